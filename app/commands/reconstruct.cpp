// The files that `alltact reconstruct` writes for each frame, besides results.jsonl.
#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "app/figures/figures.h"
#include "calibration/finger/paper_pipeline.h"
#include "calibration/reference/reference_recording.h"
#include "core/base/atomic_file.h"
#include "core/batch/batch.h"
#include "core/batch/parts.h"
#include "core/image/image_file.h"
#include "core/mesh/surface_file.h"
#include "core/open/open_source.h"
#include "core/recording/depth_video.h"
#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/face/rectified_map.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/result_json.h"
#include "core/sources/source.h"

#include <cassert>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <opencv2/core/utility.hpp>

namespace alltact {
namespace {

/// Any thread may write, except 3D images, which belong to the thread that made this.
class ResultFiles {
 public:
  /// `options` outlives it.
  [[nodiscard]] static Result<ResultFiles> create(const ReconstructOptions& options);

  /// Writes the complete files of one frame without waiting for the disk (write_file_unsynced), and
  /// returns its line. Error: they cannot be written, nor could those of others.
  [[nodiscard]] Result<FrameLine> write(BatchFrame& frame, const Pipeline& pipeline) const;

 private:
  explicit ResultFiles(const ReconstructOptions& options) : options_(&options) {}
  [[nodiscard]] Status write_maps(const FrameResult& result, const Pipeline& pipeline) const;
  [[nodiscard]] Status write_sd(const FrameResult& result, const Finger& finger) const;
  [[nodiscard]] Status write_surfaces(const FrameResult& result, const Finger& finger) const;
  [[nodiscard]] Path file(const FrameResult& result, const std::string& ending) const;

  const ReconstructOptions* options_;
  std::unique_ptr<FaceRenderer> faces_;  // where 3D images are requested
};

/// As results.jsonl names it.
ReferenceMethod reference_method(const ReconstructOptions& options) {
  return options.as_paper ? ReferenceMethod::kNearest : options.pipeline.reference;
}

FrameLine failed(const std::string& name, std::size_t index, const Error& problem) {
  FrameLine line;
  line.frame = name;
  line.line = failure_line(name, index, {as_sentence(problem)});
  line.warnings = {problem.sentence()};
  return line;
}

/// Adds to a line, as `name`, where its depth in integer steps (image_file.h) is, and the unit of
/// these.
///   where: members of a JSON object
void add_depth_steps(std::string& line, const std::string& name, const std::string& where) {
  const std::size_t at = line.rfind(",\"times_ms\":");
  assert(at != std::string::npos);
  line.insert(at, fmt::format(",\"{}\":{{{},\"mm_per_step\":{},\"zero_at\":{},\"none\":0}}", name,
                              where, kDepthStep_mm, kDepthZero));
}

Result<ResultFiles> ResultFiles::create(const ReconstructOptions& options) {
  ResultFiles files(options);
  if (!options.image) return files;
  const auto drawing = load_figures();
  if (!drawing) return drawing.error();
  auto faces = (*drawing)->faces({1280, 720}, options.scene, options.viewpoint);
  if (!faces) return faces.error();
  files.faces_ = std::move(*faces);
  return files;
}

Path ResultFiles::file(const FrameResult& result, const std::string& ending) const {
  return options_->folder / (result.frame->name + ending);
}

Result<FrameLine> ResultFiles::write(BatchFrame& frame, const Pipeline& pipeline) const {
  if (!frame.result) {
    const Error problem = frame.problem.value_or(Error());
    return failed(frame.frame ? frame.frame->name : frame_name(problem, frame.index), frame.index,
                  problem);
  }
  const FrameResult& result = *frame.result;
  FrameLine line;
  line.frame = result.frame->name;
  line.line = result_line(result, frame.index, reference_method(*options_));
  line.is_measured = result.depth.has_value();
  line.total_ms = result.times_ms.total;
  line.evidence = result.evidence;
  if (!result.depth) {
    for (const Message& problem : result.problems)
      line.warnings.push_back(fmt::format("{}: {}", result.frame->name, problem));
    return line;
  }
  if (options_->depth16) add_depth_steps(line.line, "depth16", "\"in\":\"png\"");
  if (const Status status = write_maps(result, pipeline); !status) return status.error();
  if (const Status status = write_sd(result, pipeline.finger()); !status) return status.error();
  if (const Status status = write_surfaces(result, pipeline.finger()); !status)
    return status.error();
  return line;
}

Status ResultFiles::write_maps(const FrameResult& result, const Pipeline& pipeline) const {
  const cv::Mat& depth = result.depth->depth_mm;
  if (options_->depth)
    if (Status status = write_file_unsynced(file(result, ".depth.tiff"), depth_tiff(depth));
        !status)
      return status;
  if (options_->depth16)
    if (Status status = write_file_unsynced(file(result, ".depth16.png"), depth_png(depth));
        !status)
      return status;
  if (options_->rectified) {
    const RectifiedMap map = rectified_map(depth, *result.shape);
    if (Status status =
            write_file_unsynced(file(result, ".rectified.tiff"), depth_tiff(map.values, map.plane));
        !status)
      return status;
  }
  if (options_->flags)
    if (Status status =
            write_file_unsynced(file(result, ".flags.png"), grey_png(result.depth->flags));
        !status)
      return status;
  if (!faces_) return {};
  const auto image = faces_->image(result, pipeline);
  if (!image) return Error{image.error().what, file(result, ".3d.png"), image.error().advice};
  return write_image(file(result, ".3d.png"), *image);
}

Status ResultFiles::write_sd(const FrameResult& result, const Finger& finger) const {
  if (!options_->depth_sd && !options_->sd_causes && !options_->limits) return {};
  const auto mapping = Mapping::create(*finger.mapping);
  if (!mapping) return mapping.error();
  const auto write = [&](const std::string& ending, const cv::Mat& sd_mm) {
    return write_file_unsynced(file(result, ending), depth_tiff(sd_mm));
  };
  if (options_->depth_sd || options_->limits) {
    const DepthSdAndLimits made =
        depth_sd_and_limits(*result.depth, *result.reference, *result.shape, *mapping);
    if (options_->depth_sd)
      if (Status status = write(".depth_sd.tiff", made.sd_mm); !status) return status;
    if (options_->limits)
      if (Status status = write_file_unsynced(file(result, ".limits.png"), grey_png(made.limits));
          !status)
        return status;
  }
  if (!options_->sd_causes) return {};
  for (const auto& [cause, sd_mm] :
       depth_sd_by_cause(*result.depth, *result.reference, *result.shape, *mapping))
    if (Status status = write(std::string(".sd_") + cause + ".tiff", sd_mm); !status) return status;
  return {};
}

Status ResultFiles::write_surfaces(const FrameResult& result, const Finger& finger) const {
  if (options_->points)
    if (Status status =
            write_image(file(result, ".points.tiff"), contact_face_points_mm(result, finger.face));
        !status)
      return status;
  if (options_->surfaces.empty()) return {};
  const FaceVertices vertices = contact_face_vertices(result, finger.face);
  for (const std::string& kind : options_->surfaces)
    if (Status status =
            write_surface(file(result, "." + kind), vertices.points_mm, vertices.depth_mm);
        !status)
      return status;
  return {};
}

class RecordedDepth {
 public:
  /// In the options' folder; for a part, next to the part's results. Errors: DepthVideoWriter's.
  [[nodiscard]] static Result<std::unique_ptr<RecordedDepth>> create(
      const ReconstructOptions& options, cv::Size size, double frames_per_s);

  /// Adds the compressed depth frame to the line, and its index to the line's text. Any thread.
  [[nodiscard]] Status compress(const BatchFrame& frame, FrameLine& line);
  /// The next depth frame, in the frames' order, one thread at a time.
  [[nodiscard]] Status take(const FrameLine& line) { return video_.add(line.depth_packet); }
  [[nodiscard]] Status finish() { return video_.finish(); }

 private:
  RecordedDepth(cv::Size size, DepthVideoWriter video) : size_(size), video_(std::move(video)) {}

  cv::Size size_;
  DepthVideoWriter video_;
  std::mutex lock_;  // over:
  std::vector<DepthPackets> idle_;
};

Result<std::unique_ptr<RecordedDepth>> RecordedDepth::create(const ReconstructOptions& options,
                                                             cv::Size size, double frames_per_s) {
  const std::string name = options.part ? part_video(*options.part) : std::string(kDepthVideoFile);
  auto video = DepthVideoWriter::create(options.folder / name, size, frames_per_s);
  if (!video) return video.error();
  return std::unique_ptr<RecordedDepth>(new RecordedDepth(size, std::move(*video)));
}

Status RecordedDepth::compress(const BatchFrame& frame, FrameLine& line) {
  std::optional<DepthPackets> packets;
  {
    const std::lock_guard lock(lock_);
    if (!idle_.empty()) {
      packets = std::move(idle_.back());
      idle_.pop_back();
    }
  }
  if (!packets) {
    auto made = DepthPackets::create(size_);
    if (!made) return made.error();
    packets = std::move(*made);
  }
  const bool has_depth = frame.result && frame.result->depth;
  auto packet = packets->packet(has_depth ? depth_steps(frame.result->depth->depth_mm)
                                          : cv::Mat(size_, CV_16UC1, cv::Scalar(0)));
  if (!packet) return packet.error();
  line.depth_packet = std::move(*packet);
  if (has_depth)
    add_depth_steps(line.line, "depth_video",
                    fmt::format("\"file\":\"{}\",\"picture\":{}", kDepthVideoFile, frame.index));
  const std::lock_guard lock(lock_);
  idle_.push_back(std::move(*packets));
  return {};
}

/// Runs with the same name give the same results: same program, finger, settings, requested files,
/// and inputs by name and number of frames.
std::string name_of_run(const ReconstructOptions& options, std::size_t frame_count) {
  std::string all = fmt::format("{} {} {}", ALLTACT_VERSION, options.as_paper, frame_count);
  for (const Path& input : options.inputs) all += " " + input.filename().string();
  for (const bool is_requested :
       {options.depth, options.depth16, options.depth_video, options.depth_sd, options.sd_causes,
        options.flags, options.limits, options.points, options.image, options.rectified})
    all += is_requested ? '1' : '0';
  for (const std::string& kind : options.surfaces) all += " " + kind;
  for (const auto& setting : pipeline_settings())
    all += fmt::format(" {}={}", setting.name, setting.get(options.pipeline));
  if (const auto finger = read_file(options.finger / Finger::kFileName)) all += *finger;
  std::uint64_t sum = 0xcbf29ce484222325U;  // FNV-1a
  for (const char letter : all) sum = (sum ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
  return fmt::format("{:016x}", sum);
}

/// The requested frames. Error: a part of a source without a known number of frames, or of one that
/// cannot be split.
Result<BatchFrames> requested_frames(const ReconstructOptions& options, const Source& source,
                                     const Pipeline& pipeline) {
  if (!options.part) return BatchFrames{};
  const auto count = source.count();
  if (!count)
    return Error{en::say("only recordings can be reconstructed in parts"),
                 options.inputs.front().string(), en::say("record it first")};
  if (pipeline.has_long_memory())
    return Error{options.as_paper
                     ? en::say("the source paper's method follows the markers through all frames, "
                               "so that no part can be measured by itself")
                     : en::say("the finger's force model knows creep, which depends on all frames "
                               "before, so that no part can be measured by itself"),
                 options.finger.string(), en::say("without --shard")};
  return frames_of(*options.part, *count);
}

/// The state of a run.
struct Progress {
  std::string lines;               ///< of results.jsonl
  std::vector<std::string> parts;  ///< used instead, where only a part is requested
  std::size_t index = 0;           ///< frames seen
  std::size_t failed = 0;
  double total_ms = 0;
};

/// A live frame's line, or the line with the reason why there is none.
std::string live_line(const Result<FramePtr>& frame, Pipeline& pipeline,
                      const ReconstructOptions& options, Progress& progress) {
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
Status reconstruct_live(std::unique_ptr<Source> source, Pipeline& pipeline,
                        const ReconstructOptions& options, Console& console) {
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
                           progress.index, progress.failed, newest.skipped()));
  return {};
}

/// The figures of a run, once its files are there.
Status print_summary(const Progress& progress, const Path& results, Console& console) {
  const std::size_t done = progress.index - progress.failed;
  const double mean_ms = done > 0 ? progress.total_ms / static_cast<double>(done) : 0.0;
  console.say(fmt::format("{} of {} frames reconstructed, {:.1f} ms each; results in {}", done,
                          progress.index, mean_ms, results.parent_path().string()));
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
            progress.failed, progress.index),
        "", ""};
  }
  return {};
}

Result<std::vector<Pipeline>> make_pipelines(const FingerSnapshot& finger,
                                             const ReconstructOptions& options, const Job& job) {
  // 3D images are drawn by one thread.
  const int thread_count = options.image || options.live ? 1 : batch_threads(options.threads);
  return batch_pipelines(thread_count, [&] {
    return options.as_paper ? paper_pipeline(finger, job)
                            : Pipeline::create(finger, options.pipeline, job);
  });
}

Status reconstruct_all(Source& source, std::vector<Pipeline>& pipelines,
                       const ReconstructOptions& options, const BatchFrames& frames,
                       Progress& progress, Console& console) {
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
  FingerContactTracker contacts(source.is_continuous());
  const double count =
      static_cast<double>(std::min(source.count().value_or(0), frames.end) - frames.first);
  BatchWork work;
  work.inspect = [&](BatchFrame& frame) {
    if (frame.frame && !names.insert(frame.frame->name).second)
      frame.problem = Error{en::say("another image is called '{}' as well", frame.frame->name),
                            frame.frame->origin, en::say("giving the images different names")};
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
      progress.lines += complete_line(line, contacts) + "\n";
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
    return Error{en::say("--live gives a line of JSON for each frame already"), "",
                 en::say("without --json")};
  // Each thread has frames of its own.
  set_opencv_threads(options.live ? batch_threads(options.threads) : 1);
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
  const std::size_t reported = report_remarks(**source, console);
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
  report_remarks(**source, console, reported);
  if (!status) return status;
  if (status = sync_disk_of(options.folder); !status) return status;
  const Path results =
      options.folder / (options.part ? part_file(*options.part) : std::string("results.jsonl"));
  status = options.part ? write_part(options.folder,
                                     {*options.part, name_of_run(options, count), frames->first,
                                      count, is_continuous, std::move(progress.parts)})
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
      ->add_option("INPUT", options->inputs,
                   "Images, folders of them, a video, a scene, or a camera")
      ->required();
  CLI::Option* output =
      command->add_option("-o,--output", options->folder, "Folder for the results")
          ->type_name("DIR");
  CLI::Option* live =
      command
          ->add_flag(
              "--live", options->live,
              "Prints a line of results.jsonl for each frame instead of writing files, at the pace "
              "of the camera or recording, until Ctrl-C; skips frames that come too fast")
          ->excludes(output);
  command
      ->add_option(
          "--format", *formats,
          "Files per frame, with commas: depth (float TIFF, mm), depth16 (16-bit PNG of integer "
          "micrometres: depth_mm = 0.001 (value - 10000), 0: none), depth-video (the same for all "
          "frames in one lossless file, depth.mkv: FFV1), depth_sd (standard deviation of each "
          "pixel, mm), sd_causes (the same by cause: NAME.sd_noise.tiff, sd_mapping, sd_reference, "
          "sd_light, sd_lateral), flags (8-bit PNG: 0 measured, 1 off the face, 2 too dark, 3 "
          "saturated, 4 darker than calibrated, 5 at the layer's thickness: at least that deep, 6 "
          "not in the recording, 7 end of the face hidden, 8 bulging by the layer's thickness or "
          "more), limits (8-bit PNG, bits: 1 at the layer's thickness, 2 bulging by that, 4 darker "
          "than calibrated, 8 steep: a shift of one pixel changes the depth by more than its "
          "standard deviation, 16 doubtful light), points (float TIFF, x y z in mm), rectified "
          "(float TIFF, depth in mm over the face: columns along it and rows across, 0.1 mm "
          "apart), and meshes of the face for other programs: ply, vtp, stl, glb (default "
          "depth,flags)")
      ->type_name("LIST")
      ->delimiter(',')
      ->take_all()
      ->expected(1)
      ->check(CLI::IsMember({"depth", "depth16", "depth-video", "depth_sd", "sd_causes", "flags",
                             "limits", "points", "rectified", "ply", "vtp", "stl", "glb"}))
      ->excludes(live);
  command
      ->add_flag("--picture", options->image,
                 "Adds a 3D image of the face per frame, NAME.3d.png; needs no display")
      ->excludes(live);
  command
      ->add_option("--picture-from", options->viewpoint,
                   "Viewpoint of the 3D images (default tilted)")
      ->type_name("tilted|camera|outside|side")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, Viewpoint>{{"tilted", Viewpoint::kTilted},
                                                                   {"camera", Viewpoint::kCamera},
                                                                   {"outside", Viewpoint::kOutside},
                                                                   {"side", Viewpoint::kSide}}));
  command
      ->add_option("--picture-top-mm", options->scene.top_mm,
                   "Depth at the end of the colour scale of the 3D images, mm (default 1)")
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
          "Reconstructs only part K of N of the frames; `alltact merge` joins the parts to the "
          "result of a single run")
      ->type_name("K/N")
      ->excludes(live);
  command
      ->add_option("--method", *method,
                   "Method: ours, or paper, the source paper's full method with its own "
                   "calibration from the stored presses (default ours)")
      ->type_name("ours|paper")
      ->check(CLI::IsMember({"ours", "paper"}));
  command
      ->add_option(
          "--threads", options->threads,
          "Number of threads (1 to 64; default all cores); the result does not depend on it")
      ->type_name("N")
      ->transform(typed_integer(1, 64));
  command
      ->add_option("--preset", options->preset,
                   "Settings to measure with: a preset that a study of this finger saved (alltact "
                   "study FINGER --save), or as calibrated (default: what the finger uses)")
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
    options->rectified = wants("rectified");
    for (const char* kind : {"ply", "vtp", "stl", "glb"})
      if (wants(kind)) options->surfaces.emplace_back(kind);
    const bool is_paper = *method == "paper";
    options->as_paper = is_paper;
    if (is_paper) {
      const char* none = "does not apply to the source paper's method";
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

namespace {

/// Merges the parts of a reconstruction (parts.h).
Status run_merge(const std::vector<Path>& folders, Console& console) {
  const auto merged = merge_parts(folders);
  if (!merged) return merged.error();
  console.say(fmt::format("{} frames, {} of them without depth; results in {}", merged->frames,
                          merged->failed, merged->results.parent_path().string()));
  Console::Json& answer = console.answer();
  answer["frames"] = merged->frames;
  answer["failed"] = merged->failed;
  answer["results"] = merged->results.string();
  return {};
}

}  // namespace

void add_merge(CLI::App& program, Chosen& chosen) {
  auto folders = std::make_shared<std::vector<Path>>();
  CLI::App* command = add_command(program, "merge");
  command
      ->add_option("DIR", *folders,
                   "Folders with the parts that `alltact reconstruct --shard` wrote; the results "
                   "go into the first")
      ->required();
  command->callback(
      [=, &chosen] { chosen = [=](Console& console) { return run_merge(*folders, console); }; });
}

}  // namespace alltact
