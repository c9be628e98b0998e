// Which evidence the words good, usable, unproven, unfit; pass, drifting, recalibrate, too few; and
// "nothing is due" need, and what the next contact will be off by. The only code that decides them.
//
// THE EXPECTED ERROR
// Verdict::error_mm is what the contact that is made next will be off by in depth, mm along z, mean
// absolute inside it, anywhere on the face and as deep as the calibration's presses: two contacts
// of three are off by less. With m = sqrt(2 / pi), the mean absolute value of a normal error of
// standard deviation 1, t(n) Student's factor of n degrees of freedom for 68.3 %, and p distinct
// positions,
//   error^2 = max(shape, pixel)^2 + scale^2 + zone^2 + halo^2 + body^2 + radius^2
//   shape   t(p - 1) * error on presses left out    the mapping's shape, and noise and reference
//   pixel   m * sd of a pixel by noise, reference, light and sideways (depth_sd.h): what presses
//           left out hold as well, so that only the larger counts
//   scale   t(p - 1) * m * sd of the whole mapping over its domain, at most m' * deepest press:
//           balls take it up, so that no press left out shows it
//   zone    shape * sqrt(leverage - 2 / p) of a line along the face: far from all presses
//   halo    kHaloWeight * depth read beside contacts (report/halo.h): light that scatters sideways
//           or skin that leaves the ball early, which no press tells apart; only light is an error
//   body    kBodyShare * m' * deepest press, m' the mean depth of a ball's contact as a part of its
//           deepest, where neither a depth nor a step was measured: light that scatters makes all
//           depths too large and other bodies read otherwise, and balls agree with each other
//   radius  relative change of depth for one of the radius * kRadiusSdMm / R * m' * deepest press
// Measured in random campaigns on faces that were painted without the code that measures them
// (tests/calibration/verdict).
#pragma once

#include "calibration/verdict/contradiction.h"
#include "core/finger/finger.h"
#include "core/message.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

enum class Grade {
  kGood = 1,  ///< shape and depth can be measured
  kUsable,    ///< contact and its position can, fine relief cannot
  kUnproven,  ///< the evidence does not suffice for a better word
  kUnfit,     ///< do not measure with it
};
/// "good", "usable", "unproven", "unfit": for files, streams and programs.
[[nodiscard]] std::string_view to_string(Grade grade);
/// As a sentence says it: "good", "usable for contact and its place", ...
[[nodiscard]] Message word_of(Grade grade);

/// Good up to this expected error, usable up to the other, mm.
inline constexpr double kGoodErrorMm = 0.06;
inline constexpr double kUsableErrorMm = 0.15;

/// Mean absolute value of a normal error whose standard deviation is 1: sqrt(2 / pi).
inline constexpr double kMeanOfSd = 0.7978845608028654;

/// Standard deviation of a ball's radius that was measured with callipers, mm: they show 0.01 mm of
/// the diameter and are right within 0.02 mm (ISO 13385-1).
inline constexpr double kRadiusSdMm = 0.01;

/// By what bodies of other shape read otherwise than balls, as a part of depth, where light
/// scatters sideways unseen: 0.05 to 0.155 mm of about 1 mm between balls and punches on 17
/// white-light sensors; the lower end, as most layers scatter less.
inline constexpr double kBodyShare = 0.05;
/// Of two causes that are as likely, one makes an error: half of the variance.
inline constexpr double kHaloWeight = 0.7071067811865476;

/// By what the 68.3 % bound of a spread grows when it is estimated with `freedom` degrees of
/// freedom (Abramowitz and Stegun 26.7.5); that of 1 for less.
[[nodiscard]] double student_factor(int freedom);

/// Where the error comes from.
enum class ErrorCause { kShape = 1, kScale, kPixel, kZone, kHalo, kRadius, kBody };
/// "shape", "scale", ...: for files and programs.
[[nodiscard]] std::string_view to_string(ErrorCause cause);
struct ErrorPart {
  ErrorCause cause;
  double error_mm = 0;  ///< mean absolute
};

/// What is wrong with the files of a finger's reference.
enum class ReferenceState {
  kWhole = 1,
  kAbsent,      ///< the finger names none
  kMissing,     ///< a file that it names is not there
  kCut,         ///< the recording ends early, or a table or picture cannot be read
  kOtherImage,  ///< its images are not of the camera's size
};

/// What is wrong and what to do; empty: the reference is whole.
[[nodiscard]] Message sentence(ReferenceState state);

/// All that decides a calibration's word. Zeros and defaults are missing evidence.
struct CalibrationEvidence {
  int presses = 0, positions = 0;  ///< used; distinct positions of them on the face
  std::array<int, 3> thirds = {};  ///< positions in base, middle, tip (flat: left, middle, right)
  bool is_flat = false;
  double shallowest_mm = 0, deepest_mm = 0;  ///< of the balls
  double residual_mm = 0;                    ///< mean absolute, on the presses themselves
  double held_out_mm = 0;                    ///< mean absolute, on presses left out; 0: none
  double scale_sd_mm = 0;                    ///< 0: unknown
  double pixel_sd_mm = 0;                    ///< without the mapping's share
  double halo_mm = 0;                        ///< 0: not significant
  double position_leverage = 0;              ///< see CalibrationBasis
  double depth_per_radius = 0;               ///< likewise
  std::vector<double> ball_radii_mm;         ///< ascending; 0: a step or a depth was measured
  double layer_mm = 0;
  double width_mm = 0;      ///< of a Fin Ray face; of a flat sensor's image where that is known
  int left_out = 0;         ///< presses that were given and failed
  bool has_basis = false;   ///< false: an earlier version calibrated, and stored less
  bool is_complete = true;  ///< false: stopped before the solution had settled
  std::vector<Contradiction> contradictions;
  // What happened since, and the files.
  std::vector<Message> changed;  ///< numbers that are not what they were: "width", "layer", ...
  bool reference_is_newer = false;
  ReferenceState reference = ReferenceState::kWhole;
  std::optional<double> days_unchecked;  ///< since calibration or the last check that passed
  Message repeat_command;                ///< which calibrates again from the stored presses
};

/// Of a calibrated finger as finger.yaml has it, without looking at other files: what has changed
/// since is found in it, too. Nothing but defaults where the finger has no record.
[[nodiscard]] CalibrationEvidence evidence_of(const Finger& finger);

/// A piece of evidence, and the best word that can be said without it.
struct Requirement {
  std::string_view name;  ///< "positions", for tests and files
  Grade without;
  bool (*is_met)(const CalibrationEvidence& evidence, double error_mm);
  Message (*missing)(const CalibrationEvidence& evidence, double error_mm);  ///< and what to do
};
/// All that "good" needs, worst first. Each threshold's reason stands beside it in verdict.cpp.
[[nodiscard]] const std::vector<Requirement>& calibration_requirements();

struct Verdict {
  Grade grade = Grade::kUnfit;
  double error_mm = 0;           ///< see the top of this file; NaN: none can be said
  std::vector<ErrorPart> parts;  ///< largest first, those that are 0 left out
  Message cause;  ///< the largest part, and what reduces it; empty: none can be named
  std::vector<Message> missing;  ///< what a better word lacks, worst first; empty: good
  std::vector<std::string_view> missing_names;  ///< of the requirements, in the same order
  Message rests_on;  ///< "ball of 8.00 mm diameter, layer 1.50 mm, face 24.00 mm wide"
  Message reason;    ///< what is missing, figure and largest cause, what it rests on
  Message sentence;  ///< the same behind the grade
};
[[nodiscard]] Verdict verdict(const CalibrationEvidence& evidence);

/// Of a check with new presses, or with new images of the untouched finger.
enum class CheckVerdict { kPass = 1, kDrifting, kRecalibrate, kTooFew };
/// "pass", "drifting", "recalibrate", "too_few".
[[nodiscard]] std::string_view to_string(CheckVerdict verdict);
/// As a sentence says it: "pass", "too few to tell", ...
[[nodiscard]] Message word_of(CheckVerdict verdict);
/// Of the thirds along a face: "base", "middle", "tip" (flat: "left", "middle", "right").
[[nodiscard]] Message third_name(bool is_flat, std::size_t third);

/// How many a check needs to pass: with three at distinct positions the mean's standard error is
/// known with two degrees of freedom, the fewest that tell one bad press from a bad mapping.
inline constexpr int kCheckPresses = 3;

struct CheckEvidence {
  int count = 0;      ///< presses or images that could be measured
  int positions = 0;  ///< distinct ones of them; of untouched images their number
  double error = 0, drifting_above = 0, recalibrate_above = 0;  ///< all of one unit
  double light_change = 0, light_drifting_above = 0, light_recalibrate_above = 0;  ///< magnitudes
  bool reference_is_touched = false;  ///< an untouched image shows a body in the reference
};
/// kRecalibrate is said from one press; kPass and kDrifting need kCheckPresses positions.
[[nodiscard]] CheckVerdict check_verdict(const CheckEvidence& evidence);

/// What a finger needs next.
enum class FingerDue {
  kNothing = 1,
  kRecording,    ///< it has no reference
  kCalibration,  ///< it has no mapping
  kFirstCheck,   ///< not checked since it was calibrated
  kCheck,        ///< the last check that passed is old
  kLook,         ///< the last check found it drifting
  kAgain,        ///< the last check asked for a new calibration, or the calibration is unfit
  kRepair,       ///< a file of its reference is missing, cut or of another camera
  kRepeat,       ///< numbers or reference changed: calibrate again from the stored presses
  kEvidence,     ///< the calibration is unproven: add presses
  kMorePresses,  ///< the last check had too few presses
};
/// "nothing", "recording", ...: for files, streams and programs.
[[nodiscard]] std::string_view to_string(FingerDue due);

struct DueEvidence {
  bool needs_recording = true;  ///< a Fin Ray finger; a flat sensor has an image
  bool has_mapping = false;
  ReferenceState reference = ReferenceState::kAbsent;
  std::optional<Grade> grade;         ///< of the calibration; absent: nothing is stored of it
  bool must_repeat = false;           ///< numbers or reference are not those of the calibration
  std::optional<CheckVerdict> check;  ///< the last one of this calibration
  std::optional<double> check_days;   ///< since then; absent: unknown
};
/// A check is due again after so many days.
inline constexpr int kCheckEveryDays = 7;
[[nodiscard]] FingerDue due_of(const DueEvidence& evidence);

}  // namespace alltact
