// Round contacts: Bessel functions, conservation and the half space of the simulation.
#include "calibration/joint/skin_profile.h"

#include "core/simulation/mechanics/ball_contact.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(RadialProfile, TheSkirtOfADiscIsThatOfBesselFunctions) {
  // With e within a and nothing outside, q = e - A I0(k r) within, k^2 w^2 (1 - 2.3 e) = 1, and
  // B K0(r / w) outside; both and their slopes meet at a.
  constexpr double kReach = 12.0, kDisc = 3.0;
  for (const double width : {0.6, 1.5})
    for (const double y : {0.02, 0.15, 0.3}) {
      RadialProfile disc(kReach);
      for (int i = 0; i < RadialProfile::kCount; ++i) disc[i] = disc.radius_mm(i) < kDisc ? y : 0.0;
      const RadialProfile skirt = disc.skirt_lost(width);
      const double k = std::sqrt(1.0 / (1.0 - 2.3 * y)) / width;
      const double inside = std::cyl_bessel_i(0, k * kDisc),
                   inside_slope = k * std::cyl_bessel_i(1, k * kDisc),
                   outside = std::cyl_bessel_k(0, kDisc / width),
                   outside_slope = std::cyl_bessel_k(1, kDisc / width) / width;
      const double a = y * outside_slope / (inside * outside_slope + inside_slope * outside),
                   b = a * inside_slope / outside_slope;
      for (const double r : {0.1, 1.0, 2.0, 2.8, 3.2, 4.0, 6.0, 9.0}) {
        const double exact =
            r < kDisc ? y - a * std::cyl_bessel_i(0, k * r) : b * std::cyl_bessel_k(0, r / width);
        EXPECT_NEAR(skirt.at(r), exact, 0.006 * y) << width << ' ' << y << ' ' << r;
      }
    }
}

TEST(RadialProfile, ABlurredParaboloidSinksByTheCurvatureTimesTheVariance) {
  // The mean of c - r^2 / 2 R over any round blur of variance s^2 in each direction is lower by
  // s^2 / R, and the volume stays.
  RadialProfile cap(6.0);
  double volume = 0, after = 0;
  for (int i = 0; i < RadialProfile::kCount; ++i)
    cap[i] = std::max(0.0, 1.0 - 0.125 * cap.radius_mm(i) * cap.radius_mm(i));
  for (const double sd : {0.1, 0.25}) {
    const RadialProfile blurred = cap.blurred(sd);
    for (const double r : {0.2, 0.6, 1.0})
      EXPECT_NEAR(blurred.at(r), cap.at(r) - 0.25 * sd * sd, 5e-4) << sd << ' ' << r;
    volume = after = 0;
    for (int i = 0; i < RadialProfile::kCount; ++i)
      volume += cap.radius_mm(i) * cap[i], after += cap.radius_mm(i) * blurred[i];
    EXPECT_NEAR(after, volume, 1e-4 * volume) << sd;
  }
}

TEST(SkinProfile, FollowsTheBallAndLeavesItWithoutACorner) {
  for (const double depth : {0.2, 0.6, 1.1})
    for (const double power : {0.0, 1.0}) {
      SkinForm form;
      form.lift_mm = 0.2;
      form.lift_power = power;
      const RadialProfile skin = skin_profile({4.0, 0.0, 1.5, depth}, form, 8.0);
      EXPECT_NEAR(skin.at(0.0), depth, 1e-3);
      EXPECT_NEAR(skin.at(0.5), depth - (4.0 - std::sqrt(16.0 - 0.25)), 2e-3);
      EXPECT_NEAR(skin.at(7.9), 0.0, 0.01);
      double steepest = 0, largest_bend = 0;
      for (int i = 2; i < RadialProfile::kCount; ++i) {
        EXPECT_LE(skin[i], skin[i - 1]);
        steepest = std::max(steepest, skin[i - 1] - skin[i]);
        largest_bend = std::max(largest_bend, std::abs(skin[i] - 2 * skin[i - 1] + skin[i - 2]));
      }
      EXPECT_LT(largest_bend, 0.45 * steepest) << depth << ' ' << power;
    }
}

TEST(SkinProfile, AnUnfadedHalfSpaceIsThatOfTheSimulation) {
  SkinForm form;
  form.bed = Bed::kHalfSpace;
  form.fade_mm = 1e6;
  const double depth = 0.5, radius = 4.0, edge = std::sqrt(radius * depth);
  const RadialProfile skin = skin_profile({radius, 0.0, 1.5, depth}, form, 10.0);
  const double at_edge = depth - (radius - std::sqrt(radius * radius - edge * edge));
  for (const double r : {1.6, 2.5, 4.0, 9.0})
    EXPECT_NEAR(skin.at(r), at_edge * 2.0 * hertz_tail(edge / r), 2e-3) << r;
}

TEST(SkinProfile, SwellingsRiseAndGrowWithTheDepth) {
  SkinForm form;
  form.lift_mm = 0.1;
  form.rise = {0.0, 0.05, 0.0};
  form.rise_power = 1.0;
  const auto highest = [&](double depth) {
    const RadialProfile skin = skin_profile({4.0, 0.0, 1.5, depth}, form, 10.0);
    double most = 0;
    for (int i = 0; i < RadialProfile::kCount; ++i) most = std::max(most, -skin[i]);
    return most;
  };
  EXPECT_NEAR(highest(1.0), 0.05, 0.003);
  EXPECT_NEAR(highest(0.5), 0.025, 0.003);
}

}  // namespace
}  // namespace alltact
