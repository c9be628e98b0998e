#include "app/commands/commands.h"
#include "app/flags.h"
#include "calibration/calibrate_finger.h"

#include <fmt/format.h>

namespace alltact {
namespace {

void tell(const FingerCalibration& done, Console& console) {
  const Calibration& calibration = done.calibration;
  console.say(
      fmt::format("{:<24} {:>9} {:>12} {:>13}", "press", "depth mm", "residual mm", "left-out mm"));
  for (const BallFit& ball : calibration.balls) {
    console.say(fmt::format("{:<24} {:>9.3f} {:>12.4f} {:>13}",
                            ball.press,
                            ball.depth_mm,
                            ball.residual_mm,
                            ball.held_out_mm > 0 ? fmt::format("{:.4f}", ball.held_out_mm) : "-"));
  }
  for (const std::string& reason : calibration.left_out) console.warn("Left out: " + reason);
  for (const std::string& remark : calibration.remarks) console.say("Remark: " + remark);
  console.say("Mapping: " + calibration.degree_choice);
  console.say("Verdict: " + done.verdict.sentence + ".");
}

}  // namespace

Status run_calibrate(const CalibrateOptions& options, Console& console) {
  FingerCalibrationInput input;
  input.folder = options.finger;
  input.presses = options.presses;
  input.ball_radius_mm = options.ball_radius_mm;
  input.reference = options.reference;
  input.calibration = options.calibration;
  input.pipeline = options.pipeline;
  input.program_version = ALLTACT_VERSION;
  const auto done = calibrate_finger(input, console.job());
  if (!done) return done.error();
  for (const std::string& warning : done->warnings) console.warn("Warning: " + warning);
  tell(*done, console);
  Console::Json& answer = console.answer();
  answer["verdict"] = done->verdict.sentence;
  answer["residual_mm"] = done->calibration.residual_mm;
  if (done->calibration.held_out_mm > 0) answer["held_out_mm"] = done->calibration.held_out_mm;
  answer["presses"] = done->calibration.balls.size();
  answer["left_out"] = done->calibration.left_out;
  answer["remarks"] = done->calibration.remarks;
  answer["warnings"] = done->warnings;
  answer["report"] = (options.finger / "calibration_report.json").string();
  return {};
}

void add_calibrate(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App* command =
      program.add_subcommand("calibrate", "Learns depth from presses of a ball of known radius");
  command->add_option("FINGER", options->finger, "The finger's folder")->required();
  command
      ->add_option(
          "PRESS", options->presses, "Pictures of the pressed ball, a folder of them, or a video")
      ->required();
  command->add_option("--ball-radius-mm", options->ball_radius_mm, "Radius of the ball, mm")
      ->type_name("R")
      ->check(CLI::PositiveNumber)
      ->required();
  command
      ->add_option("--reference",
                   options->reference,
                   "Flat sensors: the untouched picture, kept with the finger")
      ->type_name("IMAGE");
  command->add_option("--operator", options->operator_name, "Who calibrates, for the record")
      ->type_name("NAME");
  SettingFlags<CalibrationSettings> calibration;
  calibration.add_to(*command, calibration_settings());
  SettingFlags<PipelineSettings> pipeline;
  pipeline.add_to(*command, pipeline_settings(), {"contact-threshold-mm"});
  command->callback([=, &chosen] {
    options->calibration = calibration.applied_to({});
    const bool paper = options->calibration.method == CalibrationMethod::kPaper;
    options->pipeline = pipeline.applied_to(paper ? paper_settings() : PipelineSettings{});
    chosen = [=](Console& console) { return run_calibrate(*options, console); };
  });
}

}  // namespace alltact
