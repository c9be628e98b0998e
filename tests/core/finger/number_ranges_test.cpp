// Every number of a finger's file replaced by one that a slip, a crash or an attacker leaves there:
// it is refused by its key, or harmless.
#include "core/camera/camera.h"
#include "core/finger/finger.h"

#include <cmath>
#include <limits>
#include <regex>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

constexpr const char* kFinger = R"(format: alltact-finger/1
name: left-07
camera:
  model: brown
  size: [960, 540]
  fx: 523.9
  fy: 524.5
  cx: 479.5
  cy: 269.5
  distortion: [-0.05, 0.01, 0.0001, -0.0002, 0.001]
  port: {gap_mm: 2.0, plate_mm: 3.0, plate_index: 1.49, medium_index: 1.41}
face:
  kind: fin_ray
  width_mm: 24.0
  layer_mm: 1.5
markers:
  per_row: 2
mapping:
  kind: polynomial
  along: normal
  domain: [0.0, 0.5]
  chebyshev: [2.0, 0.5]
  covariance: [[0.0001, 0.00001], [0.00001, 0.0002]]
  residual_mm: 0.012
  held_out_mm: 0.02
  spread_mm: 0.015
contact:
  threshold_px: 12.0
  rest_markers: [[101.5, 40.0], [205.25, 41.0], [102.0, 500.0], [206.0, 499.5]]
gripper_from_camera:
  translation_mm: [40.5, 0.0, -12.0]
  rotation: [0.6, 0.0, -0.8, 0.0]
)";

/// The file with its n-th number replaced; empty when it has no more.
std::string with_number(int n, const std::string& by) {
  static const std::regex number("([ \\[])(-?[0-9]+\\.?[0-9]*)(?=[,\\]}\n])");
  const std::string text = kFinger;
  std::sregex_iterator found(text.begin(), text.end(), number), none;
  for (; n > 0 && found != none; --n) ++found;
  if (found == none) return {};
  std::string spoilt = text;
  return spoilt.replace(static_cast<std::size_t>(found->position(2)), found->length(2), by);
}

std::string reported(const std::string& text) {
  const auto finger = Finger::parse(text, "finger.yaml");
  return finger.ok() ? "accepted" : finger.error().sentence();
}

std::string with(const std::string& from, const std::string& to) {
  std::string text = kFinger;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(FingerNumbers, ThatAreNoneOrImpossibleNeverComeOutAgain) {
  ASSERT_EQ(reported(kFinger), "accepted");
  int tried = 0, accepted = 0;
  for (int n = 0; !with_number(n, "0").empty(); ++n)
    for (const char* by : {".nan", "nan", ".inf", "-.inf", "inf", "1e999", "1e308", "-1e308",
                           "1e-308", "-1", "0", "+5", "16385", "1e18", "0x10", "''"}) {
      const auto finger = Finger::parse(with_number(n, by), "finger.yaml");
      ++tried;
      if (!finger.ok()) {
        EXPECT_THAT(finger.error().where.english(), HasSubstr("finger.yaml:")) << by;
        continue;
      }
      ++accepted;
      const auto text = finger->to_yaml();
      ASSERT_TRUE(text.ok()) << with_number(n, by);
      const std::regex no_number("[^a-z](nan|inf)[^a-z]");
      EXPECT_FALSE(std::regex_search(*text, no_number)) << *text;
      const auto again = Finger::parse(*text, "finger.yaml");
      ASSERT_TRUE(again.ok()) << again.error().sentence();
      EXPECT_EQ(*again->to_yaml(), *text);
    }
  EXPECT_GT(tried, 500);
  EXPECT_LT(accepted, tried / 2);
}

TEST(FingerNumbers, OutsideOfWhatAFingerCanHaveAreRefusedByTheirKey) {
  for (const auto& [from, to, key] : {std::tuple{"fx: 523.9", "fx: +5", "camera.fx"},
                                      {"fx: 523.9", "fx: 16385", "camera.fx"},
                                      {"fy: 524.5", "fy: +5", "camera.fy"},
                                      {"fy: 524.5", "fy: 16385", "camera.fy"},
                                      {"fx: 523.9", "fx: 1100", "camera.f"},
                                      {"cx: 479.5", "cx: 16385", "camera.cx"},
                                      {"[960, 540]", "[16385, 540]", "camera.size"},
                                      {"gap_mm: 2.0", "gap_mm: 16385", "camera.port.gap_mm"},
                                      {"width_mm: 24.0", "width_mm: 16385", "face.width_mm"},
                                      {"layer_mm: 1.5", "layer_mm: 16385", "face.layer_mm"},
                                      {"layer_mm: 1.5", "layer_mm: 0.2", "mapping.chebyshev"},
                                      {"[2.0, 0.5]", "[16385, 0.5]", "mapping.chebyshev"},
                                      {"[0.0, 0.5]", "[0.0, 1e-200]", "mapping.domain"},
                                      {"[101.5, 40.0]", "[16385, 40.0]", "contact.rest_markers"}})
    EXPECT_THAT(reported(with(from, to)), HasSubstr(key)) << to;
}

TEST(FingerNumbers, AFingerWithSuchNumbersIsNotWritten) {
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinite, -infinite})
    for (int which = 0; which < 8; ++which) {
      Finger finger = Finger::parse(kFinger, "finger.yaml").value();
      double* const numbers[] = {&finger.camera.fx_px,
                                 &finger.camera.distortion[1],
                                 &finger.camera.port->plate_mm,
                                 &finger.face.layer_mm,
                                 &finger.mapping->chebyshev[0],
                                 &finger.mapping_record->spread_mm,
                                 &finger.contact->rest_markers[2].x(),
                                 &finger.gripper_from_camera->translation_mm.z()};
      *numbers[which] = bad;
      EXPECT_FALSE(finger.to_yaml().ok()) << which << ' ' << bad;
    }
}

TEST(FingerNumbers, LensesThatExistAreAccepted) {
  CameraParameters p;
  p.width_px = 1920, p.height_px = 1080;
  p.cx_px = 959.5, p.cy_px = 539.5;
  for (const double focal_px : {120.0, 1048.0, 15000.0}) {  // 166, 85 and 7 degrees wide
    p.fx_px = focal_px, p.fy_px = 1.02 * focal_px;
    EXPECT_TRUE(check_camera_range(p).ok()) << focal_px;
  }
  p.fx_px = p.fy_px = std::nan("");
  EXPECT_FALSE(check_camera_range(p).ok());
}

TEST(FingerNumbers, WhatIsRepeatedOfABadValueIsShortAndPlain) {
  const std::string huge = with("model: brown", "model: \"\\e[31m" + std::string(5000, 'x') + "\"");
  EXPECT_THAT(reported(huge), HasSubstr("'\\x1b[31mxxx"));
  EXPECT_LT(reported(huge).size(), 300U);
  const std::string key = with("  model: brown", "  model: brown\n  \"\\e[2J\": 1");
  std::vector<Message> warnings;
  ASSERT_TRUE(Finger::parse(key, "finger.yaml", &warnings).ok());
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].english().find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace alltact
