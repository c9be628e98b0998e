// Drawing without a window: pages of reports and images of the face in 3D. load_figures() loads its
// library when an image is requested, so that the command line measures without Qt and OpenGL.
#pragma once

#include "calibration/experiments/experiments.h"
#include "calibration/finger/calibrate_finger.h"
#include "calibration/live/inspect_recording.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/sensing/pipeline.h"
#include "widgets/scene3d/scene_options.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Draws the face of one frame after another, seen from the viewpoint for the first one.
class FaceRenderer {
 public:
  virtual ~FaceRenderer() = default;
  /// CV_8UC3, blue, green, red. Error: the frame has no face.
  [[nodiscard]] virtual Result<cv::Mat> image(const FrameResult& result,
                                              const Pipeline& pipeline) = 0;
};

class Figures {
 public:
  virtual ~Figures() = default;

  /// calibration_report.html and .pdf of the finger in `folder` (calibration_pages.h). For the main
  /// thread.
  [[nodiscard]] virtual Result<std::vector<ReportFile>> calibration_pages(
      const FingerCalibration& done, const std::filesystem::path& folder, const Job& job) const = 0;

  /// NAME.html and NAME.pdf (experiment_pages.h). For the main thread.
  [[nodiscard]] virtual Result<std::vector<ReportFile>> experiment_pages(
      const ExperimentReport& report, const std::string& name) const = 0;

  /// PDF to sign (inspection_report_pdf). For the main thread.
  [[nodiscard]] virtual Result<std::string> inspection_report(const InspectionLog& log,
                                                              const InspectionOrder& order,
                                                              const std::string& date) const = 0;

  /// NAME.png and NAME.pdf of a figure (offscreen.h). For the main thread.
  [[nodiscard]] virtual Result<std::vector<ReportFile>> figure_files(
      const std::string& svg, const std::string& name, const std::string& date) const = 0;

  /// Error: this computer has no OpenGL 3.2, not even in software.
  [[nodiscard]] virtual Result<std::unique_ptr<FaceRenderer>> faces(cv::Size size_px,
                                                                    const SceneOptions& options,
                                                                    Viewpoint viewpoint) const = 0;
};

/// Loads the library the first time. Error: it is not installed, or is of another version.
[[nodiscard]] Result<const Figures*> load_figures();

}  // namespace alltact
