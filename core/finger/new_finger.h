// Input for a new finger, from the window or the command line.
#pragma once

#include "core/finger/finger.h"
#include "core/result.h"

#include <filesystem>
#include <string>

namespace alltact {

struct NewFinger {
  std::filesystem::path finger;  ///< the folder to make
  std::string name;              ///< empty: the folder's name
  std::filesystem::path camera;  ///< CAMERA.yaml
  FaceKind kind = FaceKind::kFinRay;
  double width_mm = 0;
  double layer_mm = 0;
  double plane_z_mm = 0;
  int per_row = 0;
  Polarity polarity = Polarity::kAuto;
  std::optional<RigidTransform> gripper_from_camera;
};

/// Makes a finger folder and returns the finger. Errors: there is a finger already; the camera file
/// or a value is wrong; the folder cannot be written.
[[nodiscard]] Result<Finger> make_finger(const NewFinger& requested);

}  // namespace alltact
