// The messages of `alltact serve`: about its finger, and for each frame.
#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "calibration/checks/finger_check.h"
#include "calibration/export/export_texts.h"
#include "calibration/finger/calibration_report.h"
#include "calibration/live/watched_finger.h"
#include "calibration/reference/reference_recording.h"
#include "core/base/program.h"
#include "core/base/utc_time.h"
#include "core/devices/v4l2_camera.h"
#include "core/finger/finger_store.h"
#include "core/image/image_file.h"
#include "core/open/open_source.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/result_json.h"
#include "core/sources/source.h"
#include "core/stream/stream_format.h"
#include "core/stream/stream_server.h"

#include <cassert>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

struct ServeOptions {
  Path finger;
  std::vector<Path> inputs;
  std::optional<Path> socket;  ///< empty: the default one (stream_server.h)
  /// The settings to measure with, as the finger's folder has them now.
  std::function<Result<PipelineSettings>()> settings;
  bool schema = false;  ///< prints the format instead
};

struct ServedSource {
  std::string name;
  double frames_per_s = 30;
  bool is_camera = false;  ///< its times are the kernel's
};

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

StreamMessage of_frame(const Frame& frame, const std::string& line, const FingerSnapshot& finger,
                       StreamPartSet requested) {
  assert(line.ends_with('}'));
  StreamMessage message;
  message.requested_parts = requested;
  message.sequence = frame.sequence;
  message.time_ns = frame.time_ns.value_or(0);
  message.json =
      line.substr(0, line.size() - 1) + fmt::format(",\"finger_revision\":{}}}", finger.revision);
  return message;
}

Json parts_json() {
  Json parts;
  for (const StreamPartKind& kind : kStreamParts)
    parts[std::string(kind.name)] = {
        {"dtype", kind.dtype}, {"channels", kind.channels}, {"what", kind.what}};
  Json& depth16 = parts[std::string(kStreamParts[kDepth16].name)];
  depth16["mm_per_step"] = kDepthStep_mm;
  depth16["zero_at"] = kDepthZero;
  depth16["none"] = 0;
  return parts;
}

StreamMessage finger_message(const FingerSnapshot& finger, const Pipeline& pipeline,
                             const ServedSource& source) {
  const CameraParameters& camera = pipeline.finger().camera;
  Json json;
  json["format"] = kStreamFormat;
  json["program"] = "alltact " + program_version();
  json["finger"] = finger.finger.name;
  json["finger_revision"] = finger.revision;
  if (const auto date = finger.finger.provenance.find("calibration_date");
      date != finger.finger.provenance.end())
    json["calibration_date"] = date->second;
  if (const auto worth = worth_of(finger, utc_now()).verdict)
    json["verdict"] = verdict_json(*worth);
  json["source"] = source.name;
  json["clock"] = source.is_camera ? "monotonic" : "source";
  json["frames_per_s"] = source.frames_per_s;
  json["size_px"] = {camera.width_px, camera.height_px};
  json["reduced_by"] = binning_factor(pipeline.settings().resolution);
  json["camera"] = camera_json(camera);
  json["face"] = face_json(finger.finger.face);
  json["parts"] = parts_json();
  StreamMessage message;
  message.type = StreamType::kFinger;
  message.json = text_of(json);
  return message;
}

/// `line`: of results.jsonl, to which finger_revision is added. Only the requested parts are made,
/// as far as the frame has them.
StreamMessage frame_message(const FrameResult& result, const std::string& line,
                            const FingerSnapshot& finger, StreamPartSet requested) {
  StreamMessage message = of_frame(*result.frame, line, finger, requested);
  if (requested[kImage]) message.parts[kImage] = result.grey;
  if (!result.depth) return message;
  if (requested[kDepth16]) message.parts[kDepth16] = depth_steps(result.depth->depth_mm);
  if (requested[kDepth]) message.parts[kDepth] = result.depth->depth_mm;
  if (requested[kFlags]) message.parts[kFlags] = result.depth->flags;
  if (requested[kPoints])
    message.parts[kPoints] = contact_face_points_mm(result, finger.finger.face);
  return message;
}

/// For a frame that could not be measured: the image as it came.
StreamMessage unmeasured_message(const Frame& frame, const std::string& line,
                                 const FingerSnapshot& finger, StreamPartSet requested) {
  StreamMessage message = of_frame(frame, line, finger, requested);
  if (requested[kImage]) message.parts[kImage] = frame.grey;
  return message;
}

StreamMessage problem_message(const Error& problem) {
  StreamMessage message;
  message.type = StreamType::kProblem;
  message.json = text_of({{"problems", {problem.sentence()}}});
  return message;
}

/// Content of a kEnd message.
std::string end_json(const Message& reason) {
  return text_of({{"reason", fmt::format("{}.", reason)}});
}

/// Makes the pipelines for a finger's frames, now and after a new calibration.
WatchedFinger::MakePipeline pipeline_maker(const ServeOptions& options) {
  return [options](const FingerSnapshot& finger, const Job& job) -> Result<Pipeline> {
    if (!finger.mapping)
      return Error{en::say("the finger is not calibrated yet"),
                   (options.finger / Finger::kFileName).string(),
                   en::say("alltact calibrate with ball presses")};
    const auto settings = options.settings();
    if (!settings) return settings.error();
    return Pipeline::create(finger, *settings, job);
  };
}

/// Measures the newest frame again and again, for all clients.
class Serving {
 public:
  Serving(WatchedFinger& finger, std::unique_ptr<Source> source, const ServedSource& about,
          StreamServer& server, Console& console)
      : finger_(finger),
        about_(about),
        remarks_(*source),
        newest_(std::move(source)),
        server_(server),
        console_(console) {}

  /// Returns the reason of its end.
  Message run() {
    describe();
    while (!console_.job().stop_requested()) {
      follow();
      const auto frame = newest_.next();
      if (console_.job().stop_requested()) break;
      if (frame && !*frame) return en::say("the source ended");
      remarks_.report(console_);
      if (frame)
        measure(*frame);
      else
        report(frame.error());
    }
    return en::say("stopped by hand");
  }

  [[nodiscard]] std::size_t measured() const { return index_; }
  [[nodiscard]] std::size_t failed() const { return failed_; }
  [[nodiscard]] std::uint64_t skipped() const { return newest_.skipped(); }

 private:
  void describe() { server_.publish(finger_message(finger_.finger(), finger_.pipeline(), about_)); }

  void follow() {
    if (const auto problem = finger_.take_problem()) report(*problem);
    if (!finger_.take_update()) return;
    console_.warn("The finger has changed; new frames are measured with its current state.");
    describe();
  }

  void measure(const FramePtr& frame) {
    last_problem_.clear();
    warn_of_settings(*frame);
    Pipeline& pipeline = finger_.pipeline();
    const FingerSnapshot& finger = finger_.finger();
    if (const auto result = pipeline(frame)) {
      failed_ += result->depth ? 0 : 1;
      server_.publish(frame_message(*result,
                                    result_line(*result, index_, pipeline.settings().reference),
                                    finger, server_.requested()));
    } else {
      ++failed_;
      const std::string line = failure_line(frame->name, index_, {as_sentence(result.error())});
      server_.publish(unmeasured_message(*frame, line, finger, server_.requested()));
      warn_once(result.error());
    }
    ++index_;
  }

  /// Each difference once.
  void warn_of_settings(const Frame& frame) {
    const Message other = other_settings_than_stored(frame, finger_.finger().finger);
    if (!other.empty() && other != last_difference_)
      console_.warn(fmt::format("Warning: {}", other));
    last_difference_ = other;
  }

  void report(const Error& problem) {
    server_.publish(problem_message(problem));
    warn_once(problem);
  }

  /// An unplugged camera reports the same error again and again.
  void warn_once(const Error& problem) {
    const std::string sentence = problem.sentence();
    if (std::exchange(last_problem_, sentence) != sentence) console_.warn(sentence);
  }

  WatchedFinger& finger_;
  ServedSource about_;
  CameraRemarks remarks_;
  NewestSource newest_;
  StreamServer& server_;
  Console& console_;
  std::size_t index_ = 0, failed_ = 0;
  Message last_difference_;
  std::string last_problem_;
};

Status print_schema(Console& console) {
  if (!console.json()) return console.put(stream_schema_text());
  console.answer() = Console::Json::parse(stream_schema_json());
  return {};
}

/// Measures a live source and sends the results to other programs, until it ends or is stopped.
/// Errors: the socket is taken or others could reach it; the finger is not calibrated.
Status run_serve(const ServeOptions& options, Console& console) {
  const auto snapshot = open_finger(options.finger, console);
  if (!snapshot) return snapshot.error();
  const Path socket = options.socket.value_or(default_socket((*snapshot)->finger.name));
  // First, so that nothing is loaded in vain; nobody gets anything until all is ready.
  auto server = StreamServer::start(socket, "serving " + options.finger.string());
  if (!server) return server.error();
  SourceOptions how;
  how.pace = Pace::kRecorded;
  how.job = &console.job();
  auto source = open_source(options.inputs, how);
  if (!source) return source.error();
  auto finger = WatchedFinger::open(options.finger, pipeline_maker(options), console.job());
  if (!finger) return finger.error();
  report_remarks(**source, console);
  const ServedSource about{options.inputs.front().string(), (*source)->frames_per_s(),
                           dynamic_cast<CameraSource*>(source->get()) != nullptr};
  console.say(fmt::format(
      "Serving {} at {}, to programs of this user on this computer only. Ctrl-C ends it.",
      (*snapshot)->finger.name, (*server)->path().string()));
  Serving serving(**finger, std::move(*source), about, **server, console);
  const Message reason = serving.run();
  (*server)->end(end_json(reason));
  const StreamCounts counts = (*server)->counts();
  console.say(fmt::format(
      "{} frames, {} of them without depth; {} skipped to keep up; {} programs served, "
      "which were too slow for {} frames.",
      serving.measured(), serving.failed(), serving.skipped(), counts.served, counts.lost));
  Console::Json& answer = console.answer();
  answer["socket"] = (*server)->path().string();
  answer["frames"] = serving.measured();
  answer["failed"] = serving.failed();
  answer["skipped"] = serving.skipped();
  answer["clients"] = counts.served;
  answer["refused"] = counts.refused;
  answer["lost"] = counts.lost;
  return {};
}

}  // namespace

void add_serve(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ServeOptions>();
  auto preset = std::make_shared<std::string>();
  CLI::App* command = add_command(program, "serve");
  CLI::Option* finger = command->add_option("FINGER", options->finger, "The finger's folder");
  CLI::Option* inputs = command->add_option("SOURCE", options->inputs,
                                            "Camera, video, images or a folder of them, or scene");
  CLI::Option* socket =
      command
          ->add_option("--socket", options->socket,
                       "Unix socket where programs connect, in a folder that is yours alone "
                       "(default alltact/NAME.sock in $XDG_RUNTIME_DIR)")
          ->type_name("PATH");
  CLI::Option* preset_flag =
      command
          ->add_option(
              "--preset", *preset,
              "Settings to measure with: a preset that a study of this finger saved (alltact study "
              "FINGER --save), or as calibrated (default: what the finger uses)")
          ->type_name("fast|balanced|finest|calibrated");
  CLI::Option* schema = command->add_flag(
      "--schema", options->schema,
      "Prints what a program sends and receives instead, for people or (--json) programs");
  for (CLI::Option* option : {finger, inputs, socket, preset_flag}) option->excludes(schema);
  SettingFlags<PipelineSettings> pipeline;
  pipeline.add_to(*command, pipeline_settings());
  command->callback([=, &chosen] {
    if (options->schema) {
      chosen = print_schema;
      return;
    }
    for (const CLI::Option* option : {finger, inputs})
      if (option->empty()) throw CLI::RequiredError(option->get_name());
    options->settings = [=]() -> Result<PipelineSettings> {
      const auto settings = stored_settings(options->finger, *preset);
      return settings ? Result(pipeline.applied_to(*settings)) : settings.error();
    };
    chosen = [=](Console& console) -> Status {
      const auto settings = stored_settings(options->finger, *preset);
      if (!settings) return settings.error();
      warn_of_other_settings(*settings, pipeline.applied_to(*settings), console);
      return run_serve(*options, console);
    };
  });
}

}  // namespace alltact
