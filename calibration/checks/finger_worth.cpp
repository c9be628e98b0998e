#include "calibration/checks/finger_worth.h"

namespace alltact {

std::optional<CheckEntry> last_check(const FingerSnapshot& snapshot) {
  const auto history = load_checks(snapshot.folder, nullptr);
  if (!history) return std::nullopt;
  const CheckEntry* latest = latest_check(*history, snapshot.finger);
  if (latest == nullptr) return std::nullopt;
  CheckEntry entry = *latest;
  entry.verdict = verdict_now(entry);
  return entry;
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
