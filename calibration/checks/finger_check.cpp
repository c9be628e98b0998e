#include "calibration/checks/finger_check.h"

#include "calibration/finger/calibration_inputs.h"
#include "calibration/finger/calibration_report.h"
#include "core/finger/force_model.h"
#include "core/sensing/reference/reference_library.h"

#include <algorithm>
#include <array>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// Fewer frames leave gaps between the poses of a bending finger.
constexpr std::size_t kPlentyOfFrames = 40;

CheckItem check_reference(const FingerSnapshot& snapshot, const Job& job) {
  const Finger& finger = snapshot.finger;
  const bool flat = finger.face.kind == FaceKind::kFlat;
  if (!finger.reference) {
    return {"reference", CheckState::kMissing,
            flat ? en::say("no untouched image; specify it with --reference to calibrate")
                 : en::say("no recording of the untouched finger bending; run alltact reference")};
  }
  const ReferenceState state = reference_state(snapshot);
  if (state == ReferenceState::kMissing || state == ReferenceState::kCut ||
      state == ReferenceState::kOtherImage)
    return {"reference", CheckState::kMissing, sentence(state)};
  const auto library = ReferenceLibrary::load(snapshot, job);
  if (!library)
    return {"reference", CheckState::kMissing, en::say("{}.", library.error().message())};
  if (flat) return {"reference", CheckState::kFine, en::say("one untouched image")};
  const std::size_t count = library->frame_count();
  if (count < kPlentyOfFrames) {
    return {
        "reference", CheckState::kWeak,
        en::say("only {} frames; poses between them are estimates, record more bending", count)};
  }
  return {"reference", CheckState::kFine, en::count("{} frames", "{} frame", count)};
}

CheckItem check_markers(const Finger& finger) {
  if (!finger.contact) {
    return {
        "markers", CheckState::kMissing,
        en::say("no layout at rest, so contact cannot be detected; run alltact reference again")};
  }
  if (finger.reference && finger.reference->positions)
    return {"markers", CheckState::kWeak,
            en::say("none; the pose comes from the shape of the face, which hides twist")};
  return {"markers", CheckState::kFine,
          en::say("{} markers; contact is detected from {:.1f} px of summed offset",
                  finger.marker_count() - static_cast<int>(finger.markers.missing.size()),
                  finger.contact->threshold_px)};
}

/// `worth`: empty without a record of the calibration.
CheckItem check_mapping(const Finger& finger, const std::optional<Verdict>& worth) {
  if (!finger.mapping) {
    return {"mapping", CheckState::kMissing,
            en::say("not calibrated; run alltact calibrate with ball presses")};
  }
  if (!worth) {
    return {"mapping", CheckState::kWeak,
            en::say("its origin and quality are not recorded; run alltact calibrate again")};
  }
  const CheckState state = worth->grade == Grade::kUnfit  ? CheckState::kMissing
                           : worth->grade == Grade::kGood ? CheckState::kFine
                                                          : CheckState::kWeak;
  return {"mapping", state, worth->sentence};
}

/// The inputs of the calibration must equal the current ones.
CheckItem check_numbers(const Verdict& worth) {
  for (std::size_t i = 0; i < worth.missing.size(); ++i)
    if (worth.missing_names[i] == "numbers_unchanged")
      return {"numbers", CheckState::kMissing, worth.missing[i]};
  return {"numbers", CheckState::kFine,
          worth.rests_on.empty() ? en::say("unchanged since the calibration") : worth.rests_on};
}

/// Both dates are UTC in one format, so their order as text is their order in time.
CheckItem check_age(const Finger& finger, const std::optional<CalibrationEvidence>& evidence) {
  const std::string reference = provenance_of(finger, "reference_date");
  const std::string calibration = provenance_of(finger, "calibration_date");
  if (evidence && evidence->reference_is_newer) {
    return {"calibration", CheckState::kStale,
            en::say("the reference ({}) is newer than the calibration ({}): {}", reference,
                    calibration, evidence->repeat_command)};
  }
  return {
      "calibration", CheckState::kFine,
      calibration.empty() ? en::say("made on an unknown date") : en::say("made {}", calibration)};
}

CheckItem check_inputs(const fs::path& folder, const Finger& finger) {
  const auto inputs = CalibrationInputs::load(folder);
  if (!inputs)
    return {"presses", CheckState::kWeak,
            en::say("the calibration cannot be repeated: {}.", inputs.error().message())};
  const auto gone =
      std::count_if(inputs->presses.begin(), inputs->presses.end(), [&](const StoredPress& press) {
        std::error_code failed;
        return !fs::exists(stored_press_file(folder, press.name), failed);
      });
  if (gone > 0)
    return {"presses", CheckState::kWeak,
            en::say("{} of {} press images are missing, so the calibration cannot be repeated",
                    gone, inputs->presses.size())};
  if (inputs->date != provenance_of(finger, "calibration_date"))
    return {"presses", CheckState::kStale,
            en::say("the stored data is of an interrupted calibration; complete it with {}",
                    repeat_command(folder))};
  return {"presses", CheckState::kFine, en::say("{} images stored", inputs->presses.size())};
}

CheckItem check_force(const FingerSnapshot& snapshot) {
  if (snapshot.force_problem)
    return {"force", CheckState::kWeak, en::say("{}.", snapshot.force_problem->message())};
  if (const Status belongs = snapshot.force->belongs_to(snapshot.finger); !belongs)
    return {"force", CheckState::kStale, en::say("{}.", belongs.error().message())};
  const std::string trained = provenance_of(snapshot.finger, "force_date");
  const std::string kind = to_string(snapshot.force->kind);
  return {"force", CheckState::kFine,
          trained.empty() ? en::say("{}, trained at an unknown date", kind)
                          : en::say("{}, trained {}", kind, trained)};
}

/// The last check of the finger's current calibration. A pass with too few presses, which earlier
/// versions gave, counts as none.
std::optional<CheckEntry> last_check(const FingerSnapshot& snapshot) {
  const auto history = load_checks(snapshot.folder, nullptr);
  if (!history) return std::nullopt;
  const CheckEntry* latest = latest_check(*history, snapshot.finger);
  if (latest == nullptr) return std::nullopt;
  CheckEntry entry = *latest;
  entry.verdict = verdict_now(entry);
  return entry;
}

}  // namespace

std::string_view to_string(CheckState state) {
  constexpr std::array<std::string_view, 4> kWords{"fine", "weak", "stale", "missing"};
  return kWords.at(static_cast<std::size_t>(state) - 1);
}

FingerCheck check_finger(const FingerSnapshot& snapshot, const Job& job, const std::string& now) {
  const Finger& finger = snapshot.finger;
  const FingerWorth worth = worth_of(snapshot, now);
  FingerCheck check;
  check.verdict = worth.verdict;
  check.items.push_back({"camera", CheckState::kFine,
                         en::say("{}, {} x {} px", std::string(to_string(finger.camera.model)),
                                 finger.camera.width_px, finger.camera.height_px)});
  check.items.push_back(check_reference(snapshot, job));
  if (finger.face.kind == FaceKind::kFinRay) check.items.push_back(check_markers(finger));
  check.items.push_back(check_mapping(finger, worth.verdict));
  if (worth.verdict) check.items.push_back(check_numbers(*worth.verdict));
  if (finger.mapping) check.items.push_back(check_age(finger, worth.evidence));
  if (finger.mapping_record) check.items.push_back(check_inputs(snapshot.folder, finger));
  if (!finger.force_model.empty() && (snapshot.force || snapshot.force_problem))
    check.items.push_back(check_force(snapshot));
  check.fit = std::none_of(check.items.begin(), check.items.end(), [](const CheckItem& item) {
    return item.state == CheckState::kMissing;
  });
  return check;
}

FingerWorth worth_of(const FingerSnapshot& snapshot, const std::string& now) {
  FingerWorth worth;
  worth.check = last_check(snapshot);
  const bool has_passed = worth.check && worth.check->verdict == CheckVerdict::kPass;
  const CalibrationEvidence evidence =
      evidence_in(snapshot, now, has_passed ? worth.check->time : std::string());
  worth.reference = evidence.reference;
  const Finger& finger = snapshot.finger;
  if (finger.mapping && finger.mapping_record) {
    worth.evidence = evidence;
    worth.verdict = verdict(evidence);
    worth.must_repeat = !evidence.changed.empty() || evidence.reference_is_newer;
  }
  DueEvidence due;
  due.needs_recording = finger.face.kind == FaceKind::kFinRay;
  due.has_mapping = finger.mapping.has_value();
  due.reference = worth.reference;
  if (worth.verdict) due.grade = worth.verdict->grade;
  due.must_repeat = worth.must_repeat;
  if (worth.check) {
    due.check = worth.check->verdict;
    due.check_days = days_between(worth.check->time, now);
  }
  worth.due = due_of(due);
  return worth;
}

}  // namespace alltact
