// The effects that are present in one frame.
#pragma once

#include "core/simulation/effect.h"
#include "core/simulation/scene_content.h"

#include <cstdint>
#include <string>
#include <vector>

namespace alltact {

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
