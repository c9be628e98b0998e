// The place Inspect: a recording or the live finger in 3D, measured, compared, saved.
#pragma once

#include "widgets/background_work.h"
#include "widgets/inspect/inspect_pane.h"
#include "widgets/inspect/inspect_side.h"
#include "widgets/inspect/inspection.h"
#include "widgets/inspect/save_bar.h"
#include "widgets/inspect/time_line.h"
#include "widgets/live/live_session.h"
#include "widgets/shell/problem_list.h"
#include "widgets/translated.h"

#include <QLabel>
#include <QPushButton>
#include <QUndoStack>
#include <filesystem>

namespace alltact {

class InspectPlace : public Translated<QWidget> {
  Q_OBJECT
 public:
  /// Changes go through `undo`.
  InspectPlace(LiveSession& session, QUndoStack& undo, QWidget* parent = nullptr);

  /// A video or a folder of pictures.
  void open(const std::filesystem::path& recording);
  /// What is shown, by the file's ending (see kSavedAs); told below the face when it is done.
  void save(const std::filesystem::path& file);
  [[nodiscard]] const InspectOptions& options() const { return options_; }
  [[nodiscard]] const Inspection& inspection() const { return inspection_; }
  [[nodiscard]] bool is_saving() const { return saving_.is_running(); }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  [[nodiscard]] QWidget* make_header();
  [[nodiscard]] QWidget* make_side();
  void connect_parts();
  void name_parts();
  void change_options(const InspectOptions& options, const QString& what, int merge_id);
  void set_options(const InspectOptions& options);
  void set_point(QPointF pixel, bool is_second);
  void choose_video();
  void choose_folder();
  void choose_file(const QString& ending);
  void go_live();
  void follow_live();
  void follow_finger();
  void show_frame();
  void show_state();
  [[nodiscard]] QString why_nothing() const;
  [[nodiscard]] QString what_is_shown() const;
  void show_saving();
  void end_saving(const Status& status, const std::filesystem::path& file);

  LiveSession& session_;
  QUndoStack& undo_;
  Inspection inspection_;
  BackgroundWork saving_;
  InspectOptions options_;
  std::filesystem::path recording_;  // empty: the live finger
  ProblemList* problems_;
  QPushButton *live_, *video_, *folder_;
  SaveBar* save_bar_;
  QLabel *shown_, *summary_, *saved_;
  InspectPane *first_, *second_;
  TimeLine* time_line_;
  InspectSide* side_;
};

}  // namespace alltact
