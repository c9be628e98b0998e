#include "app/commands/commands.h"
#include "app/commands/kept_settings.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "app/pictures/pictures.h"
#include "calibration/finger/paper_pipeline.h"
#include "calibration/reference/settings_record.h"
#include "core/io/atomic_file.h"
#include "core/io/picture.h"
#include "core/io/surface_file.h"
#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/result_json.h"
#include "core/sources/newest_source.h"
#include "core/sources/open/open_source.h"

#include <set>

#include <fmt/format.h>
#include <opencv2/core/utility.hpp>

namespace alltact {
namespace {

/// The lines of results.jsonl as they come, and which frames failed.
struct Progress {
  std::string lines;
  std::size_t index = 0;  ///< frames seen
  std::size_t failed = 0;
  double total_ms = 0;
  std::set<std::string> names;
  std::unique_ptr<FacePictures> faces;  ///< where pictures are wanted
};

/// As results.jsonl names it.
ReferenceMethod reference_method(const ReconstructOptions& options) {
  return options.as_paper ? ReferenceMethod::kNearest : options.pipeline.reference;
}

Status write_files(const FrameResult& result,
                   const Pipeline& pipeline,
                   const ReconstructOptions& options,
                   Progress& progress) {
  const Finger& finger = pipeline.finger();
  const std::string& name = result.frame->name;
  const cv::Mat& depth = result.depth->depth_mm;
  if (options.depth) {
    const Status status = write_picture(options.folder / (name + ".depth.tiff"), depth);
    if (!status) return status;
  }
  if (options.depth_sd) {
    const auto mapping = Mapping::create(*finger.mapping);
    if (!mapping) return mapping.error();
    const Status status =
        write_picture(options.folder / (name + ".depth_sd.tiff"),
                      depth_sd_mm(*result.depth, *result.reference, *result.shape, *mapping));
    if (!status) return status;
  }
  if (options.sd_causes) {
    const auto mapping = Mapping::create(*finger.mapping);
    if (!mapping) return mapping.error();
    for (const auto& [cause, sd_mm] :
         depth_sd_by_cause(*result.depth, *result.reference, *result.shape, *mapping)) {
      const Status status =
          write_picture(options.folder / (name + ".sd_" + cause + ".tiff"), sd_mm);
      if (!status) return status;
    }
  }
  if (options.flags) {
    const Status status =
        write_picture(options.folder / (name + ".flags.png"), result.depth->flags);
    if (!status) return status;
  }
  if (progress.faces) {
    const Path file = options.folder / (name + ".3d.png");
    const auto picture = progress.faces->picture(result, pipeline);
    if (!picture) return Error{picture.error().what, file, picture.error().advice};
    if (const Status status = write_picture(file, *picture); !status) return status;
  }
  if (!options.points && options.surfaces.empty()) return {};
  const cv::Mat points = contact_face_points_mm(result, finger.face);
  if (options.points) {
    const Status status = write_picture(options.folder / (name + ".points.tiff"), points);
    if (!status) return status;
  }
  for (const std::string& kind : options.surfaces) {
    const Status status = write_surface(options.folder / (name + "." + kind), points, depth);
    if (!status) return status;
  }
  return {};
}

/// As the problems of results.jsonl stand there.
Message as_sentence(const Error& error) {
  return en::say("{}.", error.message());
}

void add_failure(const std::string& name,
                 const Error& problem,
                 Progress& progress,
                 Console& console) {
  console.warn(problem.sentence());
  progress.lines += failure_line(name, progress.index, {as_sentence(problem)}) + "\n";
  ++progress.failed;
}

/// One frame from picture to files. Error: files could not be written, so nothing more can be.
Status reconstruct_frame(const FramePtr& frame,
                         Pipeline& pipeline,
                         const ReconstructOptions& options,
                         Progress& progress,
                         Console& console) {
  if (!progress.names.insert(frame->name).second) {
    add_failure(frame->name,
                Error{en::say("another picture is called '{}' as well", frame->name),
                      frame->origin,
                      en::say("giving the pictures different names")},
                progress,
                console);
    return {};
  }
  auto result = pipeline(frame);
  if (!result) {
    add_failure(frame->name, result.error(), progress, console);
    return {};
  }
  progress.total_ms += result->times_ms.total;
  progress.lines += result_line(*result, progress.index, reference_method(options)) + "\n";
  if (!result->depth) {
    for (const Message& problem : result->problems)
      console.warn(fmt::format("{}: {}", frame->name, problem));
    ++progress.failed;
    return {};
  }
  return write_files(*result, pipeline, options, progress);
}

/// Name of a picture that could not be read, from the error that says which it was.
std::string name_of(const Error& error, std::size_t index) {
  const std::string stem = Path(error.where.english()).stem().string();
  return stem.empty() ? fmt::format("frame_{:05}", index) : stem;
}

Status reconstruct_all(Source& source,
                       Pipeline& pipeline,
                       const ReconstructOptions& options,
                       Progress& progress,
                       Console& console) {
  const double count = static_cast<double>(source.count().value_or(0));
  for (;; ++progress.index) {
    if (console.job().stop_requested()) return {};
    if (!source.is_continuous()) pipeline.forget();
    const auto frame = source.next();
    if (!frame) {
      add_failure(name_of(frame.error(), progress.index), frame.error(), progress, console);
      continue;
    }
    if (!*frame) return {};
    if (count > 0) {
      console.job().report(static_cast<double>(progress.index) / count,
                           en::say("{} of {:.0f}: {}", progress.index + 1, count, (*frame)->name));
    }
    const Status status = reconstruct_frame(*frame, pipeline, options, progress, console);
    if (!status) return status;
  }
}

/// A live frame's line, or the line that says why there is none.
std::string live_line(const Result<FramePtr>& frame,
                      Pipeline& pipeline,
                      const ReconstructOptions& options,
                      Progress& progress) {
  const std::string name = frame ? (*frame)->name : name_of(frame.error(), progress.index);
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

/// One line a frame on standard output until the source ends or somebody stops it. Frames that
/// come faster than they are measured are skipped.
Status reconstruct_live(std::unique_ptr<Source> source,
                        Pipeline& pipeline,
                        const ReconstructOptions& options,
                        Console& console) {
  NewestSource newest(std::move(source));
  Progress progress;
  Message told;  // of the settings: each difference once
  for (; !console.job().stop_requested(); ++progress.index) {
    const auto frame = newest.next();
    if (frame && !*frame) break;
    if (frame) {
      const Message other = other_settings_than_stored(**frame, pipeline.finger());
      if (!other.empty() && other != told) console.warn(fmt::format("Warning: {}", other));
      told = other;
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

}  // namespace

Status run_reconstruct(const ReconstructOptions& options, Console& console) {
  if (options.live && console.json())
    return Error{en::say("--live gives a line of JSON for each frame already"),
                 "",
                 en::say("without --json")};
  cv::setNumThreads(options.threads);
  const auto finger = open_finger(options.finger, console);
  if (!finger) return finger.error();
  if (!(*finger)->mapping) {
    return Error{en::say("the finger is not calibrated yet"),
                 (options.finger / Finger::kFileName).string(),
                 en::say("alltact calibrate with ball presses")};
  }
  SourceOptions how;
  how.pace = options.live ? Pace::kRecorded : Pace::kAsked;
  how.job = &console.job();
  auto source = open_source(options.inputs, how);
  if (!source) return source.error();
  auto pipeline = options.as_paper ? paper_pipeline(**finger, console.job())
                                   : Pipeline::create(**finger, options.pipeline, console.job());
  if (!pipeline) return pipeline.error();
  if (options.live) return reconstruct_live(std::move(*source), *pipeline, options, console);
  if (const Status status = make_folder(options.folder); !status) return status;

  Progress progress;
  if (options.picture) {
    const auto pictures = load_pictures();
    if (!pictures) return pictures.error();
    auto faces = (*pictures)->faces({1280, 720}, options.scene, options.standpoint);
    if (!faces) return faces.error();
    progress.faces = std::move(*faces);
  }
  Status status = reconstruct_all(**source, *pipeline, options, progress, console);
  if (!status) return status;
  const Path results = options.folder / "results.jsonl";
  status = write_file_atomically(results, progress.lines);
  if (!status) return status;
  const std::size_t done = progress.index - progress.failed;
  const double mean_ms = done > 0 ? progress.total_ms / static_cast<double>(done) : 0.0;
  console.say(fmt::format("{} of {} frames reconstructed, {:.1f} ms each; results in {}",
                          done,
                          progress.index,
                          mean_ms,
                          options.folder.string()));
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

void add_reconstruct(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ReconstructOptions>();
  auto formats = std::make_shared<std::vector<std::string>>(
      std::vector<std::string>{"depth", "flags", "points"});
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
          "Files per frame, with commas: depth (float TIFF, mm), depth_sd (how sure each pixel is, "
          "one standard deviation in mm), sd_causes (the same by cause: NAME.sd_noise.tiff, "
          "sd_mapping, "
          "sd_reference, sd_light, sd_lateral), flags (8-bit PNG: 0 measured, 1 off the face, 2 "
          "too "
          "dark, 3 "
          "saturated, 4 darker than calibrated, 5 beyond the layer, 6 not in the recording), "
          "points "
          "(float TIFF, x y z in mm), and meshes of the face for other programs: ply, vtp, stl, "
          "glb "
          "(default depth,flags,points)")
      ->type_name("LIST")
      ->delimiter(',')
      ->take_all()
      ->expected(1)
      ->check(CLI::IsMember(
          {"depth", "depth_sd", "sd_causes", "flags", "points", "ply", "vtp", "stl", "glb"}))
      ->excludes(live);
  command
      ->add_flag("--picture",
                 options->picture,
                 "Also a picture of the face in 3D per frame, NAME.3d.png; needs no display")
      ->excludes(live);
  command
      ->add_option("--picture-from",
                   options->standpoint,
                   "Where pictures are looked at from (default tilted)")
      ->type_name("tilted|camera|outside|side")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Standpoint>{{"tilted", Standpoint::kTilted},
                                            {"camera", Standpoint::kCamera},
                                            {"outside", Standpoint::kOutside},
                                            {"side", Standpoint::kSide}}));
  command
      ->add_option("--picture-top-mm",
                   options->scene.top_mm,
                   "Depth at which the colours of pictures end (default 1)")
      ->type_name("MM")
      ->check(CLI::Range(0.1, 10.0));
  command
      ->add_option(
          "--method",
          *method,
          "paper: the source paper's whole method, with its own calibration from the presses "
          "that the finger keeps, to compare with (default ours)")
      ->type_name("ours|paper")
      ->check(CLI::IsMember({"ours", "paper"}));
  add_threads_flag(*command, options->threads);
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
    options->depth_sd = wants("depth_sd");
    options->sd_causes = wants("sd_causes");
    options->flags = wants("flags");
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
      const auto kept = kept_settings(options->finger, options->preset);
      if (!kept) return kept.error();
      options->pipeline = pipeline.applied_to(*kept);
      warn_of_other_settings(*kept, options->pipeline, console);
      return run_reconstruct(*options, console);
    };
  });
}

}  // namespace alltact
