#include "core/simulation/scene_time.h"

#include "core/printable.h"

#include <charconv>
#include <cmath>
#include <string_view>

namespace alltact {

namespace {

constexpr double kLatest = 1e9;      // frames or seconds
constexpr double kSameFrame = 1e-6;  // rounding tolerance of a frame's time

// The first frame at or after a point in time.
int frame_from(double point, const SceneTime& time) {
  return static_cast<int>(std::ceil(std::min(point, double(time.frames)) - kSameFrame));
}

}  // namespace

SceneTime SceneTime::of(const YamlSection& part) {
  YamlSection scene = part.top();
  return {scene.integer_or("frames", 1, 1, 1000000),
          scene.number_or("frames_per_s", 30, {0.1, 10000})};
}

double SceneTime::point(YamlSection& section, const std::string& key) const {
  const std::string text = section.text(key);
  std::string_view number = text;
  const bool in_seconds = number.ends_with('s');
  if (in_seconds) number.remove_suffix(1);
  while (in_seconds && number.ends_with(' ')) number.remove_suffix(1);
  double value = -1;
  const auto [end, status] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (status != std::errc{} || end != number.data() + number.size() ||
      !(value >= 0 && value <= kLatest))
    section.refuse(key,
                   en::say("must be a point in time, not '{}'", printable(text)),
                   en::say("a frame such as 60, or seconds such as 2 s"));
  return in_seconds ? value * frames_per_s : value;
}

Presence Presence::read(YamlSection& effect, const SceneTime& time) {
  Presence presence{0, time.frames};
  if (effect.has("from")) {
    presence.first = frame_from(time.point(effect, "from"), time);
    if (presence.first >= time.frames)
      effect.refuse("from",
                    en::say("the scene ends before that"),
                    en::say("one of its frames, 0 to {}", time.frames - 1));
  }
  if (effect.has("until")) {
    presence.end = frame_from(time.point(effect, "until"), time);
    if (presence.end <= presence.first)
      effect.refuse("until",
                    en::say("it would never be there, for it begins with frame {}", presence.first),
                    en::say("a later frame, or leave the effect out"));
  }
  return presence;
}

}  // namespace alltact
