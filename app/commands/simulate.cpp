#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "calibration/twin/twin.h"
#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/image/image_file.h"
#include "core/recording/video_file.h"
#include "core/simulation/effect_catalogue.h"
#include "core/simulation/plan.h"
#include "core/simulation/scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace alltact {
namespace {

struct SimulateFitOptions {
  Path finger;
  std::vector<Path> presses;    ///< empty: those stored with the finger
  std::vector<Path> untouched;  ///< empty: the finger's own reference
  double ball_radius_mm = 0;    ///< 0: that of the finger's presses
  Path scene;                   ///< to be written
};

constexpr const char* kTruthFile = "truth.json";
constexpr const char* kVideoFile = "frames.mkv";
constexpr int kTimedFrames = 15;

std::string frame_name(int frame) { return fmt::format("frame_{:05}", frame); }

bool is_own_output(const std::string& name) {
  return name.starts_with("frame_") || name == kVideoFile || name == kTruthFile;
}

/// A folder that is new, empty or an earlier simulation. Frames of that are removed, so that a
/// shorter run does not leave the rest of a longer one.
Status prepare_folder(const Path& folder) {
  std::error_code failed;
  if (!std::filesystem::exists(folder, failed)) return make_folder(folder);
  const bool earlier = std::filesystem::exists(folder / kTruthFile, failed);
  std::vector<Path> old;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
    if (!is_own_output(entry.path().filename().string())) continue;
    if (!earlier) {
      return Error{en::say("it holds {}, which is not of an earlier simulation",
                           entry.path().filename().string()),
                   folder.string(), en::say("another folder")};
    }
    old.push_back(entry.path());
  }
  for (const Path& path : old) std::filesystem::remove(path, failed);
  return make_folder(folder);
}

std::string new_command(const Finger& finger, const Path& camera_file) {
  std::string text = fmt::format("alltact new FINGER --camera {} --layer-mm {}",
                                 camera_file.string(), finger.face.layer_mm);
  if (finger.face.kind == FaceKind::kFlat)
    return text + fmt::format(" --kind flat --plane-z-mm {}", finger.face.plane_z_mm);
  return text +
         fmt::format(" --width-mm {} --per-row {}", finger.face.width_mm, finger.markers.per_row);
}

Console::Json finger_json(const Finger& finger) {
  Console::Json json;
  json["kind"] = finger.face.kind == FaceKind::kFlat ? "flat" : "fin_ray";
  if (finger.face.kind == FaceKind::kFlat) {
    json["plane_z_mm"] = finger.face.plane_z_mm;
  } else {
    json["width_mm"] = finger.face.width_mm;
    json["per_row"] = finger.markers.per_row;
  }
  json["layer_mm"] = finger.face.layer_mm;
  json["camera"] = "camera.yaml";
  return json;
}

/// One line for each effect, in the order they run.
void explain(const Scene& scene, const Plan& plan, Console& console) {
  console.say(fmt::format("{}: {} frames, {:g} per second.", scene.name, plan.frame_count(),
                          plan.frames_per_s()));
  console.say(scene.why);
  Console::Json& answer = console.answer();
  answer["scene"] = scene.name;
  answer["why"] = scene.why;
  answer["frames"] = plan.frame_count();
  answer["frames_per_s"] = plan.frames_per_s();
  Console::Json& effects = answer["effects"] = Console::Json::array();
  for (const Plan::Entry& entry : plan.entries()) {
    const std::string sentence = entry.sentence.english();
    console.say(fmt::format("{:<14} frames {} to {}{}{}", entry.name, entry.first, entry.last,
                            sentence.empty() ? "" : ": ", sentence));
    effects.push_back(
        {{"name", entry.name}, {"first", entry.first}, {"last", entry.last}, {"what", sentence}});
  }
}

Status write_truth_images(const Path& folder, const std::string& name, const Truth& truth) {
  const Status status = write_image(folder / (name + ".depth.tiff"), truth.depth_mm);
  if (!status) return status;
  return write_image(folder / (name + ".z.tiff"), truth.untouched_z_mm);
}

Status write_truth_maps(const Path& folder, const std::string& name, const TruthMaps& maps) {
  const std::pair<std::string_view, const cv::Mat*> images[] = {
      {".contact.png", &maps.contact},
      {".seen.png", &maps.labels},
      {".normal.tiff", &maps.normal},
      {".untouched.tiff", &maps.untouched_grey}};
  for (const auto& [end, image] : images) {
    const Status status = write_image(folder / (name + std::string(end)), *image);
    if (!status) return status;
  }
  return {};
}

/// Renders every frame that arrives, passes it to `take`, writes its truth and adds it to `frames`.
template <class Take>
Status render_all(const SimulateOptions& options, const Plan& plan, int count,
                  Console::Json& frames, Console& console, Take take) {
  for (int frame = 0; frame < count; ++frame) {
    if (console.job().stop_requested())
      return Error{en::say("stopped before all frames were rendered"), "", ""};
    if (plan.arrival(frame).is_dropped) continue;
    // Image files have their own numbers; a video's frames are counted.
    const std::string name = frame_name(options.video ? static_cast<int>(frames.size()) : frame);
    console.job().report(static_cast<double>(frame) / count, en::say("rendering {}", name));
    if (const Status status = take(name, plan.render(frame, options.threads)); !status)
      return status;
    const Truth truth = plan.truth(frame);
    if (const Status status = write_truth_images(options.folder, name, truth); !status)
      return status;
    if (options.maps) {
      const Status status = write_truth_maps(options.folder, name, plan.truth_maps(frame));
      if (!status) return status;
    }
    Console::Json entry = Console::Json::parse(truth.to_json());
    entry["frame"] = name;
    frames.push_back(std::move(entry));
  }
  return {};
}

Status write_video(const SimulateOptions& options, const Plan& plan, int count,
                   Console::Json& frames, Console& console, const Path& file) {
  std::optional<VideoWriter> writer;
  const auto take = [&](const std::string& name, const cv::Mat& image) -> Status {
    Frame frame;
    frame.grey = image;
    frame.name = name;
    frame.origin = options.scene.string();
    if (!writer) {
      auto made = VideoWriter::create(file, frame, VideoCodec::kMagicYuv, plan.frames_per_s());
      if (!made) return made.error();
      writer = std::move(*made);
    }
    return writer->add(frame);
  };
  const Status status = render_all(options, plan, count, frames, console, take);
  return status && writer ? writer->finish() : status;
}

/// Prints the time of every effect of the simulation on this computer.
Status run_simulate_costs(int frames, Console& console) {
  const auto costs = measure_effect_costs(frames, console.job());
  if (!costs) return costs.error();
  console.say("Time of each effect per frame, ms per million pixels, one thread:");
  Console::Json& list = console.answer()["costs"] = Console::Json::array();
  for (const EffectCost& cost : *costs) {
    const std::string_view stage = to_string(cost.kind->stage);
    console.say(
        fmt::format("{:<20} {:<10} {:9.3f}", cost.kind->name, stage, cost.ms_per_megapixel));
    list.push_back({{"effect", cost.kind->name},
                    {"stage", stage},
                    {"example", cost.kind->example},
                    {"ms_per_megapixel", cost.ms_per_megapixel}});
  }
  return {};
}

Console::Json effect_json(const EffectDescription& effect) {
  Console::Json json{{"name", effect.kind->name},         {"stage", to_string(effect.kind->stage)},
                     {"what", effect.sentence.english()}, {"several", effect.is_repeatable},
                     {"needs", effect.kind->needs},       {"example", effect.kind->example}};
  Console::Json& parameters = json["parameters"] = Console::Json::array();
  for (const EffectParameter& parameter : effect.parameters)
    parameters.push_back({{"key", parameter.key},
                          {"values", parameter.values},
                          {"in_example", parameter.in_example}});
  return json;
}

void say_effect(const EffectDescription& effect, Console& console) {
  const EffectKind& kind = *effect.kind;
  console.say(
      fmt::format("{} ({}): {}.", kind.name, to_string(kind.stage), effect.sentence.english()));
  if (effect.is_repeatable) console.say("Can be used several times in a scene.");
  if (!kind.needs.empty())
    console.say(fmt::format("The example also needs: {}.", fmt::join(kind.needs, ", ")));
  for (const EffectParameter& parameter : effect.parameters)
    console.say(fmt::format("  {:<16} {}{}", parameter.key, parameter.values,
                            parameter.in_example ? "" : "; optional"));
  console.say(fmt::format("  - {{use: {}{}{}}}", kind.name, kind.example.empty() ? "" : ", ",
                          kind.example));
}

/// Lists the effects, or the parameters of one. Error: there is no such effect.
Status run_simulate_effects(const std::string& name, Console& console) {
  const auto effects = describe_effects();
  if (name.empty()) {
    Console::Json& list = console.answer()["effects"] = Console::Json::array();
    for (const EffectDescription& effect : effects) {
      console.say(fmt::format("{:<20} {:<10} {}", effect.kind->name, to_string(effect.kind->stage),
                              effect.sentence.english()));
      list.push_back(effect_json(effect));
    }
    return {};
  }
  std::vector<std::string> names;
  for (const EffectDescription& effect : effects) {
    if (effect.kind->name == name) {
      say_effect(effect, console);
      console.answer() = effect_json(effect);
      return {};
    }
    names.push_back(effect.kind->name);
  }
  std::sort(names.begin(), names.end());
  return Error{en::say("there is no effect '{}'", printable(name)), "", one_of(names, name)};
}

// `alltact simulate --fit`: the scene whose frames match a real finger's.

Console::Json figures_json(const std::vector<TwinFigure>& figures) {
  Console::Json list = Console::Json::array();
  for (const TwinFigure& figure : figures) {
    Console::Json one{
        {"key", figure.key}, {"what", figure.what.english()}, {"value", figure.value}};
    if (figure.sd) one["sd"] = *figure.sd;
    if (!figure.remark.empty()) one["remark"] = figure.remark.english();
    list.push_back(std::move(one));
  }
  return list;
}

Console::Json residuals_json(const std::vector<TwinResidual>& residuals) {
  Console::Json list = Console::Json::array();
  for (const TwinResidual& residual : residuals) {
    Console::Json rings = Console::Json::array();
    for (const TwinRing& ring : residual.profile)
      rings.push_back({{"radius_px", ring.radius_px},
                       {"real", ring.real},
                       {"twin", ring.twin},
                       {"se", ring.se}});
    list.push_back({{"press", residual.press},
                    {"reach_px", residual.reach_px},
                    {"rms", residual.rms},
                    {"profile_rms", residual.profile_rms},
                    {"ratio_rms", residual.ratio_rms},
                    {"ratio_profile_rms", residual.ratio_profile_rms},
                    {"profile", std::move(rings)}});
  }
  return list;
}

void print_figures(const Twin& twin, Console& console) {
  console.say(fmt::format("{:<52} {:>12} {:>10}", "what", "fitted", "+- sd"));
  for (const TwinFigure& figure : twin.figures)
    console.say(fmt::format("{:<52} {:>12.5g} {:>10}{}", figure.what.english(), figure.value,
                            figure.sd ? fmt::format("{:.2g}", *figure.sd) : "-",
                            figure.remark.empty() ? "" : "  " + figure.remark.english()));
}

void print_residuals(const Twin& twin, Console& console) {
  console.say("");
  console.say("Difference between the images of the twin and the real ones, grey levels RMS:");
  console.say(fmt::format("untouched face {:.2f}", twin.untouched_rms));
  console.say(fmt::format("{:<24} {:>10} {:>8} {:>8} {:>12} {:>12}", "press", "within px", "pixels",
                          "rings", "pixels*", "rings*"));
  for (const TwinResidual& one : twin.residuals)
    console.say(fmt::format("{:<24} {:>10.0f} {:>8.2f} {:>8.2f} {:>12.2f} {:>12.2f}", one.press,
                            one.reach_px, one.rms, one.profile_rms, one.ratio_rms,
                            one.ratio_profile_rms));
  console.say(
      "* real image divided by the real untouched image, times the twin's untouched image: without "
      "what the lamps cannot match");
}

/// Writes the scene whose frames match a real finger's (twin.h).
Status run_simulate_fit(const SimulateFitOptions& options, Console& console) {
  const auto finger = open_finger(options.finger, console);
  if (!finger) return finger.error();
  TwinFiles files;
  files.presses.files = options.presses;
  files.untouched = options.untouched;
  files.press_set.ball_radius_mm = options.ball_radius_mm;
  const auto measured = measure_for_twin(**finger, files, Job(console.job(), 0.0, 0.1));
  if (!measured) return measured.error();
  for (const Message& reason : measured->left_out)
    console.warn(fmt::format("Left out: {}", reason));
  const auto twin = fit_twin(measured->input, Job(console.job(), 0.1, 1.0));
  if (!twin) return twin.error();
  if (const Status written = write_file_atomically(options.scene, twin->yaml); !written)
    return written.error();
  print_figures(*twin, console);
  print_residuals(*twin, console);
  for (const Message& remark : twin->remarks) console.say(fmt::format("Remark: {}.", remark));
  console.say(
      fmt::format("The twin's scene is {}: frame 0 is untouched, the others show its presses.",
                  options.scene.string()));
  Console::Json& answer = console.answer();
  answer["scene"] = options.scene.string();
  answer["figures"] = figures_json(twin->figures);
  answer["untouched_rms"] = twin->untouched_rms;
  answer["presses"] = residuals_json(twin->residuals);
  answer["left_out"] = in_english(measured->left_out);
  answer["remarks"] = in_english(twin->remarks);
  return {};
}

}  // namespace

Status run_simulate(const SimulateOptions& options, Console& console) {
  const auto scene = Scene::load(options.scene);
  if (!scene) return scene.error();
  const auto plan = Plan::compile(*scene, options.seed);
  if (!plan) return plan.error();
  if (options.explain) return explain(*scene, *plan, console), Status();
  if (const Status status = plan->check_grey_levels(options.scene.string()); !status) return status;
  const int count = options.frames.value_or(plan->frame_count());
  if (count > plan->frame_count()) {
    return Error{en::say("the scene has {} frames, not {}", plan->frame_count(), count),
                 options.scene.string(), en::say("fewer --frames, or more frames in the scene")};
  }
  if (const Status status = prepare_folder(options.folder); !status) return status;

  Console::Json truth;
  truth["scene"] = scene->name;
  truth["seed"] = options.seed;
  truth["effects"] = plan->effects();
  truth["finger"] = finger_json(plan->finger());
  Console::Json& frames = truth["frames"] = Console::Json::array();
  Status status;
  if (options.video) {
    status = write_file_atomically(options.folder / kVideoFile, [&](const Path& temporary) {
      return write_video(options, *plan, count, frames, console, temporary);
    });
  } else {
    status = render_all(options, *plan, count, frames, console,
                        [&](const std::string& name, const cv::Mat& image) {
                          return write_image(options.folder / (name + ".png"), image);
                        });
  }
  if (!status) return status;
  const Path camera_file = options.folder / "camera.yaml";
  status = save_camera(camera_file, plan->finger().camera);
  if (!status) return status;
  status = write_file_atomically(options.folder / kTruthFile, truth.dump(1) + "\n");
  if (!status) return status;

  console.say(fmt::format("{} frames of '{}' in {}, with the truth next to them.", frames.size(),
                          scene->name, options.folder.string()));
  console.say("Command for its finger: " + new_command(plan->finger(), camera_file));
  console.answer()["frames"] = frames.size();
  console.answer()["folder"] = options.folder.string();
  console.answer()["effects"] = plan->effects();
  console.answer()["finger"] = truth["finger"];
  return {};
}

void add_simulate(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<SimulateOptions>();
  auto fit = std::make_shared<SimulateFitOptions>();
  auto inputs = std::make_shared<std::vector<Path>>();
  CLI::App* command = add_command(program, "simulate");
  CLI::Option* costs = command->add_flag(
      "--costs", options->costs, "Measures the time of every effect on this computer instead");
  CLI::Option* scene = command->add_option(
      "SCENE", *inputs, "Scene file (YAML); with --fit, images of the pressed ball");
  CLI::Option* output = command
                            ->add_option("-o,--output", options->folder,
                                         "Folder for the frames; with --fit, the scene file")
                            ->type_name("DIR");
  CLI::Option* effects =
      command
          ->add_option("--effects", options->effect,
                       "Lists all effects instead, or the parameters and an example of one")
          ->type_name("[NAME]")
          ->expected(0, 1)
          ->excludes(costs);
  for (CLI::Option* option : {scene, output}) option->excludes(costs)->excludes(effects);
  CLI::Option* frames =
      command
          ->add_option(
              "--frames", options->frames,
              fmt::format("Frames to render, from the first (default: all of the scene); with "
                          "--costs, frames to time with and without each effect (default: {})",
                          kTimedFrames))
          ->type_name("N")
          ->transform(typed_integer(1, 1000000));
  CLI::Option* seed = command
                          ->add_option("--seed", options->seed,
                                       "Seed of all random numbers, 0 to 2^64 - 1 (default 1)")
                          ->type_name("S")
                          ->transform(typed_integer(0));
  CLI::Option* video = command->add_flag(
      "--video", options->video, "Writes one lossless video, frames.mkv, instead of images");
  CLI::Option* maps =
      command->add_flag("--maps", options->maps,
                        "Adds the truth of every pixel: contact (.contact.png, 1 + its number), "
                        "normals and the light without presses (.normal.tiff, .untouched.tiff), "
                        "and what is visible (.seen.png: 1 face, 2 side, 3 dot, 4 hidden dot)");
  CLI::Option* explained =
      command
          ->add_flag("--explain", options->explain,
                     "Only lists which effects are built, in which frames, and why; without -o")
          ->excludes(output)
          ->excludes(costs)
          ->excludes(effects);
  add_threads_flag(*command, options->threads);
  CLI::Option* fitted =
      command
          ->add_option("--fit", fit->finger,
                       "Writes the scene of a twin instead, whose images match those of this "
                       "finger: the given presses, or the stored ones")
          ->type_name("FINGER");
  for (CLI::Option* option : {costs, effects, frames, seed, video, maps, explained})
    option->excludes(fitted);
  command
      ->add_option("--ball-radius-mm", fit->ball_radius_mm,
                   "With --fit: radius of the ball, mm (default: the stored radius)")
      ->type_name("R")
      ->transform(typed_number(kBallRadius))
      ->needs(fitted);
  command
      ->add_option("--reference", fit->untouched,
                   "With --fit: untouched image, if the finger has none stored; a second one of "
                   "the same pose gives the camera's temporal noise")
      ->type_name("IMAGE")
      ->allow_extra_args(false)
      ->take_all()
      ->needs(fitted);
  command->callback([=, &chosen] {
    if (options->costs) {
      const int timed = options->frames.value_or(kTimedFrames);
      chosen = [=](Console& console) { return run_simulate_costs(timed, console); };
      return;
    }
    if (effects->count() > 0) {
      chosen = [=](Console& console) { return run_simulate_effects(options->effect, console); };
      return;
    }
    if (scene->count() == 0 && fitted->count() == 0) throw CLI::RequiredError(scene->get_name());
    if (!options->explain && output->count() == 0) throw CLI::RequiredError(output->get_name());
    if (fitted->count() > 0) {
      fit->presses = *inputs;
      fit->scene = options->folder;
      chosen = [=](Console& console) { return run_simulate_fit(*fit, console); };
      return;
    }
    if (inputs->size() > 1)
      throw CLI::ArgumentMismatch::AtMost(scene->get_name(), 1, inputs->size());
    options->scene = inputs->front();
    chosen = [=](Console& console) { return run_simulate(*options, console); };
  });
}

// `alltact simulate --effects [NAME]`.

}  // namespace alltact
