// What a ball and the effects that change its press make of a flat face, along its radius.
#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

constexpr double kProfilePx = 0.04;  // mm

/// Depth at the distances i * kProfilePx from a ball's axis.
std::vector<double> pressed_profile(double radius, double depth, const std::string& more) {
  const Plan plan = plan_of(
      flat_text(fmt::format("  - {{use: ball, radius_mm: {}, s_mm: 0, y_mm: 0, depth_mm: {}}}\n",
                            radius, depth) +
                    more,
                "model: orthographic, size: [400, 40], mm_per_px: 0.04, cx: 20, cy: 20"));
  const cv::Mat_<float> got = plan.truth(0).depth_mm;
  std::vector<double> profile;
  for (int u = 20; u < 400; ++u) profile.push_back(got(20, u));
  return profile;
}

double ball_at(double radius, double depth, double r) {
  return depth - radius + std::sqrt(std::max(0.0, radius * radius - r * r));
}

TEST(Rolloff, FallsOffLikeHertzAndFades) {
  Parameters random(33);
  for (int i = 0; i < 8; ++i) {
    const double radius = random.between(1.5, 9), depth = random.between(0.2, 1.2);
    const double fade = i % 2 == 0 ? 0 : random.between(0.2, 5);
    const auto got = pressed_profile(
        radius, depth,
        fade > 0 ? fmt::format("  - {{use: rolloff, kind: hertz, length_mm: {}}}\n", fade)
                 : "  - {use: rolloff, kind: hertz}\n");
    const double a = std::sqrt(radius * depth), at_rim = ball_at(radius, depth, a);
    for (std::size_t k = 0; k < got.size(); ++k) {
      const double r = static_cast<double>(k) * kProfilePx, q = r / a;
      double expected = ball_at(radius, depth, std::min(r, a));
      if (q > 1)
        expected = at_rim * 2 / M_PI * ((2 - q * q) * std::asin(1 / q) + std::sqrt(q * q - 1)) *
                   (fade > 0 ? std::exp(-(r - a) / fade) : 1);
      // The profile is tabulated; just outside the rim it bends like a root.
      const double bound = q > 1 && r < a + 0.05 ? 4e-4 : 2e-5;
      EXPECT_NEAR(got[k], expected, bound) << "R " << radius << " d " << depth << " r " << r;
    }
  }
}

TEST(Rolloff, SmoothsByAGaussian) {
  Parameters random(34);
  for (int i = 0; i < 3; ++i) {
    const double radius = random.between(2, 6), depth = random.between(0.4, 1.2);
    const double sd = random.between(0.1, 0.5), rim = std::sqrt(depth * (2 * radius - depth));
    const auto got = pressed_profile(
        radius, depth, fmt::format("  - {{use: rolloff, kind: smooth, length_mm: {}}}\n", sd));
    for (std::size_t k = 0; k < 120; k += 7) {
      const double r = static_cast<double>(k) * kProfilePx;
      double sum = 0, weights = 0;
      for (double dx = -5; dx <= 5; dx += 0.04)
        for (double dy = -5; dy <= 5; dy += 0.04) {
          const double weight = std::exp(-0.5 * (dx * dx + dy * dy));
          const double from_axis = std::hypot(r + dx * sd, dy * sd);
          weights += weight;
          if (from_axis < rim) sum += weight * ball_at(radius, depth, from_axis);
        }
      EXPECT_NEAR(got[k], sum / weights, 2e-3 * depth) << "R " << radius << " sd " << sd;
    }
  }
}

TEST(Bulge, IsARingBeyondTheRim) {
  Parameters random(35);
  for (int i = 0; i < 6; ++i) {
    const double radius = random.between(1.5, 8), depth = random.between(0.2, 1.2);
    const double share = random.between(0.01, 0.3), width = random.between(0.3, 3);
    const bool hertz = i % 2 == 0;
    const std::string rolloff = "  - {use: rolloff, kind: hertz, length_mm: 0.6}\n";
    const auto plain = pressed_profile(radius, depth, hertz ? rolloff : "");
    const auto got = pressed_profile(
        radius, depth,
        (hertz ? rolloff : "") +
            fmt::format("  - {{use: bulge, share: {}, width_mm: {}}}\n", share, width));
    const double rim = hertz ? std::sqrt(radius * depth) : std::sqrt(depth * (2 * radius - depth));
    for (std::size_t k = 0; k < got.size(); ++k) {
      const double r = static_cast<double>(k) * kProfilePx, q = (r - rim) / width;
      const double ring = q > 0 ? q * q * std::exp(1 - q * q) : 0;
      if (std::abs(r - rim) < 0.02) continue;  // between two entries of the profile's table
      EXPECT_NEAR(got[k], plain[k] - share * 1.5 * ring, 2e-5 + 1e-4 * share) << r - rim;
    }
  }
}

// A T of two bars, turned and put anywhere: in by its depth or not at all.
TEST(Relief, OfATIsTwoBars) {
  Parameters random(36);
  for (int i = 0; i < 6; ++i) {
    const double size = random.between(3, 9), bar = size * random.between(0.15, 0.4);
    const double s = random.between(-2, 2), y = random.between(-1, 1);
    const double depth = random.between(0.2, 1.2), turned = random.between(-180, 180);
    const cv::Mat_<float> got =
        plan_of(flat_text(fmt::format("  - {{use: relief, shape: t_bar, size_mm: {}, bar_mm: {}, "
                                      "s_mm: {}, y_mm: {}, depth_mm: {}, rotation_deg: {}}}\n",
                                      size, bar, s, y, depth, turned),
                          "model: orthographic, size: [400, 400], mm_per_px: 0.04, cx: 200, "
                          "cy: 200"))
            .truth(0)
            .depth_mm;
    const double cos = std::cos(turned * M_PI / 180), sin = std::sin(turned * M_PI / 180);
    int in = 0;
    for_pixels(got.size(), 2, [&](int v, int u) {
      const double dx = (u - 200) * 0.04 - s, dy = (v - 200) * 0.04 - y;
      const double along = cos * dx + sin * dy, across = cos * dy - sin * dx, half = size / 2;
      // How far inside the bars: their own walls and ends.
      const double cross =
          std::min(std::min(along - (half - bar), half - along), half - std::abs(across));
      const double stem = std::min(bar / 2 - std::abs(across), half - std::abs(along));
      const double inside = std::max(cross, stem);
      if (std::abs(inside) < 0.15) return;  // a wall goes over a step of the relief's grid
      EXPECT_NEAR(got(v, u), inside > 0 ? depth : 0, 1e-6) << along << ' ' << across;
      in += inside > 0;
    });
    EXPECT_GT(in, 100);
  }
}

}  // namespace
}  // namespace alltact
