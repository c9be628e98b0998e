#include "calibration/presses/press_yaml.h"

namespace alltact {
namespace {

void refuse_unless_paired(YamlSection& top, const char* key, std::size_t count, std::size_t names) {
  if (count != names)
    top.refuse(key,
               en::say("has {} entries for {} presses", count, names),
               en::say("one for each press, \"\" where there is nothing to say"));
}

constexpr Limits kRadiusMm{0, kLargestBallMm, true}, kLengthMm{0, kDeepestMm, true};
constexpr Limits kPlaceMm{-10000, 10000};  // of a ball, from the camera

std::vector<PlacedBall> read_placed_balls(YamlSection& top) {
  std::vector<PlacedBall> balls;
  if (!top.has("balls")) return balls;
  const auto names = top.texts("balls");
  const auto centres = top.rows("balls_mm", kPlaceMm);
  refuse_unless_paired(top, "balls_mm", centres.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::vector<double>& c = centres[i];
    if (c.size() != 3 || !(c[2] > 0))
      top.refuse("balls_mm",
                 en::say("is not the centre of a ball before the camera"),
                 en::say("x, y, z in mm"));
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
  const auto radii_mm = top.numbers("other_balls_mm", kRadiusMm);
  refuse_unless_paired(top, "other_balls_mm", radii_mm.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) balls.push_back({names[i], radii_mm[i]});
  return balls;
}

std::vector<PressDepth> read_depths(YamlSection& top) {
  std::vector<PressDepth> depths;
  if (!top.has("depths")) return depths;
  const auto names = top.texts("depths");
  const auto rows = top.rows("depths_mm", kLengthMm);
  refuse_unless_paired(top, "depths_mm", rows.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::vector<double>& row = rows[i];
    if (row.size() != 2)
      top.refuse("depths_mm",
                 en::say("must hold two numbers for each press"),
                 en::say("a depth and its standard deviation in mm"));
    depths.push_back({names[i], {row[0], row[1]}});
  }
  return depths;
}

std::vector<PressStep> read_steps(YamlSection& top) {
  std::vector<PressStep> steps;
  if (!top.has("steps")) return steps;
  const auto names = top.texts("steps");
  const auto heights_mm = top.numbers("steps_mm", kLengthMm);
  refuse_unless_paired(top, "steps_mm", heights_mm.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) steps.push_back({names[i], heights_mm[i]});
  return steps;
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

void add_depths(const std::vector<PressDepth>& depths, YamlBlock& block) {
  if (depths.empty()) return;
  std::vector<std::string> names, rows;
  for (const PressDepth& press : depths) {
    names.push_back(yaml_text(press.name));
    rows.push_back(yaml_numbers({press.depth.mm, press.depth.sd_mm}));
  }
  block.add("depths", yaml_list(names));
  block.add("depths_mm", yaml_list(rows));
}

void add_steps(const std::vector<PressStep>& steps, YamlBlock& block) {
  if (steps.empty()) return;
  std::vector<std::string> names, heights;
  for (const PressStep& press : steps) {
    names.push_back(yaml_text(press.name));
    heights.push_back(yaml_number(press.step_mm));
  }
  block.add("steps", yaml_list(names));
  block.add("steps_mm", yaml_list(heights));
}

}  // namespace

double read_ball_radius_mm(YamlSection& top) {
  return top.number("ball_radius_mm", kRadiusMm);
}

SaidOfPresses read_said_of_presses(YamlSection& top) {
  return {top.has("ball_radius_mm") ? read_ball_radius_mm(top) : 0.0,
          read_other_balls(top),
          read_depths(top),
          read_steps(top),
          read_placed_balls(top),
          read_excluded_presses(top)};
}

void add_said_of_presses(const SaidOfPresses& said, YamlBlock& block) {
  add_other_balls(said.other_balls, block);
  add_depths(said.depths, block);
  add_steps(said.steps, block);
  add_placed_balls(said.balls, block);
  add_excluded_presses(said.excluded, block);
}

}  // namespace alltact
