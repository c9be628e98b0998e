// The page Record: records a reference video with its coverage, and installs it in the finger.
#pragma once

#include "calibration/reference/motion_coverage.h"
#include "calibration/reference/reference_recording.h"
#include "widgets/background_work.h"
#include "widgets/controls/number_field.h"
#include "widgets/panels/frame_strip.h"
#include "widgets/panels/image_panel.h"
#include "widgets/panels/recording_checks.h"
#include "widgets/shell/page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QUndoStack>

namespace alltact {

class RecordPage : public Page {
  Q_OBJECT
 public:
  /// `undo`: receives every choice of frames.
  RecordPage(LiveSession& session, QUndoStack& undo, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Record"); }
  [[nodiscard]] QString menu_text() const override { return tr("&Record"); }
  /// Starts recording, or stops it.
  void press_pedal() override {
    if (record_->isEnabled()) start_or_stop();
  }
  void add_problems(std::vector<Problem>& problems) override;
  [[nodiscard]] std::string leads_to() const override;

  void set_file(const QString& file) { file_->setText(file); }
  [[nodiscard]] bool is_busy() const;

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  static constexpr double kGigabyte = 1e9;

  [[nodiscard]] QWidget* make_side();
  void connect_parts();
  void make_recording_group(QVBoxLayout& column);
  void make_file_group(QVBoxLayout& column);
  void make_result_group(QVBoxLayout& column);
  void name_parts();
  void set_rest();
  void analyse_frame();
  void start_or_stop();
  void begin_recording();
  void choose_file();
  /// Replaces the name of the file, except one that the user entered.
  void follow_purpose();
  void propose_file();
  [[nodiscard]] bool is_for_measurement() const { return purpose_->currentIndex() == 1; }
  void stop_in_time(const RecordingStatus& recording);
  /// Offers a video for installation: a recording, or a file chosen by the user.
  void offer(const std::filesystem::path& video, std::optional<RestPose> rest_pose);
  void record_again();
  void judge_take();
  [[nodiscard]] ReferenceChoices choices() const;
  [[nodiscard]] std::vector<Overlay> ghost(const LiveView& view) const;
  void measure_space();
  void install();
  void install_now();
  void follow_judge();
  [[nodiscard]] bool is_installing() const;
  [[nodiscard]] const BackgroundWork& installing_work() const;
  /// Of the installation; before it, of the judged recording. nullptr: neither is known.
  [[nodiscard]] const ReferenceReport* shown_report() const;
  void list_rejected();
  /// Uses the frames of the stretch in the next installation, if its box is ticked.
  void choose_stretch(int row);
  void follow_choice();
  void show_status();
  void show_button(const LiveStatus& status);
  void show_progress(const RecordingStatus& recording);
  void show_recorded(const LiveStatus& status);
  void show_offer(const LiveStatus& status);
  void show_rig();
  [[nodiscard]] QString take_words(const RecordingStatus& recording) const;
  /// What is known of the recording so far: the expected error, or what happens to it.
  [[nodiscard]] QString outcome_text() const;
  /// Highlights the button of the next action: recording, then installing.
  void mark_primary();
  void show_installing();
  void show_coverage();
  void show_problem_image();
  void add_recording_problems(const LiveStatus& status, std::vector<Problem>& problems);
  void add_contact_notes(const LiveStatus& status, std::vector<Problem>& problems) const;
  [[nodiscard]] QString record_obstacle(const LiveStatus& status) const;
  [[nodiscard]] QString install_obstacle(const LiveStatus& status) const;

  LiveSession& session_;
  ImagePanel* panel_;
  QGroupBox *coverage_group_, *recording_group_, *result_group_, *file_group_;
  CoverageView* coverage_view_;
  QLabel* missing_;
  QPushButton* rest_;
  QLabel* rest_note_;
  QLabel* file_label_;
  QLineEdit* file_;
  QPushButton *browse_, *record_;
  QComboBox* purpose_;      // a reference, a measurement
  IntegerField* length_s_;  // 0: until it is stopped
  QLabel* sign_;            // red while it records
  QLabel *progress_, *space_;
  QStackedWidget* work_;  // how it bends; after a recording, what to do with it; a measurement
  QLabel* measurement_note_;
  QLabel* summary_;
  QPushButton *install_, *keep_, *again_, *inspect_, *onward_, *video_, *stop_install_;
  QProgressBar* bar_;
  QStackedWidget* step_;  // install, wait for it, go on, nothing
  QLabel *install_reason_, *outcome_;
  FrameChooser* chooser_;
  QListWidget* rejected_;
  QCheckBox* skin_changed_;
  RigCheckBox* rig_box_;

  BendCoverage coverage_;
  std::filesystem::path shown_finger_;
  std::vector<std::filesystem::path> shown_source_;
  bool was_recording_ = false;
  bool is_measurement_ = false;  // the running or last recording
  QString proposed_file_;
  std::uint64_t contact_frames_ = 0;
  std::optional<bool> is_face_pressed_;  // of the newest frame; empty: unknown
  bool is_in_contact_ = false;           // in the last frame, and not during quick bending
  QuickBending bending_;
  int unknown_frames_ = 0;  // consecutive
  RigCheck rig_;
  QElapsedTimer ghost_clock_, since_rig_;
  TakeJudge judge_;
  BackgroundWork install_work_, space_work_;
  bool install_after_judging_ = false;  // the judging run is installed, not repeated
  std::optional<double> free_gb_;
  std::optional<Result<ReferenceReport>> report_;
  std::filesystem::path recorded_, installed_, deferred_;
  std::optional<RestPose> rest_pose_;        // of the recording
  std::weak_ptr<const JudgedTake> listed_;   // the judged recording whose frames are listed
  std::vector<ReferenceStretch> stretches_;  // listed; ticked where retained
  QImage problem_image_;                     // findings of a failed installation, as an image
  QElapsedTimer since_space_;
};

}  // namespace alltact
