// Markers (numbered) and dots (detected, not yet numbered).
#pragma once

#include <vector>

namespace alltact {

struct Marker {
  double u = 0, v = 0;  ///< px, oriented image; an estimate when not seen
  bool seen = false;
  double sd_px = 0;  ///< expected standard deviation of u and of v
};

/// 2n markers, indexed by number.
using Markers = std::vector<Marker>;

/// A dot detected in the image, not yet numbered.
struct Dot {
  double u = 0, v = 0;
  double radius_px = 0;  ///< of the disc with the same area
  double contrast = 0;   ///< grey levels relative to the surroundings; the sign is the polarity
  double sd_px = 0;
  bool upper = false;   ///< on the side face at small v
  double along_mm = 0;  ///< length of the face from its base to the dot's foot on it
  double face_px = 0;   ///< width of the face at the dot's distance from the camera
  double off_face = 0;  ///< distance from the face, as a fraction of its width
  double half_u_px = 0, half_v_px = 0;  ///< half extents at half height; 0: not known
  double score = 1;                     ///< confidence, 0 to 1; 1 from finders without scores
};

}  // namespace alltact
