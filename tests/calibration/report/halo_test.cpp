// Light that scatters sideways is seen beside the contacts, and usual skin is not taken for it:
// presses painted with and without a skirt around every dark place. Skin that leaves the ball at
// three quarters of its rim looks like light, and is not among them.
#include "calibration/report/press_errors.h"
#include "tests/support/made_press.h"

#include <cstdio>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace made;

constexpr double kMmPerPx = 0.05;

/// Round, exp(-r / w) / r as of diffusion in a slab, of sum 1.
cv::Mat skirt(double width_mm) {
  const int half = static_cast<int>(4 * width_mm / kMmPerPx);
  cv::Mat kernel(2 * half + 1, 2 * half + 1, CV_32FC1);
  for (int v = -half; v <= half; ++v)
    for (int u = -half; u <= half; ++u) {
      const double r = std::max(0.5, std::hypot(u, v)) * kMmPerPx;
      kernel.at<float>(v + half, u + half) = static_cast<float>(std::exp(-r / width_mm) / r);
    }
  return kernel / cv::sum(kernel)[0];
}

/// Presses of one ball; `share` of a pixel's darkness comes from around it.
std::vector<Press> presses(const Contact& contact, double share, double width_mm, unsigned seed) {
  std::mt19937 random(seed);
  const MadeScene scene = flat_scene(kMmPerPx);
  const double depths_mm[] = {0.45, 0.9, 0.6, 1.05, 0.75, 0.5};
  std::vector<Press> all;
  for (int i = 0; i < 6; ++i) {
    const Ball ball{110.0 + 36.0 * i, i % 2 == 0 ? 130.0 : 170.0, 4.0, depths_mm[i]};
    Press press = make_press(scene, {}, contact, {ball}, 1.0, random, fmt::format("p{}", i)).press;
    if (share > 0) {
      cv::Mat around;
      cv::filter2D(press.difference.x, around, -1, skirt(width_mm), {-1, -1}, 0,
                   cv::BORDER_CONSTANT);
      press.difference.x = (1 - share) * press.difference.x + share * around;
    }
    all.push_back(std::move(press));
  }
  return all;
}

Halo halo_of(const std::vector<Press>& presses) {
  const MadeScene scene = flat_scene(kMmPerPx);
  const auto found = calibrate(presses, scene.camera, scene.face, {}, Job{});
  EXPECT_TRUE(found.ok()) << (found ? "" : found.error().sentence());
  if (!found) return {};
  std::vector<const Press*> all;
  for (const Press& press : presses) all.push_back(&press);
  return measure_halo(all, scene.face, *found);
}

TEST(Halo, OfLocalLightIsNotSeenWhateverTheSkin) {
  const Contact contacts[] = {{Skin::kSharp, 0, 0},        {Skin::kSharp, 0, 0.03},
                              {Skin::kSmooth, 0.15, 0.02}, {Skin::kTail, 0.95, 0.03},
                              {Skin::kHertz, 0, 0},        {Skin::kHertz, 0, 0.03}};
  unsigned seed = 70;
  for (const Contact& contact : contacts) {
    const Halo halo = halo_of(presses(contact, 0, 1, ++seed));
    std::printf(
        "[ figures  ] skin %d bulge %.2f: near %.3f, far %.3f, beyond skin %.3f +- %.3f mm\n",
        static_cast<int>(contact.skin), contact.bulge_mm, halo.near_mm, halo.far_mm, halo.excess_mm,
        halo.excess_sd_mm);
    EXPECT_FALSE(halo.is_seen) << static_cast<int>(contact.skin) << " seed " << seed;
    EXPECT_GE(halo.presses, 4);
  }
}

TEST(Halo, OfScatteredLightIsSeen) {
  unsigned seed = 90;
  for (const double share : {0.4, 0.6, 0.75})
    for (const double width_mm : {0.6, 1.0, 1.5}) {
      const Halo halo = halo_of(presses({Skin::kTail, 0.85, 0}, share, width_mm, ++seed));
      std::printf(
          "[ figures  ] share %.1f width %.1f mm: near %.3f, far %.3f, beyond skin %.3f +- "
          "%.3f mm\n",
          share, width_mm, halo.near_mm, halo.far_mm, halo.excess_mm, halo.excess_sd_mm);
      EXPECT_TRUE(halo.is_seen) << share << " " << width_mm << " seed " << seed;
    }
}

}  // namespace
}  // namespace alltact
