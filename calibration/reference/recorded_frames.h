// Frames of a recording that was just written, by their number in it, and where their markers are.
#pragma once

#include "calibration/reference/recording_pass.h"
#include "core/recording/video_file.h"
#include "core/sensing/reference/marker_table.h"

#include <filesystem>
#include <vector>

namespace alltact {

/// A row for each of `kept`, numbered from 0 on.
[[nodiscard]] MarkerTable table_of(const NumberedRecording& numbered,
                                   const std::vector<std::size_t>& kept);
/// The same, numbered as the frames are in the video.
[[nodiscard]] MarkerTable table_in_video(const RecordingPass& pass,
                                         const NumberedRecording& numbered,
                                         const std::vector<std::size_t>& kept);

/// Frame `number` of a video, CV_8UC1, oriented as the camera has it.
[[nodiscard]] Result<cv::Mat> oriented_frame(VideoFile& video,
                                             std::size_t number,
                                             const CameraParameters& camera);

/// What was referred to must live as long.
struct RecordedVideo {
  const RecordingPass& pass;
  const std::filesystem::path& file;
  const Finger& finger;
  const Camera& camera;
  VideoFile reader;

  /// By its number in the video; CV_8UC1, oriented as the finger's camera has it.
  [[nodiscard]] Result<cv::Mat> frame(std::size_t number);
};

}  // namespace alltact
