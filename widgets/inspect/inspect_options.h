// What the place Inspect shows, as one value that can be undone, kept and put back.
#pragma once

#include "calibration/live/frame_measurer.h"
#include "widgets/scene3d/face_scene.h"

#include <filesystem>
#include <optional>

namespace alltact {

enum class ShownAs { k3d = 1, kHeightMap };
enum class Comparison { kNone = 1, kSideBySide, kDifference };

/// Along the face from its base and across it from its middle, mm (FaceShape::place_mm): it stays
/// where it is on the finger while that moves.
struct FacePlace {
  double along_mm = 0, across_mm = 0;
  bool operator==(const FacePlace&) const = default;
};

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
  Comparand with{OtherMethod::kPaper};  ///< what is compared with, where anything is
  Standpoint standpoint = Standpoint::kTilted;
  std::optional<Look> look;  ///< turned or moved by hand; none: as from the standpoint
  SceneOptions scene;
  std::optional<FacePlace> a, b;  ///< the two points one measures with

  /// Beside a second finger nothing is compared.
  [[nodiscard]] Comparison shown_comparison() const {
    return second ? Comparison::kNone : comparison;
  }
  [[nodiscard]] Comparand comparand() const {
    return shown_comparison() == Comparison::kNone ? Comparand() : with;
  }
  bool operator==(const InspectOptions&) const = default;
};

/// Which of a frame's measurements a pane shows.
enum class PaneContent { kFirst = 1, kSecond, kDifference };

}  // namespace alltact
