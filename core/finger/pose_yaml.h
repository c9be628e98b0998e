// Pose of a camera, to and from YAML: `translation_mm` and `rotation` of a RigidTransform.
#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/result.h"
#include "core/yaml/yaml_reader.h"
#include "core/yaml/yaml_writer.h"

#include <optional>
#include <string>

namespace alltact {

/// For YamlFile::read(): three and four numbers; pose_problem() checks their values.
[[nodiscard]] RigidTransform read_pose(YamlSection section);

void add_pose(const RigidTransform& pose, YamlBlock& block);

/// Error for a coordinate beyond 10000 mm, a rotation not within 0.001 of unit length, or NaN.
/// `key` is the pose's key, the error's `where` the key below it.
[[nodiscard]] std::optional<Error> pose_problem(const RigidTransform& pose, const std::string& key);

}  // namespace alltact
