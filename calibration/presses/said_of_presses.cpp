#include "calibration/presses/said_of_presses.h"

#include "core/printable.h"

#include <charconv>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace alltact {
namespace {

/// NAME=REST at the last sign; nullopt: there is no name, or no sign.
struct Named {
  std::string name;
  std::string_view rest;
};
std::optional<Named> named(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0) return std::nullopt;
  return Named{text.substr(0, sign), std::string_view(text).substr(sign + 1)};
}

/// The whole of a text as a number above 0 and up to `most`.
std::optional<double> length_mm(std::string_view text, double most) {
  double mm = 0;
  const char* end = text.data() + text.size();
  const auto [read, failed] = std::from_chars(text.data(), end, mm);
  if (failed != std::errc{} || read != end || !(mm > 0.0) || !(mm <= most)) return std::nullopt;
  return mm;
}

template <class T>
void keep(const std::set<std::string>& presses, std::vector<T>& list) {
  std::erase_if(list, [&](const T& one) { return !presses.contains(one.name); });
}

template <class T>
void sort_by_name(std::vector<T>& list) {
  std::sort(list.begin(), list.end(), [](const T& a, const T& b) { return a.name < b.name; });
}

}  // namespace

std::set<std::string> SaidOfPresses::names() const {
  std::set<std::string> names;
  const auto add = [&](const auto& list) {
    for (const auto& one : list) names.insert(one.name);
  };
  add(other_balls), add(depths), add(steps), add(balls), add(excluded);
  return names;
}

SaidOfPresses SaidOfPresses::only(const std::set<std::string>& presses) const {
  SaidOfPresses said = *this;
  keep(presses, said.other_balls);
  keep(presses, said.depths);
  keep(presses, said.steps);
  keep(presses, said.balls);
  keep(presses, said.excluded);
  return said;
}

SaidOfPresses SaidOfPresses::by_name() const {
  SaidOfPresses said = *this;
  sort_by_name(said.other_balls);
  sort_by_name(said.depths);
  sort_by_name(said.steps);
  sort_by_name(said.balls);
  sort_by_name(said.excluded);
  return said;
}

double SaidOfPresses::radius_of(const std::string& press) const {
  const OtherBall* other = said_of(other_balls, press);
  return other == nullptr ? ball_radius_mm : other->radius_mm;
}

Result<OtherBall> other_ball_from(const std::string& text) {
  const auto parts = named(text);
  const auto mm = parts ? length_mm(parts->rest, kLargestBallMm) : std::nullopt;
  if (!mm)
    return Error{
        en::say("'{}' is not NAME=R, a press and its ball's radius in mm", printable(text)),
        "",
        ""};
  return OtherBall{parts->name, *mm};
}

std::string to_text(const OtherBall& ball) {
  return fmt::format("{}={}", ball.name, ball.radius_mm);
}

Result<PressDepth> press_depth_from(const std::string& text) {
  const Error wrong{en::say("'{}' is not NAME=MM+-SD, a press, how deep its ball was pressed "
                            "in and how well that is known, in mm",
                            printable(text)),
                    "",
                    ""};
  const auto parts = named(text);
  if (!parts) return wrong;
  std::string_view depth = parts->rest, sd;
  std::optional<double> sd_mm = kUsualDepthSdMm;
  for (const std::string_view sign : {"+-", "±"}) {
    const std::size_t at = depth.find(sign);
    if (at == std::string_view::npos) continue;
    sd_mm = length_mm(depth.substr(at + sign.size()), kDeepestMm);
    depth = depth.substr(0, at);
    break;
  }
  const auto mm = length_mm(depth, kDeepestMm);
  if (!mm || !sd_mm) return wrong;
  return PressDepth{parts->name, {*mm, *sd_mm}};
}

std::string to_text(const PressDepth& depth) {
  return fmt::format("{}={}+-{}", depth.name, depth.depth.mm, depth.depth.sd_mm);
}

Result<PressStep> press_step_from(const std::string& text) {
  const auto parts = named(text);
  const auto mm = parts ? length_mm(parts->rest, kDeepestMm) : std::nullopt;
  if (!mm)
    return Error{en::say("'{}' is not NAME=MM, a press and the height of its punch's step in "
                         "mm",
                         printable(text)),
                 "",
                 ""};
  return PressStep{parts->name, *mm};
}

std::string to_text(const PressStep& step) {
  return fmt::format("{}={}", step.name, step.step_mm);
}

ExcludedPress excluded_press_from(const std::string& text) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos) return {text, ""};
  return {text.substr(0, sign), text.substr(sign + 1)};
}

std::string to_text(const ExcludedPress& press) {
  return press.because.empty() ? press.name : press.name + '=' + press.because;
}

}  // namespace alltact
