// In which directions a finger has been bent while it was recorded, from its markers.
#pragma once

#include "core/sensing/markers.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace alltact {

/// How the markers of both rows lie against their places at rest, mean over the row, px:
///   bend: both rows along the finger, towards the tip positive; grows as the finger bends away;
///   sway: both rows across the finger, towards large v positive;
///   twist: the rows against each other along the finger.
struct BendPose {
  double bend_px = 0, sway_px = 0, twist_px = 0;
};

/// Empty where the numbers of markers differ, or fewer than half of the markers are seen.
[[nodiscard]] std::optional<BendPose> bend_pose(const Markers& markers,
                                                const Markers& rest,
                                                bool base_at_low_u);

/// How far a recording has to go in each direction, px.
struct BendNeed {
  double bend_px = 0, sway_px = 0, twist_px = 0;

  /// For a picture so wide: what bending a finger by about a twentieth of its length moves.
  [[nodiscard]] static BendNeed for_width(int width_px);
};

enum class BendDirection { kAway = 0, kTowards, kUp, kDown, kTwistRight, kTwistLeft };
inline constexpr std::size_t kBendDirections = 6;

/// What a picture of the coverage shows.
struct BendPicture {
  BendNeed need;
  std::array<double, kBendDirections> reached{};  ///< parts of what is needed, 1: enough
  /// Poses in bend (columns) and sway (rows), each from -1.5 to 1.5 times what is needed; how
  /// often.
  static constexpr int kCells = 15;
  std::array<std::uint32_t, kCells * kCells> visits{};
  std::optional<BendPose> now;
  std::uint64_t poses = 0;

  [[nodiscard]] std::vector<BendDirection> missing() const;
  [[nodiscard]] bool is_enough() const { return poses > 0 && missing().empty(); }
};

/// Collects poses. The first complete layout is rest, unless rest is known.
class BendCoverage {
 public:
  void begin(const BendNeed& need, std::optional<Markers> rest = std::nullopt);
  void add(const Markers& markers, bool base_at_low_u);
  /// The markers could not be seen: there is no pose now.
  void add_nothing() { picture_.now.reset(); }
  [[nodiscard]] const BendPicture& picture() const { return picture_; }

 private:
  BendPicture picture_;
  std::optional<Markers> rest_;
};

}  // namespace alltact
