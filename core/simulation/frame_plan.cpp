#include "core/simulation/frame_plan.h"

namespace alltact {

FramePlan::FramePlan(const Scene::Content& content, std::uint64_t seed, int frame) {
  const int frame_of_scene = frame % content.time.frames;
  for (const auto& named : content.effects) {
    if (!named.presence.holds(frame_of_scene)) continue;
    const auto add = [&]<class E>(std::vector<Step<E>>& steps) {
      steps.push_back({&named,
                       static_cast<const E*>(named.effect.get()),
                       {seed ^ named.stream, frame, content.motion, content.finger, seed}});
      ++build_count().steps;
    };
    switch (named.kind->stage) {
      case Stage::kGeometry:
        add(geometry);
        break;
      case Stage::kRadiance:
        add(radiance);
        break;
      case Stage::kSensor:
        add(sensor);
        gives_bytes_ = gives_bytes_ || sensor.back().effect->gives_bytes();
        break;
      case Stage::kTransport:
        add(transport);
        break;
    }
  }
}

std::vector<const Scene::Content::Named*> FramePlan::effects() const {
  std::vector<const Scene::Content::Named*> all;
  const auto take = [&](const auto& steps) {
    for (const auto& step : steps) all.push_back(step.named);
  };
  take(geometry), take(radiance), take(sensor), take(transport);
  return all;
}

}  // namespace alltact
