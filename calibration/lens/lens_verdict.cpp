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

}  // namespace

Verdict lens_verdict(const LensCalibration& calibration, double distance_mm) {
  const double sigma_px = calibration.fit.sigma_px;
  Verdict result;
  result.error_mm = distance_mm * calibration.focal_sd_part;
  Grade grade = grade_of_mm(result.error_mm);
  Message reason = en::say("the focal length is known to {:.2g} %, {:.2g} mm at {:g} mm",
                           100 * calibration.focal_sd_part, result.error_mm, distance_mm);
  const auto lower_to = [&](Grade other, const Message& why) {
    if (other <= grade) return;
    grade = other;
    reason = en::clauses({reason, why});
  };
  if (calibration.halves) {
    // Each half has half the views: a lens of all views is about twice as precise.
    const double px = calibration.halves->median_px / 2;
    const double mm = px * distance_mm / calibration.fit.lens.fx_px;
    lower_to(grade_of_mm(mm),
             en::say("but two halves of the views disagree by {:.2f} px ({:.2g} mm)",
                     calibration.halves->median_px, 2 * mm));
  }
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

namespace {

/// The views for which `selects(index)` holds, with the start for them.
template <class Selector>
std::pair<std::vector<BoardView>, LensFit> part_of(const std::vector<BoardView>& views,
                                                   const LensFit& fit, const Selector& selects) {
  std::pair<std::vector<BoardView>, LensFit> part;
  part.second.lens = fit.lens;
  part.second.shape = fit.shape;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!selects(i)) continue;
    part.first.push_back(views[i]);
    part.second.poses.push_back(fit.poses[i]);
  }
  return part;
}

}  // namespace

std::optional<HeldOut> cross_validate(const std::vector<BoardView>& views, const LensFit& fit,
                                      int coefficients, const Job& job) {
  if (views.size() < 4) return std::nullopt;
  const std::size_t folds = std::min<std::size_t>(5, views.size());
  double sum = 0, freedom = 0;
  std::vector<Eigen::Vector2d> focals;
  for (std::size_t fold = 0; fold < folds; ++fold) {
    const auto [others, start] =
        part_of(views, fit, [&](std::size_t i) { return i % folds != fold; });
    const auto without = fit_lens(others, start, coefficients, job);
    if (!without) return std::nullopt;
    focals.emplace_back(without->lens.fx_px, without->lens.fy_px);
    for (std::size_t i = fold; i < views.size(); i += folds) {
      BoardPose pose = fit.poses[i];
      const double error = fit_pose(views[i], without->lens, fit.weights[i], pose);
      if (!std::isfinite(error)) continue;
      const double used =
          2 * static_cast<double>(std::count(fit.weights[i].begin(), fit.weights[i].end(), 1.0)) -
          6;
      sum += error * error * used;
      freedom += used;
    }
  }
  if (!(freedom > 0)) return std::nullopt;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero(), spread = Eigen::Vector2d::Zero();
  const auto n = static_cast<double>(folds);
  for (const Eigen::Vector2d& focal : focals) mean += focal / n;
  for (const Eigen::Vector2d& focal : focals) spread += (focal - mean).cwiseAbs2();
  spread = (spread * (n - 1) / n).cwiseSqrt();
  return HeldOut{std::sqrt(sum / freedom), spread.x(), spread.y()};
}

std::optional<LensDifference> difference_of(const CameraParameters& a, const CameraParameters& b,
                                            double distance_mm) {
  const auto camera = Camera::create(a);
  if (!camera || !Camera::create(b)) return std::nullopt;
  constexpr int kColumns = 16, kRows = 12;
  BoardView cloud;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const Eigen::Vector2d pixel((a.width_px - 1) * column / (kColumns - 1.0),
                                  (a.height_px - 1) * row / (kRows - 1.0));
      const auto ray = camera->unproject(pixel);
      if (!ray || ray->direction.head<2>().norm() > 5) continue;  // beyond 79 degrees
      for (const double part : {2.0 / 3, 4.0 / 3}) {
        cloud.board_mm.push_back(ray->point_at(part * distance_mm));
        cloud.pixels.push_back(pixel);
      }
    }
  if (cloud.pixels.size() < 20) return std::nullopt;
  BoardPose pose;
  const std::vector<double> ones(cloud.pixels.size(), 1.0);
  if (!std::isfinite(fit_pose(cloud, b, ones, pose))) return std::nullopt;
  std::vector<double> differences;
  const Eigen::VectorXd numbers = lens_numbers(b);
  for (std::size_t i = 0; i < cloud.pixels.size(); ++i) {
    const auto seen =
        project_by(b.model, {numbers.data(), static_cast<std::size_t>(numbers.size())},
                   pose(cloud.board_mm[i]));
    if (!seen) return std::nullopt;
    differences.push_back((seen->pixel - cloud.pixels[i]).norm());
  }
  LensDifference result;
  result.worst_px = *std::max_element(differences.begin(), differences.end());
  result.median_px = upper_median(differences);
  return result;
}

std::optional<LensDifference> difference_of_halves(const std::vector<BoardView>& views,
                                                   const LensFit& fit, int coefficients,
                                                   double distance_mm, const Job& job) {
  if (views.size() < 6) return std::nullopt;
  std::vector<CameraParameters> lenses;
  for (const std::size_t half : {0U, 1U}) {
    const auto [some, start] = part_of(views, fit, [&](std::size_t i) { return i % 2 == half; });
    const auto fitted = fit_lens(some, start, coefficients, job);
    if (!fitted) return std::nullopt;
    lenses.push_back(fitted->lens);
  }
  return difference_of(lenses[0], lenses[1], distance_mm);
}

}  // namespace alltact
