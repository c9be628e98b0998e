// What rendering a scene costs, and what each named effect adds (frame time, one thread).
#include "core/simulation/plan.h"
#include "tests/support/two_effects_by_hand.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include <benchmark/benchmark.h>

namespace alltact {
namespace {

void render_file(benchmark::State& state, const std::string& file, int threads) {
  const auto scene = Scene::load(ALLTACT_SOURCE_DIR "/" + file);
  if (!scene) return state.SkipWithError(scene.error().sentence().c_str());
  const auto plan = Plan::compile(*scene, 1);
  if (!plan) return state.SkipWithError(plan.error().sentence().c_str());
  int frame = 0;
  for ([[maybe_unused]] const auto _ : state)
    benchmark::DoNotOptimize(plan->render(frame++ % plan->frame_count(), threads));
}

void render_scene(benchmark::State& state, const char* name, int threads) {
  render_file(state, std::string("resources/scenes/") + name + ".yaml", threads);
}

template <class Render>
double time_ms(const Render& render) {
  const auto begin = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(render());
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  return taken.count();
}

// A Plan beside the loop that one would write instead of it, in turns; of ten turns the best of
// each make a pair, and of the pairs' ratios come the median and what eight of ten lie between.
void two_effects_beside_a_loop(benchmark::State& state) {
  constexpr int kPairs = 40, kTurns = 10;
  const auto scene = Scene::load(ALLTACT_SOURCE_DIR "/resources/scenes/two_effects.yaml");
  if (!scene) return state.SkipWithError(scene.error().sentence().c_str());
  const auto plan = Plan::compile(*scene, 1);
  if (!plan) return state.SkipWithError(plan.error().sentence().c_str());
  const PixelRays rays(Camera::create(plan->finger().camera).value());
  std::vector<double> ratios;
  for ([[maybe_unused]] const auto _ : state)
    for (int pair = 0; pair < kPairs; ++pair) {
      double of_plan = std::numeric_limits<double>::max(), of_loop = of_plan;
      for (int turn = 0; turn < kTurns; ++turn) {
        of_plan = std::min(of_plan, time_ms([&] { return plan->render(0); }));
        of_loop = std::min(of_loop,
                           time_ms([&] { return two_effects_by_hand(rays, plan->finger().face); }));
      }
      ratios.push_back(of_plan / of_loop);
    }
  std::sort(ratios.begin(), ratios.end());
  const auto at = [&](std::size_t percent) { return ratios[ratios.size() * percent / 100]; };
  state.counters["ratio"] = at(50);
  state.counters["ratio_p10"] = at(10);
  state.counters["ratio_p90"] = at(90);
}

BENCHMARK(two_effects_beside_a_loop)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(render_scene, five_effects, "five_effects", 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(render_file, sensor_effects, "tests/bench/sensor_effects.yaml", 1)
    ->Unit(benchmark::kMillisecond);
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
