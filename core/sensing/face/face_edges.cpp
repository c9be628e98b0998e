#include "core/sensing/face/face_edges.h"

#include "core/numerics/image_noise.h"
#include "core/sensing/face/edge_follower.h"
#include "core/sensing/face/edge_reader.h"
#include "core/sensing/face/rough_edges.h"

#include <algorithm>

namespace alltact {
namespace {

/// Invalidates samples beyond the ends of the face.
void invalidate_beyond(const FaceEnds& ends, double half_step, FaceEdges& edges) {
  for (Edge* edge : {&edges.upper, &edges.lower})
    for (std::size_t i = 0; i < edges.u.size(); ++i) {
      const double v = edge->v[i];
      const bool before = ends.first && edges.u[i] - half_step < ends.first->at(v);
      const bool after = ends.last && edges.u[i] + half_step > ends.last->at(v);
      if (before || after) edge->valid[i] = 0;
    }
}

}  // namespace

Result<FaceEdges> FaceEdgeFinder::operator()(const cv::Mat& grey) const {
  CV_Assert(grey.type() == CV_8UC1);
  FaceEdges edges;
  edges.noise_sd = image_noise_sd(grey);
  const Error lost{
      en::say("the two long edges of the face were not found"),
      en::say("the picture"),
      en::say("light the finger as in its recording, and check that the picture shows the face "
              "from base to tip with the finger's length along the picture's width")};
  const auto rough = find_rough_edges(grey, edges.noise_sd);
  if (!rough) return lost;
  edges.bright_inside = rough->bright_inside;

  const int step = std::max(options_.columns, 1);
  for (int u = 0; u + step <= grey.cols; u += step) edges.u.push_back(u + 0.5 * (step - 1));
  const float sign = rough->bright_inside ? 1.0F : -1.0F;
  const EdgeReader upper(grey, options_, edges.noise_sd, sign, true);
  const EdgeReader lower(grey, options_, edges.noise_sd, -sign, false);
  edges.upper = find_edge(upper, *rough, rough->upper, edges.u);
  edges.lower = find_edge(lower, *rough, rough->lower, edges.u);
  edges.ends = find_face_ends(grey, edges, options_.view ? &*options_.view : nullptr);
  invalidate_beyond(edges.ends, 0.25 * step, edges);

  std::size_t both = 0;
  for (std::size_t i = 0; i < edges.u.size(); ++i)
    both += edges.upper.valid[i] && edges.lower.valid[i];
  if (5 * both < edges.u.size()) return lost;
  return edges;
}

}  // namespace alltact
