// Summary of a recently used finger, for the start page.
#pragma once

#include "calibration/verdict/verdict.h"

#include <QImage>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// Read from the files of a folder; texts are made where they are shown.
struct FingerCard {
  std::filesystem::path folder;
  std::string name;
  std::optional<Grade> grade;  ///< of the calibration
  ReferenceState reference = ReferenceState::kAbsent;
  bool is_recorded = false;       ///< its reference is a recording, not a single image
  bool must_repeat = false;       ///< numbers or reference differ from those of the calibration
  std::vector<Message> findings;  ///< contradictions, then missing requirements
  std::string lacks;              ///< the worst requirement that is not met; empty: none
  Message rests_on;               ///< see Verdict
  /// Of its reference: a change of one of them may change all of this.
  std::vector<std::filesystem::path> files;
  std::string calibrated_on;  ///< UTC, 2026-01-31T12:00:00Z; empty: never
  std::string checked_on;     ///< likewise; of this calibration
  double error_mm = 0;        ///< expected at the next contact; 0: unknown
  double checked_mm = 0;      ///< error in the last check; 0: never checked
  FingerDue due = FingerDue::kNothing;
  QImage image;  ///< of a press or of the finger out of contact; null: none

  [[nodiscard]] bool operator==(const FingerCard&) const = default;
};

/// Reads a folder, on any thread; nullopt where no finger can be opened there.
///   now: UTC, as utc_now() writes it
[[nodiscard]] std::optional<FingerCard> read_finger_card(const std::filesystem::path& folder,
                                                         const std::string& now);

}  // namespace alltact
