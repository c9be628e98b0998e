#include "calibration/lens/lens_coverage.h"

#include <algorithm>
#include <array>
#include <functional>

namespace alltact {
namespace {

constexpr int kColumns = 6, kRows = 4;
constexpr double kTiltedDeg = 15;
using Cells = std::array<std::array<bool, kColumns>, kRows>;

Cells cells_seen(const std::vector<BoardView>& views, const LensFit& fit) {
  Cells seen{};
  for (std::size_t i = 0; i < views.size(); ++i)
    for (std::size_t k = 0; k < views[i].pixels.size(); ++k) {
      if (fit.weights[i][k] == 0) continue;
      const Eigen::Vector2d& pixel = views[i].pixels[k];
      const auto cell = [](double at, int length, int count) {
        return static_cast<std::size_t>(
            std::clamp(static_cast<int>((at + 0.5) / length * count), 0, count - 1));
      };
      seen[cell(pixel.y(), fit.lens.height_px, kRows)]
          [cell(pixel.x(), fit.lens.width_px, kColumns)] = true;
    }
  return seen;
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
std::vector<Region> unseen_regions(const Cells& seen) {
  std::array<std::array<int, 3>, 3> count{}, unseen{};
  for (std::size_t row = 0; row < kRows; ++row)
    for (std::size_t column = 0; column < kColumns; ++column) {
      const std::size_t down = row == 0 ? 0 : row + 1 < kRows ? 1 : 2;
      ++count[down][column / 2];
      unseen[down][column / 2] += seen[row][column] ? 0 : 1;
    }
  std::vector<Region> regions;
  for (std::size_t down = 0; down < 3; ++down)
    for (std::size_t right = 0; right < 3; ++right)
      if (2 * unseen[down][right] > count[down][right]) regions.push_back({down, right});
  return regions;
}

Message listed(const std::vector<Message>& words) {
  if (words.size() < 2) return en::list(words);
  const Message first = en::list({words.begin(), words.end() - 1});
  return en::say("{} and {}", first, words.back());
}

/// `number`: 1 to kEnoughViews.
Message number_word(int number) {
  static const std::array words{en::say("one"),
                                en::say("two"),
                                en::say("three"),
                                en::say("four"),
                                en::say("five"),
                                en::say("six"),
                                en::say("seven"),
                                en::say("eight"),
                                en::say("nine"),
                                en::say("ten")};
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
                             ? en::say("{} more, tilted {}", number, listed(coverage.untilted))
                             : en::say("{} more, tilted", number);
  Message where;
  if (coverage.unseen.size() > 4) {
    where = en::say("large enough to fill the picture");
  } else if (!coverage.unseen.empty()) {
    where = en::say("near the {}", listed(coverage.unseen));
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
  const Cells seen = cells_seen(views, fit);
  int count = 0;
  for (const auto& row : seen) count += static_cast<int>(std::count(row.begin(), row.end(), true));
  coverage.seen_part = static_cast<double>(count) / (kColumns * kRows);
  const std::vector<Region> unseen = unseen_regions(seen);
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
  const std::array all{
      en::say("to the left"), en::say("to the right"), en::say("up"), en::say("down")};
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
