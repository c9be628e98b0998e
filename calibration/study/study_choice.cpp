#include "calibration/study/study_choice.h"

#include <cassert>
#include <set>

namespace alltact {
namespace {

/// One value of one setting.
struct TriedValue {
  const Setting<PipelineSettings>* setting;
  std::string value;
};

std::vector<TriedValue> tried_values(const PipelineSettings& base) {
  std::vector<TriedValue> values;
  for (const auto& setting : pipeline_settings()) {
    if (!setting.trade) continue;
    for (const std::string& value : setting.trade->tried)
      if (value != setting.get(base)) values.push_back({&setting, value});
  }
  return values;
}

void put(const TriedValue& tried, PipelineSettings& settings) {
  [[maybe_unused]] const Status status = tried.setting->set(settings, tried.value);
  assert(status.ok());  // the table's own value
}

PipelineSettings cheapest() {
  PipelineSettings settings;
  for (const auto& setting : pipeline_settings())
    if (setting.trade) put({&setting, setting.trade->tried.front()}, settings);
  return settings;
}

}  // namespace

std::vector<PipelineSettings> study_choices(const PipelineSettings& base, StudyExtent extent) {
  std::vector<PipelineSettings> choices;
  std::set<std::string> known;
  const auto add = [&](const PipelineSettings& choice) {
    if (known.insert(key_of(choice)).second) choices.push_back(choice);
  };
  add(base);
  const std::vector<TriedValue> values = tried_values(base);
  for (const TriedValue& value : values) {
    PipelineSettings choice = base;
    put(value, choice);
    add(choice);
  }
  if (extent == StudyExtent::kQuick) return choices;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t k = i + 1; k < values.size(); ++k) {
      if (values[i].setting == values[k].setting) continue;
      PipelineSettings choice = base;
      put(values[i], choice);
      put(values[k], choice);
      add(choice);
    }
  PipelineSettings least = cheapest();
  least.contact_threshold_mm = base.contact_threshold_mm;
  add(least);
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

std::string key_of(const PipelineSettings& choice) {
  std::string key;
  for (const auto& setting : pipeline_settings())
    key += (key.empty() ? "" : " ") + setting.name + '=' + setting.get(choice);
  return key;
}

}  // namespace alltact
