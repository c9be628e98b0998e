#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "calibration/lens/board_views.h"
#include "calibration/lens/calibrate_lens.h"
#include "core/camera/camera.h"
#include "core/open/open_source.h"

#include <fmt/format.h>

namespace alltact {
namespace {

struct LensOptions {
  std::vector<Path> inputs;
  Board board;  ///< only columns, rows and square_mm; the rest is in the settings
  LensSettings settings;
  Orientation orientation = Orientation::kNone;
  std::optional<FlatPort> port;           ///< the finger's window, where the board had none
  std::optional<double> known_length_mm;  ///< on the finger, with `known_ends`
  std::vector<double> known_ends_px;      ///< u1 v1 u2 v2 in the image after orientation
  Path camera;
};

void print_views(const LensViews& found, const LensCalibration& done, Console& console) {
  console.say(fmt::format("{:<24} {:>7} {:>9} {:>9} {:>9}", "view", "corners", "outliers",
                          "error px", "tilt deg"));
  for (const LensViewReport& view : done.views) {
    if (!view.rejection.empty()) continue;
    console.say(fmt::format("{:<24} {:>7} {:>9} {:>9.3f} {:>9.0f}", view.name, view.corners,
                            view.left_out, view.error_px, view.tilt_deg));
  }
  for (const auto& [name, reason] : found.refused)
    console.warn(fmt::format("No board: {}: {}", name.english(), reason));
  for (const LensViewReport& view : done.views)
    if (!view.rejection.empty())
      console.warn(fmt::format("Rejected: {}: {}", view.name, view.rejection));
}

void print_lens(const LensCalibration& done, const LensSettings& settings, Console& console) {
  const CameraParameters& lens = done.fit.lens;
  console.say(
      fmt::format("Lens: {}, {} x {} px, fx {:.2f} +- {:.2f}, fy {:.2f} +- {:.2f}, centre "
                  "({:.2f} +- {:.2f}, {:.2f} +- {:.2f}) px",
                  to_string(lens.model), lens.width_px, lens.height_px, lens.fx_px, lens.sd_px[0],
                  lens.fy_px, lens.sd_px[1], lens.cx_px, lens.sd_px[2], lens.cy_px, lens.sd_px[3]));
  std::string errors = fmt::format("Corner error: {:.3f} px in fitted views", done.fit.sigma_px);
  if (done.held_out)
    errors += fmt::format(", {:.3f} px in held-out views", done.held_out->error_px);
  if (done.halves)
    errors += fmt::format(
        "; lenses from two halves of the views differ by {:.2f} px (median), {:.2f} px (maximum)",
        done.halves->difference.median_px, done.halves->difference.worst_px);
  console.say(errors);
  if (done.halves) {
    const auto& [first, second] = done.halves->numbers;
    console.say(fmt::format(
        "Halves: fx {:.2f} and {:.2f} px, fy {:.2f} and {:.2f} px; by the covariance alone fx +- "
        "{:.2f} px",
        first[0], second[0], first[1], second[1], done.fit.sd(0)));
  }
  console.say(fmt::format("At the finger: uncertainty {:.2g} mm at a distance of {:g} mm",
                          done.verdict.error_mm, settings.distance_mm));
  console.say(
      fmt::format("Coverage: {:.0f} % of the image, {} of {} views tilted by 15 degrees or more",
                  100 * done.coverage.seen_part, done.coverage.tilted_views, done.used.size()));
}

Console::Json views_json(const LensViews& found, const LensCalibration& done) {
  Console::Json views = Console::Json::array();
  for (const LensViewReport& view : done.views) {
    Console::Json entry{{"name", view.name}, {"corners", view.corners}};
    if (view.rejection.empty()) {
      entry["outliers"] = view.left_out;
      entry["error_px"] = view.error_px;
      entry["tilt_deg"] = view.tilt_deg;
    } else {
      entry["put_aside"] = view.rejection.english();
    }
    views.push_back(entry);
  }
  for (const auto& [name, reason] : found.refused)
    views.push_back({{"name", name.english()}, {"corners", 0}, {"put_aside", reason.english()}});
  return views;
}

/// Every outlier corner, so that the user finds it in its image.
Console::Json outliers_json(const LensCalibration& done) {
  Console::Json outliers = Console::Json::array();
  for (std::size_t i = 0; i < done.used.size(); ++i)
    for (std::size_t k = 0; k < done.used[i].pixels.size(); ++k)
      if (done.fit.weights[i][k] == 0)
        outliers.push_back({{"view", done.used[i].name},
                            {"u", done.used[i].pixels[k].x()},
                            {"v", done.used[i].pixels[k].y()},
                            {"error_px", done.fit.errors_px[i][k]}});
  return outliers;
}

void answer(const LensViews& found, const LensCalibration& done, Console::Json& json) {
  const CameraParameters& lens = done.fit.lens;
  json["verdict"] = done.verdict.sentence.english();
  json["fx"] = lens.fx_px;
  json["fy"] = lens.fy_px;
  json["cx"] = lens.cx_px;
  json["cy"] = lens.cy_px;
  json["distortion"] = lens.distortion;
  json["sd"] = {
      {"fx", lens.sd_px[0]}, {"fy", lens.sd_px[1]}, {"cx", lens.sd_px[2]}, {"cy", lens.sd_px[3]}};
  json["fx_fit_sd"] = done.fit.sd(0);
  json["focal_sd_percent"] = 100 * done.focal_sd_part;
  json["error_mm"] = done.verdict.error_mm;
  json["corner_px"] = done.fit.sigma_px;
  if (done.held_out) json["held_out_px"] = done.held_out->error_px;
  if (done.halves) {
    json["halves_median_px"] = done.halves->difference.median_px;
    json["halves_worst_px"] = done.halves->difference.worst_px;
    json["halves_fx"] = {done.halves->numbers[0][0], done.halves->numbers[1][0]};
    json["halves_fy"] = {done.halves->numbers[0][1], done.halves->numbers[1][1]};
  }
  json["seen_part"] = done.coverage.seen_part;
  json["unseen"] = in_english(done.coverage.unseen);
  json["tilted_views"] = done.coverage.tilted_views;
  json["more"] = done.coverage.advice.english();
  json["pictures"] = found.analysed;
  json["views_used"] = done.used.size();
  json["views"] = views_json(found, done);
  json["outliers"] = outliers_json(done);
  json["remarks"] = in_english(done.remarks);
}

/// The camera to write: the lens, and the window in front of it.
Result<CameraParameters> seen_through(const LensOptions& options, const CameraParameters& lens,
                                      Console& console) {
  if (!options.port) {
    console.warn(
        "Remark: this lens is valid in air, where the board was. Through acrylic into silicone, "
        "everything looks larger and distances come out 23 to 31 % too small. Give --port, or take "
        "the images through the window with the board in a liquid of the silicone's index.");
    return lens;
  }
  const FlatPort& port = *options.port;
  const double distance = options.settings.distance_mm;
  const double behind_mm = distance - port.gap_mm - port.plate_mm;
  if (!(behind_mm > 0))
    return Error{en::say("the finger must lie behind the window, which ends {:g} mm from the "
                         "lens",
                         port.gap_mm + port.plate_mm),
                 std::string("--distance-mm"),
                 en::say("the distance from the lens to the finger's middle")};
  CameraParameters camera = lens;
  camera.port = port;
  const double seems_mm = apparent_distance_mm(port, distance);
  // By how much z changes per error of a caliper or a table, near the axis.
  const double by_gap_mm = port.medium_index - 1;
  const double by_index_mm = 0.01 * behind_mm / port.medium_index;
  console.say(
      fmt::format("Window: refraction is computed exactly; a point {:g} mm from the lens appears "
                  "at {:.1f} mm. A gap error of 1 mm moves the finger by {:.2f} mm, an index error "
                  "of 0.01 behind the window by {:.2f} mm",
                  distance, seems_mm, by_gap_mm, by_index_mm));
  console.answer()["port"] = {{"seems_mm", seems_mm},
                              {"air_depth_part", seems_mm / distance},
                              {"mm_per_gap_mm", by_gap_mm},
                              {"mm_per_hundredth_of_index", by_index_mm}};
  return camera;
}

/// Compares a length on the finger, measured with a caliper, with this camera's measurement.
Status check_scale(const LensOptions& options, const CameraParameters& parameters,
                   Console& console) {
  if (!options.known_length_mm) return {};
  const auto camera = Camera::create(parameters);
  if (!camera) return camera.error();
  const auto& ends = options.known_ends_px;
  const auto a = camera->unproject({ends[0], ends[1]});
  const auto b = camera->unproject({ends[2], ends[3]});
  if (!a || !b)
    return Error{en::say("an end of the known length lies where this lens sees nothing"),
                 std::string("--known-ends"),
                 en::say("its ends in pixels of the picture after orientation")};
  const double z_mm = options.settings.distance_mm;
  const double seen_mm = (a->point_at(z_mm) - b->point_at(z_mm)).norm();
  const double ratio = seen_mm / *options.known_length_mm;
  std::string text = fmt::format("Scale: a length of {:g} mm at {:g} mm is measured as {:.2f} mm",
                                 *options.known_length_mm, options.settings.distance_mm, seen_mm);
  constexpr double kAgrees = 0.03;  // 1 mm of 60 in the distance is 2 % already
  if (std::abs(ratio - 1) <= kAgrees) {
    text += fmt::format(", {:+.1f} %: lens and finger agree", 100 * (ratio - 1));
  } else if (ratio > 1) {
    text += fmt::format(
        ", {:.2f} times too large, as through a medium with an index of about {:.2f}. Depths would "
        "come out {:.0f} % too small; {}",
        ratio, ratio, 100 * (1 - 1 / ratio),
        options.port ? "check the numbers of --port, the distance and the ends"
                     : "give --port with what lies between lens and finger");
  } else {
    text += fmt::format(
        ", {:.2f} times: too small. Check --square-mm, the distance (from the lens, not from the "
        "window) and the ends. Omit --port if the board was in the medium",
        ratio);
  }
  console.say(text);
  console.answer()["scale"] = {{"seen_mm", seen_mm}, {"ratio", ratio}};
  return {};
}

/// Calibrates a lens from images of a board and writes CAMERA.yaml.
Status run_lens(const LensOptions& options, Console& console) {
  const Job& job = console.job();
  SourceOptions how;
  how.job = &job;
  const auto source = open_source(options.inputs, how);
  if (!source) return source.error();
  if ((*source)->is_live())
    return Error{en::say("a camera gives pictures without end"), "",
                 en::say("a recording of it: alltact record")};
  const Board board = options.settings.applied_to(options.board);
  const auto found = find_boards(**source, board, options.orientation, job);
  if (!found) return found.error();
  report_remarks(**source, console);
  auto done = calibrate_lens(found->views, found->size, options.settings, job);
  if (!done) {
    for (const auto& [name, reason] : found->refused)
      console.warn(fmt::format("No board: {}: {}", name.english(), reason));
    return done.error();
  }
  const auto remarks = print_remarks(found->board);
  done->remarks.insert(done->remarks.begin(), remarks.begin(), remarks.end());
  console.say(fmt::format("Board of {} found in {} of {} images, {} used", board.words(),
                          found->analysed - found->refused.size(), found->analysed,
                          done->used.size()));
  if (found->repeats > 0)
    console.say(fmt::format("{} more images repeat a position of the board", found->repeats));
  print_views(*found, *done, console);
  print_lens(*done, options.settings, console);
  for (const Message& remark : done->remarks) console.say(fmt::format("Remark: {}.", remark));
  answer(*found, *done, console.answer());
  const LensRecord record = lens_record(board, *done);
  auto camera = seen_through(options, done->fit.lens, console);
  if (!camera) return camera.error();
  camera->orientation = options.orientation;
  if (const Status status = check_scale(options, *camera, console); !status) return status;
  if (const Status status = save_camera(options.camera, *camera, record); !status) return status;
  console.say(fmt::format("Verdict: {}.", done->verdict.sentence));
  console.say(fmt::format("{} written. Next: alltact new with --camera", options.camera.string()));
  console.answer()["camera"] = options.camera.string();
  return {};
}

/// Throws CLI::ValidationError.
std::vector<double> four_numbers(const char* flag, const std::string& text) {
  const auto numbers = typed_numbers(text, 4);
  if (!numbers) throw CLI::ValidationError(flag, numbers.error().what.english());
  return *numbers;
}

}  // namespace

void add_lens(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<LensOptions>();
  auto port = std::make_shared<std::vector<double>>();
  CLI::App* command = add_command(program, "lens");
  command->add_option("INPUT", options->inputs, "Images of the board, folders of them, or a video")
      ->required();
  command
      ->add_option_function<std::string>(
          "--board",
          [options](const std::string& text) {
            if (const Status status = set_board_size(options->board, text); !status)
              throw CLI::ValidationError("--board", status.error().what.english());
          },
          "Inner corners, dots or tags of the board in a row and in a column, such as 9x6")
      ->type_name("CxR")
      ->required();
  command
      ->add_option("--square-mm", options->board.square_mm,
                   "Side of a square or of a tag, or distance between two dots (asymmetric dots: "
                   "between two rows), mm")
      ->type_name("S")
      ->transform(typed_number(kBoardSquare))
      ->required();
  command->add_option("-o,--output", options->camera, "Camera file to write")
      ->type_name("CAMERA.yaml")
      ->required();
  command
      ->add_option_function<std::string>(
          "--orientation",
          [options](const std::string& word) {
            const auto orientation = orientation_from(word);
            if (!orientation)
              throw CLI::ValidationError("--orientation", "'" + word + "' is not an orientation");
            options->orientation = *orientation;
          },
          "Rotation or flip of the camera's images so that the finger lies along them (default "
          "none)")
      ->type_name("none|flip_u|flip_v|rotate_180|rotate_90|rotate_270");
  command
      ->add_option_function<std::string>(
          "--port", [port](const std::string& text) { *port = four_numbers("--port", text); },
          "Window between lens and finger, if the board was in air: air gap mm, plate mm, index of "
          "the plate (acrylic 1.49), index behind it (silicone 1.41)")
      ->type_name("GAP,PLATE,INDEX,INDEX");
  CLI::Option* length = command
                            ->add_option("--known-length-mm", options->known_length_mm,
                                         "Known length on the finger, across the line of sight at "
                                         "--distance-mm, to check the scale, mm")
                            ->type_name("L")
                            ->transform(typed_number(kKnownLength));
  command
      ->add_option_function<std::string>(
          "--known-ends",
          [options](const std::string& text) {
            options->known_ends_px = four_numbers("--known-ends", text);
          },
          "Ends of the known length in the image, px")
      ->type_name("U,V,U,V")
      ->needs(length);
  SettingFlags<LensSettings> settings;
  settings.add_to(*command, lens_settings());
  command->callback([=, &chosen] {
    if (options->known_length_mm && options->known_ends_px.empty())
      throw CLI::RequiredError("--known-ends");
    if (!port->empty()) {
      options->port = FlatPort{(*port)[0], (*port)[1], (*port)[2], (*port)[3]};
      if (const Status status = check_port(*options->port); !status)
        throw CLI::ValidationError(
            "--port", fmt::format("{} {}", status.error().where.english(), status.error().what));
    }
    options->settings = settings.applied_to({});
    chosen = [=](Console& console) { return run_lens(*options, console); };
  });
}

}  // namespace alltact
