#include "app/commands/commands.h"
#include "app/commands/opencv_threads.h"
#include "app/commands/reconstruct_part.h"
#include "app/commands/recorded_depth.h"
#include "app/commands/result_files.h"
#include "app/commands/stored_settings.h"
#include "app/console/camera_remarks.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "app/console/number_flags.h"
#include "calibration/finger/paper_pipeline.h"
#include "calibration/reference/settings_record.h"
#include "core/batch/batch.h"
#include "core/io/atomic_file.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/result_json.h"
#include "core/sources/newest_source.h"
#include "core/sources/open/open_source.h"

#include <set>

#include <fmt/format.h>
#include <opencv2/core/utility.hpp>

namespace alltact {
namespace {

/// The state of a run.
struct Progress {
  std::string lines;               ///< of results.jsonl
  std::vector<std::string> parts;  ///< used instead, where only a part is requested
  std::size_t index = 0;           ///< frames seen
  std::size_t failed = 0;
  double total_ms = 0;
};

/// A live frame's line, or the line with the reason why there is none.
std::string live_line(const Result<FramePtr>& frame,
                      Pipeline& pipeline,
                      const ReconstructOptions& options,
                      Progress& progress) {
  const std::string name = frame ? (*frame)->name : frame_name(frame.error(), progress.index);
  Error problem;
  if (frame) {
    if (const auto result = pipeline(*frame)) {
      progress.failed += result->depth ? 0 : 1;
      return result_line(*result, progress.index, reference_method(options));
    } else {
      problem = result.error();
    }
  } else {
    problem = frame.error();
  }
  ++progress.failed;
  return failure_line(name, progress.index, {as_sentence(problem)});
}

/// One line a frame on standard output until the source ends or somebody stops it. Frames that come
/// faster than they are measured are skipped.
Status reconstruct_live(std::unique_ptr<Source> source,
                        Pipeline& pipeline,
                        const ReconstructOptions& options,
                        Console& console) {
  CameraRemarks remarks(*source);
  NewestSource newest(std::move(source));
  Progress progress;
  Message last_difference;  // of the settings: each difference is reported once
  for (; !console.job().stop_requested(); ++progress.index) {
    const auto frame = newest.next();
    if (frame && !*frame) break;
    remarks.report(console);
    if (frame) {
      const Message other = other_settings_than_stored(**frame, pipeline.finger());
      if (!other.empty() && other != last_difference)
        console.warn(fmt::format("Warning: {}", other));
      last_difference = other;
    }
    const Status status = console.put(live_line(frame, pipeline, options, progress));
    if (!status) return status;
  }
  console.warn(fmt::format("{} frames, {} of them without depth; {} skipped to keep up.",
                           progress.index,
                           progress.failed,
                           newest.skipped()));
  return {};
}

/// 0: all cores that this process may use.
int threads_of(int requested) {
  if (requested > 0) return requested;
  constexpr int kMost = 64;
  return std::clamp(cv::getNumberOfCPUs(), 1, kMost);
}

/// The figures of a run, once its files are there.
Status print_summary(const Progress& progress, const Path& results, Console& console) {
  const std::size_t done = progress.index - progress.failed;
  const double mean_ms = done > 0 ? progress.total_ms / static_cast<double>(done) : 0.0;
  console.say(fmt::format("{} of {} frames reconstructed, {:.1f} ms each; results in {}",
                          done,
                          progress.index,
                          mean_ms,
                          results.parent_path().string()));
  Console::Json& answer = console.answer();
  answer["frames"] = progress.index;
  answer["failed"] = progress.failed;
  answer["results"] = results.string();
  if (console.job().stop_requested())
    return Error{en::say("stopped before all frames were done"), "", ""};
  if (progress.failed > 0) {
    return Error{
        en::say(
            "{} of {} frames could not be reconstructed; each is named above and in results.jsonl",
            progress.failed,
            progress.index),
        "",
        ""};
  }
  return {};
}

/// One pipeline for each thread. They share the large data (ReferenceLibrary::load).
Result<std::vector<Pipeline>> make_pipelines(const FingerSnapshot& finger,
                                             const ReconstructOptions& options,
                                             const Job& job) {
  // 3D images are drawn by one thread.
  const int thread_count = options.image || options.live ? 1 : threads_of(options.threads);
  std::vector<Pipeline> pipelines;
  while (pipelines.size() < static_cast<std::size_t>(thread_count)) {
    auto pipeline = options.as_paper ? paper_pipeline(finger, job)
                                     : Pipeline::create(finger, options.pipeline, job);
    if (!pipeline) return pipeline.error();
    pipelines.push_back(std::move(*pipeline));
    if (pipelines.front().has_long_memory()) break;
  }
  return pipelines;
}

Status reconstruct_all(Source& source,
                       std::vector<Pipeline>& pipelines,
                       const ReconstructOptions& options,
                       const BatchFrames& frames,
                       Progress& progress,
                       Console& console) {
  const auto files = ResultFiles::create(options);
  if (!files) return files.error();
  std::unique_ptr<RecordedDepth> video;
  if (options.depth_video) {
    auto made =
        RecordedDepth::create(options, pipelines.front().camera().size(), source.frames_per_s());
    if (!made) return made.error();
    video = std::move(*made);
  }
  std::set<std::string> names;
  ContactLines contacts(source.is_continuous());
  const double count =
      static_cast<double>(std::min(source.count().value_or(0), frames.end) - frames.first);
  BatchWork work;
  work.inspect = [&](BatchFrame& frame) {
    if (frame.frame && !names.insert(frame.frame->name).second)
      frame.problem = Error{en::say("another picture is called '{}' as well", frame.frame->name),
                            frame.frame->origin,
                            en::say("giving the pictures different names")};
  };
  work.write = [&](BatchFrame& frame, const Pipeline& pipeline) -> Result<FrameLine> {
    auto line = files->write(frame, pipeline);
    if (line && video)
      if (const Status made = video->compress(frame, *line); !made) return made.error();
    return line;
  };
  work.take = [&](std::size_t index, FrameLine&& line) -> Status {
    for (const std::string& warning : line.warnings) console.warn(warning);
    if (video)
      if (Status written = video->take(line); !written) return written;
    if (options.part)
      progress.parts.push_back(line.to_json());
    else
      progress.lines += contacts(line) + "\n";
    progress.index = index + 1 - frames.first;
    progress.failed += line.is_measured ? 0 : 1;
    progress.total_ms += line.total_ms;
    if (count > 0)
      console.job().report(static_cast<double>(progress.index) / count,
                           en::say("{} of {:.0f}: {}", progress.index, count, line.frame));
    return {};
  };
  const Status measured = measure_batch(source, pipelines, frames, work, console.job());
  return measured && video ? video->finish() : measured;
}

}  // namespace

Status run_reconstruct(const ReconstructOptions& options, Console& console) {
  if (options.live && console.json())
    return Error{en::say("--live gives a line of JSON for each frame already"),
                 "",
                 en::say("without --json")};
  // Each thread has frames of its own.
  set_opencv_threads(options.live ? threads_of(options.threads) : 1);
  const auto finger = open_finger(options.finger, console);
  if (!finger) return finger.error();
  if (!(*finger)->mapping) {
    return Error{en::say("the finger is not calibrated yet"),
                 (options.finger / Finger::kFileName).string(),
                 en::say("alltact calibrate with ball presses")};
  }
  SourceOptions how;
  how.pace = options.live ? Pace::kRecorded : Pace::kOnDemand;
  how.job = &console.job();
  auto source = open_source(options.inputs, how);
  if (!source) return source.error();
  auto pipelines = make_pipelines(**finger, options, console.job());
  if (!pipelines) return pipelines.error();
  if (options.live)
    return reconstruct_live(std::move(*source), pipelines->front(), options, console);
  if (const Status status = make_folder(options.folder); !status) return status;

  Progress progress;
  const auto frames = requested_frames(options, **source, pipelines->front());
  if (!frames) return frames.error();
  const bool is_continuous = (*source)->is_continuous();
  const std::size_t count = (*source)->count().value_or(0);
  Status status = reconstruct_all(**source, *pipelines, options, *frames, progress, console);
  if (!status) return status;
  if (status = sync_disk_of(options.folder); !status) return status;
  const Path results =
      options.folder / (options.part ? part_file(*options.part) : std::string("results.jsonl"));
  status = options.part ? write_part(options.folder,
                                     {*options.part,
                                      name_of_run(options, count),
                                      frames->first,
                                      count,
                                      is_continuous,
                                      std::move(progress.parts)})
                        : write_file_atomically(results, progress.lines);
  if (!status) return status;
  return print_summary(progress, results, console);
}

void add_reconstruct(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ReconstructOptions>();
  auto formats =
      std::make_shared<std::vector<std::string>>(std::vector<std::string>{"depth", "flags"});
  auto method = std::make_shared<std::string>("ours");
  CLI::App* command = add_command(program, "reconstruct");
  command->add_option("FINGER", options->finger, "The finger's folder")->required();
  command
      ->add_option(
          "INPUT", options->inputs, "Pictures, folders of them, a video, a scene, or a camera")
      ->required();
  CLI::Option* output =
      command->add_option("-o,--output", options->folder, "Folder for the results")
          ->type_name("DIR");
  CLI::Option* live =
      command
          ->add_flag("--live",
                     options->live,
                     "At the pace of the camera or the recording, a line of results.jsonl for each "
                     "frame on standard output instead of files, until Ctrl-C; frames that come "
                     "too fast are skipped")
          ->excludes(output);
  command
      ->add_option(
          "--format",
          *formats,
          "Files per frame, with commas: depth (float TIFF, mm), depth16 (16-bit PNG of whole "
          "micrometres: depth_mm = 0.001 (value - 10000), 0: none), depth-video (the same of all "
          "frames "
          "in one file, depth.mkv, without loss: FFV1), depth_sd (how sure each pixel "
          "is, "
          "one standard deviation in mm), sd_causes (the same by cause: NAME.sd_noise.tiff, "
          "sd_mapping, "
          "sd_reference, sd_light, sd_lateral), flags (8-bit PNG: 0 measured, 1 off the face, 2 "
          "too "
          "dark, 3 "
          "saturated, 4 darker than calibrated, 5 at the layer's thickness: at least that deep, 6 "
          "not in the recording, 7 its end hidden, 8 bulging by the layer's thickness or more), "
          "limits (8-bit PNG, bits: 1 at the layer's thickness, 2 bulging by that, 4 darker than "
          "calibrated, 8 steep: a pixel sideways changes the depth by more than its standard "
          "deviation, 16 doubtful light), "
          "points "
          "(float TIFF, x y z in mm), and meshes of the face for other programs: ply, vtp, stl, "
          "glb "
          "(default depth,flags)")
      ->type_name("LIST")
      ->delimiter(',')
      ->take_all()
      ->expected(1)
      ->check(CLI::IsMember({"depth",
                             "depth16",
                             "depth-video",
                             "depth_sd",
                             "sd_causes",
                             "flags",
                             "limits",
                             "points",
                             "ply",
                             "vtp",
                             "stl",
                             "glb"}))
      ->excludes(live);
  command
      ->add_flag("--picture",
                 options->image,
                 "Also a picture of the face in 3D per frame, NAME.3d.png; needs no display")
      ->excludes(live);
  command
      ->add_option("--picture-from",
                   options->viewpoint,
                   "Where pictures are looked at from (default tilted)")
      ->type_name("tilted|camera|outside|side")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, Viewpoint>{{"tilted", Viewpoint::kTilted},
                                                                   {"camera", Viewpoint::kCamera},
                                                                   {"outside", Viewpoint::kOutside},
                                                                   {"side", Viewpoint::kSide}}));
  command
      ->add_option("--picture-top-mm",
                   options->scene.top_mm,
                   "Depth at which the colours of pictures end (default 1)")
      ->type_name("MM")
      ->transform(typed_number(0.1, 10.0));
  command
      ->add_option_function<std::string>(
          "--shard",
          [=](const std::string& text) {
            const auto part = part_of(text);
            if (!part) throw CLI::ValidationError("--shard", part.error().what.english());
            options->part = *part;
          },
          "Only part K of N of the frames; `alltact merge` brings the parts together, the same as "
          "without")
      ->type_name("K/N")
      ->excludes(live);
  command
      ->add_option(
          "--method",
          *method,
          "paper: the source paper's whole method, with its own calibration from the presses "
          "that the finger keeps, to compare with (default ours)")
      ->type_name("ours|paper")
      ->check(CLI::IsMember({"ours", "paper"}));
  command
      ->add_option("--threads",
                   options->threads,
                   "The result is the same for any number (1 to 64; default all cores)")
      ->type_name("N")
      ->transform(typed_integer(1, 64));
  command
      ->add_option("--preset",
                   options->preset,
                   "Measure with settings that a study found for this finger (alltact study FINGER "
                   "--save), or as it was calibrated (default: what the finger uses)")
      ->type_name("fast|balanced|finest|calibrated");
  SettingFlags<PipelineSettings> pipeline;
  pipeline.add_to(*command, pipeline_settings());
  command->callback([=, &chosen] {
    if (!options->live && output->empty()) throw CLI::RequiredError("--output or --live");
    const auto wants = [&](const char* word) {
      return std::find(formats->begin(), formats->end(), word) != formats->end();
    };
    options->depth = wants("depth");
    options->depth16 = wants("depth16");
    options->depth_video = wants("depth-video");
    options->depth_sd = wants("depth_sd");
    options->sd_causes = wants("sd_causes");
    options->flags = wants("flags");
    options->limits = wants("limits");
    options->points = wants("points");
    for (const char* kind : {"ply", "vtp", "stl", "glb"})
      if (wants(kind)) options->surfaces.emplace_back(kind);
    const bool is_paper = *method == "paper";
    options->as_paper = is_paper;
    if (is_paper) {
      const char* none = "the source paper's method has none of these settings";
      pipeline.refuse_all(none);
      if (!options->preset.empty()) throw CLI::ValidationError("--preset", none);
    }
    chosen = [=](Console& console) -> Status {
      if (is_paper) return run_reconstruct(*options, console);
      const auto stored = stored_settings(options->finger, options->preset);
      if (!stored) return stored.error();
      options->pipeline = pipeline.applied_to(*stored);
      warn_of_other_settings(*stored, options->pipeline, console);
      return run_reconstruct(*options, console);
    };
  });
}

}  // namespace alltact
