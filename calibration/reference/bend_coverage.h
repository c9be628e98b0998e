// In which directions a finger has been bent while it was recorded: the live picture of what
// calibration/reference/motion_coverage.h measures.
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

/// What a picture of the coverage shows.
struct BendPicture {
  MotionNeed need;
  std::array<double, kBendDirections> reached{};  ///< parts of what is needed, 1: enough
  /// Poses in bend (columns) and sway (rows), each from -1.5 to 1.5 times what is needed; how
  /// often.
  static constexpr int kCells = 15;
  static constexpr double kShown = 1.5;
  std::array<std::uint32_t, kCells * kCells> visits{};
  std::optional<TipMotion> now;
  std::uint64_t poses = 0;

  /// Not nearly reached. Twist is not asked of a finger that has been bent and swayed all ways and
  /// hardly twisted meanwhile: it has none.
  [[nodiscard]] std::vector<BendDirection> missing() const;
  [[nodiscard]] bool is_wanted(BendDirection direction) const;
  [[nodiscard]] bool is_enough() const { return poses > 0 && missing().empty(); }
};

/// Collects poses. Rest is the middle of those seen, so that it does not matter how a
/// recording begins, until somebody says which pose it is.
class BendCoverage {
 public:
  /// Forgets the poses, and keeps the rest that somebody set.
  void begin(const MotionNeed& need = {});
  /// Uses the pair of dots nearest the tip that the first pose shows; a pose that does not show it
  /// is none.
  void add(const Markers& markers, const FaceShape& shape);
  void add(const TipPlace& place);
  /// The markers could not be seen: there is no pose now.
  void add_nothing();
  /// The pose now is rest, for the poses before as well. False: there is no pose now.
  bool set_rest();
  [[nodiscard]] bool rest_is_set() const { return is_set_; }
  /// The rest that somebody set.
  [[nodiscard]] std::optional<RestPose> set_rest_pose() const;
  [[nodiscard]] const BendPicture& picture() const { return picture_; }

 private:
  void choose_rest();
  void show_again();
  void show(const TipPlace& place);
  [[nodiscard]] TipMotion motion_of(const TipPlace& place) const;

  BendPicture picture_;
  std::vector<TipPlace> places_;
  std::optional<std::size_t> pair_;
  std::optional<TipPlace> now_, rest_;
  TipMotion middle_;  // of all poses, told from rest_
  bool is_set_ = false;
  std::size_t next_choice_ = 1;  // number of poses at which rest is chosen anew
};

}  // namespace alltact
