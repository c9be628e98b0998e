// The edges of a face that is a plane, as a pinhole camera sees them, with noise.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <cmath>
#include <random>

namespace alltact::test {

inline Face plane_face() {
  Face face;
  face.width_mm = 24.0;
  face.layer_mm = 1.5;
  return face;
}

/// z = 55 mm + slope X: in column x = X / z the distance is 55 / (1 - slope x), and the face's half
/// width 12 fy / z pixels.
inline FaceEdges plane_edges(double slope, const Camera& camera, double noise_px, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const CameraParameters& lens = camera.parameters();
  FaceEdges edges;
  for (double u = 3.5; u < camera.size().width; u += 8.0) {
    const double x = (u - lens.cx_px) / lens.fx_px;
    const double z = 55.0 / (1.0 - slope * x);
    const double half = 0.5 * plane_face().width_mm * lens.fy_px / z;
    edges.u.push_back(u);
    for (Edge* edge : {&edges.upper, &edges.lower}) {
      const double v = lens.cy_px + (edge == &edges.upper ? -half : half);
      edge->v.push_back(v + noise_px * normal(random));
      edge->sd.push_back(std::max(noise_px, 0.02));
      edge->valid.push_back(z > 0 && v > 1.0 && v < camera.size().height - 2.0);
    }
  }
  return edges;
}

}  // namespace alltact::test
