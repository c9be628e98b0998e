// Rules for the grades good, usable, unproven, unfit; for the check results pass, drifting,
// recalibrate, too few; for "nothing is due"; and for the expected error. No other code decides
// them.
//
// THE EXPECTED ERROR
// Verdict::error_mm is the expected depth error of the next contact, mm along z, mean absolute
// inside it. It holds anywhere on the face, down to the depth of the calibration's presses. Two
// contacts of three have a smaller error. m = sqrt(2 / pi) is the mean absolute value of a normal
// error of standard deviation 1. t(n) is Student's factor of n degrees of freedom for 68.3 %, p the
// number of distinct positions:
//   error^2 = max(shape, pixel)^2 + scale^2 + zone^2 + halo^2 + body^2 + radius^2
//   shape   t(p - 1) * error on presses left out    the mapping's shape, and noise and reference
//   pixel   m * sd of a pixel by noise, reference, light and sideways (depth_sd.h): presses left
//           out contain it as well, so that only the larger one counts
//   scale   t(p - 1) * m * sd of the mapping over its full domain, at most m' * deepest press:
//           balls absorb it, so that no press left out shows it
//   zone    shape * sqrt(leverage - 2 / p) of a line along the face: far from all presses
//   halo    kHaloWeight * depth read outside contacts (report/press_errors.h): light that scatters
//           sideways, or skin that leaves the ball early. No press separates them; only light is
//           an error
//   body    kBodyShare * m' * deepest press, where neither a depth nor a step was measured. m' is
//           the mean depth of a ball's contact as a part of its deepest. Scattered light makes all
//           depths too large; other bodies read differently, and balls agree with each other
//   radius  relative change of depth for one of the radius * kRadiusSdMm / R * m' * deepest press
// Measured in random campaigns on faces painted by independent code (tests/calibration/verdict).
#pragma once

#include "core/base/message.h"
#include "core/finger/finger.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

// Numbers given for a calibration that its presses contradict.

enum class ContradictionKind {
  kContactWiderThanBall = 1,  ///< a dark part is wider than the ball itself
  kContactDeeperThanLayer,    ///< a ball lies deeper than the layer is thick
  kDepthBeyondMapping,        ///< a press is darker than the mapping reaches
  kFaceWidthAgainstCamera,    ///< the face's edges and the camera give another width
  kReferenceContact,          ///< skin is brighter in presses than in the reference
};
/// As finger.yaml writes it: "contact_wider_than_ball", ...
[[nodiscard]] std::string_view to_string(ContradictionKind kind);

struct Contradiction {
  ContradictionKind kind;
  std::vector<std::string> presses;  ///< that show it, by name
  double given_mm = 0;               ///< the number: a ball's radius, the layer, the width, a depth
  /// in the presses: the smallest value, or a position along the face
  double measured_mm = 0;
  double measured_to_mm = 0;  ///< the greatest; 0: as measured_mm
  int of = 0;                 ///< presses that were analysed
};

/// The number is certainly wrong, so that no depth is valid: the grade is unfit at best.
[[nodiscard]] bool rules_out_use(ContradictionKind kind);

/// The two sides of the contradiction, and what to check.
[[nodiscard]] Message sentence(const Contradiction& contradiction);

/// The form stored in finger.yaml, where presses are counted.
[[nodiscard]] RecordedContradiction recorded(const Contradiction& contradiction);

// Grades and errors.

enum class Grade {
  kGood = 1,  ///< shape and depth can be measured
  kUsable,    ///< contact and its position can, fine relief cannot
  kUnproven,  ///< the evidence does not suffice for a better grade
  kUnfit,     ///< do not measure with it
};
/// "good", "usable", "unproven", "unfit": for files, streams and programs.
[[nodiscard]] std::string_view to_string(Grade grade);
/// The grade as part of a sentence.
[[nodiscard]] Message word_of(Grade grade);

/// Good up to this expected error, usable up to the other, mm.
inline constexpr double kGoodErrorMm = 0.06;
inline constexpr double kUsableErrorMm = 0.15;

/// Mean absolute value of a normal error whose standard deviation is 1: sqrt(2 / pi).
inline constexpr double kMeanOfSd = 0.7978845608028654;

/// Standard deviation of a ball's radius measured with callipers, mm: they show 0.01 mm of the
/// diameter and are right within 0.02 mm (ISO 13385-1).
inline constexpr double kRadiusSdMm = 0.01;

/// Difference between bodies of other shapes and balls, as a fraction of depth, where light
/// scatters sideways undetected: 0.05 to 0.155 mm of about 1 mm between balls and punches on 17
/// white-light sensors. The lower end is used, as most layers scatter less.
inline constexpr double kBodyShare = 0.05;
/// Probability that the test for such light is wrong, whatever it reports: no layer is quite as the
/// test assumes.
inline constexpr double kSpreadTestDoubt = 0.1;
/// Mean depth inside the contacts of presses, mm: under a ball's cap depth is spread evenly, from 0
/// to the deepest, over the contact's area.
[[nodiscard]] inline double mean_depth_mm(double shallowest_mm, double deepest_mm) {
  return 0.5 * 0.5 * (shallowest_mm + deepest_mm);
}
/// Of two equally likely causes one makes an error: half of the variance.
inline constexpr double kHaloWeight = 0.7071067811865476;

/// Factor on the 68.3 % bound of a spread that is estimated with `freedom` degrees of freedom
/// (Abramowitz and Stegun 26.7.5); below 1, the factor for 1.
[[nodiscard]] double student_factor(int freedom);

/// Sources of the error.
enum class ErrorCause { kShape = 1, kScale, kPixel, kZone, kHalo, kRadius, kBody };
/// "shape", "scale", ...: for files and programs.
[[nodiscard]] std::string_view to_string(ErrorCause cause);
struct ErrorPart {
  ErrorCause cause;
  double error_mm = 0;  ///< mean absolute
};

/// State of the files of a finger's reference.
enum class ReferenceState {
  kIntact = 1,
  kAbsent,      ///< the finger names none
  kMissing,     ///< a named file does not exist
  kCut,         ///< the recording ends early, or a table or image cannot be read
  kOtherImage,  ///< its images are not of the camera's size
};

/// The fault and its remedy; empty: the reference is intact.
[[nodiscard]] Message sentence(ReferenceState state);

/// Everything that decides a calibration's grade. Zeros and defaults are missing evidence.
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
  double undetected_spread = 1;              ///< see CalibrationBasis
  double position_leverage = 0;              ///< see CalibrationBasis
  double depth_per_radius = 0;               ///< likewise
  std::vector<double> ball_radii_mm;         ///< ascending; 0: a step or a depth was measured
  double layer_mm = 0;
  double width_mm = 0;      ///< of a Fin Ray face; of a flat sensor's image where that is known
  int left_out = 0;         ///< presses that were given and failed
  bool has_basis = false;   ///< false: an earlier version calibrated, and stored less
  bool is_complete = true;  ///< false: stopped before the solution had settled
  std::vector<Contradiction> contradictions;
  // Changes since the calibration, and the files.
  std::vector<Message> changed;  ///< numbers that have changed: "width", "layer", ...
  bool reference_is_newer = false;
  ReferenceState reference = ReferenceState::kIntact;
  std::optional<double> days_unchecked;  ///< since calibration or the last check that passed
  Message repeat_command;                ///< which calibrates again from the stored presses
};

/// An entry of finger.yaml's provenance; empty where there is none.
[[nodiscard]] std::string provenance_of(const Finger& finger, const char* key);

/// Evidence of a calibrated finger from finger.yaml alone, including changes since the calibration.
/// Defaults where the finger has no record.
[[nodiscard]] CalibrationEvidence evidence_of(const Finger& finger);

/// A requirement, and the best grade without it.
struct Requirement {
  std::string_view name;  ///< "positions", for tests and files
  Grade without;
  bool (*is_met)(const CalibrationEvidence& evidence, double error_mm);
  Message (*missing)(const CalibrationEvidence& evidence, double error_mm);  ///< and what to do
};
/// All requirements of "good", worst first. verdict.cpp holds the reason of each threshold.
[[nodiscard]] const std::vector<Requirement>& calibration_requirements();

struct Verdict {
  Grade grade = Grade::kUnfit;
  double error_mm = 0;           ///< see the top of this file; NaN: unknown
  std::vector<ErrorPart> parts;  ///< largest first, without those that are 0
  Message cause;                 ///< the largest part, and what reduces it; empty: unknown
  std::vector<Message> missing;  ///< what a better grade lacks, worst first; empty: good
  std::vector<std::string_view> missing_names;  ///< of the requirements, in the same order
  Message rests_on;  ///< "ball of 8.00 mm diameter, layer 1.50 mm, face 24.00 mm wide"
  Message reason;    ///< what is missing, figure and largest cause, basis
  Message sentence;  ///< the same after the grade
};
[[nodiscard]] Verdict verdict(const CalibrationEvidence& evidence);

/// Of a check with new presses, or with new images of the untouched finger.
enum class CheckVerdict { kPass = 1, kDrifting, kRecalibrate, kTooFew };
/// "pass", "drifting", "recalibrate", "too_few".
[[nodiscard]] std::string_view to_string(CheckVerdict verdict);
/// The check result as part of a sentence.
[[nodiscard]] Message word_of(CheckVerdict verdict);
/// Of the thirds along a face: "base", "middle", "tip" (flat: "left", "middle", "right").
[[nodiscard]] Message third_name(bool is_flat, std::size_t third);

/// "width, camera and layer".
[[nodiscard]] Message enumerated(const std::vector<Message>& names);

/// Presses that a check needs to pass. With three distinct positions the mean's standard error has
/// two degrees of freedom, the fewest that separate one bad press from a bad mapping.
inline constexpr int kCheckPresses = 3;

struct CheckEvidence {
  int count = 0;      ///< presses or images that could be measured
  int positions = 0;  ///< distinct ones of them; of untouched images their number
  double error = 0, drifting_above = 0, recalibrate_above = 0;  ///< all of one unit
  double light_change = 0, light_drifting_above = 0, light_recalibrate_above = 0;  ///< magnitudes
  bool reference_has_contact = false;  ///< an untouched image shows a body in the reference
};
/// kRecalibrate needs one press; kPass and kDrifting need kCheckPresses positions.
[[nodiscard]] CheckVerdict check_verdict(const CheckEvidence& evidence);

/// The next step for a finger.
enum class FingerDue {
  kNothing = 1,
  kRecording,       ///< it has no reference
  kCalibration,     ///< it has no mapping
  kFirstCheck,      ///< not checked since it was calibrated
  kCheck,           ///< the last check that passed is old
  kInspect,         ///< the last check found it drifting
  kCalibrateAgain,  ///< the last check asked for a new calibration, or the calibration is unfit
  kRepair,          ///< a file of its reference is missing, cut or of another camera
  kRepeat,          ///< numbers or reference changed: calibrate again from the stored presses
  kEvidence,        ///< the calibration is unproven: add presses
  kMorePresses,     ///< the last check had too few presses
};
/// "nothing", "recording", ...: for files, streams and programs.
[[nodiscard]] std::string_view to_string(FingerDue due);

struct DueEvidence {
  bool needs_recording = true;  ///< a Fin Ray finger; a flat sensor has an image
  bool has_mapping = false;
  ReferenceState reference = ReferenceState::kAbsent;
  std::optional<Grade> grade;         ///< of the calibration; empty: none is stored
  bool must_repeat = false;           ///< numbers or reference are not those of the calibration
  std::optional<CheckVerdict> check;  ///< the last one of this calibration
  std::optional<double> check_days;   ///< since then; empty: unknown
};
/// A check is due again after so many days.
inline constexpr int kCheckEveryDays = 7;
[[nodiscard]] FingerDue due_of(const DueEvidence& evidence);

// Coverage of a face by presses, which limits the evidence for its parts.

/// Distribution of a calibration's presses over the face.
struct PressCoverage {
  /// Distinct positions: contacts whose middles are further apart than the larger one's radius.
  /// Closer contacts share more than a third of their area, and with it light, layer and camera.
  /// They count as repeats.
  int positions = 0;
  std::array<int, 3> thirds = {};  ///< of them in base, middle, tip (flat: left, middle, right)
  /// Cost of predicting from a straight line along the face through the positions, in variances of
  /// one position, as the mean over the face: 1 / n + mean((s - mean s)^2) / sum((s - mean s)^2),
  /// at most kMaxLeverage. 0 with one position.
  double leverage = 0;
};
inline constexpr double kMaxLeverage = 16;

/// Position of one contact on the face, mm.
struct ContactSpot {
  double along_mm = 0, across_mm = 0;
  double radius_mm = 0;       ///< of the contact's rim
  double face_length_mm = 0;  ///< visible to the camera
};
/// The distinct position of each, numbered from 0. Which contacts share one does not depend on the
/// order.
[[nodiscard]] std::vector<int> position_numbers(const std::vector<ContactSpot>& spots);

/// The order does not matter.
[[nodiscard]] PressCoverage coverage_of(std::vector<ContactSpot> spots);

}  // namespace alltact
