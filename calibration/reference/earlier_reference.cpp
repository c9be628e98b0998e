#include "calibration/reference/earlier_reference.h"

#include "calibration/reference/recorded_frames.h"

#include <vector>

namespace alltact {
namespace {

/// Rows spread evenly, at most `most`.
MarkerTable thinned(const MarkerTable& all, std::size_t most) {
  const std::size_t step = (all.frames.size() + most - 1) / most;
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < all.frames.size(); row += step) rows.push_back(row);
  return rows_of(all, rows);
}

}  // namespace

std::optional<EarlierReference> EarlierReference::open(const std::filesystem::path& folder,
                                                       const Finger& finger,
                                                       const NumberedRecording& recording,
                                                       const Job& job) {
  if (!finger.reference || finger.reference->video.empty() || finger.reference->positions ||
      recording.positions || finger.markers.missing != recording.missing)
    return std::nullopt;
  auto table = MarkerTable::load(folder / finger.reference->markers, finger.marker_count());
  if (!table || table->typical.size() != recording.typical.size() || table->frames.empty())
    return std::nullopt;
  auto video = VideoFile::open(folder / finger.reference->video, job);
  if (!video || static_cast<std::size_t>(table->frames.back()) >= video->frame_count())
    return std::nullopt;
  EarlierReference earlier(finger.camera, std::move(*video), thinned(*table, kMostFrames));
  // The first frame shows whether image size or orientation of the camera have changed.
  if (!earlier.frame(static_cast<std::size_t>(earlier.table_.frames.front()))) return std::nullopt;
  return earlier;
}

Result<cv::Mat> EarlierReference::frame(std::size_t number) {
  return oriented_frame(video_, number, camera_);
}

}  // namespace alltact
