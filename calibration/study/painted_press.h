// A ball or a bar painted into an untouched image, with its ground truth.
#pragma once

#include "calibration/study/study_world.h"
#include "core/finger/finger_store.h"
#include "core/numerics/philox.h"
#include "core/sensing/face/face_shape.h"

#include <cmath>
#include <cstdint>
#include <optional>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Random numbers of one painted image, from its own counter.
class StudyDraws {
 public:
  StudyDraws(std::uint64_t seed, std::uint32_t frame) : seed_(seed), frame_(frame) {}
  double uniform() { return philox_uniform(seed_, "study", frame_, next_++); }
  /// Box and Muller.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * M_PI * uniform());
  }

 private:
  std::uint64_t seed_;
  std::uint32_t frame_;
  std::uint32_t next_ = 0;
};

/// The pressing body: all points within radius_mm of a straight line segment; a ball where the
/// segment has no length. Camera frame.
struct PaintedBody {
  Eigen::Vector3d centre_mm;
  double radius_mm = 0;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< unit
  double half_length_mm = 0;
};

/// Distance, mm, along a line from `from` along the unit vector `direction` to its first point in
/// the body.
[[nodiscard]] std::optional<double> distance_to_body(const PaintedBody& body,
                                                     const Eigen::Vector3d& from,
                                                     const Eigen::Vector3d& direction);

class PressPainter {
 public:
  /// `finger` is calibrated and outlives this.
  PressPainter(const FingerSnapshot& finger, double radius_mm);

  /// grey: untouched, CV_8UC1; shape: of the face in it. The result includes the contact's
  /// position, from the same shape. nullopt: no valid position on this face.
  [[nodiscard]] std::optional<StudyFrame> ball(const cv::Mat& grey,
                                               const FaceShape& shape,
                                               StudyDraws& draws,
                                               FaceZone zone) const;
  /// A bar with round sides and ends, half as wide as the ball and 6 mm longer, with its angle.
  [[nodiscard]] std::optional<StudyFrame> bar(const cv::Mat& grey,
                                              const FaceShape& shape,
                                              StudyDraws& draws,
                                              FaceZone zone) const;

 private:
  struct Spot;
  [[nodiscard]] std::optional<Spot> spot_on(const FaceShape& shape,
                                            StudyDraws& draws,
                                            FaceZone zone) const;
  [[nodiscard]] StudyFrame painted_with(const PaintedBody& body,
                                        FaceZone zone,
                                        const cv::Mat& grey,
                                        const FaceShape& shape) const;

  const FingerSnapshot& finger_;
  const Mapping& mapping_;
  double radius_mm_;
  double deepest_mm_ = 0;
};

}  // namespace alltact
