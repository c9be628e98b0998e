#include "core/sensing/face/rectified_map.h"

#include "core/numerics/image_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {

namespace {

struct Extent {
  double first_mm = std::numeric_limits<double>::infinity(),
         last_mm = -std::numeric_limits<double>::infinity();
  void add(double at_mm) {
    first_mm = std::min(first_mm, at_mm);
    last_mm = std::max(last_mm, at_mm);
  }
};

/// Round steps within an extent: the first, and their number.
std::pair<double, int> steps_within(const Extent& extent, double step_mm) {
  const double first = std::ceil(extent.first_mm / step_mm - 1e-9),
               last = std::floor(extent.last_mm / step_mm + 1e-9);
  return {first * step_mm, std::max(0, static_cast<int>(last - first) + 1)};
}

}  // namespace

RectifiedMap rectified_map(const cv::Mat& by_pixel, const FaceShape& shape, double step_mm) {
  CV_Assert(by_pixel.type() == CV_32FC1 && by_pixel.cols == shape.width_px() && step_mm > 0);
  Extent along, across;
  for (int u = 0; u < shape.width_px(); ++u) {
    const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
    if (!column.valid) continue;
    along.add(shape.length_at(u));
    for (const double v : {column.upper_v, column.lower_v}) across.add(shape.position_mm(u, v).y());
  }
  RectifiedMap map;
  map.plane.step_mm = step_mm;
  if (!(along.last_mm > along.first_mm)) return map;
  const auto [first_along, columns] = steps_within(along, step_mm);
  const auto [first_across, rows] = steps_within(across, step_mm);
  map.plane.first_column_mm = first_along, map.plane.first_row_mm = first_across;
  if (columns == 0 || rows == 0) return map;
  map.values.create(rows, columns, CV_32FC1);
  map.values.setTo(std::numeric_limits<float>::quiet_NaN());
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      if (const auto pixel =
              pixel_of_position(shape, {first_along + i * step_mm, first_across + j * step_mm}))
        map.values.at<float>(j, i) = static_cast<float>(bilinear(by_pixel, *pixel));
  return map;
}

}  // namespace alltact
