// `alltact simulate --fit`: the scene whose frames match a real finger's.
#include "app/commands/commands.h"
#include "calibration/twin/twin_inputs.h"
#include "core/io/atomic_file.h"

#include <fmt/format.h>

namespace alltact {
namespace {

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
    console.say(fmt::format("{:<52} {:>12.5g} {:>10}{}",
                            figure.what.english(),
                            figure.value,
                            figure.sd ? fmt::format("{:.2g}", *figure.sd) : "-",
                            figure.remark.empty() ? "" : "  " + figure.remark.english()));
}

void print_residuals(const Twin& twin, Console& console) {
  console.say("");
  console.say("How far the twin's pictures are from the real ones, grey levels RMS:");
  console.say(fmt::format("untouched face {:.2f}", twin.untouched_rms));
  console.say(fmt::format("{:<24} {:>10} {:>8} {:>8} {:>12} {:>12}",
                          "press",
                          "within px",
                          "pixels",
                          "rings",
                          "pixels*",
                          "rings*"));
  for (const TwinResidual& one : twin.residuals)
    console.say(fmt::format("{:<24} {:>10.0f} {:>8.2f} {:>8.2f} {:>12.2f} {:>12.2f}",
                            one.press,
                            one.reach_px,
                            one.rms,
                            one.profile_rms,
                            one.ratio_rms,
                            one.ratio_profile_rms));
  console.say(
      "* the real picture over the real untouched one, times the twin's untouched one: without "
      "what "
      "the lamps cannot match");
}

}  // namespace

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

}  // namespace alltact
