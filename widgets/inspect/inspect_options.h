// What the place Inspect shows, as one value that can be undone and put back.
#pragma once

#include "widgets/inspect/inspection.h"
#include "widgets/scene3d/face_scene.h"

#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

enum class ShownAs { k3d = 1, kHeightMap };
enum class Comparison { kNone = 1, kSideBySide, kDifference };

struct InspectOptions {
  ShownAs shown_as = ShownAs::k3d;
  Comparison comparison = Comparison::kNone;
  Standpoint standpoint = Standpoint::kTilted;
  SceneOptions scene;
  std::optional<cv::Point2d> a, b;  ///< pixels of the two points one measures with
  bool operator==(const InspectOptions&) const = default;
};

/// Which of a frame's measurements a pane shows.
enum class PaneContent { kFirst = 1, kSecond, kDifference };

}  // namespace alltact
