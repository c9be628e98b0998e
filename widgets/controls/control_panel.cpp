#include "widgets/controls/control_panel.h"

#include "widgets/controls/number_field.h"
#include "widgets/language.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <linux/videodev2.h>

namespace alltact {
namespace {

/// First to last; all others follow in the camera's order.
constexpr std::array<std::uint32_t, 9> kImportant{
    V4L2_CID_EXPOSURE_AUTO, V4L2_CID_EXPOSURE_ABSOLUTE,  V4L2_CID_AUTOGAIN,
    V4L2_CID_GAIN,          V4L2_CID_AUTO_WHITE_BALANCE, V4L2_CID_WHITE_BALANCE_TEMPERATURE,
    V4L2_CID_FOCUS_AUTO,    V4L2_CID_FOCUS_ABSOLUTE,     V4L2_CID_BRIGHTNESS};

std::size_t rank(const CameraControl& control) {
  return static_cast<std::size_t>(std::find(kImportant.begin(), kImportant.end(), control.id) -
                                  kImportant.begin());
}

QString unit_of(const CameraControl& control) {
  if (control.id == V4L2_CID_EXPOSURE_ABSOLUTE) return ControlPanel::tr(" ms");
  if (control.id == V4L2_CID_WHITE_BALANCE_TEMPERATURE) return ControlPanel::tr(" K");
  return {};
}

/// Cameras count exposure in tenths of a millisecond; people in milliseconds.
class TenthsBox : public IntegerField {
 protected:
  [[nodiscard]] QString written(int value, bool /*is_exact*/) const override {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);  // as it may be typed
    return locale.toString(0.1 * value, 'f', 1);
  }
  [[nodiscard]] Result<int> parsed(const QString& text) const override {
    const auto value = parse_typed_number(
        text.toStdString(), {window_decimal_mark(), suffix().trimmed().toStdString()});
    if (!value) return value.error();
    const double tenths = 10 * *value;
    if (std::abs(tenths) < std::numeric_limits<int>::max() &&
        std::abs(tenths - std::round(tenths)) < 1e-6)
      return static_cast<int>(std::lround(tenths));
    return Error{en::say("'{}' has too many digits after the decimal mark (at most {})",
                         text.toStdString(), 1),
                 "", ""};
  }
  [[nodiscard]] double shown_number(int value) const override { return 0.1 * value; }
};

bool is_in_tenths(const CameraControl& control) { return control.id == V4L2_CID_EXPOSURE_ABSOLUTE; }

IntegerField* box_for(const CameraControl& control) {
  return is_in_tenths(control) ? new TenthsBox : new IntegerField;
}

QString text_of(const CameraControl& control, std::int64_t value) {
  const QLocale locale;
  const QString number = is_in_tenths(control)
                             ? locale.toString(0.1 * static_cast<double>(value), 'f', 1)
                             : locale.toString(qint64{value});
  return number + unit_of(control);
}

int as_int(std::int64_t value) {
  return static_cast<int>(std::clamp<std::int64_t>(value, std::numeric_limits<int>::min(),
                                                   std::numeric_limits<int>::max()));
}

bool is_same_control(const CameraControl& a, const CameraControl& b) {
  return a.id == b.id && a.name == b.name && a.type == b.type && a.low == b.low &&
         a.high == b.high && a.step == b.step && a.menu.size() == b.menu.size();
}

}  // namespace

/// One control: the input widget and its value.
class ControlPanel::Row : public QWidget {
 public:
  Row(const CameraControl& control, ControlPanel& panel) : control_(control), panel_(panel) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 2, 0, 2);
    layout->setSpacing(2);
    switch (control.type) {
      case ControlType::kBoolean:
        make_switch(*layout);
        break;
      case ControlType::kMenu:
      case ControlType::kIntegerMenu:
        make_choice(*layout);
        break;
      default:
        make_number(*layout);
    }
  }

  void show_value(const CameraControl& control, bool is_locked) {
    const bool is_in_use = (slider_ != nullptr && slider_->isSliderDown()) ||
                           (number_ != nullptr && number_->hasFocus());
    control_ = control;
    setEnabled(!is_locked && !control.is_inactive && !control.is_read_only);
    setToolTip(is_locked             ? ControlPanel::tr("Locked: unlock above to change it.")
               : control.is_inactive ? ControlPanel::tr("An automatic mode controls it.")
                                     : QString());
    if (is_in_use) return;
    is_showing_ = true;
    if (number_ != nullptr) number_->setValue(as_int(control.value));
    if (slider_ != nullptr) slider_->setValue(as_int(control.value));
    if (switch_ != nullptr) switch_->setChecked(control.value != 0);
    if (choice_ != nullptr) choice_->setCurrentIndex(choice_->findData(qint64{control.value}));
    is_showing_ = false;
  }

 private:
  void make_number(QVBoxLayout& layout) {
    auto* label = new QLabel(control_name(control_));
    number_ = box_for(control_);
    number_->setRange(as_int(control_.low), as_int(control_.high));
    number_->setSingleStep(as_int(std::max<std::int64_t>(control_.step, 1)));
    number_->setSuffix(unit_of(control_));
    number_->setAccessibleName(control_name(control_));
    label->setBuddy(number_);
    slider_ = new QSlider(Qt::Horizontal);
    slider_->setRange(number_->minimum(), number_->maximum());
    slider_->setSingleStep(number_->singleStep());
    slider_->setPageStep(
        std::max(number_->singleStep(), (slider_->maximum() - slider_->minimum()) / 10));
    slider_->setAccessibleName(control_name(control_));
    const QString range =
        ControlPanel::tr("%1 to %2")
            .arg(text_of(control_, control_.low), text_of(control_, control_.high));
    number_->setAccessibleDescription(range);
    slider_->setAccessibleDescription(range);
    auto* head = new QHBoxLayout;
    head->addWidget(label, 1);
    head->addWidget(number_);
    layout.addLayout(head);
    layout.addWidget(slider_);
    connect(number_, &IntegerField::valueChanged, this, [this](int value) { change(value); });
    connect(slider_, &QSlider::valueChanged, this, [this](int value) { change(value); });
  }

  void make_switch(QVBoxLayout& layout) {
    switch_ = new QCheckBox(control_name(control_));
    layout.addWidget(switch_);
    connect(switch_, &QCheckBox::toggled, this, [this](bool is_on) { change(is_on ? 1 : 0); });
  }

  void make_choice(QVBoxLayout& layout) {
    auto* label = new QLabel(control_name(control_));
    choice_ = new QComboBox;
    choice_->setAccessibleName(control_name(control_));
    for (const MenuItem& item : control_.menu)
      choice_->addItem(QString::fromStdString(item.name), qint64{item.value});
    label->setBuddy(choice_);
    layout.addWidget(label);
    layout.addWidget(choice_);
    connect(choice_, &QComboBox::currentIndexChanged, this,
            [this](int) { change(choice_->currentData().toLongLong()); });
  }

  void change(std::int64_t value) {
    if (is_showing_ || value == control_.value) return;
    const std::int64_t before = std::exchange(control_.value, value);
    is_showing_ = true;  // the linked widget follows
    if (number_ != nullptr) number_->setValue(as_int(value));
    if (slider_ != nullptr) slider_->setValue(as_int(value));
    is_showing_ = false;
    Q_EMIT panel_.control_changed(control_.id, before, value);
  }

  CameraControl control_;
  ControlPanel& panel_;
  IntegerField* number_ = nullptr;
  QSlider* slider_ = nullptr;
  QCheckBox* switch_ = nullptr;
  QComboBox* choice_ = nullptr;
  bool is_showing_ = false;
};

ControlPanel::ControlPanel(QWidget* parent)
    : Translated(parent),
      lock_(new QCheckBox),
      reason_(wrapped_label()),
      empty_(wrapped_label()),
      list_(new QWidget) {
  auto* layout = without_margins(new QVBoxLayout(this));
  without_margins(new QVBoxLayout(list_));
  add_widgets(*layout, {empty_, lock_, reason_, list_});
  lock_->setChecked(true);
  connect(lock_, &QCheckBox::clicked, this, &ControlPanel::lock_changed);
  say([this] {
    lock_->setText(tr("&Lock brightness"));
    lock_->setToolTip(
        tr("Exposure, gain, white balance and focus stay as they are; depth rests on them"));
    lock_->setAccessibleDescription(
        tr("Automatic modes stay off; unrequested changes are undone."));
    reason_->setText(
        tr("Brightness is what is measured: when locked, it does not change. Unlock it only before "
           "calibrating."));
    empty_->setText(
        tr("A camera's exposure, gain, white balance and focus appear here. This source is not a "
           "camera."));
  });
  refresh();
}

void ControlPanel::set_controls(const std::vector<CameraControl>& controls, bool is_locked) {
  std::vector<CameraControl> shown;
  std::copy_if(controls.begin(), controls.end(), std::back_inserter(shown),
               [](const CameraControl& control) { return control.is_setting(); });
  std::stable_sort(shown.begin(), shown.end(),
                   [](const auto& a, const auto& b) { return rank(a) < rank(b); });
  const bool is_same =
      std::equal(shown.begin(), shown.end(), controls_.begin(), controls_.end(), is_same_control);
  controls_ = std::move(shown);
  is_locked_ = is_locked;
  if (!is_same) rebuild();
  refresh();
}

void ControlPanel::rebuild() {
  for (const auto& [id, row] : rows_) delete row;
  rows_.clear();
  for (const CameraControl& control : controls_) {
    auto* row = new Row(control, *this);
    rows_[control.id] = row;
    list_->layout()->addWidget(row);
  }
}

void ControlPanel::refresh() {
  const bool has_controls = !controls_.empty();
  empty_->setVisible(!has_controls);
  for (QWidget* widget : std::initializer_list<QWidget*>{lock_, reason_, list_})
    widget->setVisible(has_controls);
  lock_->setChecked(is_locked_);
  for (const CameraControl& control : controls_)
    rows_.at(control.id)->show_value(control, is_locked_);
}

void ControlPanel::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() != QEvent::LanguageChange) return;
  rebuild();
  refresh();
}

QString control_name(const CameraControl& control) {
  switch (control.id) {
    case V4L2_CID_EXPOSURE_AUTO:
      return ControlPanel::tr("Automatic exposure");
    case V4L2_CID_EXPOSURE_ABSOLUTE:
      return ControlPanel::tr("Exposure time");
    case V4L2_CID_AUTOGAIN:
      return ControlPanel::tr("Automatic gain");
    case V4L2_CID_GAIN:
      return ControlPanel::tr("Gain");
    case V4L2_CID_AUTO_WHITE_BALANCE:
      return ControlPanel::tr("Automatic white balance");
    case V4L2_CID_WHITE_BALANCE_TEMPERATURE:
      return ControlPanel::tr("White balance");
    case V4L2_CID_FOCUS_AUTO:
      return ControlPanel::tr("Automatic focus");
    case V4L2_CID_FOCUS_ABSOLUTE:
      return ControlPanel::tr("Focus");
    case V4L2_CID_BRIGHTNESS:
      return ControlPanel::tr("Brightness");
    default:
      return QString::fromStdString(control.name);
  }
}

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
      state_(wrapped_label()),
      device_(new QComboBox),
      control_(new QComboBox),
      report_(new QLineEdit),
      look_(new QPushButton),
      slider_(new QSlider(Qt::Horizontal)),
      level_(new IntegerField) {
  auto* form = without_margins(new QFormLayout(this));
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  auto* devices = new QHBoxLayout;
  device_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  device_->setMinimumContentsLength(12);
  devices->addWidget(device_, 1);
  devices->addWidget(look_);
  for (int i = 0; i <= kControls.size(); ++i) control_->addItem({});
  for (QWidget* widget : std::initializer_list<QWidget*>{slider_, level_})
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
  device_->setToolTip(tr("USB device that dims the lamp; none leaves the lamp alone"));
  look_->setText(tr("Search"));
  look_->setAccessibleName(tr("Search for dimmers"));
  look_->setToolTip(tr("Lists the dimmers that are plugged in now"));
  control_label_->setText(tr("Output"));
  control_->setAccessibleName(tr("The dimmer's output"));
  control_->setToolTip(tr("The pin or report that the lamp is connected to"));
  control_->setItemText(0, tr("MCP2221A, pin GP2"));
  control_->setItemText(1, tr("MCP2221A, pin GP3"));
  control_->setItemText(2, tr("Custom report"));
  report_->setAccessibleName(tr("Report that sets the brightness"));
  report_->setToolTip(tr("Number, bytes and range of the HID report that sets the brightness"));
  report_->setPlaceholderText(QStringLiteral("output id=0 bytes=8 at=1 range=0..255"));
  level_label_->setText(tr("Brightness"));
  level_->setSuffix(tr(" %"));
  level_->setAccessibleName(tr("The lamp's brightness"));
  level_->setToolTip(tr("In per cent; every recorded image stores it"));
  slider_->setAccessibleName(tr("The lamp's brightness"));
  slider_->setToolTip(tr("In per cent; every recorded image stores it"));
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
  return DimmerSetting{device.toStdString(), control.toStdString(),
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
  for (QWidget* widget : std::initializer_list<QWidget*>{slider_, level_})
    widget->setEnabled(requested.has_value());
  const auto& problem = lamp_.problem();
  const auto& setting = lamp_.setting();
  state_->setText(problem   ? window_sentence(problem->message())
                  : setting ? tr("Set to %1 %. Every image records it.")
                                  .arg(QLocale().toString(kFullLevel * setting->level, 'f', 0))
                  : requested
                      ? tr("The dimmer is being set.")
                      : tr("Choose the device that dims the finger's lamp, if there is one."));
}

}  // namespace alltact
