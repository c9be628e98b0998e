// The place Inspect: a recording or the live finger in 3D, measured, compared, saved.
#pragma once

#include "widgets/background_work.h"
#include "widgets/inspect/finger_pair.h"
#include "widgets/inspect/inspect_pane.h"
#include "widgets/inspect/inspect_side.h"
#include "widgets/inspect/inspection.h"
#include "widgets/inspect/pair_box.h"
#include "widgets/inspect/save_bar.h"
#include "widgets/inspect/save_inspected.h"
#include "widgets/inspect/time_line.h"
#include "widgets/live/live_session.h"
#include "widgets/panels/force_box.h"
#include "widgets/places/place.h"
#include "widgets/undo_step.h"

#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QUndoStack>
#include <filesystem>
#include <map>

namespace alltact {

class InspectPlace : public Place {
  Q_OBJECT
 public:
  /// Changes go through `undo`.
  InspectPlace(LiveSession& session, QUndoStack& undo, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Inspect"); }
  [[nodiscard]] QString menu_text() const override { return tr("&Inspect"); }

  void reload() override { inspection_.measure_again(); }

  /// A video or a folder of pictures. What is open already is opened afresh.
  void open(const std::filesystem::path& recording);
  /// What is shown, by the file's ending (see kSavedAs); told below the face when it is done. A
  /// film of the live finger goes on until stop_saving().
  void save(const std::filesystem::path& file);
  /// Beside the recording that is shown; none: no second finger.
  void open_second(const std::optional<SecondFinger>& second);
  /// What was shown in another session, from this frame on.
  void restore(const InspectOptions& options, std::size_t frame);
  /// What changed() tells of, though not of every frame while it plays.
  [[nodiscard]] const InspectOptions& options() const { return options_; }
  /// Of the recording that is shown.
  [[nodiscard]] std::size_t frame_number() const;
  [[nodiscard]] const FingerPair& pair() const { return pair_; }
  [[nodiscard]] const Inspection& inspection() const { return inspection_; }
  [[nodiscard]] bool is_saving() const { return saving_.is_running(); }
  void stop_saving() { saving_.stop(); }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  [[nodiscard]] QWidget* make_header();
  [[nodiscard]] QWidget* make_side();
  void connect_parts();
  void connect_panes();
  void connect_pair();
  void make_touch(QVBoxLayout& column);
  void follow_touch();
  [[nodiscard]] const TouchHistory& touch_history() const;
  [[nodiscard]] ShownForce shown_force() const;
  [[nodiscard]] static QString text_of(const std::filesystem::path& path) {
    return QString::fromStdString(path.string());
  }
  void name_parts();
  void change_options(const InspectOptions& options, const StepWords& what, int merge_id);
  void set_options(const InspectOptions& options);
  void set_point(QPointF pixel, bool is_second);
  void drop_points();
  void show_probe();
  void keep_look(const InspectPane& pane, bool is_drag);
  void show_recording();
  void choose_second();
  void choose_place(bool is_second);
  void choose_video();
  void choose_folder();
  void choose_file(const QString& ending);
  void go_live();
  void follow_live();
  void follow_finger();
  void show_frame();
  void show_panes();
  void show_second();
  void show_state();
  void add_pair_problems(std::vector<Problem>& problems);
  [[nodiscard]] bool is_one_picture() const;
  [[nodiscard]] QString summary_text() const;
  [[nodiscard]] QString title_of(bool is_second) const;
  [[nodiscard]] BackgroundWork::Work saving_work(const std::filesystem::path& file);
  [[nodiscard]] BackgroundWork::Work picture_work(const std::filesystem::path& file);
  [[nodiscard]] BackgroundWork::Work film_work(const std::filesystem::path& file);
  [[nodiscard]] Status save_section(const std::filesystem::path& file);
  [[nodiscard]] FilmView film_view() const;
  [[nodiscard]] FilmMoment film_moment() const;
  [[nodiscard]] CanSave can_save() const;
  void show_summaries();
  [[nodiscard]] QString why_nothing() const;
  [[nodiscard]] QString what_is_shown() const;
  void show_saving();
  void end_saving(const Status& status, const std::vector<std::filesystem::path>& files);

  LiveSession& session_;
  QUndoStack& undo_;
  Inspection inspection_;
  FingerPair pair_;
  BackgroundWork saving_;
  InspectOptions options_;
  std::map<std::filesystem::path, std::size_t> left_at_;  // the frame of each recording
  QElapsedTimer since_turn_;
  int turns_ = 0;  // that are steps of their own
  ProblemList* problems_;
  QPushButton *live_, *video_, *folder_;
  SaveBar* save_bar_;
  QLabel *shown_, *summary_, *saved_, *probe_;
  std::optional<QPointF> pointed_at_;     // pixel under the pointer
  std::filesystem::path points_of_;       // the finger that A and B lie on
  std::shared_ptr<FilmQueue> live_film_;  // while the live finger is filmed
  QTimer summaries_timer_;                // puts news of many frames together
  InspectPane *first_, *second_;
  TimeLine* time_line_;
  InspectSide* side_;
  PairBox* pair_box_;
  // Of the recording, as long as its frames were shown one after the other.
  TouchHistory played_;
  std::shared_ptr<const InspectedFrame> played_to_;
  QGroupBox* contact_group_;
  QLabel* contact_;
  ForceBox* force_;
};

}  // namespace alltact
