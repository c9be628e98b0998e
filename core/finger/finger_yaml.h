// Parts of finger.yaml that other files contain as well.
#pragma once

#include "core/base/fields.h"
#include "core/base/result.h"
#include "core/geometry/rigid_transform.h"

#include <optional>
#include <string>

namespace alltact {

/// Pose of a camera; pose_problem() checks its values.
void describe(Fields& fields, RigidTransform& pose);

/// Error for a coordinate beyond 10000 mm, a rotation not within 0.001 of unit length, or NaN.
/// `key` is the pose's key, the error's `where` the key below it.
[[nodiscard]] std::optional<Error> pose_problem(const RigidTransform& pose, const std::string& key);

}  // namespace alltact
