// In which directions a finger has been bent while it was recorded: the live picture of what
// calibration/motion_coverage.h measures.
#pragma once

#include "calibration/motion_coverage.h"

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
  std::optional<Motion> now;
  std::uint64_t poses = 0;

  [[nodiscard]] std::vector<BendDirection> missing() const;
  [[nodiscard]] bool is_enough() const { return poses > 0 && missing().empty(); }
};

/// Collects poses. The first one is rest, as in the reference recording itself.
class BendCoverage {
 public:
  void begin(const MotionNeed& need = {});
  /// Uses the pair of dots nearest the tip that the first pose shows; a pose that does not show it
  /// is none.
  void add(const Markers& markers, const FaceShape& shape);
  void add(const Motion& motion);
  /// The markers could not be seen: there is no pose now.
  void add_nothing() { picture_.now.reset(); }
  [[nodiscard]] const BendPicture& picture() const { return picture_; }

 private:
  BendPicture picture_;
  std::size_t pair_ = 0;
  std::optional<TipPlace> rest_;
};

}  // namespace alltact
