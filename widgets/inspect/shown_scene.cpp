#include "widgets/inspect/shown_scene.h"

#include "core/sensing/measures.h"
#include "widgets/inspect/face_positions.h"

namespace alltact {

void show_in(FaceScene& scene,
             const InspectedFrame& frame,
             PaneContent content,
             const std::optional<OtherInGripper>& other) {
  const bool has_other = frame.other_surface.has_value();
  if (frame.bare)
    scene.show(*frame.bare, *frame.camera);
  else if (other)
    scene.show_in_gripper({*frame.surface, *frame.camera, other->poses[0]},
                          {*other->frame->surface, *other->frame->camera, other->poses[1]});
  else if (content == PaneContent::kDifference && has_other)
    scene.show_difference(*frame.surface, frame.other_depth_mm, *frame.camera);
  else if (content == PaneContent::kSecond && has_other)
    scene.show(*frame.other_surface, *frame.camera);
  else
    scene.show(*frame.surface, *frame.camera);
}

SceneMarks marks_of(const InspectedFrame& frame, const InspectOptions& options) {
  SceneMarks marks;
  const auto a = pixel_of(frame, options.a), b = pixel_of(frame, options.b);
  marks.points = {a, b};
  if (a && b && frame.surface)
    marks.lines.push_back(profile_between(frame.result, frame.face, {}, *a, *b).pixels);
  return marks;
}

}  // namespace alltact
