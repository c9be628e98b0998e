// The report of a calibration for the lab book: its grade and the evidence for it.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "calibration/finger/calibration_report.h"
#include "calibration/joint/calibrate.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/camera/camera.h"
#include "widgets/background_work.h"
#include "widgets/report/document.h"

#include <QImage>
#include <QObject>
#include <QSize>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// kReportHtml and kReportPdf of the finger in `folder`; the same calibration gives the same
/// bytes. Needs a QApplication, on any platform, and its thread. Errors: the job was stopped; the
/// printing failed.
[[nodiscard]] Result<std::vector<ReportFile>> make_calibration_pages(
    const FingerCalibration& done, const std::filesystem::path& folder, const Job& job);

/// The files of a finished report; any thread.
[[nodiscard]] Result<std::vector<ReportFile>> files_of(const Document& report,
                                                       const std::string& date, const Job& job);

// Image of a press for visual inspection: the region around the contact, with the ball's outline.

/// The part of an oriented grey image around the ball, scaled to `size` px. It shows the ball's
/// exact outline as the camera sees it, its centre, and dashed the border of the contact.
/// `contact_pixels`: of that part; may be empty. Parts beyond the image are grey.
[[nodiscard]] QImage press_image(const cv::Mat& grey, const Camera& camera, const BallFit& ball,
                                 const std::vector<Eigen::Vector2d>& contact_pixels,
                                 const QSize& size);

/// The full image, for a press without a ball.
[[nodiscard]] QImage full_image(const cv::Mat& grey, const QSize& size);

// Writes a calibration's report into the finger's folder while the window goes on.

/// Gives the same bytes as make_calibration_pages in a program without a window. Lives on the GUI
/// thread: plots are drawn there, one part at a time; the rest runs on another thread.
class ReportWriter : public QObject {
  Q_OBJECT
 public:
  explicit ReportWriter(QObject* parent = nullptr);
  ~ReportWriter() override;

  /// Replaces a report that is being written.
  void start(std::shared_ptr<const FingerCalibration> done, const std::filesystem::path& folder);
  /// Nothing is written from then on.
  void stop();
  [[nodiscard]] bool is_running() const { return pages_ != nullptr; }
  /// Why the last one could not be written.
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

 Q_SIGNALS:
  void finished();

 private:
  struct Pages;
  void draw(const std::shared_ptr<Pages>& pages);
  void write(const std::shared_ptr<Pages>& pages);
  void end(const Status& how);

  std::shared_ptr<Pages> pages_;  ///< of the report that is being written
  std::optional<Error> problem_;
  std::unique_ptr<BackgroundWork> work_;
};

}  // namespace alltact
