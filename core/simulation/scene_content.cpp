#include "core/simulation/scene_content.h"

namespace alltact {

FramePlan::FramePlan(const Scene::Content& content, std::uint64_t seed, int frame) {
  const int frame_of_scene = frame % content.time.frames;
  for (const auto& named : content.effects) {
    if (!named.presence.holds(frame_of_scene)) continue;
    const auto add = [&]<class E>(std::vector<Step<E>>& steps) {
      steps.push_back({&named,
                       static_cast<const E*>(named.effect.get()),
                       {seed ^ named.stream,
                        frame,
                        content.motion,
                        content.finger,
                        content.time.frames_per_s,
                        seed}});
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
        outputs_bytes_ = outputs_bytes_ || sensor.back().effect->outputs_bytes();
        is_multi_pass_ = is_multi_pass_ || sensor.back().effect->needs_full_image();
        break;
      case Stage::kTransport:
        add(transport);
        break;
    }
  }
  if (sensor.empty()) return;
  const Facts known = facts(content);
  for (const auto& step : sensor) step.effect->expose(known.scene(), exposure_);
  is_multi_pass_ = is_multi_pass_ || !exposure_.is_instantaneous();
}

void FramePlan::move_to(double frame_offset) {
  for (auto& step : geometry) step.context.frame_offset = frame_offset;
  for (auto& step : radiance) step.context.frame_offset = frame_offset;
}

FramePlan::Facts FramePlan::facts(const Scene::Content& content) const {
  Facts facts{content.finger, content.length_mm, content.time.frames_per_s, {}, 0, {}, nullptr};
  for (const auto* named : effects()) {
    facts.named.push_back(named->kind->name);
    facts.lamp_count += named->effect->lamp_count();
    if (const auto kind = named->effect->presses()) facts.press_kinds.push_back(*kind);
    if (const ElasticFinger* elastic = named->effect->elastic()) facts.elastic = elastic;
  }
  return facts;
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
