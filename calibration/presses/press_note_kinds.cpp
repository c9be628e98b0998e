#include "calibration/presses/press_note_kinds.h"

#include "core/base/message.h"
#include "core/base/typed_number.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

namespace alltact {
namespace {

using Text = std::optional<std::string>;

/// A complete text as a number above 0 and up to `max_mm`.
std::optional<double> length_mm(std::string_view text, double max_mm) {
  const auto mm = parse_typed_number(text, {DecimalMark::kPoint, "mm"});
  return mm && *mm > 0.0 && *mm <= max_mm ? std::optional(*mm) : std::nullopt;
}

Text number_text(const std::optional<double>& value) {
  return value ? Text(fmt::format("{}", *value)) : std::nullopt;
}

bool read_radius(const std::string& value, PressNote& note) {
  note.ball_radius_mm = length_mm(value, kLargestBallMm);
  return note.ball_radius_mm.has_value();
}

bool read_depth(const std::string& value, PressNote& note) {
  std::string_view depth = value;
  std::optional<double> sd_mm = kTypicalDepthSdMm;
  for (const std::string_view sign : {"+-", "±"}) {
    const std::size_t at = depth.find(sign);
    if (at == std::string_view::npos) continue;
    sd_mm = length_mm(depth.substr(at + sign.size()), kDeepestMm);
    depth = depth.substr(0, at);
    break;
  }
  const auto mm = length_mm(depth, kDeepestMm);
  if (!mm || !sd_mm) return false;
  note.depth = GivenDepth{*mm, *sd_mm};
  return true;
}

Text write_depth(const PressNote& note) {
  return note.depth ? Text(fmt::format("{}+-{}", note.depth->mm, note.depth->sd_mm)) : std::nullopt;
}

bool read_step(const std::string& value, PressNote& note) {
  note.step_mm = length_mm(value, kDeepestMm);
  return note.step_mm.has_value();
}

bool read_body(const std::string& value, PressNote& note) {
  if (value.empty()) return false;
  note.body = std::filesystem::absolute(value).string();
  return true;
}

bool read_ball(const std::string& value, PressNote& note) {
  std::string_view text = value;
  // With semicolons between them, the numbers may have decimal commas.
  const char parting = text.find(';') != std::string_view::npos ? ';' : ',';
  Eigen::Vector3d at;
  for (int i = 0; i < 3; ++i) {
    const std::size_t end = i < 2 ? text.find(parting) : std::min(text.find(parting), text.size());
    const bool has_rest = end < text.size() && i == 2;
    if (end == std::string_view::npos || has_rest) return false;
    const auto along = parse_typed_number(text.substr(0, end));
    if (!along || !(std::abs(*along) <= 1e4)) return false;
    at[i] = *along;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!(at.z() > 0)) return false;
  note.ball_mm = at;
  return true;
}

Text write_ball(const PressNote& note) {
  const auto& at = note.ball_mm;
  return at ? Text(fmt::format("{},{},{}", at->x(), at->y(), at->z())) : std::nullopt;
}

}  // namespace

const std::vector<PressNoteKind>& press_note_kinds() {
  static const std::vector<PressNoteKind> kinds{
      {"other-ball", "NAME=R",
       "A press made with a ball of another radius in mm, by its picture's name without the ending",
       "none", read_radius, [](const PressNote& note) { return number_text(note.ball_radius_mm); },
       [](PressNote& note) { note.ball_radius_mm.reset(); }},
      {"depth", "NAME=MM+-SD",
       "How deep a press' ball was pushed in, normal to the face from where it first touches, as a "
       "stage or a feeler gauge tells it, and how well that is known (0.02 where it is not said)",
       "none", read_depth, write_depth, [](PressNote& note) { note.depth.reset(); }},
      {"step", "NAME=MM",
       "A press made with a flat punch that has a step of this height, not with a ball", "none",
       read_step, [](const PressNote& note) { return number_text(note.step_mm); },
       [](PressNote& note) { note.step_mm.reset(); }},
      {"body", "NAME=FILE",
       "A press made with another body of known shape, not with a ball: its closed mesh, STL or "
       "OBJ in mm, which is copied into the finger's folder",
       "none", read_body, [](const PressNote& note) { return note.body; },
       [](PressNote& note) { note.body.reset(); }},
      {"ball", "NAME=X,Y,Z",
       "A press' ball put by hand where the fit is to begin, in mm before the camera", "find",
       read_ball, write_ball, [](PressNote& note) { note.ball_mm.reset(); }},
      {"exclude", "NAME[=WHY]", "A press to keep but not to use, and why", nullptr,
       [](const std::string& value, PressNote& note) {
         note.excluded = value;
         return true;
       },
       [](const PressNote& note) { return note.excluded; },
       [](PressNote& note) { note.excluded.reset(); }, true}};
  return kinds;
}

Status set_press_note(const PressNoteKind& kind, const std::string& text, PressSet& presses) {
  const std::size_t sign = kind.is_free_text ? text.find('=') : text.rfind('=');
  const bool has_value = sign != std::string::npos;
  const std::string name = text.substr(0, sign);
  const std::string value = has_value ? text.substr(sign + 1) : std::string();
  PressNote note = presses.of(name);
  bool is_valid = !name.empty() && (has_value || kind.is_free_text);
  if (is_valid && kind.reset_word != nullptr && value == kind.reset_word)
    kind.forget(note);
  else
    is_valid = is_valid && kind.read(value, note);
  if (!is_valid)
    return Error{en::say("'{}' is not of the form {}", printable(text), std::string(kind.form)), "",
                 ""};
  presses.say(name, std::move(note));
  return {};
}

std::vector<std::pair<std::string, std::string>> press_note_flags(const PressSet& presses) {
  std::vector<std::pair<std::string, std::string>> flags;
  for (const PressNoteKind& kind : press_note_kinds())
    for (const auto& [name, note] : presses.notes)
      if (const Text value = kind.write(note))
        flags.emplace_back(kind.flag, value->empty() ? name : name + '=' + *value);
  return flags;
}

}  // namespace alltact
