// Readers of what is written in YAML or JSON.
#include "calibration/finger/calibration_file.h"
#include "calibration/finger/calibration_inputs.h"
#include "calibration/finger/measuring_presets.h"
#include "calibration/force/collect_force.h"
#include "calibration/study/study_file.h"
#include "core/base/atomic_file.h"
#include "core/batch/batch.h"
#include "core/finger/finger_store.h"
#include "core/finger/force_model.h"
#include "core/gripper/gripper.h"
#include "core/gripper/gripper_recording.h"
#include "core/inspection/inspection_recipe.h"
#include "core/sensing/force/force_meter.h"
#include "core/sensing/markers/dot_network.h"
#include "core/sensing/result_json.h"
#include "core/simulation/scene.h"
#include "tests/core/finger/finger_files.h"
#include "tests/core/gripper/gripper_files.h"
#include "tests/fuzz/readers.h"
#include "tests/support/flat_sensor.h"
#include "tests/support/foreign_cameras.h"
#include "tests/support/two_marker_force.h"
#include "tests/support/written_region.h"

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

std::string source_text(const std::string& path) {
  return *read_file(fs::path(ALLTACT_SOURCE_DIR) / path);
}

/// Written, read and written again it is the same; the names of its files stay in its folder.
std::string law_of_finger(const Finger& finger) {
  const auto written = finger.to_yaml();
  if (!written) return "read, but not to be written: " + written.error().sentence();
  for (const std::string& file :
       {finger.force_model, finger.reference ? finger.reference->video : std::string(),
        finger.reference ? finger.reference->markers : std::string(),
        finger.reference ? finger.reference->image : std::string()}) {
    const fs::path inside = fs::path(file).lexically_normal();
    if (inside.is_absolute() || (!inside.empty() && *inside.begin() == ".."))
      return "a file outside the folder: " + file;
  }
  (void)FingerSnapshot::of("finger", finger).ok();  // a camera that folds is refused here
  return same_again<Finger>(*written, Finger::parse(*written, "finger.yaml"), [](const Finger& f) {
    const auto text = f.to_yaml();
    return text ? *text : text.error().sentence();
  });
}

/// As a file of this program it is the same camera, and every number of it is finite.
Reading read_camera(const std::string& bytes) {
  static const ScratchFile again("again.yaml");
  const auto camera = parse_camera(bytes, "camera.yaml");
  if (!camera) return {camera.error()};
  if (const Status saved = save_camera(again.path(), camera->parameters); !saved)
    return {std::nullopt, "read, but not to be written: " + saved.error().sentence()};
  const auto back = load_camera(again.path());
  if (!back || !(back->parameters == camera->parameters))
    return {std::nullopt, "another camera comes back"};
  if (camera->understood.empty()) return {std::nullopt, "a camera without a line about it"};
  return {};
}

/// A file of each format of other programs.
std::vector<std::string> foreign_camera_seeds() {
  std::vector<std::string> seeds;
  for (const ForeignFile& file : foreign_files(some_foreign_camera())) seeds.push_back(file.text);
  return seeds;
}

Reading read_recipe(const std::string& bytes) {
  return reading_of(InspectionRecipe::parse(bytes, "recipe.yaml"), [](const auto& recipe) {
    const std::string written = recipe.to_yaml();
    return same_again<InspectionRecipe>(written, InspectionRecipe::parse(written, "recipe.yaml"),
                                        [](const InspectionRecipe& r) { return r.to_yaml(); });
  });
}

std::vector<std::string> recipe_seeds() {
  InspectionRecipe recipe;
  recipe.name = "a \"seal\"";
  recipe.readings = {{"depth", Measurand::kStep, {30, -2.5}, {36, 2.5}, 0.45, 0.55, {}},
                     {"1e3", Measurand::kAngle, {0, 0}, {1, 1}, {}, -2.0, {}},
                     {"cut", Measurand::kSectionArea, {0, 0}, {1, 1}, {}, {}, {}},
                     {"grain", Measurand::kRoughness, {0, 0}, {9, 9}, {}, 0.02, {3, 0.8}}};
  return {recipe.to_yaml()};
}

CalibrationInputs some_inputs() {
  CalibrationInputs inputs;
  inputs.date = "2026-01-31T12:00:00Z";
  inputs.program_version = "0.1.0";
  inputs.press_set.operator_name = "Ada";
  inputs.press_set.ball_radius_mm = 3.975;
  inputs.finger_checksum = inputs.reference_checksum = "0123456789abcdef";
  inputs.presses = {{"press_0", "0000000000000001"}, {"12", "1111111111111111"}};
  inputs.press_set.notes["press_0"].ball_radius_mm = 6.25;
  inputs.press_set.notes["press_0"].depth = GivenDepth{0.5, 0.02};
  inputs.press_set.notes["press_0"].ball_mm = {1.5, -2.25, 48.0625};
  inputs.press_set.notes["12"].step_mm = 0.5;
  inputs.press_set.notes["12"].body = "bodies/rod.stl";
  inputs.press_set.notes["12"].excluded = "glove in view";
  return inputs;
}

Reading read_inputs(const std::string& bytes) {
  return reading_of(CalibrationInputs::parse(bytes, "in.yaml"), [](const CalibrationInputs& in) {
    const std::string written = in.to_yaml();
    return same_again<CalibrationInputs>(written, CalibrationInputs::parse(written, "in.yaml"),
                                         [](const CalibrationInputs& i) { return i.to_yaml(); });
  });
}

FingerCalibration some_calibration() {
  FingerCalibration done;
  Calibration& calibration = done.calibration;
  calibration.residual_mm = 0.004;
  calibration.condition = 180.5;
  calibration.degree_choice = en::say("solving");
  calibration.left_out = {en::at(Message::typed("12"), en::say("no face was found"))};
  calibration.remarks = {en::say("no press is named '{}'", std::string("a\"b"))};
  calibration.next_press = PressAdvice{false, 8.5, -1.25, 0.5, 0.01, 0.008, en::say("done")};
  calibration.steps = {{"step", 0.5, 0.49, 0.01}};
  calibration.bodies = {{"rod", "rod.stl", 1.01, 0.008}};
  BallFit ball;
  ball.press = "press_0";
  ball.radius_mm = 3.975;
  ball.centre_mm = {1.5, -2.25, 48.0625};
  ball.centre_sd_mm = {0.01, 0.01, 0.02};
  ball.depth_mm = 0.75;
  ball.given_depth = GivenDepth{0.5, 0.02};
  calibration.balls = {ball, ball};
  calibration.balls[1].press = "12";
  done.residuals = {{"press_0", 8.5, 0.25, 1.5, 40, 24, {}}};
  done.residuals[0].samples = {{{120.5, 64.5}, 0.125, 0.25, -0.001, 8.5, 0.25, 0.5, 1}};
  done.residuals[0].samples.push_back(done.residuals[0].samples.front());
  done.fault_signs = {en::say("done")};
  return done;
}

Reading read_calibration(const std::string& bytes) {
  return reading_of(parse_calibration(bytes, "calibration.yaml"),
                    [](const FingerCalibration& done) {
                      const std::string written = calibration_yaml(done);
                      return same_again<FingerCalibration>(
                          written, parse_calibration(written, "calibration.yaml"),
                          [](const FingerCalibration& again) { return calibration_yaml(again); });
                    });
}

Reading read_notes(const std::string& bytes) {
  return reading_of(PressSet::parse(bytes, "notes.yaml"), [](const PressSet& notes) {
    const std::string written = notes.to_yaml();
    return same_again<PressSet>(written, PressSet::parse(written, "notes.yaml"),
                                [](const PressSet& n) { return n.to_yaml(); });
  });
}

/// measuring.yaml of a finger that says nothing else of its settings.
Reading read_measuring(const std::string& bytes) {
  static const ScratchFile file(kMeasuringFile);
  return reading_of(presets_of_finger(file.write(bytes).parent_path()),
                    [&](const MeasuringPresets&) { return file.stray(); });
}

std::vector<std::string> measuring_seeds() {
  return {
      "format: alltact-measuring/1\nused: fast\nused_settings: {reference-neighbours: 4}\n"
      "study: {date: \"2026-01-31T12:00:00Z\", program_version: 0.1.0, machine: \"a: b\", about: "
      "balls}\nbase: {edge-method: crossing, smoothing-px: 1.25}\npresets:\n  fast: {frame_ms: "
      "1.1, "
      "median_mm: 0.012, p95_mm: 0.05, settings: {reference-neighbours: 4}}\n"};
}

Reading read_gripper(const std::string& bytes) {
  return reading_of(Gripper::parse(bytes, "gripper.yaml"), [](const Gripper& gripper) {
    const auto written = gripper.to_yaml();
    if (!written) return "read, but not to be written: " + written.error().sentence();
    return same_again<Gripper>(*written, Gripper::parse(*written, "gripper.yaml"),
                               [](const Gripper& g) {
                                 const auto text = g.to_yaml();
                                 return text ? *text : text.error().sentence();
                               });
  });
}

Reading read_network_check(const std::string& bytes) {
  static const ScratchFile file("network.yaml");
  return reading_of(NetworkCheck::load(file.write(bytes)), kNoLaw);
}

/// A model never tells a force that is no number.
Reading read_force_model(const std::string& bytes) {
  return reading_of(ForceModel::parse(bytes, "force.json"), [](const ForceModel& model) {
    Markers markers;
    for (const auto& rest : model.rest_px) markers.push_back({rest.x() + 3, rest.y() - 2, true, 1});
    const auto force = model(force_input(model, markers, Eigen::Vector2d(40, 1)));
    if (force && !(force->force_N.allFinite() && force->half_95_N.allFinite()))
      return std::string("a force that is no number");
    const std::string written = model.to_json();
    return same_again<ForceModel>(written, ForceModel::parse(written, "force.json"),
                                  [](const ForceModel& m) { return m.to_json(); });
  });
}

std::vector<std::string> result_seeds() {
  FrameResult result;
  auto frame = std::make_shared<Frame>();
  frame->name = "frame_00003";
  frame->time_ns = 123456789012345678;
  result.frame = frame;
  result.depth.emplace();
  result.regions = {written_region()};
  return {result_line(result, 3, ReferenceMethod::kLocal) + "\n",
          failure_line("frame_00004", 4, {en::say("the picture is black")}) + "\n"};
}

Reading read_results(const std::string& bytes) {
  return reading_of(parse_recorded_contacts(bytes, "results.jsonl"), [](const auto& frames) {
    for (const RecordedContacts& one : frames)
      if (one.contact && !one.contact->position_mm.allFinite()) return std::string("no place");
    return std::string();
  });
}

Reading read_frame_line(const std::string& bytes) {
  return reading_of(FrameLine::from_json(bytes), [](const FrameLine& line) {
    const std::string written = line.to_json();
    return same_again<FrameLine>(written, FrameLine::from_json(written),
                                 [](const FrameLine& l) { return l.to_json(); });
  });
}

std::vector<std::string> frame_line_seeds() {
  FrameLine line;
  line.frame = "frame_00003";
  line.line = result_seeds().front();
  line.is_measured = true;
  line.total_ms = 2.5;
  ContactEvidence& evidence = line.evidence.emplace();
  const std::string without = line.to_json();
  evidence.time_s = 12.5, evidence.depth = 2.5, evidence.push = 1.5,
  evidence.is_face_pressed = true;
  auto& indentation = evidence.indentation.emplace();
  indentation.position = {52.3, -1.5, 0.4, 0.05, 0.06, 0.01, kLayerLimit};
  indentation.direction = Eigen::Vector3d::UnitZ();
  indentation.on_skin_mm = {12, -1.5};
  evidence.deflection = {PushedFace::kBack, -Eigen::Vector3d::UnitZ(), 0.5, PositionOnFinger()};
  return {without, line.to_json()};
}

Reading read_study(const std::string& bytes) {
  return reading_of(rows_of_lines(bytes, "study_rows.jsonl"), [](const auto& rows) {
    std::string written;
    for (const StudyRow& row : rows) written += line_of(row);
    return same_again<std::vector<StudyRow>>(written, rows_of_lines(written, "study_rows.jsonl"),
                                             [](const auto& again) {
                                               std::string text;
                                               for (const StudyRow& row : again)
                                                 text += line_of(row);
                                               return text;
                                             });
  });
}

std::vector<std::string> study_seeds() {
  StudyRow row;
  row.frames = 9;
  row.depth = ErrorSpread{0.012, 0.05};
  row.coverage = 0.98, row.position_mm = 0.02, row.angle_deg = 1.5;
  row.time_ms = 2.5, row.time_p95_ms = 3;
  StudyRow real = row;
  real.real = RealErrors{5, 1, {0.004, 0.02}, {ErrorSpread{0.003, 0.01}}};
  return {line_of(row) + line_of(real)};
}

}  // namespace

std::vector<Reader> yaml_readers() {
  const auto texts = [](std::vector<std::string> seeds) { return [seeds] { return seeds; }; };
  const auto sources = [](std::vector<std::string> paths) {
    return [paths] {
      std::vector<std::string> seeds;
      for (const std::string& path : paths) seeds.push_back(source_text(path));
      return seeds;
    };
  };
  return {
      {"inspection_recipe", recipe_seeds, read_recipe},
      {"finger", texts({kFinRay, kFlat}),
       [](const std::string& bytes) {
         return reading_of(Finger::parse(bytes, "finger.yaml"), law_of_finger);
       }},
      {"camera",
       texts({"model: brown\nsize: [960, 540]\nfx: 523.9\nfy: 524.5\ncx: 479.5\ncy: 269.5\n"
              "distortion: [-0.05, 0.01, 0.0001, -0.0002, 0.001]\norientation: flip_v\n"
              "port: {gap_mm: 3, plate_mm: 2, plate_index: 1.52, medium_index: 1.41}\n",
              "camera:\n  model: orthographic\n  size: [460, 345]\n  mm_per_px: 0.051\n  cx: "
              "229.5\n  cy: 172.0\n"}),
       read_camera},
      {"foreign_camera", foreign_camera_seeds, read_camera},
      {"scene",
       sources({"resources/scenes/demo_presses.yaml", "resources/scenes/five_effects.yaml",
                "resources/scenes/pushed_finger.yaml", "resources/scenes/hard_two_contacts.yaml",
                "resources/scenes/flat_press.yaml"}),
       [](const std::string& bytes) {
         return reading_of(Scene::parse(bytes, "scene.yaml"), kNoLaw);
       }},
      {"calibration_inputs", [] { return std::vector{some_inputs().to_yaml()}; }, read_inputs},
      {"calibration", [] { return std::vector{calibration_yaml(some_calibration())}; },
       read_calibration},
      {"press_notes", [] { return std::vector{some_inputs().press_set.to_yaml()}; }, read_notes},
      {"measuring", measuring_seeds, read_measuring},
      {"gripper", texts({kGripper}), read_gripper},
      {"network_check",
       texts({"picture: [64, 48]\nevery: 13\ntolerance: 0.001\noutput: [0.5, -1.25, 3e-4]\n"}),
       read_network_check},
      {"force_model", [] { return std::vector{two_marker_force().to_json()}; }, read_force_model},
      {"results", result_seeds, read_results},
      {"frame_line", frame_line_seeds, read_frame_line},
      {"study_rows", study_seeds, read_study},
      {"simulated_forces",
       texts({R"({"frames": [{"frame": "frame_00000"}, {"frame": "frame_00001", "contacts": [
            {"name": "push", "force_N": [1.0, 0.5, 0.25], "along_mm": 40, "across_mm": 1}]}]})"}),
       [](const std::string& bytes) {
         return reading_of(ForceGauge::parse_truth(bytes, "truth.json"), kNoLaw);
       }},
  };
}

}  // namespace alltact::test
