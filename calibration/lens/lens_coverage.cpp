#include "calibration/lens/lens_coverage.h"

#include <fmt/format.h>

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

/// Thirds of the picture of whose cells more than half were never seen.
std::vector<std::string> places_unseen(const Cells& seen) {
  constexpr std::array<std::array<const char*, 3>, 3> kPlaces{
      {{"top left corner", "top edge", "top right corner"},
       {"left edge", "middle", "right edge"},
       {"bottom left corner", "bottom edge", "bottom right corner"}}};
  std::array<std::array<int, 3>, 3> count{}, unseen{};
  for (std::size_t row = 0; row < kRows; ++row)
    for (std::size_t column = 0; column < kColumns; ++column) {
      const std::size_t down = row == 0 ? 0 : row + 1 < kRows ? 1 : 2;
      ++count[down][column / 2];
      unseen[down][column / 2] += seen[row][column] ? 0 : 1;
    }
  std::vector<std::string> places;
  for (std::size_t down = 0; down < 3; ++down)
    for (std::size_t right = 0; right < 3; ++right)
      if (2 * unseen[down][right] > count[down][right]) places.emplace_back(kPlaces[down][right]);
  return places;
}

bool is_corner(const std::string& place) {
  return place.ends_with("corner");
}

std::string listed(const std::vector<std::string>& words) {
  if (words.size() < 2) return fmt::format("{}", fmt::join(words, ""));
  const std::vector<std::string> first(words.begin(), words.end() - 1);
  return fmt::format("{} and {}", fmt::join(first, ", "), words.back());
}

std::string number_word(int number) {
  constexpr std::array kWords{
      "no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"};
  const auto at = static_cast<std::size_t>(std::max(number, 0));
  return at < kWords.size() ? kWords[at] : fmt::format("{}", number);
}

std::string advice_of(const LensCoverage& coverage, int views) {
  const bool flat = coverage.tilted_views < 4 || coverage.untilted.size() > 1;
  int more = std::max(kEnoughViews - views, static_cast<int>(coverage.unseen.size()));
  if (flat)
    more = std::max({more, 4 - coverage.tilted_views, static_cast<int>(coverage.untilted.size())});
  if (more <= 0) return {};
  std::string advice = fmt::format("{} more, tilted", number_word(more));
  if (flat && !coverage.untilted.empty() && coverage.untilted.size() < 4)
    advice += fmt::format(" {}", listed(coverage.untilted));
  if (coverage.unseen.size() > 4) {
    advice += ", large enough to fill the picture";
  } else if (!coverage.unseen.empty()) {
    advice += fmt::format(", near the {}", listed(coverage.unseen));
  }
  return advice;
}

}  // namespace

Eigen::Vector2d tilt_deg(const BoardView& view, const BoardPose& pose) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& place : view.board_mm)
    middle += place / static_cast<double>(view.board_mm.size());
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
  coverage.unseen = places_unseen(seen);
  std::array<int, 4> ways{};  // left, right, up, down
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Eigen::Vector2d tilt = tilt_deg(views[i], fit.poses[i]);
    if (tilt.norm() < kTiltedDeg) continue;
    ++coverage.tilted_views;
    // Between two ways both count: 22 degrees are enough of the second.
    const Eigen::Vector2d way = tilt.normalized();
    if (way.x() < -0.38) ++ways[0];
    if (way.x() > 0.38) ++ways[1];
    if (way.y() < -0.38) ++ways[2];
    if (way.y() > 0.38) ++ways[3];
  }
  constexpr std::array kWays{"to the left", "to the right", "up", "down"};
  for (std::size_t i = 0; i < ways.size(); ++i)
    if (ways[i] == 0) coverage.untilted.emplace_back(kWays[i]);
  const auto n = static_cast<int>(views.size());
  coverage.enough = n >= kEnoughViews && coverage.tilted_views >= 4 &&
                    coverage.untilted.size() <= 1 &&
                    std::all_of(coverage.unseen.begin(), coverage.unseen.end(), is_corner);
  coverage.advice = advice_of(coverage, n);
  return coverage;
}

}  // namespace alltact
