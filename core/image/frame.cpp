#include "core/image/frame.h"

#include <map>

namespace alltact {
namespace {

constexpr std::string_view kBetween = "; ";

std::string without(std::string_view text, std::string_view forbidden) {
  std::string clean(text);
  for (char& c : clean)
    if (forbidden.find(c) != std::string_view::npos || static_cast<unsigned char>(c) < ' ') c = ' ';
  return clean;
}

std::map<std::string_view, std::string_view> entries_of(std::string_view settings) {
  std::map<std::string_view, std::string_view> entries;
  while (!settings.empty()) {
    const std::string_view entry = settings.substr(0, settings.find(kBetween));
    settings.remove_prefix(std::min(settings.size(), entry.size() + kBetween.size()));
    const std::size_t equals = entry.find('=');
    if (equals != std::string_view::npos)
      entries.emplace(entry.substr(0, equals), entry.substr(equals + 1));
  }
  return entries;
}

/// Controls are named by their camera; only these names are the program's.
Message name_of(std::string_view name) {
  if (name == "Camera") return en::say("Camera");
  if (name == "Serial number") return en::say("Serial number");
  if (name == "Format") return en::say("Format");
  if (name == "Light") return en::say("Light");
  return Message::typed(std::string(name));
}

}  // namespace

void add_setting(std::string& settings, std::string_view name, std::string_view value) {
  settings += fmt::format("{}{}={}", settings.empty() ? "" : kBetween, without(name, ";="),
                          without(value, ";"));
}

Message differences(std::string_view before, std::string_view now) {
  std::vector<Message> changes;
  const auto earlier = entries_of(before);
  for (const auto& [name, value] : entries_of(now)) {
    const auto old = earlier.find(name);
    if (old == earlier.end() || old->second == value) continue;
    changes.push_back(en::say("{} changed from {} to {}", name_of(name), std::string(old->second),
                              std::string(value)));
  }
  return en::list(changes);
}

void SettingsMonitor::add(const Frame& frame) {
  if (frame.controls == nullptr || frame.controls == last_) return;
  last_ = frame.controls;
  if (first_.empty()) first_ = *frame.controls;
  if (change_.empty()) change_ = differences(first_, *frame.controls);
}

}  // namespace alltact
