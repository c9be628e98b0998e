#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"

#include <fmt/format.h>

namespace alltact {

Result<FingerPtr> open_finger(const Path& folder, Console& console) {
  auto finger = open_finger(folder);
  if (finger)
    for (const Message& warning : (*finger)->warnings)
      console.warn(fmt::format("Warning: {}", warning));
  return finger;
}

Status run_new(const NewFinger& options, Console& console) {
  CameraFile camera;
  const auto finger = make_finger(options, &camera);
  if (!finger) return finger.error();
  const Path file = options.finger / Finger::kFileName;
  console.say(fmt::format("Camera {}", camera.understood));
  for (const Message& warning : camera.warnings) console.warn(fmt::format("Warning: {}", warning));
  console.say(
      fmt::format("{} made. Next: {}", file.string(),
                  options.kind == FaceKind::kFlat
                      ? "alltact calibrate with ball presses and --reference"
                      : "alltact reference with a recording of the bending, untouched finger"));
  console.answer()["finger"] = file.string();
  console.answer()["name"] = finger->name;
  console.answer()["camera"] = camera.understood.english();
  console.answer()["warnings"] = in_english(camera.warnings);
  return {};
}

void add_new(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<NewFinger>();
  CLI::App* command = add_command(program, "new");
  command->add_option("FINGER", options->finger, "New folder")->required();
  command
      ->add_option("--camera", options->camera,
                   "File with the camera: of 'alltact lens' or 'alltact export', ROS, OpenCV, "
                   "Kalibr, mrcal, PhotonVision or Matlab; FILE#NAME: one camera of several")
      ->type_name("CAMERA.yaml")
      ->required();
  command->add_option("--layer-mm", options->layer_mm, "Thickness of the translucent layer, mm")
      ->type_name("T")
      ->transform(typed_number(kLayerThickness))
      ->required();
  const std::map<std::string, FaceKind> kinds{{"fin_ray", FaceKind::kFinRay},
                                              {"flat", FaceKind::kFlat}};
  command
      ->add_option("--kind", options->kind,
                   "Kind of finger: fin_ray, its shape estimated from the two edges of the face; "
                   "flat, a rigid sensor (default fin_ray)")
      ->type_name("fin_ray|flat")
      ->transform(CLI::Transformer(kinds));
  CLI::Option* width = command
                           ->add_option("--width-mm", options->width_mm,
                                        "Distance between the two edges of the view face, mm")
                           ->type_name("W")
                           ->transform(typed_number(kFaceWidth));
  CLI::Option* per_row = command
                             ->add_option("--per-row", options->per_row,
                                          "Number of engraved dots on each side face; 0: none, "
                                          "poses are estimated from the shape of the face")
                             ->type_name("N")
                             ->transform(typed_integer(0, 64));
  const std::map<std::string, Polarity> polarities{
      {"auto", Polarity::kAuto}, {"bright", Polarity::kBright}, {"dark", Polarity::kDark}};
  command
      ->add_option("--polarity", options->polarity,
                   "Brightness of the dots against their surroundings; auto: from the reference "
                   "recording (default auto)")
      ->type_name("auto|bright|dark")
      ->transform(CLI::Transformer(polarities));
  CLI::Option* plane =
      command
          ->add_option("--plane-z-mm", options->plane_z_mm,
                       "Distance of the view face of a flat sensor, mm (default 0)")
          ->type_name("Z")
          ->transform(typed_number(-kPlaneDistance.possible.high, kPlaneDistance.possible.high));
  command->add_option("--name", options->name, "Name of the finger (default: the folder's)")
      ->type_name("NAME");
  auto gripper = std::make_shared<std::vector<double>>();
  CLI::Option* in_gripper =
      command
          ->add_option("--gripper-from-camera", *gripper,
                       "Pose of the camera in the gripper: position in mm, and rotations about the "
                       "gripper's axes x, then y, then z, in degrees")
          ->type_name("X Y Z RX RY RZ")
          ->transform(typed_number(-1e4, 1e4))
          ->expected(6);
  command->callback([=, &chosen] {
    if (!in_gripper->empty()) {
      const std::vector<double>& g = *gripper;
      options->gripper_from_camera = RigidTransform{rotation_from_rpy_deg({g[3], g[4], g[5]}),
                                                    Eigen::Vector3d(g[0], g[1], g[2])};
    }
    if (options->kind == FaceKind::kFinRay) {
      if (width->empty()) throw CLI::RequiredError("--width-mm");
      if (per_row->empty()) throw CLI::RequiredError("--per-row");
      if (!plane->empty()) throw CLI::ValidationError("--plane-z-mm", "is for --kind flat only");
    } else if (!per_row->empty()) {
      throw CLI::ValidationError("--per-row", "a flat sensor has no markers");
    }
    chosen = [=](Console& console) { return run_new(*options, console); };
  });
}

}  // namespace alltact
