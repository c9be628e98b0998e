#include "widgets/controls/lamp_panel.h"

#include "widgets/language.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <cmath>

namespace alltact {
namespace {

constexpr int kFullLevel = 100;  // per cent
/// Names that LedDimmer understands; the entry after them describes a report.
const QStringList kControls{QStringLiteral("mcp2221a gp2"), QStringLiteral("mcp2221a gp3")};

}  // namespace

LampPanel::LampPanel(Lamp& lamp, QWidget* parent)
    : Translated(parent),
      lamp_(lamp),
      device_label_(new QLabel),
      control_label_(new QLabel),
      level_label_(new QLabel),
      state_(new QLabel),
      device_(new QComboBox),
      control_(new QComboBox),
      report_(new QLineEdit),
      look_(new QPushButton),
      slider_(new QSlider(Qt::Horizontal)),
      level_(new IntegerField) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  auto* devices = new QHBoxLayout;
  device_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  device_->setMinimumContentsLength(12);
  devices->addWidget(device_, 1);
  devices->addWidget(look_);
  for (int i = 0; i <= kControls.size(); ++i) control_->addItem({});
  for (QWidget* widget : {static_cast<QWidget*>(slider_), static_cast<QWidget*>(level_)})
    widget->setEnabled(false);
  slider_->setRange(0, kFullLevel);
  level_->setRange(0, kFullLevel);
  auto* levels = new QHBoxLayout;
  levels->addWidget(slider_, 1);
  levels->addWidget(level_);
  form->addRow(device_label_, devices);
  form->addRow(control_label_, control_);
  form->addRow(report_);
  form->addRow(level_label_, levels);
  form->addRow(state_);
  state_->setWordWrap(true);
  device_label_->setBuddy(device_);
  control_label_->setBuddy(control_);
  level_label_->setBuddy(level_);
  connect(look_, &QPushButton::clicked, &lamp_, &Lamp::find_devices);
  connect(device_, &QComboBox::activated, this, &LampPanel::ask);
  connect(control_, &QComboBox::activated, this, &LampPanel::ask);
  connect(report_, &QLineEdit::editingFinished, this, &LampPanel::ask);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    const QSignalBlocker quiet(level_);
    level_->setValue(value);
    ask();
  });
  connect(level_, &IntegerField::valueChanged, slider_, &QSlider::setValue);
  connect(&lamp_, &Lamp::changed, this, &LampPanel::show_lamp);
  say([this] { name_parts(); });
}

void LampPanel::name_parts() {
  device_label_->setText(tr("Dimmer"));
  device_->setAccessibleName(tr("The lamp's dimmer"));
  look_->setText(tr("Look"));
  look_->setAccessibleName(tr("Look for dimmers"));
  control_label_->setText(tr("Output"));
  control_->setAccessibleName(tr("The dimmer's output"));
  control_->setItemText(0, tr("MCP2221A, pin GP2"));
  control_->setItemText(1, tr("MCP2221A, pin GP3"));
  control_->setItemText(2, tr("A report, described"));
  report_->setAccessibleName(tr("Report that sets the brightness"));
  report_->setPlaceholderText(QStringLiteral("output id=0 bytes=8 at=1 range=0..255"));
  level_label_->setText(tr("Brightness"));
  level_->setSuffix(tr(" %"));
  level_->setAccessibleName(tr("The lamp's brightness"));
  slider_->setAccessibleName(tr("The lamp's brightness"));
  show_devices();
  show_lamp();
}

void LampPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (lamp_.found().empty()) lamp_.find_devices();
}

std::optional<DimmerSetting> LampPanel::chosen() const {
  const QString device = device_->currentData().toString();
  if (device.isEmpty()) return std::nullopt;
  const int which = control_->currentIndex();
  const QString control = which < kControls.size() ? kControls[which] : report_->text().trimmed();
  if (control.isEmpty()) return std::nullopt;
  return DimmerSetting{device.toStdString(),
                       control.toStdString(),
                       static_cast<double>(slider_->value()) / kFullLevel};
}

void LampPanel::ask() {
  report_->setVisible(control_->currentIndex() == kControls.size());
  Q_EMIT setting_requested(chosen());
}

void LampPanel::show_devices() {
  const auto& requested = lamp_.requested();
  const QString now =
      requested ? QString::fromStdString(requested->device) : device_->currentData().toString();
  const QSignalBlocker quiet(device_);
  device_->clear();
  device_->addItem(tr("none"), QString());
  for (const FoundHid& hid : lamp_.found())
    device_->addItem(QString::fromStdString(hid.identity.name.empty() ? hid.identity.stable_name()
                                                                      : hid.identity.name),
                     QString::fromStdString(hid.identity.stable_name()));
  if (!now.isEmpty() && device_->findData(now) < 0) device_->addItem(now, now);
  device_->setCurrentIndex(std::max(0, device_->findData(now)));
}

void LampPanel::show_lamp() {
  if (device_->count() != static_cast<int>(lamp_.found().size()) + 1) show_devices();
  const auto& requested = lamp_.requested();
  if (requested) {
    const QSignalBlocker quiet(device_), quiet_too(control_);
    device_->setCurrentIndex(
        std::max(0, device_->findData(QString::fromStdString(requested->device))));
    const auto which = kControls.indexOf(QString::fromStdString(requested->control));
    control_->setCurrentIndex(static_cast<int>(which < 0 ? kControls.size() : which));
    if (which < 0 && !report_->hasFocus())
      report_->setText(QString::fromStdString(requested->control));
    const int percent = static_cast<int>(std::lround(kFullLevel * requested->level));
    const QSignalBlocker quiet_slider(slider_), quiet_level(level_);
    if (!slider_->isSliderDown()) slider_->setValue(percent);
    if (!level_->hasFocus()) level_->setValue(percent);
  } else {
    const QSignalBlocker quiet(device_);
    device_->setCurrentIndex(0);
  }
  report_->setVisible(control_->currentIndex() == kControls.size());
  for (QWidget* widget : {static_cast<QWidget*>(slider_), static_cast<QWidget*>(level_)})
    widget->setEnabled(requested.has_value());
  const auto& problem = lamp_.problem();
  const auto& setting = lamp_.setting();
  state_->setText(problem   ? window_sentence(problem->message())
                  : setting ? tr("Set to %1 %. Every picture tells it.")
                                  .arg(QLocale().toString(kFullLevel * setting->level, 'f', 0))
                  : requested
                      ? tr("The dimmer is being told.")
                      : tr("Choose the device that dims the finger's lamp, where there is one."));
}

}  // namespace alltact
