#include "core/sensing/markers/networks/network_dot_finder.h"

#include "core/sensing/markers/dot_measure.h"
#include "core/sensing/markers/marker_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {
namespace {

/// Measures the dot at a detection. Detections have an accuracy of about half an output cell, which
/// may miss a thin dot. Positions slightly above and below are tried too.
std::optional<Dot> measured(const cv::Mat& grey,
                            const SideEdges& edges,
                            const NetworkDot& seen,
                            double sign) {
  const int u = std::clamp(static_cast<int>(std::lround(seen.u)), 0, grey.cols - 1);
  DotSeed seed;
  seed.u = seen.u;
  seed.half_u = std::max(1.0, seen.half_u);
  seed.half_v = std::max(1.0, seen.half_v);
  seed.upper = seen.v < static_cast<double>(edges.middle(u));
  seed.sign = sign;
  for (const double offset : {0.0, -1.5, 1.5}) {
    seed.v = seen.v + offset;
    auto dot = measure_dot(grey, edges, seed);
    const double far = std::max(seen.half_u, seen.half_v) + 3.0;
    if (!dot || std::hypot(dot->u - seen.u, dot->v - seen.v) > far) continue;
    dot->score = seen.score;
    return dot;
  }
  return std::nullopt;
}

bool is_among(const std::vector<Dot>& dots, const Dot& dot) {
  return std::any_of(dots.begin(), dots.end(), [&](const Dot& other) {
    return std::hypot(other.u - dot.u, other.v - dot.v) < std::max(1.5, 0.8 * other.radius_px);
  });
}

}  // namespace

FoundDots NetworkDotFinder::operator()(const cv::Mat& grey, const FaceShape& shape) const {
  FoundDots found;
  found.polarity = rows_.polarity == Polarity::kAuto ? Polarity::kBright : rows_.polarity;
  if (grey.type() != CV_8UC1 || grey.cols != shape.width_px() || rows_.per_row <= 0) return found;
  const auto seen = (*network_)(grey);
  if (!seen) {
    found.problem = seen.error().message();
    return found;
  }
  const SideEdges edges(shape);
  const auto dots_as = [&](Polarity polarity) {
    std::vector<Dot> dots;
    for (const NetworkDot& candidate : *seen) {
      if (!(candidate.u >= 0 && candidate.v >= 0 && candidate.u <= grey.cols - 1 &&
            candidate.v <= grey.rows - 1))
        continue;
      const auto dot = measured(grey, edges, candidate, polarity == Polarity::kBright ? 1 : -1);
      if (dot && !is_among(dots, *dot)) dots.push_back(*dot);
    }
    return dots;
  };
  found.dots = dots_as(found.polarity);
  if (rows_.polarity == Polarity::kAuto) {
    auto dark = dots_as(Polarity::kDark);
    if (dark.size() > found.dots.size())
      found.dots = std::move(dark), found.polarity = Polarity::kDark;
  }
  locate_on_finger(found.dots, shape, edges);
  return found;
}

}  // namespace alltact
