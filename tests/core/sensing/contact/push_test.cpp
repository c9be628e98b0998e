#include "core/sensing/contact/push.h"

#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

ContactSettings at_rest(double threshold_px) {
  ContactSettings settings;
  settings.threshold_px = threshold_px;
  for (int m = 0; m < 12; ++m)
    settings.rest_markers.emplace_back(100.0 + 40 * (m % 6), m < 6 ? 50.0 : 300.0);
  return settings;
}

Markers moved(const ContactSettings& settings, const Eigen::Vector2d& each) {
  Markers markers;
  for (const auto& rest : settings.rest_markers)
    markers.push_back({rest.x() + each.x(), rest.y() + each.y(), true, 0.05});
  return markers;
}

TEST(Push, OffsetIsTheSumOverMarkersAndOnlyBeyondTheThresholdAPush) {
  const auto settings = at_rest(6.0);
  const Push little = push_of(moved(settings, {0.3, 0.4}), settings, true);
  EXPECT_NEAR(little.offset_px.x(), 12 * 0.3, 1e-9);
  EXPECT_NEAR(little.offset_px.y(), 12 * 0.4, 1e-9);
  EXPECT_NEAR(little.offset_px.norm(), 6.0, 1e-9);
  const Push none = push_of(moved(settings, {0.29, 0.4}), settings, true);
  EXPECT_FALSE(none.direction || none.sd_deg || none.face);
  const Push some = push_of(moved(settings, {0.31, 0.4}), settings, true);
  ASSERT_TRUE(some.direction);
  EXPECT_NEAR(some.direction->norm(), 1.0, 1e-12);
  EXPECT_EQ(some.direction->z(), 0.0);
}

TEST(Push, FaceIsTheOneWhoseInwardNormalIsNearest) {
  const auto settings = at_rest(1.0);
  const auto face = [&](double degrees, bool base_at_low_u) {
    const double a = degrees * M_PI / 180;
    return *push_of(moved(settings, {std::cos(a), std::sin(a)}), settings, base_at_low_u).face;
  };
  for (double offset : {-44.0, -10.0, 0.0, 44.0}) {
    EXPECT_EQ(face(0 + offset, true), PushedFace::kContact);
    EXPECT_EQ(face(90 + offset, true), PushedFace::kUpper);
    EXPECT_EQ(face(180 + offset, true), PushedFace::kBack);
    EXPECT_EQ(face(270 + offset, true), PushedFace::kLower);
    // With the base on the right the tip lies to the left.
    EXPECT_EQ(face(0 + offset, false), PushedFace::kBack);
    EXPECT_EQ(face(180 + offset, false), PushedFace::kContact);
    EXPECT_EQ(face(90 + offset, false), PushedFace::kUpper);
  }
}

TEST(Push, StatedUncertaintyIsTheSpreadOfNoisyRepeats) {
  const auto settings = at_rest(1.0);
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 0.05);
  double square = 0, stated = 0;
  constexpr int kRepeats = 4000;
  for (int i = 0; i < kRepeats; ++i) {
    auto markers = moved(settings, {0.3, 0.2});
    for (Marker& m : markers) m.u += noise(random), m.v += noise(random);
    ContactSettings recorded = settings;  // in one frame, that is as noisy
    for (Eigen::Vector2d& rest : recorded.rest_markers)
      rest += Eigen::Vector2d(noise(random), noise(random));
    const Push result = push_of(markers, recorded, true);
    const double angle =
        std::atan2(result.direction->y(), result.direction->x()) - std::atan2(0.2, 0.3);
    square += angle * angle;
    stated += *result.sd_deg;
  }
  EXPECT_NEAR(std::sqrt(square / kRepeats) * 180 / M_PI / (stated / kRepeats), 1.0, 0.05);
}

TEST(Push, MarkersThatDoNotBelongToTheFingerAreNoPush) {
  const auto settings = at_rest(1.0);
  auto markers = moved(settings, {5, 5});
  markers.pop_back();
  EXPECT_FALSE(push_of(markers, settings, true).direction);
  EXPECT_FALSE(push_of({}, ContactSettings{}, true).direction);
  markers = moved(settings, {5, 5});
  markers[3].u = std::nan("");
  const Push result = push_of(markers, settings, true);
  EXPECT_FALSE(result.direction);
  EXPECT_TRUE(result.offset_px.allFinite());
}

}  // namespace
}  // namespace alltact
