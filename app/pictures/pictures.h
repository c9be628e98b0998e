// What takes a window's libraries to draw, though no window opens: pages of reports and pictures of
// the face in 3D. It stands in a library of its own, liballtact-pictures.so, which is loaded when a
// picture is asked for, so that the command line needs neither Qt nor OpenGL to measure.
#pragma once

#include "calibration/experiments/experiments.h"
#include "calibration/finger/calibrate_finger.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/pipeline.h"
#include "widgets/scene3d/scene_options.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Draws the face of one frame after another, looked at from where that of the first would be.
class FacePictures {
 public:
  virtual ~FacePictures() = default;
  /// CV_8UC3, blue, green, red. Error: the frame has no face.
  [[nodiscard]] virtual Result<cv::Mat> picture(const FrameResult& result,
                                                const Pipeline& pipeline) = 0;
};

class Pictures {
 public:
  virtual ~Pictures() = default;

  /// calibration_report.html and .pdf of the finger in `folder` (calibration_pages.h). Of the main
  /// thread.
  [[nodiscard]] virtual Result<std::vector<ReportFile>> calibration_pages(
      const FingerCalibration& done, const std::filesystem::path& folder, const Job& job) const = 0;

  /// NAME.html and NAME.pdf (experiment_pages.h). Of the main thread.
  [[nodiscard]] virtual Result<std::vector<ReportFile>> experiment_pages(
      const ExperimentReport& report, const std::string& name) const = 0;

  /// NAME.png and NAME.pdf of a figure (svg_figure.h). Of the main thread.
  [[nodiscard]] virtual Result<std::vector<ReportFile>> figure_files(
      const std::string& svg, const std::string& name, const std::string& date) const = 0;

  /// Error: this computer has no OpenGL 3.2, not even in software.
  [[nodiscard]] virtual Result<std::unique_ptr<FacePictures>> faces(
      cv::Size size_px, const SceneOptions& options, Standpoint standpoint) const = 0;
};

/// Loads the library the first time. Error: it is not installed, or is of another version.
[[nodiscard]] Result<const Pictures*> load_pictures();

}  // namespace alltact
