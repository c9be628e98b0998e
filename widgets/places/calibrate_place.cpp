#include "widgets/places/calibrate_place.h"

#include "widgets/shell/icons.h"
#include "widgets/theme.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace alltact {
namespace {

constexpr int kSymbol = 16;

QString state_word(StepState state) {
  switch (state) {
    case StepState::kDone:
      return CalibratePlace::tr("done");
    case StepState::kLookAgain:
      return CalibratePlace::tr("look again");
    case StepState::kToDo:
      break;
  }
  return CalibratePlace::tr("to do");
}

}  // namespace

CalibratePlace::CalibratePlace(LiveSession& session,
                               QUndoStack& undo,
                               const CalibrateTools& tools,
                               QWidget* parent)
    : Translated(parent),
      session_(session),
      desk_(undo),
      run_(desk_, undo, tools.version, tools.program),
      lens_(new LensPage(session, tools.measure_lens, tools.work_folder)),
      finger_(new FingerPage(session)),
      presses_(new PressesPage(session, desk_, run_)),
      mapping_(new MappingPage(desk_, run_)),
      verdict_(new VerdictPage(run_)),
      check_(new CheckPage(session, desk_, run_, undo, tools.version)),
      pages_{lens_, finger_, presses_, mapping_, verdict_, check_},
      buttons_{},
      stack_(new QStackedWidget),
      missing_(wrapped_text()),
      next_(new QPushButton) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* strip = new QHBoxLayout;
  auto* group = new QButtonGroup(this);
  for (std::size_t i = 0; i < kSteps; ++i) {
    auto* button = new QToolButton;
    button->setCheckable(true);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize({kSymbol, kSymbol});
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setMinimumHeight(34);
    button->setFocusPolicy(Qt::StrongFocus);
    group->addButton(button);
    strip->addWidget(button);
    buttons_[i] = button;
    stack_->addWidget(pages_[i]);
    connect(button, &QToolButton::clicked, this, [this, i] { go_to(i); });
    connect(pages_[i], &StepPage::changed, this, &CalibratePlace::show_steps);
  }
  column->addLayout(strip);
  column->addWidget(stack_, 1);
  auto* foot = new QHBoxLayout;
  foot->addWidget(missing_, 1);
  foot->addWidget(next_);
  column->addLayout(foot);
  missing_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  connect(next_, &QPushButton::clicked, this, [this] { go_to(step_ + 1); });
  connect(finger_, &FingerPage::new_finger_wanted, this, &CalibratePlace::new_finger_wanted);
  connect(finger_, &FingerPage::open_finger_wanted, this, &CalibratePlace::open_finger_wanted);
  connect(finger_, &FingerPage::record_wanted, this, &CalibratePlace::record_wanted);
  connect(finger_, &FingerPage::finger_changed, this, &CalibratePlace::finger_changed);
  connect(&run_, &CalibrationRun::finger_changed, this, &CalibratePlace::finger_changed);
  connect(&session_, &LiveSession::status_ready, this, &CalibratePlace::follow);
  say([this] {
    shown_icons_.clear();
    show_steps();
  });
}

void CalibratePlace::follow() {
  const FingerStatus& finger = session_.status().finger;
  const bool is_own = finger.state == FingerState::kReady && !finger.folder.empty();
  const auto folder = is_own && finger.has_reference ? finger.folder : std::filesystem::path();
  // While a finger is loaded again what is known of it stays.
  if (finger.state != FingerState::kLoading && folder != desk_.folder()) {
    desk_.open(folder);
    run_.reload();
  }
  lens_->show_status();
  finger_->show_status();
  show_steps();
}

void CalibratePlace::reload() {
  desk_.open(desk_.folder());
  run_.reload();
}

std::size_t CalibratePlace::last_open() const {
  std::size_t step = 0;
  while (step + 1 < kSteps && pages_[step]->missing().isEmpty()) ++step;
  return step;
}

void CalibratePlace::go_to_next_to_do() {
  go_to(last_open());
}

void CalibratePlace::go_to(std::size_t step) {
  step_ = std::min(step, last_open());
  stack_->setCurrentWidget(pages_[step_]);
  show_steps();
}

void CalibratePlace::show_steps() {
  if (next_ == nullptr || buttons_.back() == nullptr) return;
  finger_->set_camera_file(lens_->camera_file());
  const std::size_t open = last_open();
  if (step_ > open) {  // what it stands on has gone
    step_ = open;
    stack_->setCurrentWidget(pages_[step_]);
  }
  QString icons;
  for (std::size_t i = 0; i < kSteps; ++i) {
    const StepState state = i <= open ? pages_[i]->state() : StepState::kToDo;
    QToolButton* button = buttons_[i];
    button->setEnabled(i <= open);
    button->setChecked(i == step_);
    const QString text = tr("%1 %2: %3").arg(i + 1).arg(pages_[i]->title(), state_word(state));
    if (button->text() != text) {
      button->setText(text);
      button->setAccessibleName(text);
    }
    button->setToolTip(i <= open ? QString() : pages_[open]->missing());
    icons += QChar(static_cast<char16_t>(state));
  }
  if (icons != shown_icons_) {
    shown_icons_ = icons;
    for (std::size_t i = 0; i < kSteps; ++i) {
      const auto state = static_cast<StepState>(icons[static_cast<qsizetype>(i)].unicode());
      const Meaning meaning = state == StepState::kDone ? Meaning::kGood : Meaning::kDoubtful;
      buttons_[i]->setIcon(
          state == StepState::kToDo
              ? QIcon()
              : QIcon(symbol(
                    meaning == Meaning::kGood ? QStringLiteral("good") : QStringLiteral("doubtful"),
                    meaning_colour(meaning, palette()),
                    kSymbol,
                    devicePixelRatioF())));
    }
  }
  const bool is_last = step_ + 1 == kSteps;
  const QString missing = pages_[step_]->missing();
  missing_->setText(missing);
  next_->setVisible(!is_last);
  next_->setEnabled(missing.isEmpty());
  if (!is_last) next_->setText(tr("&Next: %1").arg(pages_[step_ + 1]->title()));
}

void CalibratePlace::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  shown_icons_.clear();
  show_steps();
}

}  // namespace alltact
