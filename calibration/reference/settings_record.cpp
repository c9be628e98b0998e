#include "calibration/reference/settings_record.h"

namespace alltact {
namespace {

std::string stored(const Finger& finger, const char* key) {
  const auto found = finger.provenance.find(key);
  return found == finger.provenance.end() ? std::string() : found->second;
}

}  // namespace

std::vector<Message> record_settings(const SettingsMonitor& seen,
                                     RecordingKind kind,
                                     Finger& finger) {
  const bool is_reference = kind == RecordingKind::kReference;
  const char* key = is_reference ? kReferenceSettings : kPressSettings;
  const Message reference = en::say("reference"), presses = en::say("presses");
  const Message taken = is_reference ? reference : en::say("set of presses");
  std::vector<Message> warnings;
  if (!seen.change().empty())
    warnings.push_back(
        en::say("The {} was not taken with one setting of camera and light: {}. Lock them, and "
                "record it again.",
                taken,
                seen.change()));
  const Message other =
      differences(stored(finger, is_reference ? kPressSettings : kReferenceSettings), seen.first());
  if (!other.empty())
    warnings.push_back(
        en::say("The {} and the {} were taken with other settings: {}. Depth comes from "
                "comparing their brightness: record one of them again.",
                is_reference ? reference : presses,
                is_reference ? presses : reference,
                other));
  if (seen.first().empty()) {
    finger.provenance.erase(key);
  } else {
    finger.provenance[key] = seen.first();
  }
  return warnings;
}

Message other_settings_than_stored(const Frame& frame, const Finger& finger) {
  if (frame.controls == nullptr) return {};
  std::string before = stored(finger, kPressSettings);
  if (before.empty()) before = stored(finger, kReferenceSettings);
  const Message other = differences(before, *frame.controls);
  if (other.empty()) return {};
  return en::say(
      "The finger was calibrated with other settings: {}. Set them as they were, or calibrate "
      "again.",
      other);
}

}  // namespace alltact
