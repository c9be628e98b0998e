// Every key that a finger's folder may hold stands in core/finger/README.md.
#include "core/base/atomic_file.h"
#include "core/finger/finger.h"
#include "core/finger/press_set.h"
#include "tests/core/finger/finger_files.h"

#include <regex>
#include <set>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// As written, with the keys that kFinRay and kFlat lack.
constexpr const char* kEveryKey = R"(format: alltact-finger/1
name: left-07
camera:
  model: pinhole
  size: [960, 540]
  fx: 523.9
  fy: 524.5
  cx: 479.5
  cy: 269.5
  sd_px: [0.2, 0.2, 0.15, 0.1]
  distortion: []
  orientation: none
  port: {gap_mm: 3.0, plate_mm: 2.0, plate_index: 1.52, medium_index: 1.41}
  lens: {date: 2026-01-31, views: 12}
face:
  kind: fin_ray
  width_mm: 24.0
  layer_mm: 1.5
markers: {per_row: 2, polarity: dark, missing: [1, 3]}
mapping:
  kind: moebius
  along: normal
  domain: [0.0, 0.5]
  a_mm: 2.5
  b: 1.3
  varies: {along: 0.1, across: -0.05, middle_mm: [20.0, 0.5], half_mm: [15.0, 8.0]}
  spread: {optical_thickness: 0.7, optical_thickness_sd: 0.1, width_factor: 1.1, b_straight: 1.2, log_b_along: 0.2, middle_mm: 30.0, half_mm: 20.0}
  covariance: [[0.0001, 1.0e-05, 0.0, 0.0], [1.0e-05, 0.0002, 0.0, 0.0], [0.0, 0.0, 0.0001, 0.0], [0.0, 0.0, 0.0, 0.0001]]
  method: joint
  presses: [press_000, "12"]
  residual_mm: 0.012
  held_out_mm: 0.02
  spread_mm: 0.015
  pixel_mm: 0.02
  degree_choice: "two coefficients: least error"
  basis: {ball_radii_mm: [3.975, 6.0], face_mm: [24.0, 1.5, 0.0], camera: "0123456789abcdef", reference: "a123456789abcdef", positions: 9, thirds: [3, 3, 3], position_leverage: 0.2, depths_mm: [0.1, 0.9], scale_sd_mm: 0.01, pixel_sd_mm: 0.02, halo_mm: 0.001, undetected_spread: 0.5, depth_per_radius: 0.3, left_out: 1, complete: true, contradictions: [radius, layer], contradictions_mm: [[3.0, 9.0, 4.0, 4.1, 4.2], [1.0, 9.0, 1.5, 1.6, 1.7]]}
reference: {video: a.mkv, markers: a.csv, places: [100.5, 4.25]}
)";

/// Words before a colon, but the names of texts that a person chooses.
std::set<std::string> keys_of(const std::string& yaml) {
  static const std::regex key("([a-z_]+): ?");
  std::set<std::string> keys;
  for (auto at = std::sregex_iterator(yaml.begin(), yaml.end(), key); at != std::sregex_iterator();
       ++at)
    keys.insert((*at)[1]);
  for (const char* chosen : {"date", "views", "coefficients", "operator"}) keys.erase(chosen);
  return keys;
}

void expect_described(const std::string& yaml) {
  const auto page = read_file(std::filesystem::path(ALLTACT_SOURCE_DIR) / "core/finger/README.md");
  ASSERT_TRUE(page.ok());
  for (const std::string& key : keys_of(yaml))
    EXPECT_TRUE(std::regex_search(*page, std::regex("\\b" + key + "\\b"))) << key;
}

TEST(DescribedKeys, AFingerWithEveryKeyIsWrittenAsItWasRead) {
  std::vector<Message> warnings;
  const auto finger = Finger::parse(kEveryKey, "finger.yaml", &warnings);
  ASSERT_TRUE(finger.ok()) << finger.error().sentence();
  EXPECT_TRUE(warnings.empty());
  const auto text = finger->to_yaml();
  ASSERT_TRUE(text.ok()) << text.error().sentence();
  EXPECT_EQ(*text, kEveryKey);
}

TEST(DescribedKeys, StandOnThePageOfFiles) {
  for (const char* yaml : {kEveryKey, test::kFinRay, test::kFlat}) expect_described(yaml);
  PressSet presses;
  presses.ball_radius_mm = 4;
  presses.notes["a"] = {
      6.0, GivenDepth{1.2, 0.01}, 0.5, "bodies/rod.stl", Eigen::Vector3d(1, 2, 48), "glove"};
  expect_described(presses.to_yaml());
}

}  // namespace
}  // namespace alltact
