// Step 1, the lens: the camera's numbers, known already, from a file, or measured with pictures of
// a board.
#pragma once

#include "calibration/lens/calibrate_lens.h"
#include "widgets/background_work.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/live/live_session.h"
#include "widgets/shell/problem_list.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>

namespace alltact {

struct LensWanted {
  std::filesystem::path pictures;  ///< a folder of them, or a recording
  Board board;
  LensSettings settings;
  std::filesystem::path camera;  ///< the file to write
};
/// Measures a lens as the command line does and writes the camera file; gives the verdict, a
/// sentence. Runs on a thread of its own.
using LensMeasurer = std::function<Result<Message>(const LensWanted&, const Job&)>;

class LensPage : public StepPage {
  Q_OBJECT
 public:
  /// work_folder: where a camera file that nobody named is written.
  LensPage(LiveSession& session,
           LensMeasurer measurer,
           std::filesystem::path work_folder,
           QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Lens"); }
  [[nodiscard]] StepState state() const override;
  [[nodiscard]] QString missing() const override;
  [[nodiscard]] QWidget* main_control() const override { return choose_file_; }
  /// A camera file that can be used; empty where a finger is open, or none was chosen yet.
  [[nodiscard]] const std::filesystem::path& camera_file() const { return camera_file_; }
  void show_status();

 private:
  [[nodiscard]] QWidget* make_board_group();
  void name_parts();
  void take_file(const std::filesystem::path& file);
  void choose_file();
  void choose_pictures();
  void use_simulated();
  void measure();
  void show_progress();

  LiveSession& session_;
  LensMeasurer measurer_;
  std::filesystem::path work_folder_;
  QLabel* summary_;
  ProblemList* problems_;
  QGroupBox *file_group_, *board_group_;
  QLineEdit *file_, *pictures_;
  QPushButton *choose_file_, *choose_pictures_, *simulated_, *measure_, *stop_;
  QComboBox* pattern_;
  QSpinBox *columns_, *rows_;
  QDoubleSpinBox* square_;
  QLabel *pictures_label_, *pattern_label_, *size_label_, *square_label_, *by_label_, *outcome_;
  QProgressBar* bar_;
  std::filesystem::path camera_file_;
  std::optional<CameraParameters> camera_;
  LensRecord record_;
  bool was_own_ = false;  // a finger was open before it was loaded again
  BackgroundWork work_;
};

}  // namespace alltact
