// Range of motion of a recording, against what grasping needs.
#pragma once

#include "core/message.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Difference of a pose from rest, from a pair of dots near the tip.
struct TipMotion {
  double bend_mm = 0;    ///< of the tip at right angles to the face, > 0 away from the camera
  double sway_mm = 0;    ///< of the tip across the finger, > 0 towards +y
  double twist_deg = 0;  ///< rotation of the line through both dots in the image
};

/// Pose of the face between the two dots of a pair, and direction of their line.
struct TipPose {
  Eigen::Vector3d middle_mm;  ///< on the middle line of the view face
  Eigen::Vector3d normal;     ///< of the face there
  double turn_rad = 0;        ///< of the line from the upper to the lower dot, from +v towards -u
};
/// pair: 0 at the base to n - 1 at the tip. nullopt where the face is not visible between the dots.
[[nodiscard]] std::optional<TipPose> tip_pose(const Markers& markers,
                                              std::size_t pair,
                                              const FaceShape& shape);
[[nodiscard]] TipMotion motion_between(const TipPose& rest, const TipPose& now);

/// Required range for grasping, in both directions of each motion.
struct MotionNeed {
  double bend_mm = 4.0;
  double sway_mm = 1.5;
  double twist_deg = 2.0;
};

class MotionCoverage {
 public:
  static constexpr int kCells = 6;  ///< across the range of bend, and of sway

  explicit MotionCoverage(const MotionNeed& need) : need_(need) {}
  void add(const TipMotion& motion);

  struct Reach {
    double least = 0, most = 0;
  };
  [[nodiscard]] Reach bend_mm() const { return bend_; }
  [[nodiscard]] Reach sway_mm() const { return sway_; }
  [[nodiscard]] Reach twist_deg() const { return twist_; }
  [[nodiscard]] const MotionNeed& need() const { return need_; }
  /// Frames in each cell of bend (column) and sway (row) over the required range, minimum first.
  [[nodiscard]] const std::array<std::array<int, kCells>, kCells>& cells() const { return cells_; }
  /// Fraction of the cells, without corners, that contain a frame.
  [[nodiscard]] double covered() const;
  /// Motions still to be done, in words, the most important first; empty when all is covered.
  [[nodiscard]] std::vector<Message> missing() const;

 private:
  MotionNeed need_;
  Reach bend_, sway_, twist_;
  std::array<std::array<int, kCells>, kCells> cells_{};
};

}  // namespace alltact
