// What is known of a finger that was worked with lately, for the page that one begins with.
#pragma once

#include "calibration/verdict/verdict.h"

#include <QImage>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// Of a folder, as its files stand; texts are worded where they are shown.
struct FingerCard {
  std::filesystem::path folder;
  std::string name;
  std::optional<Grade> grade;  ///< of the calibration
  ReferenceState reference = ReferenceState::kAbsent;
  bool is_recorded = false;       ///< its reference is a recording, not a single image
  bool must_repeat = false;       ///< numbers or reference are not those of the calibration
  std::vector<Message> findings;  ///< what contradicts the calibration, then what it lacks
  std::string lacks;              ///< the worst requirement that is not met; empty: none
  Message rests_on;               ///< see Verdict
  /// Of its reference: where one of them changes, all of this may.
  std::vector<std::filesystem::path> files;
  std::string calibrated_on;  ///< UTC, 2026-01-31T12:00:00Z; empty: never
  std::string checked_on;     ///< likewise; of this calibration
  double error_mm = 0;        ///< of the next contact; 0: nothing vouches for a figure
  double checked_mm = 0;      ///< what the last check was off by; 0: never checked
  FingerDue due = FingerDue::kNothing;
  QImage picture;  ///< of a press or of the untouched finger; null: none

  [[nodiscard]] bool operator==(const FingerCard&) const = default;
};

/// Reads a folder, on any thread; nullopt where no finger can be opened there.
///   now: UTC, as utc_now() writes it
[[nodiscard]] std::optional<FingerCard> read_finger_card(const std::filesystem::path& folder,
                                                         const std::string& now);

}  // namespace alltact
