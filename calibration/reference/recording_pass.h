// The first pass over a recording: its frames written as a video of our own, and the dots of each.
#pragma once

#include "calibration/reference/recording_layouts.h"
#include "calibration/reference/settings_record.h"
#include "core/job.h"
#include "core/sources/source.h"

#include <filesystem>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// All that the first pass leaves.
struct RecordingPass {
  std::vector<FrameDots> frames;
  std::vector<int> in_video;  ///< by frame, its number in the video written; -1: never got there
  int written = 0;
  /// By number in the video, the oriented pictures, so that they need not be decoded again; empty
  /// beyond the first 512 MB.
  std::vector<cv::Mat> greys;
  SettingsSeen settings;
};

/// Reads the source to its end, writes every frame that could be read to `video` (lossless grey, as
/// the source gave it) and looks for dots. Errors: a wrong size; a source that fails for ever; a
/// disk that does not take the video; a stopped job.
[[nodiscard]] Result<RecordingPass> read_recording(Source& source,
                                                   const Camera& camera,
                                                   const Finger& finger,
                                                   const Job& job,
                                                   const std::filesystem::path& video);

/// Rewrites the video with only some of its frames, in order. keep: by frame.
[[nodiscard]] Status keep_frames(const std::filesystem::path& video,
                                 const std::vector<char>& keep,
                                 const Job& job);

}  // namespace alltact
