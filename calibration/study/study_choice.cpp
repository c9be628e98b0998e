#include "calibration/study/study_choice.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace alltact {
namespace {

/// A study's images have the light of the recording that they come from.
const std::pair<std::string, std::string> kUnproven{"light-change", "ignored"};

/// One value of one setting.
struct TriedValue {
  const Setting<PipelineSettings>* setting;
  std::string value;

  [[nodiscard]] bool is_alone() const {
    const auto& alone = setting->trade->alone;
    return std::find(alone.begin(), alone.end(), value) != alone.end();
  }
};

std::vector<TriedValue> tried_values(const PipelineSettings& base, const Finger& finger) {
  std::vector<TriedValue> values;
  for (const auto& setting : pipeline_settings()) {
    if (!has_trade_off(setting, finger)) continue;
    for (const std::string& value : setting.trade->tried)
      if (value != setting.get(base)) values.push_back({&setting, value});
  }
  return values;
}

void put(const TriedValue& tried, PipelineSettings& settings) {
  [[maybe_unused]] const Status status = tried.setting->set(settings, tried.value);
  assert(status.ok());  // the table's own value
}

PipelineSettings cheapest(PipelineSettings settings, const Finger& finger) {
  for (const auto& setting : pipeline_settings())
    if (has_trade_off(setting, finger) && !setting.trade->tried.empty())
      put({&setting, setting.trade->tried.front()}, settings);
  return settings;
}

}  // namespace

std::vector<PipelineSettings> study_choices(const PipelineSettings& base,
                                            StudyExtent extent,
                                            const Finger& finger) {
  std::vector<PipelineSettings> choices;
  std::set<std::string> known;
  const auto add = [&](const PipelineSettings& choice) {
    if (known.insert(key_of(choice)).second) choices.push_back(choice);
  };
  add(base);
  const std::vector<TriedValue> values = tried_values(base, finger);
  for (const TriedValue& value : values) {
    PipelineSettings choice = base;
    put(value, choice);
    add(choice);
  }
  if (extent == StudyExtent::kQuick) return choices;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t k = i + 1; k < values.size(); ++k) {
      if (values[i].setting == values[k].setting) continue;
      if (values[i].is_alone() || values[k].is_alone()) continue;
      PipelineSettings choice = base;
      put(values[i], choice);
      put(values[k], choice);
      add(choice);
    }
  add(cheapest(base, finger));
  return choices;
}

Message words_of(const PipelineSettings& choice, const PipelineSettings& base) {
  std::string words;
  for (const auto& setting : pipeline_settings())
    if (setting.get(choice) != setting.get(base))
      words += (words.empty() ? "" : ", ") + setting.name + ' ' + setting.get(choice);
  return words.empty() ? en::say("as it is") : Message::typed(words);
}

std::string flags_of(const PipelineSettings& choice, const PipelineSettings& base) {
  std::string flags;
  for (const auto& setting : pipeline_settings())
    if (setting.get(choice) != setting.get(base))
      flags += (flags.empty() ? "--" : " --") + setting.name + ' ' + setting.get(choice);
  return flags;
}

bool is_proven(const PipelineSettings& choice, const PipelineSettings& base) {
  const auto& all = pipeline_settings();
  return std::none_of(all.begin(), all.end(), [&](const Setting<PipelineSettings>& setting) {
    return setting.name == kUnproven.first && setting.get(choice) == kUnproven.second &&
           setting.get(base) != kUnproven.second;
  });
}

std::string key_of(const PipelineSettings& choice) {
  std::string key;
  for (const auto& setting : pipeline_settings())
    key += (key.empty() ? "" : " ") + setting.name + '=' + setting.get(choice);
  return key;
}

}  // namespace alltact
