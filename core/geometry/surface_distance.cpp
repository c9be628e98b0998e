// Boxes around blocks of a grid, in a tree. Of two such trees only those pairs are searched that
// can hold a smaller distance than the best so far.
#include "core/geometry/surface_distance.h"

#include <queue>
#include <vector>

#include <Eigen/Geometry>

namespace alltact {
namespace {

using Box = Eigen::AlignedBox3d;  // empty without points

class Blocks {
 public:
  explicit Blocks(const PosedSurface& surface)
      : columns_(surface.points_mm.cols), points_(surface.points_mm.total()) {
    CV_Assert(surface.points_mm.type() == CV_32FC3);
    for (int j = 0; j < surface.points_mm.rows; ++j)
      for (int i = 0; i < columns_; ++i) {
        const auto& p = surface.points_mm.at<cv::Vec3f>(j, i);
        points_[index(i, j)] = surface.pose.point({p[0], p[1], p[2]});
      }
    Level cells{columns_ - 1, surface.points_mm.rows - 1, {}};
    if (cells.columns < 1 || cells.rows < 1) return;
    for (int j = 0; j < cells.rows; ++j)
      for (int i = 0; i < cells.columns; ++i) {
        Box box;
        for (const Triangle& triangle : triangles(i, j))
          for (const Eigen::Vector3d& corner : triangle) box.extend(corner);
        cells.boxes.push_back(box);
      }
    levels_.push_back(std::move(cells));
    while (levels_.back().boxes.size() > 1) levels_.push_back(above(levels_.back()));
  }

  struct Block {
    std::size_t level;
    int i, j;
  };
  [[nodiscard]] bool is_empty() const { return levels_.empty() || box(top()).isEmpty(); }
  [[nodiscard]] Block top() const { return {levels_.size() - 1, 0, 0}; }
  [[nodiscard]] const Box& box(const Block& block) const {
    const Level& level = levels_[block.level];
    return level.boxes[static_cast<std::size_t>(block.j * level.columns + block.i)];
  }
  [[nodiscard]] std::vector<Block> parts(const Block& block) const {
    std::vector<Block> parts;
    const Level& level = levels_[block.level - 1];
    for (int j = 2 * block.j; j < std::min(2 * block.j + 2, level.rows); ++j)
      for (int i = 2 * block.i; i < std::min(2 * block.i + 2, level.columns); ++i)
        if (!box({block.level - 1, i, j}).isEmpty()) parts.push_back({block.level - 1, i, j});
    return parts;
  }
  /// The finite triangles of a cell.
  [[nodiscard]] std::vector<Triangle> triangles(int i, int j) const {
    const Eigen::Vector3d &a = points_[index(i, j)], &b = points_[index(i + 1, j)],
                          &c = points_[index(i, j + 1)], &d = points_[index(i + 1, j + 1)];
    std::vector<Triangle> complete;
    for (const Triangle& triangle : {Triangle{a, c, b}, Triangle{b, c, d}})
      if (triangle[0].allFinite() && triangle[1].allFinite() && triangle[2].allFinite())
        complete.push_back(triangle);
    return complete;
  }

 private:
  struct Level {
    int columns, rows;
    std::vector<Box> boxes;
  };
  [[nodiscard]] std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j * columns_ + i);
  }
  static Level above(const Level& below) {
    Level level{(below.columns + 1) / 2, (below.rows + 1) / 2, {}};
    level.boxes.resize(static_cast<std::size_t>(level.columns * level.rows));
    for (int j = 0; j < below.rows; ++j)
      for (int i = 0; i < below.columns; ++i)
        level.boxes[static_cast<std::size_t>(j / 2 * level.columns + i / 2)].extend(
            below.boxes[static_cast<std::size_t>(j * below.columns + i)]);
    return level;
  }

  int columns_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Level> levels_;
};

struct Pair {
  double distance2;  // of the boxes: a lower bound
  Blocks::Block first, second;
  /// The nearest first; of equally near ones the smallest, so that a result is found early.
  bool operator<(const Pair& other) const {
    if (distance2 != other.distance2) return distance2 > other.distance2;
    return first.level + second.level > other.first.level + other.second.level;
  }
};

}  // namespace

std::optional<NearestPoints> nearest_points(const PosedSurface& first, const PosedSurface& second) {
  constexpr double kNoticeable = 1 - 2e-9;  // of a squared distance
  const Blocks a(first), b(second);
  if (a.is_empty() || b.is_empty()) return std::nullopt;
  std::priority_queue<Pair> pairs;
  const auto add = [&](const Blocks::Block& p, const Blocks::Block& q) {
    pairs.push({a.box(p).squaredExteriorDistance(b.box(q)), p, q});
  };
  add(a.top(), b.top());
  std::optional<NearestPoints> best;
  double best2 = std::numeric_limits<double>::infinity();
  while (!pairs.empty() && pairs.top().distance2 < best2 * kNoticeable) {
    const Pair pair = pairs.top();
    pairs.pop();
    const bool is_first_cell = pair.first.level == 0, is_second_cell = pair.second.level == 0;
    if (is_first_cell && is_second_cell) {
      for (const Triangle& p : a.triangles(pair.first.i, pair.first.j))
        for (const Triangle& q : b.triangles(pair.second.i, pair.second.j)) {
          const NearestPoints points = nearest_points(p, q);
          const double distance2 = (points.second - points.first).squaredNorm();
          if (distance2 >= best2) continue;
          best2 = distance2;
          best = points;
        }
    } else if (is_second_cell || (!is_first_cell && pair.first.level >= pair.second.level)) {
      for (const Blocks::Block& part : a.parts(pair.first)) add(part, pair.second);
    } else {
      for (const Blocks::Block& part : b.parts(pair.second)) add(pair.first, part);
    }
  }
  return best;
}

}  // namespace alltact
