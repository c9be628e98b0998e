// Options of the 3D view, without VTK.
#pragma once

namespace alltact {

/// Where the view is from.
enum class Viewpoint {
  kTilted = 1,  ///< from the camera's side, square to the face but for a tilt
  kCamera,      ///< as the camera sees the face
  kOutside,     ///< from where objects press, square to the face but for a tilt
  kSide,        ///< along y: the finger's profile
};

struct SceneOptions {
  bool body = true;                 ///< the finger behind its face, with its dots and its base
  bool ruler = true;                ///< mm along the face, and the exaggeration of heights
  bool untouched = false;           ///< lines of the undeformed face
  bool camera = true;               ///< the camera and its axes
  double top_mm = 1.0;              ///< end of the depth colour scale
  double difference_top_mm = 0.05;  ///< end of the difference colour scale, to both sides
  double exaggeration = 1.0;        ///< factor on drawn depth
  bool operator==(const SceneOptions&) const = default;
};

}  // namespace alltact
