// Step 3, the presses: taken from the live stream under guidance, or added from files. Each is
// shown with the ball's outline, which can be moved, and can be left out.
#pragma once

#include "calibration/finger/calibrate_presses.h"
#include "calibration/presses/guided_presses.h"
#include "widgets/calibrating/press_collection.h"
#include "widgets/calibrating/press_guide.h"
#include "widgets/calibrating/press_list.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/controls/number_field.h"
#include "widgets/image/overlays.h"
#include "widgets/panels/image_panel.h"
#include "widgets/plots/calibration_plots.h"
#include "widgets/widget_base.h"

#include <QAction>
#include <QCheckBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>
#include <QWidget>
#include <optional>

namespace alltact {

// Form for the notes of one press: ball, punch or another body, and measured depth.

class PressForm : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit PressForm(PressCollection& collection, QWidget* parent = nullptr);
  /// Shows the notes of this press; call it again when they change.
  void show_press(const std::string& name);

 private:
  void name_parts();
  void choose_mesh();

  PressCollection& collection_;
  std::string shown_;
  QLabel *radius_label_, *depth_label_, *depth_sd_label_, *step_label_, *body_label_;
  NumberField *radius_, *depth_, *depth_sd_, *step_;
  QPushButton* body_;  ///< its menu chooses a mesh, or a ball again
  QAction *choose_mesh_, *no_mesh_;
};

// What the ball's position means for one press: the error of the mapping under it, as an image
// overlay and as points around the curve. Updated while an outline is dragged.

/// Mapping minus ball over the contact as colours: red where the mapping is too deep.
[[nodiscard]] std::vector<Overlay> residual_overlays(const PressFit& fit);

class PressFitPane : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit PressFitPane(QWidget* parent = nullptr);

  /// fit: at the current ball position; before: at the calibrated position, if the ball was moved
  /// by hand. Null fit: the pane is hidden. `forecast`: expected accuracy with all presses.
  void show_fit(const PressFit* fit, const PressFit* before, const Calibration* calibration,
                const QString& forecast);

  /// Text of the plot, for the layout next to the image; shown and hidden with the pane.
  [[nodiscard]] QLabel* words() const { return words_; }

  [[nodiscard]] QSize sizeHint() const override { return {640, 190}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 150}; }

 private:
  MappingPlot* plot_;
  ReservedText* words_;
};

class PressesPage : public StepPage {
  Q_OBJECT
 public:
  /// Whether a new finger's presses are taken as soon as they are held still; without it they are.
  static constexpr QLatin1String kAutomaticKey{"presses/automatic"};

  PressesPage(LiveSession& session, PressCollection& collection, const CalibrationRun& run,
              PressForecast& forecast, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Presses"); }
  [[nodiscard]] StepState state() const override;
  void press_pedal() override;
  [[nodiscard]] QVBoxLayout* foot() const override { return foot_; }
  [[nodiscard]] QWidget* main_control() const override { return take_; }
  [[nodiscard]] const QPushButton* action_button() const override;
  [[nodiscard]] QString missing() const override;
  [[nodiscard]] bool take_files(const DroppedFiles& dropped) override;
  void show_status();
  /// Shows this press' image; empty: the live image.
  void show_press(const std::string& name);

 protected:
  void hideEvent(QHideEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void make_list(QVBoxLayout& column);
  [[nodiscard]] QWidget* make_views();
  [[nodiscard]] QWidget* make_side();
  void make_taking(QVBoxLayout& column);
  [[nodiscard]] QWidget* make_press();
  void connect_parts();
  void name_parts();
  void take();
  [[nodiscard]] QString take_obstacle() const;
  void watch_contact();
  void begin_first_series();
  void begin_series();
  [[nodiscard]] bool has_radius() const;
  void take_automatically();
  [[nodiscard]] QString auto_take_obstacle() const;
  void show_guide();
  void add_taken(const PressTaker::Taken& taken);
  /// When a source has ended, its last frame counts as held still.
  void follow_source();
  [[nodiscard]] double held_part() const;
  void choose_files();
  void add_files(const std::vector<std::filesystem::path>& files);
  void make_list_actions();
  /// Names of the presses that are selected in the list.
  [[nodiscard]] std::vector<std::string> selected() const;
  void show_problems();
  void show_list();
  void show_shown();
  void show_press_image(const CollectedPress& press);
  void show_fit(const CollectedPress& press);
  void show_position();
  void show_forecast();
  void show_take();
  [[nodiscard]] QString taken_words() const;
  [[nodiscard]] static QString taken_words(const QString& name, int frames);
  [[nodiscard]] static QString no_press_text();
  [[nodiscard]] std::vector<Overlay> overlays_of(const CollectedPress& press) const;
  [[nodiscard]] std::optional<ShownBall> ball_of(const CollectedPress& press) const;
  [[nodiscard]] std::optional<PressFit> fit_at(const CollectedPress& press,
                                               const Eigen::Vector3d& centre_mm) const;
  /// Ball position in the calibration or forecast compared with.
  [[nodiscard]] std::optional<Eigen::Vector3d> solved_ball(const CollectedPress& press) const;
  [[nodiscard]] QString advice_for(const CollectedPress& press) const;

  QVBoxLayout* foot_ = nullptr;
  LiveSession& session_;
  PressCollection& collection_;
  const CalibrationRun& run_;
  PressForecast& forecast_;
  PressModel model_;
  StationaryContactDetector still_;
  int series_left_ = 0;               // presses that are still taken automatically
  bool is_series_over_ = false;       // since the last one was taken
  bool awaits_first_series_ = false;  // of a finger whose presses are being read
  PressTaker taker_;  // takes presses from the live stream while this page is visible
  std::filesystem::path taker_folder_;  // the finger's folder
  PressGuidance guided_;
  std::string shown_;               // name of the press; empty: the live image
  std::string taken_name_;          // name of the latest press; empty: none
  std::size_t taken_frames_ = 0;    // frames averaged into it
  std::optional<Problem> refused_;  // why images could not be added
  std::optional<PressFit> fit_;     // of the press that is shown
  ReservedText *count_, *forecast_words_;
  PressListView* list_;
  QAction *list_leave_out_, *list_remove_;  // of its selected presses: context menu and keys
  QPushButton *add_, *leave_out_, *remove_;
  QPushButton *live_button_, *press_button_;
  QCheckBox* residual_;
  QStackedWidget* views_;
  ImagePanel* live_;
  OutlineEditor* editor_;
  PressFitPane* fit_pane_;
  QLabel* position_;
  QGroupBox *take_group_, *press_group_;
  QLabel *radius_label_, *operator_label_;
  NumberField* radius_;
  QLineEdit* operator_;
  PressForm* form_;
  QToolButton* more_;
  QPushButton *take_, *find_;
  QCheckBox* automatic_;
  ReservedText *guide_, *take_state_, *press_text_;
  QLabel* legend_;
};

}  // namespace alltact
