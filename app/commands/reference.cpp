#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "calibration/reference/reference_recording.h"

#include <charconv>

#include <fmt/format.h>

namespace alltact {
namespace {

Status run_flat(const ReferenceOptions& options, Console& console) {
  if (options.inputs.size() != 1) {
    return Error{en::say("a flat sensor has one untouched picture"), options.finger.string(),
                 en::say("giving exactly one picture")};
  }
  const auto image = read_untouched_image(options.inputs.front());
  if (!image) return image.error();
  const auto warnings = set_untouched_image(options.finger, *image);
  if (!warnings) return warnings.error();
  for (const Message& warning : *warnings) console.warn(fmt::format("Warning: {}", warning));
  console.say("The untouched image is installed. Next: alltact calibrate with ball presses");
  console.answer()["frames_kept"] = 1;
  return {};
}

void print_report(const ReferenceReport& report, Console& console) {
  console.say(
      fmt::format("{} of {} frames are in the reference library; the median distance to the "
                  "nearest neighbour is {:.2f} px.",
                  report.frames_retained, report.frames_read, report.median_step_px));
  constexpr std::size_t kShown = 8;
  for (std::size_t i = 0; i < report.rejected.size() && i < kShown; ++i)
    console.say(fmt::format("  left out: {}", report.rejected[i]));
  if (report.rejected.size() > kShown)
    console.say(
        fmt::format("  left out: {} more; --json lists them all", report.rejected.size() - kShown));
  if (report.doubtful > 0)
    console.say(
        fmt::format("  {} of these frames are doubtful; --keep-frames FIRST-LAST includes those "
                    "that were untouched",
                    report.doubtful));
  if (report.repeated > 0)
    console.say(fmt::format("  {} frames repeat a stored pose and were left out", report.repeated));
  const MotionCoverage& seen = report.coverage;
  console.say(fmt::format(
      "The tip bent by {:+.1f} to {:+.1f} mm, swayed by {:+.1f} to {:+.1f} mm and "
      "twisted by {:+.1f} to {:+.1f} degrees; combined bend and sway cover {:.0f} %.",
      seen.bend_mm().least, seen.bend_mm().most, seen.sway_mm().least, seen.sway_mm().most,
      seen.twist_deg().least, seen.twist_deg().most, 100.0 * seen.covered()));
  console.say(fmt::format(
      "Depth error of its references: median {:.4f} mm, 95th percentile {:.4f} mm{}.",
      report.error_median_mm, report.error_p95_mm,
      report.by_own_mapping ? ""
                            : "; computed with a typical layer until the finger is calibrated"));
  for (const Message& remark : report.remarks) console.say(fmt::format("  {}", remark));
  for (const Message& warning : report.warnings) console.warn(fmt::format("Warning: {}", warning));
  Console::Json& answer = console.answer();
  answer["frames_read"] = report.frames_read;
  answer["frames_kept"] = report.frames_retained;
  answer["median_step_px"] = report.median_step_px;
  answer["rejected"] = in_english(report.rejected);
  answer["touched"] = report.contact_frames;
  answer["doubtful"] = report.doubtful;
  answer["uncompared"] = report.uncompared;
  answer["stretches"] = Console::Json::array();
  for (const ReferenceStretch& stretch : report.stretches)
    answer["stretches"].push_back({{"first", stretch.first},
                                   {"last", stretch.last},
                                   {"doubtful", stretch.is_doubtful},
                                   {"kept", stretch.is_retained},
                                   {"darker", stretch.darker},
                                   {"along_mm", stretch.along_mm}});
  answer["repeated"] = report.repeated;
  answer["missing_markers"] = report.missing;
  answer["by_shape"] = report.by_shape;
  answer["rest_frame"] = report.rest_frame;
  answer["error_median"] = report.error_median;
  answer["error_p95"] = report.error_p95;
  answer["error_median_mm"] = report.error_median_mm;
  answer["error_p95_mm"] = report.error_p95_mm;
  const auto range = [](const MotionCoverage::Reach& reach) {
    return Console::Json{reach.least, reach.most};
  };
  answer["bend_mm"] = range(seen.bend_mm());
  answer["sway_mm"] = range(seen.sway_mm());
  answer["twist_deg"] = range(seen.twist_deg());
  answer["covered"] = seen.covered();
  answer["remarks"] = in_english(report.remarks);
  answer["warnings"] = in_english(report.warnings);
}

/// "12-40" or "12"; nullopt: neither.
std::optional<FrameRange> frame_range(const std::string& text) {
  FrameRange range;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, range.first);
  if (first.ec != std::errc() || range.first < 0) return std::nullopt;
  range.last = range.first;
  if (first.ptr == end) return range;
  if (*first.ptr != '-') return std::nullopt;
  const auto last = std::from_chars(first.ptr + 1, end, range.last);
  if (last.ec != std::errc() || last.ptr != end || range.last < range.first) return std::nullopt;
  return range;
}

void add_ranges(CLI::App& command, const char* flag, const char* help,
                const std::shared_ptr<ReferenceOptions>& options,
                std::vector<FrameRange> ReferenceChoices::*ranges) {
  command
      .add_option_function<std::vector<std::string>>(
          flag,
          [options, ranges](const std::vector<std::string>& texts) {
            for (const std::string& text : texts)
              if (const auto range = frame_range(text))
                (options->choices.*ranges).push_back(*range);
          },
          help)
      ->type_name("FIRST-LAST")
      ->delimiter(',')
      ->check([](const std::string& text) {
        return frame_range(text) ? std::string()
                                 : fmt::format("'{}' is not a range of frames such as 12-40", text);
      });
}

}  // namespace

Status run_reference(const ReferenceOptions& options, Console& console) {
  const auto finger = open_finger(options.finger, console);
  if (!finger) return finger.error();
  if ((*finger)->finger.face.kind == FaceKind::kFlat) return run_flat(options, console);
  const auto report = set_reference(options.finger, options.inputs, console.job(), options.choices);
  if (!report) return report.error();
  print_report(*report, console);
  return {};
}

void add_reference(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ReferenceOptions>();
  CLI::App* command = add_command(program, "reference");
  command->add_option("FINGER", options->finger, "The finger's folder")->required();
  command->add_option("RECORDING", options->inputs, "Video, folder of images, or images")
      ->required();
  const auto need = [&](const char* flag, double& value, const char* help) {
    command->add_option(flag, value, help)
        ->transform(typed_number(0.1, 100.0))
        ->capture_default_str();
  };
  need("--bend-mm", options->choices.need.bend_mm,
       "Bend of the tip in a grasp, to and from the camera, mm; motion that the recording lacks is "
       "reported");
  need("--sway-mm", options->choices.need.sway_mm, "Sway of the tip in a grasp, to each side, mm");
  need("--twist-deg", options->choices.need.twist_deg,
       "Twist of the tip in a grasp, in each direction, degrees");
  command
      ->add_option("--rest-frame", options->choices.rest_frame,
                   "Frame of the recording that shows the finger at rest, counted from 0 (default: "
                   "the middle of all poses)")
      ->type_name("N")
      ->transform(typed_integer(0, std::numeric_limits<int>::max()));
  add_ranges(
      *command, "--keep-frames",
      "Frames to use as untouched, whatever the analysis finds: 12-40, or several with commas",
      options, &ReferenceChoices::keep);
  add_ranges(*command, "--leave-out-frames", "Frames to leave out: 12-40, or several with commas",
             options, &ReferenceChoices::leave_out);
  command->add_flag("--skin-changed", options->choices.skin_was_changed,
                    "States that the skin was cleaned, painted or replaced since the earlier "
                    "reference, which then cannot reveal contacts");
  command->callback([=, &chosen] {
    chosen = [=](Console& console) { return run_reference(*options, console); };
  });
}

}  // namespace alltact
