// Writes a calibration's report into the finger's folder while the window goes on.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "widgets/background_work.h"

#include <QObject>
#include <filesystem>
#include <memory>
#include <optional>

namespace alltact {

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
  void prepare(const std::shared_ptr<Pages>& pages);
  void draw(const std::shared_ptr<Pages>& pages);
  void write(const std::shared_ptr<Pages>& pages);
  void end(const Status& how);

  std::shared_ptr<Pages> pages_;  ///< of the report that is being written
  std::optional<Error> problem_;
  std::unique_ptr<BackgroundWork> work_;
};

}  // namespace alltact
