#include "core/geometry/surface_distance.h"

#include <algorithm>
#include <optional>
#include <queue>
#include <vector>

#include <Eigen/Geometry>

namespace alltact {

// Boxes around blocks of a grid, in a tree. Of two such trees only those pairs are searched that
// can hold a smaller distance than the best so far.

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
    return level.boxes[static_cast<std::size_t>(std::ptrdiff_t{block.j} * level.columns + block.i)];
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
    return static_cast<std::size_t>(std::ptrdiff_t{j} * columns_ + i);
  }
  static Level above(const Level& below) {
    Level level{(below.columns + 1) / 2, (below.rows + 1) / 2, {}};
    level.boxes.resize(static_cast<std::size_t>(std::ptrdiff_t{level.columns} * level.rows));
    for (int j = 0; j < below.rows; ++j)
      for (int i = 0; i < below.columns; ++i)
        level.boxes[static_cast<std::size_t>(std::ptrdiff_t{j / 2} * level.columns + i / 2)].extend(
            below.boxes[static_cast<std::size_t>(std::ptrdiff_t{j} * below.columns + i)]);
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

namespace {

using Point = Eigen::Vector3d;

Point nearest_on_segment(const Point& a, const Point& b, const Point& p) {
  const Point along = b - a;
  const double length2 = along.squaredNorm();
  if (length2 <= 0) return a;
  return a + std::clamp((p - a).dot(along) / length2, 0.0, 1.0) * along;
}

/// Ericson 5.1.5: inside, or the nearest edge.
Point nearest_on_triangle(const Triangle& t, const Point& p) {
  const Point ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  const Point bp = p - t[1], cp = p - t[2];
  const double d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  const double sum = va + vb + vc;
  if (va > 0 && vb > 0 && vc > 0 && sum > 0) return t[0] + (vb / sum) * ab + (vc / sum) * ac;
  Point best = nearest_on_segment(t[0], t[1], p);
  for (const Point& other : {nearest_on_segment(t[1], t[2], p), nearest_on_segment(t[2], t[0], p)})
    if ((other - p).squaredNorm() < (best - p).squaredNorm()) best = other;
  return best;
}

/// Ericson 5.1.9.
NearestPoints nearest_of_segments(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point first = b - a, second = d - c, between = a - c;
  const double aa = first.squaredNorm(), ee = second.squaredNorm();
  const double f = second.dot(between);
  if (aa <= 0) return {a, nearest_on_segment(c, d, a)};
  if (ee <= 0) return {nearest_on_segment(a, b, c), c};
  const double ab = first.dot(second), ac = first.dot(between);
  const double sine2 = aa * ee - ab * ab;
  double s = sine2 > 0 ? std::clamp((ab * f - ac * ee) / sine2, 0.0, 1.0) : 0.0;
  const double t = (ab * s + f) / ee;
  if (t < 0) return {a + std::clamp(-ac / aa, 0.0, 1.0) * first, c};
  if (t > 1) return {a + std::clamp((ab - ac) / aa, 0.0, 1.0) * first, d};
  return {a + s * first, c + t * second};
}

/// The point where a segment crosses a triangle.
std::optional<Point> crossing(const Triangle& t, const Point& from, const Point& to) {
  const Point normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double before = normal.dot(from - t[0]), behind = normal.dot(to - t[0]);
  if (before * behind > 0 || before == behind) return std::nullopt;
  const Point at = from + before / (before - behind) * (to - from);
  for (std::size_t i = 0; i < 3; ++i)
    if ((t[(i + 1) % 3] - t[i]).cross(at - t[i]).dot(normal) < 0) return std::nullopt;
  return at;
}

}  // namespace

NearestPoints nearest_points(const Triangle& first, const Triangle& second) {
  NearestPoints best{first[0], second[0]};
  const auto offer = [&](const NearestPoints& other) {
    if ((other.second - other.first).squaredNorm() < (best.second - best.first).squaredNorm())
      best = other;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (const auto at = crossing(second, first[i], first[next])) return {*at, *at};
    if (const auto at = crossing(first, second[i], second[next])) return {*at, *at};
    offer({first[i], nearest_on_triangle(second, first[i])});
    offer({nearest_on_triangle(first, second[i]), second[i]});
    for (std::size_t j = 0; j < 3; ++j)
      offer(nearest_of_segments(first[i], first[next], second[j], second[(j + 1) % 3]));
  }
  return best;
}

}  // namespace alltact
