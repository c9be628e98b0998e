#include "widgets/scene3d/face_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace alltact {
namespace {

template <class Vector>
Vector between(const cv::Mat& grid, cv::Point2d position) {
  const int i = std::clamp(static_cast<int>(position.x), 0, grid.cols - 2);
  const int j = std::clamp(static_cast<int>(position.y), 0, grid.rows - 2);
  const auto x = static_cast<float>(position.x - i), y = static_cast<float>(position.y - j);
  return (1 - y) * ((1 - x) * grid.at<Vector>(j, i) + x * grid.at<Vector>(j, i + 1)) +
         y * ((1 - x) * grid.at<Vector>(j + 1, i) + x * grid.at<Vector>(j + 1, i + 1));
}

Eigen::Vector3d at(const cv::Mat& grid, int i, int j) {
  const auto& p = grid.at<cv::Vec3f>(j, i);
  return {p[0], p[1], p[2]};
}

/// Moeller and Trumbore: distance along the ray, and the weights of the second and third corner.
struct Hit {
  double distance, second, third;
};
std::optional<Hit> hit(const Eigen::Vector3d& from,
                       const Eigen::Vector3d& direction,
                       const std::array<Eigen::Vector3d, 3>& corner) {
  const Eigen::Vector3d one = corner[1] - corner[0], two = corner[2] - corner[0];
  const Eigen::Vector3d p = direction.cross(two);
  const double determinant = one.dot(p);
  if (determinant == 0) return std::nullopt;
  const Eigen::Vector3d t = from - corner[0];
  const double second = t.dot(p) / determinant;
  if (!(second >= 0 && second <= 1)) return std::nullopt;
  const Eigen::Vector3d q = t.cross(one);
  const double third = direction.dot(q) / determinant;
  if (!(third >= 0 && second + third <= 1)) return std::nullopt;
  const double distance = two.dot(q) / determinant;
  if (!(distance > 0)) return std::nullopt;
  return Hit{distance, second, third};
}

/// Bounding sphere test: the ray's distance from the middle is at most half the diagonal.
bool may_meet(const Eigen::AlignedBox3d& box,
              const Eigen::Vector3d& from,
              const Eigen::Vector3d& direction) {
  const Eigen::Vector3d away = box.center() - from;
  const double along = away.dot(direction) / direction.squaredNorm();
  constexpr double kRounding = 1.0001;
  return (away - along * direction).squaredNorm() <=
         kRounding * 0.25 * box.diagonal().squaredNorm();
}

}  // namespace

cv::Vec2f pixel_between(const cv::Mat& grid, cv::Point2d position) {
  return between<cv::Vec2f>(grid, position);
}

cv::Vec3f point_between(const cv::Mat& grid, cv::Point2d position) {
  return between<cv::Vec3f>(grid, position);
}

std::optional<cv::Point2d> grid_position_of(const FaceSurface& surface, cv::Point2d pixel) {
  const cv::Mat& grid = surface.pixel;
  const auto u = [&](int i) { return static_cast<double>(grid.at<cv::Vec2f>(0, i)[0]); };
  if (grid.empty() || !(pixel.x >= u(0) && pixel.x <= u(grid.cols - 1))) return std::nullopt;
  int low = 0, high = grid.cols - 1;
  while (high - low > 1) (u((low + high) / 2) <= pixel.x ? low : high) = (low + high) / 2;
  const double width = u(high) - u(low);
  const double share = width > 0 ? (pixel.x - u(low)) / width : 0.0;
  const auto v = [&](int j) {
    return (1 - share) * grid.at<cv::Vec2f>(j, low)[1] + share * grid.at<cv::Vec2f>(j, high)[1];
  };
  const double first = v(0), last = v(grid.rows - 1);
  // Edges between columns of the grid differ a little from those of the image.
  constexpr double kSlack_px = 1.5;
  if (!(pixel.y >= first - kSlack_px && pixel.y <= last + kSlack_px) || first == last)
    return std::nullopt;
  const double part = std::clamp((pixel.y - first) / (last - first), 0.0, 1.0);
  return cv::Point2d(low + share, part * (grid.rows - 1));
}

GridBoxes::GridBoxes(const cv::Mat& drawn_mm) : drawn_mm_(drawn_mm) {
  constexpr int kCells = 16;
  for (int j = 0; j + 1 < drawn_mm.rows; j += kCells)
    for (int i = 0; i + 1 < drawn_mm.cols; i += kCells) {
      Box& box = boxes_.emplace_back();
      box.cells = {
          i, j, std::min(kCells, drawn_mm.cols - 1 - i), std::min(kCells, drawn_mm.rows - 1 - j)};
      for (int row = j; row <= j + box.cells.height; ++row)
        for (int column = i; column <= i + box.cells.width; ++column)
          box.bounds.extend(at(drawn_mm, column, row));
    }
}

std::optional<cv::Point2d> GridBoxes::first_hit(const Eigen::Vector3d& from,
                                                const Eigen::Vector3d& direction) const {
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<cv::Point2d> position;
  for (const Box& box : boxes_) {
    if (!may_meet(box.bounds, from, direction)) continue;
    for (int j = box.cells.y; j < box.cells.y + box.cells.height; ++j) {
      for (int i = box.cells.x; i < box.cells.x + box.cells.width; ++i) {
        const Eigen::Vector3d a = at(drawn_mm_, i, j), below = at(drawn_mm_, i, j + 1);
        const Eigen::Vector3d right = at(drawn_mm_, i + 1, j), over = at(drawn_mm_, i + 1, j + 1);
        if (const auto found = hit(from, direction, {a, below, right});
            found && found->distance < nearest) {
          nearest = found->distance;
          position = cv::Point2d(i + found->third, j + found->second);
        }
        if (const auto found = hit(from, direction, {over, right, below});
            found && found->distance < nearest) {
          nearest = found->distance;
          position = cv::Point2d(i + 1 - found->third, j + 1 - found->second);
        }
      }
    }
  }
  return position;
}

std::optional<cv::Point2d> first_hit(const cv::Mat& drawn_mm,
                                     const Eigen::Vector3d& from,
                                     const Eigen::Vector3d& direction) {
  return GridBoxes(drawn_mm).first_hit(from, direction);
}

}  // namespace alltact
