// How the finger twists, told by its two rows of dots.
#pragma once

#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// What a finger's recording says of its pairs of dots, one of each row. A pair is tied to one
/// cross-section; in a picture it leans by
///   turn = -dx / dy = g (tan(twist)) + k (yaw + offset),  g = t . ray, k = n . ray,
/// ray = (x, y, 1) the pair's direction, t and n along the face's length and normal to it, twist
/// and yaw the cross-section's turns about the finger's length and about its normal, and offset
/// what the pair leans by on a straight finger. Where the finger sways its cross-sections may turn
/// along (yaw = slope of the middle line, as in a beam) or slide past each other (yaw = 0):
/// `yaw_per_slope` between both is the finger's own.
///
/// No twist is what the middle of the recording shows: half of its frames are twisted one way and
/// half the other.
class TwistModel {
 public:
  /// One frame of the recording: its markers and the shape that its edges alone give.
  struct Pose {
    Markers markers;
    FaceShape shape;
  };

  /// nullopt: fewer than 3 pairs, or fewer than 2 frames that show them.
  static std::optional<TwistModel> learn(const std::vector<Pose>& recording);

  /// The twist of a frame: nullopt where it cannot be told from none, or too few pairs are seen.
  [[nodiscard]] std::optional<FaceTwist> operator()(const Markers& markers,
                                                    const FaceShape& shape) const;

  /// The shape that its edges alone gave, turned by the twist that the frame shows; nullopt where
  /// there is none to be told, or none that fits the edges.
  [[nodiscard]] std::optional<FaceShape> twisted(const Markers& markers,
                                                 const FaceShape& shape) const;

  [[nodiscard]] double yaw_per_slope() const { return yaw_per_slope_; }

 private:
  struct Pair {
    std::size_t upper = 0, lower = 0;  // numbers of the markers
    double offset = 0;                 // rad
    double sd = 0;                     // of a turn: how well a smooth twist explains the recording
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
