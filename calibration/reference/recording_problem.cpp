#include "calibration/reference/recording_problem.h"

#include "calibration/report/problem_image.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_shape.h"

#include <cmath>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kTouchRadiusMm = 3.0;  // of the circle that is drawn

bool is_cached(const RecordingPass& pass, std::size_t frame) {
  return pass.in_video[frame] >= 0 &&
         !pass.greys[static_cast<std::size_t>(pass.in_video[frame])].empty();
}

/// nullptr: no contact, or its frame is not cached.
const ReferenceStretch* darkest_stretch(const RecordingPass& pass, const ReferenceReport& report) {
  const ReferenceStretch* darkest = nullptr;
  for (const ReferenceStretch& stretch : report.stretches)
    if ((!darkest || stretch.darker > darkest->darker) &&
        is_cached(pass, static_cast<std::size_t>(stretch.darkest)))
      darkest = &stretch;
  return darkest;
}

/// One of the cached frames; their number where there is none.
std::size_t frame_to_show(const RecordingPass& pass, const MadeReference& made) {
  const std::size_t count = pass.frames.size();
  std::size_t frame = count;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_cached(pass, i)) continue;
    const bool is_numbered = i < made.numbered.markers.size() && made.numbered.markers[i];
    if (frame == count || (i == made.rest && is_numbered)) frame = i;
    if (pass.frames[frame].curves.u.empty() && !pass.frames[i].curves.u.empty()) frame = i;
  }
  return frame;
}

/// The contact's position; nullopt where the face is not found.
std::optional<ProblemMark> mark_of(const ReferenceStretch& stretch,
                                   const cv::Mat& grey,
                                   const Camera& camera,
                                   const Face& face) {
  const auto edges = FaceEdgeFinder({.view = FaceView{camera, face.width_mm}})(grey);
  if (!edges) return std::nullopt;
  constexpr int kDegree = 7;
  const auto shape = FaceShape::fit(*edges, camera, face, kDegree);
  if (!shape) return std::nullopt;
  for (int u = 0; u < shape->width_px(); ++u) {
    const FaceColumn& column = shape->columns()[static_cast<std::size_t>(u)];
    if (!column.valid || shape->length_at(u) < stretch.along_mm) continue;
    const double part = stretch.across_mm / face.width_mm;  // -0.5 at the upper edge
    return ProblemMark{ProblemMark::Kind::kDarker,
                       static_cast<double>(u),
                       std::lerp(column.upper_v, column.lower_v, 0.5 + part),
                       kTouchRadiusMm / camera.mm_per_px_at(column.z_mm),
                       -1};
  }
  return std::nullopt;
}

void add_dots(const RecordingPass& pass,
              const NumberedRecording& numbered,
              std::size_t frame,
              ProblemScene& scene) {
  const bool by_dots =
      !numbered.positions && frame < numbered.markers.size() && numbered.markers[frame];
  if (by_dots)
    for (std::size_t m = 0; m < numbered.markers[frame]->size(); ++m) {
      const Marker& marker = (*numbered.markers[frame])[m];
      scene.marks.push_back({marker.seen ? ProblemMark::Kind::kUsed : ProblemMark::Kind::kExpected,
                             marker.u,
                             marker.v,
                             numbered.typical[m].radius_px,
                             static_cast<int>(m)});
    }
  const bool is_dark = numbered.polarity == Polarity::kDark;
  for (const Dot& dot : is_dark ? pass.frames[frame].dark : pass.frames[frame].bright)
    if (std::none_of(scene.marks.begin(), scene.marks.end(), [&](const ProblemMark& mark) {
          return std::hypot(mark.u - dot.u, mark.v - dot.v) < 1.0;
        }))
      scene.marks.push_back({ProblemMark::Kind::kRefused, dot.u, dot.v, dot.radius_px, -1});
}

}  // namespace

cv::Mat recording_problem(const RecordingPass& pass,
                          const MadeReference& made,
                          const Camera& camera,
                          const Finger& finger,
                          const std::string& sentence) {
  const ReferenceStretch* touch = darkest_stretch(pass, made.report);
  const std::size_t frame =
      touch ? static_cast<std::size_t>(touch->darkest) : frame_to_show(pass, made);
  if (frame == pass.frames.size()) return {};
  ProblemScene scene;
  scene.grey = pass.greys[static_cast<std::size_t>(pass.in_video[frame])];
  scene.edges = pass.frames[frame].curves;
  add_dots(pass, made.numbered, frame, scene);
  scene.words = {
      fmt::format("{} in its frame {} out of {}", finger.name, frame, pass.frames.size()),
      sentence};
  if (touch) {
    if (const auto mark = mark_of(*touch, scene.grey, camera, finger.face))
      scene.marks.push_back(*mark);
    scene.words.push_back(touch->sentence.english());
  }
  return problem_image(scene);
}

}  // namespace alltact
