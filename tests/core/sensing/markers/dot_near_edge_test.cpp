// Dots of all sizes and contrasts beside the bright face, in pictures drawn by hand.
#include "core/sensing/markers/marker_detector.h"
#include "core/sensing/markers/markers.h"
#include "tests/support/marked_finger.h"

#include <cstdio>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::Bend;
using test::MarkedFinger;
using test::random_bend;

struct Tried {
  int dots = 0, found = 0;
  double square = 0, worst = 0;
  [[nodiscard]] double rms_px() const { return std::sqrt(square / std::max(1, found)); }
};

/// Six dots a side whose rims lie `gap_px` from the face's edge.
std::vector<MarkedFinger::Extra> dots_beside(const MarkedFinger& finger, const Bend& bend,
                                             double radius_px, double gap_px, double contrast,
                                             std::mt19937& random) {
  std::uniform_real_distribution<double> shift(-8.0, 8.0);
  std::vector<MarkedFinger::Extra> dots;
  for (const double side : {-1.0, 1.0}) {
    auto edge = finger.edge(bend, side, 0);
    std::vector<double> there;
    for (std::size_t u = 0; u < edge.size(); ++u)
      if (std::isfinite(edge[u])) there.push_back(static_cast<double>(u));
    for (int i = 0; i < 6; ++i) {
      const double u =
          there.front() + (0.1 + 0.15 * i) * (there.back() - there.front()) + shift(random);
      const auto column = static_cast<std::size_t>(u);
      const double t = u - static_cast<double>(column);
      const double at = (1 - t) * edge[column] + t * edge[column + 1];
      const double slope = edge[column + 3] - edge[column - 3];
      // The edge is sloped, so the rim is nearest off the dot's own column.
      const double off = (radius_px + gap_px) * std::hypot(1.0, slope / 6.0);
      dots.push_back({{u, at + side * off, radius_px, radius_px},
                      finger.side_level * (1.2 - 0.4 * u / finger.width) + contrast});
    }
  }
  return dots;
}

Tried try_dots(double radius_px, double gap_px, double contrast, double noise) {
  MarkedFinger finger;
  finger.noise = noise;
  if (contrast < 0) finger.side_level = 80;
  std::mt19937 random(static_cast<unsigned>(100 * radius_px + 10 * gap_px + std::abs(contrast)));
  std::vector<int> every;
  for (int m = 0; m < 2 * finger.per_row; ++m) every.push_back(m);
  Tried tried;
  for (int i = 0; i < 6; ++i) {
    const Bend bend = random_bend(random);
    const auto truth = dots_beside(finger, bend, radius_px, gap_px, contrast, random);
    const cv::Mat grey = finger.with_noise(finger.clean(bend, every, truth), random);
    const MarkerDetector detector(
        {finger.per_row, contrast > 0 ? Polarity::kBright : Polarity::kDark});
    const auto found = detector(grey, finger.shape(bend));
    for (const auto& dot : truth) {
      double nearest = 1e9;
      for (const Dot& seen : found.dots)
        nearest = std::min(nearest, std::hypot(seen.u - dot.disc.u, seen.v - dot.disc.v));
      ++tried.dots;
      if (nearest > 1.0) continue;
      ++tried.found;
      tried.square += nearest * nearest;
      tried.worst = std::max(tried.worst, nearest);
    }
  }
  return tried;
}

TEST(MarkerDetector, FindsDotsOfAnySizeOnePixelAndAHalfOffTheFace) {
  for (const double contrast : {170.0, 60.0, 25.0, -40.0})
    for (const double radius_px : {1.5, 2.5, 5.5, 8.0})
      for (const double gap_px : {1.5, 2.5, 4.5, 8.0}) {
        const Tried tried = try_dots(radius_px, gap_px, contrast, 1.0);
        std::printf(
            "[ figures  ] contrast %4.0f, %4.1f px wide, rim %.1f px off: %d of %d, rms "
            "%.3f, worst %.2f px\n",
            contrast, 2 * radius_px, gap_px, tried.found, tried.dots, tried.rms_px(), tried.worst);
        EXPECT_GE(tried.found, tried.dots - tried.dots / 24);
        // Nine pixels of a faint dot in noise of one grey level tell no more.
        EXPECT_LT(tried.rms_px(), radius_px < 2 && std::abs(contrast) < 30 ? 0.25 : 0.1);
      }
}

TEST(MarkerDetector, FindsFaintDotsInNoise) {
  const Tried tried = try_dots(4.0, 6.0, 12.0, 2.0);
  std::printf("[ figures  ] faint: %d of %d, rms %.3f px\n", tried.found, tried.dots,
              tried.rms_px());
  EXPECT_GE(tried.found, tried.dots - tried.dots / 20);
  EXPECT_LT(tried.rms_px(), 0.3);
}

}  // namespace
}  // namespace alltact
