// The Studio's window: combines the pages, the navigation bar, the open finger and source, the
// notification bar, and the menus.
#pragma once

#include "app/studio/desktop_files.h"
#include "app/studio/session.h"
#include "app/studio/workspace.h"
#include "core/open/open_source.h"
#include "widgets/background_work.h"
#include "widgets/controls/devices.h"
#include "widgets/language.h"
#include "widgets/shell/dropped_files.h"
#include "widgets/shell/settings_dialog.h"

#include <QHBoxLayout>
#include <QMainWindow>
#include <QStackedWidget>
#include <QUndoStack>
#include <QVBoxLayout>

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
class HeaderBar;
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
  /// For the tutorial's finger and captured boards, where a person finds them.
  std::filesystem::path work_folder;
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
  /// As those of Workspace.
  void open_finger(const std::filesystem::path& folder) { work_.open_finger(folder); }
  void open_source(const std::vector<std::filesystem::path>& inputs) { work_.open_source(inputs); }
  /// By its name; to the first page where none has it.
  void go_to(const std::string& page);
  /// Goes to the page, and there to the next thing to do.
  void lead_to(const std::string& page);
  /// Ends a recording and the program, without a question.
  void end();

 protected:
  /// The focus of a control that was disabled or hidden goes to what comes next on the page.
  bool focusNextPrevChild(bool next) override;
  void closeEvent(QCloseEvent* event) override;
  /// Files and folders can be dropped anywhere: fingers open, others go to the page or become the
  /// source.
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

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
  /// Header, and below it one line of fixed height for notices, the hint or the guide: what comes
  /// and goes there moves nothing on the page.
  void make_bars(QVBoxLayout& column);
  /// While the guide has the line, notices stand in the header instead of the finger's summary.
  void share_bars();
  /// Only one button leads to what is due: of the page, the guide or the header.
  void show_leads();
  void open_files(const DroppedFiles& dropped);
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
  HeaderBar* header_;
  QHBoxLayout *header_row_, *strip_row_;
  FingerMenu* finger_menu_;
  SourceMenu* source_menu_;
  NavigationBar* navigation_;
  NotificationBar* problems_;
  Tutorial* guide_;
  PageHint* hint_;
  QStackedWidget* stack_;
  bool may_close_ = false;  // while recording
  BackgroundWork dropping_;
};

}  // namespace alltact
