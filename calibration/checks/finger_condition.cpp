#include "calibration/checks/finger_condition.h"

namespace alltact {

std::optional<CheckEntry> last_check(const FingerSnapshot& snapshot) {
  const auto history = load_checks(snapshot.folder, nullptr);
  if (!history) return std::nullopt;
  const CheckEntry* latest = latest_check(*history, snapshot.finger);
  if (latest == nullptr) return std::nullopt;
  CheckEntry entry = *latest;
  // Earlier versions passed with any number of presses.
  if (entry.verdict == CheckVerdict::kPass && entry.presses < kCheckPresses)
    entry.verdict = CheckVerdict::kTooFew;
  return entry;
}

FingerCondition condition_of(const FingerSnapshot& snapshot, const std::string& now) {
  FingerCondition condition;
  condition.check = last_check(snapshot);
  const bool has_passed = condition.check && condition.check->verdict == CheckVerdict::kPass;
  const CalibrationEvidence evidence =
      evidence_in(snapshot, now, has_passed ? condition.check->time : std::string());
  condition.reference = evidence.reference;
  const Finger& finger = snapshot.finger;
  if (finger.mapping && finger.mapping_record) {
    condition.verdict = verdict(evidence);
    condition.must_repeat = !evidence.changed.empty() || evidence.reference_is_newer;
  }
  DueEvidence due;
  due.needs_recording = finger.face.kind == FaceKind::kFinRay;
  due.has_mapping = finger.mapping.has_value();
  due.reference = condition.reference;
  if (condition.verdict) due.grade = condition.verdict->grade;
  due.must_repeat = condition.must_repeat;
  if (condition.check) {
    due.check = condition.check->verdict;
    due.check_days = days_between(condition.check->time, now);
  }
  condition.due = due_of(due);
  return condition;
}

}  // namespace alltact
