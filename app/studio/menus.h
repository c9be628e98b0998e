// A menu whose title and entries follow the language.
#pragma once

#include "app/studio/workspace.h"
#include "core/finger/finger_store.h"
#include "widgets/controls/devices.h"
#include "widgets/live/live_session.h"
#include "widgets/widget_base.h"

#include <QMenu>
#include <QMenuBar>
#include <QObject>
#include <QUndoStack>
#include <utility>

namespace alltact {

class TranslatedMenu : public Translated<QMenu> {
 public:
  using Words = std::function<QString()>;

  explicit TranslatedMenu(QWidget* parent) : Translated(parent) {}

  void set_title(Words title) {
    say([this, title = std::move(title)] { setTitle(title()); });
  }
  /// An entry at the menu's end; `keys` may be empty.
  QAction* add(const QList<QKeySequence>& keys, Words words, const std::function<void()>& act) {
    QAction* entry = addAction(QString());
    entry->setShortcuts(keys);
    connect(entry, &QAction::triggered, this, act);
    say([entry, words = std::move(words)] { entry->setText(words()); });
    return entry;
  }
};

// The menu Edit: undo and redo, each with the name of its step.

/// An accidental shortcut must not end a recording: while one runs, shortcuts do not undo a step
/// that opens another source. The menu entry still does.
class EditMenu : public TranslatedMenu {
  Q_OBJECT
 public:
  EditMenu(QUndoStack& undo, const LiveSession& session, QWidget* parent);

 private:
  void follow();
  [[nodiscard]] bool would_end_recording(const QUndoCommand* step) const;

  QUndoStack& stack_;
  const LiveSession& session_;
  QAction *undo_, *redo_;
};

// The menu of recently opened fingers, and the dialogs that open, make and export one. No dialog
// stops running work.

class FingerMenu : public TranslatedMenu {
  Q_OBJECT
 public:
  /// `window` has the dialogs.
  FingerMenu(Workspace& work, QWidget* window);

  /// The same entries in the menu File, with keys.
  void add_to(TranslatedMenu& file);
  void choose();
  /// Makes a new one, with these known values.
  void make(const NewFinger& known = {});
  /// All fingers of the lab in one list.
  void list_all();
  /// The recent ones that can be opened: only they are offered.
  void offer(const std::vector<std::filesystem::path>& found);

 private:
  void fill();
  void export_finger();

  [[nodiscard]] std::vector<std::filesystem::path> offered() const;

  Workspace& work_;
  QMenu* recent_;
  std::optional<std::vector<std::filesystem::path>> found_;  // nullopt: they are not read yet
};

// The menu of cameras and other sources of frames, and its dialogs. No dialog stops running work.

class SourceMenu : public Translated<QMenu> {
  Q_OBJECT
 public:
  /// `window` has the dialogs.
  SourceMenu(Workspace& work, const CameraFinder& finder, QWidget* window);

  void open_simulated();
  /// A full day: the finger is bent to be recorded, then pressed and held still.
  void open_simulated_day();
  void choose_video();
  void choose_folder();

 Q_SIGNALS:
  /// Nothing was opened.
  void failed(const alltact::Error& why);

 private:
  void fill();
  void choose_scene();
  void open_shipped(const char* name);
  void open(const QString& path);
  void add_recent();

  Workspace& work_;
  const CameraFinder& finder_;
};

// Alt and a menu's letter opens that menu everywhere. A page may have a button or a label with the
// same letter, in any language; Qt would then only move the focus from one to the other.

class MenuKeys : public QObject {
  Q_OBJECT
 public:
  /// Listens to `window`, which has the menus.
  MenuKeys(QMenuBar& menus, QWidget& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] QAction* menu_of(const QKeyEvent& key) const;

  QMenuBar& menus_;
  QWidget& window_;
};

}  // namespace alltact
