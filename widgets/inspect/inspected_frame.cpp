#include "widgets/inspect/inspected_frame.h"

#include "core/sensing/face/face_shape.h"
#include "core/sensing/surface_measurement.h"

#include <algorithm>
#include <cmath>

namespace alltact {

FrameSummary summary_of(const MeasuredFrame& frame) {
  const FrameResult& result = frame.result;
  FrameSummary summary;
  summary.number = frame.number;
  if (result.depth) {
    summary.deepest_mm = summary.area_mm2 = 0.0;
    for (const ContactRegion& region : result.regions) {
      *summary.deepest_mm = std::max(*summary.deepest_mm, region.deepest_mm);
      *summary.area_mm2 += region.area_mm2;
    }
  }
  if (result.force) summary.force_N = result.force->force_N.norm();
  summary.has_contact = result.contact.has_value();
  if (!result.problems.empty()) summary.problem = result.problems.front();
  return summary;
}

std::optional<cv::Point2d> pixel_of(const InspectedFrame& frame,
                                    const std::optional<FacePosition>& position) {
  return position ? pixel_of(frame.result, *position) : std::nullopt;
}

std::optional<FacePosition> position_of(const InspectedFrame& frame, cv::Point2d pixel) {
  if (!frame.result.shape) return std::nullopt;
  const Eigen::Vector2d position_mm = frame.result.shape->position_mm(pixel.x, pixel.y);
  return FacePosition{position_mm.x(), position_mm.y()};
}

std::optional<Profile> other_profile(const InspectedFrame& frame, const FacePosition& a,
                                     const FacePosition& b) {
  if (!frame.other || !frame.other->shape || !frame.other->depth) return std::nullopt;
  const auto from = pixel_of_position(*frame.other->shape, {a.along_mm, a.across_mm});
  const auto to = pixel_of_position(*frame.other->shape, {b.along_mm, b.across_mm});
  if (!from || !to) return std::nullopt;
  return profile_between(*frame.other, frame.face, {}, {from->x(), from->y()}, {to->x(), to->y()});
}

MatchedFrame matched_frame(std::size_t number, const RecordingInfo& first,
                           const RecordingInfo& second) {
  static const FrameTimes kNone;
  return match_frame(number, first.times_ns ? *first.times_ns : kNone,
                     second.times_ns ? *second.times_ns : kNone, second.count);
}

bool FramePair::has_face() const {
  const auto is_shown = [](const auto& frame) { return frame && (frame->surface || frame->bare); };
  if (!poses) return is_shown(first) && (!second || is_shown(second));
  return first && second && first->surface && second->surface;
}

void show_in(FaceScene& scene, const FramePair& frames, PaneContent content) {
  scene.set_gap(frames.is_joint() ? frames.gap : std::nullopt);
  const InspectedFrame& frame = *frames.first;
  const bool has_other = frame.other_surface.has_value();
  if (frame.bare)
    scene.show(*frame.bare, *frame.camera);
  else if (frames.is_joint())
    scene.show_in_gripper({*frame.surface, *frame.camera, (*frames.poses)[0]},
                          {*frames.second->surface, *frames.second->camera, (*frames.poses)[1]});
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
