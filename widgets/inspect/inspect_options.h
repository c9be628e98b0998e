// What the place Inspect shows, as one value that can be undone, kept and put back.
#pragma once

#include "widgets/inspect/inspection.h"
#include "widgets/scene3d/face_scene.h"

#include <filesystem>
#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

enum class ShownAs { k3d = 1, kHeightMap };
enum class Comparison { kNone = 1, kSideBySide, kDifference };

/// Another finger of the same gripper, with its own recording.
struct SecondFinger {
  std::filesystem::path finger, recording;
  bool operator==(const SecondFinger&) const = default;
};

struct InspectOptions {
  std::filesystem::path recording;     ///< a video or a folder of pictures; empty: the live finger
  std::optional<SecondFinger> second;  ///< beside a recording only
  ShownAs shown_as = ShownAs::k3d;
  Comparison comparison = Comparison::kNone;
  Standpoint standpoint = Standpoint::kTilted;
  std::optional<Look> look;  ///< turned or moved by hand; none: as from the standpoint
  SceneOptions scene;
  std::optional<cv::Point2d> a, b;  ///< pixels of the two points one measures with

  /// Beside a second finger nothing is compared.
  [[nodiscard]] Comparison shown_comparison() const {
    return second ? Comparison::kNone : comparison;
  }
  bool operator==(const InspectOptions&) const = default;
};

/// Which of a frame's measurements a pane shows.
enum class PaneContent { kFirst = 1, kSecond, kDifference };

}  // namespace alltact
