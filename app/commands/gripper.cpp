// Two fingers on a gripper: the poses of their cameras, and measurements of an object between them.
#include "core/gripper/gripper.h"

#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "core/gripper/gripper_recording.h"
#include "core/gripper/held_object.h"
#include "core/image/image_file.h"
#include "core/numerics/readable_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace alltact {
namespace {

struct GripperOptions {
  Path gripper;  ///< gripper.yaml or its folder
  std::optional<double> motor_turns;
  std::optional<double> motor_sd_turns;  ///< empty: gripper.yaml's
  std::optional<Path> motor_log;         ///< instead of motor_turns, with results
  std::vector<Path> results;             ///< none, or results.jsonl of the first and second finger
  double tolerance_ms = 20;
  Eigen::Vector3d up = {0, 0, -1};  ///< in the gripper's frame
};

constexpr double kDegPerRad = 180.0 / M_PI;

Console::Json vector_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

void print_linkages(const Gripper& gripper, Console& console) {
  const GripperMotor& motor = gripper.motor;
  Console::Json& answer = console.answer();
  answer["gripper"] = gripper.name;
  answer["range_turns"] = {motor.first_turns, motor.last_turns};
  console.say(fmt::format("{}: motor from {:g} to {:g} turns, screw lead {:g} mm", gripper.name,
                          motor.first_turns, motor.last_turns, motor.lead_mm));
  Console::Json fingers = Console::Json::array();
  for (std::size_t i = 0; i < 2; ++i) {
    const auto linkage = Linkage::create(gripper.fingers[i].linkage, motor.lead_mm);
    if (!linkage) continue;  // a loaded gripper is valid
    const MotorReach reach = linkage->reach_around(0.5 * (motor.first_turns + motor.last_turns));
    console.say(fmt::format("{:<12} closes from {:.4g} turns ({}) to {:.4g} ({})",
                            gripper.fingers[i].name, reach.first.motor_turns,
                            to_message(reach.first.kind), reach.last.motor_turns,
                            to_message(reach.last.kind)));
    Console::Json dead = Console::Json::array();
    for (const DeadPoint& point : gripper.dead_points_in_range(i)) {
      console.say(fmt::format("{:<12} has a dead point at {:.4g} turns: {}",
                              gripper.fingers[i].name, point.motor_turns, to_message(point.kind)));
      dead.push_back(point.motor_turns);
    }
    fingers.push_back({{"finger", gripper.fingers[i].name},
                       {"reach_turns", {reach.first.motor_turns, reach.last.motor_turns}},
                       {"stands_still_at_turns", std::move(dead)}});
  }
  answer["linkages"] = std::move(fingers);
}

void print_pose(const Gripper& gripper, const GripperPose& pose, Console& console) {
  console.say(
      fmt::format("at {:g} +- {:g} turns, gripper_from_camera:", pose.motor_turns, pose.sd_turns));
  Console::Json fingers = Console::Json::array();
  for (std::size_t i = 0; i < 2; ++i) {
    const FingerPose& finger = pose.fingers[i];
    const Eigen::Vector3d& at = finger.gripper_from_camera.translation_mm;
    const Eigen::Vector3d turns = rpy_deg(finger.gripper_from_camera.rotation);
    const Eigen::Quaterniond turn = finger.gripper_from_camera.rotation.normalized();
    Console::Json one{{"finger", gripper.fingers[i].name},
                      {"crank_deg", finger.angle.rad * kDegPerRad}};
    std::string angle_text = "dead point";
    if (finger.angle_sd_rad) {
      one["crank_deg_per_turn"] = finger.angle.rad_per_turn * kDegPerRad;
      one["crank_sd_deg"] = *finger.angle_sd_rad * kDegPerRad;
      angle_text =
          fmt::format("{:.3f} deg per turn, sd {:.3f} deg", finger.angle.rad_per_turn * kDegPerRad,
                      *finger.angle_sd_rad * kDegPerRad);
    }
    console.say(
        fmt::format("{:<12} position {:.3f} {:.3f} {:.3f} mm, rotation {:.3f} {:.3f} {:.3f} deg "
                    "about x, y, z; crank at {:.3f} deg, {}",
                    gripper.fingers[i].name, at.x(), at.y(), at.z(), turns.x(), turns.y(),
                    turns.z(), finger.angle.rad * kDegPerRad, angle_text));
    one["gripper_from_camera"] = {{"translation_mm", vector_json(at)},
                                  {"rotation", {turn.w(), turn.x(), turn.y(), turn.z()}}};
    fingers.push_back(std::move(one));
  }
  console.answer()["motor_turns"] = pose.motor_turns;
  console.answer()["motor_sd_turns"] = pose.sd_turns;
  console.answer()["fingers"] = std::move(fingers);
}

/// "12.3 +- 0.1 mm"; without the standard deviation where it is not known.
std::string with_sd(double value, const std::optional<double>& sd, const char* unit) {
  return sd ? fmt::format("{} {}", value_and_sd(value, *sd, 3), unit)
            : fmt::format("{:.3f} {}", value, unit);
}

void put_width(const GripperPose& pose, const std::array<ObservedContact, 2>& contacts,
               Console::Json& entry, std::string& line) {
  const HeldWidth width = held_width(pose, contacts);
  line += fmt::format("; width {}", with_sd(width.mm, width.sd_mm, "mm"));
  entry["width_mm"] = width.mm;
  if (width.sd_mm) entry["width_sd_mm"] = *width.sd_mm;
}

void put_turns(const Gripper& gripper, const GripperPose& pose,
               const std::array<const RecordedContacts*, 2>& seen, const Eigen::Vector3d& up,
               Console::Json& entry, std::string& line) {
  std::array<std::optional<UprightTurn>, 2> turns;
  for (std::size_t i = 0; i < 2; ++i) {
    if (seen[i]->contact) turns[i] = upright_turn_deg(pose, i, *seen[i]->contact, up);
    if (!turns[i]) continue;
    line += fmt::format("; upright turn from {}: {}", gripper.fingers[i].name,
                        with_sd(turns[i]->deg, turns[i]->sd_deg, "deg"));
    entry["turns"].push_back({{"finger", gripper.fingers[i].name},
                              {"deg", turns[i]->deg},
                              {"sd_deg", turns[i]->sd_deg}});
  }
  if (!turns[0] || !turns[1]) return;
  const auto joint = joint_turn(*turns[0], *turns[1]);
  if (!joint) return;
  line += fmt::format(
      "; upright turn from both: {}{}", with_sd(joint->mean.deg, joint->mean.sd_deg, "deg"),
      joint->agree ? "" : fmt::format(", but they differ by {:.1f} deg", joint->difference_deg));
  entry["turn_deg"] = joint->mean.deg;
  entry["turn_sd_deg"] = joint->mean.sd_deg;
  entry["apart_deg"] = joint->difference_deg;
  entry["agree"] = joint->agree;
}

/// The face stored next to results.jsonl; nullopt where there is none.
Result<std::optional<cv::Mat>> stored_points(const Path& results, const std::string& frame) {
  // A frame's name comes from a file and must not lead elsewhere.
  if (Path(frame).filename() != Path(frame)) return std::optional<cv::Mat>();
  const Path file = results.parent_path() / (frame + ".points.tiff");
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return std::optional<cv::Mat>();
  auto points = read_float_image(file);
  if (!points) return points.error();
  if (points->type() != CV_32FC3)
    return Error{en::say("holds no points: three numbers a pixel are needed"), file,
                 en::say("alltact reconstruct with --format points")};
  return std::optional<cv::Mat>(std::move(*points));
}

Status put_gap(const GripperPose& pose, const std::array<Path, 2>& files,
               const std::array<const RecordedContacts*, 2>& seen, Console::Json& entry,
               std::string& line) {
  std::array<GapFace, 2> faces;
  for (std::size_t i = 0; i < 2; ++i) {
    auto points = stored_points(files[i], seen[i]->frame);
    if (!points) return points.error();
    if (!*points) return {};
    faces[i].points_mm = std::move(**points);
    faces[i].z_sd_mm = [one = seen[i]](double u) { return one->z_sd_mm(u); };
  }
  const auto gap = face_gap(pose, faces);
  if (!gap) return {};
  line += fmt::format("; gap {}", with_sd(gap->mm, gap->sd_mm, "mm"));
  entry["gap_mm"] = gap->mm;
  if (gap->sd_mm) entry["gap_sd_mm"] = *gap->sd_mm;
  entry["gap_at_mm"] = {vector_json(gap->first_mm), vector_json(gap->second_mm)};
  return {};
}

void print_unpaired(const Gripper& gripper,
                    const std::array<std::vector<RecordedContacts>, 2>& seen,
                    const PairedFrames& paired, Console& console) {
  Console::Json unpaired = Console::Json::object();
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& alone = i == 0 ? paired.unpaired_first : paired.unpaired_second;
    Console::Json names = Console::Json::array();
    std::string words;
    constexpr std::size_t kShown = 5;
    for (const std::size_t k : alone) {
      names.push_back(seen[i][k].frame);
      if (names.size() <= kShown) words += (words.empty() ? "" : ", ") + seen[i][k].frame;
    }
    if (!alone.empty())
      console.warn(fmt::format("Without a frame of the same time: {} frames of {}: {}{}",
                               alone.size(), gripper.fingers[i].name, words,
                               alone.size() > kShown ? ", ..." : ""));
    unpaired[gripper.fingers[i].name] = std::move(names);
  }
  console.answer()["unpaired"] = std::move(unpaired);
}

/// The gripper's position while two frames were taken: one motor position, or that of the log at
/// the middle of both times. The motor's motion between them adds to its uncertainty.
class RecordedPose {
 public:
  RecordedPose(const Gripper& gripper, const GripperOptions& options, std::optional<MotorLog> log)
      : gripper_(gripper), options_(options), log_(std::move(log)) {}
  Result<GripperPose> operator()(const RecordedContacts& first,
                                 const RecordedContacts& second) const {
    if (!log_) return gripper_.pose_at(*options_.motor_turns, options_.motor_sd_turns);
    std::optional<double> before, after;
    if (first.time_ns) before = log_->turns_at(*first.time_ns);
    if (second.time_ns) after = log_->turns_at(*second.time_ns);
    if (!before || !after)
      return Error{en::say("the motor's log does not reach to when this was taken"), "", ""};
    const double sd = options_.motor_sd_turns.value_or(gripper_.motor.sd_turns);
    return gripper_.pose_at(0.5 * (*before + *after), std::hypot(sd, 0.5 * (*after - *before)));
  }
  [[nodiscard]] bool is_logged() const { return log_.has_value(); }

  /// Error: no frame was taken while the motor was logged.
  [[nodiscard]] Status check_times(const std::vector<RecordedContacts>& frames) const {
    if (!log_) return {};
    std::int64_t first_ns = std::numeric_limits<std::int64_t>::max(), last_ns = -first_ns;
    for (const RecordedContacts& frame : frames)
      if (frame.time_ns)
        first_ns = std::min(first_ns, *frame.time_ns), last_ns = std::max(last_ns, *frame.time_ns);
    if (first_ns > last_ns || (first_ns <= log_->last_ns() && last_ns >= log_->first_ns()))
      return {};
    const auto seconds = [](std::int64_t ns) { return 1e-9 * static_cast<double>(ns); };
    return Error{en::say("the motor's log runs from {:g} to {:g} s, the frames from {:g} to {:g} s",
                         seconds(log_->first_ns()), seconds(log_->last_ns()), seconds(first_ns),
                         seconds(last_ns)),
                 *options_.motor_log,
                 en::say("times on the clock of the frames, and their unit in the column's name, "
                         "as t_ms")};
  }

 private:
  const Gripper& gripper_;
  const GripperOptions& options_;
  std::optional<MotorLog> log_;
};

Status print_recorded(const Gripper& gripper, const RecordedPose& pose_of,
                      const GripperOptions& options, Console& console) {
  const std::array<Path, 2> files{options.results[0], options.results[1]};
  std::array<std::vector<RecordedContacts>, 2> seen;
  for (std::size_t i = 0; i < 2; ++i) {
    auto read = read_recorded_contacts(files[i]);
    if (!read) return read.error();
    seen[i] = std::move(*read);
    if (const Status reached = pose_of.check_times(seen[i]); !reached) return reached;
  }
  const PairedFrames paired =
      paired_frames(seen[0], seen[1], std::llround(1e6 * options.tolerance_ms));
  if (!paired.by_time)
    console.warn("Warning: some frames have no time, so all are paired in their order.");
  Console::Json pairs = Console::Json::array();
  for (const auto& [first, second] : paired.pairs) {
    if (console.job().stop_requested()) return Error{en::say("stopped"), "", ""};
    const std::array<const RecordedContacts*, 2> both{&seen[0][first], &seen[1][second]};
    Console::Json entry{{"frames", {both[0]->frame, both[1]->frame}}};
    std::string line = fmt::format("{} and {}", both[0]->frame, both[1]->frame);
    if (paired.by_time)
      entry["later_ms"] =
          1e-6 * (static_cast<double>(*both[1]->time_ns) - static_cast<double>(*both[0]->time_ns));
    const auto pose = pose_of(*both[0], *both[1]);
    if (!pose) {
      if (!pose_of.is_logged()) return pose.error();
      console.say(fmt::format("{}; {}", line, pose.error().message()));
      entry["problem"] = pose.error().message().english();
      pairs.push_back(std::move(entry));
      continue;
    }
    if (pose_of.is_logged()) entry["motor_turns"] = pose->motor_turns;
    if (const Status gap = put_gap(*pose, files, both, entry, line); !gap) return gap;
    if (both[0]->contact && both[1]->contact)
      put_width(*pose, {*both[0]->contact, *both[1]->contact}, entry, line);
    else
      line += "; nothing is held";
    put_turns(gripper, *pose, both, options.up, entry, line);
    console.say(line);
    pairs.push_back(std::move(entry));
  }
  console.answer()["paired_by"] = paired.by_time ? "time" : "order";
  console.answer()["pairs"] = std::move(pairs);
  print_unpaired(gripper, seen, paired, console);
  if (paired.pairs.empty())
    return Error{en::say("no frame of one finger has a partner of the other"),
                 options.results[0].string(),
                 en::say("recordings made at the same time, or a greater --tolerance-ms")};
  return {};
}

/// Prints the reach of a gripper's linkages, its cameras' poses for a motor position, and the
/// object between the fingers from recordings of both. Error: out of reach; no frames that belong
/// together.
Status run_gripper(const GripperOptions& options, Console& console) {
  std::vector<Message> warnings;
  const auto gripper = Gripper::load(options.gripper, &warnings);
  if (!gripper) return gripper.error();
  for (const Message& warning : warnings) console.warn(fmt::format("Warning: {}", warning));
  if (!(options.up.tail<2>().norm() > 0.17 * options.up.norm()))
    return Error{en::say("the way up lies along x, the direction in which the fingers close: no "
                         "turn about it brings an object upright"),
                 std::string("--up"), en::say("a direction across it, for example 0 0 -1")};
  print_linkages(*gripper, console);
  std::optional<MotorLog> log;
  if (options.motor_log) {
    auto read = MotorLog::load(*options.motor_log);
    if (!read) return read.error();
    console.say(read->understood().english());
    for (const Message& remark : read->remarks()) console.warn(remark.english());
    console.answer()["motor_log_read_as"] = read->understood().english();
    log = std::move(*read);
  }
  if (options.motor_turns) {
    const auto pose = gripper->pose_at(*options.motor_turns, options.motor_sd_turns);
    if (!pose) return pose.error();
    print_pose(*gripper, *pose, console);
  }
  if (options.results.empty()) return {};
  return print_recorded(*gripper, RecordedPose(*gripper, options, std::move(log)), options,
                        console);
}

}  // namespace

void add_gripper(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<GripperOptions>();
  auto up = std::make_shared<std::vector<double>>();
  CLI::App* command = add_command(program, "gripper");
  command->add_option("GRIPPER", options->gripper, "gripper.yaml, or its folder")->required();
  CLI::Option* motor =
      command
          ->add_option("--motor", options->motor_turns,
                       "Motor position, turns; gives the poses of both cameras in the gripper")
          ->type_name("M")
          ->transform(typed_number(-1e6, 1e6));
  CLI::Option* sd =
      command
          ->add_option(
              "--motor-sd", options->motor_sd_turns,
              "Standard deviation of the motor position, turns (default: that of gripper.yaml)")
          ->type_name("S")
          ->transform(typed_number(0.0, 1000.0));
  CLI::Option* results =
      command
          ->add_option("--results", options->results,
                       "results.jsonl of both fingers, in the order of gripper.yaml. For frames of "
                       "the same time: gap of the faces (needs NAME.points.tiff), width of the "
                       "held object, and the turn that brings it upright")
          ->type_name("FIRST SECOND")
          ->expected(2);
  CLI::Option* log = command
                         ->add_option("--motor-log", options->motor_log,
                                      "Motor positions during that recording: a table of time_ns "
                                      "and turns on the clock of the frames; other units stand in "
                                      "the names, as t_ms and 'angle [deg]'")
                         ->type_name("FILE")
                         ->needs(results)
                         ->excludes(motor);
  command
      ->add_option("--tolerance-ms", options->tolerance_ms,
                   "Maximum time between two paired frames, ms (default 20)")
      ->type_name("T")
      ->transform(typed_number(0.0, 1e6))
      ->needs(results);
  command
      ->add_option("--up", *up,
                   "Up direction in the gripper's frame (default 0 0 -1: it points downwards)")
      ->type_name("X Y Z")
      ->transform(typed_number(-1e6, 1e6))
      ->expected(3)
      ->needs(results);
  command->callback([=, &chosen] {
    if (!results->empty() && motor->empty() && log->empty())
      throw CLI::RequiredError("--motor or --motor-log");
    if (!sd->empty() && motor->empty() && log->empty())
      throw CLI::ValidationError("--motor-sd", "is for --motor or --motor-log");
    if (!up->empty()) options->up = {(*up)[0], (*up)[1], (*up)[2]};
    chosen = [=](Console& console) { return run_gripper(*options, console); };
  });
}

}  // namespace alltact
