// The finger's lamp in the place Live: each change a step that can be undone, and kept for the next
// time.
#include "widgets/places/live_place.h"
#include "widgets/value_change.h"

#include <QSettings>

namespace alltact {
namespace {

constexpr int kLampMergeId = 23000;

QString lamp_key(const char* name) {
  return QStringLiteral("lamp/") + QLatin1String(name);
}

std::optional<DimmerSetting> kept_lamp() {
  const QSettings settings;
  const QString device = settings.value(lamp_key("device")).toString();
  const QString control = settings.value(lamp_key("control")).toString();
  const double level = settings.value(lamp_key("level"), -1).toDouble();
  if (device.isEmpty() || control.isEmpty() || !(level >= 0 && level <= 1)) return std::nullopt;
  return DimmerSetting{device.toStdString(), control.toStdString(), level};
}

void keep_lamp(const std::optional<DimmerSetting>& lamp) {
  QSettings settings;
  if (!lamp) return settings.remove(QStringLiteral("lamp"));
  settings.setValue(lamp_key("device"), QString::fromStdString(lamp->device));
  settings.setValue(lamp_key("control"), QString::fromStdString(lamp->control));
  settings.setValue(lamp_key("level"), lamp->level);
}

}  // namespace

void LivePlace::connect_lamp() {
  auto* panel = lamp_group_->findChild<LampPanel*>();
  connect(panel, &LampPanel::setting_wanted, this, &LivePlace::change_lamp);
  // Frames tell what the device took, not what somebody wants.
  connect(&lamp_, &Lamp::changed, this, [this] { session_.set_light(lamp_.setting()); });
  if (const auto kept = kept_lamp()) lamp_.set(kept);
}

void LivePlace::change_lamp(const std::optional<DimmerSetting>& wanted) {
  const auto& before = lamp_.wanted();
  const auto same = [](const DimmerSetting& a, const DimmerSetting& b) {
    return a.device == b.device && a.control == b.control;
  };
  if (wanted == before) return;
  const bool is_level = wanted && before && same(*wanted, *before);
  undo_.push(new ValueChange<std::optional<DimmerSetting>>(
      [is_level] { return is_level ? tr("dim the lamp") : tr("choose the lamp's dimmer"); },
      before,
      wanted,
      [this](const std::optional<DimmerSetting>& lamp) {
        lamp_.set(lamp);
        keep_lamp(lamp);
      },
      is_level ? kLampMergeId : -1));
}

}  // namespace alltact
