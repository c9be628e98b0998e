#include "calibration/reference/recording_problem.h"

#include "calibration/report/problem_picture.h"

#include <cmath>

#include <fmt/format.h>

namespace alltact {

cv::Mat recording_problem(const RecordingPass& pass,
                          const NumberedRecording& numbered,
                          std::size_t rest,
                          const std::string& finger_name,
                          const std::string& sentence) {
  std::size_t frame = pass.frames.size();
  const auto is_held = [&](std::size_t i) {
    return pass.in_video[i] >= 0 && !pass.greys[static_cast<std::size_t>(pass.in_video[i])].empty();
  };
  for (std::size_t i = 0; i < pass.frames.size(); ++i) {
    if (!is_held(i)) continue;
    const bool is_numbered = i < numbered.markers.size() && numbered.markers[i];
    if (frame == pass.frames.size() || (i == rest && is_numbered)) frame = i;
    if (pass.frames[frame].curves.u.empty() && !pass.frames[i].curves.u.empty()) frame = i;
  }
  if (frame == pass.frames.size()) return {};
  ProblemScene scene;
  scene.grey = pass.greys[static_cast<std::size_t>(pass.in_video[frame])];
  scene.edges = pass.frames[frame].curves;
  const bool by_dots =
      !numbered.places && frame < numbered.markers.size() && numbered.markers[frame];
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
  scene.words = {
      fmt::format("{} in its frame {} out of {}", finger_name, frame, pass.frames.size()),
      sentence};
  return problem_picture(scene);
}

}  // namespace alltact
