#include "app/console/finger_work.h"

#include "calibration/finger/calibrate_finger.h"
#include "calibration/lens/lens_views.h"
#include "core/camera/camera.h"
#include "core/io/atomic_file.h"
#include "core/sources/open/open_source.h"

#include <fmt/format.h>

namespace alltact {

namespace fs = std::filesystem;

Result<Finger> make_finger(const NewFinger& wanted) {
  std::error_code ignored;
  const fs::path file = wanted.finger / Finger::kFileName;
  if (fs::exists(file, ignored)) {
    return Error{"there is a finger already, and it is never overwritten",
                 file.string(),
                 "another folder, or moving that one away"};
  }
  LensRecord lens_record;
  auto camera = load_camera(wanted.camera, &lens_record);
  if (!camera) return camera.error();
  if (const auto valid = Camera::create(*camera); !valid) return valid.error();

  Finger finger;
  finger.name = wanted.name;
  if (finger.name.empty())
    finger.name = fs::absolute(wanted.finger / "").parent_path().filename().string();
  finger.camera = std::move(camera).value();
  finger.lens_record = std::move(lens_record);
  finger.face.kind = wanted.kind;
  finger.face.width_mm = wanted.width_mm;
  finger.face.layer_mm = wanted.layer_mm;
  finger.face.plane_z_mm = wanted.plane_z_mm;
  finger.markers.per_row = wanted.per_row;
  finger.markers.polarity = wanted.polarity;
  finger.gripper_from_camera = wanted.gripper_from_camera;
  finger.provenance["program_version"] = ALLTACT_VERSION;
  if (const Status status = finger.validate(); !status) return status.error();
  if (const Status status = make_folder(wanted.finger); !status) return status.error();
  if (const Status status = finger.save(wanted.finger); !status) return status.error();
  return finger;
}

Result<ReferenceReport> install_recording(const fs::path& folder,
                                          Finger& finger,
                                          const std::vector<fs::path>& inputs,
                                          const Job& job,
                                          const ReferenceChoices& choices) {
  auto source = open_source(inputs);
  if (!source) return source.error();
  auto report = install_reference(**source, folder, finger, job, choices);
  if (!report) return report.error();
  finger.provenance["reference_date"] = utc_now();
  if (const Status status = finger.save(folder); !status) return status.error();
  return report;
}

Result<LensCalibration> measure_lens(const std::vector<fs::path>& inputs,
                                     const Board& board,
                                     const LensSettings& settings,
                                     const Job& job) {
  SourceOptions how;
  how.job = &job;
  const auto source = open_source(inputs, how);
  if (!source) return source.error();
  const auto found = find_boards(**source, board, Orientation::kNone, job);
  if (!found) return found.error();
  return calibrate_lens(found->views, found->size, settings, job);
}

LensRecord lens_record(const Board& board, const LensCalibration& done) {
  LensRecord record;
  record["date"] = utc_now();
  record["program_version"] = ALLTACT_VERSION;
  record["board"] = board.words();
  record["square_mm"] = fmt::format("{}", board.square_mm);
  record["views"] = fmt::format("{}", done.used.size());
  record["fx_sd_px"] = fmt::format("{:.4f}", done.fit.sd(0));
  record["fy_sd_px"] = fmt::format("{:.4f}", done.fit.sd(1));
  record["focal_sd_percent"] = fmt::format("{:.4f}", 100 * done.focal_sd_part);
  record["corner_px"] = fmt::format("{:.4f}", done.fit.sigma_px);
  if (done.held_out) record["held_out_px"] = fmt::format("{:.4f}", done.held_out->error_px);
  record["verdict"] = done.verdict.sentence;
  return record;
}

fs::path find_command_line() {
  std::error_code failed;
  const fs::path folder = fs::read_symlink("/proc/self/exe", failed).parent_path();
  for (const fs::path& program : {folder / "alltact", folder.parent_path() / "alltact"})
    if (fs::is_regular_file(program, failed)) return program;
  return {};
}

Result<fs::path> find_resource(const fs::path& name) {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  const fs::path installed = program.parent_path() / ".." / "share" / "alltact";
  for (const fs::path& resources : {installed, fs::path(ALLTACT_RESOURCES)}) {
    const fs::path file = resources / name;
    if (fs::exists(file, failed)) return file;
  }
  return Error{"this file that comes with the program is not there",
               name.string(),
               "installing the program again"};
}

}  // namespace alltact
