// A face in 3D from closed formulas: a plane, inclined or not, with a round hill pressed in.
#pragma once

#include "widgets/scene3d/face_surface.h"

#include <cmath>

namespace alltact::test {

struct MadeSurface {
  static constexpr double kWidth_px = 960, kHeight_px = 540;
  double mm_per_px = 0.1;
  double z_mm = 100;
  double slope = 0;  ///< dz/dx
  double deepest_mm = 0.8, radius_mm = 6;

  [[nodiscard]] double depth_at(double x_mm, double y_mm) const {
    const double part = std::hypot(x_mm, y_mm) / radius_mm;
    return part < 1 ? deepest_mm * (1 - part * part) : 0.0;
  }
  [[nodiscard]] FaceSurface make(int columns, int rows) const {
    FaceSurface surface;
    surface.untouched_mm.create(rows, columns, CV_32FC3);
    surface.depth_mm.create(rows, columns, CV_32FC1);
    surface.pixel.create(rows, columns, CV_32FC2);
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        const double u = i * (kWidth_px - 1) / (columns - 1), v = j * (kHeight_px - 1) / (rows - 1);
        const double x = (u - 0.5 * (kWidth_px - 1)) * mm_per_px;
        const double y = (v - 0.5 * (kHeight_px - 1)) * mm_per_px;
        surface.untouched_mm.at<cv::Vec3f>(j, i) = cv::Vec3d(x, y, z_mm + slope * x);
        surface.depth_mm.at<float>(j, i) = static_cast<float>(depth_at(x, y));
        surface.pixel.at<cv::Vec2f>(j, i) = cv::Vec2d(u, v);
      }
    }
    return surface;
  }
  [[nodiscard]] static Camera camera() {
    CameraParameters lens;
    lens.model = CameraModel::kPinhole;
    lens.width_px = static_cast<int>(kWidth_px);
    lens.height_px = static_cast<int>(kHeight_px);
    lens.fx_px = lens.fy_px = 1000;
    lens.cx_px = 0.5 * (kWidth_px - 1);
    lens.cy_px = 0.5 * (kHeight_px - 1);
    return Camera::create(lens).value();
  }
};

}  // namespace alltact::test
