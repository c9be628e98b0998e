// The study that a finger keeps: measured once on its own pictures, there at once on other days.
//
// accuracy_study.jsonl in the finger's folder: a line that says of what and where it was measured,
// then one line a row (study_file.h). It grows while it is measured, so that what was stopped goes
// on there.
#pragma once

#include "calibration/study/accuracy_study.h"

#include <optional>
#include <string>

namespace alltact {

inline constexpr const char* kFingerStudy = "accuracy_study.jsonl";

struct FingerStudy {
  AccuracyStudy study;            ///< the rows there are so far, as calibrated first; never empty
  std::string date;               ///< UTC, when it was begun
  std::string computer;           ///< whose times these are
  bool is_of_finger_now = false;  ///< camera, face, markers, mapping and reference are the same
  bool is_of_this_computer = false;
  bool has_all_single = false;  ///< every value of every setting by itself
  bool has_all_pairs = false;   ///< and every two of them
};

/// nullopt: the finger keeps none. Errors: the file is not readable, or not what a study keeps.
[[nodiscard]] Result<std::optional<FingerStudy>> kept_study(const FingerPtr& finger);

/// Measures what is missing, and keeps it. Rows of another finger, computer or version of the
/// program are measured again. Errors: those of painted_world and study_accuracy; not writable.
///   extent: kQuick takes about 12 s, kPairs some minutes
[[nodiscard]] Result<FingerStudy> study_finger(const FingerPtr& finger,
                                               StudyExtent extent,
                                               const std::string& program_version,
                                               const Job& job);

/// Keeps a study that was made elsewhere as if it had been measured of this finger, here and now.
[[nodiscard]] Status keep_study(const FingerPtr& finger,
                                const AccuracyStudy& study,
                                const std::string& program_version);

}  // namespace alltact
