// The study stored with a finger: measured once on its own images, available at once later.
//
// accuracy_study.jsonl in the finger's folder holds a line on subject and origin of the
// measurement, then one line a row (study_file.h). The file grows during the measurement, so that a
// stopped study resumes from it.
#pragma once

#include "calibration/study/accuracy_study.h"

#include <optional>
#include <string>

namespace alltact {

inline constexpr const char* kFingerStudy = "accuracy_study.jsonl";

struct FingerStudy {
  /// the rows there are so far, calibrated settings first; never empty
  AccuracyStudy study;
  std::string date;               ///< UTC, start of the study
  std::string computer;           ///< that the times were measured on
  bool is_of_finger_now = false;  ///< camera, face, markers, mapping and reference are the same
  bool is_of_this_computer = false;
  bool has_all_single = false;  ///< every value of every setting by itself
  bool has_all_pairs = false;   ///< and every two of them
};

/// nullopt: the finger has none. Errors: the file is not readable, or is not a study.
[[nodiscard]] Result<std::optional<FingerStudy>> stored_study(const FingerPtr& finger);

/// Measures the missing rows and stores them. Rows of another finger, computer or version of the
/// program are measured again. Errors: those of painted_world and study_accuracy; not writable.
///   extent: kQuick takes about 12 s, kPairs some minutes
[[nodiscard]] Result<FingerStudy> study_finger(const FingerPtr& finger,
                                               StudyExtent extent,
                                               const std::string& program_version,
                                               const Job& job);

/// Stores a study that was made elsewhere as one of this finger, this computer and this time.
[[nodiscard]] Status store_study(const FingerPtr& finger,
                                 const AccuracyStudy& study,
                                 const std::string& program_version);

}  // namespace alltact
