// Recorders on a made-up camera, and what is in the files that they leave.
#pragma once

#include "core/recording/recorder.h"
#include "core/recording/video_file.h"
#include "tests/core/recording/recording_frames.h"

#include <filesystem>
#include <memory>

#include <gtest/gtest.h>

namespace alltact::test {

namespace fs = std::filesystem;

inline RecorderSettings settings_for(VideoCodec codec, int queue_mb = 256) {
  RecorderSettings settings;
  settings.codec = codec;
  settings.queue_mb = queue_mb;
  settings.reserve_mb = 0;
  return settings;
}

inline std::unique_ptr<Recorder> started(const fs::path& file, const RecorderSettings& settings) {
  auto recorder = Recorder::start(file, settings, 30, "test camera");
  EXPECT_TRUE(recorder.ok()) << recorder.error().sentence();
  return std::move(*recorder);
}

/// All frames of a recording are the camera's, from the first on without a gap; how many.
inline std::uint32_t exact_frames(const fs::path& file, bool is_jpeg, cv::Size size = {64, 48}) {
  auto video = VideoFile::open(file);
  EXPECT_TRUE(video.ok()) << video.error().sentence();
  if (!video.ok()) return 0;
  for (std::uint32_t i = 0; i < video->frame_count(); ++i) {
    const auto frame = video->frame(i);
    EXPECT_TRUE(frame.ok()) << frame.error().sentence();
    if (!frame.ok()) return i;
    const FramePtr truth = camera_frame(i, is_jpeg, size);
    EXPECT_EQ(cv::norm((*frame)->grey, truth->grey, cv::NORM_INF), 0) << i;
    EXPECT_EQ((*frame)->sequence, i);
  }
  return static_cast<std::uint32_t>(video->frame_count());
}

}  // namespace alltact::test
