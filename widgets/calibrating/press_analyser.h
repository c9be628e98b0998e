// Analysis of one press image before any calibration: the shape of the face and the position of the
// ball.
#pragma once

#include "calibration/finger/forecast_calibration.h"
#include "calibration/presses/press.h"
#include "core/job.h"
#include "core/sensing/pipeline.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace alltact {

struct PressAnalysis {
  cv::Mat grey;                             ///< oriented; empty where analysis failed
  std::shared_ptr<const FaceShape> shape;   ///< null: no face was found
  std::optional<Eigen::Vector3d> found_mm;  ///< the ball's centre, camera frame
  std::optional<Error> problem;             ///< why there is no ball
  /// Input of a calibration; null where the image is not usable.
  std::shared_ptr<const ReferencedPress> measured;
};

/// Used by one thread at a time.
class PressAnalyser {
 public:
  /// Reads the finger's reference. Errors: those of open_finger and Pipeline::create.
  static Result<std::shared_ptr<PressAnalyser>> create(const std::filesystem::path& folder,
                                                       const Job& job);

  [[nodiscard]] const Camera& camera() const { return pipeline_.camera(); }
  [[nodiscard]] const Finger& finger() const { return pipeline_.finger(); }
  [[nodiscard]] bool is_perspective() const { return camera().is_perspective(); }

  /// radius_mm: of the ball; 0: unknown, and no ball is searched for.
  [[nodiscard]] PressAnalysis operator()(const FramePtr& frame, double radius_mm);

 private:
  explicit PressAnalyser(Pipeline pipeline) : pipeline_(std::move(pipeline)) {}
  Pipeline pipeline_;
};

}  // namespace alltact
