// Content of a Scene; for the simulation's own files.
#pragma once

#include "core/finger/finger.h"
#include "core/simulation/effect.h"
#include "core/simulation/motion.h"
#include "core/simulation/scene.h"
#include "core/simulation/scene_time.h"

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct Scene::Content {
  std::string name, why;
  Finger finger;  // camera, face, markers; nothing calibrated
  SceneTime time;

  // Of the undeformed finger, Fin Ray only: the view face's middle line starts at `base_mm`, forms
  // `incline_rad` with x and is `length_mm` long.
  Eigen::Vector3d base_mm = Eigen::Vector3d::Zero();
  double incline_rad = 0;
  double length_mm = 0;

  Motion motion;
  struct Named {
    const EffectKind* kind;
    std::string name;  // the kind's; the second of a kind is "ball#2", and so on
    Presence presence;
    std::uint64_t stream;  // changes the scene's seed for its draws; 0 for the first of a kind
    std::shared_ptr<const Effect> effect;
    std::string where;  // in the file, for errors
  };
  std::vector<Named> effects;  // in running order
};

}  // namespace alltact
