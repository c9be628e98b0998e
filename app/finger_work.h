// What the window and the command line do with fingers in exactly the same way.
#pragma once

#include "calibration/reference_recording.h"
#include "core/finger/finger.h"
#include "core/job.h"
#include "core/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace alltact {

struct NewFinger {
  std::filesystem::path finger;  ///< the folder to make
  std::string name;              ///< empty: the folder's
  std::filesystem::path camera;  ///< CAMERA.yaml
  FaceKind kind = FaceKind::kFinRay;
  double width_mm = 0;
  double layer_mm = 0;
  double plane_z_mm = 0;
  int per_row = 0;
  Polarity polarity = Polarity::kAuto;
};

/// Makes a finger folder and gives what lies in it. Errors: there is a finger already; the camera
/// file or a value is wrong; the folder cannot be written.
[[nodiscard]] Result<Finger> make_finger(const NewFinger& wanted);

/// Installs a recording as a Fin Ray finger's reference and saves the finger. Errors: those of
/// open_source, install_reference and Finger::save.
[[nodiscard]] Result<ReferenceReport> install_recording(
    const std::filesystem::path& folder,
    Finger& finger,
    const std::vector<std::filesystem::path>& inputs,
    const Job& job,
    const MotionNeed& need = {});

/// A file of the resources, "scenes/NAME.yaml": beside the program once installed, in the source
/// tree while developing. Error: it is in neither.
[[nodiscard]] Result<std::filesystem::path> find_resource(const std::filesystem::path& name);

}  // namespace alltact
