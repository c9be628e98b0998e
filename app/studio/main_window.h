// The Studio's window: places in the rail, finger and source always in view, problems in words.
#pragma once

#include "app/studio/dresser.h"
#include "app/studio/session_keeper.h"
#include "core/sources/open/open_source.h"
#include "widgets/live/camera_finder.h"
#include "widgets/live/pedal.h"
#include "widgets/places/calibrate_place.h"
#include "widgets/places/inspect_place.h"
#include "widgets/places/live_place.h"
#include "widgets/places/record_place.h"
#include "widgets/shell/problem_list.h"
#include "widgets/shell/start_panel.h"

#include <QButtonGroup>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QStackedWidget>
#include <QToolButton>
#include <QUndoStack>

namespace alltact {

struct StudioOptions {
  std::filesystem::path finger;               ///< to open at once; empty for none
  std::vector<std::filesystem::path> source;  ///< to open at once; empty for none
  std::filesystem::path session_folder;       ///< where the session is kept
  SourceOpener opener = &alltact::open_source;
  CameraFinder::Lister lister;  ///< empty: the system's cameras
  PedalPorts pedal;
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
  void open_finger(const std::filesystem::path& folder);
  void open_source(const std::vector<std::filesystem::path>& inputs);
  void go_to(const std::string& place);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Words {
    QAction* action;
    std::function<QString()> text;
  };
  QAction* add(QMenu& menu, std::function<QString()> text, const QKeySequence& key = {});
  void make_menus();
  void make_source_entries(QMenu& menu);
  void make_undo_entries();
  void make_view_menu();
  void make_help_menu();
  [[nodiscard]] QWidget* make_rail();
  void connect_calibrating();
  void connect_pedal();
  [[nodiscard]] QWidget* make_header();
  void make_status_line();
  void name_parts();
  void set_icons();

  void show_undo();
  void fill_source_menu();
  void fill_recent_menu();
  void choose_finger();
  void new_finger(const NewFinger& known = {});
  void export_open_finger();
  void choose_video();
  void choose_folder();
  void choose_scene();
  void open_simulated();
  void go_on_with_last();
  void show_settings();
  void show_help();
  void show_about();

  void follow();
  void show_header(const LiveStatus& status);
  void show_line(const LiveStatus& status);
  [[nodiscard]] std::vector<Problem> problems_of(const LiveStatus& status);
  void add_source_problems(const LiveStatus& status, std::vector<Problem>& problems) const;
  void add_finger_problems(const LiveStatus& status, std::vector<Problem>& problems) const;
  void keep();
  void restore(const SessionState& state);
  void name_last();
  void set_finger(const std::filesystem::path& folder);
  void set_source(const std::vector<std::filesystem::path>& inputs);
  [[nodiscard]] bool would_end_recording(const QUndoCommand* step) const;
  [[nodiscard]] QString source_name() const;

  Dresser& dresser_;
  SessionKeeper keeper_;
  SessionState state_;
  bool is_crash_told_ = false;
  LiveSession session_;
  CameraFinder finder_;
  Pedal pedal_;
  QUndoStack undo_;
  std::vector<Words> words_;
  QMenu *file_menu_, *source_menu_, *recent_menu_, *edit_menu_, *view_menu_, *help_menu_;
  QAction *undo_action_, *redo_action_, *export_action_;
  QButtonGroup* rail_;
  QToolButton *live_button_, *calibrate_button_, *record_button_, *inspect_button_, *finger_button_,
      *source_button_;
  QLabel *finger_label_, *source_label_;
  ProblemList* problems_;
  QStackedWidget* places_;
  QStackedWidget* live_or_start_;
  StartPanel* start_;
  LivePlace* live_;
  CalibratePlace* calibrate_;
  RecordPlace* record_;
  InspectPlace* inspect_;
  QLabel *delivered_, *lost_, *age_, *time_;
};

}  // namespace alltact
