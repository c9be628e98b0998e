// Parts of finger.yaml that other files contain as well.
#pragma once

#include "core/base/result.h"
#include "core/base/yaml.h"
#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/geometry/rigid_transform.h"

#include <optional>
#include <string>

namespace alltact {

/// Writes the key `camera:` of a finger file. `unknown`: the file's other keys; the caller adds
/// those directly under `camera`.
void add_camera(const CameraParameters& parameters, const LensRecord& record,
                const UnknownKeys& unknown, YamlBlock& block);

// Pose of a camera, to and from YAML: `translation_mm` and `rotation` of a RigidTransform.

/// For YamlFile::read(): three and four numbers; pose_problem() checks their values.
[[nodiscard]] RigidTransform read_pose(YamlSection section);

void add_pose(const RigidTransform& pose, YamlBlock& block);

/// Error for a coordinate beyond 10000 mm, a rotation not within 0.001 of unit length, or NaN.
/// `key` is the pose's key, the error's `where` the key below it.
[[nodiscard]] std::optional<Error> pose_problem(const RigidTransform& pose, const std::string& key);

}  // namespace alltact
