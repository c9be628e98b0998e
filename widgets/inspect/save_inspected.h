// Exports what is shown. Slow: not for the window's thread.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/geometry/surface_distance.h"
#include "core/recording/video_file.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/scene3d/vtk_view.h"
#include "widgets/widget_base.h"

#include <QComboBox>
#include <QProgressBar>
#include <QPushButton>
#include <array>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

// Renders images and films of the inspected faces without a window. Slow: not for the window's
// thread.

/// How a film is rendered.
struct FilmView {
  InspectOptions options;
  SceneColours colours;
  cv::Size size_px{1280, 720};
  double pixels_per_unit = 1;  ///< scale of lines and letters
};

/// Figure for a paper: PNG, 300 dots per inch, 17 cm wide, in the aspect ratio of the view, on
/// white. Errors: no face, no OpenGL, not writable.
[[nodiscard]] Status save_paper_figure(const FramePair& moment, FilmView view,
                                       const std::filesystem::path& file);
inline constexpr double kPaperDotsPerInch = 300, kPaperWidth_px = 2008;

/// Writes a PNG of 300 dots per inch, atomically.
///   bgr: CV_8UC3, blue, green, red
[[nodiscard]] Status write_paper_figure(const std::filesystem::path& file, const cv::Mat& bgr);

/// The contact face in the format of the file's ending: see write_surface(); .tiff: its depth over
/// the face (rectified_map.h). Errors: no face; those of writing.
[[nodiscard]] Status save_surface(const InspectedFrame& frame, const std::filesystem::path& file);

/// NAME-1 and NAME-2 with the ending of `file`.
[[nodiscard]] std::vector<std::filesystem::path> files_of_both(const std::filesystem::path& file);
/// Both contact faces of a joint pair, in the gripper's frame, into files_of_both(). Errors: as
/// save_surface().
[[nodiscard]] Status save_both(const FramePair& frames, const std::filesystem::path& file);

/// A 3D video (Matroska, Motion JPEG) of the full recording at its frame rate; needs no display.
/// Frames without a face are skipped. A stopped file is valid up to that frame. Errors: no OpenGL,
/// no frame with a face, those of reading and writing.
///   finger: the folder of the finger that measures view.options.recording
///   poses: see FramePair
[[nodiscard]] Status save_film(const std::filesystem::path& finger, const FilmView& view,
                               const std::optional<std::array<RigidTransform, 2>>& poses,
                               const std::filesystem::path& file, const Job& job);

/// Queue of live moments for a film. When it is full, the oldest is dropped.
class FilmQueue {
 public:
  static constexpr std::size_t kMaxMoments = 4;
  void add(FramePair moment);
  /// Waits up to 100 ms; nullopt: nothing arrived.
  [[nodiscard]] std::optional<FramePair> next();

 private:
  mutable std::mutex mutex_;
  std::condition_variable added_;
  std::deque<FramePair> moments_;
};

/// A video of the queue's moments until it is stopped. Errors: as save_film().
[[nodiscard]] Status save_live_film(FilmQueue& queue, const FilmView& view,
                                    const std::filesystem::path& file, const Job& job);

// Choice of a file format, and the progress of saving.

/// File endings of all formats.
inline constexpr std::array<const char*, 10> kSaveFormats{"ply", "vtp", "stl", "glb", "tiff",
                                                          "png", "pdf", "svg", "csv", "mkv"};

struct CanSave {
  bool surface = false;  ///< PLY, VTP, STL, glTF, TIFF
  bool image = false;    ///< PNG
  bool section = false;  ///< PDF, SVG, CSV of the cross-section
  bool film = false;     ///< MKV
  [[nodiscard]] bool saves(const std::string& ending) const;
};

class SaveBar : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit SaveBar(QWidget* parent = nullptr);

  void set_can_save(const CanSave& can);
  /// None: nothing is being saved. Below 0: saving continues until it is stopped.
  void show_progress(std::optional<double> fraction);

 Q_SIGNALS:
  void save_requested(const QString& ending);
  void stop_requested();

 private:
  QComboBox* kind_;
  QPushButton *save_, *stop_;
  QProgressBar* progress_;
};

}  // namespace alltact
