// `alltact simulate --effects [NAME]`.
#include "app/commands/commands.h"
#include "core/either.h"
#include "core/printable.h"
#include "core/simulation/effect_costs.h"
#include "core/simulation/effect_parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace alltact {

namespace {

Console::Json effect_json(const EffectDescription& effect) {
  Console::Json json{{"name", effect.kind->name},
                     {"stage", to_string(effect.kind->stage)},
                     {"what", effect.sentence.english()},
                     {"several", effect.is_repeatable},
                     {"needs", effect.kind->needs},
                     {"example", effect.kind->example}};
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
  if (effect.is_repeatable) console.say("May be named several times at once.");
  if (!kind.needs.empty())
    console.say(fmt::format("The example needs beside it: {}.", fmt::join(kind.needs, ", ")));
  for (const EffectParameter& parameter : effect.parameters)
    console.say(fmt::format("  {:<16} {}{}",
                            parameter.key,
                            parameter.values,
                            parameter.in_example ? "" : "; may be left out"));
  console.say(fmt::format(
      "  - {{use: {}{}{}}}", kind.name, kind.example.empty() ? "" : ", ", kind.example));
}

}  // namespace

Status run_simulate_effects(const std::string& name, Console& console) {
  const auto effects = describe_effects();
  if (name.empty()) {
    Console::Json& list = console.answer()["effects"] = Console::Json::array();
    for (const EffectDescription& effect : effects) {
      console.say(fmt::format("{:<20} {:<10} {}",
                              effect.kind->name,
                              to_string(effect.kind->stage),
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

}  // namespace alltact
