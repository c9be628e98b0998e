// A program that changes one thing on a disk, for tests that give it a disk with faults:
//   disk_child picture FINGER PICTURE      installs a flat sensor's untouched picture
//   disk_child calibrate FINGER PRESS...   calibrates a flat sensor's finger
//   disk_child reference FINGER VIDEO      installs a recording
//   disk_child notes FINGER RADIUS         keeps what is said of the presses
//   disk_child check FINGER                adds a check to its history
//   disk_child rename FINGER NAME          changes finger.yaml
//   disk_child record FILE FRAMES          records them in 2.5 s
// Exit status 0, or 1 with a sentence.
#include "calibration/checks/check_history.h"
#include "calibration/finger/calibrate_finger.h"
#include "calibration/reference/reference_recording.h"
#include "core/recording/recorder.h"
#include "tests/core/recording/recording_frames.h"

#include <cstdio>
#include <thread>

namespace {

using namespace alltact;
using Arguments = std::vector<std::string>;

Status calibrate(const Arguments& arguments) {
  FingerCalibrationInput input;
  input.folder = arguments[0];
  input.presses.files.assign(arguments.begin() + 1, arguments.end());
  input.press_set.ball_radius_mm = 4;
  input.date = "2026-02-01T12:00:00Z";
  input.program_version = "0.1.0";
  const auto done = calibrate_finger(input, Job());
  return done ? Status() : done.error();
}

Status record(const std::string& file, std::uint32_t frames) {
  RecorderSettings settings;
  settings.reserve_mb = 0;
  auto recorder = Recorder::start(file, settings, 30, "test camera");
  if (!recorder) return recorder.error();
  for (std::uint32_t i = 0; i < frames; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2500 / frames));
    if (!(*recorder)->add_waiting(test::camera_frame(i, false))) break;
  }
  return (*recorder)->finish("done");
}

Status run(const std::string& what, const Arguments& arguments) {
  const std::filesystem::path place = arguments[0];
  if (what == "calibrate") return calibrate(arguments);
  if (what == "record") return record(arguments[0], static_cast<unsigned>(std::stoi(arguments[1])));
  if (what == "picture") {
    const auto image = read_untouched_image(arguments[1]);
    if (!image) return image.error();
    const auto given = set_untouched_image(place, *image);
    return given ? Status() : given.error();
  }
  if (what == "reference") {
    const auto given = set_reference(place, {arguments[1]}, Job());
    return given ? Status() : given.error();
  }
  if (what == "notes") {
    PressSet notes;
    notes.ball_radius_mm = std::stod(arguments[1]);
    return FingerStore::of(place)->save_presses(notes);
  }
  if (what == "rename") {
    const auto changed = FingerStore::of(place)->update(
        [&](Finger& finger) { return finger.name = arguments[1], Status(); });
    return changed ? Status() : changed.error();
  }
  CheckEntry entry;
  entry.time = "2026-01-31T12:00:00Z";
  entry.error_mm = 0.02, entry.drifting_above_mm = 0.025, entry.recalibrate_above_mm = 0.05;
  entry.presses = 3, entry.ball_radius_mm = 4;
  return append_check(place, entry);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const Status status = run(argv[1], Arguments(argv + 2, argv + argc));
  if (!status) std::fprintf(stderr, "%s\n", status.error().sentence().c_str());
  return status ? 0 : 1;
}
