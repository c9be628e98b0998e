// The earlier reference of a finger that is recorded again: evidence of its untouched skin.
#pragma once

#include "calibration/reference/recording_layouts.h"
#include "core/finger/finger.h"
#include "core/job.h"
#include "core/recording/video_file.h"
#include "core/result.h"
#include "core/sensing/reference/marker_table.h"

#include <filesystem>
#include <optional>
#include <utility>

namespace alltact {

class EarlierReference {
 public:
  /// At most kMostFrames of it, spread evenly. nullopt: there is none, it cannot be read, or its
  /// poses rely on other markers than those of the new recording.
  static std::optional<EarlierReference> open(const std::filesystem::path& folder,
                                              const Finger& finger,
                                              const NumberedRecording& recording,
                                              const Job& job);

  static constexpr std::size_t kMostFrames = 300;

  [[nodiscard]] const MarkerTable& table() const { return table_; }
  /// By its number in the video; CV_8UC1, oriented as the finger's camera.
  [[nodiscard]] Result<cv::Mat> frame(std::size_t number);

 private:
  EarlierReference(CameraParameters camera, VideoFile video, MarkerTable table)
      : camera_(std::move(camera)), video_(std::move(video)), table_(std::move(table)) {}

  CameraParameters camera_;
  VideoFile video_;
  MarkerTable table_;
};

}  // namespace alltact
