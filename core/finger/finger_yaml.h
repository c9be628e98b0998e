// Content of finger.yaml, to and from YAML.
#pragma once

#include "core/base/result.h"
#include "core/base/yaml.h"
#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/geometry/rigid_transform.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// For YamlFile::read(). Checks the form of the values; Finger::validate checks the values.
[[nodiscard]] Finger read_finger(YamlSection& top);

/// A valid finger as a file. `unknown`: unknown keys of its original file.
[[nodiscard]] std::string finger_text(const Finger& finger, const UnknownKeys& unknown);

/// The words of the file, in the order of the enums, which count from 1.
using FingerWords = std::vector<std::string_view>;
inline const FingerWords kFaceKinds{"fin_ray", "flat"};
inline const FingerWords kPolarities{"bright", "dark", "auto"};
inline const FingerWords kMappingKinds{"polynomial", "moebius"};
inline const FingerWords kAlongs{"z", "normal", "projected"};

// The key `camera:` of a finger file, to and from YAML.

/// For YamlFile::read(). Checks the form of the values; Camera::create() checks the values.
[[nodiscard]] CameraParameters read_camera(YamlSection& section, LensRecord& record);
/// `unknown`: the file's other keys; the caller adds those directly under `camera`.
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
