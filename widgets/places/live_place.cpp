#include "widgets/places/live_place.h"

#include "widgets/panels/side_panel.h"
#include "widgets/touch/contact_words.h"
#include "widgets/value_change.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace alltact {
namespace {

constexpr int kLiveSideWidth = 300;

enum MergeId { kDepthTop = 1, kControls = 1000 };

}  // namespace

LivePlace::LivePlace(LiveSession& session, QUndoStack& undo, QWidget* parent)
    : Place("live", parent),
      session_(session),
      undo_(undo),
      pair_(session),
      pages_(new QStackedLayout(this)),
      start_(new StartPanel),
      panel_(new PicturePanel(session)),
      pictures_(new QHBoxLayout),
      over_(new QGroupBox),
      camera_(new QGroupBox),
      lamp_group_(new QGroupBox),
      contact_group_(new QGroupBox),
      times_group_(new QGroupBox),
      choices_{{{new QCheckBox, &ViewOptions::edges},
                {new QCheckBox, &ViewOptions::markers},
                {new QCheckBox, &ViewOptions::direction},
                {new QCheckBox, &ViewOptions::depth},
                {new QCheckBox, &ViewOptions::faults}}},
      top_label_(new QLabel),
      top_(new NumberField),
      contact_(new QLabel),
      times_(new QLabel),
      controls_(new ControlPanel),
      force_(new ForceBox([this] { return shown_force(); })),
      pair_box_(new LivePairBox(pair_, session)) {
  pages_->addWidget(start_);
  pages_->addWidget(make_picture());
  connect_choices();
  connect_force();
  connect_pair();
  connect_lamp();
  connect(controls_, &ControlPanel::control_changed, this, &LivePlace::change_control);
  connect(controls_, &ControlPanel::lock_changed, this, &LivePlace::change_lock);
  connect(&session_, &LiveSession::status_ready, this, &LivePlace::show_status);
  // The last picture of a source that was closed may still be on its way.
  connect(&session_, &LiveSession::view_ready, this, [this] {
    if (!is_start_wanted_) show_start(false);
  });
  connect(start_, &StartPanel::finger_wanted, this, &LivePlace::open_finger_wanted);
  connect(start_, &StartPanel::new_finger_wanted, this, [this] { Q_EMIT new_finger_wanted({}); });
  say([this] { name_parts(); });
  set_options(options_);
}

void LivePlace::show_start(bool is_wanted) {
  is_start_wanted_ = is_wanted;
  pages_->setCurrentIndex(is_wanted ? 0 : 1);
}

QWidget* LivePlace::make_picture() {
  auto* page = new QWidget;
  auto* row = new QHBoxLayout(page);
  row->setContentsMargins(0, 0, 0, 0);
  auto* column = new QVBoxLayout;
  pictures_->addWidget(panel_, 1);
  column->addLayout(pictures_, 1);
  column->addWidget(force_->take_plot());
  row->addLayout(column, 1);
  row->addWidget(make_side());
  return page;
}

void LivePlace::connect_choices() {
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

void LivePlace::name_parts() {
  over_->setTitle(tr("Over the picture"));
  const std::array<QString, 5> names{tr("&Edges of the face"),
                                     tr("&Markers with numbers"),
                                     tr("Direction of &contact"),
                                     tr("&Depth in colours"),
                                     tr("&Too dark or too bright")};
  for (std::size_t i = 0; i < names.size(); ++i) choices_[i].box->setText(names[i]);
  choices_[1].box->setToolTip(
      tr("A ring: the marker is seen. A dashed diamond: its place is an estimate."));
  choices_[4].box->setToolTip(
      tr("Stripes falling to the right: too bright to measure. "
         "Stripes falling to the left: too dark."));
  top_label_->setText(tr("Colours &end at"));
  top_->setSuffix(tr(" mm"));
  top_->setAccessibleName(tr("Depth at which the colours end"));
  camera_->setTitle(tr("Camera"));
  lamp_group_->setTitle(tr("Lamp"));
  contact_group_->setTitle(tr("Contact"));
  contact_->setToolTip(contact_words_help());
  contact_->setAccessibleName(tr("What touches the finger"));
  times_group_->setTitle(tr("Time of a frame"));
  show_status();
}

QWidget* LivePlace::make_side() {
  const SidePanel side(kLiveSideWidth);
  auto* over = new QVBoxLayout(over_);
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
  side.column->addWidget(over_);
  side.column->addWidget(pair_box_);
  make_contact();
  side.column->addWidget(contact_group_);
  side.column->addWidget(force_);
  (new QVBoxLayout(times_group_))->addWidget(times_);
  side.column->addWidget(times_group_);
  (new QVBoxLayout(camera_))->addWidget(controls_);
  side.column->addWidget(camera_);
  (new QVBoxLayout(lamp_group_))->addWidget(new LampPanel(lamp_));
  side.column->addWidget(lamp_group_);
  side.column->addStretch();
  return side.whole;
}

void LivePlace::set_options(const ViewOptions& options) {
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

void LivePlace::change_options(const ViewOptions& options, const StepWords& what, int merge_id) {
  undo_.push(new ValueChange<ViewOptions>(
      what, options_, options, [this](const ViewOptions& value) { set_options(value); }, merge_id));
}

void LivePlace::change_control(std::uint32_t id, std::int64_t before, std::int64_t value) {
  const auto& controls = session_.status().controller.controls;
  const auto control =
      std::find_if(controls.begin(), controls.end(), [&](const auto& c) { return c.id == id; });
  const std::string name = control == controls.end() ? std::string() : control->name;
  undo_.push(new ValueChange<std::int64_t>(
      [name] { return tr("change %1").arg(QString::fromStdString(name)); },
      before,
      value,
      [this, id, name](const std::int64_t& wanted) {
        session_.set_control({id, name, wanted});
        Q_EMIT control_set({id, name, wanted});
      },
      static_cast<int>(kControls + id % 1000000)));
}

void LivePlace::change_lock(bool is_locked) {
  undo_.push(new ValueChange<bool>(
      [is_locked] { return is_locked ? tr("lock brightness") : tr("unlock brightness"); },
      !is_locked,
      is_locked,
      [this](const bool& value) {
        session_.set_lock(value);
        Q_EMIT lock_set(value);
      }));
}

void LivePlace::show_status() {
  const LiveStatus& status = session_.status();
  controls_->set_controls(status.controller.controls, status.controller.is_locked);
  const auto& view = session_.view();
  contact_->setText(view ? contact_words(view->result, &session_.touch_history())
                         : tr("No picture yet."));
  force_->news();
  show_times();
}

void LivePlace::show_times() {
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
  add(tr("All together"), times.total);
  times_->setText(rows.isEmpty() ? tr("No picture yet.")
                                 : QStringLiteral("<table>%1</table>").arg(rows));
}

}  // namespace alltact
