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

 private:
  bool gives_bytes_ = false;
};

}  // namespace alltact
