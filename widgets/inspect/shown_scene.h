// Fills a 3D scene with the inspected faces, for the window, films and images.
#pragma once

#include "widgets/inspect/inspect_options.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/scene3d/face_scene.h"

#include <array>
#include <memory>
#include <optional>

namespace alltact {

/// A second finger in the same scene; gripper_from_camera of both cameras.
struct OtherInGripper {
  std::shared_ptr<const InspectedFrame> frame;
  std::array<RigidTransform, 2> poses;
};

/// The frame has a surface, or a bare one. Without a compared surface, kSecond and kDifference are
/// shown as kFirst.
void show_in(FaceScene& scene,
             const InspectedFrame& frame,
             PaneContent content,
             const std::optional<OtherInGripper>& other);

/// The points, and the path over the face between them.
[[nodiscard]] SceneMarks marks_of(const InspectedFrame& frame, const InspectOptions& options);

}  // namespace alltact
