// What is inspected, in a scene: for the window, for films and for pictures alike.
#pragma once

#include "widgets/inspect/inspect_options.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/scene3d/face_scene.h"

#include <array>
#include <memory>
#include <optional>

namespace alltact {

/// The second finger beside the first: where both cameras sit in the gripper.
struct OtherInGripper {
  std::shared_ptr<const InspectedFrame> frame;
  std::array<RigidTransform, 2> places;
};

/// The frame has a surface, or a bare one; with kSecond or kDifference one to compare with, else it
/// is shown as kFirst.
void show_in(FaceScene& scene,
             const InspectedFrame& frame,
             PaneContent content,
             const std::optional<OtherInGripper>& other);

/// The points, and the way over the face between them.
[[nodiscard]] SceneMarks marks_of(const InspectedFrame& frame, const InspectOptions& options);

}  // namespace alltact
