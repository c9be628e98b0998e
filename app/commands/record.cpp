// Presses of a foot pedal or button while a command runs, and its problems.
#include "app/commands/commands.h"
#include "app/commands/gauge_flags.h"
#include "app/console/command_names.h"
#include "app/console/console.h"
#include "app/console/flags.h"
#include "core/base/letters.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/devices/hid_button.h"
#include "core/devices/led_dimmer.h"
#include "core/devices/open_gauge.h"
#include "core/image/image_file.h"
#include "core/open/open_source.h"
#include "core/recording/journal.h"
#include "core/recording/recorder.h"
#include "core/sources/file_source.h"
#include "core/sources/source.h"

#include <atomic>
#include <memory>
#include <string>

#include <fmt/format.h>

namespace alltact {
namespace {

/// The light that a recording is made with.
struct LightOptions {
  std::string device;  ///< empty: none is set
  std::string control;
  double brightness = 0;
};

struct RecordOptions {
  std::vector<Path> inputs;
  Path output;  ///< a video; or, with a button, the name pattern of images (png)
  std::optional<LearntButton> button;
  LightOptions light;
  RecorderSettings recorder;
  Pace pace = Pace::kRecorded;
  std::uint64_t seed = 1;
  int threads = 1;
  std::optional<std::uint64_t> frames;  ///< ends after so many
  std::optional<double> seconds;        ///< ends after so much recorded time
  GaugeChoice gauge;                    ///< read in parallel; none where its name is empty
};

/// One thread asks; the presses arrive on another.
class ButtonPresses {
 public:
  /// Errors: the device is not there, or may not be used (with the udev rule to install).
  [[nodiscard]] static Result<std::unique_ptr<ButtonPresses>> listen(const LearntButton& button);

  /// True when it was pressed since the last call. Warns once when the device was unplugged, waits
  /// for it, and reports its return.
  [[nodiscard]] bool taken(Console& console);
  /// Drops presses that came before now.
  void forget() { presses_ = 0; }

 private:
  ButtonPresses(std::unique_ptr<HidPort> port, const LearntButton& button);

  std::atomic<int> presses_{0};
  bool is_away_ = false;
  HidButton button_;  // last: its thread ends first
};

/// Returns the port that is open already, and opens the device again from then on.
HidButton::Opener opener(std::unique_ptr<HidPort> port, const std::string& device) {
  auto first = std::make_shared<std::unique_ptr<HidPort>>(std::move(port));
  return [first, device]() -> Result<std::unique_ptr<HidPort>> {
    if (*first != nullptr) return std::move(*first);
    return open_hid(device);
  };
}

ButtonPresses::ButtonPresses(std::unique_ptr<HidPort> port, const LearntButton& button)
    : button_(opener(std::move(port), button.device), button.pattern, [this] { ++presses_; }) {}

Result<std::unique_ptr<ButtonPresses>> ButtonPresses::listen(const LearntButton& button) {
  auto port = open_hid(button.device);
  if (!port) return port.error();
  return std::unique_ptr<ButtonPresses>(new ButtonPresses(std::move(*port), button));
}

bool ButtonPresses::taken(Console& console) {
  const Status status = button_.status();
  if (!status && !is_away_)
    console.warn("The button is disconnected. " + status.error().sentence());
  if (status && is_away_) console.warn("The button is connected again.");
  is_away_ = !status.ok();
  return presses_.exchange(0) > 0;
}

/// Prints each fault and each remark of the camera once, and takes button presses between frames.
class SourceReader {
 public:
  SourceReader(Source& source, CameraRemarks remarks, ButtonPresses* button, Console& console)
      : source_(source), remarks_(std::move(remarks)), button_(button), console_(console) {}

  /// The next frame; null when the source is over, with the reason in why(), or when the button was
  /// pressed while no frame came.
  FramePtr next() {
    while (true) {
      if (is_stopped()) return end(en::say("stopped by hand"));
      auto frame = source_.next();
      remarks_.report(console_);
      is_pressed_ = button_ != nullptr && button_->taken(console_);
      if (frame && *frame) {
        last_problem_.clear();
        return *frame;
      }
      if (frame)
        return end(is_stopped() ? en::say("stopped by hand") : en::say("the source ended"));
      // An unplugged camera reports the same error again and again, and may come back.
      const std::string problem = frame.error().sentence();
      if (problem != last_problem_) console_.warn(problem);
      last_problem_ = problem;
      ++unreadable_;
      if (is_pressed_) return nullptr;
    }
  }
  /// The button was pressed since the call of next() before the last.
  [[nodiscard]] bool is_pressed() const { return is_pressed_; }
  /// Empty as long as frames may follow.
  [[nodiscard]] const Message& why() const { return why_; }
  [[nodiscard]] bool is_over() const { return !why_.empty(); }
  [[nodiscard]] bool is_stopped() const { return console_.job().stop_requested(); }
  [[nodiscard]] std::uint64_t unreadable() const { return unreadable_; }
  [[nodiscard]] Source& source() const { return source_; }

 private:
  FramePtr end(Message why) {
    why_ = std::move(why);
    return nullptr;
  }

  Source& source_;
  CameraRemarks remarks_;
  ButtonPresses* button_;
  Console& console_;
  bool is_pressed_ = false;
  Message why_;
  std::string last_problem_;
  std::uint64_t unreadable_ = 0;
};

constexpr double kGigabyte = 1e9;

/// The progress of a recording, and its end condition.
class Extent {
 public:
  explicit Extent(const RecordOptions& options) : options_(options) {}

  void add(const Frame& frame) {
    const double now_s = time_s(frame).value_or(0.0);
    if (frames_++ == 0) first_s_ = now_s;
    seconds_ = std::max(seconds_, now_s - first_s_);
  }
  [[nodiscard]] bool is_reached(double period_s) const {
    return (options_.frames && frames_ >= *options_.frames) ||
           (options_.seconds && frames_ > 0 && seconds_ + 0.5 * period_s >= *options_.seconds);
  }
  /// 0 where no end is known.
  [[nodiscard]] double fraction(std::optional<std::size_t> count) const {
    double part = 0;
    if (count && *count > 0) part = static_cast<double>(frames_) / static_cast<double>(*count);
    if (options_.frames)
      part = std::max(part, static_cast<double>(frames_) / static_cast<double>(*options_.frames));
    if (options_.seconds) part = std::max(part, seconds_ / *options_.seconds);
    return std::min(part, 1.0);
  }
  [[nodiscard]] std::uint64_t frames() const { return frames_; }
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  const RecordOptions& options_;
  std::uint64_t frames_ = 0;
  double first_s_ = 0;
  double seconds_ = 0;
};

Message progress(const RecorderCounts& counts) {
  return en::say("{} frames, {} lost, {:.1f} GB free", counts.recorded,
                 counts.dropped + counts.missing,
                 static_cast<double>(counts.free_bytes) / kGigabyte);
}

/// From `first` (or the next frame) to the last; returns the reason of the end, for the journal.
/// Recorder::problem() has the recorder's own reason.
std::string record_all(SourceReader& reading, FramePtr first, Recorder& recorder, Extent& extent,
                       GaugeLog* gauge, Console& console) {
  const Source& source = reading.source();
  while (true) {
    const FramePtr frame = first ? std::exchange(first, nullptr) : reading.next();
    print_gauge(gauge, console);
    if (reading.is_over()) return reading.why().english();
    if (reading.is_pressed() && extent.frames() > 0) return "the button was pressed";
    if (!frame) continue;
    if (gauge != nullptr) gauge->sync_clock(*frame);
    const bool is_taken = source.is_live() ? recorder.add(frame) : recorder.add_waiting(frame);
    if (!is_taken && recorder.problem()) return {};
    extent.add(*frame);
    console.job().report(extent.fraction(source.count()), progress(recorder.counts()));
    if (extent.is_reached(1 / source.frames_per_s())) return "the requested length was reached";
  }
}

void print_recording(const Path& video, const RecorderCounts& counts, const Extent& extent,
                     Console::Json& answer, Console& console) {
  answer["video"] = video.string();
  answer["journal"] = journal_of(video).string();
  answer["frames"] = counts.recorded;
  answer["dropped"] = counts.dropped;
  answer["missing"] = counts.missing;
  answer["seconds"] = extent.seconds();
  answer["bytes"] = counts.bytes;
  if (counts.recorded == 0) return;
  answer["codec"] = to_string(*counts.codec);
  console.say(fmt::format("{} frames ({:.1f} s, {:.2f} GB, {}) in {}", counts.recorded,
                          extent.seconds(), static_cast<double>(counts.bytes) / kGigabyte,
                          to_string(*counts.codec), video.string()));
  if (counts.missing > 0)
    console.warn(fmt::format("{} frames never came from the source; the journal {} lists them.",
                             counts.missing, journal_of(video).string()));
}

/// One complete recording.
Status record_one(SourceReader& reading, const FramePtr& first, const Path& video,
                  const RecordOptions& options, GaugeLog* gauge, Console::Json& answer,
                  Console& console) {
  auto recorder = Recorder::start(video, options.recorder, reading.source().frames_per_s(),
                                  options.inputs.front().string());
  if (!recorder) return recorder.error();
  if (gauge != nullptr)
    if (const Status begun = gauge->begin(gauge_log_of(video)); !begun) return begun;
  Extent extent(options);
  const std::string why = record_all(reading, first, **recorder, extent, gauge, console);
  const Status finished = (*recorder)->finish(why, console.job());
  const RecorderCounts counts = (*recorder)->counts();
  print_recording(video, counts, extent, answer, console);
  const Status gauge_status = end_gauge(gauge, video, answer, console);
  const Message lost = en::say("{} frames were lost here", counts.dropped);
  if (!finished) {
    if (counts.dropped > 0) console.warn(fmt::format("{}.", lost));
    return finished;
  }
  if (!gauge_status) return gauge_status;
  if (counts.dropped > 0)
    return Error{en::say("{}, because the disk or this computer was too slow", lost),
                 video.string(),
                 en::say("another disk, a smaller picture, or a longer --queue-mb")};
  return {};
}

Status all_was_readable(const SourceReader& reading, const RecordOptions& options) {
  if (reading.unreadable() == 0 || !reading.source().count()) return {};
  return Error{en::say("{} frames could not be read; each is named above", reading.unreadable()),
               options.inputs.front().string(), ""};
}

/// NAME-001.mkv, the first from `number` on of which nothing exists; sets `number` to the one after
/// it.
Path next_free(const Path& output, int& number) {
  std::error_code ignored;
  Path file;
  do {
    file = output.parent_path() /
           fmt::format("{}-{:03}{}", output.stem().string(), number++, output.extension().string());
  } while (std::filesystem::exists(file, ignored) ||
           std::filesystem::exists(journal_of(file), ignored) ||
           std::filesystem::exists(gauge_log_of(file), ignored));
  return file;
}

/// From press to press; null when it is over before the next one.
FramePtr next_pressed(SourceReader& reading) {
  bool is_pressed = false;  // maybe while the camera was away
  while (!reading.is_over()) {
    FramePtr frame = reading.next();
    is_pressed = is_pressed || reading.is_pressed();
    if (is_pressed && frame) return frame;
  }
  return nullptr;
}

/// A source that ended before the first press is an error, a technician who ended it is none.
Status end_of_presses(const SourceReader& reading, bool is_any, const RecordOptions& options) {
  if (is_any || reading.is_stopped()) return {};
  return Error{en::say("the button was not pressed before the end: {}", reading.why()),
               options.inputs.front().string(), en::say("press it while the source runs")};
}

Status record_by_button(SourceReader& reading, const RecordOptions& options, GaugeLog* gauge,
                        Console& console) {
  Console::Json& recordings = console.answer()["recordings"] = Console::Json::array();
  console.say(
      "Press the button to start a recording, and again to end it. Ctrl-C ends the command.");
  int number = 1;
  while (const FramePtr first = next_pressed(reading)) {
    const Path video = next_free(options.output, number);
    console.say(fmt::format("Recording {}", video.string()));
    Console::Json answer;
    const Status status = record_one(reading, first, video, options, gauge, answer, console);
    recordings.push_back(std::move(answer));
    if (!status) return status;
  }
  const bool is_any = !recordings.empty();
  console.answer()["unreadable"] = reading.unreadable();  // renames an existing file
  return end_of_presses(reading, is_any, options);
}

/// The first image after each press.
Status record_images(SourceReader& reading, const RecordOptions& options, Console& console) {
  Console::Json& images = console.answer()["pictures"] = Console::Json::array();
  console.say("Press the button to take an image. Ctrl-C ends the command.");
  int number = 1;
  while (!options.frames || images.size() < *options.frames) {
    const FramePtr frame = next_pressed(reading);
    if (!frame) return end_of_presses(reading, !images.empty(), options);
    const Path file = next_free(options.output, number);
    const Status status =
        write_image(file, frame->grey, frame->controls ? *frame->controls : std::string());
    if (!status) return status;
    images.push_back(file.string());
    console.say(file.string());
  }
  return {};
}

/// Sets the light, which stays so afterwards, and records it with every frame.
Result<std::unique_ptr<Source>> lit(std::unique_ptr<Source> source, const LightOptions& light) {
  if (light.device.empty()) return source;
  auto port = open_hid(light.device);
  if (!port) return port.error();
  auto dimmer = LedDimmer::create(std::move(*port), light.device, light.control);
  if (!dimmer) return dimmer.error();
  if (const Status status = dimmer->set(light.brightness); !status) return status.error();
  return std::unique_ptr<Source>(std::make_unique<LitSource>(std::move(source), dimmer->setting()));
}

bool records_images(const RecordOptions& options) {
  return lowered_extension(options.output) == ".png";
}

void add_button_flag(CLI::App& command, RecordOptions& options) {
  command
      .add_option_function<std::string>(
          "--button",
          [&options](const std::string& text) {
            const auto button = LearntButton::parse(text);
            if (!button) throw CLI::ValidationError("--button", button.error().sentence());
            options.button = *button;
          },
          "Foot pedal or button, as 'alltact devices --learn-button' prints it (in quotes). With "
          "-o NAME.mkv, one press starts a recording and the next ends it: NAME-001.mkv, "
          "NAME-002.mkv, ... With -o NAME.png, each press takes one image: NAME-001.png, ... "
          "Existing files are skipped, not overwritten")
      ->type_name("BUTTON");
}

void add_light_flags(CLI::App& command, LightOptions& light) {
  CLI::Option* device = command
                            .add_option("--dimmer", light.device,
                                        "LED dimmer to set before recording, by a name from "
                                        "'alltact devices'; its setting is stored with every frame")
                            ->type_name("DEVICE");
  CLI::Option* control =
      command
          .add_option("--dimmer-control", light.control,
                      "Control of the dimmer: 'mcp2221a gp2', 'mcp2221a gp3', or a report such as "
                      "'output id=0 bytes=8 at=1 range=0..255'")
          ->type_name("TEXT")
          ->needs(device);
  CLI::Option* brightness = command
                                .add_option("--brightness", light.brightness,
                                            "Brightness of the dimmer, from 0 dark to 1 full")
                                ->type_name("B")
                                ->transform(typed_number(0.0, 1.0))
                                ->needs(device);
  device->needs(control)->needs(brightness);
}

/// Refuses options that do not go together.
void check_output(const RecordOptions& options) {
  if (!records_images(options)) return;
  if (!options.button)
    throw CLI::ValidationError("--output", "images need a --button; a video is .mkv");
  if (!options.gauge.gauge.empty())
    throw CLI::ValidationError("--gauge", "works with a video, not with images");
  if (options.seconds)
    throw CLI::ValidationError("--seconds", "images have no length; --frames counts them");
}

/// Records a source until it ends or is stopped; with a button, between one press and the next, or
/// one image a press. Error: frames were lost on this computer, or could not be read; the recording
/// had to end; the button or the light is missing or not allowed.
Status run_record(const RecordOptions& options, Console& console) {
  SourceOptions how;
  how.pace = options.pace;
  how.seed = options.seed;
  how.threads = options.threads;
  how.job = &console.job();
  std::unique_ptr<ButtonPresses> button;
  if (options.button) {
    auto listening = ButtonPresses::listen(*options.button);
    if (!listening) return listening.error();
    button = std::move(*listening);
  }
  auto opened = open_source(options.inputs, how);
  if (!opened) return opened.error();
  const Source& frames = **opened;
  const std::size_t reported = report_remarks(frames, console);
  const CameraRemarks remarks(**opened);
  auto source = lit(std::move(*opened), options.light);
  if (!source) return source.error();
  // An image shows the moment of its press, however long the one before took to write.
  if (records_images(options)) *source = std::make_unique<NewestSource>(std::move(*source));
  SourceReader reading(**source, remarks, button.get(), console);
  if (records_images(options)) return record_images(reading, options, console);
  const auto gauge = start_gauge(options.gauge);
  if (!gauge) return gauge.error();
  if (button) return record_by_button(reading, options, gauge->get(), console);
  const Status status = record_one(reading, nullptr, options.output, options, gauge->get(),
                                   console.answer(), console);
  report_remarks(frames, console, reported);
  console.answer()["unreadable"] = reading.unreadable();
  return status ? all_was_readable(reading, options) : status;
}

}  // namespace

void add_record(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<RecordOptions>();
  auto pace = std::make_shared<std::string>("recorded");
  CLI::App* command = add_command(program, "record");
  command
      ->add_option("SOURCE", options->inputs,
                   "Camera (by a name from 'alltact devices'), video, scene (the simulated finger, "
                   "at its camera's pace, without end), images or folders of them")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "Video to write, NAME.mkv; NAME.frames.csv next to it describes each frame. "
                   "With --button also NAME.png")
      ->type_name("FILE")
      ->required();
  add_button_flag(*command, *options);
  add_light_flags(*command, options->light);
  add_gauge_flags(*command, options->gauge);
  command
      ->add_option("--frames", options->frames,
                   "Number of frames of each recording, or of images in total (default: until the "
                   "source ends)")
      ->type_name("N")
      ->transform(typed_integer(1, 1000000000));
  command
      ->add_option("--seconds", options->seconds,
                   "Recorded time of each recording, s (default: until the source ends)")
      ->type_name("S")
      ->transform(typed_number(0.001, 1e7));
  command
      ->add_option("--pace", *pace,
                   "Pace of videos and scenes: recorded, as they were recorded or as a camera "
                   "sends them; asked, as fast as possible (default recorded)")
      ->type_name("recorded|asked")
      ->check(CLI::IsMember({"recorded", "asked"}));
  command
      ->add_option("--seed", options->seed, "Seed of a simulated finger, 0 to 2^64 - 1 (default 1)")
      ->type_name("S")
      ->transform(typed_integer(0));
  command
      ->add_option("--threads", options->threads,
                   "Number of threads that render a simulated finger (1 to 64; default 1); the "
                   "images do not depend on it")
      ->type_name("N")
      ->transform(typed_integer(1, 64));
  SettingFlags<RecorderSettings> recorder;
  recorder.add_to(*command, recorder_settings());
  command->callback([=, &chosen] {
    check_output(*options);
    options->pace = *pace == "asked" ? Pace::kOnDemand : Pace::kRecorded;
    options->recorder = recorder.applied_to({});
    chosen = [=](Console& console) { return run_record(*options, console); };
  });
}

}  // namespace alltact
