// Edges of a face that darkens towards them.
//
// Light that scatters in the layer leaves through its side faces, or is absorbed there: within
// about half a layer thickness of its edge the face loses up to half of its brightness. The
// crossing of the mean of both sides' levels (edge_tracing.h) then lies up to half a pixel inside
// the edge, and the face seems narrower, and so further away. Across such an edge brightness is a
// blurred step with a face behind it that recovers exponentially:
//   outside + step Phi((r - r0) / sd) + recovery (1 - exp(-(r - r0) / length)) blurred alike
// with r the distance from the crossing inwards. In layers walked by single paths of light (optical
// thickness 0.8 to 2.8, paint absorbing 1 to 4 %) its r0 lies within 0.01 mm of the edge, mostly.
#pragma once

#include "core/sensing/face/face_edges.h"

#include <array>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Brightness across an edge, at distances kFirst, kFirst + 1, .. from its crossing inwards, px.
struct AcrossEdge {
  static constexpr int kFirst = -6, kCount = 21;
  std::array<double, kCount> brightness{};  ///< grey levels
};

/// -r0 above: how far the crossing lies inside the edge, px. nullopt: the profile is not of that
/// form, or the face hardly darkens.
[[nodiscard]] std::optional<double> fit_darkened_edge(const AcrossEdge& profile);

/// Moves the valid samples of one edge from crossings to the edge, where the face darkens.
/// `is_upper`: the face is at larger v. Uses medians over eighths of the edge, so that dots and one
/// contact at the edge have no effect.
void move_to_darkened_edge(const cv::Mat& grey, const std::vector<double>& u, bool is_upper,
                           Edge* edge);

}  // namespace alltact
