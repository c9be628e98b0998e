// What rendering a scene costs, and what each named effect adds (frame time, one thread).
#include "core/simulation/plan.h"

#include <benchmark/benchmark.h>

namespace alltact {
namespace {

void render_scene(benchmark::State& state, const char* name, int threads) {
  const auto scene =
      Scene::load(std::string(ALLTACT_SOURCE_DIR "/resources/scenes/") + name + ".yaml");
  if (!scene) return state.SkipWithError(scene.error().sentence().c_str());
  const auto plan = Plan::compile(*scene, 1);
  if (!plan) return state.SkipWithError(plan.error().sentence().c_str());
  int frame = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(plan->render(frame++ % plan->frame_count(), threads));
}

BENCHMARK_CAPTURE(render_scene, two_effects, "two_effects", 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(render_scene, two_effects_2_threads, "two_effects", 2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(render_scene, demo_reference, "demo_reference", 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(render_scene, demo_presses, "demo_presses", 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(render_scene, demo_t, "demo_t", 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(render_scene, flat_press, "flat_press", 1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace alltact
