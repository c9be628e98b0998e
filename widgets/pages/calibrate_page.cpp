#include "widgets/pages/calibrate_page.h"

#include "calibration/reference/reference_recording.h"
#include "widgets/theme.h"
#include "widgets/undo_step.h"

#include <QHBoxLayout>

namespace alltact {
namespace {

constexpr int kMissingLines = 2;
constexpr int kGoodPresses = 6;  // with fewer, another press is advised before the next step

}  // namespace

CalibratePage::CalibratePage(LiveSession& session, QUndoStack& undo,
                             const std::filesystem::path& work_folder,
                             const std::string& program_version, QWidget* parent)
    : Page("calibrate", parent),
      session_(session),
      collection_(undo),
      run_(collection_, undo, program_version),
      forecast_(collection_, run_),
      lens_(new LensPage(session, work_folder)),
      finger_(new FingerPage(session, undo)),
      presses_(new PressesPage(session, collection_, run_, forecast_)),
      mapping_(new MappingPage(collection_, run_, forecast_)),
      verdict_(new VerdictPage(run_)),
      check_(new CheckPage(session, collection_, run_, undo, program_version)),
      pages_{lens_, finger_, presses_, mapping_, verdict_, check_},
      steps_(new StepList),
      stack_(new QStackedWidget),
      column_(new QVBoxLayout(this)),
      foot_(new QWidget),
      foot_row_(new QBoxLayout(QBoxLayout::LeftToRight, foot_)),
      missing_(new ReservedText(kMissingLines)),
      next_(new QPushButton) {
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(3);
  column_->addWidget(steps_);
  connect(steps_, &StepList::chosen, this, &CalibratePage::go_to);
  for (StepPage* page : pages_) {
    stack_->addWidget(page);
    connect(page, &StepPage::changed, this, &CalibratePage::show_steps);
    connect(page, &StepPage::problems_changed, this, &CalibratePage::problems_changed);
    connect(page, &StepPage::focus_released, this, &CalibratePage::focus_next);
  }
  column_->addWidget(stack_, 1);
  foot_row_->setContentsMargins(0, 0, 0, 0);
  foot_row_->addWidget(new UndoBar(undo, session));
  foot_row_->addWidget(missing_, 1);
  foot_row_->addWidget(next_);
  set_primary(*next_, false);
  reserve_room(*next_);  // there is none after the last step
  missing_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  show_page(0);
  connect(next_, &QPushButton::clicked, this, &CalibratePage::go_on);
  connect(finger_, &FingerPage::new_finger_requested, this, &CalibratePage::new_finger_requested);
  connect(finger_, &FingerPage::open_finger_requested, this, &CalibratePage::open_finger_requested);
  connect(finger_, &FingerPage::record_requested, this,
          [this] { Q_EMIT page_requested("record"); });
  connect(mapping_, &MappingPage::press_requested, this, [this](const std::string& name) {
    go_to(kPressesStep);
    presses_->show_press(name);
  });
  connect(verdict_, &VerdictPage::presses_requested, this, [this] { go_to(kPressesStep); });
  connect(verdict_, &VerdictPage::check_requested, this, [this] { go_to(kSteps - 1); });
  connect(check_, &CheckPage::checked, &run_, &CalibrationRun::reload);
  connect(&run_, &CalibrationRun::changed, this, &CalibratePage::follow_run);
  connect(&session_, &LiveSession::status_ready, this,
          [this, followed = std::filesystem::path()]() mutable {
            const auto& folder = session_.status().finger.folder;
            follows_due_ = follows_due_ || folder != followed;
            followed = folder;
            follow();
          });
  is_constructed_ = true;
  say([this] { show_steps(); });
}

void CalibratePage::follow() {
  const FingerStatus& finger = session_.status().finger;
  const bool has_presses = finger.state == FingerState::kReady && finger.has_reference;
  // While a finger is loaded again its presses stay.
  const bool is_reloading =
      finger.state == FingerState::kLoading && finger.folder == collection_.folder();
  const auto folder = has_presses || is_reloading ? finger.folder : std::filesystem::path();
  if (folder != collection_.folder()) {
    collection_.open(folder);
    run_.reload();
  }
  lens_->show_status();
  finger_->show_status();
  show_steps();
}

void CalibratePage::add_problems(std::vector<Problem>& problems) {
  if (isVisible())
    for (Problem& problem : pages_[step_]->problems()) problems.push_back(std::move(problem));
}

void CalibratePage::reload() {
  const auto finger = open_finger(collection_.folder());
  const PressAnalyser* analyser = collection_.analyser();
  const auto has_same_face = [](const Face& a, const Face& b) {
    return a.width_mm == b.width_mm && a.layer_mm == b.layer_mm && a.plane_z_mm == b.plane_z_mm;
  };
  if (!finger || analyser == nullptr ||
      !has_same_reference(analyser->finger(), (*finger)->finger) ||
      !has_same_face(analyser->finger().face, (*finger)->finger.face))
    collection_.open(collection_.folder());
  run_.reload();
}

std::size_t CalibratePage::last_open() const {
  std::size_t step = 0;
  while (step + 1 < kSteps && pages_[step]->missing().isEmpty()) ++step;
  return step;
}

std::string CalibratePage::leads_to() const {
  return pages_[step_] == finger_ && finger_->leads_to_record() ? "record" : std::string();
}

std::size_t CalibratePage::due_step() const {
  return has_unseen_verdict_ ? kVerdictStep : last_open();
}

void CalibratePage::go_on() {
  const bool is_first_calibration =
      pages_[step_] == presses_ && run_.state() == CalibrationState::kNone && !run_.is_running();
  if (is_first_calibration) run_.start();
  go_to(step_ + 1);
}

void CalibratePage::begin_next_step() { go_to(due_step()); }

void CalibratePage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  show_steps();
}

void CalibratePage::follow_run() {
  const bool is_done = was_calibrating_ && !run_.is_running();
  was_calibrating_ = run_.is_running();
  if (is_done && !run_.problem()) has_unseen_verdict_ = pages_[step_] != verdict_;
  if (run_.state() == CalibrationState::kNone) has_unseen_verdict_ = false;
}

void CalibratePage::go_to(std::size_t step) {
  follows_due_ = false;
  show_page(std::min(step, last_open()));
  show_steps();
  QWidget* control = pages_[step_]->main_control();
  control->isEnabled() && control->isVisible() ? control->setFocus() : focus_next();
}

void CalibratePage::show_page(std::size_t step) {
  if (step == step_ && stack_->currentWidget() == pages_[step_] && foot_->parentWidget() != nullptr)
    return;
  step_ = step;
  stack_->setCurrentWidget(pages_[step_]);
  if (step_ == kVerdictStep) has_unseen_verdict_ = false;
  QVBoxLayout* side_column = pages_[step_]->foot();
  foot_row_->setDirection(side_column != nullptr ? QBoxLayout::TopToBottom
                                                 : QBoxLayout::LeftToRight);
  (side_column != nullptr ? side_column : column_)->addWidget(foot_);
  foot_->show();  // at once: a new parent hides it
}

void CalibratePage::show_steps() {
  if (!is_constructed_) return;
  finger_->set_camera_file(lens_->camera_file());
  const bool is_reading = session_.status().finger.state == FingerState::kLoading;
  if (follows_due_) {
    show_page(due_step());
    follows_due_ =
        !isVisible() || is_reading || (!collection_.folder().empty() && !collection_.is_ready());
  }
  const std::size_t open = last_open();
  if (step_ > open) show_page(open);  // an earlier step is not done any more
  std::vector<Step> steps;
  for (std::size_t i = 0; i < kSteps; ++i)
    steps.push_back({pages_[i]->title(),
                     i <= open && pages_[i]->state() != StepState::kToDo ? pages_[i]->state()
                     : is_reading                                        ? StepState::kReading
                                                                         : StepState::kToDo,
                     i <= open, pages_[open]->missing()});
  steps_->show_steps(steps, step_);
  const bool is_last = step_ + 1 == kSteps;
  const QString missing = pages_[step_]->missing();
  missing_->setText(missing);
  next_->setVisible(!is_last);
  next_->setToolTip(tr("Opens the next step"));
  next_->setEnabled(missing.isEmpty());
  if (!is_last) next_->setText(tr("&Next: %1").arg(pages_[step_ + 1]->title()));
  const bool has_presses = run_.state() == CalibrationState::kCurrent
                               ? verdict_->state() == StepState::kDone
                               : collection_.usable_count() >= kGoodPresses;
  const bool is_enough = pages_[step_] != presses_ || has_presses;
  const bool is_done = pages_[step_]->state() == StepState::kDone;
  const bool goes_on = !is_last && missing.isEmpty() && is_enough && is_done;
  set_primary(*next_, goes_on);
  const QPushButton* action_button = goes_on ? nullptr : pages_[step_]->action_button();
  for (auto* button : pages_[step_]->findChildren<QPushButton*>())
    if (button != next_ && (button == action_button || is_primary(*button)))
      set_primary(*button, button == action_button);
  follow_focus();
}

namespace {

constexpr int kMaxTextWidth_px = 180, kIconAndFrame_px = 40;

}  // namespace

UndoBar::UndoBar(QUndoStack& undo, const LiveSession& session, QWidget* parent)
    : Translated(parent),
      stack_(undo),
      session_(session),
      undo_(new QToolButton),
      redo_(new QToolButton) {
  auto* row = without_margins(new QHBoxLayout(this));
  add_widgets(*row, {undo_, redo_});
  row->addStretch();
  undo_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  undo_->setFixedWidth(kMaxTextWidth_px + kIconAndFrame_px);  // for all names of steps
  connect(undo_, &QToolButton::clicked, &stack_, &QUndoStack::undo);
  connect(redo_, &QToolButton::clicked, &stack_, &QUndoStack::redo);
  connect(&stack_, &QUndoStack::indexChanged, this, &UndoBar::follow);
  connect(&session_, &LiveSession::status_ready, this, &UndoBar::follow);
  set_icons();
  say([this] { follow(); });
}

void UndoBar::follow() {
  const bool is_recording = session_.status().recording.state == RecordingState::kRunning;
  undo_->setEnabled(stack_.canUndo() && !is_recording);
  redo_->setEnabled(stack_.canRedo() && !is_recording);
  const QString undo = stack_.canUndo() ? tr("Undo: %1").arg(undo_words(stack_)) : tr("Undo");
  const QString redo = stack_.canRedo() ? tr("Redo: %1").arg(redo_words(stack_)) : tr("Redo");
  undo_->setText(undo_->fontMetrics().elidedText(undo, Qt::ElideRight, kMaxTextWidth_px));
  undo_->setToolTip(tr("%1 (Ctrl+Z)").arg(undo));
  redo_->setToolTip(tr("%1 (Ctrl+Shift+Z)").arg(redo));
  undo_->setAccessibleName(undo);
  redo_->setAccessibleName(redo);
}

void UndoBar::set_icons() {
  undo_->setIcon(icon(QStringLiteral("undo"), palette()));
  redo_->setIcon(icon(QStringLiteral("redo"), palette()));
}

void UndoBar::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) set_icons();
}

}  // namespace alltact
