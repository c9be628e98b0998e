// The source paper's reference: the frame with the nearest markers from a video of the untouched
// finger.
#pragma once

#include "core/camera/camera.h"
#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/markers/markers.h"

#include <filesystem>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// The markers of a frame by the paper's sorting into two rows (paper_rows.h). MarkerDetector finds
/// the dots instead of the paper's network, whose weights are its authors'. `before`: the markers
/// of an earlier frame; may be null. nullopt: too few dots.
[[nodiscard]] std::optional<Markers> paper_markers(const cv::Mat& grey,
                                                   const FaceShape& shape,
                                                   const MarkerRows& rows,
                                                   const Markers* before);

class PaperReference {
 public:
  struct Recorded {
    cv::Mat grey;
    Markers markers;
    int number = 0;  ///< in the video
  };

  /// Reads a recording with the paper's own steps, without a marker table. Frames in which face or
  /// markers are not found are left out. A video larger than `memory_limit_bytes` is read at every
  /// second, third, ... frame. Errors: the video cannot be read, or shows the markers in no frame;
  /// stopped.
  [[nodiscard]] static Result<PaperReference> read(const std::filesystem::path& video,
                                                   const Finger& finger,
                                                   const Camera& camera,
                                                   const Job& job,
                                                   std::size_t memory_limit_bytes = std::size_t{512}
                                                                                    << 20);

  [[nodiscard]] std::size_t frame_count() const { return frames_.size(); }
  [[nodiscard]] const Recorded& frame(std::size_t index) const { return frames_[index]; }

  /// The frame with the smallest sum of distances over all markers, seen or estimated, and that sum
  /// divided by their number. `markers`: as many as were recorded.
  struct Nearest {
    std::size_t index = 0;
    double distance_px = 0;
  };
  [[nodiscard]] Nearest nearest(const Markers& markers) const;

 private:
  std::vector<Recorded> frames_;  // at least one
};

}  // namespace alltact
