// What to simulate, as data: a finger, its motion, and a list of named effects.
#pragma once

#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/simulation/effect.h"
#include "core/simulation/scene_time.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// An effect of a scene.
struct SceneEffect {
  const EffectKind* kind;
  std::string name;  ///< the kind's; the second of a kind is "ball#2", and so on
  Presence presence;
  std::uint64_t stream;  ///< changes the scene's seed for its draws; 0 for the first of a kind
  std::shared_ptr<const Effect> effect;
  std::string where;  ///< in the file, for errors
};

/// A scene after reading and format checks: a finger and a list of effects with parameters.
/// Presence is the only switch: effects that are not listed are not built. Unknown effects and keys
/// are errors with file, line and key.
struct Scene {
  static Result<Scene> load(const std::filesystem::path& file);
  /// `origin` names the text in errors.
  static Result<Scene> parse(std::string_view yaml, const std::string& origin);

  std::string name;
  std::string why;  ///< purpose of its effects
  Finger finger;    ///< camera, face, markers; nothing calibrated
  SceneTime time;

  // Of the undeformed finger, Fin Ray only: the view face's middle line starts at `base_mm`, forms
  // `incline_rad` with x and is `length_mm` long.
  Eigen::Vector3d base_mm = Eigen::Vector3d::Zero();
  double incline_rad = 0;
  double length_mm = 0;

  Motion motion;
  std::vector<SceneEffect> effects;  ///< in running order
};

}  // namespace alltact
