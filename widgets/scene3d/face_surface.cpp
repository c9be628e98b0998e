#include "widgets/scene3d/face_surface.h"

#include "core/sensing/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// `depth`: empty where none is known.
std::optional<FaceSurface> surface_of(
    const FaceShape& shape, const cv::Mat& depth, const Face& face, int columns, int rows) {
  CV_Assert(columns >= 2 && rows >= 2);
  const Columns range = columns_of(shape);
  if (range.last <= range.first) return std::nullopt;
  FaceSurface surface;
  surface.untouched_mm.create(rows, columns, CV_32FC3);
  surface.depth_mm.create(rows, columns, CV_32FC1);
  surface.pixel.create(rows, columns, CV_32FC2);
  for (int i = 0; i < columns; ++i) {
    const double even =
        range.first + static_cast<double>(i) * (range.last - range.first) / (columns - 1);
    const int u = usable_column(shape, static_cast<int>(std::lround(even)));
    const auto inside = shape.rows(u, 0);
    for (int j = 0; j < rows; ++j) {
      const double v =
          inside.first + static_cast<double>(j) * (inside.last - inside.first) / (rows - 1);
      const auto local = shape.at(u, v);
      if (!local) return std::nullopt;
      const Eigen::Vector3f at =
          untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ).cast<float>();
      surface.untouched_mm.at<cv::Vec3f>(j, i) = {at.x(), at.y(), at.z()};
      surface.depth_mm.at<float>(j, i) =
          depth.empty() ? std::numeric_limits<float>::quiet_NaN() : value_between(depth, u, v);
      surface.pixel.at<cv::Vec2f>(j, i) = {static_cast<float>(u), static_cast<float>(v)};
    }
  }
  return surface;
}

}  // namespace

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
  return surface_of(*result.shape, result.depth->depth_mm, face, columns, rows);
}

std::optional<FaceSurface> bare_surface(const FrameResult& result,
                                        const Face& face,
                                        int columns,
                                        int rows) {
  if (!result.shape) return std::nullopt;
  return surface_of(*result.shape, {}, face, columns, rows);
}

}  // namespace alltact
