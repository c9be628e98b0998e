#include "calibration/reference/earlier_reference.h"

#include "core/camera/camera.h"

#include <algorithm>

namespace alltact {
namespace {

/// Every so many rows that at most `most` are left.
MarkerTable thinned(const MarkerTable& all, std::size_t most) {
  const std::size_t step = (all.frames.size() + most - 1) / most;
  if (step <= 1) return all;
  MarkerTable some;
  some.typical = all.typical;
  some.layouts.resize(static_cast<Eigen::Index>((all.frames.size() + step - 1) / step),
                      all.layouts.cols());
  for (std::size_t i = 0; i < all.frames.size(); i += step) {
    some.layouts.row(std::ssize(some.frames)) = all.layouts.row(static_cast<Eigen::Index>(i));
    some.frames.push_back(all.frames[i]);
    some.seen.push_back(all.seen[i]);
  }
  return some;
}

}  // namespace

std::optional<EarlierReference> EarlierReference::open(const std::filesystem::path& folder,
                                                       const Finger& finger,
                                                       const NumberedRecording& recording,
                                                       const Job& job) {
  if (!finger.reference || finger.reference->video.empty() || finger.reference->places ||
      recording.places || finger.markers.missing != recording.missing)
    return std::nullopt;
  auto table = MarkerTable::load(folder / finger.reference->markers, finger.marker_count());
  if (!table || table->typical.size() != recording.typical.size() || table->frames.empty())
    return std::nullopt;
  auto video = VideoFile::open(folder / finger.reference->video, job);
  if (!video || static_cast<std::size_t>(table->frames.back()) >= video->frame_count())
    return std::nullopt;
  EarlierReference earlier(finger.camera, std::move(*video), thinned(*table, kMostFrames));
  // A camera whose picture has another size or turn since: the first frame tells.
  if (!earlier.frame(static_cast<std::size_t>(earlier.table_.frames.front()))) return std::nullopt;
  return earlier;
}

Result<cv::Mat> EarlierReference::frame(std::size_t number) {
  const auto read = video_.frame(number);
  if (!read) return read.error();
  return oriented_for(camera_, (*read)->grey, en::say("the recording's picture"), "", "");
}

}  // namespace alltact
