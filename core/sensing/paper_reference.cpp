#include "core/sensing/paper_reference.h"

#include "core/recording/video_file.h"
#include "core/sensing/markers/paper_rows.h"
#include "core/sensing/paper_face.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace alltact {

std::optional<Markers> paper_markers(const cv::Mat& grey,
                                     const FaceShape& shape,
                                     const MarkerRows& rows,
                                     const Markers* before) {
  const auto found = MarkerDetector(rows)(grey, shape);
  return paper_rows(found.dots, rows.per_row, shape.base_at_low_u(), before);
}

Result<PaperReference> PaperReference::read(const std::filesystem::path& video,
                                            const Finger& finger,
                                            const Camera& camera,
                                            const Job& job,
                                            std::size_t memory_limit_bytes) {
  auto file = VideoFile::open(video, job);
  if (!file) return file.error();
  const std::size_t count = file->frame_count();
  const std::size_t one = static_cast<std::size_t>(camera.size().area());
  const std::size_t step = 1 + one * (count - 1) / std::max(one, memory_limit_bytes);
  PaperReference reference;
  std::optional<Markers> before;
  for (std::size_t number = 0; number < count; number += step) {
    if (job.stop_requested())
      return Error{en::say("stopped while the recording was read"), video.string(), ""};
    job.report(static_cast<double>(number) / static_cast<double>(count),
               en::say("reading the recording as the source paper does"));
    const auto frame = file->frame(number);
    if (!frame) return frame.error();
    const auto grey = oriented_for(finger.camera,
                                   (*frame)->grey,
                                   en::say("the reference recording"),
                                   video.string(),
                                   en::say("recording it anew with this camera"));
    if (!grey) return grey.error();
    const auto face = PaperFace::fit(paper_edges(*grey), camera, finger.face);
    if (!face) continue;
    const auto shape = face->shape(camera, finger.face);
    if (!shape) continue;
    auto markers = paper_markers(*grey, *shape, finger.markers, before ? &*before : nullptr);
    if (!markers) continue;
    before = markers;
    reference.frames_.push_back({grey->clone(), std::move(*markers), static_cast<int>(number)});
  }
  if (reference.frames_.empty())
    return Error{
        en::say("the source paper's method finds face and markers in none of {} frames", count),
        video.string(),
        en::say("our own method, or a recording with brighter dots")};
  return reference;
}

PaperReference::Nearest PaperReference::nearest(const Markers& markers) const {
  Nearest best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const Markers& there = frames_[i].markers;
    assert(there.size() == markers.size());
    double sum = 0;
    for (std::size_t m = 0; m < markers.size(); ++m)
      sum += std::hypot(markers[m].u - there[m].u, markers[m].v - there[m].v);
    if (sum < best.distance_px) best = {i, sum};
  }
  best.distance_px /= static_cast<double>(std::max<std::size_t>(1, markers.size()));
  return best;
}

}  // namespace alltact
