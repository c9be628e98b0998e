#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "app/figures/figures.h"
#include "calibration/finger/calibrate_finger.h"
#include "calibration/finger/calibration_report.h"
#include "calibration/report/press_resolution.h"
#include "core/base/program.h"
#include "core/base/utc_time.h"
#include "core/numerics/readable_numbers.h"

#include <fmt/format.h>

namespace alltact {
namespace {

void print_methods(const std::vector<MethodRow>& methods, Console& console) {
  console.say(fmt::format("{:<25} {:>7} {:>13} {:>12} {:>9} {:>9}", "all methods, same presses",
                          "presses", "mean depth mm", "residual mm", "method mm", "joint mm"));
  for (const MethodRow& row : methods)
    console.say(row.failed.empty()
                    ? fmt::format("{:<25} {:>7} {:>13.3f} {:>12.4f} {:>9.3f} {:>9.3f}",
                                  method_name(row.method), row.presses, row.press_depth_mm,
                                  row.residual_mm, row.at_depth_mm, row.joint_depth_mm)
                    : fmt::format("{:<25} {}", method_name(row.method), row.failed));
}

void print_result(const FingerCalibration& done, Console& console) {
  const Calibration& calibration = done.calibration;
  console.say(
      fmt::format("{:<24} {:>9} {:>12} {:>13}", "press", "depth mm", "residual mm", "held-out mm"));
  for (const BallFit& ball : calibration.balls) {
    console.say(fmt::format("{:<24} {:>9.3f} {:>12.4f} {:>13}", ball.press, ball.depth_mm,
                            ball.residual_mm,
                            ball.held_out_mm > 0 ? fmt::format("{:.4f}", ball.held_out_mm) : "-"));
  }
  const auto by_chance =
      std::count_if(calibration.balls.begin(), calibration.balls.end(), [](const BallFit& ball) {
        return ball.held_out_mm > 0 && ball.held_out_mm < ball.residual_mm;
      });
  if (by_chance > 0)
    console.say(
        fmt::format("Remark: {} of {} presses happen to fit better when left out than when used.",
                    by_chance, calibration.balls.size()));
  for (const Message& remark : done.source_remarks) console.say(remark.english());
  for (const BallFit& ball : calibration.balls)
    if (ball.given_depth)
      console.say(fmt::format("{}: measured indentation {} mm, fitted {:.3f} mm", ball.press,
                              value_and_sd(ball.given_depth->mm, ball.given_depth->sd_mm, 3),
                              ball.indentation_mm));
  for (const StepFit& step : calibration.steps)
    console.say(fmt::format("{}: step of {:.3f} mm, estimated as {} mm", step.press, step.step_mm,
                            value_and_sd(step.estimated_mm, step.sd_mm, 3)));
  for (const BodyFit& body : calibration.bodies)
    console.say(fmt::format("{}: depths on {} read {} % of the true ones", body.press, body.body,
                            value_and_sd(100 * body.scale, 100 * body.sd, 1)));
  for (const Message& reason : calibration.left_out)
    console.warn(fmt::format("Left out: {}", reason));
  if (!done.problem_image.empty())
    console.warn("Image of the detections: " + done.problem_image.string());
  for (const Message& remark : calibration.remarks) console.say(fmt::format("Remark: {}", remark));
  for (const Message& sign : done.fault_signs) console.warn(fmt::format("Warning: {}.", sign));
  console.say(fmt::format("Mapping: {}", calibration.degree_choice));
  console.say(fmt::format("Verdict: {}.", done.verdict.sentence));
  console.say(fmt::format("By zone of the face: {}.", zone_sentence(done.zones)));
  if (const Message resolution = resolution_sentence(done.residuals, done.halo);
      !resolution.empty())
    console.say(fmt::format("Resolution: {}.", resolution));
  if (!done.methods.empty()) print_methods(done.methods, console);
}

/// The inputs of a repetition, changed by the command line's options.
Result<CalibrationInputs> inputs_again(const CalibrateOptions& options, Console& console) {
  std::vector<Message> warnings;
  auto stored = CalibrationInputs::load(options.finger, &warnings);
  if (!stored) return stored.error();
  for (const Message& warning : warnings) console.warn(fmt::format("Warning: {}", warning));
  CalibrationInputs inputs = std::move(stored).value();
  if (options.change) options.change(inputs.calibration, inputs.pipeline);
  PressSet& press_set = inputs.press_set;
  if (options.ball_radius_mm > 0) press_set.ball_radius_mm = options.ball_radius_mm;
  if (!options.operator_name.empty()) press_set.operator_name = options.operator_name;
  for (const std::string& name : options.included) {
    PressNote note = press_set.of(name);
    if (!note.excluded)
      return Error{en::say("'{}' is not excluded", name), options.finger.string(), ""};
    note.excluded.reset();
    press_set.say(name, std::move(note));
  }
  if (options.annotate_presses) options.annotate_presses(press_set);
  return inputs;
}

/// A finger is calibrated even if the library that draws is missing.
MakeReport report_maker(const CalibrateOptions& options, Console& console) {
  const auto drawing = load_figures();
  if (!drawing) {
    console.warn(fmt::format("The report pages cannot be written: {}", drawing.error().sentence()));
    return {};
  }
  return
      [drawn = *drawing, folder = options.finger](const FingerCalibration& done, const Job& job) {
        return drawn->calibration_pages(done, folder, job);
      };
}

Result<FingerCalibration> calibrate_as_asked(const CalibrateOptions& options, Console& console) {
  if (options.again) {
    const auto inputs = inputs_again(options, console);
    if (!inputs) return inputs.error();
    return calibrate_finger_again(options.finger, *inputs, program_version(),
                                  report_maker(options, console), options.compare_methods,
                                  console.job());
  }
  FingerCalibrationInput input;
  input.folder = options.finger;
  input.presses = options.presses;
  input.press_set.ball_radius_mm = options.ball_radius_mm;
  input.press_set.operator_name = options.operator_name;
  input.reference = options.reference;
  input.calibration = options.calibration;
  input.pipeline = options.pipeline;
  if (options.annotate_presses) options.annotate_presses(input.press_set);
  input.date = options.date;
  input.program_version = program_version();
  input.make_report = report_maker(options, console);
  input.compare_methods = options.compare_methods;
  return calibrate_finger(input, console.job());
}

}  // namespace

Status run_calibrate(const CalibrateOptions& options, Console& console) {
  const auto done = calibrate_as_asked(options, console);
  if (!done) return done.error();
  std::vector<Message> warnings = done->warnings;
  warnings.insert(warnings.end(), done->about_settings.begin(), done->about_settings.end());
  for (const Message& warning : warnings) console.warn(fmt::format("Warning: {}", warning));
  print_result(*done, console);
  console.say("Report: " + (options.finger / kReportHtml).string() + ", .pdf");
  console.say("To repeat it from the stored data: " + repeat_command(options.finger));
  Console::Json& answer = console.answer();
  answer["verdict"] = done->verdict.sentence.english();
  answer["grade"] = to_string(done->verdict.grade);
  answer["evidence"] = verdict_json(done->verdict);
  answer["residual_mm"] = done->calibration.residual_mm;
  if (done->calibration.held_out_mm > 0) answer["held_out_mm"] = done->calibration.held_out_mm;
  answer["expected_error_mm"] = done->verdict.error_mm;
  answer["resolution"] = resolution_json(*done);
  answer["presses"] = done->calibration.balls.size();
  answer["left_out"] = in_english(done->calibration.left_out);
  if (!done->problem_image.empty()) answer["problem_picture"] = done->problem_image.string();
  answer["remarks"] = in_english(done->calibration.remarks);
  answer["warnings"] = in_english(warnings);
  answer["report"] = (options.finger / kReportJson).string();
  return {};
}

void add_calibrate(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App* command = add_command(program, "calibrate");
  command->add_option("FINGER", options->finger, "The finger's folder")->required();
  CLI::Option* presses = command->add_option(
      "PRESS", options->presses.files, "Images of the pressed ball, a folder of them, or a video");
  CLI::Option* bursts =
      command->add_flag("--bursts", options->presses.bursts,
                        "Averages the frames of each PRESS, a short video or a folder of one press "
                        "held still, to one image with its name");
  CLI::Option* radius =
      command->add_option("--ball-radius-mm", options->ball_radius_mm, "Radius of the ball, mm")
          ->type_name("R")
          ->transform(typed_number(kBallRadius));
  PressFlags press_set;
  press_set.add_to(*command);
  CLI::Option* reference =
      command
          ->add_option("--reference", options->reference,
                       "Untouched image of a flat sensor; stored with the finger")
          ->type_name("IMAGE");
  command->add_option("--operator", options->operator_name, "Name of the operator, for the record")
      ->type_name("NAME");
  CLI::Option* date =
      command
          ->add_option(
              "--date", options->date,
              "Date of this calibration, for the record, as 2026-01-31T12:00:00Z (default: now)")
          ->type_name("DATE")
          ->check([](const std::string& text) {
            return is_utc(text) ? std::string() : "must be a date such as 2026-01-31T12:00:00Z";
          });
  CLI::Option* again =
      command
          ->add_flag("--again", options->again,
                     "Repeats the stored calibration with the same presses and settings, to "
                     "identical bytes; other options given here override it")
          ->excludes(presses)
          ->excludes(bursts)
          ->excludes(reference)
          ->excludes(date);
  command->add_option("--include", options->included, "With --again: uses an excluded press again")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->take_all()
      ->needs(again);
  command->add_flag("--compare", options->compare_methods,
                    "Compares with other methods on the same presses, here and in the report, "
                    "which takes longer than the calibration itself");
  SettingFlags<CalibrationSettings> calibration;
  calibration.add_to(*command, calibration_settings());
  SettingFlags<PipelineSettings> pipeline;
  pipeline.add_to(*command, pipeline_settings(), mapping_independent_settings());
  command->callback([=, &chosen] {
    if (!options->again && presses->count() == 0) throw CLI::RequiredError("PRESS");
    if (!options->again && radius->count() == 0) throw CLI::RequiredError("--ball-radius-mm");
    const auto change = [=](CalibrationSettings& how, PipelineSettings& frames) {
      how = calibration.applied_to(how);
      // The source paper's method has none of these.
      if (how.method == CalibrationMethod::kPaper) frames = {};
      frames = pipeline.applied_to(frames);
    };
    options->calibration = {};
    options->pipeline = {};
    change(options->calibration, options->pipeline);
    if (options->calibration.method == CalibrationMethod::kPaper)
      pipeline.refuse_all("does not apply to the source paper's method");
    options->change = change;
    options->annotate_presses = [=](PressSet& presses) { press_set.say(presses); };
    chosen = [=](Console& console) { return run_calibrate(*options, console); };
  });
}

}  // namespace alltact
