// The first pass over a recording: its frames are written as a video, and the dots of each are
// found.
#pragma once

#include "calibration/reference/recording_layouts.h"
#include "calibration/reference/settings_record.h"
#include "core/job.h"
#include "core/sources/source.h"

#include <filesystem>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Results of the first pass.
struct RecordingPass {
  std::vector<FrameDots> frames;
  std::vector<int> in_video;  ///< by frame, its number in the video written; -1: not written
  int written = 0;
  /// By number in the video, the oriented images, so that they need not be decoded again; empty
  /// beyond the first 512 MB.
  std::vector<cv::Mat> greys;
  SettingsMonitor settings;
};

/// Reads the source to its end, writes every readable frame to `video` (lossless grey, as from the
/// source) and finds dots. Errors: a wrong size; a source that fails permanently; the video cannot
/// be written; a stopped job.
[[nodiscard]] Result<RecordingPass> read_recording(Source& source,
                                                   const Camera& camera,
                                                   const Finger& finger,
                                                   const Job& job,
                                                   const std::filesystem::path& video);

/// Rewrites the video with only some of its frames, in order. keep: by frame.
[[nodiscard]] Status retain_frames(const std::filesystem::path& video,
                                   const std::vector<char>& keep,
                                   const Job& job);

}  // namespace alltact
