#include "calibration/hard_cases/groups.h"
#include "core/camera/camera.h"
#include "core/camera/distortion.h"

namespace alltact {
namespace {

/// Pixel to ray and back over a whole Full HD picture, 85 degrees wide.
HardCase round_trip(std::vector<double> distortion, const char* what) {
  HardCase one{what, "fixed-point steps, 5 of them", "px", 0, 0, 1e-9};
  CameraParameters p;
  p.model = CameraModel::kBrown;
  p.width_px = 1920, p.height_px = 1080;
  p.cx_px = 959.5, p.cy_px = 539.5;
  p.distortion = distortion;
  const BrownDistortion brown(distortion);
  // The ray 46.4 degrees off the axis is seen in the corner.
  constexpr double kCorner = 1.0513;
  p.fx_px = p.fy_px = 1101.5 / brown.distort({kCorner, 0.0}).x();
  const auto camera = Camera::create(p);
  const BrownDistortion radial(std::vector<double>{distortion[0],
                                                   distortion.size() > 1 ? distortion[1] : 0.0,
                                                   0.0,
                                                   0.0,
                                                   distortion.size() > 4 ? distortion[4] : 0.0});
  for (int v = 0; v < p.height_px; v += 27)
    for (int u = 0; u <= p.width_px - 1; u += 19) {
      const Eigen::Vector2d pixel(u, v);
      const Eigen::Vector2d seen((u - p.cx_px) / p.fx_px, (v - p.cy_px) / p.fy_px);
      const auto ray = camera ? camera->unproject(pixel) : std::nullopt;
      const auto back = ray ? camera->project(ray->direction) : std::nullopt;
      // A pixel may also be told to lie beyond the valid radius.
      if (ray) keep_worst(back ? (*back - pixel).norm() : NAN, one.our_error);
      Eigen::Vector2d x = seen;
      for (int i = 0; i < 5 && x.allFinite(); ++i) {
        const double r2 = x.squaredNorm();
        const double factor = r2 > 0 ? radial.distort(x).norm() / std::sqrt(r2) : 1.0;
        const Eigen::Vector2d tangential = brown.distort(x) - radial.distort(x);
        x = (seen - tangential) / factor;
      }
      keep_worst((brown.distort(x) - seen).norm() * p.fx_px, one.plain_error);
    }
  if (!camera) one.our_error = std::numeric_limits<double>::infinity();
  return one;
}

HardCase fold() {
  HardCase one{"lens that folds over inside the picture: cameras accepted",
               "no look at the fold",
               "cameras",
               1,
               0,
               0};
  CameraParameters p;
  p.model = CameraModel::kBrown;
  p.width_px = 1920, p.height_px = 1080;
  p.fx_px = p.fy_px = 1047.7;
  p.cx_px = 959.5, p.cy_px = 539.5;
  p.distortion = {-0.32};
  one.our_error = Camera::create(p) ? 1.0 : 0.0;
  return one;
}

}  // namespace

std::vector<HardCase> hard_lenses() {
  return {round_trip({-0.3, 0.1}, "undistorting, k = -0.3, 0.1"),
          round_trip({-0.35, 0.12, 0.0, 0.0, -0.02}, "undistorting, k = -0.35, 0.12, -0.02"),
          round_trip({0.3, 0.1}, "undistorting, k = 0.3, 0.1"),
          round_trip({-0.3, 0.1, 0.002, -0.003}, "undistorting, with tangential parts"),
          fold()};
}

}  // namespace alltact
