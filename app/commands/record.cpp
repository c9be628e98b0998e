#include "app/commands/commands.h"
#include "app/flags.h"
#include "core/recording/journal.h"
#include "core/sources/source.h"

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kGigabyte = 1e9;

/// How far a recording has come, and when it has what was asked for.
class Extent {
 public:
  explicit Extent(const RecordOptions& options) : options_(options) {}

  void add(const Frame& frame) {
    if (frames_++ == 0) first_ns_ = frame.time_ns;
    seconds_ = std::max(seconds_, static_cast<double>(frame.time_ns - first_ns_) * 1e-9);
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
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  const RecordOptions& options_;
  std::uint64_t frames_ = 0;
  std::int64_t first_ns_ = 0;
  double seconds_ = 0;
};

std::string progress(const RecorderCounts& counts) {
  return fmt::format("{} frames, {} lost, {:.1f} GB free",
                     counts.recorded,
                     counts.dropped + counts.missing,
                     static_cast<double>(counts.free_bytes) / kGigabyte);
}

/// What a recording ended for, and what could not be read on the way.
struct Ending {
  std::string why;
  std::uint64_t unreadable = 0;
};

/// From the first frame to the last. The recorder's own end shows in Recorder::problem().
Ending record_all(Source& source, Recorder& recorder, Extent& extent, Console& console) {
  Ending ending;
  std::string last_problem;
  while (true) {
    if (console.job().stop_requested()) return ending.why = "stopped by hand", ending;
    const auto frame = source.next();
    if (!frame) {
      // A camera that is unplugged says so again and again, and may come back.
      if (frame.error().sentence() != last_problem) console.warn(frame.error().sentence());
      last_problem = frame.error().sentence();
      ++ending.unreadable;
      continue;
    }
    if (!*frame) {
      ending.why = console.job().stop_requested() ? "stopped by hand" : "the source ended";
      return ending;
    }
    last_problem.clear();
    const bool is_taken = source.is_live() ? recorder.add(*frame) : recorder.add_waiting(*frame);
    if (!is_taken && recorder.problem()) return ending;
    extent.add(**frame);
    console.job().report(extent.fraction(source.count()), progress(recorder.counts()));
    if (extent.is_reached(1 / source.frames_per_s()))
      return ending.why = "as many frames as were asked for", ending;
  }
}

void tell(const RecordOptions& options,
          const RecorderCounts& counts,
          const Extent& extent,
          const Ending& ending,
          Console& console) {
  Console::Json& answer = console.answer();
  answer["video"] = options.video.string();
  answer["journal"] = journal_of(options.video).string();
  answer["frames"] = counts.recorded;
  answer["dropped"] = counts.dropped;
  answer["missing"] = counts.missing;
  answer["unreadable"] = ending.unreadable;
  answer["seconds"] = extent.seconds();
  answer["bytes"] = counts.bytes;
  if (counts.recorded == 0) return;
  answer["codec"] = to_string(*counts.codec);
  console.say(fmt::format("{} frames ({:.1f} s, {:.2f} GB, {}) in {}",
                          counts.recorded,
                          extent.seconds(),
                          static_cast<double>(counts.bytes) / kGigabyte,
                          to_string(*counts.codec),
                          options.video.string()));
  if (counts.missing > 0)
    console.warn(fmt::format("{} frames never came from the source; the journal {} says where.",
                             counts.missing,
                             journal_of(options.video).string()));
}

}  // namespace

Status run_record(const RecordOptions& options, Console& console) {
  SourceOptions how;
  how.pace = options.pace;
  how.seed = options.seed;
  how.threads = options.threads;
  how.job = &console.job();
  auto source = open_source(options.inputs, how);
  if (!source) return source.error();
  auto recorder = Recorder::start(
      options.video, options.recorder, (*source)->frames_per_s(), options.inputs.front().string());
  if (!recorder) return recorder.error();
  Extent extent(options);
  const Ending ending = record_all(**source, **recorder, extent, console);
  const Status finished = (*recorder)->finish(ending.why);
  const RecorderCounts counts = (*recorder)->counts();
  tell(options, counts, extent, ending, console);
  const std::string lost = fmt::format("{} frames were lost here", counts.dropped);
  if (!finished) {
    if (counts.dropped > 0) console.warn(lost + ".");
    return finished;
  }
  if (counts.dropped > 0)
    return Error{lost + ", because the disk or this computer was too slow",
                 options.video.string(),
                 "another disk, a smaller picture, or a longer --queue-mb"};
  if (ending.unreadable > 0 && (*source)->count())
    return Error{fmt::format("{} frames could not be read; each is named above", ending.unreadable),
                 options.inputs.front().string(),
                 ""};
  return {};
}

void add_record(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<RecordOptions>();
  auto pace = std::make_shared<std::string>("recorded");
  CLI::App* command = program.add_subcommand(
      "record", "Records a source without loss, and without losing anything when killed");
  command
      ->add_option("SOURCE",
                   options->inputs,
                   "A camera (by a name that 'alltact devices' tells), a video, a scene (the "
                   "simulated finger, at its camera's pace, without end), "
                   "pictures or folders of them")
      ->required();
  command
      ->add_option("-o,--output",
                   options->video,
                   "The video, NAME.mkv; NAME.frames.csv beside it says what each frame was")
      ->type_name("VIDEO")
      ->required();
  command
      ->add_option(
          "--frames", options->frames, "Ends after so many frames (default: at the source's end)")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1000000000}));
  command
      ->add_option("--seconds",
                   options->seconds,
                   "Ends after so much recorded time (default: at the source's end)")
      ->type_name("S")
      ->check(CLI::Range(0.001, 1e7));
  command
      ->add_option("--pace",
                   *pace,
                   "Videos and scenes: recorded: as they were, or as a camera gives them; asked: "
                   "as fast as it goes (default recorded)")
      ->type_name("recorded|asked")
      ->check(CLI::IsMember({"recorded", "asked"}));
  command->add_option("--seed", options->seed, "Of a simulated finger, 0 to 2^64 - 1 (default 1)")
      ->type_name("S");
  command
      ->add_option("--threads",
                   options->threads,
                   "That render a simulated finger; the pictures are the same for any number (1 to "
                   "64; default 1)")
      ->type_name("N")
      ->check(CLI::Range(1, 64));
  SettingFlags<RecorderSettings> recorder;
  recorder.add_to(*command, recorder_settings());
  command->callback([=, &chosen] {
    options->pace = *pace == "asked" ? Pace::kAsked : Pace::kRecorded;
    options->recorder = recorder.applied_to({});
    chosen = [=](Console& console) { return run_record(*options, console); };
  });
}

}  // namespace alltact
