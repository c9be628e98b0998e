// The presses that a finger keeps, as truth that nobody painted: a mapping made without a press is
// held against the ball's sphere in it.
//
// What the error holds: the mapping made from fewer presses than the finger's own, picture noise
// and reference, and how well the ball is found by the shape of its contact (ball_by_shape.h). What
// it does not hold: a radius that is wrong for all presses.
#pragma once

#include "calibration/finger/calibration_inputs.h"
#include "calibration/presses/press.h"
#include "calibration/study/accuracy_study.h"
#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/reference/reference_library.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace alltact {

class RealPresses {
 public:
  static constexpr std::size_t kLeast = 3;  ///< presses: two calibrate, one is left out

  /// Reads the pictures of the presses that are not left out, and the finger's reference. Errors:
  /// the finger keeps no presses, or fewer than kLeast of a ball; those of reading them; stopped.
  [[nodiscard]] static Result<RealPresses> open(const FingerPtr& finger, const Job& job);

  /// As these settings read them, each by itself; those that show no face or no reference are
  /// missing. Errors: those of Pipeline; stopped.
  [[nodiscard]] Result<std::vector<Press>> measured(const PipelineSettings& settings,
                                                    const Job& job) const;

  /// Of a finger's usual calibration with the family of its mapping: each press left out in turn,
  /// of more than ten in ten groups. Errors: those of measured(); no press could be held against a
  /// mapping.
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

/// Absolute errors, mm, of what a mapping reads in presses, by the zone of the face.
class RealErrorSum {
 public:
  /// face_length_mm: of which a third is a zone; of a flat sensor what the camera sees
  void add(const Press& press, const Face& face, const Mapping& mapping, const Job& job);
  void add_missing() { ++errors_.presses_missing; }
  /// nullopt: no press was measured.
  [[nodiscard]] std::optional<RealErrors> errors();

 private:
  RealErrors errors_;
  std::array<std::vector<float>, kFaceZones> by_zone_;
};

/// That which a mapping is made with again: its family, degree and thickness are not chosen anew.
[[nodiscard]] CalibrationSettings as_it_was_chosen(const CalibrationSettings& settings,
                                                   const MappingParameters& mapping);

/// Median and 95 %, of the order of the values independent; nullopt of none.
[[nodiscard]] std::optional<ErrorSpread> spread_of_errors(std::vector<float>& errors_mm);

/// Measures rows that have none yet and that `wanted` names, and puts it into them; `keep` is told
/// of each. Errors: those of held_out() where the base cannot be measured (of another row it is
/// absent); what keep says; stopped.
[[nodiscard]] Status add_real_errors(AccuracyStudy& study,
                                     const RealPresses& presses,
                                     const std::vector<std::size_t>& wanted,
                                     const KeepRows& keep,
                                     const Job& job);

/// Rows that are worth holding against real presses: the base, what presets_of() names, and where
/// `all` is asked for what one setting makes and what is on the front.
[[nodiscard]] std::vector<std::size_t> rows_for_real(const AccuracyStudy& study, bool all);

}  // namespace alltact
