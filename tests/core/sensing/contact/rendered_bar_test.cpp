// The axis of bars that are pressed into a finger, from picture to angle: bent fingers drawn at
// random, noise of a grey level, every bar elsewhere and turned otherwise.
// ALLTACT_NEES_RUNS=200 makes as many runs as a figure needs; without it fewer are made, and what
// few runs scatter by is allowed for.
#include "core/image/image_file.h"
#include "core/sensing/pipeline.h"
#include "core/simulation/plan.h"
#include "tests/support/temporary_folder.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

int bar_runs() {
  const char* text = std::getenv("ALLTACT_NEES_RUNS");
  return text != nullptr ? std::max(10, std::atoi(text)) : 16;
}

/// What bars are pressed into; each run another one.
struct BarFinger {
  double focal_px, width_mm, layer_mm, x_mm, z_mm, incline_deg, length_mm, scatter_per_mm, light;
};

Plan bar_plan(const BarFinger& finger, const std::string& bend, const std::string& pressed,
              int run) {
  const std::string text = fmt::format(
      "name: bars\nwhy: to learn what an axis is worth\nframes: 1\n"
      "finger:\n"
      "  camera: {{model: pinhole, size: [960, 540], fx: {0}, fy: {0}, cx: 479.5, cy: 269.5}}\n"
      "  face: {{kind: fin_ray, width_mm: {1}, layer_mm: {2}}}\n"
      "untouched: {{x_mm: {3}, z_mm: {4}, incline_deg: {5}, length_mm: {6}}}\n"
      "effects:\n{7}{8}"
      "  - {{use: layer, scatter_per_mm: {9}, along: normal}}\n"
      "  - {{use: sides, albedo: 0.12, depth_mm: 14.0}}\n"
      "  - use: leds\n    lamps:\n"
      "      - {{at_mm: [0.0, -3.0, 0.0], power: {10}}}\n"
      "      - {{at_mm: [0.0, 3.0, 0.0], power: {10}}}\n"
      "      - {{at_mm: [4.0, 0.0, -20.0], power: {11}, aim_mm: [71.0, 0.0, 93.0], lobe: 8}}\n"
      "  - {{use: read, sd: 1.0}}\n  - {{use: quantisation}}\n",
      finger.focal_px, finger.width_mm, finger.layer_mm, finger.x_mm, finger.z_mm,
      finger.incline_deg, finger.length_mm, bend, pressed, finger.scatter_per_mm,
      270000 * finger.light, 3300000 * finger.light);
  const auto scene = Scene::parse(text, "bars");
  EXPECT_TRUE(scene) << (scene ? "" : scene.error().sentence());
  auto plan = Plan::compile(*scene, static_cast<std::uint64_t>(run));
  EXPECT_TRUE(plan) << (plan ? "" : plan.error().sentence());
  return std::move(plan).value();
}

/// What the finger's calibration would be at its best: without absorption the layer's brightness
/// is d = t (1 + s) x / (1 + s x) exactly.
MappingParameters true_mapping(const BarFinger& finger) {
  const double s = finger.scatter_per_mm * finger.layer_mm;
  MappingParameters mapping;
  mapping.kind = MappingKind::kMoebius;
  mapping.along = MappingAlong::kProjected;
  mapping.a_mm = finger.layer_mm * (1 + s), mapping.b = s;
  mapping.x_max = 0.9;
  return mapping;
}

struct BarWorld {
  explicit BarWorld(int run) : random_(static_cast<unsigned>(9000 + run)), run_(run) {
    // One pose, the same with the bar and without it.
    const double q1 = between(-1.2, 1.2), q2 = between(-2, 2);
    bend_ =
        fmt::format("  - {{use: bend, q1_mm: {{from: {}, to: {}}}, q2_mm: {{from: {}, to: {}}}}}\n",
                    q1, q1 + 1e-9, q2, q2 + 1e-9);
    finger_ = {between(490, 540), between(20, 26),   between(1.3, 2.0),
               between(-25, -21), between(27, 31),   between(30, 37),
               between(105, 120), between(0.4, 0.8), between(0.7, 1.0)};
  }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Truth truth;  ///< of what was seen last
  /// What the pipeline sees of a body that is pressed in where and as deep as drawn.
  FrameResult seen(const std::string& body, const std::string& turn) {
    const std::string pressed = fmt::format(
        "  - {{use: {}, s_mm: {}, y_mm: {}, depth_mm: {}{}}}\n"
        "  - {{use: rolloff, kind: smooth, length_mm: 0.2}}\n",
        body, between(25, 70), between(-3, 3), between(0.5, 1.0), turn);
    const Plan untouched = bar_plan(finger_, bend_, "", run_),
               plan = bar_plan(finger_, bend_, pressed, 5000 + run_);
    Finger finger = plan.finger();
    finger.mapping = true_mapping(finger_);
    Pipeline pipeline =
        Pipeline::with_library(ReferenceLibrary::single(untouched.render(0, 2)).value(),
                               FingerSnapshot::of({}, finger).value(), {});
    auto frame = std::make_shared<Frame>();
    frame->grey = plan.render(0, 2);
    truth = plan.truth(0);
    auto result = pipeline(frame);
    EXPECT_TRUE(result && !result->regions.empty());
    return std::move(result).value();
  }

 private:
  std::mt19937 random_;
  int run_;
  std::string bend_;
  BarFinger finger_;
};

struct AxisErrors {
  double rms_deg = 0, worst_deg = 0, mean_sd_deg = 0, normalised = 0;
  double worst_in_space_deg = 0;  ///< between the axis and the body's own
};

AxisErrors axis_errors(const std::string& body) {
  AxisErrors errors;
  const int runs = bar_runs();
  for (int run = 0; run < runs; ++run) {
    BarWorld world(run);
    const double angle = world.between(-89, 90);
    const FrameResult result = world.seen(body, fmt::format(", rotation_deg: {}", angle));
    EXPECT_TRUE(!result.regions.empty() && result.regions[0].angle_deg) << run;
    if (result.regions.empty() || !result.regions[0].angle_deg) continue;
    const ContactRegion& bar = result.regions[0];
    const double error = std::remainder(*bar.angle_deg - angle, 180.0);
    errors.worst_deg = std::max(errors.worst_deg, std::abs(error));
    EXPECT_TRUE(bar.axis && world.truth.contacts.at(0).camera_from_object);
    const Eigen::Vector3d body_axis =
        world.truth.contacts[0].camera_from_object->linear() * Eigen::Vector3d::UnitX();
    errors.worst_in_space_deg =
        std::max(errors.worst_in_space_deg,
                 std::asin(std::min(1.0, body_axis.cross(*bar.axis).norm())) * 180.0 / M_PI);
    errors.rms_deg += error * error / runs;
    errors.mean_sd_deg += *bar.angle_sd_deg / runs;
    errors.normalised += std::pow(error / *bar.angle_sd_deg, 2) / runs;
  }
  errors.rms_deg = std::sqrt(errors.rms_deg);
  std::printf(
      "[ figures  ] %.40s: axis off by rms %.3f, worst %.3f degrees of %d; mean sd %.3f; "
      "normalised error squared %.2f; in space worst %.3f\n",
      body.c_str(), errors.rms_deg, errors.worst_deg, runs, errors.mean_sd_deg, errors.normalised,
      errors.worst_in_space_deg);
  return errors;
}

// A mean of n normalised squares scatters by sqrt(2 / n).
void expect_as_sure_as_told(const AxisErrors& errors) {
  const double scatter = 3 * std::sqrt(2.0 / bar_runs());
  EXPECT_GT(errors.normalised, 0.75 * (1 - scatter));
  EXPECT_LT(errors.normalised, 1.25 * (1 + scatter));
}

TEST(RenderedBars, TheAxisIsToldToADegree) {
  for (const std::string body : {"cylinder, radius_mm: 3, length_mm: 12",
                                 "edge, angle_deg: 90, radius_mm: 0.3, length_mm: 12"}) {
    const AxisErrors errors = axis_errors(body);
    EXPECT_LT(errors.worst_deg, 1.0);
    EXPECT_LT(errors.worst_in_space_deg, 1.0) << "what a gripper turns by";
    EXPECT_LT(errors.rms_deg, 0.1);
    expect_as_sure_as_told(errors);
  }
}

TEST(RenderedBars, TheAxisOfASmoothBodyIsAsSureAsItSays) {
  // A paraboloid of half axes 6 and 2.4 mm, 1.2 mm high: no walls that a depth along z undercuts.
  const test::TemporaryFolder folder;
  constexpr double kMmPerPx = 0.05, kAlong = 6, kAcross = 2.4;
  cv::Mat height(101, 251, CV_8UC1);
  for (int v = 0; v < height.rows; ++v)
    for (int u = 0; u < height.cols; ++u) {
      const double p = (u - 125) * kMmPerPx / kAlong, q = (v - 50) * kMmPerPx / kAcross;
      height.at<std::uint8_t>(v, u) =
          cv::saturate_cast<std::uint8_t>(255 * std::max(0.0, 1 - p * p - q * q));
    }
  const std::string file = (folder / "bar.png").string();
  ASSERT_TRUE(write_image(file, height));
  const AxisErrors errors = axis_errors(
      fmt::format("relief, shape: picture, mm_per_px: 0.05, height_mm: 1.2, file: {}", file));
  EXPECT_LT(errors.worst_deg, 1.0);
  expect_as_sure_as_told(errors);
}

TEST(RenderedBars, ABallHasNoAxis) {
  for (int run = 0; run < bar_runs(); ++run) {
    BarWorld world(run);
    const FrameResult result = world.seen("ball, radius_mm: 4", "");
    ASSERT_FALSE(result.regions.empty());
    EXPECT_FALSE(result.regions[0].angle_deg) << run << ": " << *result.regions[0].angle_deg;
    EXPECT_FALSE(result.regions[0].axis);
  }
}

}  // namespace
}  // namespace alltact
