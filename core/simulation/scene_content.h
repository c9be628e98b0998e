// Content of a Scene; for the simulation's own files.
#pragma once

#include "core/finger/finger.h"
#include "core/simulation/effect.h"
#include "core/simulation/scene.h"
#include "core/simulation/scene_time.h"

#include <cstdint>
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

// The effects that are present in one frame.

/// Built anew for every frame, so that rendering does not test for presence.
class FramePlan {
 public:
  FramePlan(const Scene::Content& content, std::uint64_t seed, int frame);

  template <class E>
  struct Step {
    const Scene::Content::Named* named;
    const E* effect;
    FrameContext context;  ///< with the seed of this effect's draws
  };
  // In running order.
  std::vector<Step<GeometryEffect>> geometry;
  std::vector<Step<RadianceEffect>> radiance;
  std::vector<Step<SensorEffect>> sensor;
  std::vector<Step<TransportEffect>> transport;

  /// True: the image has integer grey levels.
  [[nodiscard]] bool outputs_bytes() const { return outputs_bytes_; }
  [[nodiscard]] std::vector<const Scene::Content::Named*> effects() const;
  /// True: an effect needs more than a row at a time.
  [[nodiscard]] bool is_multi_pass() const { return is_multi_pass_; }
  [[nodiscard]] const Exposure& exposure() const { return exposure_; }
  /// Moves everything to so many frames after the frame's own time.
  void move_to(double frame_offset);

  /// What the effects of the frame may ask about each other.
  struct Facts {
    const Finger& finger;
    double length_mm, frames_per_s;
    std::vector<std::string> named;
    int lamp_count;
    std::vector<PressKind> press_kinds;
    const ElasticFinger* elastic;
    [[nodiscard]] SceneFacts scene() const {
      return {finger, length_mm, named, frames_per_s, lamp_count, press_kinds, elastic};
    }
  };
  [[nodiscard]] Facts facts(const Scene::Content& content) const;

 private:
  bool outputs_bytes_ = false, is_multi_pass_ = false;
  Exposure exposure_;
};

}  // namespace alltact
