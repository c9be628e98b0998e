// Step 2, the finger: its geometry, and what untouched pictures of it look like.
#pragma once

#include "core/io/disk_queue.h"
#include "widgets/background_work.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/controls/number_field.h"
#include "widgets/live/live_session.h"
#include "widgets/panels/picture_panel.h"
#include "widgets/shell/new_finger_dialog.h"
#include "widgets/shell/problem_list.h"

#include <QGroupBox>
#include <QPushButton>
#include <QUndoStack>

namespace alltact {

class FingerPage : public StepPage {
  Q_OBJECT
 public:
  FingerPage(LiveSession& session, QUndoStack& undo, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Finger"); }
  [[nodiscard]] StepState state() const override;
  [[nodiscard]] QString missing() const override;
  [[nodiscard]] QVBoxLayout* foot() const override { return foot_; }
  [[nodiscard]] QWidget* main_control() const override { return make_; }
  [[nodiscard]] const QPushButton* to_do() const override;
  void show_status();
  /// Where a new finger's lens is to be read from; may be empty.
  void set_camera_file(const std::filesystem::path& file) { camera_file_ = file; }

 Q_SIGNALS:
  /// A new finger is to be made, beginning with what is known of it.
  void new_finger_wanted(const alltact::NewFinger& known);
  void open_finger_wanted();
  void record_wanted();

 private:
  [[nodiscard]] bool is_own() const;
  /// After a change of a finger that was complete: what is shown stays.
  [[nodiscard]] bool is_read_again() const;
  [[nodiscard]] QWidget* make_side();
  void connect_parts();
  void name_parts();
  void make_finger();
  void take_untouched();
  void show_sizes();
  void change_sizes();
  /// Width and layer, mm.
  using Sizes = std::pair<double, double>;
  void write_sizes(const std::filesystem::path& folder, const Sizes& sizes);

  QVBoxLayout* foot_ = nullptr;
  LiveSession& session_;
  QUndoStack& undo_;
  PicturePanel* live_;
  std::filesystem::path camera_file_;
  ProblemList* problems_;
  QGroupBox *geometry_group_, *reference_group_;
  QLabel *geometry_, *reference_;
  QPushButton *make_, *open_, *record_, *untouched_;
  QLabel *width_label_, *layer_label_;
  NumberField *width_, *layer_;
  QWidget* sizes_;
  QPushButton* change_;
  std::filesystem::path shown_folder_;
  Sizes shown_sizes_;
  bool was_complete_ = false;  // before it was loaded again
  BackgroundWork work_;
  DiskQueue disk_;
};

}  // namespace alltact
