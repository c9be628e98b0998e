#include "widgets/shell/finger_card.h"

#include "calibration/checks/check_history.h"
#include "calibration/finger/calibration_inputs.h"
#include "core/finger/finger_store.h"

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr int kPictureHeight = 144;  // twice what is shown, for fine screens
constexpr double kDay_s = 86400;

/// The first press, or the untouched picture of a flat sensor.
fs::path picture_of(const fs::path& folder, const Finger& finger) {
  if (const auto presses = kept_presses(folder); presses && !presses->empty())
    return presses->front();
  if (finger.reference && !finger.reference->image.empty()) return folder / finger.reference->image;
  return {};
}

FingerDue due_of(const Finger& finger,
                 const std::optional<CheckEntry>& check,
                 const std::string& now) {
  const bool needs_recording = finger.face.kind == FaceKind::kFinRay;
  if (needs_recording && !finger.reference) return FingerDue::kRecording;
  if (!finger.mapping) return FingerDue::kCalibration;
  if (!check) return FingerDue::kFirstCheck;
  if (check->verdict == CheckVerdict::kRecalibrate) return FingerDue::kAgain;
  if (check->verdict == CheckVerdict::kDrifting) return FingerDue::kLook;
  const auto then_s = seconds_of(check->time), now_s = seconds_of(now);
  return then_s && now_s && *now_s - *then_s > kCheckEveryDays * kDay_s ? FingerDue::kCheck
                                                                        : FingerDue::kNothing;
}

}  // namespace

std::optional<FingerCard> read_finger_card(const fs::path& folder, const std::string& now) {
  const auto opened = open_finger(folder);
  if (!opened) return std::nullopt;
  const Finger& finger = (*opened)->finger;
  FingerCard card;
  card.folder = folder;
  card.name = finger.name.empty() ? folder.filename().string() : finger.name;
  std::optional<CheckEntry> check;
  if (finger.mapping) {
    if (const auto date = finger.provenance.find("calibration_date");
        date != finger.provenance.end())
      card.calibrated_on = date->second;
    if (const auto history = load_checks(folder, nullptr))
      if (const CheckEntry* latest = latest_check(*history, finger)) check = *latest;
  }
  if (check) {
    card.checked_on = check->time;
    card.checked_mm = check->error_mm;
  }
  if (const auto& record = finger.mapping_record) {
    const Verdict worth = verdict({record->residual_mm,
                                   record->held_out_mm,
                                   record->spread_mm,
                                   static_cast<int>(record->presses.size()),
                                   record->pixel_mm});
    card.grade = worth.grade;
    card.error_mm = worth.error_mm;
  }
  card.due = due_of(finger, check, now);
  if (const fs::path file = picture_of(folder, finger); !file.empty())
    if (const QImage whole(QString::fromStdString(file.string())); !whole.isNull())
      card.picture = whole.scaledToHeight(kPictureHeight, Qt::SmoothTransformation)
                         .convertToFormat(QImage::Format_RGB32);
  return card;
}

}  // namespace alltact
