// State of the page Inspect as one value that can be undone, saved and restored.
#pragma once

#include "calibration/live/frame_measurer.h"
#include "widgets/scene3d/face_scene.h"

#include <filesystem>
#include <optional>

namespace alltact {

enum class ShownAs { k3d = 1, kHeightMap };
enum class Comparison { kNone = 1, kSideBySide, kDifference };

/// Position on the face, mm: along it from its base and across it from its middle
/// (FaceShape::position_mm). It moves with the finger.
struct FacePosition {
  double along_mm = 0, across_mm = 0;
  bool operator==(const FacePosition&) const = default;
};

/// Another finger of the same gripper, with its own recording.
struct SecondFinger {
  std::filesystem::path finger, recording;
  bool operator==(const SecondFinger&) const = default;
};

struct InspectOptions {
  std::filesystem::path recording;     ///< a video or a folder of images; empty: the live finger
  std::optional<SecondFinger> second;  ///< only with a recording
  ShownAs shown_as = ShownAs::k3d;
  Comparison comparison = Comparison::kNone;
  ComparisonSpec with{OtherMethod::kPaper};  ///< what is compared with, if anything is
  Viewpoint viewpoint = Viewpoint::kTilted;
  std::optional<ViewPose> view_pose;  ///< 3D camera moved by hand; none: as from the standpoint
  SceneOptions scene;
  std::optional<FacePosition> a, b;  ///< the two measuring points

  /// With a second finger nothing is compared.
  [[nodiscard]] Comparison shown_comparison() const {
    return second ? Comparison::kNone : comparison;
  }
  [[nodiscard]] ComparisonSpec comparand() const {
    return shown_comparison() == Comparison::kNone ? ComparisonSpec() : with;
  }
  bool operator==(const InspectOptions&) const = default;
};

/// Which of a frame's measurements a pane shows.
enum class PaneContent { kFirst = 1, kSecond, kDifference };

}  // namespace alltact
