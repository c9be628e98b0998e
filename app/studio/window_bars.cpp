#include "app/studio/window_bars.h"

#include "calibration/reference/reference_recording.h"
#include "core/base/slow_disk.h"
#include "widgets/language.h"
#include "widgets/theme.h"

#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace alltact {
namespace {

constexpr int kRailIcon = 28, kRailWidth = 76;

}  // namespace

NavigationBar::NavigationBar(const std::vector<Page*>& pages, QWidget* parent)
    : Translated(parent), pages_(pages), buttons_(new QButtonGroup(this)) {
  setObjectName(QStringLiteral("rail"));
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::AlternateBase);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 8, 6, 8);
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    QAbstractButton* button = make_button();
    buttons_->addButton(button, static_cast<int>(i));
    column->addWidget(button);
  }
  column->addStretch();
  mark(0);
  connect(buttons_, &QButtonGroup::idClicked, this,
          [this](int id) { Q_EMIT chosen(pages_[static_cast<std::size_t>(id)]->name()); });
  say([this] { name_buttons(); });
  set_icons();
}

void NavigationBar::mark(std::size_t page) {
  buttons_->button(static_cast<int>(page))->setChecked(true);
  for (QAbstractButton* button : buttons_->buttons())
    button->setFocusPolicy(button->isChecked() ? Qt::TabFocus : Qt::NoFocus);
}

QAbstractButton* NavigationBar::make_button() {
  auto* button = new QToolButton;
  button->setCheckable(true);
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setIconSize({kRailIcon, kRailIcon});
  button->setMinimumHeight(64);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  button->setFocusPolicy(Qt::TabFocus);
  button->setAutoRaise(true);
  return button;
}

void NavigationBar::name_buttons() {
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    QAbstractButton* button = buttons_->button(static_cast<int>(i));
    button->setText(pages_[i]->title());
    button->setMinimumWidth(std::max(kRailWidth, button->sizeHint().width()));
    button->setToolTip(tr("%1 (Ctrl+%2)").arg(without_mnemonic(pages_[i]->menu_text())).arg(i + 1));
  }
}

void NavigationBar::set_icons() {
  for (QAbstractButton* button : buttons_->buttons()) {  // none before they are made
    const Page& page = *pages_[static_cast<std::size_t>(buttons_->id(button))];
    button->setIcon(icon(QString::fromStdString(page.name()), palette()));
  }
}

void NavigationBar::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) set_icons();
}

namespace {

/// A warning or a remark: a sentence alone.
Problem note_of(const Message& sentence) {
  return Problem::of(Error{sentence, "", ""}, Meaning::kDoubtful);
}

}  // namespace

NotificationBar::NotificationBar(const LiveSession& session, const SessionStore& store,
                                 const Pedal& pedal, Workspace& work,
                                 const std::vector<Page*>& pages,
                                 std::function<std::vector<std::filesystem::path>()> slow_files)
    : session_(session),
      session_store_(store),
      pedal_(pedal),
      work_(work),
      pages_(pages),
      slow_files_(std::move(slow_files)) {
  connect(&session_, &LiveSession::status_ready, this, &NotificationBar::follow);
  connect(&pedal_, &Pedal::changed, this, &NotificationBar::follow);
  connect(&work_, &Workspace::source_changed, this, [this] { open_error_.reset(); });
  connect(&work_, &Workspace::finger_changed, this, [this] { open_error_.reset(); });
  say([this] { follow(); });
}

void NotificationBar::follow() {
  Problems problems;
  add_session_problems(problems);
  add_disk_problems(problems);
  add_pedal_problems(problems);
  add_source_problems(problems);
  add_finger_problems(problems);
  for (Page* page : pages_) page->add_problems(problems);
  set_problems(std::move(problems));
}

void NotificationBar::show_error(const Error& why) {
  open_error_ = why;
  follow();
}

void NotificationBar::forget_crash() {
  is_crash_reported_ = true;
  follow();
}

void NotificationBar::add_session_problems(Problems& problems) {
  if (session_store_.has_crashed() && !is_crash_reported_)
    problems.push_back({Meaning::kDoubtful, tr("The program ended unexpectedly last time."),
                        tr("Your work is saved."), tr("&Go on with it"),
                        [this] { Q_EMIT continue_requested(); }});
  if (const auto unkept = session_store_.problem())
    problems.push_back(Problem::of(*unkept, Meaning::kDoubtful));
}

/// One sentence for a disk that holds up many files.
void NotificationBar::add_disk_problems(Problems& problems) const {
  if (!slow_files_) return;
  const auto files = slow_files_();
  if (!files.empty()) problems.push_back(Problem::of(slow_disk(files.front()), Meaning::kDoubtful));
}

void NotificationBar::add_pedal_problems(Problems& problems) const {
  if (const auto& away = pedal_.problem())
    problems.push_back({Meaning::kDoubtful, tr("The foot pedal sends no signal now."),
                        window_sentence(away->message())});
}

void NotificationBar::add_source_problems(Problems& problems) {
  if (open_error_) problems.push_back(Problem::of(*open_error_));
  const LiveStatus& status = session_.status();
  if (status.source.problem) problems.push_back(Problem::of(*status.source.problem));
  if (status.source.state == SourceState::kEnded)
    problems.push_back({Meaning::kDoubtful,
                        tr("The source has ended; its last image is shown."),
                        {},
                        tr("&Play it again"),
                        [this, inputs = work_.state().source] { work_.open_source(inputs); }});
  if (status.controller.problem) problems.push_back(Problem::of(*status.controller.problem));
  if (!status.remark.empty()) problems.push_back(note_of(status.remark));
}

void NotificationBar::add_finger_problems(Problems& problems) const {
  const FingerStatus& finger = session_.status().finger;
  if (finger.problem) problems.push_back(Problem::of(*finger.problem));
  for (const Message& warning : finger.warnings) problems.push_back(note_of(warning));
  const auto& view = session_.view();
  if (!view) return;
  if (view->problem) problems.push_back(Problem::of(*view->problem));
  const FramePtr& frame = view->result.frame;
  if (!finger.finger || !finger.has_reference || !frame) return;
  const Message other = other_settings_than_stored(*frame, *finger.finger);
  if (!other.empty()) problems.push_back(note_of(other));
}

StatusLine::StatusLine(const LiveSession& session)
    : session_(session),
      delivered_(new QLabel),
      lost_(new QLabel),
      time_(new QLabel),
      age_(new AgeLabel) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // a long text must not widen the window
  for (QLabel* label : labels()) {
    label->setContentsMargins(6, 0, 12, 0);
    addWidget(label);
  }
  connect(&session_, &LiveSession::status_ready, this, &StatusLine::follow);
  say([this] {
    delivered_->setAccessibleName(tr("Frames delivered"));
    lost_->setAccessibleName(tr("Frames lost"));
    time_->setAccessibleName(tr("Time per frame"));
    follow();
  });
}

std::array<QLabel*, 4> StatusLine::labels() const { return {delivered_, lost_, age_, time_}; }

void StatusLine::follow() {
  const bool is_open = session_.view() != nullptr;
  for (QLabel* label : labels()) label->setVisible(is_open);
  if (!is_open) return;
  const LiveStatus& status = session_.status();
  const QLocale locale;
  show_source(status.source, status.shown_per_s);
  age_->show_age(status.age_ms);
  time_->setText(tr("%1 ms per frame").arg(locale.toString(session_.times_ms().total, 'f', 1)));
  layout()->activate();  // a text that has grown is painted with its own width
}

void StatusLine::show_source(const SourceStatus& source, double shown_per_s) {
  const QLocale locale;
  const QString rates = tr("%1 frames/s, %2 delivered, %3 shown per second")
                            .arg(locale.toString(source.frames_per_s, 'f', 1),
                                 locale.toString(static_cast<qulonglong>(source.delivered)),
                                 locale.toString(shown_per_s, 'f', 1));
  delivered_->setText(source.is_catching_up ? tr("%1 (catching up)").arg(rates) : rates);
  const std::uint64_t damaged = source.camera ? source.camera->damaged : 0;
  lost_->setText(tr("%n frame(s) lost", nullptr, static_cast<int>(source.missing + damaged)));
}

}  // namespace alltact
