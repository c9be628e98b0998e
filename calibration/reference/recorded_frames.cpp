#include "calibration/reference/recorded_frames.h"

namespace alltact {

MarkerTable table_of(const NumberedRecording& numbered, const std::vector<std::size_t>& selected) {
  MarkerTable table;
  const auto count = numbered.typical.size();
  table.typical = numbered.typical;
  table.layouts.resize(static_cast<Eigen::Index>(selected.size()),
                       static_cast<Eigen::Index>(2 * count));
  for (std::size_t i = 0; i < selected.size(); ++i) {
    const Markers& markers = *numbered.markers[selected[i]];
    table.frames.push_back(static_cast<int>(i));
    table.seen.emplace_back(count, 0);
    for (std::size_t m = 0; m < count; ++m) {
      table.layouts.row(static_cast<Eigen::Index>(i)).segment<2>(static_cast<Eigen::Index>(2 * m))
          << markers[m].u,
          markers[m].v;
      table.seen.back()[m] = static_cast<char>(markers[m].seen);
    }
  }
  return table;
}

MarkerTable table_in_video(const RecordingPass& pass,
                           const NumberedRecording& numbered,
                           const std::vector<std::size_t>& selected) {
  MarkerTable table = table_of(numbered, selected);
  for (std::size_t i = 0; i < selected.size(); ++i) table.frames[i] = pass.in_video[selected[i]];
  return table;
}

Result<cv::Mat> oriented_frame(VideoFile& video,
                               std::size_t number,
                               const CameraParameters& camera) {
  const auto read = video.frame(number);
  if (!read) return read.error();
  return oriented_for(camera, (*read)->grey, en::say("the recording's picture"), "", "");
}

Result<cv::Mat> RecordedVideo::frame(std::size_t number) {
  if (!pass.greys[number].empty()) return pass.greys[number];
  return oriented_frame(reader, number, finger.camera);
}

}  // namespace alltact
