// Step 3, the presses: taken from the live picture, which shows where to press next, or from files;
// each with the ball's outline over it, to be moved, taken out and put back.
#pragma once

#include "calibration/presses/press_taker.h"
#include "widgets/calibrating/press_fit_pane.h"
#include "widgets/calibrating/press_form.h"
#include "widgets/calibrating/press_guide.h"
#include "widgets/calibrating/press_list_view.h"
#include "widgets/calibrating/press_model.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/controls/number_field.h"
#include "widgets/panels/picture_panel.h"
#include "widgets/shell/problem_list.h"

#include <QCheckBox>
#include <QGroupBox>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>

namespace alltact {

class PressesPage : public StepPage {
  Q_OBJECT
 public:
  PressesPage(LiveSession& session,
              PressDesk& desk,
              const CalibrationRun& run,
              PressForecast& forecast,
              QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Presses"); }
  [[nodiscard]] StepState state() const override;
  void press_pedal() override;
  [[nodiscard]] QVBoxLayout* foot() const override { return foot_; }
  [[nodiscard]] QWidget* main_control() const override { return take_; }
  [[nodiscard]] QString missing() const override;
  void show_status();
  /// Shows this press' picture; empty: the live one.
  void show_press(const std::string& name);

 protected:
  void hideEvent(QHideEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void make_list(QVBoxLayout& column);
  [[nodiscard]] QWidget* make_pictures();
  [[nodiscard]] QWidget* make_side();
  void make_taking(QVBoxLayout& column);
  void make_press(QVBoxLayout& column);
  void connect_parts();
  void name_parts();
  void take();
  [[nodiscard]] QString why_not_take() const;
  void watch_contact();
  [[nodiscard]] QString why_not_by_itself() const;
  void show_guide();
  void keep_taken(const PressTaker::Taken& taken);
  /// Of a source that has ended the last frame stands still.
  void follow_source();
  [[nodiscard]] double held_part() const;
  void choose_files();
  void show_problems();
  void show_list();
  void show_shown();
  void show_picture(const DeskPress& press);
  void show_fit(const DeskPress& press);
  void show_place();
  void show_forecast();
  void show_take();
  void show_taken();
  [[nodiscard]] std::vector<Overlay> overlays_of(const DeskPress& press) const;
  [[nodiscard]] std::optional<ShownBall> ball_of(const DeskPress& press) const;
  [[nodiscard]] std::optional<PressFit> fit_at(const DeskPress& press,
                                               const Eigen::Vector3d& centre_mm) const;
  /// Where the calibration to compare with puts its ball.
  [[nodiscard]] std::optional<Eigen::Vector3d> solved_ball(const DeskPress& press) const;
  [[nodiscard]] QString advice_for(const DeskPress& press) const;

  QVBoxLayout* foot_ = nullptr;
  LiveSession& session_;
  PressDesk& desk_;
  const CalibrationRun& run_;
  PressForecast& forecast_;
  PressModel model_;
  StationaryContactDetector still_;
  PressTaker taker_;                // of the live picture, for as long as it is watched
  std::filesystem::path held_for_;  // the finger's folder
  GuidedFrame guided_;
  std::string shown_;               // empty: live
  std::string taken_name_;          // of the press taken last; empty: none
  std::size_t taken_of_ = 0;        // frames
  std::optional<Problem> refused_;  // why pictures could not be added
  std::optional<PressFit> fit_;     // of the press that is shown
  ProblemList* problems_;
  QLabel *count_, *forecast_words_;
  PressListView* list_;
  QPushButton *add_, *out_, *remove_;
  QPushButton *live_button_, *press_button_;
  QCheckBox* residual_;
  QStackedWidget* pictures_;
  PicturePanel* live_;
  OutlineEditor* editor_;
  PressFitPane* fit_pane_;
  QLabel* place_;
  QGroupBox *take_group_, *press_group_;
  QLabel *radius_label_, *operator_label_;
  NumberField* radius_;
  QLineEdit* operator_;
  PressForm* form_;
  QToolButton* more_;
  QPushButton *take_, *find_;
  QCheckBox* by_itself_;
  QLabel *take_reason_, *guide_, *why_waiting_, *taken_, *press_text_, *legend_;
};

}  // namespace alltact
