// How what was said of presses stands in YAML, for the two files that keep it.
#pragma once

#include "calibration/presses/said_of_presses.h"
#include "core/yaml/yaml_reader.h"
#include "core/yaml/yaml_writer.h"

namespace alltact {

/// `ball_radius_mm`. Refuses what no ball has.
[[nodiscard]] double read_ball_radius_mm(YamlSection& top);

/// `ball_radius_mm`, 0 where it is absent; `other_balls` and `other_balls_mm`, `depths` and
/// `depths_mm`, `steps` and `steps_mm`, `balls` and `balls_mm`, `excluded` and `excluded_because`;
/// nothing where the first of two is absent. Refuses lists of different lengths and impossible
/// values.
[[nodiscard]] SaidOfPresses read_said_of_presses(YamlSection& top);
/// All but the radius.
void add_said_of_presses(const SaidOfPresses& said, YamlBlock& block);

}  // namespace alltact
