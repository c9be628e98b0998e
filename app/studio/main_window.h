// The Studio's window: puts together the places, the rail that leads to them, the finger and the
// source that are worked on, what is wrong with them, and the menus.
#pragma once

#include "app/studio/dresser.h"
#include "app/studio/session_keeper.h"
#include "app/studio/workspace.h"
#include "core/sources/open/open_source.h"
#include "widgets/live/camera_finder.h"
#include "widgets/live/pedal.h"

#include <QMainWindow>
#include <QStackedWidget>
#include <QUndoStack>

namespace alltact {

class FingerMenu;
class InspectPlace;
class LivePlace;
class Place;
class PlaceHint;
class ProblemBar;
class Rail;
class SourceMenu;
class TryGuide;

struct StudioOptions {
  std::filesystem::path finger;               ///< to open at once; empty for none
  std::vector<std::filesystem::path> source;  ///< to open at once; empty for none
  std::filesystem::path session_folder;       ///< where the session is kept
  SourceOpener opener = &alltact::open_source;
  CameraFinder::Lister lister;  ///< empty: the system's cameras
  HidPorts pedal;
  /// Files that are waited for too long; empty: nobody watches.
  std::function<std::vector<std::filesystem::path>()> slow_files;
};

class MainWindow : public Translated<QMainWindow> {
  Q_OBJECT
 public:
  MainWindow(const StudioOptions& options, Dresser& dresser);
  ~MainWindow() override;

  [[nodiscard]] LiveSession& session() { return session_; }
  [[nodiscard]] QUndoStack& undo_stack() { return undo_; }
  [[nodiscard]] Pedal& pedal() { return pedal_; }
  /// Both can be undone. An empty one closes; what is open already is opened afresh.
  void open_finger(const std::filesystem::path& folder) { work_.open_finger(folder); }
  void open_source(const std::vector<std::filesystem::path>& inputs) { work_.open_source(inputs); }
  /// By its name; to the first place where none has it.
  void go_to(const std::string& place);
  /// Goes there, to what is to be done next.
  void lead_to(const std::string& place);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void make_places(const StudioOptions& options);
  void connect_place(Place& place);
  void connect_live();
  void connect_start();
  void connect_pedal();
  void make_menus();
  void make_file_menu();
  void make_view_menu();
  void put_together();
  void show_settings();
  /// The first page says itself what it is for.
  void show_hint();
  /// Recording goes on until somebody has said that it may end.
  void ask_before_closing();
  [[nodiscard]] Place& shown_place() const;
  void keep();
  void restore(const SessionState& state);
  void go_on_with_last();
  void name_last();

  Dresser& dresser_;
  SessionKeeper keeper_;
  LiveSession session_;
  QUndoStack undo_;
  Workspace work_;
  CameraFinder finder_;
  Pedal pedal_;
  std::vector<Place*> places_;  // in the order of the rail
  LivePlace* live_;
  InspectPlace* inspect_;
  FingerMenu* finger_menu_;
  SourceMenu* source_menu_;
  Rail* rail_;
  ProblemBar* problems_;
  TryGuide* guide_;
  PlaceHint* hint_;
  QStackedWidget* stack_;
  bool may_close_ = false;  // while recording
};

}  // namespace alltact
