// Step 1, the lens: camera intrinsics from a file, or calibrated with images of a board.
#pragma once

#include "calibration/lens/board_views.h"
#include "calibration/lens/calibrate_lens.h"
#include "core/base/slow_disk.h"
#include "core/camera/camera.h"
#include "widgets/background_work.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/controls/number_field.h"
#include "widgets/live/live_session.h"
#include "widgets/panels/image_panel.h"
#include "widgets/widget_base.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

namespace alltact {

// Form for the calibration board, and for a window between lens and finger that the board was not
// seen through.

class LensForm : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit LensForm(QWidget* parent = nullptr);
  [[nodiscard]] Board board() const;
  [[nodiscard]] LensSettings settings() const;
  /// nullopt: no window.
  [[nodiscard]] std::optional<FlatPort> port() const;
  /// Why a visible number is refused; empty: none is. board(), settings() and port() then hold the
  /// last valid numbers.
  [[nodiscard]] QString refusal() const;

 Q_SIGNALS:
  /// The board was changed.
  void board_changed();

 private:
  void name_parts();
  void show_port();
  void show_tag_gap();

  QFormLayout* form_;
  QComboBox *pattern_, *model_;
  IntegerField *columns_, *rows_;
  NumberField *square_, *tag_gap_, *distance_, *gap_, *plate_, *plate_index_, *medium_index_;
  QCheckBox* has_port_;
  QLabel *pattern_label_, *size_label_, *square_label_, *tag_gap_label_, *by_label_, *model_label_,
      *distance_label_;
  QLabel *gap_label_, *plate_label_, *plate_index_label_, *medium_index_label_;
};

class LensPage : public StepPage {
  Q_OBJECT
 public:
  /// work_folder: for unnamed camera files and for captured board images.
  LensPage(LiveSession& session, std::filesystem::path work_folder, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Lens"); }
  [[nodiscard]] StepState state() const override;
  [[nodiscard]] QString missing() const override;
  [[nodiscard]] bool take_files(const DroppedFiles& dropped) override;
  void press_pedal() override;
  [[nodiscard]] QVBoxLayout* foot() const override { return foot_; }
  [[nodiscard]] QWidget* main_control() const override;
  /// A usable camera file; empty where a finger is open, or none was chosen yet.
  [[nodiscard]] const std::filesystem::path& camera_file() const { return camera_file_; }
  void show_status();

 private:
  [[nodiscard]] QWidget* make_side();
  void connect_parts();
  void name_parts();
  void take_file(const std::filesystem::path& file);
  void use_simulated();
  void measure();
  void show_progress();
  void show_summary(bool has_folder);
  void show_views(const std::vector<LensViewReport>& views);

  // Boards in the live image
  [[nodiscard]] bool has_folder() const;
  [[nodiscard]] bool can_take() const;
  void analyse_frame();
  void take_detection(const std::shared_ptr<BoardCollector>& by, const BoardAnalysis& detection);
  void request_board();
  void add_board(const BoardAnalysis& detection);
  void remove_pending_view();
  void begin_boards();
  void fit_boards();
  void show_boards();
  [[nodiscard]] QString board_words() const;
  [[nodiscard]] std::vector<Overlay> overlays(const LiveView& view) const;

  QVBoxLayout* foot_ = nullptr;
  LiveSession& session_;
  std::filesystem::path work_folder_;
  ImagePanel* live_;
  QLabel* summary_;
  QGroupBox *file_group_, *board_group_, *live_group_;
  QLineEdit *file_, *images_;
  QPushButton *choose_file_, *choose_images_, *simulated_, *measure_, *stop_;
  LensForm* form_;
  QLabel *images_label_, *outcome_;
  QProgressBar* bar_;
  QPushButton *take_, *forget_;
  QCheckBox* automatic_;
  QLabel *guide_, *forecast_;
  QListWidget* views_;
  std::filesystem::path camera_file_;
  std::optional<CameraFile> camera_;
  bool had_folder_ = false;  // a finger was open before it was loaded again
  BackgroundWork work_;

  std::shared_ptr<BoardCollector> collector_;  // while analysing_ runs, owned by its thread
  BoardCollector::Cells cells_{};
  std::optional<BoardAnalysis> detection_;  // in the newest analysed frame
  bool is_board_requested_ = false;
  std::string view_to_remove_;  // view to remove as soon as no frame is being analysed
  std::filesystem::path boards_folder_;
  std::shared_ptr<DiskQueue> disk_ = std::make_shared<DiskQueue>();
  std::shared_ptr<const LensCalibration> fitted_;
  bool is_fit_stale_ = false;
  BackgroundWork analysing_, fitting_;
};

}  // namespace alltact
