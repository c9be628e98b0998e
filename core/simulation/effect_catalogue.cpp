#include "core/simulation/effect_catalogue.h"

#include "core/base/yaml.h"
#include "core/numerics/median.h"
#include "core/simulation/plan.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <set>
#include <tuple>

namespace alltact {
namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

// Splits "a: 1, b: [2, 3]" by key; text in brackets stays together.
Pairs pairs_of(std::string_view flow) {
  Pairs pairs;
  int depth = 0;
  std::string text;
  const auto end_pair = [&] {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos) return;
    const std::size_t key = text.find_first_not_of(' ');
    pairs.emplace_back(text.substr(key, colon - key), text.substr(colon + 1));
    text.clear();
  };
  for (const char c : flow) {
    depth += c == '[' || c == '{';
    depth -= c == ']' || c == '}';
    if (c == ',' && depth == 0)
      end_pair();
    else
      text += c;
  }
  end_pair();
  return pairs;
}

// `keys`: receives the keys that the effect's reader requested.
Result<std::shared_ptr<const Effect>> make(const EffectKind& kind, const Pairs& pairs,
                                           std::vector<std::string>* keys = nullptr) {
  std::string text = fmt::format("frames: 100\neffect:\n  use: {}\n", kind.name);
  for (const auto& [key, value] : pairs) text += fmt::format("  {}: {}\n", key, value);
  YamlFile file("example", YamlFile::Unknown::kRefused);
  std::shared_ptr<const Effect> effect;
  const Status read = file.read(text, [&](YamlSection& top) {
    (void)top.integer("frames", 1, 100);
    YamlSection section = top.section("effect");
    (void)section.text("use");
    effect = kind.make(section);
    if (keys != nullptr) *keys = section.requested_keys();
  });
  if (!read) return read.error();
  return effect;
}

// The error about these parameters; empty: none.
Error refusal(const EffectKind& kind, const Pairs& pairs) {
  const auto made = make(kind, pairs);
  return made ? Error() : made.error();
}

void set(Pairs& pairs, const std::string& key, const std::string& value) {
  for (auto& pair : pairs)
    if (pair.first == key) {
      pair.second = value;
      return;
    }
  pairs.emplace_back(key, value);
}

std::string between(std::string text, std::string_view before, std::string_view after) {
  if (text.starts_with(before)) text.erase(0, before.size());
  const std::size_t end = text.find(after);
  return end == std::string::npos ? text : text.substr(0, end);
}

// Extracts the requirement from "must be a number above 0, not 'x'".
std::string requirement_in(const Error& error) {
  std::string text = between(error.what.english(), "must be ", ", not '");
  text = between(text, "holds 'x', which is not ", "\n");
  const std::string_view to = " and up to ";
  const std::size_t at = text.find(to);
  if (at != std::string::npos && text.find("number from") == text.find("number"))
    text.replace(at, to.size(), " to ");
  return text;
}

std::string values_of(const EffectKind& kind, Pairs pairs, const std::string& key) {
  const auto answer_to = [&](const std::string& value) {
    set(pairs, key, value);
    return refusal(kind, pairs);
  };
  Error to_word = answer_to("x");
  std::string together;
  if (to_word.kind == ErrorKind::kMissingKey) {  // another one
    const std::string where = to_word.where.english();
    const std::string other = where.substr(where.rfind('.') + 1);
    set(pairs, other, "1");
    to_word = answer_to("x");
    together = ", together with " + other;
  }
  switch (to_word.kind) {
    case ErrorKind::kUnknownWord:
      return to_word.advice.english();
    case ErrorKind::kNoBlock:
      return "{from: ..., to: ...}, each " + requirement_in(answer_to("{from: x, to: 1}"));
    case ErrorKind::kNoList:
      for (const char* value : {"[x, x, x]", "[x, x]"})
        if (const Error inner = answer_to(value); inner.kind == ErrorKind::kWrongItem)
          return "a list, each " + requirement_in(inner);
      [[fallthrough]];
    case ErrorKind::kWrongValue:
      return requirement_in(to_word) + together;
    default:
      return "a name";
  }
}

std::vector<const EffectKind*> kinds_in_running_order() {
  auto kinds = effect_kinds();
  std::sort(kinds.begin(), kinds.end(), [](const auto* a, const auto* b) {
    return std::tie(a->stage, a->rank, a->name) < std::tie(b->stage, b->rank, b->name);
  });
  return kinds;
}

}  // namespace

EffectDescription describe(const EffectKind& kind) {
  const Pairs pairs = pairs_of(kind.example);
  std::vector<std::string> keys;
  const auto effect = make(kind, pairs, &keys);
  if (!effect) return {&kind, {}, false, {}};
  EffectDescription description{&kind, kind.sentence, (*effect)->is_repeatable(), {}};
  for (const std::string& key : keys) {
    if (key == "use") continue;
    const bool in_example = std::any_of(pairs.begin(), pairs.end(),
                                        [&](const auto& pair) { return pair.first == key; });
    description.parameters.push_back({key, values_of(kind, pairs, key), in_example});
  }
  return description;
}

std::vector<EffectDescription> describe_effects() {
  std::vector<EffectDescription> all;
  for (const EffectKind* kind : kinds_in_running_order()) all.push_back(describe(*kind));
  return all;
}

namespace {

constexpr int kWidth_px = 960, kHeight_px = 540;

const EffectKind* kind_named(const std::vector<const EffectKind*>& kinds, std::string_view name) {
  const auto found = std::find_if(kinds.begin(), kinds.end(),
                                  [&](const auto* kind) { return kind->name == name; });
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
  constexpr std::array<std::string_view, 4> kWords{"geometry", "radiance", "sensor", "transport"};
  return kWords.at(static_cast<std::size_t>(stage) - 1);
}

std::string example_scene(const std::vector<std::string_view>& kinds, std::string_view without) {
  const auto all = effect_kinds();
  std::vector<std::string_view> requested{"bend", "layer", "leds", "quantisation"};
  std::set<std::string_view> listed{without};
  for (const std::string_view name : kinds) {
    if (const EffectKind* kind = kind_named(all, name)) {
      requested.insert(requested.end(), kind->needs.begin(), kind->needs.end());
      listed.insert(kind->instead_of);
    }
    requested.push_back(name);
  }
  std::string effects;
  for (const std::string_view name : requested) {
    const EffectKind* kind = kind_named(all, name);
    if (kind == nullptr || !listed.insert(name).second) continue;
    effects += fmt::format("  - {{use: {}{}{}}}\n", name, kind->example.empty() ? "" : ", ",
                           kind->example);
  }
  return fmt::format(
      "name: example\nwhy: an effect to look at or to time\nframes: 1000\nfinger:\n"
      "  camera: {{model: pinhole, size: [{}, {}], fx: 523.9, fy: 523.9, cx: 479.5, cy: 269.5}}\n"
      "  face: {{kind: fin_ray, width_mm: 24, layer_mm: 1.5}}\n"
      "  markers: {{per_row: 6, polarity: bright}}\n"
      "untouched: {{x_mm: -25, z_mm: 28, incline_deg: 34, length_mm: 116}}\n"
      "{}effects:{}\n{}",
      kWidth_px, kHeight_px,
      listed.contains("sway") || without != "bend" ? "motion: {kind: wander, frames_per_move: 20}\n"
                                                   : "",
      effects.empty() ? " []" : "", effects);
}

Result<std::vector<EffectCost>> measure_effect_costs(int repetitions, const Job& job) {
  const auto kinds = kinds_in_running_order();
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
