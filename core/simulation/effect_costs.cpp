#include "core/simulation/effect_costs.h"

#include "core/numerics/median.h"
#include "core/simulation/plan.h"

#include <chrono>
#include <set>
#include <tuple>

namespace alltact {

namespace {

constexpr int kWidth_px = 960, kHeight_px = 540;

const EffectKind* kind_named(const std::vector<const EffectKind*>& kinds, std::string_view name) {
  const auto found = std::find_if(
      kinds.begin(), kinds.end(), [&](const auto* kind) { return kind->name == name; });
  return found == kinds.end() ? nullptr : *found;
}

Result<Plan> example_plan(std::string_view kind, std::string_view without) {
  const auto scene = Scene::parse(example_scene({kind}, without), std::string(kind));
  if (!scene) return scene.error();
  return Plan::compile(*scene, 1);
}

double frame_ms(const Plan& plan, int frame) {
  const auto begin = std::chrono::steady_clock::now();
  const Arrival arrival = plan.arrival(frame);
  const SentFrame sent = plan.send(frame);
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  return sent.grey.empty() || arrival.late_ms < 0 ? 0 : taken.count();
}

}  // namespace

std::string_view to_string(Stage stage) {
  switch (stage) {
    case Stage::kGeometry:
      return "geometry";
    case Stage::kRadiance:
      return "radiance";
    case Stage::kSensor:
      return "sensor";
    case Stage::kTransport:
      break;
  }
  return "transport";
}

std::string example_scene(const std::vector<std::string_view>& kinds, std::string_view without) {
  const auto all = effect_kinds();
  std::vector<std::string_view> requested{"bend", "layer", "leds", "quantisation"};
  for (const std::string_view name : kinds) {
    if (const EffectKind* kind = kind_named(all, name))
      requested.insert(requested.end(), kind->needs.begin(), kind->needs.end());
    requested.push_back(name);
  }
  std::string effects;
  std::set<std::string_view> listed{without};
  for (const std::string_view name : requested) {
    const EffectKind* kind = kind_named(all, name);
    if (kind == nullptr || !listed.insert(name).second) continue;
    effects += fmt::format(
        "  - {{use: {}{}{}}}\n", name, kind->example.empty() ? "" : ", ", kind->example);
  }
  return fmt::format(
      "name: example\nwhy: an effect to look at or to time\nframes: 1000\nfinger:\n"
      "  camera: {{model: pinhole, size: [{}, {}], fx: 523.9, fy: 523.9, cx: 479.5, cy: 269.5}}\n"
      "  face: {{kind: fin_ray, width_mm: 24, layer_mm: 1.5}}\n"
      "  markers: {{per_row: 6, polarity: bright}}\n"
      "untouched: {{x_mm: -25, z_mm: 28, incline_deg: 34, length_mm: 116}}\n"
      "{}effects:{}\n{}",
      kWidth_px,
      kHeight_px,
      listed.contains("sway") || without != "bend" ? "motion: {kind: wander, frames_per_move: 20}\n"
                                                   : "",
      effects.empty() ? " []" : "",
      effects);
}

Result<std::vector<EffectCost>> measure_effect_costs(int repetitions, const Job& job) {
  auto kinds = effect_kinds();
  std::sort(kinds.begin(), kinds.end(), [](const auto* a, const auto* b) {
    return std::tie(a->stage, a->rank, a->name) < std::tie(b->stage, b->rank, b->name);
  });
  std::vector<EffectCost> costs;
  for (const EffectKind* kind : kinds) {
    const auto with = example_plan(kind->name, {}), without = example_plan(kind->name, kind->name);
    if (!with) return with.error();
    if (!without) return without.error();
    std::vector<double> added;
    for (int i = 0; i <= repetitions; ++i) {
      if (job.stop_requested())
        return Error{en::say("stopped before all effects were measured"), "", ""};
      job.report(static_cast<double>(costs.size()) / static_cast<double>(kinds.size()),
                 en::say("measuring {}", kind->name));
      const double plain = frame_ms(*without, i), more = frame_ms(*with, i);
      if (i > 0) added.push_back(more - plain);  // the first frame warms up
    }
    costs.push_back({kind, upper_median(added) / (1e-6 * kWidth_px * kHeight_px)});
  }
  return costs;
}

}  // namespace alltact
