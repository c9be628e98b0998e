// Cost in time and gain in accuracy of each setting of the frame pipeline, measured on images with
// known ground truth (study_world.h).
//
// ERRORS are those of single frames. They depend on images and settings alone, and are the same to
// the bit on any computer, with any number of threads.
//
// TIMES are of a frame that follows one of nearly the same pose, as live frames do: processor time
// where OpenCV has one thread, else wall-clock time. Each choice takes turns with the base, frame
// by frame, so that both see the same load. Compared is the median of the ratios.
#pragma once

#include "calibration/study/study_world.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/finger/finger_store.h"
#include "core/image/frame.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/pipeline_settings.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

// The settings that a study compares, and their names.

enum class StudyExtent {
  kQuick = 1,  ///< every value that is worth trying (Trade::tried), one setting at a time
  kPairs,      ///< and every two of them at a time, and the cheapest of all
};

/// The base first, then the others, each once, in a fixed order. Only settings that trade accuracy
/// for time on this finger (has_trade_off()).
[[nodiscard]] std::vector<PipelineSettings> study_choices(const PipelineSettings& base,
                                                          StudyExtent extent, const Finger& finger);

/// The differences: "reference-method nearest, smoothing-px 0"; "as it is" where there is none.
[[nodiscard]] Message words_of(const PipelineSettings& choice, const PipelineSettings& base);

/// The same as flags of the command line: "--reference-method nearest --smoothing-px 0".
[[nodiscard]] std::string flags_of(const PipelineSettings& choice, const PipelineSettings& base);

/// False: the choice has a value, different from the base's, whose loss the study's images do not
/// show: their light is that of the recording.
[[nodiscard]] bool is_proven(const PipelineSettings& choice, const PipelineSettings& base);

/// All settings with their values; unique for each choice.
[[nodiscard]] std::string key_of(const PipelineSettings& choice);

/// Of absolute errors, mm.
struct ErrorSpread {
  double median_mm = 0, p95_mm = 0;
};

/// Of presses that were left out of the calibration that measures them.
struct RealErrors {
  int presses = 0, presses_missing = 0;  ///< measured; without a ball, or without a mapping
  ErrorSpread depth;                     ///< against the ball's sphere, where skin and ball touch
  std::array<std::optional<ErrorSpread>, kFaceZones> depth_by_zone;
};

/// What one choice of settings does. Fields that no frame measures are empty.
struct StudyRow {
  PipelineSettings settings;
  int frames = 0;          ///< measured
  int frames_missing = 0;  ///< without depth
  /// Of pixels truly pressed deeper than 0.05 mm.
  std::optional<ErrorSpread> depth;
  std::array<std::optional<ErrorSpread>, kFaceZones> depth_by_zone;
  std::optional<double> coverage;         ///< fraction of these pixels that have a depth at all
  std::optional<double> false_depth_mm;   ///< mean depth further than 1 mm from any contact
  std::optional<double> position_mm;      ///< median error of the contact's position on the face
  std::optional<double> position_p95_mm;  ///< 95 % of these errors are at most so large
  std::optional<double> angle_deg;        ///< median error of a bar's orientation
  std::optional<double> angle_p95_deg;
  int bars = 0;                         ///< analysed
  int bars_missing = 0;                 ///< without an angle
  double time_ms = 0, time_p95_ms = 0;  ///< on this computer, at the time of the study
  double time_ratio = 1;                ///< to the base, median
  /// Reference library plus what a pipeline and its first frame's result hold. Heap memory, so that
  /// it may differ by some hundred bytes from run to run.
  std::size_t memory_bytes = 0;
  /// Of the finger's own presses (real_presses.h), left out of the calibration that measures them.
  /// Never mixed with the other figures.
  std::optional<RealErrors> real = std::nullopt;
};

struct StudyOptions {
  StudyExtent extent = StudyExtent::kPairs;
  PipelineSettings base;  ///< the first row
  int repeats = 3;        ///< of the times
};

struct AccuracyStudy {
  Message about;
  bool simulated = false;
  std::uint64_t world_checksum = 0;
  std::vector<StudyRow> rows;  ///< the base first, then in the order of study_choices()
  /// StudyWorld::mapping_p95_mm: an error that the errors above do not include.
  double mapping_p95_mm = 0;
};

/// Rows that are known already (by key_of()) are not measured again. `keep` receives new rows as
/// soon as they are measured. Errors: those of Pipeline; those of `keep`; stopped.
using SaveRows = std::function<Status(const std::vector<StudyRow>&)>;
[[nodiscard]] Result<AccuracyStudy> study_accuracy(const StudyWorld& world,
                                                   const StudyOptions& options,
                                                   const std::vector<StudyRow>& known,
                                                   const SaveRows& save, const Job& job);

// One frame measured with two settings, and the difference of the depths.

struct ComparedFrame {
  FrameResult now, other;
  /// Depth of `other` minus that of `now`, mm, CV_32FC1, in the camera's image size at any
  /// resolution. NaN where either has none. Empty where one has no depth at all.
  cv::Mat difference_mm;
  /// Of absolute differences, where either depth is above 0.05 mm; empty: nothing presses.
  std::optional<double> median_mm, p95_mm;
  /// processor time of this frame, which each pipeline has seen once before
  double now_ms = 0, other_ms = 0;
};

/// Used by one thread.
class ComparedSettings {
 public:
  /// Errors: those of Pipeline::create.
  [[nodiscard]] static Result<ComparedSettings> create(const FingerSnapshot& finger,
                                                       const PipelineSettings& now,
                                                       const PipelineSettings& other,
                                                       const Job& job);
  /// Error: the frame is not of the finger's size.
  [[nodiscard]] Result<ComparedFrame> operator()(const FramePtr& frame);

 private:
  ComparedSettings(Pipeline now, Pipeline other) : now_(std::move(now)), other_(std::move(other)) {}
  Pipeline now_, other_;
};

/// Expands an image of a reduced frame: each value is repeated over the pixels that it covers, NaN
/// outside. Unchanged where nothing is reduced.
///   values: CV_32FC1
[[nodiscard]] cv::Mat at_full_size(const cv::Mat& values, int reduced_by, cv::Size full);

}  // namespace alltact
