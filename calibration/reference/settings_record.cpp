#include "calibration/reference/settings_record.h"

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr const char* kReferenceKey = "reference_settings";
constexpr const char* kPressKey = "press_settings";

std::string stored(const Finger& finger, const char* key) {
  const auto found = finger.provenance.find(key);
  return found == finger.provenance.end() ? std::string() : found->second;
}

}  // namespace

std::vector<std::string> record_settings(const SettingsSeen& seen,
                                         RecordingKind kind,
                                         Finger& finger) {
  const bool is_reference = kind == RecordingKind::kReference;
  const char* key = is_reference ? kReferenceKey : kPressKey;
  const std::string name = is_reference ? "reference" : "presses";
  std::vector<std::string> warnings;
  if (!seen.change().empty())
    warnings.push_back(
        fmt::format("The {} was not taken with one setting of camera and light: {}. Lock them, and "
                    "record it again.",
                    is_reference ? "reference" : "set of presses",
                    seen.change()));
  const std::string other =
      differences(stored(finger, is_reference ? kPressKey : kReferenceKey), seen.first());
  if (!other.empty())
    warnings.push_back(
        fmt::format("The {} and the {} were taken with other settings: {}. Depth comes from "
                    "comparing their brightness: record one of them again.",
                    name,
                    is_reference ? "presses" : "reference",
                    other));
  if (seen.first().empty()) {
    finger.provenance.erase(key);
  } else {
    finger.provenance[key] = seen.first();
  }
  return warnings;
}

std::string other_settings_than_stored(const Frame& frame, const Finger& finger) {
  if (frame.controls == nullptr) return {};
  std::string before = stored(finger, kPressKey);
  if (before.empty()) before = stored(finger, kReferenceKey);
  const std::string other = differences(before, *frame.controls);
  if (other.empty()) return {};
  return fmt::format(
      "The finger was calibrated with other settings: {}. Set them as they were, or calibrate "
      "again.",
      other);
}

}  // namespace alltact
