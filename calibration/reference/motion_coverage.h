// Range of motion of a recording, against what grasping needs.
#pragma once

#include "core/base/message.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <array>
#include <cstdint>
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
/// The rest of a finger, set by a person: the pose at a pair of its dots.
struct RestPose {
  std::size_t pair = 0;  ///< 0 at the base
  TipPose pose;
};

/// pair: 0 at the base to n - 1 at the tip. nullopt where the face is not visible between the dots.
[[nodiscard]] std::optional<TipPose> tip_pose(const Markers& markers, std::size_t pair,
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

// Directions in which a finger has been bent during a recording: the live display of the measures
// in calibration/reference/motion_coverage.h.

enum class BendDirection { kAway = 0, kTowards, kUp, kDown, kTwistRight, kTwistLeft };
inline constexpr std::size_t kBendDirections = 6;

/// The displayed state of the coverage.
struct BendState {
  MotionNeed need;
  std::array<double, kBendDirections> reached{};  ///< fractions of what is needed, 1: enough
  /// Poses in bend (columns) and sway (rows), each from -1.5 to 1.5 times what is needed; number of
  /// visits.
  static constexpr int kCells = 15;
  static constexpr double kShown = 1.5;
  std::array<std::uint32_t, std::size_t{kCells} * kCells> visits{};
  std::optional<TipMotion> now;
  std::uint64_t poses = 0;

  /// Directions not nearly reached. Twist is not required of a finger that has been bent and swayed
  /// in all directions and hardly twisted meanwhile: it has none.
  [[nodiscard]] std::vector<BendDirection> missing() const;
  [[nodiscard]] bool is_required(BendDirection direction) const;
  [[nodiscard]] bool is_enough() const { return poses > 0 && missing().empty(); }
};

/// Collects poses. Rest is the middle of all poses, independent of the recording's start, until
/// set_rest() defines it.
class BendCoverage {
 public:
  /// Clears the poses; a rest that was set stays.
  void begin(const MotionNeed& need = {});
  /// Uses the pair of dots nearest the tip that the first pose shows. A pose without that pair is
  /// ignored.
  void add(const Markers& markers, const FaceShape& shape);
  void add(const TipPose& pose);
  /// The markers are not visible: there is no current pose.
  void clear_pose();
  /// Defines the current pose as rest, for earlier poses as well. False: there is no current pose.
  bool set_rest();
  [[nodiscard]] bool rest_is_set() const { return is_set_; }
  /// The rest that was set.
  [[nodiscard]] std::optional<RestPose> set_rest_pose() const;
  [[nodiscard]] const BendState& state() const { return state_; }

 private:
  void choose_rest();
  void rebuild();
  void accumulate(const TipPose& pose);
  [[nodiscard]] TipMotion motion_of(const TipPose& pose) const;

  BendState state_;
  std::vector<TipPose> poses_;
  std::optional<std::size_t> pair_;
  std::optional<TipPose> now_, rest_;
  TipMotion middle_;  // of all poses, relative to rest_
  bool is_set_ = false;
  std::size_t next_choice_ = 1;  // number of poses at which rest is chosen anew
};

// Target outline of a finger that moves a little further: a guide for the hand during the recording
// of a reference.

/// Both edges of the face from base to tip, px of the oriented image.
struct BentOutline {
  std::vector<Eigen::Vector2d> upper, lower;
};

/// The face moved by `motion` at its tip, as a cantilever beam: displacement (s / L)^2 of the
/// motion at s of the length L. nullopt: no face is visible.
[[nodiscard]] std::optional<BentOutline> bent_outline(const FaceShape& shape,
                                                      const TipMotion& motion);

/// Motion from the current pose to slightly beyond what is needed in a direction; zero where no
/// pose is known.
[[nodiscard]] TipMotion motion_left(const BendState& image, BendDirection direction);

}  // namespace alltact
