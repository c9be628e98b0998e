// How what was said of presses stands in YAML, for the two files that keep it.
#pragma once

#include "calibration/calibration_inputs.h"
#include "core/finger/yaml_reader.h"
#include "core/finger/yaml_writer.h"

#include <vector>

namespace alltact {

inline constexpr double kLargestBallMm = 1000;  ///< radius; a larger one is a slip of the pen

/// `ball_radius_mm`. Refuses what no ball has.
[[nodiscard]] double read_ball_radius_mm(YamlSection& top);
/// `balls` and `balls_mm`, `excluded` and `excluded_because`; nothing where the first is absent.
/// Refuses lists of different lengths and impossible values.
[[nodiscard]] std::vector<PlacedBall> read_placed_balls(YamlSection& top);
[[nodiscard]] std::vector<ExcludedPress> read_excluded_presses(YamlSection& top);

/// `other_balls` and `other_balls_mm`.
[[nodiscard]] std::vector<OtherBall> read_other_balls(YamlSection& top);

void add_other_balls(const std::vector<OtherBall>& balls, YamlBlock& block);
void add_placed_balls(const std::vector<PlacedBall>& balls, YamlBlock& block);
void add_excluded_presses(const std::vector<ExcludedPress>& excluded, YamlBlock& block);

}  // namespace alltact
