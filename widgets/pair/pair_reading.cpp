#include "widgets/pair/pair_reading.h"

#include <cmath>

namespace alltact {
namespace fs = std::filesystem;
namespace {

fs::path canonical_folder(const fs::path& folder) {
  std::error_code ignored;
  const fs::path canonical = fs::weakly_canonical(folder, ignored);
  return canonical.has_filename() ? canonical : canonical.parent_path();  // "left/" is "left"
}

GapFace gap_face(const FrameResult& result, const Face& face) {
  GapFace gap;
  gap.points_mm = contact_face_points_mm(result, face);
  gap.z_sd_mm = [shape = *result.shape](double u) -> std::optional<double> {
    const int column = static_cast<int>(std::lround(u));
    if (column < 0 || column >= shape.width_px()) return std::nullopt;
    const FaceColumn& at = shape.columns()[static_cast<std::size_t>(column)];
    return at.valid ? std::optional(at.z_sd_mm) : std::nullopt;
  };
  return gap;
}

}  // namespace

Result<OpenGripper> OpenGripper::load(const fs::path& path) {
  auto gripper = Gripper::load(path);
  if (!gripper) return gripper.error();
  std::error_code ignored;
  const fs::path folder = fs::is_directory(path, ignored) ? path : path.parent_path();
  OpenGripper open{std::move(*gripper), {}};
  for (std::size_t i = 0; i < 2; ++i)
    open.folders[i] =
        canonical_folder(fs::absolute(folder, ignored) / open.gripper.fingers[i].folder);
  return open;
}

std::optional<std::array<std::size_t, 2>> OpenGripper::order_of(
    const std::array<fs::path, 2>& fingers) const {
  const std::array canonical{canonical_folder(fingers[0]), canonical_folder(fingers[1])};
  if (canonical[0] == folders[0] && canonical[1] == folders[1])
    return std::array<std::size_t, 2>{0, 1};
  if (canonical[0] == folders[1] && canonical[1] == folders[0])
    return std::array<std::size_t, 2>{1, 0};
  return std::nullopt;
}

Result<PairReading> read_pair(const OpenGripper& gripper,
                              double motor_turns,
                              const ViewPair& pair,
                              const std::array<PairedFinger, 2>& fingers) {
  const auto order = gripper.order_of({fingers[0].folder, fingers[1].folder});
  if (!order)
    return Error{en::say("the gripper's fingers are {} and {}, and others are open",
                         gripper.folders[0].string(),
                         gripper.folders[1].string()),
                 "",
                 en::say("opening these two fingers")};
  const auto pose = gripper.gripper.pose_at(motor_turns);
  if (!pose) return pose.error();
  PairReading reading{pair, motor_turns, {}, {}};
  std::array<const FrameResult*, 2> results{};  // in the gripper's order
  std::array<const Face*, 2> faces{};
  for (std::size_t i = 0; i < 2; ++i) {
    results[(*order)[i]] = &pair.views[i]->result;
    faces[(*order)[i]] = &fingers[i].face;
  }
  if (results[0]->depth && results[0]->shape && results[1]->depth && results[1]->shape)
    reading.gap =
        face_gap(*pose, {gap_face(*results[0], *faces[0]), gap_face(*results[1], *faces[1])});
  if (!results[0]->regions.empty() && !results[1]->regions.empty())
    reading.width = held_width(*pose,
                               {observed_contact(results[0]->regions.front()),
                                observed_contact(results[1]->regions.front())});
  return reading;
}

}  // namespace alltact
