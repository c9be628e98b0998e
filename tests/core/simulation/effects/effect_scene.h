// Scenes in which an effect shows by itself, and seeded parameters for it.
#pragma once

#include "core/numerics/philox.h"
#include "tests/core/simulation/scene_text.h"

#include <cmath>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {

inline const std::string kFaceAndLamps =
    "  - {use: layer, scatter_per_mm: 0.6, along: z}\n"
    "  - {use: leds, lamps: [{at_mm: [1, -3, -2], power: 300000}, {at_mm: [9, 4, 0], power: "
    "200000}]}\n";

/// A flat face 30 mm before a camera, the whole picture; without effects its light is 1. Pixel
/// (u, v) sees ((u - 158.5) / 170, (v - 90.25) / 172, 1) * 30 mm.
inline std::string flat_text(const std::string& effects, const std::string& camera = "") {
  return "name: test\nwhy: a flat face to test with\nfinger:\n  camera: {" +
         (camera.empty()
              ? "model: pinhole, size: [320, 180], fx: 170, fy: 172, cx: 158.5, cy: 90.25"
              : camera) +
         "}\n  face: {kind: flat, layer_mm: 1.5, plane_z_mm: 30}\nframes: 100\n" +
         (effects.empty() ? "effects: []\n" : "effects:\n" + effects);
}
inline Eigen::Vector3d flat_point(int u, int v) {
  return {(u - 158.5) / 170 * 30, (v - 90.25) / 172 * 30, 30};
}
/// One million pixels of light 1.
inline std::string million_text(const std::string& effects) {
  return flat_text(effects,
                   "model: orthographic, size: [1000, 1000], mm_per_px: 0.01, cx: 500, cy: 500");
}

/// What plan_of(text, seed) hands to its effects as their seed.
inline std::uint64_t effect_seed(std::uint64_t seed = 7) {
  return seed ^ std::uint64_t{fnv1a("test")} << 32;
}

inline cv::Mat_<float> rendered(const std::string& text, int frame = 0) {
  return plan_of(text).render(frame);
}

/// How bright frame `frame` is, as a share of a scene without the effect.
inline double share_in(const std::string& effect, int frame, double frames_per_s) {
  const std::string rate = fmt::format("frames_per_s: {}\n", frames_per_s);
  const cv::Mat_<float> plain = rendered(rate + flat_text(kFaceAndLamps), frame);
  const cv::Mat_<float> lit = rendered(rate + flat_text(kFaceAndLamps + effect), frame);
  return double{lit(90, 160)} / plain(90, 160);
}

/// Share of the pixel within `radius` of the line from a to b, of the flat face.
inline double part_of(double mm_per_px, int u, int v, Eigen::Vector2d a, Eigen::Vector2d b,
                      double radius) {
  const Eigen::Vector2d p = flat_point(u, v).head<2>();
  double nearest = std::min((p - a).norm(), (p - b).norm());
  const double length = (b - a).norm();
  if (length > 0) {
    const Eigen::Vector2d way = (b - a) / length;
    const double along = (p - a).dot(way);
    if (along > 0 && along < length)
      nearest = std::abs((p - a).x() * way.y() - (p - a).y() * way.x());
  }
  return std::clamp((radius - nearest) / mm_per_px + 0.5, 0.0, 1.0);
}

class Parameters {
 public:
  explicit Parameters(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) + 0.5) / 4294967296.0;
  }

 private:
  std::mt19937 random_;
};

struct Moments {
  double sum = 0, sum2 = 0;
  long n = 0;
  void add(double x) {
    sum += x;
    sum2 += x * x;
    ++n;
  }
  [[nodiscard]] double mean() const { return sum / static_cast<double>(n); }
  [[nodiscard]] double variance() const { return sum2 / static_cast<double>(n) - mean() * mean(); }
};

/// That these are draws of a normal law of this mean and standard deviation.
inline void expect_normal(const Moments& draws, double mean, double sd) {
  const auto n = static_cast<double>(draws.n);
  EXPECT_GE(draws.n, 999000);
  EXPECT_NEAR(draws.mean(), mean, 4.5 * sd / std::sqrt(n));
  EXPECT_NEAR(draws.variance(), sd * sd, 4.5 * sd * sd * std::sqrt(2 / n));
}

/// Calls check(v, u) for every so manieth pixel.
template <class Check>
void for_pixels(cv::Size size, int step, const Check& check) {
  for (int v = 0; v < size.height; v += step)
    for (int u = 0; u < size.width; u += step) check(v, u);
}

}  // namespace alltact
