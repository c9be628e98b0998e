// What one press picture shows before anything is calibrated: the face, and where the ball is.
#pragma once

#include "calibration/finger/forecast_calibration.h"
#include "calibration/presses/press.h"
#include "core/job.h"
#include "core/sensing/pipeline.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace alltact {

struct LookedAt {
  cv::Mat grey;                             ///< oriented; empty where it could not be looked at
  std::shared_ptr<const FaceShape> shape;   ///< null: no face was found
  std::optional<Eigen::Vector3d> found_mm;  ///< the ball's centre
  std::optional<Error> problem;             ///< why there is no ball
  /// What a calibration reads of it; null where the picture could not be used.
  std::shared_ptr<const ReferencedPress> measured;
};

/// Used by one thread at a time.
class PressLooker {
 public:
  /// Reads the finger's reference. Errors: those of open_finger and Pipeline::create.
  static Result<std::shared_ptr<PressLooker>> create(const std::filesystem::path& folder,
                                                     const Job& job);

  [[nodiscard]] const Camera& camera() const { return pipeline_.camera(); }
  [[nodiscard]] const Finger& finger() const { return pipeline_.finger(); }
  [[nodiscard]] bool is_perspective() const { return camera().is_perspective(); }

  /// radius_mm: of the ball; 0 where it is not known: then no ball is looked for.
  [[nodiscard]] LookedAt operator()(const FramePtr& frame, double radius_mm);

 private:
  explicit PressLooker(Pipeline pipeline) : pipeline_(std::move(pipeline)) {}
  Pipeline pipeline_;
};

}  // namespace alltact
