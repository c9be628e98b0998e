#include "calibration/lens/board_views.h"
#include "calibration/lens/calibrate_lens.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace alltact {
namespace {

Grade grade_of_mm(double error_mm) {
  if (!(error_mm <= kUsableLensMm)) return Grade::kUnfit;
  return error_mm <= kGoodLensMm ? Grade::kGood : Grade::kUsable;
}

/// Held-out views that fit worse than fitted ones show that the model is wrong.
Grade grade_of_held_out(double error_px, double sigma_px) {
  const double ratio = error_px / std::max(sigma_px, 0.02);
  if (ratio > 3 && error_px > 1) return Grade::kUnfit;
  return ratio > 1.5 ? Grade::kUsable : Grade::kGood;
}

Message name_of(Grade grade) {
  static const std::array kWords{en::say("good"), en::say("usable"), en::say("unproven"),
                                 en::say("unfit for measuring")};
  return kWords.at(static_cast<std::size_t>(grade) - 1);
}

/// The first words of a verdict: how well the focal length is known, and why not better.
Message focal_reason(const LensCalibration& calibration, double distance_mm, double error_mm) {
  const Message known = en::say("the focal length is known to {:.2g} %, {:.2g} mm at {:g} mm",
                                100 * calibration.focal_sd_part, error_mm, distance_mm);
  constexpr double kDisagree = 3;  // standard deviations
  if (!calibration.halves || !(calibration.halves->sigmas.head<2>().maxCoeff() > kDisagree))
    return known;
  const Eigen::Index number = calibration.halves->sigmas[1] > calibration.halves->sigmas[0] ? 1 : 0;
  const auto& numbers = calibration.halves->numbers;
  return en::clauses({known, en::say("two halves of the views give {} = {:.1f} and {:.1f} px",
                                     std::string(number == 0 ? "fx" : "fy"), numbers[0][number],
                                     numbers[1][number])});
}

}  // namespace

PixelAspect pixel_aspect(const LensCalibration& calibration) {
  const CameraParameters& lens = calibration.fit.lens;
  PixelAspect aspect{lens.fx_px / lens.fy_px, AspectCause::kNone};
  const double off = std::abs(aspect.ratio - 1);
  constexpr double kSquare = 0.01, kSigmas = 3;
  // The errors of fx and fy have much in common, so that of their ratio is smaller than either.
  const Eigen::MatrixXd& covariance = calibration.fit.covariance;
  if (covariance.rows() < 2) return aspect;
  const Eigen::Vector2d by_number(1 / lens.fx_px, -1 / lens.fy_px);
  double sd = std::sqrt(std::max(0.0, by_number.dot(covariance.topLeftCorner<2, 2>() * by_number)));
  if (calibration.halves) {
    const auto& [first, second] = calibration.halves->numbers;
    sd = std::max(sd, 0.5 * std::abs(first[0] / first[1] - second[0] / second[1]));
  }
  if (!(off > kSquare) || !(off > kSigmas * sd)) return aspect;
  aspect.cause = AspectCause::kUndecided;
  if (!calibration.shape) return aspect;
  const BoardShape& shape = *calibration.shape;
  const double off_with_shape = std::abs(shape.lens.fx_px / shape.lens.fy_px - 1);
  if (shape.is_stretched && off_with_shape < 0.5 * off)
    aspect.cause = AspectCause::kBoard;
  else if (std::abs(shape.stretch) + kSigmas * shape.stretch_sd < 0.5 * off)
    aspect.cause = AspectCause::kImage;
  return aspect;
}

Verdict lens_verdict(const LensCalibration& calibration, double distance_mm) {
  const double sigma_px = calibration.fit.sigma_px;
  Verdict result;
  result.error_mm = distance_mm * calibration.focal_sd_part;
  Grade grade = grade_of_mm(result.error_mm);
  Message reason = focal_reason(calibration, distance_mm, result.error_mm);
  const auto lower_to = [&](Grade other, const Message& why) {
    if (other <= grade) return;
    grade = other;
    reason = en::clauses({reason, why});
  };
  if (calibration.halves) {
    // Each half has half the views: a lens of all views is about twice as precise.
    const double px = calibration.halves->difference.median_px / 2;
    const double mm = px * distance_mm / calibration.fit.lens.fx_px;
    lower_to(grade_of_mm(mm),
             en::say("but two halves of the views disagree by {:.2f} px ({:.2g} mm)",
                     calibration.halves->difference.median_px, 2 * mm));
  }
  if (const PixelAspect aspect = pixel_aspect(calibration);
      aspect.cause == AspectCause::kBoard || aspect.cause == AspectCause::kUndecided) {
    grade = std::max(grade, grade_of_mm(0.5 * std::abs(aspect.ratio - 1) * distance_mm));
    reason = en::clauses(
        {reason, en::say("fx and fy differ by {:.1f} %: the board is likely out of square",
                         100 * std::abs(aspect.ratio - 1))});
  }
  if (calibration.shape && calibration.shape->is_stretched)
    reason = en::clauses({reason, en::say("the squares of the board are stretched by {:.1f} %",
                                          100 * std::abs(calibration.shape->stretch))});
  if (calibration.shape && calibration.shape->is_bent)
    reason = en::clauses(
        {reason, en::say("the board is bent by about {:.2g} mm", calibration.shape->bend_mm)});
  if (calibration.held_out)
    lower_to(grade_of_held_out(calibration.held_out->error_px, sigma_px),
             en::say("but views left out fit worse ({:.2f} px) than those fitted ({:.2f} px)",
                     calibration.held_out->error_px, sigma_px));
  if (!calibration.coverage.enough)
    lower_to(Grade::kUsable,
             en::say("but the views cover too little of the image or too few tilts"));
  if (!calibration.held_out)
    lower_to(Grade::kUnproven,
             en::say("with so few views, none could be left out to test the lens"));
  result.grade = grade;
  const Message& more = calibration.coverage.advice;
  Message advice;
  if (!more.empty())
    advice = en::say("take {}", more);
  else if (grade != Grade::kGood)
    advice = en::say("add views, sharp and tilted, that fill the image");
  result.sentence = en::clauses({en::at(name_of(grade), reason), advice});
  return result;
}

namespace {

constexpr double kTiltedDeg = 15;

BoardCollector::Cells used_corners(const std::vector<BoardView>& views, const LensFit& fit) {
  BoardCollector::Cells cells{};
  for (std::size_t i = 0; i < views.size(); ++i)
    for (std::size_t k = 0; k < views[i].pixels.size(); ++k)
      if (fit.weights[i][k] != 0)
        BoardCollector::add_corner(views[i].pixels[k], {fit.lens.width_px, fit.lens.height_px},
                                   cells);
  return cells;
}

/// One of nine regions: a third of the image across and down.
struct Region {
  std::size_t down, right;

  [[nodiscard]] bool is_corner() const { return down != 1 && right != 1; }
  [[nodiscard]] Message name() const {
    static const std::array<std::array<Message, 3>, 3> names{
        {{en::say("top left corner"), en::say("top edge"), en::say("top right corner")},
         {en::say("left edge"), en::say("middle"), en::say("right edge")},
         {en::say("bottom left corner"), en::say("bottom edge"), en::say("bottom right corner")}}};
    return names[down][right];
  }
};

/// The regions of whose cells more than half have no corner.
std::vector<Region> unseen_regions(const BoardCollector::Cells& corners) {
  std::array<std::array<int, 3>, 3> count{}, unseen{};
  for (std::size_t row = 0; row < corners.size(); ++row)
    for (std::size_t column = 0; column < corners[row].size(); ++column) {
      const std::size_t down = row == 0 ? 0 : row + 1 < corners.size() ? 1 : 2;
      ++count[down][column / 2];
      unseen[down][column / 2] += corners[row][column] > 0 ? 0 : 1;
    }
  std::vector<Region> regions;
  for (std::size_t down = 0; down < 3; ++down)
    for (std::size_t right = 0; right < 3; ++right)
      if (2 * unseen[down][right] > count[down][right]) regions.push_back({down, right});
  return regions;
}

/// `number`: 1 to kEnoughViews.
Message number_word(int number) {
  static const std::array words{en::say("one"),  en::say("two"), en::say("three"), en::say("four"),
                                en::say("five"), en::say("six"), en::say("seven"), en::say("eight"),
                                en::say("nine"), en::say("ten")};
  static_assert(words.size() == kEnoughViews);
  return words.at(static_cast<std::size_t>(number - 1));
}

Message advice_of(const LensCoverage& coverage, int views) {
  const bool flat = coverage.tilted_views < 4 || coverage.untilted.size() > 1;
  int more = std::max(kEnoughViews - views, static_cast<int>(coverage.unseen.size()));
  if (flat)
    more = std::max({more, 4 - coverage.tilted_views, static_cast<int>(coverage.untilted.size())});
  if (more <= 0) return {};
  const Message number = number_word(more);
  const bool names_directions = flat && !coverage.untilted.empty() && coverage.untilted.size() < 4;
  const Message tilted = names_directions
                             ? en::say("{} more, tilted {}", number, enumerated(coverage.untilted))
                             : en::say("{} more, tilted", number);
  Message where;
  if (coverage.unseen.size() > 4) {
    where = en::say("large enough to fill the image");
  } else if (!coverage.unseen.empty()) {
    where = en::say("near the {}", enumerated(coverage.unseen));
  }
  return en::list({tilted, where});
}

}  // namespace

Eigen::Vector2d tilt_deg(const BoardView& view, const BoardPose& pose) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point_mm : view.board_mm)
    middle += point_mm / static_cast<double>(view.board_mm.size());
  const Eigen::Vector3d sight = pose(middle).normalized();
  Eigen::Vector3d normal = pose.rotation().col(2);
  if (normal.dot(sight) > 0) normal = -normal;
  const double angle = std::atan2(normal.cross(sight).norm(), -normal.dot(sight));
  const Eigen::Vector2d lean = (normal - normal.dot(sight) * sight).head<2>();
  if (lean.norm() == 0) return Eigen::Vector2d::Zero();
  return lean.normalized() * (angle * 180 / M_PI);
}

LensCoverage coverage_of(const std::vector<BoardView>& views, const LensFit& fit) {
  LensCoverage coverage;
  const BoardCollector::Cells corners = used_corners(views, fit);
  int count = 0;
  for (const auto& row : corners)
    count += static_cast<int>(std::count_if(row.begin(), row.end(), std::identity()));
  coverage.seen_part =
      static_cast<double>(count) / (BoardCollector::kColumns * BoardCollector::kRows);
  const std::vector<Region> unseen = unseen_regions(corners);
  for (const Region& region : unseen) coverage.unseen.push_back(region.name());
  std::array<int, 4> tilt_counts{};  // left, right, up, down
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Eigen::Vector2d tilt = tilt_deg(views[i], fit.poses[i]);
    if (tilt.norm() < kTiltedDeg) continue;
    ++coverage.tilted_views;
    // Between two directions both count: 22 degrees are enough of the second.
    const Eigen::Vector2d direction = tilt.normalized();
    if (direction.x() < -0.38) ++tilt_counts[0];
    if (direction.x() > 0.38) ++tilt_counts[1];
    if (direction.y() < -0.38) ++tilt_counts[2];
    if (direction.y() > 0.38) ++tilt_counts[3];
  }
  const std::array all{en::say("to the left"), en::say("to the right"), en::say("up"),
                       en::say("down")};
  for (std::size_t i = 0; i < tilt_counts.size(); ++i)
    if (tilt_counts[i] == 0) coverage.untilted.push_back(all[i]);
  const auto n = static_cast<int>(views.size());
  coverage.enough = n >= kEnoughViews && coverage.tilted_views >= 4 &&
                    coverage.untilted.size() <= 1 &&
                    std::all_of(unseen.begin(), unseen.end(), std::mem_fn(&Region::is_corner));
  coverage.advice = advice_of(coverage, n);
  return coverage;
}

}  // namespace alltact
