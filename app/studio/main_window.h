// The Studio's window: combines the pages, the navigation bar, the open finger and source, the
// notification bar, and the menus.
#pragma once

#include "app/studio/desktop_files.h"
#include "app/studio/session.h"
#include "app/studio/workspace.h"
#include "core/open/open_source.h"
#include "widgets/controls/devices.h"
#include "widgets/language.h"
#include "widgets/shell/settings_dialog.h"

#include <QMainWindow>
#include <QStackedWidget>
#include <QUndoStack>

namespace alltact {

// Sets the theme and the language of the full program.

class ProgramAppearance {
 public:
  /// Widgets follow by PaletteChange and LanguageChange.
  void apply(const Appearance& appearance);
  [[nodiscard]] const Appearance& appearance() const { return appearance_; }

 private:
  void set_language(const QString& language);

  Appearance appearance_;
  QString language_;  // empty at first: English has plural forms to load, too
  WindowTranslator app_translator_, qt_translator_;
};

class FingerMenu;
class InspectPage;
class LivePage;
class Page;
class PageHint;
class NotificationBar;
class NavigationBar;
class SourceMenu;
class Tutorial;

struct StudioOptions {
  std::filesystem::path finger;               ///< to open at once; empty for none
  std::vector<std::filesystem::path> source;  ///< to open at once; empty for none
  std::filesystem::path session_folder;       ///< where the session is saved
  SourceOpener opener = &alltact::open_source;
  CameraFinder::Lister lister;  ///< empty: the system's cameras
  HidPorts pedal;
  /// Files whose disk takes too long; empty: not monitored.
  std::function<std::vector<std::filesystem::path>()> slow_files;
};

class MainWindow : public Translated<QMainWindow> {
  Q_OBJECT
 public:
  MainWindow(const StudioOptions& options, ProgramAppearance& program_appearance);
  ~MainWindow() override;

  [[nodiscard]] LiveSession& session() { return session_; }
  [[nodiscard]] QUndoStack& undo_stack() { return undo_; }
  [[nodiscard]] Pedal& pedal() { return pedal_; }
  /// Both can be undone. An empty one closes; one that is open already is opened again.
  void open_finger(const std::filesystem::path& folder) { work_.open_finger(folder); }
  void open_source(const std::vector<std::filesystem::path>& inputs) { work_.open_source(inputs); }
  /// By its name; to the first page where none has it.
  void go_to(const std::string& page);
  /// Goes to the page, and there to the next thing to do.
  void lead_to(const std::string& page);
  /// Ends a recording and the program, without a question.
  void end();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void make_pages(const StudioOptions& options);
  void connect_page(Page& page);
  void connect_live();
  void connect_start();
  void connect_pedal();
  void make_menus();
  void make_file_menu();
  void make_view_menu();
  void put_together();
  void show_settings();
  /// The first page needs no hint, since it explains itself.
  void show_hint();
  /// Recording goes on until the user confirms its end.
  void ask_before_closing();
  [[nodiscard]] Page& shown_page() const;
  void keep();
  void restore(const SessionState& state);
  void go_on_with_last();
  void name_last();

  ProgramAppearance& program_appearance_;
  SessionStore session_store_;
  LiveSession session_;
  QUndoStack undo_;
  Workspace work_;
  CameraFinder finder_;
  Pedal pedal_;
  DesktopFiles desktop_files_;
  std::vector<Page*> pages_;  // in the order of the navigation bar
  LivePage* live_;
  InspectPage* inspect_;
  FingerMenu* finger_menu_;
  SourceMenu* source_menu_;
  NavigationBar* navigation_;
  NotificationBar* problems_;
  Tutorial* guide_;
  PageHint* hint_;
  QStackedWidget* stack_;
  bool may_close_ = false;  // while recording
};

}  // namespace alltact
