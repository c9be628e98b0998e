#include "widgets/pages/live_page.h"

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
  connect(
      start_, &StartPanel::new_finger_requested, this, [this] { Q_EMIT new_finger_requested({}); });
  say([this] { name_parts(); });
  set_options(options_);
}

void LivePage::show_start(bool is_requested) {
  is_start_requested_ = is_requested;
  pages_->setCurrentIndex(is_requested ? 0 : 1);
}

QWidget* LivePage::make_view_page() {
  auto* page = new QWidget;
  auto* row = new QHBoxLayout(page);
  row->setContentsMargins(0, 0, 0, 0);
  auto* column = new QVBoxLayout;
  panels_->addWidget(panel_, 1);
  column->addLayout(panels_, 1);
  column->addWidget(force_->take_plot());
  row->addLayout(column, 1);
  row->addWidget(make_side());
  return page;
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
  overlay_group_->setTitle(tr("Over the picture"));
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

QWidget* LivePage::make_side() {
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
  side.column->addWidget(overlay_group_);
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
  return side.root;
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
      [name] { return tr("change %1").arg(QString::fromStdString(name)); },
      before,
      value,
      [this, id, name](const std::int64_t& requested) {
        session_.set_control({id, name, requested});
        Q_EMIT control_set({id, name, requested});
      },
      static_cast<int>(kControls + id % 1000000)));
}

void LivePage::change_lock(bool is_locked) {
  undo_.push(new ValueChange<bool>(
      [is_locked] { return is_locked ? tr("lock brightness") : tr("unlock brightness"); },
      !is_locked,
      is_locked,
      [this](const bool& value) {
        session_.set_lock(value);
        Q_EMIT lock_set(value);
      }));
}

void LivePage::show_status() {
  const LiveStatus& status = session_.status();
  controls_->set_controls(status.controller.controls, status.controller.is_locked);
  const auto& view = session_.view();
  contact_->setText(view ? contact_words(view->result, &session_.touch_history())
                         : tr("No picture yet."));
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
  add(tr("All together"), times.total);
  times_->setText(rows.isEmpty() ? tr("No picture yet.")
                                 : QStringLiteral("<table>%1</table>").arg(rows));
}

}  // namespace alltact
