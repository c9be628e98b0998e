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

#include "calibration/study/study_choice.h"
#include "calibration/study/study_world.h"
#include "core/job.h"
#include "core/result.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

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
                                                   const SaveRows& save,
                                                   const Job& job);

}  // namespace alltact
