// Joint readings of two fingers of one gripper at one moment.
#pragma once

#include "core/gripper/face_gap.h"
#include "core/gripper/gripper.h"
#include "core/gripper/held_object.h"
#include "widgets/pair/view_pairing.h"

#include <array>
#include <filesystem>
#include <optional>

namespace alltact {

/// A gripper with the absolute folders of its fingers.
struct OpenGripper {
  Gripper gripper;
  std::array<std::filesystem::path, 2> folders;

  /// Errors: those of Gripper::load.
  static Result<OpenGripper> load(const std::filesystem::path& path);
  /// Indices of these fingers in the gripper; nullopt: they are not its two.
  [[nodiscard]] std::optional<std::array<std::size_t, 2>> order_of(
      const std::array<std::filesystem::path, 2>& fingers) const;
};

struct PairReading {
  ViewPair of;
  double motor_turns = 0;
  std::optional<FaceGap> gap;      ///< empty where a face has no depth
  std::optional<HeldWidth> width;  ///< empty where a finger has no contact
};

/// A finger in a view of the pair.
struct PairedFinger {
  std::filesystem::path folder;
  Face face;
};

/// Errors: the fingers are not the gripper's; those of Gripper::pose_at. Takes tens of
/// milliseconds: not for the window's thread.
[[nodiscard]] Result<PairReading> read_pair(const OpenGripper& gripper,
                                            double motor_turns,
                                            const ViewPair& pair,
                                            const std::array<PairedFinger, 2>& fingers);

}  // namespace alltact
