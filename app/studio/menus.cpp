#include "app/studio/menus.h"

#include "app/studio/workspace.h"
#include "core/base/program.h"
#include "widgets/shell/export_dialog.h"
#include "widgets/shell/finger_card.h"
#include "widgets/shell/gage_dialog.h"
#include "widgets/shell/new_finger_dialog.h"
#include "widgets/undo_step.h"
#include "widgets/widget_base.h"

#include <QApplication>
#include <QKeyEvent>

namespace alltact {

EditMenu::EditMenu(QUndoStack& undo, const LiveSession& session, QWidget* parent)
    : TranslatedMenu(parent),
      stack_(undo),
      session_(session),
      undo_(addAction(QString())),
      redo_(addAction(QString())) {
  undo_->setShortcut(Qt::CTRL | Qt::Key_Z);
  redo_->setShortcuts({Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y});
  connect(undo_, &QAction::triggered, &stack_, &QUndoStack::undo);
  connect(redo_, &QAction::triggered, &stack_, &QUndoStack::redo);
  connect(&stack_, &QUndoStack::indexChanged, this, &EditMenu::follow);
  connect(&session_, &LiveSession::status_ready, this, &EditMenu::follow);
  say([this] {
    setTitle(tr("&Edit"));
    follow();
  });
}

bool EditMenu::would_end_recording(const QUndoCommand* step) const {
  const bool is_recording = session_.status().recording.state == RecordingState::kRunning;
  return is_recording && step != nullptr && Workspace::changes_source(*step);
}

void EditMenu::follow() {
  const bool can_undo = stack_.canUndo(), can_redo = stack_.canRedo();
  undo_->setEnabled(can_undo && !would_end_recording(stack_.command(stack_.index() - 1)));
  redo_->setEnabled(can_redo && !would_end_recording(stack_.command(stack_.index())));
  undo_->setText(can_undo ? tr("&Undo: %1").arg(undo_words(stack_)) : tr("&Undo"));
  redo_->setText(can_redo ? tr("&Redo: %1").arg(redo_words(stack_)) : tr("&Redo"));
}

namespace {

constexpr int kPathRoom = 420;  // px

}  // namespace

FingerMenu::FingerMenu(Workspace& work, QWidget* window)
    : TranslatedMenu(window), work_(work), recent_(new QMenu(this)) {
  setToolTipsVisible(true);
  recent_->setToolTipsVisible(true);
  connect(&work_, &Workspace::recent_fingers_changed, this, &FingerMenu::fill);
  say([this] {
    recent_->setTitle(tr("&Recent fingers"));
    fill();
  });
}

void FingerMenu::add_to(TranslatedMenu& file) {
  file.add(
      {QKeySequence::Open}, [] { return tr("&Open finger…"); }, [this] { choose(); });
  file.add(
      {QKeySequence::New}, [] { return tr("&New finger…"); }, [this] { make(); });
  file.addMenu(recent_);
  file.add(
      {Qt::CTRL | Qt::Key_L}, [] { return tr("&All fingers…"); }, [this] { list_all(); });
  QAction* exports = file.add(
      {Qt::CTRL | Qt::Key_E}, [] { return tr("E&xport finger…"); }, [this] { export_finger(); });
  const auto follow = [this, exports] { exports->setEnabled(!work_.state().finger.empty()); };
  connect(&work_, &Workspace::finger_changed, exports, follow);
  follow();
  file.add(
      {}, [] { return tr("&Close finger"); }, [this] { work_.open_finger({}); });
}

void FingerMenu::fill() {
  clear();
  recent_->clear();
  const auto folders = offered();
  for (const std::filesystem::path& folder : folders)
    for (QMenu* menu : {recent_, static_cast<QMenu*>(this)}) {
      const QString path = QString::fromStdString(folder.string());
      QAction* entry = menu->addAction(elided_path(path, fontMetrics(), kPathRoom));
      entry->setToolTip(path);
      connect(entry, &QAction::triggered, this, [this, folder] { work_.open_finger(folder); });
    }
  recent_->setEnabled(!folders.empty());
  if (!folders.empty()) addSeparator();
  connect(addAction(tr("&Open finger…")), &QAction::triggered, this, &FingerMenu::choose);
  connect(addAction(tr("&All fingers…")), &QAction::triggered, this, &FingerMenu::list_all);
  connect(addAction(tr("&New finger…")), &QAction::triggered, this, [this] { make(); });
  connect(addAction(tr("&Close finger")), &QAction::triggered, this,
          [this] { work_.open_finger({}); });
}

std::vector<std::filesystem::path> FingerMenu::offered() const {
  const auto& recent = work_.state().recent_fingers;
  if (!found_) return recent;
  std::vector<std::filesystem::path> offered;
  for (const auto& folder : recent)
    if (std::find(found_->begin(), found_->end(), folder) != found_->end())
      offered.push_back(folder);
  return offered;
}

void FingerMenu::offer(const std::vector<std::filesystem::path>& found) {
  if (found_ == found) return;
  found_ = found;
  fill();
}

void FingerMenu::list_all() {
  auto* dialog = new FingerListDialog(work_.state().recent_fingers, parentWidget());
  connect(dialog, &FingerListDialog::finger_chosen, this,
          [this](const QString& folder) { work_.open_finger(folder.toStdString()); });
  connect(dialog, &FingerListDialog::gage_requested, this,
          [this](const std::vector<std::filesystem::path>& folders) {
            show_dialog(*new GageDialog(folders, parentWidget()));
          });
  show_dialog(*dialog);
}

void FingerMenu::choose() {
  ask_for_folder(parentWidget(), FilesOf::kFingers, tr("Open a finger's folder"),
                 [this](const QString& folder) { work_.open_finger(folder.toStdString()); });
}

void FingerMenu::make(const NewFinger& known) {
  auto* dialog = new NewFingerDialog(parentWidget());
  dialog->set_description(known);
  connect(dialog, &NewFingerDialog::made, this,
          [this](const QString& folder) { work_.open_finger(folder.toStdString()); });
  show_dialog(*dialog);
}

void FingerMenu::export_finger() {
  auto* dialog = new ExportDialog(work_.state().finger, parentWidget());
  show_dialog(*dialog);
}

SourceMenu::SourceMenu(Workspace& work, const CameraFinder& finder, QWidget* window)
    : Translated(window), work_(work), finder_(finder) {
  setToolTipsVisible(true);
  connect(&finder_, &CameraFinder::cameras_changed, this, &SourceMenu::fill);
  connect(&work_, &Workspace::source_changed, this, &SourceMenu::fill);
  say([this] {
    setTitle(tr("&Source"));
    fill();
  });
}

void SourceMenu::fill() {
  clear();
  for (const FoundCamera& camera : finder_.cameras()) {
    const std::string name = camera.identity.stable_name();
    QAction* entry = addAction(tr("Camera %1").arg(QString::fromStdString(camera.identity.name)));
    entry->setToolTip(QString::fromStdString(name));
    entry->setEnabled(!camera.problem);
    connect(entry, &QAction::triggered, this, [this, name] { work_.open_source({name}); });
  }
  if (finder_.cameras().empty()) addAction(tr("No camera is plugged in"))->setEnabled(false);
  addSeparator();
  const auto add = [this](const QString& text, auto slot) {
    connect(addAction(text), &QAction::triggered, this, slot);
  };
  add(tr("&Simulated finger"), &SourceMenu::open_simulated);
  add(tr("&Video file…"), &SourceMenu::choose_video);
  add(tr("Folder of &images…"), &SourceMenu::choose_folder);
  add(tr("Scene &file…"), &SourceMenu::choose_scene);
  add_recent();
  addSeparator();
  add(tr("&Close the source"), [this] { work_.open_source({}); });
}

void SourceMenu::add_recent() {
  const auto& recent = work_.state().recent_sources;
  if (recent.empty()) return;
  QMenu* menu = addMenu(tr("&Recent sources"));
  menu->setToolTipsVisible(true);
  for (const std::filesystem::path& source : recent) {
    const QString path = QString::fromStdString(source.string());
    QAction* entry = menu->addAction(elided_path(path, fontMetrics(), kPathRoom));
    entry->setToolTip(path);
    connect(entry, &QAction::triggered, this, [this, path] { open(path); });
  }
}

void SourceMenu::open_simulated() { open_shipped("scenes/studio_finger.yaml"); }

void SourceMenu::open_simulated_day() { open_shipped("scenes/studio_day.yaml"); }

void SourceMenu::open_shipped(const char* name) {
  const auto scene = find_resource(name);
  if (scene)
    work_.open_source({*scene});
  else
    Q_EMIT failed(scene.error());
}

void SourceMenu::choose_video() {
  ask_for_file(parentWidget(), FilesOf::kRecordings, tr("Open a video"), video_filter(),
               [this](const QString& file) { open(file); });
}

void SourceMenu::choose_folder() {
  ask_for_folder(parentWidget(), FilesOf::kRecordings, tr("Open a folder of images"),
                 [this](const QString& folder) { open(folder); });
}

void SourceMenu::choose_scene() {
  ask_for_file(parentWidget(), FilesOf::kRecordings, tr("Open a scene"),
               tr("Scenes (*.yaml *.yml)"), [this](const QString& file) { open(file); });
}

void SourceMenu::open(const QString& path) { work_.open_source({path.toStdString()}); }

MenuKeys::MenuKeys(QMenuBar& menus, QWidget& window)
    : QObject(&window), menus_(menus), window_(window) {
  qApp->installEventFilter(this);
}

QAction* MenuKeys::menu_of(const QKeyEvent& key) const {
  if (key.modifiers() != Qt::AltModifier) return nullptr;
  for (QAction* menu : menus_.actions())
    if (menu->isEnabled() &&
        QKeySequence::mnemonic(menu->text()) == QKeySequence(Qt::ALT | Qt::Key(key.key())))
      return menu;
  return nullptr;
}

bool MenuKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
  const auto* widget = qobject_cast<const QWidget*>(watched);
  if (widget == nullptr || widget->window() != &window_) return false;
  QAction* menu = menu_of(static_cast<const QKeyEvent&>(*event));
  if (menu == nullptr) return false;
  // An accepted key reaches no shortcut any more.
  event->accept();
  if (event->type() == QEvent::KeyPress) menus_.setActiveAction(menu);
  return true;
}

}  // namespace alltact
