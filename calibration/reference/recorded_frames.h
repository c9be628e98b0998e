// Frames of a recording that was just written, by their number in it, and their marker positions.
#pragma once

#include "calibration/reference/recording_pass.h"
#include "core/recording/video_file.h"
#include "core/sensing/reference/marker_table.h"

#include <filesystem>
#include <vector>

namespace alltact {

/// A row for each of `selected`, numbered from 0 on.
[[nodiscard]] MarkerTable table_of(const NumberedRecording& numbered,
                                   const std::vector<std::size_t>& selected);
/// The same, numbered as the frames are in the video.
[[nodiscard]] MarkerTable table_in_video(const RecordingPass& pass,
                                         const NumberedRecording& numbered,
                                         const std::vector<std::size_t>& selected);

/// Frame `number` of a video, CV_8UC1, oriented as the camera.
[[nodiscard]] Result<cv::Mat> oriented_frame(VideoFile& video,
                                             std::size_t number,
                                             const CameraParameters& camera);

/// The referenced objects must outlive this.
struct RecordedVideo {
  const RecordingPass& pass;
  const std::filesystem::path& file;
  const Finger& finger;
  const Camera& camera;
  VideoFile reader;

  /// By its number in the video; CV_8UC1, oriented as the finger's camera.
  [[nodiscard]] Result<cv::Mat> frame(std::size_t number);
};

}  // namespace alltact
