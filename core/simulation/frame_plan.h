// What one frame is made of: the effects that are present in it, and no others.
#pragma once

#include "core/simulation/effect.h"
#include "core/simulation/scene_content.h"

#include <cstdint>
#include <string>
#include <vector>

namespace alltact {

/// Made anew for every frame, so that rendering it asks no more what is present.
class FramePlan {
 public:
  FramePlan(const Scene::Content& content, std::uint64_t seed, int frame);

  template <class E>
  struct Step {
    const Scene::Content::Named* named;
    const E* effect;
    FrameContext context;  ///< with the seed of this effect's draws
  };
  // In the order they run.
  std::vector<Step<GeometryEffect>> geometry;
  std::vector<Step<RadianceEffect>> radiance;
  std::vector<Step<SensorEffect>> sensor;
  std::vector<Step<TransportEffect>> transport;

  /// True: the picture is of whole grey levels.
  [[nodiscard]] bool gives_bytes() const { return gives_bytes_; }
  [[nodiscard]] std::vector<const Scene::Content::Named*> effects() const;
  /// True: an effect needs more than a row at a time.
  [[nodiscard]] bool in_passes() const { return in_passes_; }
  [[nodiscard]] const Exposure& exposure() const { return exposure_; }
  /// From now on everything is where it is so many frames after the frame's own moment.
  void move_to(double later);

  /// What the effects of the frame may ask of one another.
  struct Facts {
    const Finger& finger;
    double length_mm, frames_per_s;
    std::vector<std::string> named;
    int lamp_count;
    std::vector<PressKind> pressed;
    const ElasticFinger* elastic;
    [[nodiscard]] SceneFacts scene() const {
      return {finger, length_mm, named, frames_per_s, lamp_count, pressed, elastic};
    }
  };
  [[nodiscard]] Facts facts(const Scene::Content& content) const;

 private:
  bool gives_bytes_ = false, in_passes_ = false;
  Exposure exposure_;
};

}  // namespace alltact
