// A finger's stored presses as ground truth that is not painted. A mapping made without a press is
// compared with the ball's sphere in that press.
//
// The error includes: a mapping made from fewer presses than the finger's own, noise of image and
// reference, and the accuracy of fitting the ball to its contact (press_check.h). It excludes a
// radius error common to all presses.
#pragma once

#include "calibration/finger/calibration_inputs.h"
#include "calibration/presses/press.h"
#include "calibration/study/accuracy_study.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/reference/reference_library.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace alltact {

class RealPresses {
 public:
  static constexpr std::size_t kMinPresses = 3;  ///< presses: two calibrate, one is left out

  /// Reads the images of the presses that are not left out, and the finger's reference. Errors: the
  /// finger has no stored presses, or fewer than kMinPresses of a ball; those of reading them;
  /// stopped.
  [[nodiscard]] static Result<RealPresses> open(const FingerPtr& finger, const Job& job);

  /// The presses measured with these settings, one by one. Presses without a face or a reference
  /// are omitted. Errors: those of Pipeline; stopped.
  [[nodiscard]] Result<std::vector<Press>> measured(const PipelineSettings& settings,
                                                    const Job& job) const;

  /// Cross-validation of a default calibration with the family of the finger's mapping: each press
  /// is left out in turn, more than ten presses in ten groups. Errors: those of measured(); no
  /// press could be compared with a mapping.
  [[nodiscard]] Result<RealErrors> held_out(const PipelineSettings& settings, const Job& job) const;

  [[nodiscard]] const FingerSnapshot& finger() const { return *finger_; }
  [[nodiscard]] const CalibrationInputs& inputs() const { return inputs_; }
  [[nodiscard]] const std::vector<FramePtr>& frames() const { return frames_; }
  [[nodiscard]] const ReferenceLibrary& library() const { return library_; }

 private:
  RealPresses(FingerPtr finger, CalibrationInputs inputs, ReferenceLibrary library)
      : finger_(std::move(finger)), inputs_(std::move(inputs)), library_(std::move(library)) {}

  [[nodiscard]] Result<Pipeline> pipeline_of(const PipelineSettings& settings,
                                             const Job& job) const;

  FingerPtr finger_;
  CalibrationInputs inputs_;
  ReferenceLibrary library_;
  std::vector<FramePtr> frames_;
};

/// Absolute errors, mm, of a mapping's depth in presses, by the zone of the face.
class RealErrorSum {
 public:
  /// face_length_mm: a zone is a third of it; of a flat sensor the visible length
  void add(const Press& press, const Face& face, const Mapping& mapping, const Job& job);
  void add_missing() { ++errors_.presses_missing; }
  /// nullopt: no press was measured.
  [[nodiscard]] std::optional<RealErrors> errors();

 private:
  RealErrors errors_;
  std::array<std::vector<float>, kFaceZones> by_zone_;
};

/// Settings that repeat a mapping: its family, degree and thickness are fixed, not chosen anew.
[[nodiscard]] CalibrationSettings fixed_to_mapping(const CalibrationSettings& settings,
                                                   const MappingParameters& mapping);

/// Median and 95 %, independent of the order of the values; nullopt of an empty vector.
[[nodiscard]] std::optional<ErrorSpread> spread_of_errors(std::vector<float>& errors_mm);

/// Measures the rows named by `requested` that have no real errors yet, and stores the errors in
/// them. `keep` receives each row. Errors: those of held_out() for the base (for another row the
/// field stays empty); those of `keep`; stopped.
[[nodiscard]] Status add_real_errors(AccuracyStudy& study, const RealPresses& presses,
                                     const std::vector<std::size_t>& requested,
                                     const SaveRows& save, const Job& job);

/// Rows worth comparing with real presses: the base and what presets_of() names. With `all` also
/// rows that change one setting, and the front.
[[nodiscard]] std::vector<std::size_t> rows_for_real(const AccuracyStudy& study, bool all);

}  // namespace alltact
