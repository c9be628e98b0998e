// Step 1, the lens: the camera's numbers, known already, from a file, or measured with a board that
// is held before the camera or was before.
#pragma once

#include "calibration/lens/board_collector.h"
#include "calibration/lens/calibrate_lens.h"
#include "core/camera/flat_port.h"
#include "core/io/disk_queue.h"
#include "widgets/background_work.h"
#include "widgets/calibrating/lens_form.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/live/live_session.h"
#include "widgets/panels/picture_panel.h"
#include "widgets/shell/problem_list.h"

#include <QCheckBox>
#include <QGroupBox>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>

namespace alltact {

struct LensWanted {
  std::filesystem::path pictures;  ///< a folder of them, or a recording
  Board board;
  LensSettings settings;
  std::optional<FlatPort>
      port;  ///< a window that the finger is seen through, and the board was not
  std::filesystem::path camera;  ///< the file to write
};
struct LensMeasured {
  Message verdict;  ///< a sentence
  std::vector<LensViewReport> views;
  Message advice;  ///< which views are missing; empty: none
};
/// Measures a lens as the command line does and writes the camera file. Runs on a thread of its
/// own.
using LensMeasurer = std::function<Result<LensMeasured>(const LensWanted&, const Job&)>;

class LensPage : public StepPage {
  Q_OBJECT
 public:
  /// work_folder: where a camera file that nobody named is written, and boards that are taken.
  LensPage(LiveSession& session,
           LensMeasurer measurer,
           std::filesystem::path work_folder,
           QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Lens"); }
  [[nodiscard]] StepState state() const override;
  [[nodiscard]] QString missing() const override;
  void press_pedal() override;
  [[nodiscard]] QVBoxLayout* foot() const override { return foot_; }
  [[nodiscard]] QWidget* main_control() const override;
  /// A camera file that can be used; empty where a finger is open, or none was chosen yet.
  [[nodiscard]] const std::filesystem::path& camera_file() const { return camera_file_; }
  void show_status();

 private:
  [[nodiscard]] QWidget* make_side();
  void connect_parts();
  void name_parts();
  void take_file(const std::filesystem::path& file);
  void choose_file();
  void choose_pictures();
  void use_simulated();
  void measure();
  void show_progress();
  void show_summary(bool is_own);
  void show_views(const std::vector<LensViewReport>& views);

  // lens_page_boards.cpp: boards of the live picture
  [[nodiscard]] bool is_own() const;
  [[nodiscard]] bool can_take() const;
  void look_at_frame();
  void take_look(const std::shared_ptr<BoardCollector>& by, const BoardLook& look);
  void want_board();
  void keep_board(const BoardLook& look);
  void forget_board();
  void forget_wanted_board();
  void begin_boards();
  void fit_boards();
  void show_boards();
  [[nodiscard]] QString board_words() const;
  [[nodiscard]] std::vector<Overlay> overlays(const LiveView& view) const;

  QVBoxLayout* foot_ = nullptr;
  LiveSession& session_;
  LensMeasurer measurer_;
  std::filesystem::path work_folder_;
  PicturePanel* live_;
  QLabel* summary_;
  ProblemList* problems_;
  QGroupBox *file_group_, *board_group_, *live_group_;
  QLineEdit *file_, *pictures_;
  QPushButton *choose_file_, *choose_pictures_, *simulated_, *measure_, *stop_;
  LensForm* form_;
  QLabel *pictures_label_, *outcome_;
  QProgressBar* bar_;
  QPushButton *take_, *forget_;
  QCheckBox* by_itself_;
  QLabel *guide_, *forecast_;
  QListWidget* views_;
  std::filesystem::path camera_file_;
  std::optional<CameraParameters> camera_;
  LensRecord record_;
  bool was_own_ = false;  // a finger was open before it was loaded again
  BackgroundWork work_;

  std::shared_ptr<BoardCollector> collector_;  // looking_ works on it, else this thread
  BoardCollector::Cells cells_{};
  std::optional<BoardLook> look_;  // the newest
  bool is_board_wanted_ = false;
  std::string unwanted_;  // a view to be left out as soon as no frame is looked at
  std::filesystem::path boards_folder_;
  std::shared_ptr<DiskQueue> disk_ = std::make_shared<DiskQueue>();
  std::shared_ptr<const LensCalibration> fitted_;
  bool is_fit_stale_ = false;
  BackgroundWork looking_, fitting_;
};

}  // namespace alltact
