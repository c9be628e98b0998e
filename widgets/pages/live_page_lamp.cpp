// The finger's lamp in the page Live: each change is an undo step and is saved for the next start.
#include "widgets/pages/live_page.h"
#include "widgets/value_change.h"

#include <QSettings>

namespace alltact {
namespace {

constexpr int kLampMergeId = 23000;

QString lamp_key(const char* name) {
  return QStringLiteral("lamp/") + QLatin1String(name);
}

std::optional<DimmerSetting> saved_lamp() {
  const QSettings settings;
  const QString device = settings.value(lamp_key("device")).toString();
  const QString control = settings.value(lamp_key("control")).toString();
  const double level = settings.value(lamp_key("level"), -1).toDouble();
  if (device.isEmpty() || control.isEmpty() || !(level >= 0 && level <= 1)) return std::nullopt;
  return DimmerSetting{device.toStdString(), control.toStdString(), level};
}

void save_lamp(const std::optional<DimmerSetting>& lamp) {
  QSettings settings;
  if (!lamp) return settings.remove(QStringLiteral("lamp"));
  settings.setValue(lamp_key("device"), QString::fromStdString(lamp->device));
  settings.setValue(lamp_key("control"), QString::fromStdString(lamp->control));
  settings.setValue(lamp_key("level"), lamp->level);
}

}  // namespace

void LivePage::connect_lamp() {
  auto* panel = lamp_group_->findChild<LampPanel*>();
  connect(panel, &LampPanel::setting_requested, this, &LivePage::change_lamp);
  // Frames store the setting that the device accepted, not the requested one.
  connect(&lamp_, &Lamp::changed, this, [this] { session_.set_light(lamp_.setting()); });
  if (const auto saved = saved_lamp()) lamp_.set(saved);
}

void LivePage::change_lamp(const std::optional<DimmerSetting>& requested) {
  const auto& before = lamp_.requested();
  const auto same = [](const DimmerSetting& a, const DimmerSetting& b) {
    return a.device == b.device && a.control == b.control;
  };
  if (requested == before) return;
  const bool is_level = requested && before && same(*requested, *before);
  undo_.push(new ValueChange<std::optional<DimmerSetting>>(
      [is_level] { return is_level ? tr("dim the lamp") : tr("choose the lamp's dimmer"); },
      before,
      requested,
      [this](const std::optional<DimmerSetting>& lamp) {
        lamp_.set(lamp);
        save_lamp(lamp);
      },
      is_level ? kLampMergeId : -1));
}

}  // namespace alltact
