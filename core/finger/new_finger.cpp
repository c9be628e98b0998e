#include "core/finger/new_finger.h"

#include "core/camera/camera.h"
#include "core/io/atomic_file.h"
#include "core/program.h"

namespace alltact {

Result<Finger> make_finger(const NewFinger& requested) {
  std::error_code ignored;
  const std::filesystem::path file = requested.finger / Finger::kFileName;
  if (std::filesystem::exists(file, ignored)) {
    return Error{en::say("there is a finger already, and it is never overwritten"),
                 file.string(),
                 en::say("another folder, or moving that one away")};
  }
  LensRecord lens_record;
  auto camera = load_camera(requested.camera, &lens_record);
  if (!camera) return camera.error();
  if (const auto valid = Camera::create(*camera); !valid) return valid.error();

  Finger finger;
  finger.name = requested.name;
  if (finger.name.empty())
    finger.name =
        std::filesystem::absolute(requested.finger / "").parent_path().filename().string();
  finger.camera = std::move(camera).value();
  finger.lens_record = std::move(lens_record);
  finger.face.kind = requested.kind;
  finger.face.width_mm = requested.width_mm;
  finger.face.layer_mm = requested.layer_mm;
  finger.face.plane_z_mm = requested.plane_z_mm;
  finger.markers.per_row = requested.per_row;
  finger.markers.polarity = requested.polarity;
  finger.gripper_from_camera = requested.gripper_from_camera;
  finger.provenance["program_version"] = program_version();
  if (const Status status = finger.validate(); !status) return status.error();
  if (const Status status = make_folder(requested.finger); !status) return status.error();
  if (const Status status = finger.save(requested.finger); !status) return status.error();
  return finger;
}

}  // namespace alltact
