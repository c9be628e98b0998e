#include "tests/support/flat_sensor.h"

#include <cmath>
#include <fstream>
#include <random>
#include <string>

#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

double clean_level(int u, int v) {
  const double x = (u - FlatSensor::kWidth / 2.0) / FlatSensor::kWidth;
  const double y = (v - FlatSensor::kHeight / 2.0) / FlatSensor::kHeight;
  return 190.0 - 60.0 * (x * x + y * y);
}

template <class Level>
cv::Mat noisy_picture(std::uint64_t seed, Level level) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0.0, 0.7);
  cv::Mat image(FlatSensor::kHeight, FlatSensor::kWidth, CV_8UC1);
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u)
      image.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(level(u, v) + noise(random));
  return image;
}

}  // namespace

Finger flat_sensor_finger(bool is_calibrated) {
  Finger finger;
  finger.name = "flat";
  finger.camera.model = CameraModel::kOrthographic;
  finger.camera.width_px = FlatSensor::kWidth, finger.camera.height_px = FlatSensor::kHeight;
  finger.camera.cx_px = 159.5, finger.camera.cy_px = 119.5;
  finger.camera.mm_per_px = FlatSensor::kMmPerPx;
  finger.face.kind = FaceKind::kFlat;
  finger.face.layer_mm = FlatSensor::kLayerMm;
  finger.face.plane_z_mm = 20;
  if (!is_calibrated) return finger;
  finger.mapping.emplace();
  finger.mapping->kind = MappingKind::kMoebius;
  finger.mapping->x_max = 0.5;
  finger.mapping->a_mm = FlatSensor::kA, finger.mapping->b = FlatSensor::kB;
  return finger;
}

cv::Mat_<float> ball_depth_mm(double u, double v, double depth_mm) {
  cv::Mat_<float> depth(FlatSensor::kHeight, FlatSensor::kWidth, 0.0F);
  const double r = FlatSensor::kBallRadiusMm;
  for (int row = 0; row < depth.rows; ++row) {
    for (int column = 0; column < depth.cols; ++column) {
      const double away = FlatSensor::kMmPerPx * std::hypot(column - u, row - v);
      const double below = r * r - away * away;
      if (below > 0)
        depth(row, column) = static_cast<float>(std::max(0.0, depth_mm - r + std::sqrt(below)));
    }
  }
  return depth;
}

cv::Mat untouched_picture(std::uint64_t seed) { return noisy_picture(seed, clean_level); }

cv::Mat pressed_picture(const cv::Mat_<float>& depth_mm, std::uint64_t seed) {
  return noisy_picture(seed, [&](int u, int v) {
    const double d = depth_mm(v, u);
    const double x = d / (FlatSensor::kA - FlatSensor::kB * d);  // the mapping solved for x
    return clean_level(u, v) * (1.0 - x);
  });
}

void write_flat_camera(const std::filesystem::path& file) {
  std::ofstream(file) << "model: orthographic\nsize: [" << FlatSensor::kWidth << ", "
                      << FlatSensor::kHeight << "]\nmm_per_px: " << FlatSensor::kMmPerPx
                      << "\ncx: 159.5\ncy: 119.5\n"
                      << "distortion: []\norientation: none\n";
}

std::vector<std::filesystem::path> write_flat_sensor(const std::filesystem::path& folder) {
  write_flat_camera(folder / "camera.yaml");
  cv::imwrite((folder / "ref.png").string(), untouched_picture(1));
  struct Place {
    double u, v, depth_mm;
  };
  const Place places[] = {{150, 120, 0.5}, {190, 100, 0.4}, {120, 140, 0.3}, {200, 150, 0.55}};
  std::vector<std::filesystem::path> presses;
  for (const Place& place : places) {
    presses.push_back(folder / ("press_" + std::to_string(presses.size()) + ".png"));
    cv::imwrite(
        presses.back().string(),
        pressed_picture(ball_depth_mm(place.u, place.v, place.depth_mm), 10 + presses.size()));
  }
  return presses;
}

}  // namespace alltact::test
