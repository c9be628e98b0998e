// Directions in which a finger has been bent during a recording: the live display of the measures
// in calibration/reference/motion_coverage.h.
#pragma once

#include "calibration/reference/motion_coverage.h"
#include "calibration/reference/reference_recording.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace alltact {

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
  std::array<std::uint32_t, kCells * kCells> visits{};
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

}  // namespace alltact
