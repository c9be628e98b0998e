// What a calibration's choices cost and bring: how many presses, how many pictures of each, which
// method, family and how many iterations, against computing and against the technician's time.
//
// Two truths, told apart:
//   painted  balls painted into untouched pictures of the finger calibrate it anew, and other
//            painted pictures tell how far its depth is off: any number of presses, but skin that
//            follows the ball exactly, and a mapping of the finger's own form;
//   real     the presses that the finger keeps: some calibrate, the rest is held against the ball's
//            sphere (real_presses.h); no more of them than there are.
#pragma once

#include "calibration/joint/calibration_settings.h"
#include "calibration/study/accuracy_study.h"
#include "calibration/study/real_presses.h"
#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/message.h"
#include "core/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace alltact {

/// What a technician spends. An estimate, not measured here: whoever knows better changes it in
/// this place.
struct TechnicianTimes {
  double once_s = 120;          ///< fetch and clean the ball, start, read the verdict
  double press_s = 20;          ///< move the ball, press, wait until it is still, take, lift
  double picture_s = 1.0 / 30;  ///< each further picture of a press that is held
  [[nodiscard]] double minutes(int presses, int pictures) const {
    return (once_s + presses * (press_s + (pictures - 1) * picture_s)) / 60;
  }
};

struct CalibratingChoice {
  int presses = 6;
  int pictures = 1;  ///< of each press, averaged
  CalibrationMethod method = CalibrationMethod::kJoint;
  FamilyChoice family = FamilyChoice::kAuto;
  int iterations = CalibrationSettings{}.iterations;
  bool operator==(const CalibratingChoice&) const = default;
};

struct CalibratingRow {
  CalibratingChoice choice;
  int draws = 0, failed = 0;           ///< calibrations with painted presses; that gave no mapping
  std::optional<ErrorSpread> painted;  ///< of depth in other painted pictures
  int splits = 0, splits_failed = 0;   ///< the same of the presses that are kept
  std::optional<RealErrors> real;
  double computing_s = 0;  ///< reading the presses and solving, on this computer, then; median
  double time_ratio = 1;   ///< to the base, median over the draws
  double technician_min = 0;
};

struct CalibratingStudy {
  Message about;
  std::uint64_t world_checksum = 0;
  TechnicianTimes technician;
  Message no_real;                   ///< why no kept presses tell anything; empty: they do
  std::vector<CalibratingRow> rows;  ///< the base (a usual calibration) first
};

struct CalibratingOptions {
  std::uint64_t seed = 1;
  std::optional<CalibratingChoice> base =
      std::nullopt;    ///< absent: as many presses as the finger's
  bool quick = false;  ///< fewer choices and draws
  TechnicianTimes technician;
};

/// Every choice by itself and those of presses with those of method and pictures. Errors: those of
/// untouched_pictures() and Pipeline; stopped.
[[nodiscard]] Result<CalibratingStudy> study_calibrating(const FingerPtr& finger,
                                                         const CalibratingOptions& options,
                                                         const Job& job);

/// The choices in their order, of the values that calibration_settings() says are worth trying; the
/// base first.
[[nodiscard]] std::vector<CalibratingChoice> calibrating_choices(const CalibratingChoice& base,
                                                                 bool quick);

/// As the finger was calibrated, as far as painted presses can be as many; the usual choice where
/// it does not tell.
[[nodiscard]] CalibratingChoice choice_of_finger(const Finger& finger);

/// "6 presses, 4 pictures each, cone"
[[nodiscard]] Message words_of(const CalibratingChoice& choice);

/// Minutes of the technician and of the computer together.
[[nodiscard]] double whole_minutes(const CalibratingRow& row);

/// Rows (by index, quickest first) that nothing beats in whole_minutes() and painted median error.
[[nodiscard]] std::vector<std::size_t> calibrating_front(const CalibratingStudy& study);

/// What one more press, more pictures of each and more minutes would bring over `from`, by painted
/// truth, each a sentence; only what was studied.
[[nodiscard]] std::vector<Message> what_more_brings(const CalibratingStudy& study,
                                                    const CalibratingChoice& from);

[[nodiscard]] std::string text_of(const CalibratingStudy& study);
[[nodiscard]] std::string csv_of(const CalibratingStudy& study);
[[nodiscard]] nlohmann::json json_of(const CalibratingStudy& study);

}  // namespace alltact
