#include "widgets/shell/finger_card.h"

#include "calibration/checks/finger_worth.h"
#include "calibration/finger/calibration_inputs.h"
#include "core/finger/finger_store.h"
#include "widgets/verdict_text.h"

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr int kImageHeight = 144;  // twice the shown height, for dense screens

/// The first press, or the reference image of a flat sensor.
fs::path image_file_of(const fs::path& folder, const Finger& finger) {
  if (const auto presses = stored_presses(folder); presses && !presses->empty())
    return presses->front();
  if (finger.reference && !finger.reference->image.empty()) return folder / finger.reference->image;
  return {};
}

}  // namespace

std::optional<FingerCard> read_finger_card(const fs::path& folder, const std::string& now) {
  const auto opened = open_finger(folder);
  if (!opened) return std::nullopt;
  const Finger& finger = (*opened)->finger;
  FingerCard card;
  card.folder = folder;
  card.name = finger.name.empty() ? folder.filename().string() : finger.name;
  const FingerWorth state = worth_of(**opened, now);
  if (finger.mapping)
    if (const auto date = finger.provenance.find("calibration_date");
        date != finger.provenance.end())
      card.calibrated_on = date->second;
  if (state.check) {
    card.checked_on = state.check->time;
    card.checked_mm = state.check->error_mm;
  }
  if (state.verdict) {
    card.grade = state.verdict->grade;
    const Verdict worth = window_verdict(*state.evidence);
    card.error_mm = expected_error_mm(worth).value_or(0.0);
    card.findings = findings_of(worth, state.evidence->contradictions);
    if (!worth.missing_names.empty()) card.lacks = worth.missing_names.front();
    card.rests_on = worth.rests_on;
  }
  card.reference = state.reference;
  card.is_recorded = finger.face.kind == FaceKind::kFinRay;
  card.must_repeat = state.must_repeat;
  if (const Message broken = sentence(state.reference);
      state.due == FingerDue::kRepair && card.findings.empty())
    card.findings = {broken};
  if (finger.reference)
    for (const std::string& name :
         {finger.reference->image, finger.reference->video, finger.reference->markers})
      if (!name.empty()) card.files.push_back(folder / name);
  card.due = state.due;
  if (const fs::path file = image_file_of(folder, finger); !file.empty())
    if (const QImage full_image(QString::fromStdString(file.string())); !full_image.isNull())
      card.image = full_image.scaledToHeight(kImageHeight, Qt::SmoothTransformation)
                       .convertToFormat(QImage::Format_RGB32);
  return card;
}

}  // namespace alltact
