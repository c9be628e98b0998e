#include "core/finger/pose_yaml.h"

namespace alltact {

RigidTransform read_pose(YamlSection section) {
  RigidTransform pose;
  const std::vector<double> at = section.numbers("translation_mm");
  if (at.size() != 3)
    section.refuse("translation_mm", en::say("must be three numbers: x, y, z in mm"), "");
  pose.translation_mm = {at[0], at[1], at[2]};
  const std::vector<double> turn = section.numbers("rotation");
  if (turn.size() != 4)
    section.refuse(
        "rotation", en::say("must be four numbers: w, x, y, z of a unit quaternion"), "");
  pose.rotation = {turn[0], turn[1], turn[2], turn[3]};
  return pose;
}

void add_pose(const RigidTransform& pose, YamlBlock& block) {
  const Eigen::Vector3d& at = pose.translation_mm;
  const Eigen::Quaterniond& turn = pose.rotation;
  block.add("translation_mm", yaml_numbers({at.x(), at.y(), at.z()}));
  block.add("rotation", yaml_numbers({turn.w(), turn.x(), turn.y(), turn.z()}));
}

std::optional<Error> pose_problem(const RigidTransform& pose, const std::string& key) {
  for (const double along : pose.translation_mm)
    if (!(along >= -1e4 && along <= 1e4))
      return Error{en::say("must be three numbers from -10000 to 10000"),
                   key + ".translation_mm",
                   en::say("where the camera sits in the gripper, in mm")};
  if (const double norm = pose.rotation.norm(); !(norm >= 0.999 && norm <= 1.001))
    return Error{en::say("is no rotation: a quaternion w, x, y, z has the length 1"),
                 key + ".rotation",
                 en::say("[1.0, 0.0, 0.0, 0.0] for a camera that is not turned")};
  return std::nullopt;
}

}  // namespace alltact
