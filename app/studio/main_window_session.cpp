// What is worked on: finger and source, what was done can be undone, what was kept comes back.
#include "app/studio/main_window.h"
#include "core/sources/open/open_source.h"
#include "widgets/value_change.h"

namespace alltact {
namespace {

constexpr std::size_t kMostRecent = 10;
using Inputs = std::vector<std::filesystem::path>;
using InputsChange = ValueChange<Inputs>;

QString name_of(const std::filesystem::path& path) {
  const auto name = path.has_filename() ? path.filename() : path.parent_path().filename();
  return QString::fromStdString(name.string());
}

bool changes_source(const QUndoCommand& step) {
  if (dynamic_cast<const InputsChange*>(&step) != nullptr) return true;
  for (int i = 0; i < step.childCount(); ++i)
    if (changes_source(*step.child(i))) return true;
  return false;
}

}  // namespace

QString MainWindow::source_name() const {
  return state_.source.empty() ? tr("none", "source") : name_of(state_.source.front());
}

void MainWindow::open_finger(const std::filesystem::path& folder) {
  std::error_code ignored;
  const auto wanted = folder.empty() ? folder : std::filesystem::absolute(folder, ignored);
  if (wanted == state_.finger) return set_finger(wanted);
  undo_.push(new ValueChange<std::filesystem::path>(
      wanted.empty() ? tr("close the finger") : tr("open finger %1").arg(name_of(wanted)),
      state_.finger,
      wanted,
      [this](const std::filesystem::path& finger) { set_finger(finger); }));
}

void MainWindow::set_finger(const std::filesystem::path& folder) {
  std::error_code ignored;
  state_.finger = folder.empty() ? folder : std::filesystem::absolute(folder, ignored);
  session_.open_finger(state_.finger);
  if (!folder.empty()) {
    std::erase(state_.recent_fingers, state_.finger);
    state_.recent_fingers.insert(state_.recent_fingers.begin(), state_.finger);
    if (state_.recent_fingers.size() > kMostRecent) state_.recent_fingers.resize(kMostRecent);
  }
  export_action_->setEnabled(!folder.empty());
  fill_recent_menu();
  keep();
}

void MainWindow::open_source(const Inputs& inputs) {
  if (inputs == state_.source) return set_source(inputs);
  undo_.push(new InputsChange(
      inputs.empty() ? tr("close the source") : tr("open source %1").arg(name_of(inputs.front())),
      state_.source,
      inputs,
      [this](const Inputs& wanted) { set_source(wanted); }));
}

void MainWindow::set_source(const Inputs& inputs) {
  state_.source = inputs;
  if (inputs.empty()) {
    session_.close_source();
    live_or_start_->setCurrentWidget(start_);
  } else {
    session_.set_lock(state_.is_locked);
    session_.open_source(inputs, state_.controls[source_name().toStdString()]);
    live_or_start_->setCurrentWidget(live_);
  }
  keep();
}

void MainWindow::make_undo_entries() {
  undo_action_ = edit_menu_->addAction(QString());
  redo_action_ = edit_menu_->addAction(QString());
  undo_action_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Z));
  redo_action_->setShortcuts(
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  connect(undo_action_, &QAction::triggered, &undo_, &QUndoStack::undo);
  connect(redo_action_, &QAction::triggered, &undo_, &QUndoStack::redo);
  connect(&undo_, &QUndoStack::indexChanged, this, &MainWindow::show_undo);
}

/// A key pressed once too often must not cost a recording: whoever wants another source meanwhile
/// chooses it.
bool MainWindow::would_end_recording(const QUndoCommand* step) const {
  const bool is_recording = session_.status().recording.state == RecordingState::kRunning;
  return is_recording && step != nullptr && changes_source(*step);
}

void MainWindow::show_undo() {
  undo_action_->setEnabled(undo_.canUndo() &&
                           !would_end_recording(undo_.command(undo_.index() - 1)));
  redo_action_->setEnabled(undo_.canRedo() && !would_end_recording(undo_.command(undo_.index())));
  undo_action_->setText(undo_.canUndo() ? tr("&Undo: %1").arg(undo_.undoText()) : tr("&Undo"));
  redo_action_->setText(undo_.canRedo() ? tr("&Redo: %1").arg(undo_.redoText()) : tr("&Redo"));
}

void MainWindow::keep() {
  state_.view = live_->options();
  state_.inspect = {inspect_->options(), inspect_->frame_number()};
  keeper_.keep(state_);
}

void MainWindow::restore(const SessionState& state) {
  state_.place = state.place;
  live_->set_options(state.view);
  const bool was_inspecting = !state.inspect.options.recording.empty();
  if (!state.finger.empty() || !state.source.empty() || was_inspecting) {
    undo_.beginMacro(tr("go on with the last session"));
    if (!state.finger.empty()) open_finger(state.finger);
    if (!state.source.empty()) open_source(state.source);
    inspect_->restore(state.inspect.options, state.inspect.frame);
    undo_.endMacro();
  }
  go_to(state.place);
}

void MainWindow::name_last() {
  const auto& last = keeper_.last();
  QStringList what;
  if (last && !last->finger.empty()) what << tr("finger %1").arg(name_of(last->finger));
  if (last && !last->source.empty()) what << tr("source %1").arg(name_of(last->source.front()));
  if (last && !last->inspect.options.recording.empty())
    what << tr("recording %1").arg(name_of(last->inspect.options.recording));
  start_->set_last(what.join(QStringLiteral(", ")));
}

void MainWindow::go_on_with_last() {
  is_crash_told_ = true;
  if (keeper_.last()) restore(*keeper_.last());
  follow();
}

}  // namespace alltact
