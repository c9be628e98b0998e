// What the 3D view is asked to show, said without any of what shows it.
#pragma once

namespace alltact {

/// Where one looks from.
enum class Standpoint {
  kTilted = 1,  ///< from the camera's side, square to the face but for a tilt
  kCamera,      ///< as the camera sees the face
  kOutside,     ///< from where objects press, square to the face but for a tilt
  kSide,        ///< along y: the finger's profile
};

struct SceneOptions {
  bool body = true;                 ///< the finger behind its face, with its dots and its base
  bool ruler = true;                ///< mm along the face, and how large heights are drawn
  bool untouched = false;           ///< lines of the face as if nothing pressed
  bool camera = true;               ///< the camera and its axes
  double top_mm = 1.0;              ///< where the colours of depth end
  double difference_top_mm = 0.05;  ///< where those of differences end, to both sides
  double times = 1.0;               ///< that depth is drawn larger than it is
  bool operator==(const SceneOptions&) const = default;
};

}  // namespace alltact
