// A study as text, table and JSON.
#pragma once

#include "calibration/study/accuracy_study.h"
#include "calibration/study/recommended_settings.h"
#include "core/base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace alltact {

/// One row on one line, in the form that a resumed study reads.
[[nodiscard]] std::string line_of(const StudyRow& row);
/// Error: a malformed line; a truncated last line is ignored.
[[nodiscard]] Result<std::vector<StudyRow>> rows_of_lines(std::string_view lines,
                                                          const std::string& where);

/// The study for other programs: errors apart from times, which depend on the computer.
[[nodiscard]] nlohmann::json json_of(const AccuracyStudy& study);

/// A line a row, with a header line: for spreadsheets.
[[nodiscard]] std::string csv_of(const AccuracyStudy& study);

/// The front and the rows that change one setting, in columns for a terminal.
[[nodiscard]] std::string text_of(const AccuracyStudy& study);

// The study stored with a finger: measured once on its own images, available at once later.
//
// accuracy_study.jsonl in the finger's folder holds a line on subject and origin of the
// measurement, then one line a row (study_file.h). The file grows during the measurement, so that a
// stopped study resumes from it.

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
[[nodiscard]] Result<FingerStudy> study_finger(const FingerPtr& finger, StudyExtent extent,
                                               const std::string& program_version, const Job& job);

/// Stores a study that was made elsewhere as one of this finger, this computer and this time.
[[nodiscard]] Status store_study(const FingerPtr& finger, const AccuracyStudy& study,
                                 const std::string& program_version);

}  // namespace alltact
