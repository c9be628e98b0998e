#include "widgets/pages/inspect_page.h"

#include "widgets/inspect/face_positions.h"
#include "widgets/panels/side_panel.h"
#include "widgets/shell/elided_label.h"
#include "widgets/touch/contact_words.h"
#include "widgets/value_change.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <cmath>

namespace alltact {
namespace {

constexpr int kInspectSideWidth = 296;
constexpr int kFirstTurn = 21000, kTurns = 1000;  // merge ids
// Steps of wheel and keys within this time are one undo step.
constexpr int kOneTurn_ms = 700;

}  // namespace

InspectPage::InspectPage(LiveSession& session, QUndoStack& undo, QWidget* parent)
    : Page("inspect", parent),
      session_(session),
      undo_(undo),
      pair_(inspection_),
      problems_(new ProblemList),
      live_(new QPushButton),
      video_(new QPushButton),
      folder_(new QPushButton),
      save_bar_(new SaveBar),
      shown_(new ElidedLabel(Qt::ElideMiddle)),
      summary_(new QLabel),
      saved_(new ElidedLabel(Qt::ElideMiddle)),
      probe_(new ElidedLabel),
      first_(new InspectPane(PaneContent::kFirst)),
      second_(new InspectPane(PaneContent::kSecond)),
      time_line_(new TimeLine),
      side_(new InspectSide),
      pair_box_(new PairBox(pair_)),
      contact_group_(new QGroupBox),
      contact_(new QLabel),
      force_(new ForceBox([this] { return shown_force(); })) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  auto* column = new QVBoxLayout;
  column->setSpacing(3);
  column->addWidget(make_header());
  column->addWidget(problems_);
  auto* panes = new QHBoxLayout;
  panes->addWidget(first_, 1);
  panes->addWidget(second_, 1);
  column->addLayout(panes, 1);
  auto* words = new QHBoxLayout;
  words->addWidget(summary_);
  words->addWidget(probe_, 1);
  column->addLayout(words);
  column->addWidget(time_line_);
  row->addLayout(column, 1);
  row->addWidget(make_side());
  second_->hide();
  time_line_->hide();
  connect_parts();
  connect_panes();
  connect_pair();
  if (!VtkView::is_supported()) options_.shown_as = ShownAs::kHeightMap;
  say([this] { name_parts(); });
  set_options(options_);
}

QWidget* InspectPage::make_header() {
  auto* header = new QWidget;
  auto* row = new QHBoxLayout(header);
  row->setContentsMargins(0, 0, 0, 0);
  live_->setCheckable(true);
  live_->setChecked(true);
  for (QPushButton* button : {live_, video_, folder_, pair_box_->open_button()})
    row->addWidget(button);
  shown_->setMinimumWidth(1);
  row->addWidget(shown_, 1);
  saved_->setMinimumWidth(1);
  saved_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  saved_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return header;
}

QWidget* InspectPage::make_side() {
  const SidePanel panel(kInspectSideWidth);
  panel.column->addWidget(pair_box_);
  make_contact(*panel.column);
  panel.column->addWidget(side_);
  panel.foot->addWidget(saved_);
  panel.foot->addWidget(save_bar_);
  return panel.root;
}

void InspectPage::connect_parts() {
  connect(live_, &QPushButton::clicked, this, &InspectPage::go_live);
  connect(video_, &QPushButton::clicked, this, &InspectPage::choose_video);
  connect(folder_, &QPushButton::clicked, this, &InspectPage::choose_folder);
  connect(&session_, &LiveSession::view_ready, this, &InspectPage::follow_live);
  connect(&session_, &LiveSession::status_ready, this, &InspectPage::follow_finger);
  connect(&inspection_, &Inspection::frame_ready, this, &InspectPage::show_frame);
  connect(&inspection_, &Inspection::state_changed, this, &InspectPage::show_state);
  constexpr int kSummaryInterval_ms = 200;
  summaries_timer_.setSingleShot(true);
  summaries_timer_.setInterval(kSummaryInterval_ms);
  connect(&summaries_timer_, &QTimer::timeout, this, &InspectPage::show_summaries);
  connect(&inspection_, &Inspection::summaries_changed, this, [this] {
    if (!summaries_timer_.isActive()) summaries_timer_.start();
  });
  connect(time_line_, &TimeLine::frame_requested, &inspection_, &Inspection::show_frame);
  connect(side_, &InspectSide::changed, this, &InspectPage::change_options);
  connect(save_bar_, &SaveBar::save_requested, this, &InspectPage::choose_file);
  connect(save_bar_, &SaveBar::stop_requested, &saving_, &BackgroundWork::stop);
  connect(&saving_, &BackgroundWork::progressed, this, &InspectPage::show_saving);
  connect(&saving_, &BackgroundWork::finished, this, &InspectPage::show_saving);
}

void InspectPage::connect_panes() {
  connect(first_, &InspectPane::clicked, this, &InspectPage::set_point);
  connect(second_, &InspectPane::clicked, this, [this](QPointF pixel, bool is_second) {
    if (!options_.second) set_point(pixel, is_second);  // points lie on the first finger
  });
  for (InspectPane* pane : {first_, second_}) {
    InspectPane* other = pane == first_ ? second_ : first_;
    connect(pane, &InspectPane::pointed_at, this, [this](const std::optional<QPointF>& pixel) {
      pointed_at_ = pixel;
      show_probe();
    });
    connect(pane, &InspectPane::view_changed, other, [pane, other] { other->copy_look(*pane); });
    connect(pane, &InspectPane::view_settled, this, [this, pane](bool is_drag) {
      store_look(*pane, is_drag);
    });
    connect(pane, &InspectPane::reset_requested, this, [this] {
      InspectOptions next = options_;
      next.view_pose.reset();
      change_options(
          next, [] { return tr("show all again"); }, -1);
    });
  }
}

void InspectPage::name_parts() {
  live_->setText(tr("&Live finger"));
  video_->setText(tr("Vide&o…"));
  folder_->setText(tr("Folder of p&ictures…"));
  shown_->setAccessibleName(tr("What is shown"));
  summary_->setAccessibleName(tr("Deepest contact"));
  saved_->setAccessibleName(tr("What was saved"));
  probe_->setAccessibleName(tr("Under the pointer"));
  contact_group_->setTitle(tr("Contact"));
  contact_->setToolTip(contact_words_help());
  contact_->setAccessibleName(tr("What touches the finger"));
  show_frame();
}

void InspectPage::change_options(const InspectOptions& options,
                                 const StepWords& what,
                                 int merge_id) {
  if (options == options_) return;
  undo_.push(new ValueChange<InspectOptions>(
      what,
      options_,
      options,
      [this](const InspectOptions& value) { set_options(value); },
      merge_id));
}

void InspectPage::set_options(const InspectOptions& options) {
  const InspectOptions before = std::exchange(options_, options);
  const Comparison comparison = options.shown_comparison();
  inspection_.set_other(options.comparand());
  first_->set_content(comparison == Comparison::kDifference ? PaneContent::kDifference
                                                            : PaneContent::kFirst);
  second_->set_content(options.second ? PaneContent::kFirst : PaneContent::kSecond);
  first_->set_options(options);
  InspectOptions others = options;
  if (options.second) others.a = others.b = std::nullopt;  // on the first finger only
  second_->set_options(others);
  side_->set_options(options);
  if (options.recording != before.recording) show_recording();
  pair_.open(options.second);
  show_frame();
  Q_EMIT changed();
}

/// Each drag is an undo step; quick steps of the wheel or of keys are merged into one.
void InspectPage::store_look(const InspectPane& pane, bool is_drag) {
  if (is_drag || !since_turn_.isValid() || since_turn_.elapsed() > kOneTurn_ms) ++turns_;
  if (is_drag)
    since_turn_.invalidate();
  else
    since_turn_.start();
  InspectOptions next = options_;
  next.view_pose = pane.face_pane()->scene().view_pose();
  change_options(
      next, [] { return tr("turn the 3D view"); }, is_drag ? -1 : kFirstTurn + turns_ % kTurns);
}

void InspectPage::set_point(QPointF pixel, bool is_second) {
  if (!inspection_.frame()) return;
  const auto position = position_of(*inspection_.frame(), nearest_pixel({pixel.x(), pixel.y()}));
  if (!position) return;
  InspectOptions next = options_;
  (is_second ? next.b : next.a) = position;
  change_options(
      next, [is_second] { return is_second ? tr("put point B") : tr("put point A"); }, -1);
}

/// The points do not apply to another finger.
void InspectPage::drop_points() {
  if (!options_.a && !options_.b) return;
  InspectOptions next = options_;
  next.a.reset();
  next.b.reset();
  set_options(next);
}

void InspectPage::open(const std::filesystem::path& recording) {
  if (recording == options_.recording) return show_recording();
  InspectOptions next = options_;
  next.recording = recording;
  change_options(
      next, [recording] { return tr("inspect %1").arg(text_of(recording.filename())); }, -1);
}

void InspectPage::restore(const InspectOptions& options, std::size_t frame) {
  last_frame_[options.recording] = frame;
  InspectOptions next = options;
  if (!VtkView::is_supported()) next.shown_as = ShownAs::kHeightMap;
  change_options(
      next, [] { return tr("go on with what was inspected"); }, -1);
}

std::size_t InspectPage::frame_number() const {
  const auto at = last_frame_.find(options_.recording);
  return options_.recording.empty() || at == last_frame_.end() ? 0 : at->second;
}

void InspectPage::show_recording() {
  live_->setChecked(options_.recording.empty());
  time_line_->begin(frame_number());
  follow_finger();
  inspection_.open(options_.recording, frame_number());
  if (options_.recording.empty()) follow_live();
  show_frame();
}

void InspectPage::go_live() {
  live_->setChecked(true);
  if (options_.recording.empty()) return;
  InspectOptions next = options_;
  next.recording.clear();
  if (next.second) next.view_pose.reset();
  next.second.reset();
  change_options(
      next, [] { return tr("inspect the live finger"); }, -1);
}

void InspectPage::follow_live() {
  const LiveStatus& status = session_.status();
  if (!options_.recording.empty() || !isVisible() || !session_.view() || !status.finger.finger)
    return;
  inspection_.show_live(session_.view(), *status.finger.finger);
}

void InspectPage::follow_finger() {
  const FingerStatus& finger = session_.status().finger;
  if (!finger.folder.empty()) {
    if (!points_finger_.empty() && points_finger_ != finger.folder) drop_points();
    points_finger_ = finger.folder;
  }
  if (finger.state != FingerState::kLoading) {
    inspection_.set_finger(finger.folder);
    pair_.set_first(finger.folder);
  }
  show_state();
}

void InspectPage::showEvent(QShowEvent* event) {
  Translated::showEvent(event);
  inspection_.set_scanning(true);
  follow_live();
}

void InspectPage::hideEvent(QHideEvent* event) {
  inspection_.set_scanning(false);
  Translated::hideEvent(event);
}

}  // namespace alltact
