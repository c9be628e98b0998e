// The page Inspect: a recording or the live finger in 3D, measured, compared, saved.
#pragma once

#include "widgets/background_work.h"
#include "widgets/inspect/finger_pair.h"
#include "widgets/inspect/inspect_pane.h"
#include "widgets/inspect/inspect_side.h"
#include "widgets/inspect/inspection.h"
#include "widgets/inspect/save_inspected.h"
#include "widgets/inspect/time_line.h"
#include "widgets/live/live_session.h"
#include "widgets/panels/force_box.h"
#include "widgets/shell/page.h"
#include "widgets/undo_step.h"

#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QUndoStack>
#include <filesystem>
#include <map>

namespace alltact {

class InspectPage : public Page {
  Q_OBJECT
 public:
  /// `undo`: receives every change.
  InspectPage(LiveSession& session, QUndoStack& undo, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Inspect"); }
  [[nodiscard]] QString menu_text() const override { return tr("&Inspect"); }

  void add_problems(std::vector<Problem>& problems) override;
  [[nodiscard]] bool take_files(const DroppedFiles& dropped) override;
  void reload() override { inspection_.measure_again(); }

  /// A video or a folder of images. Opens it again if it is open already.
  void open(const std::filesystem::path& recording);
  /// Saves the view in the format of the file's ending (see kSaveFormats) and reports the result
  /// below the face. A film of the live finger continues until stop_saving().
  void save(const std::filesystem::path& file);
  /// Second finger of the open recording; none: closes it.
  void open_second(const std::optional<SecondFinger>& second);
  /// Restores the view of an earlier session, from this frame on.
  void restore(const InspectOptions& options, std::size_t frame);
  /// State reported by changed(), which is not emitted for each frame during playback.
  [[nodiscard]] const InspectOptions& options() const { return options_; }
  /// Frame of the open recording.
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
  [[nodiscard]] SidePanel make_side();
  void connect_parts();
  void connect_panes();
  void connect_pair();
  void follow_contact();
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
  void store_look(const InspectPane& pane, bool is_drag);
  void show_recording();
  void choose_recording();
  void choose_second();
  void choose_pose(bool is_second);
  void inspect_all();
  void inspect_folder(const std::filesystem::path& folder);
  void choose_file(const QString& ending);
  void go_live();
  void follow_live();
  void follow_finger();
  void show_frame();
  void show_panes();
  void show_second();
  void show_state();
  void add_pair_problems(std::vector<Problem>& problems);
  void add_other_finger(std::vector<Problem>& problems);
  [[nodiscard]] bool is_joint_view() const;
  [[nodiscard]] QString summary_text() const;
  [[nodiscard]] QString title_of(bool is_second) const;
  [[nodiscard]] BackgroundWork::Work saving_work(const std::filesystem::path& file);
  [[nodiscard]] BackgroundWork::Work image_work(const std::filesystem::path& file);
  [[nodiscard]] BackgroundWork::Work film_work(const std::filesystem::path& file);
  [[nodiscard]] Status save_section(const std::filesystem::path& file);
  [[nodiscard]] FilmView film_view() const;
  [[nodiscard]] FramePair film_moment() const;
  [[nodiscard]] CanSave can_save() const;
  [[nodiscard]] QString empty_reason() const;
  [[nodiscard]] QString shown_text() const;
  void show_saving();
  void end_saving(const Status& status, const std::vector<std::filesystem::path>& files);

  LiveSession& session_;
  QUndoStack& undo_;
  Inspection inspection_;
  FingerPair pair_;
  BackgroundWork saving_;
  InspectOptions options_;
  std::map<std::filesystem::path, std::size_t>
      last_frame_;  // the last frame shown of each recording
  QElapsedTimer since_turn_;
  int turns_ = 0;  // count of turns that are undo steps of their own
  QPushButton *live_, *recordings_, *video_, *folder_;
  SaveBar* save_bar_;
  QLabel *shown_, *summary_, *saved_, *probe_;
  std::optional<QPointF> pointed_at_;     // pixel under the pointer
  std::filesystem::path points_finger_;   // folder of the finger that A and B lie on
  std::filesystem::path opened_with_;     // folder of the finger when the recording was opened
  std::shared_ptr<FilmQueue> live_film_;  // while the live finger is filmed
  QTimer summaries_timer_;                // one update for the summaries of many frames
  InspectPane *first_, *second_;
  TimeLine* time_line_;
  InspectSide* side_;
  PairBox* pair_box_;
  // Contacts of the recording, as long as its frames are shown in sequence.
  TouchHistory played_;
  std::shared_ptr<const InspectedFrame> last_played_;
  ContactBox* contact_;
  ForceBox* force_;
};

}  // namespace alltact
