// Step 2, the finger: its geometry, and what untouched pictures of it look like.
#pragma once

#include "widgets/background_work.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/live/live_session.h"
#include "widgets/shell/new_finger_dialog.h"
#include "widgets/shell/problem_list.h"

#include <QGroupBox>
#include <QPushButton>

namespace alltact {

class FingerPage : public StepPage {
  Q_OBJECT
 public:
  explicit FingerPage(LiveSession& session, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Finger"); }
  [[nodiscard]] StepState state() const override;
  [[nodiscard]] QString missing() const override;
  [[nodiscard]] QWidget* main_control() const override { return make_; }
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
  void make_finger();
  void take_untouched();

  LiveSession& session_;
  std::filesystem::path camera_file_;
  ProblemList* problems_;
  QGroupBox *geometry_group_, *reference_group_;
  QLabel *geometry_, *reference_;
  QPushButton *make_, *open_, *record_, *untouched_;
  bool was_complete_ = false;  // before it was loaded again
  BackgroundWork work_;
};

}  // namespace alltact
