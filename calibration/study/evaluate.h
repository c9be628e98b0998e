// Errors of results against the ground truth of simulated images.
#pragma once

#include "core/base/result.h"
#include "core/camera/camera.h"
#include "core/sensing/markers/markers.h"
#include "core/simulation/simulated_frame.h"

#include <filesystem>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Over all frames of a run. Means and medians are over pixels (or markers) of all frames together.
/// A figure without data is empty.
struct Evaluation {
  int frames = 0;          ///< compared
  int frames_missing = 0;  ///< in the truth, but without a result
  std::optional<double>
      contact_depth_mm;  ///< mean |error| of depth where truly deeper than 0.05 mm
  std::optional<double> contact_coverage;  ///< fraction of those pixels that have a depth at all
  std::optional<double> false_depth_mm;    ///< mean |depth| further than 1 mm from any contact
  std::optional<double> position_mm;       ///< median |error| of z of the untouched face
  std::optional<double> marker_seen_px;    ///< mean distance, markers seen that can be seen
  std::optional<double> marker_hidden_px;  ///< mean distance, markers that cannot be seen
  std::optional<double> time_ms;           ///< median time of a frame in the pipeline
};

/// Collects errors frame by frame.
class Evaluator {
 public:
  explicit Evaluator(Camera camera) : camera_(std::move(camera)) {}

  /// depth_mm CV_32FC1 and points_mm CV_32FC3 (of the pressed face) as reconstruct writes them, the
  /// size of the truth's. An empty list of markers is not compared.
  void add(const Truth& truth, const cv::Mat& depth_mm, const cv::Mat& points_mm,
           const Markers& markers);
  void add_missing() { ++evaluation_.frames_missing; }
  void add_time(double time_ms) { times_ms_.push_back(time_ms); }

  [[nodiscard]] Evaluation evaluation() const;

 private:
  void add_depth(const Truth& truth, const cv::Mat& depth_mm);
  void add_position(const Truth& truth, const cv::Mat& depth_mm, const cv::Mat& points_mm);
  void add_markers(const Truth& truth, const Markers& markers);

  struct Mean {
    double sum = 0;
    double count = 0;
    void add(double value) { sum += value, ++count; }
    [[nodiscard]] std::optional<double> value() const {
      return count > 0 ? std::optional(sum / count) : std::nullopt;
    }
  };
  Camera camera_;
  Evaluation evaluation_;
  Mean contact_, false_, seen_, hidden_, covered_;
  std::vector<double> positions_mm_, times_ms_;
};

/// Compares a folder that `alltact simulate` wrote with what `alltact reconstruct` made of it.
/// Errors: files missing or not as these commands write them.
[[nodiscard]] Result<Evaluation> evaluate_folder(const std::filesystem::path& truth_folder,
                                                 const std::filesystem::path& results_folder);

// Thresholds on the ground truth, shared by all error figures.

inline constexpr float kPressedMm = 0.05F;    ///< deeper: inside a contact
inline constexpr float kUntouchedMm = 0.01F;  ///< less: no contact
inline constexpr double kAwayMm = 1.0;        ///< distance from any contact that counts as far

}  // namespace alltact
