#include "calibration/press_yaml.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace alltact {
namespace {

void refuse_unless_paired(YamlSection& top, const char* key, std::size_t count, std::size_t names) {
  if (count != names)
    top.refuse(key,
               fmt::format("has {} entries for {} presses", count, names),
               "one for each press, \"\" where there is nothing to say");
}

bool is_radius(double mm) {
  return mm > 0 && mm <= kLargestBallMm;
}

constexpr double kFarthestMm = 10000;  // of a ball from the camera
constexpr const char* kRadiusRange = "must be above 0 and at most 1000";

}  // namespace

double read_ball_radius_mm(YamlSection& top) {
  const double radius_mm = top.number("ball_radius_mm", "the ball's radius in mm");
  if (!is_radius(radius_mm)) top.refuse("ball_radius_mm", kRadiusRange, "the ball's radius in mm");
  return radius_mm;
}

std::vector<PlacedBall> read_placed_balls(YamlSection& top) {
  std::vector<PlacedBall> balls;
  if (!top.has("balls")) return balls;
  const auto names = top.texts("balls");
  const auto centres = top.rows("balls_mm");
  refuse_unless_paired(top, "balls_mm", centres.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::vector<double>& c = centres[i];
    const auto is_near = [](double mm) { return std::abs(mm) <= kFarthestMm; };
    if (c.size() != 3 || !std::all_of(c.begin(), c.end(), is_near) || !(c[2] > 0))
      top.refuse("balls_mm", "is not the centre of a ball before the camera", "x, y, z in mm");
    balls.push_back({names[i], {c[0], c[1], c[2]}});
  }
  return balls;
}

std::vector<ExcludedPress> read_excluded_presses(YamlSection& top) {
  std::vector<ExcludedPress> excluded;
  if (!top.has("excluded")) return excluded;
  const auto names = top.texts("excluded");
  const auto because = top.texts("excluded_because");
  refuse_unless_paired(top, "excluded_because", because.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) excluded.push_back({names[i], because[i]});
  return excluded;
}

std::vector<OtherBall> read_other_balls(YamlSection& top) {
  std::vector<OtherBall> balls;
  if (!top.has("other_balls")) return balls;
  const auto names = top.texts("other_balls");
  const auto radii_mm = top.numbers("other_balls_mm");
  refuse_unless_paired(top, "other_balls_mm", radii_mm.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!is_radius(radii_mm[i]))
      top.refuse("other_balls_mm", kRadiusRange, "the balls' radii in mm");
    balls.push_back({names[i], radii_mm[i]});
  }
  return balls;
}

void add_other_balls(const std::vector<OtherBall>& balls, YamlBlock& block) {
  if (balls.empty()) return;
  std::vector<std::string> names, radii;
  for (const OtherBall& ball : balls) {
    names.push_back(yaml_text(ball.name));
    radii.push_back(yaml_number(ball.radius_mm));
  }
  block.add("other_balls", yaml_list(names));
  block.add("other_balls_mm", yaml_list(radii));
}

void add_placed_balls(const std::vector<PlacedBall>& balls, YamlBlock& block) {
  if (balls.empty()) return;
  std::vector<std::string> names, centres;
  for (const PlacedBall& ball : balls) {
    names.push_back(yaml_text(ball.name));
    centres.push_back(yaml_numbers({ball.centre_mm.x(), ball.centre_mm.y(), ball.centre_mm.z()}));
  }
  block.add("balls", yaml_list(names));
  block.add("balls_mm", yaml_list(centres));
}

void add_excluded_presses(const std::vector<ExcludedPress>& excluded, YamlBlock& block) {
  if (excluded.empty()) return;
  std::vector<std::string> names, because;
  for (const ExcludedPress& press : excluded) {
    names.push_back(yaml_text(press.name));
    because.push_back(yaml_text(press.because));
  }
  block.add("excluded", yaml_list(names));
  block.add("excluded_because", yaml_list(because));
}

}  // namespace alltact
