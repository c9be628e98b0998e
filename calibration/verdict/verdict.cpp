#include "calibration/verdict/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace alltact {
namespace {

constexpr std::array kContradictionWords{
    std::string_view("contact_wider_than_ball"), std::string_view("contact_deeper_than_layer"),
    std::string_view("depth_beyond_mapping"), std::string_view("face_width_against_camera"),
    std::string_view("reference_touched")};

/// "2.17 to 2.44 mm", "2.17 mm".
Message range_mm(const Contradiction& one) {
  return one.measured_to_mm > one.measured_mm + 0.005
             ? en::say("{:.2f} to {:.2f} mm", one.measured_mm, one.measured_to_mm)
             : en::say("{:.2f} mm", one.measured_mm);
}

}  // namespace

std::string_view to_string(ContradictionKind kind) {
  return kContradictionWords.at(static_cast<std::size_t>(kind) - 1);
}

bool rules_out_use(ContradictionKind kind) {
  // Every depth is in proportion to the ball's radius and to the face's width.
  return kind == ContradictionKind::kContactWiderThanBall ||
         kind == ContradictionKind::kFaceWidthAgainstCamera;
}

Message sentence(const Contradiction& one) {
  const std::size_t count = std::max<std::size_t>(1, one.presses.size());
  const int of = std::max(one.of, static_cast<int>(count));
  switch (one.kind) {
    case ContradictionKind::kContactWiderThanBall:
      return en::count(
          "{0} of {1} presses have a dark part wider than the ball of {2:.2f} mm diameter "
          "({3} radius): check the ball's radius",
          "{0} of {1} presses has a dark part wider than the ball of {2:.2f} mm diameter "
          "({3} radius): check the ball's radius",
          count, of, 2 * one.given_mm, range_mm(one));
    case ContradictionKind::kContactDeeperThanLayer:
      return en::count(
          "{0} of {1} presses are deeper than the layer of {2:.2f} mm ({3}): check the layer's "
          "thickness and the ball's radius",
          "{0} of {1} presses is deeper than the layer of {2:.2f} mm ({3}): check the layer's "
          "thickness and the ball's radius",
          count, of, one.given_mm, range_mm(one));
    case ContradictionKind::kDepthBeyondMapping:
      return en::count(
          "{0} of {1} presses are darker than the mapping reaches ({3} deep, the mapping ends at "
          "{2:.2f} mm): calibrate again with them",
          "{0} of {1} presses is darker than the mapping reaches ({3} deep, the mapping ends at "
          "{2:.2f} mm): calibrate again with it",
          count, of, one.given_mm, range_mm(one));
    case ContradictionKind::kFaceWidthAgainstCamera:
      return en::say(
          "the specified face width is {:.2f} mm, but camera and presses show {}: check the width "
          "and the lens",
          one.given_mm, range_mm(one));
    case ContradictionKind::kReferenceContact:
      break;
  }
  return en::say(
      "in {} of {} presses the face is brighter than its reference {:.0f} mm along it: something "
      "pressed there when the reference was recorded; record it again, then calibrate again",
      count, of, one.measured_mm);
}

RecordedContradiction recorded(const Contradiction& one) {
  return {std::string(to_string(one.kind)),
          static_cast<int>(one.presses.size()),
          one.of,
          one.given_mm,
          one.measured_mm,
          one.measured_to_mm};
}

namespace {

/// nullopt for a kind of a later version.
std::optional<Contradiction> from_record(const RecordedContradiction& recorded) {
  const auto* word =
      std::find(kContradictionWords.begin(), kContradictionWords.end(), recorded.kind);
  if (word == kContradictionWords.end()) return std::nullopt;
  Contradiction one;
  one.kind = static_cast<ContradictionKind>(word - kContradictionWords.begin() + 1);
  one.presses.resize(static_cast<std::size_t>(std::max(0, recorded.presses)));
  one.given_mm = recorded.given_mm;
  one.measured_mm = recorded.measured_mm;
  one.measured_to_mm = recorded.measured_to_mm;
  one.of = recorded.of;
  return one;
}

// A spread from n positions has n - 1 degrees of freedom. Its 95 % upper bound is 4.4 times the
// estimate with 2, 2.9 with 3, 2.4 with 4: below 3 a small error on presses left out proves
// nothing.
constexpr int kGoodPresses = 4;
// Two positions fix a line along the face, the third is the first that can contradict it.
constexpr int kGoodPositions = 3;
// Smaller depth ratios separate offset and scale of the curve by the balls' curvature alone: the
// ratio's sd is then above 1 at 2 % of error in each press.
constexpr double kDepthRatio = 1.15;
// The interval at which measuring instruments are calibrated where nothing else is known (ILAC-G24,
// "staircase" method's typical start).
constexpr double kCalibrationDays = 365;
// Half of the presses may be wrong before a robust estimate breaks down.
constexpr double kMaxLeftOut = 0.5;

double square(double x) { return x * x; }

/// Neither a depth nor a step was measured, which alone show the effect of scattered light on the
/// scale. Balls of two radii agree with each other in spite of it.
bool is_scale_from_balls_alone(const std::vector<double>& radii_mm) {
  return std::find(radii_mm.begin(), radii_mm.end(), 0.0) == radii_mm.end();
}

std::vector<ErrorPart> parts_of(const CalibrationEvidence& e) {
  const double student = student_factor(e.positions - 1);
  const double shape = student * (e.held_out_mm > 0 ? e.held_out_mm : e.residual_mm);
  const double pixel = kMeanOfSd * e.pixel_sd_mm;
  // Presses spread evenly over the face have 2 / n: of the mean and of the slope.
  const double even = e.positions > 0 ? 2.0 / e.positions : 0.0;
  const double excess = e.position_leverage - even;
  const double leverage = excess <= 0 ? 0.0 : excess;  // NaN stays NaN
  const double depth_mm = mean_depth_mm(e.shallowest_mm, e.deepest_mm);
  double radius = 0;
  for (const double radius_mm : e.ball_radii_mm) {
    if (radius_mm == 0) continue;
    const double part = std::abs(e.depth_per_radius) * kRadiusSdMm / radius_mm * depth_mm;
    if (!(part <= radius)) radius = part;
  }
  const double undetected = e.undetected_spread < kSpreadTestDoubt  // NaN stays NaN
                                ? kSpreadTestDoubt
                                : e.undetected_spread;
  const double body = is_scale_from_balls_alone(e.ball_radii_mm)
                          ? std::sqrt(undetected) * kBodyShare * depth_mm
                          : 0.0;
  // An undetermined scale makes depths wrong by their own size at most.
  const double scale = student * kMeanOfSd * e.scale_sd_mm;
  const bool is_bounded = depth_mm > 0 && scale > depth_mm;
  std::vector<ErrorPart> parts{
      shape >= pixel ? ErrorPart{ErrorCause::kShape, shape} : ErrorPart{ErrorCause::kPixel, pixel},
      {ErrorCause::kScale, is_bounded ? depth_mm : scale},
      {ErrorCause::kZone, shape * std::sqrt(leverage)},
      {ErrorCause::kHalo, kHaloWeight * e.halo_mm},
      {ErrorCause::kRadius, radius},
      {ErrorCause::kBody, body}};
  if (!std::isfinite(pixel) || !std::isfinite(shape))
    parts.push_back({ErrorCause::kShape, std::numeric_limits<double>::infinity()});
  for (ErrorPart& part : parts)
    if (!std::isfinite(part.error_mm)) part.error_mm = std::numeric_limits<double>::infinity();
  std::erase_if(parts, [](const ErrorPart& part) { return part.error_mm == 0; });
  std::stable_sort(parts.begin(), parts.end(),
                   [](const ErrorPart& a, const ErrorPart& b) { return a.error_mm > b.error_mm; });
  return parts;
}

/// The largest part, and what reduces it.
Message largest_cause(ErrorCause cause) {
  static const std::array kWords{
      en::say("mostly the curve's shape: add presses of different depth and position"),
      en::say("mostly scale: measure one press's depth"),
      en::say("mostly noise and reference of single pixels: record the reference again, "
              "with more light"),
      en::say("mostly parts of the face far from any press: press there"),
      en::say("mostly depth measured next to contacts, as caused by light that scatters sideways"),
      en::say("mostly the ball's radius: measure it to a hundredth of a millimetre"),
      en::say("mostly bodies of other shape than the ball: measure one press's depth")};
  return kWords.at(static_cast<std::size_t>(cause) - 1);
}

Message missing_thirds(const CalibrationEvidence& e, double /*error_mm*/) {
  std::vector<Message> empty;
  for (std::size_t i = 0; i < e.thirds.size(); ++i)
    if (e.thirds[i] == 0) empty.push_back(third_name(e.is_flat, i));
  const Message names = en::list(empty);
  return empty.size() == 1 ? en::say("no press in the {} third; press there once", names)
                           : en::say("no press in these thirds: {}; press once in each", names);
}

Message contradictions(const CalibrationEvidence& e, bool ruling_out) {
  std::vector<Message> all;
  for (const Contradiction& one : e.contradictions)
    if (rules_out_use(one.kind) == ruling_out) all.push_back(sentence(one));
  return en::clauses(all);
}

bool has_contradiction(const CalibrationEvidence& e, bool ruling_out) {
  return std::any_of(e.contradictions.begin(), e.contradictions.end(),
                     [&](const auto& one) { return rules_out_use(one.kind) == ruling_out; });
}

Message changed_numbers(const CalibrationEvidence& e, double /*error_mm*/) {
  const Message names = enumerated(e.changed);
  return e.changed.size() == 1
             ? en::say("{} was changed since the calibration: {}", names, e.repeat_command)
             : en::say("{} were changed since the calibration: {}", names, e.repeat_command);
}

Message newer_reference(const CalibrationEvidence& e, double /*error_mm*/) {
  return en::say("the reference is newer than the calibration: {}", e.repeat_command);
}

using Evidence = CalibrationEvidence;

}  // namespace

Message sentence(ReferenceState state) {
  static const std::array kWords{
      Message(), en::say("there is no reference: record one"),
      en::say("a file of the reference is missing: restore it, or record the reference again"),
      en::say("the reference is cut off or unreadable: record it again"),
      en::say("the reference has another image size than the camera: record it again")};
  return kWords.at(static_cast<std::size_t>(state) - 1);
}

std::string_view to_string(Grade grade) {
  constexpr std::array<std::string_view, 4> kWords{"good", "usable", "unproven", "unfit"};
  return kWords.at(static_cast<std::size_t>(grade) - 1);
}

Message word_of(Grade grade) {
  static const std::array kWords{en::say("good"), en::say("usable for contact and its position"),
                                 en::say("unproven"), en::say("unfit for measuring")};
  return kWords.at(static_cast<std::size_t>(grade) - 1);
}

std::string_view to_string(ErrorCause cause) {
  constexpr std::array<std::string_view, 7> kWords{"shape", "scale",  "pixel", "zone",
                                                   "halo",  "radius", "body"};
  return kWords.at(static_cast<std::size_t>(cause) - 1);
}

std::string_view to_string(CheckVerdict verdict) {
  constexpr std::array<std::string_view, 4> kWords{"pass", "drifting", "recalibrate", "too_few"};
  return kWords.at(static_cast<std::size_t>(verdict) - 1);
}

Message word_of(CheckVerdict verdict) {
  static const std::array kWords{en::say("pass"), en::say("drifting"), en::say("recalibrate"),
                                 en::say("too few to judge")};
  return kWords.at(static_cast<std::size_t>(verdict) - 1);
}

Message enumerated(const std::vector<Message>& names) {
  if (names.size() < 2) return en::list(names);
  const Message first = en::list({names.begin(), names.end() - 1});
  return en::say("{} and {}", first, names.back());
}

Message third_name(bool is_flat, std::size_t third) {
  if (third == 1) return en::say("middle");
  if (third == 0) return is_flat ? en::say("left") : en::say("base");
  return is_flat ? en::say("right") : en::say("tip");
}

std::string_view to_string(FingerDue due) {
  constexpr std::array<std::string_view, 11> kWords{
      "nothing", "recording", "calibration", "first_check", "check",       "look",
      "again",   "repair",    "repeat",      "evidence",    "more_presses"};
  return kWords.at(static_cast<std::size_t>(due) - 1);
}

double student_factor(int freedom) {
  const double n = std::max(1, freedom);
  // Of z = 1: t = z + (z^3 + z) / 4n + (5 z^5 + 16 z^3 + 3 z) / 96 n^2 + (3 z^7 + 19 z^5 + 17 z^3 -
  // 15 z) / 384 n^3.
  return 1 + 0.5 / n + 0.25 / (n * n) + 0.0625 / (n * n * n);
}

std::string provenance_of(const Finger& finger, const char* key) {
  const auto found = finger.provenance.find(key);
  return found == finger.provenance.end() ? std::string() : found->second;
}

CalibrationEvidence evidence_of(const Finger& finger) {
  CalibrationEvidence evidence;
  evidence.is_flat = finger.face.kind == FaceKind::kFlat;
  evidence.layer_mm = finger.face.layer_mm;
  const CameraParameters& camera = finger.camera;
  if (!evidence.is_flat)
    evidence.width_mm = finger.face.width_mm;
  else if (camera.model == CameraModel::kOrthographic)
    evidence.width_mm = camera.mm_per_px * camera.width_px;
  if (!finger.mapping || !finger.mapping_record) return evidence;
  const MappingRecord& record = *finger.mapping_record;
  evidence.presses = static_cast<int>(record.presses.size());
  evidence.residual_mm = record.residual_mm;
  evidence.held_out_mm = record.held_out_mm;
  evidence.scale_sd_mm = record.spread_mm / kMeanOfSd;
  evidence.pixel_sd_mm =
      std::sqrt(std::max(0.0, square(record.pixel_mm) - square(record.spread_mm))) / kMeanOfSd;
  // Both are UTC in one format, so that their order as text is their order in time.
  evidence.reference_is_newer =
      provenance_of(finger, "reference_date") > provenance_of(finger, "calibration_date");
  if (!record.basis) return evidence;
  const CalibrationBasis& basis = *record.basis;
  evidence.has_basis = true;
  evidence.positions = basis.positions;
  evidence.thirds = basis.thirds;
  evidence.shallowest_mm = basis.shallowest_mm;
  evidence.deepest_mm = basis.deepest_mm;
  evidence.scale_sd_mm = basis.scale_sd_mm;
  evidence.pixel_sd_mm = basis.pixel_sd_mm;
  evidence.halo_mm = basis.halo_mm;
  evidence.undetected_spread = basis.undetected_spread;
  evidence.position_leverage = basis.position_leverage;
  evidence.depth_per_radius = basis.depth_per_radius;
  evidence.ball_radii_mm = basis.ball_radii_mm;
  evidence.layer_mm = basis.layer_mm;
  if (!evidence.is_flat) evidence.width_mm = basis.width_mm;
  evidence.left_out = basis.left_out;
  evidence.is_complete = basis.is_complete;
  for (const RecordedContradiction& recorded : basis.contradictions)
    if (auto one = from_record(recorded)) evidence.contradictions.push_back(std::move(*one));
  if (basis.width_mm != finger.face.width_mm) evidence.changed.push_back(en::say("width"));
  if (basis.layer_mm != finger.face.layer_mm) evidence.changed.push_back(en::say("layer"));
  if (basis.plane_z_mm != finger.face.plane_z_mm)
    evidence.changed.push_back(en::say("distance of the face"));
  if (basis.camera != camera_fingerprint(finger.camera))
    evidence.changed.push_back(en::say("camera or lens"));
  return evidence;
}

const std::vector<Requirement>& calibration_requirements() {
  static const std::vector<Requirement> kRequirements{
      {"reference_whole", Grade::kUnfit,
       [](const Evidence& e, double) { return e.reference == ReferenceState::kIntact; },
       [](const Evidence& e, double) { return sentence(e.reference); }},
      {"numbers_unchanged", Grade::kUnfit,
       [](const Evidence& e, double) { return e.changed.empty(); }, changed_numbers},
      {"ball_possible", Grade::kUnfit,
       [](const Evidence& e, double) { return !has_contradiction(e, true); },
       [](const Evidence& e, double) { return contradictions(e, true); }},
      {"error_usable", Grade::kUnfit,
       // Too few positions are no evidence against the presses: see "positions" below.
       [](const Evidence& e, double error_mm) {
         const bool is_open = e.has_basis && e.positions < kGoodPositions && error_mm > 0;
         return error_mm <= kUsableErrorMm || (is_open && e.residual_mm <= kUsableErrorMm);
       },
       [](const Evidence&, double) {
         return en::say("press again with a clean ball of the given radius, entirely on the face");
       }},
      {"numbers_consistent", Grade::kUnproven,
       [](const Evidence& e, double) { return !has_contradiction(e, false); },
       [](const Evidence& e, double) { return contradictions(e, false); }},
      {"basis_stored", Grade::kUnproven, [](const Evidence& e, double) { return e.has_basis; },
       [](const Evidence& e, double) {
         return en::say("an earlier version calibrated it and stored too little: {}",
                        e.repeat_command);
       }},
      {"reference_older", Grade::kUnproven,
       [](const Evidence& e, double) { return !e.reference_is_newer; }, newer_reference},
      {"complete", Grade::kUnproven, [](const Evidence& e, double) { return e.is_complete; },
       [](const Evidence& e, double) {
         return en::say("the calibration was stopped before its end: {}", e.repeat_command);
       }},
      {"held_out", Grade::kUnproven,
       [](const Evidence& e, double) { return e.presses > 1 && e.held_out_mm > 0; },
       [](const Evidence& e, double) {
         return e.presses > 1 ? en::say("no press was left out to show the error on others")
                              : en::say(
                                    "one press cannot show the error on others; add presses of "
                                    "different depth");
       }},
      {"presses", Grade::kUnproven,
       [](const Evidence& e, double) { return e.presses >= kGoodPresses; },
       [](const Evidence& e, double) {
         return en::say("{} of {} presses needed; add more", e.presses, kGoodPresses);
       }},
      {"positions", Grade::kUnproven,
       [](const Evidence& e, double) { return !e.has_basis || e.positions >= kGoodPositions; },
       [](const Evidence& e, double) {
         return en::count("all presses are at {0} positions, {1} are needed; press at others",
                          "all presses are at {0} position, {1} are needed; press at others",
                          e.positions, kGoodPositions);
       }},
      {"thirds", Grade::kUnproven,
       [](const Evidence& e, double) {
         return !e.has_basis ||
                std::none_of(e.thirds.begin(), e.thirds.end(), [](int n) { return n == 0; });
       },
       missing_thirds},
      {"depths", Grade::kUnproven,
       [](const Evidence& e, double) {
         return !e.has_basis || e.deepest_mm >= kDepthRatio * e.shallowest_mm;
       },
       [](const Evidence& e, double) {
         return en::say("all presses are about {:.2f} mm deep; press shallower and deeper as well",
                        e.deepest_mm);
       }},
      {"scale_known", Grade::kUnproven,
       [](const Evidence& e, double) { return !e.has_basis || e.scale_sd_mm > 0; },
       [](const Evidence&, double) {
         return en::say("the presses do not show how certain the scale is; add presses");
       }},
      {"few_left_out", Grade::kUnproven,
       [](const Evidence& e, double) {
         return e.left_out <= kMaxLeftOut * (e.presses + e.left_out);
       },
       [](const Evidence& e, double) {
         return en::say("{} of {} presses had to be left out; find out why", e.left_out,
                        e.presses + e.left_out);
       }},
      {"fresh", Grade::kUnproven,
       [](const Evidence& e, double) {
         return !e.days_unchecked || *e.days_unchecked <= kCalibrationDays;
       },
       [](const Evidence& e, double) {
         return en::say("neither calibrated nor checked for {:.0f} days; check it with {} presses",
                        e.days_unchecked.value_or(0.0), kCheckPresses);
       }},
      {"error_good", Grade::kUsable,
       [](const Evidence&, double error_mm) { return error_mm <= kGoodErrorMm; },
       [](const Evidence&, double error_mm) {
         return error_mm <= kUsableErrorMm
                    ? en::say("fine relief needs an error of at most {:.2f} mm", kGoodErrorMm)
                    : Message();
       }},
  };
  return kRequirements;
}

namespace {

Message rests_on(const Evidence& e) {
  std::vector<Message> numbers;
  std::vector<double> radii_mm = e.ball_radii_mm;
  std::erase(radii_mm, 0.0);
  if (radii_mm.size() == 1) {
    numbers.push_back(en::say("ball of {:.2f} mm diameter", 2 * radii_mm.front()));
  } else if (radii_mm.size() > 1) {
    numbers.push_back(en::say("balls of {:.2f} to {:.2f} mm diameter", 2 * radii_mm.front(),
                              2 * radii_mm.back()));
  }
  if (e.has_basis) numbers.push_back(en::say("layer {:.2f} mm", e.layer_mm));
  if (e.has_basis && e.width_mm > 0)
    numbers.push_back(e.is_flat ? en::say("image {:.2f} mm wide", e.width_mm)
                                : en::say("face {:.2f} mm wide", e.width_mm));
  return en::list(numbers);
}

}  // namespace

Verdict verdict(const CalibrationEvidence& evidence) {
  Verdict result;
  result.parts = parts_of(evidence);
  double squares = 0;
  for (const ErrorPart& part : result.parts) squares += square(part.error_mm);
  result.error_mm = evidence.presses > 0 && std::isfinite(squares)
                        ? std::sqrt(squares)
                        : std::numeric_limits<double>::quiet_NaN();
  result.grade = Grade::kGood;
  for (const Requirement& requirement : calibration_requirements()) {
    if (requirement.is_met(evidence, result.error_mm)) continue;
    result.grade = std::max(result.grade, requirement.without);
    const Message missing = requirement.missing(evidence, result.error_mm);
    if (missing.empty()) continue;
    result.missing.push_back(missing);
    result.missing_names.push_back(requirement.name);
  }
  result.rests_on = rests_on(evidence);
  std::vector<Message> clauses = result.missing;  // contradictions come first
  if (std::isfinite(result.error_mm)) {
    if (!result.parts.empty()) result.cause = largest_cause(result.parts.front().cause);
    clauses.push_back(result.cause.empty()
                          ? en::say("expected error {:.3f} mm", result.error_mm)
                          : en::say("expected error {:.3f} mm, {}", result.error_mm, result.cause));
  } else {
    clauses.push_back(en::say("no expected error can be given"));
  }
  clauses.push_back(result.rests_on);
  result.reason = en::clauses(clauses);
  result.sentence = en::at(word_of(result.grade), result.reason);
  return result;
}

CheckVerdict check_verdict(const CheckEvidence& e) {
  // One press shows a clear failure; a pass needs more.
  if (e.reference_has_contact || !(e.error <= e.recalibrate_above) ||
      !(e.light_change <= e.light_recalibrate_above))
    return CheckVerdict::kRecalibrate;
  if (e.count < kCheckPresses || e.positions < kCheckPresses) return CheckVerdict::kTooFew;
  if (e.error > e.drifting_above || e.light_change > e.light_drifting_above)
    return CheckVerdict::kDrifting;
  return CheckVerdict::kPass;
}

FingerDue due_of(const DueEvidence& e) {
  const bool has_reference = e.reference != ReferenceState::kAbsent;
  if (e.needs_recording && !has_reference) return FingerDue::kRecording;
  if (has_reference && e.reference != ReferenceState::kIntact) return FingerDue::kRepair;
  if (!e.has_mapping || !has_reference) return FingerDue::kCalibration;
  if (e.must_repeat) return FingerDue::kRepeat;
  if (e.grade == Grade::kUnfit || e.check == CheckVerdict::kRecalibrate)
    return FingerDue::kCalibrateAgain;
  if (!e.grade || e.grade == Grade::kUnproven) return FingerDue::kEvidence;
  if (!e.check) return FingerDue::kFirstCheck;
  if (e.check == CheckVerdict::kDrifting) return FingerDue::kInspect;
  if (e.check == CheckVerdict::kTooFew) return FingerDue::kMorePresses;
  // A check from tomorrow was stamped by a wrong clock.
  if (!e.check_days || *e.check_days > kCheckEveryDays || *e.check_days < -1)
    return FingerDue::kCheck;
  return FingerDue::kNothing;
}

namespace {

bool is_before(const ContactSpot& a, const ContactSpot& b) {
  return std::tie(a.along_mm, a.across_mm, a.radius_mm) <
         std::tie(b.along_mm, b.across_mm, b.radius_mm);
}

bool is_same_position(const ContactSpot& a, const ContactSpot& b) {
  return std::hypot(a.along_mm - b.along_mm, a.across_mm - b.across_mm) <=
         std::max(a.radius_mm, b.radius_mm);
}

}  // namespace

std::vector<int> position_numbers(const std::vector<ContactSpot>& spots) {
  std::vector<std::size_t> order(spots.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return is_before(spots[i], spots[j]); });
  std::vector<int> numbers(spots.size(), 0);
  std::vector<std::size_t> first;  // of each position
  for (const std::size_t i : order) {
    const auto same = std::find_if(first.begin(), first.end(), [&](std::size_t other) {
      return is_same_position(spots[i], spots[other]);
    });
    numbers[i] = static_cast<int>(same - first.begin());
    if (same == first.end()) first.push_back(i);
  }
  return numbers;
}

PressCoverage coverage_of(std::vector<ContactSpot> spots) {
  std::sort(spots.begin(), spots.end(), is_before);
  const std::vector<int> numbers = position_numbers(spots);
  std::vector<ContactSpot> distinct;
  PressCoverage coverage;
  double length_mm = 0;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const ContactSpot& spot = spots[i];
    length_mm = std::max(length_mm, spot.face_length_mm);
    if (std::find(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(i), numbers[i]) !=
        numbers.begin() + static_cast<std::ptrdiff_t>(i))
      continue;
    distinct.push_back(spot);
    if (!(spot.face_length_mm > 0)) continue;
    const int third = static_cast<int>(std::floor(3.0 * spot.along_mm / spot.face_length_mm));
    ++coverage.thirds[static_cast<std::size_t>(std::clamp(third, 0, 2))];
  }
  coverage.positions = static_cast<int>(distinct.size());
  if (distinct.size() < 2 || !(length_mm > 0)) return coverage;
  const auto n = static_cast<double>(distinct.size());
  double mean = 0, squares = 0;
  for (const ContactSpot& spot : distinct) mean += spot.along_mm / n;
  for (const ContactSpot& spot : distinct)
    squares += (spot.along_mm - mean) * (spot.along_mm - mean);
  // Over a face from 0 to its length.
  const double apart = 0.5 * length_mm - mean;
  const double mean_square = apart * apart + length_mm * length_mm / 12;
  coverage.leverage =
      std::min(kMaxLeverage, 1 / n + (squares > 0 ? mean_square / squares : kMaxLeverage));
  return coverage;
}

}  // namespace alltact
