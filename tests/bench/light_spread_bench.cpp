// The removal of spread light from one 960 x 540 picture of a face, beside what a picture without
// spread light costs from differences to depths.
#include "core/sensing/depth/light_spread.h"
#include "tests/support/made_press.h"

#include <random>

#include <benchmark/benchmark.h>

namespace {

using namespace alltact;

MappingParameters spreading(double optical_thickness) {
  MappingParameters mapping;
  mapping.kind = MappingKind::kMoebius;
  mapping.along = MappingAlong::kNormal;
  mapping.a_mm = 3.0;
  mapping.b = 1.0;
  mapping.x_max = 0.6;
  mapping.spread.optical_thickness = optical_thickness;
  mapping.spread.b_straight = mapping.b;
  mapping.spread.middle_mm = 20.0, mapping.spread.half_mm = 15.0;
  return mapping;
}

/// A face pressed by a ball, seen through a layer of this optical thickness, with noise.
Difference pressed_face(const made::MadeScene& scene, double optical_thickness) {
  cv::Mat y(540, 960, CV_64FC1, cv::Scalar(0.0));
  const made::Relief depth({made::Skin::kSmooth, 0.15}, 4.0, 0.7);
  for (int v = 0; v < y.rows; ++v)
    for (int u = 0; u < y.cols; ++u) {
      const Eigen::Vector2d at = scene.shape.position_mm(u, v) - Eigen::Vector2d(22.0, 1.0);
      const double depth_mm = depth(at.norm());
      y.at<double>(v, u) = depth_mm / (3.0 - depth_mm);
    }
  const cv::Mat shown = with_light_spread(y, spreading(optical_thickness), scene.shape);
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 0.004);
  Difference difference;
  difference.x.create(y.size(), CV_32FC1);
  difference.flags.create(y.size(), CV_8UC1);
  difference.face = face_runs(scene.shape, 1.0, y.size(), cv::Range::all());
  for (int v = 0; v < y.rows; ++v)
    for (int u = 0; u < y.cols; ++u) {
      const bool on_face = scene.shape.at(u, v).has_value();
      difference.flags.at<std::uint8_t>(v, u) = on_face ? kMeasured : kOffFace;
      difference.x.at<float>(v, u) =
          on_face ? static_cast<float>(shown.at<double>(v, u) + noise(random))
                  : std::numeric_limits<float>::quiet_NaN();
    }
  return difference;
}

constexpr double kOpticalThickness = 0.6;

void removal_of_spread_light(benchmark::State& state) {
  cv::setNumThreads(1);
  const made::MadeScene scene = made::finger_scene(30.0, 40.0);
  const MappingParameters mapping = spreading(kOpticalThickness);
  const Difference pressed = pressed_face(scene, kOpticalThickness);
  for ([[maybe_unused]] const auto _ : state) {
    Difference difference = pressed;
    remove_light_spread(mapping, scene.shape, &difference);
    benchmark::DoNotOptimize(difference.x.data);
  }
}
BENCHMARK(removal_of_spread_light)->Unit(benchmark::kMillisecond);

void depth_of_a_picture(benchmark::State& state) {
  cv::setNumThreads(1);
  const made::MadeScene scene = made::finger_scene(30.0, 40.0);
  MappingParameters parameters = spreading(state.range(0) != 0 ? kOpticalThickness : 0.0);
  const Mapping mapping = *Mapping::create(parameters);
  const Difference pressed = pressed_face(scene, kOpticalThickness);
  for ([[maybe_unused]] const auto _ : state) {
    const DepthMap map = depth_map(pressed, mapping, scene.shape);
    benchmark::DoNotOptimize(map.depth_mm.data);
  }
}
BENCHMARK(depth_of_a_picture)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
