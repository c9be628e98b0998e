// Finger files for tests, whole ones that hold every key.
#pragma once

#include "core/finger/finger.h"
#include "tests/support/temporary_folder.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace alltact::test {

// One key on each line, so that lines can be removed and spoiled one by one.
inline constexpr const char* kFinRay = R"(format: alltact-finger/1
name: left-07
camera:
  model: brown
  size: [960, 540]
  fx: 523.9
  fy: 524.5
  cx: 479.5
  cy: 269.5
  distortion: [-0.05, 0.01, 0.0001, -0.0002, 0.001]
  orientation: flip_v
face:
  kind: fin_ray
  width_mm: 24.0
  layer_mm: 1.5
markers:
  per_row: 2
  polarity: bright
mapping:
  kind: polynomial
  along: normal
  domain: [0.0, 0.5]
  chebyshev: [2.0, 0.5]
  powers: [0.0, 1.5, 2.0]
  covariance: [[0.0001, 0.00001], [0.00001, 0.0002]]
  method: joint
  presses: [press_000, press_001]
  residual_mm: 0.012
  held_out_mm: 0.02
  spread_mm: 0.015
  degree_choice: "two coefficients: least error on presses left out"
reference:
  video: reference.mkv
  markers: reference.csv
contact:
  threshold_px: 12.0
  rest_markers: [[101.5, 40.0], [205.25, 41.0], [102.0, 500.0], [206.0, 499.5]]
force:
  model: force.yaml
gripper_from_camera:
  translation_mm: [40.5, 0.0, -12.0]
  rotation: [0.6, 0.0, -0.8, 0.0]
provenance:
  date: 2024-06-11
  ball_radius_mm: 3
  operator: "null"
)";

inline constexpr const char* kFlat = R"(format: alltact-finger/1
name: flat-01
camera:
  model: orthographic
  size: [460, 345]
  mm_per_px: 0.051015
  cx: 229.5
  cy: 172.0
face:
  kind: flat
  layer_mm: 3
  plane_z_mm: 0
mapping:
  kind: moebius
  domain: [0, 0.7]
  a_mm: 2.5
  b: 1.3
reference:
  image: ref.png
)";

/// Reads and writes them.
class FingerFiles : public testing::Test {
 protected:
  static Result<Finger> load(const std::string& text, std::vector<Message>* warnings = nullptr) {
    return Finger::parse(text, "left/finger.yaml", warnings);
  }
  static std::string saved(const Finger& finger) {
    const auto text = finger.to_yaml();
    EXPECT_TRUE(text.ok()) << (text.ok() ? "" : text.error().sentence());
    return text.ok() ? *text : "";
  }
  TemporaryFolder folder_;
};

}  // namespace alltact::test
