#include "widgets/shell/finger_card.h"

#include "calibration/checks/finger_worth.h"
#include "calibration/finger/calibration_inputs.h"
#include "core/finger/finger_store.h"

#include <cmath>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr int kPictureHeight = 144;  // twice what is shown, for fine screens

/// The first press, or the untouched picture of a flat sensor.
fs::path picture_of(const fs::path& folder, const Finger& finger) {
  if (const auto presses = kept_presses(folder); presses && !presses->empty())
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
  const FingerWorth worth = worth_of(**opened, now);
  if (finger.mapping)
    if (const auto date = finger.provenance.find("calibration_date");
        date != finger.provenance.end())
      card.calibrated_on = date->second;
  if (worth.check) {
    card.checked_on = worth.check->time;
    card.checked_mm = worth.check->error_mm;
  }
  if (worth.verdict) {
    card.grade = worth.verdict->grade;
    if (std::isfinite(worth.verdict->error_mm)) card.error_mm = worth.verdict->error_mm;
  }
  card.due = worth.due;
  if (const fs::path file = picture_of(folder, finger); !file.empty())
    if (const QImage whole(QString::fromStdString(file.string())); !whole.isNull())
      card.picture = whole.scaledToHeight(kPictureHeight, Qt::SmoothTransformation)
                         .convertToFormat(QImage::Format_RGB32);
  return card;
}

}  // namespace alltact
