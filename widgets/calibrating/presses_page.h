// Step 3, the presses: taken from the live picture or from files, each with the ball's outline over
// it, to be moved, taken out and put back.
#pragma once

#include "calibration/presses/held_frames.h"
#include "core/live/stationary_contact.h"
#include "widgets/calibrating/press_form.h"
#include "widgets/calibrating/press_model.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/panels/picture_panel.h"
#include "widgets/picture/outline_editor.h"
#include "widgets/shell/problem_list.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QStackedWidget>

namespace alltact {

class PressesPage : public StepPage {
  Q_OBJECT
 public:
  PressesPage(LiveSession& session,
              PressDesk& desk,
              const CalibrationRun& run,
              QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Presses"); }
  [[nodiscard]] StepState state() const override;
  void press_pedal() override;
  [[nodiscard]] QWidget* main_control() const override { return take_; }
  [[nodiscard]] QString missing() const override;
  void show_status();
  /// Shows this press' picture; empty: the live one.
  void show_press(const std::string& name);

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  [[nodiscard]] QWidget* make_list();
  [[nodiscard]] QWidget* make_middle();
  [[nodiscard]] QWidget* make_side();
  void name_parts();
  void take();
  [[nodiscard]] QString why_not_take() const;
  void watch_contact();
  void hold(const FramePtr& frame);
  void forget_held();
  void choose_files();
  void take_out_or_put_back();
  void show_list();
  void show_shown();
  void show_take();
  [[nodiscard]] std::vector<Overlay> overlays_of(const DeskPress& press) const;
  [[nodiscard]] std::optional<ShownBall> ball_of(const DeskPress& press) const;
  [[nodiscard]] QString advice_for(const DeskPress& press) const;

  LiveSession& session_;
  PressDesk& desk_;
  const CalibrationRun& run_;
  PressModel model_;
  StationaryContactDetector still_;
  HeldFrames held_;                 // of the live picture, for as long as it is watched
  FramePtr newest_held_;            // null: none
  std::filesystem::path held_for_;  // the finger's folder
  std::string shown_;               // empty: live
  QString taken_name_;              // of the press taken last; empty: none
  std::size_t taken_of_ = 0;        // frames
  ProblemList* problems_;
  QLabel* count_;
  QListView* list_;
  QPushButton *add_, *out_, *remove_;
  QPushButton *live_button_, *press_button_;
  QStackedWidget* pictures_;
  PicturePanel* live_;
  OutlineEditor* editor_;
  QLabel* place_;
  QGroupBox *take_group_, *press_group_;
  QLabel *radius_label_, *operator_label_;
  QDoubleSpinBox* radius_;
  QLineEdit* operator_;
  PressForm* form_;
  QPushButton *take_, *find_;
  QCheckBox* by_itself_;
  QLabel *take_reason_, *taken_, *press_text_, *legend_;
};

}  // namespace alltact
