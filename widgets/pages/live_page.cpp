#include "widgets/pages/live_page.h"

#include "widgets/controls/devices.h"
#include "widgets/language.h"
#include "widgets/live/live_pair.h"
#include "widgets/live/touch_history.h"
#include "widgets/panels/force_box.h"
#include "widgets/shell/force_dialog.h"
#include "widgets/shell/page.h"
#include "widgets/theme.h"
#include "widgets/undo_step.h"

#include <QHBoxLayout>
#include <QSettings>
#include <QVBoxLayout>

namespace alltact {
namespace {

constexpr int kLiveSideWidth = 300;

constexpr int kDepthTop = 1, kControls = 1000;  // merge ids

}  // namespace

LivePage::LivePage(LiveSession& session, QUndoStack& undo, QWidget* parent)
    : Page("live", parent),
      session_(session),
      undo_(undo),
      pair_(session),
      pages_(new QStackedLayout(this)),
      start_(new StartPanel),
      panel_(new ImagePanel(session)),
      panels_(new QHBoxLayout),
      overlay_group_(new QGroupBox),
      camera_(new QGroupBox),
      lamp_group_(new QGroupBox),
      times_group_(new QGroupBox),
      choices_{{{new QCheckBox, &ViewOptions::edges},
                {new QCheckBox, &ViewOptions::markers},
                {new QCheckBox, &ViewOptions::direction},
                {new QCheckBox, &ViewOptions::depth},
                {new QCheckBox, &ViewOptions::faults},
                {new QCheckBox, &ViewOptions::focus}}},
      top_label_(new QLabel),
      top_(new NumberField),
      contact_(new ContactBox),
      times_(new QLabel),
      brightness_(new BrightnessBox),
      controls_(new ControlPanel),
      force_(new ForceBox([this] { return shown_force(); })),
      pair_box_(new LivePairBox(pair_, session)) {
  pages_->addWidget(start_);
  pages_->addWidget(make_view_page());
  connect_choices();
  connect_force();
  connect_pair();
  connect_lamp();
  connect(controls_, &ControlPanel::control_changed, this, &LivePage::change_control);
  connect(controls_, &ControlPanel::lock_changed, this, &LivePage::change_lock);
  connect(&session_, &LiveSession::status_ready, this, &LivePage::show_status);
  // A last view of a source that was closed may still arrive.
  connect(&session_, &LiveSession::view_ready, this, [this] {
    if (!is_start_requested_) show_start(false);
  });
  connect(start_, &StartPanel::finger_requested, this, &LivePage::open_finger_requested);
  connect(start_, &StartPanel::new_finger_requested, this,
          [this] { Q_EMIT new_finger_requested({}); });
  say([this] { name_parts(); });
  set_options(options_);
}

void LivePage::show_start(bool is_requested) {
  is_start_requested_ = is_requested;
  pages_->setCurrentIndex(is_requested ? 0 : 1);
}

QWidget* LivePage::make_view_page() {
  auto* image = new QWidget;
  auto* column = without_margins(new QVBoxLayout(image));
  panels_->addWidget(panel_, 1);
  column->addLayout(panels_, 1);
  column->addWidget(force_->take_plot());
  return make_side().next_to(image, QStringLiteral("live"));
}

void LivePage::connect_choices() {
  for (const Choice& choice : choices_)
    connect(choice.box, &QCheckBox::clicked, this, [this, choice](bool is_on) {
      ViewOptions next = options_;
      next.*choice.member = is_on;
      const auto what = [box = choice.box, is_on] {
        const QString name = box->text().remove(QLatin1Char('&'));
        return is_on ? tr("show %1").arg(name) : tr("hide %1").arg(name);
      };
      change_options(next, what, -1);
    });
  connect(top_, &NumberField::valueChanged, this, [this](double value) {
    if (value == options_.depth_top_mm) return;
    ViewOptions next = options_;
    next.depth_top_mm = value;
    change_options(
        next, [] { return tr("change the depth colours"); }, kDepthTop);
  });
}

void LivePage::name_parts() {
  overlay_group_->setTitle(tr("Image overlays"));
  const std::array<QString, 6> names{tr("Edges &of the face"),      tr("&Markers with numbers"),
                                     tr("Direction of &contact"),   tr("&Depth in colours"),
                                     tr("&Too dark or too bright"), tr("Shar&p edges")};
  for (std::size_t i = 0; i < names.size(); ++i) choices_[i].box->setText(names[i]);
  choices_[0].box->setToolTip(tr("Both edges of the face, as they are found in this image"));
  choices_[2].box->setToolTip(tr("Arrow: displacement of the finger; it grows with the force"));
  choices_[3].box->setToolTip(tr("How deep the face is pressed in; the scale is in mm"));
  choices_[1].box->setToolTip(tr("Ring: visible marker. Dashed diamond: estimated position."));
  choices_[4].box->setToolTip(
      tr("Stripes falling to the right: too bright to measure. "
         "Stripes falling to the left: too dark."));
  choices_[5].box->setToolTip(
      tr("Yellow where the image is sharp: turn the lens until most of the face's edges and of the "
         "markers are yellow."));
  top_label_->setText(tr("Colours e&nd at"));
  top_->setSuffix(tr(" mm"));
  top_->setAccessibleName(tr("Depth at which the colours end"));
  top_->setToolTip(tr("Deeper contacts have the colour of the end of the scale"));
  camera_->setTitle(tr("Camera"));
  lamp_group_->setTitle(tr("Lamp"));
  times_group_->setTitle(tr("Time per frame"));
  show_status();
}

SidePanel LivePage::make_side() {
  const SidePanel side(kLiveSideWidth);
  auto* over = new QVBoxLayout(overlay_group_);
  for (const Choice& choice : choices_) over->addWidget(choice.box);
  auto* top = new QHBoxLayout;
  top_->setRange(0.1, 10);
  top_->setSingleStep(0.1);
  top_->set_shown_decimals(1);
  top_label_->setBuddy(top_);
  top->addSpacing(24);
  top->addWidget(top_label_);
  top->addWidget(top_);
  top->addStretch();
  over->insertLayout(4, top);
  add_widgets(*side.column, {overlay_group_, pair_box_, contact_, force_});
  auto* camera = new QVBoxLayout(camera_);
  add_widgets(*camera, {brightness_, controls_});
  side.column->addWidget(camera_);
  (new QVBoxLayout(lamp_group_))->addWidget(new LampPanel(lamp_));
  side.column->addWidget(lamp_group_);
  // Its rows come with the first image: below all controls.
  (new QVBoxLayout(times_group_))->addWidget(times_);
  side.column->addWidget(times_group_);
  side.column->addStretch();
  return side;
}

void LivePage::set_options(const ViewOptions& options) {
  options_ = options;
  for (const Choice& choice : choices_) choice.box->setChecked(options.*choice.member);
  top_->setValue(options.depth_top_mm);
  top_->setEnabled(options.depth);
  set_layers(session_);
  if (pair_.second() != nullptr) set_layers(*pair_.second());
  panel_->set_options(options);
  if (second_panel_ != nullptr) second_panel_->set_options(options);
  Q_EMIT changed();
}

void LivePage::change_options(const ViewOptions& options, const StepWords& what, int merge_id) {
  undo_.push(new ValueChange<ViewOptions>(
      what, options_, options, [this](const ViewOptions& value) { set_options(value); }, merge_id));
}

void LivePage::change_control(std::uint32_t id, std::int64_t before, std::int64_t value) {
  const auto& controls = session_.status().controller.controls;
  const auto control =
      std::find_if(controls.begin(), controls.end(), [&](const auto& c) { return c.id == id; });
  const std::string name = control == controls.end() ? std::string() : control->name;
  undo_.push(new ValueChange<std::int64_t>(
      [name] { return tr("change %1").arg(QString::fromStdString(name)); }, before, value,
      [this, id, name](const std::int64_t& requested) {
        session_.set_control({id, name, requested});
        Q_EMIT control_set({id, name, requested});
      },
      static_cast<int>(kControls + id % 1000000)));
}

void LivePage::change_lock(bool is_locked) {
  undo_.push(new ValueChange<bool>(
      [is_locked] { return is_locked ? tr("lock brightness") : tr("unlock brightness"); },
      !is_locked, is_locked,
      [this](const bool& value) {
        session_.set_lock(value);
        Q_EMIT lock_set(value);
      }));
}

void LivePage::show_status() {
  const LiveStatus& status = session_.status();
  controls_->set_controls(status.controller.controls, status.controller.is_locked);
  const auto& view = session_.view();
  brightness_->show_image(view && isVisible() ? &view->result : nullptr);
  contact_->show_contact(view ? &view->result : nullptr, session_.touch_history());
  force_->schedule_update();
  show_times();
}

void LivePage::show_times() {
  const QLocale locale;
  const StepTimes& times = session_.times_ms();
  QString rows;
  const auto add = [&](const QString& name, double milliseconds) {
    if (milliseconds <= 0) return;
    rows += QStringLiteral("<tr><td>%1</td><td align='right'>&nbsp;&nbsp;%2</td></tr>")
                .arg(name, tr("%1 ms").arg(locale.toString(milliseconds, 'f', 2)));
  };
  add(tr("Preparation"), times.prepare);
  add(tr("Edges"), times.edges);
  add(tr("Shape"), times.global);
  add(tr("Markers"), times.markers);
  add(tr("Reference"), times.reference);
  add(tr("Depth"), times.local);
  add(tr("Contacts"), times.contact);
  add(tr("Force"), times.force);
  add(tr("Total"), times.total);
  times_->setText(rows.isEmpty() ? tr("No image yet.")
                                 : QStringLiteral("<table>%1</table>").arg(rows));
}

namespace {

/// A camera's name may be wider than its button: its middle is cut, for cameras of one maker differ
/// at the end.
class CameraButton : public QPushButton {
 public:
  explicit CameraButton(const QString& name) : name_(name) { setAccessibleName(name); }
  [[nodiscard]] QSize minimumSizeHint() const override {
    return {0, QPushButton::minimumSizeHint().height()};
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QPushButton::resizeEvent(event);
    const int frame_px = 2 * style()->pixelMetric(QStyle::PM_ButtonMargin);
    setText(fontMetrics().elidedText(name_, Qt::ElideMiddle, std::max(0, width() - frame_px)));
  }

 private:
  QString name_;
};

}  // namespace

StartPanel::StartPanel(QWidget* parent)
    : Translated(parent),
      title_(new QLabel),
      intro_(wrapped_label()),
      cards_(new FingerCards),
      drawing_(new FingerDrawing(DrawnThing::kFinger)),
      try_(new QPushButton),
      last_(new QPushButton),
      simulated_(new QPushButton),
      video_(new QPushButton),
      folder_(new QPushButton),
      finger_(new QPushButton),
      new_finger_(new QPushButton),
      all_(new QPushButton),
      sources_(new QGroupBox),
      fingers_(new QGroupBox),
      cameras_(new QVBoxLayout) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kSpacing, kSpacing, kSpacing, kSpacing);
  row->setSpacing(3 * kSpacing);
  row->addLayout(make_left(), 1);
  row->addLayout(make_right());
  connect(cards_, &FingerCards::filled, this, &StartPanel::mark_primary);
  connect(try_, &QPushButton::clicked, this, &StartPanel::tutorial_requested);
  connect(last_, &QPushButton::clicked, this, &StartPanel::last_requested);
  connect(simulated_, &QPushButton::clicked, this, &StartPanel::simulation_requested);
  connect(video_, &QPushButton::clicked, this, &StartPanel::video_requested);
  connect(folder_, &QPushButton::clicked, this, &StartPanel::folder_requested);
  connect(finger_, &QPushButton::clicked, this, &StartPanel::finger_requested);
  connect(new_finger_, &QPushButton::clicked, this, &StartPanel::new_finger_requested);
  connect(all_, &QPushButton::clicked, this, &StartPanel::all_fingers_requested);
  say([this] { name_parts(); });
}

QVBoxLayout* StartPanel::make_left() {
  auto* column = new QVBoxLayout;
  column->setSpacing(kSpacing + kSpacing / 2);
  title_->setFont(text_font(font(), TextSize::kTitle));
  add_widgets(*column, {last_, cards_, title_, intro_});
  column->addWidget(drawing_, 100);
  column->addStretch(1);  // below a small drawing
  return column;
}

QVBoxLayout* StartPanel::make_right() {
  constexpr int kWidth = 220;
  auto* sources = new QVBoxLayout(sources_);
  sources->addLayout(cameras_);
  add_widgets(*sources, {simulated_, video_, folder_});
  auto* fingers = new QVBoxLayout(fingers_);
  add_widgets(*fingers, {finger_, all_, new_finger_});
  auto* column = new QVBoxLayout;
  column->setSpacing(2 * kSpacing);
  for (QWidget* widget : std::initializer_list<QWidget*>{try_, sources_, fingers_}) {
    widget->setMinimumWidth(kWidth);
    column->addWidget(widget);
  }
  column->addStretch();
  return column;
}

void StartPanel::name_parts() {
  title_->setText(tr("Choose a source"));
  intro_->setText(tr("The source supplies the images. Open a finger before or after."));
  try_->setText(tr("&Try with a simulated finger"));
  try_->setToolTip(
      tr("A full day in five minutes: record, press, calibrate and check a simulated finger"));
  simulated_->setText(tr("&Simulated finger"));
  simulated_->setToolTip(tr("A computed finger that bends, to try everything without a camera"));
  video_->setText(tr("Vi&deo file…"));
  video_->setToolTip(tr("Plays a recording as if it came from a camera"));
  folder_->setText(tr("Folder of &images…"));
  folder_->setToolTip(tr("Plays the images of a folder by their names"));
  finger_->setText(tr("&Open a finger…"));
  finger_->setToolTip(tr("Chooses the folder of a finger that exists (Ctrl+O)"));
  all_->setText(tr("&All fingers…"));
  all_->setToolTip(tr("Verdict and due steps of each, in one list"));
  new_finger_->setText(tr("&New finger…"));
  new_finger_->setToolTip(tr("Describes a finger that is not calibrated yet (Ctrl+N)"));
  sources_->setTitle(tr("Source"));
  fingers_->setTitle(tr("Finger"));
  drawing_->setAccessibleName(
      tr("A finger from its side: camera and lamps at its base, and a ball that presses"));
  set_last(last_text_);
  show_cameras();
}

void StartPanel::mark_primary() {
  const bool has_worked = !last_text_.isEmpty();
  set_primary(*last_, has_worked);
  set_primary(*try_, !has_worked && cards_->cards().empty());
  all_->setEnabled(!cards_->cards().empty());
  // Who has fingers knows what one is.
  constexpr int kSmall_px = 320;
  drawing_->setMaximumHeight(cards_->cards().empty() ? QWIDGETSIZE_MAX : kSmall_px);
}

void StartPanel::set_last(const QString& what) {
  last_text_ = what;
  last_->setVisible(!what.isEmpty());
  last_->setText(tr("&Go on with %1").arg(what));
  last_->setToolTip(tr("Opens the source and the finger of the last time"));
  mark_primary();
}

void StartPanel::set_cameras(const std::vector<FoundCamera>& cameras) {
  found_ = cameras;
  show_cameras();
}

void StartPanel::show_cameras() {
  while (QLayoutItem* item = cameras_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  if (found_.empty()) cameras_->addWidget(new QLabel(tr("No camera is plugged in.")));
  for (const FoundCamera& camera : found_) {
    const QString name = QString::fromStdString(camera.identity.stable_name());
    auto* button = new CameraButton(tr("Camera %1").arg(camera_label(camera, found_)));
    button->setToolTip(name);
    connect(button, &QPushButton::clicked, this, [this, name] { Q_EMIT camera_requested(name); });
    cameras_->addWidget(button);
    if (!camera.problem) continue;
    button->setEnabled(false);
    auto* why = new QLabel(window_sentence(camera.problem->message()));
    why->setWordWrap(true);
    cameras_->addWidget(why);
  }
}

// Contact and force in the page Live.

void LivePage::connect_force() {
  connect(&session_, &LiveSession::view_ready, force_, &ForceBox::schedule_update);
  connect(force_, &ForceBox::zero_requested, this,
          [this](const ForceZero& zero) { take_zero(session_, undo_, zero); });
  connect(force_, &ForceBox::no_zero_requested, this, [this] { drop_zero(session_, undo_); });
  connect(force_, &ForceBox::training_requested, this,
          [this] { open_force_training(session_, undo_, *this); });
}

ShownForce LivePage::shown_force() const {
  ShownForce shown;
  const auto& view = session_.view();
  if (view) shown.now = view->result.force;
  shown.history = &session_.touch_history();
  shown.zero = session_.force_zero();
  shown.why_none = no_force_reason(session_.status().finger);
  shown.has_model = has_force_model(session_.status().finger);
  shown.can_train = can_train_force(session_.status().finger);
  return shown;
}

// The second finger in the page Live.

namespace {

constexpr int kMotorMergeId = 22000;

}  // namespace

void LivePage::connect_pair() {
  connect(&pair_, &LivePair::pair_ready, this, &LivePage::show_pair);
  connect(&pair_, &LivePair::changed, this, &LivePage::show_pair_state);
  connect(pair_box_, &LivePairBox::open_requested, this, &LivePage::choose_second);
  connect(pair_box_, &LivePairBox::close_requested, this, [this] { open_second(std::nullopt); });
  connect(pair_box_, &LivePairBox::motor_requested, this, [this](double turns) {
    auto second = pair_.opened();
    if (!second) return;
    second->motor_turns = turns;
    change_second(
        second, [] { return tr("change the motor's position"); }, kMotorMergeId);
  });
}

void LivePage::set_cameras(const std::vector<FoundCamera>& cameras) {
  start_->set_cameras(cameras);
  cameras_.clear();
  for (const FoundCamera& camera : cameras)
    if (!camera.problem) cameras_ << QString::fromStdString(camera.identity.stable_name());
}

void LivePage::open_second(const std::optional<SecondCamera>& second) {
  change_second(
      second,
      [opens = second.has_value()] {
        return opens ? tr("watch a second finger") : tr("close the second finger");
      },
      -1);
}

void LivePage::change_second(const std::optional<SecondCamera>& second, const StepWords& what,
                             int merge_id) {
  using Second = std::optional<SecondCamera>;
  if (second == pair_.opened()) return;
  undo_.push(new ValueChange<Second>(
      what, pair_.opened(), second, [this](const Second& requested) { set_second(requested); },
      merge_id));
}

void LivePage::choose_second() {
  auto* dialog = new SecondCameraDialog(pair_.opened(), cameras_, this);
  connect(dialog, &SecondCameraDialog::chosen, this,
          [this](const SecondCamera& second) { open_second(second); });
  show_dialog(*dialog);
}

void LivePage::set_second(const std::optional<SecondCamera>& second) {
  pair_.open(second);
  if (second && second_panel_ == nullptr) {
    second_panel_ = new ImagePanel(*pair_.second());
    second_panel_->set_options(options_);
    set_layers(*pair_.second());
    panels_->addWidget(second_panel_, 1);
  }
  if (second_panel_ != nullptr) second_panel_->setVisible(second.has_value());
  show_pair();
  show_pair_state();
}

void LivePage::set_layers(LiveSession& session) const {
  session.set_layers({options_.depth, options_.faults, options_.focus});
  session.set_depth_top_mm(options_.depth_top_mm);
}

/// Each panel shows its view of the pair instead of its own newest view.
void LivePage::show_pair() {
  const auto& pair = pair_.pair();
  panel_->show_instead(pair ? pair->views[0] : nullptr);
  if (second_panel_ != nullptr) second_panel_->show_instead(pair ? pair->views[1] : nullptr);
}

void LivePage::show_pair_state() {
  pair_box_->show_pair();
  const bool is_open = pair_.opened() && pair_.second() != nullptr;
  panel_->set_title(is_open ? QStringLiteral("1: ") + finger_name(session_.status().finger)
                            : QString());
  if (second_panel_ != nullptr)
    second_panel_->set_title(QStringLiteral("2: ") + finger_name(pair_.second()->status().finger));
}

// The finger's lamp in the page Live: each change is an undo step and is saved for the next start.

namespace {

constexpr int kLampMergeId = 23000;

QString lamp_key(const char* name) { return QStringLiteral("lamp/") + QLatin1String(name); }

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
      [is_level] { return is_level ? tr("dim the lamp") : tr("choose the lamp's dimmer"); }, before,
      requested,
      [this](const std::optional<DimmerSetting>& lamp) {
        lamp_.set(lamp);
        save_lamp(lamp);
      },
      is_level ? kLampMergeId : -1));
}

}  // namespace alltact
