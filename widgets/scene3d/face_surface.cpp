#include "widgets/scene3d/face_surface.h"

#include "widgets/scene3d/face_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace alltact {
namespace {

struct Columns {
  int first = 0, last = -1;
};

/// From the first to the last column that has rows.
Columns columns_of(const FaceShape& shape) {
  Columns columns;
  const auto has_rows = [&](int u) { return shape.rows(u, 0).first < shape.rows(u, 0).last; };
  while (columns.first < shape.width_px() && !has_rows(columns.first)) ++columns.first;
  columns.last = shape.width_px() - 1;
  while (columns.last > columns.first && !has_rows(columns.last)) --columns.last;
  return columns;
}

/// The nearest column to u that has rows; between the first and the last there is one.
int usable_column(const FaceShape& shape, int u) {
  for (int step = 0;; ++step)
    for (const int near : {u - step, u + step})
      if (near >= 0 && near < shape.width_px() &&
          shape.rows(near, 0).first < shape.rows(near, 0).last)
        return near;
}

/// Both edges of the face at a fractional column: interpolated between its neighbours, so that the
/// grid's border is as smooth as the face's.
struct EdgeRows {
  double first, last;
};
EdgeRows edge_rows(const FaceShape& shape, int u) {
  const auto rows = shape.rows(u, 0);
  const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
  // The outermost pixels lie half a pixel inside; where an end cuts a column short, the end gives
  // the edge.
  const auto exact = [](double edge, int pixel) {
    return std::abs(edge - pixel) < 1 ? edge : static_cast<double>(pixel);
  };
  return {exact(column.upper_v + 0.5, rows.first), exact(column.lower_v - 0.5, rows.last)};
}
EdgeRows edge_rows_between(const FaceShape& shape, double u) {
  const int left = static_cast<int>(std::floor(u));
  const int a = usable_column(shape, left);
  const int b = usable_column(shape, std::min(left + 1, shape.width_px() - 1));
  const EdgeRows one = edge_rows(shape, a), two = edge_rows(shape, b);
  const double part = b > a ? std::clamp((u - a) / (b - a), 0.0, 1.0) : 0.0;
  return {one.first + part * (two.first - one.first), one.last + part * (two.last - one.last)};
}

/// Bilinear over those of the four pixels that have a value, where they hold most of the weight.
float depth_between(const cv::Mat& depth_mm, double u, double v) {
  const int left = static_cast<int>(std::floor(u)), upper = static_cast<int>(std::floor(v));
  double sum = 0, share = 0;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
    const int i = left + x, j = upper + y;
    if (i < 0 || j < 0 || i >= depth_mm.cols || j >= depth_mm.rows) continue;
    const float depth = depth_mm.at<float>(j, i);
    if (!std::isfinite(depth)) continue;
    const double part = (x == 0 ? left + 1 - u : u - left) * (y == 0 ? upper + 1 - v : v - upper);
    sum += part * static_cast<double>(depth);
    share += part;
  }
  constexpr double kEnough = 0.5;
  return share >= kEnough ? static_cast<float>(sum / share)
                          : std::numeric_limits<float>::quiet_NaN();
}

/// The side face at row 0 or at the last row, straight behind the face: the edge, and below it the
/// same edge `deep_mm` further in.
cv::Mat side_wall(const cv::Mat& untouched_mm, int row, double deep_mm) {
  cv::Mat wall(2, untouched_mm.cols, CV_32FC3);
  for (int i = 0; i < wall.cols; ++i) {
    const auto& edge = untouched_mm.at<cv::Vec3f>(row, i);
    const Eigen::Vector3d in = deep_mm * inward_normal(untouched_mm, i, row);
    wall.at<cv::Vec3f>(0, i) = edge;
    wall.at<cv::Vec3f>(1, i) = edge + cv::Vec3f(cv::Vec3d(in.x(), in.y(), in.z()));
  }
  return wall;
}

/// Intersections of the markers' rays with the side faces.
std::vector<SurfaceMarker> markers_on(const FaceSurface& surface,
                                      const FaceShape& shape,
                                      const Markers& markers) {
  const double deep_mm = 2 * shape.face().width_mm;  // deeper than any finger's dots
  const std::size_t per_row = markers.size() / 2;
  std::vector<SurfaceMarker> found;
  for (const bool is_upper : {true, false}) {
    const cv::Mat wall =
        side_wall(surface.untouched_mm, is_upper ? 0 : surface.rows() - 1, deep_mm);
    for (std::size_t k = 0; k < per_row; ++k) {
      const Marker& marker = markers[is_upper ? k : per_row + k];
      const auto ray = shape.camera().unproject({marker.u, marker.v});
      if (!ray) continue;
      const auto hit = first_hit(wall, ray->origin_mm, ray->direction);
      if (!hit) continue;
      const cv::Vec3f at = point_between(wall, *hit);
      found.push_back({{at[0], at[1], at[2]}, hit->x, hit->y * deep_mm, marker.seen});
    }
  }
  return found;
}

/// `depth`: empty where none is known.
std::optional<FaceSurface> surface_of(
    const FrameResult& result, const cv::Mat& depth, const Face& face, int columns, int rows) {
  CV_Assert(columns >= 2 && rows >= 2);
  const FaceShape& shape = *result.shape;
  const Columns range = columns_of(shape);
  if (range.last <= range.first) return std::nullopt;
  FaceSurface surface;
  surface.untouched_mm.create(rows, columns, CV_32FC3);
  surface.depth_mm.create(rows, columns, CV_32FC1);
  surface.pixel.create(rows, columns, CV_32FC2);
  for (int i = 0; i < columns; ++i) {
    double u = range.first + static_cast<double>(i) * (range.last - range.first) / (columns - 1);
    // The nearest column with a face stands in for columns without one.
    if (shape.rows(static_cast<int>(std::lround(u)), 0).first >=
        shape.rows(static_cast<int>(std::lround(u)), 0).last)
      u = usable_column(shape, static_cast<int>(std::lround(u)));
    const EdgeRows inside = edge_rows_between(shape, u);
    surface.along_mm.push_back(shape.length_at(u));
    for (int j = 0; j < rows; ++j) {
      const double v = inside.first + j * (inside.last - inside.first) / (rows - 1);
      const auto local = shape.at(u, v);
      if (!local) return std::nullopt;
      const Eigen::Vector3f at =
          untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ).cast<float>();
      surface.untouched_mm.at<cv::Vec3f>(j, i) = {at.x(), at.y(), at.z()};
      surface.depth_mm.at<float>(j, i) =
          depth.empty() ? std::numeric_limits<float>::quiet_NaN() : depth_between(depth, u, v);
      surface.pixel.at<cv::Vec2f>(j, i) = {static_cast<float>(u), static_cast<float>(v)};
    }
  }
  surface.has_body = face.kind == FaceKind::kFinRay;
  if (surface.has_body && result.markers)
    surface.markers = markers_on(surface, shape, *result.markers);
  return surface;
}

}  // namespace

Eigen::Vector3d inward_normal(const cv::Mat& grid, int column, int row) {
  const auto at = [&](int j, int i) {
    const auto& p =
        grid.at<cv::Vec3f>(std::clamp(j, 0, grid.rows - 1), std::clamp(i, 0, grid.cols - 1));
    return Eigen::Vector3d(p[0], p[1], p[2]);
  };
  const Eigen::Vector3d along = at(row, column + 1) - at(row, column - 1);
  // From edge to edge: neighbouring rows lie too near for a float's last digits.
  const Eigen::Vector3d down = at(grid.rows - 1, column) - at(0, column);
  return down.cross(along).normalized();
}

cv::Size grid_for(const FrameResult& result, int vertices) {
  if (!result.shape) return {2, 2};
  const Columns columns = columns_of(*result.shape);
  const int length = std::max(1, columns.last - columns.first);
  const int middle = usable_column(*result.shape, (columns.first + columns.last) / 2);
  const auto rows = result.shape->rows(middle, 0);
  const int width = std::max(1, rows.last - rows.first);
  double step = std::sqrt(static_cast<double>(length) * width / vertices);
  if (result.mesh_step_px > 1) step = std::max<double>(step, result.mesh_step_px);
  return {std::max(2, static_cast<int>(std::lround(length / step))),
          std::max(2, static_cast<int>(std::lround(width / step)))};
}

std::optional<FaceSurface> face_surface(const FrameResult& result,
                                        const Face& face,
                                        int columns,
                                        int rows) {
  if (!result.shape || !result.depth) return std::nullopt;
  return surface_of(result, result.depth->depth_mm, face, columns, rows);
}

std::optional<FaceSurface> uncalibrated_surface(const FrameResult& result,
                                                const Face& face,
                                                int columns,
                                                int rows) {
  if (!result.shape) return std::nullopt;
  return surface_of(result, {}, face, columns, rows);
}

}  // namespace alltact
