// Estimates the twist of the finger from its two rows of dots.
#pragma once

#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Model of a finger's recorded pairs of dots, one of each row. A pair is fixed to one
/// cross-section; in an image it leans by
///   turn = -dx / dy = g (tan(twist)) + k (yaw + offset),  g = t . ray, k = n . ray,
/// ray = (x, y, 1) is the pair's direction, t and n are along the face's length and normal to it.
/// Twist and yaw are the cross-section's rotations about the finger's length and about its normal.
/// `offset` is the lean on a straight finger. Where the finger sways, cross-sections may turn along
/// (yaw = slope of the middle line, as in a beam) or slide past each other (yaw = 0).
/// `yaw_per_slope` between both is a property of the finger.
///
/// Zero twist is the median of the recording: half of its frames are twisted to one side and half
/// to the other.
class TwistModel {
 public:
  /// One frame of the recording: its markers, and the shape from its edges alone.
  struct Pose {
    Markers markers;
    FaceShape shape;
  };

  /// nullopt: fewer than 3 pairs, or fewer than 2 frames that show them.
  static std::optional<TwistModel> learn(const std::vector<Pose>& recording);

  /// The twist of a frame; nullopt where it is not significant, or too few pairs are seen.
  [[nodiscard]] std::optional<FaceTwist> operator()(const Markers& markers,
                                                    const FaceShape& shape) const;

  /// The shape from the edges alone, turned by the twist of the frame. nullopt where no twist is
  /// significant, or none fits the edges.
  [[nodiscard]] std::optional<FaceShape> twisted(const Markers& markers,
                                                 const FaceShape& shape) const;

  [[nodiscard]] double yaw_per_slope() const { return yaw_per_slope_; }

 private:
  struct Pair {
    std::size_t upper = 0, lower = 0;  // numbers of the markers
    double offset = 0;                 // rad
    double sd = 0;                     // of a turn: residual of a smooth twist in the recording
  };
  struct Lean;
  using Leans = std::vector<Lean>;  // of one frame
  [[nodiscard]] Leans leans_of(const Markers& markers, const FaceShape& shape) const;
  [[nodiscard]] std::optional<FaceTwist> fit(const Leans& leans) const;
  void find_pairs(const std::vector<Pose>& recording);
  bool find_offsets(const std::vector<Leans>& recording);
  void find_yaw(const std::vector<Leans>& recording);
  void find_sd(const std::vector<Leans>& recording);

  std::vector<Pair> pairs_;
  double yaw_per_slope_ = 0;
};

}  // namespace alltact
