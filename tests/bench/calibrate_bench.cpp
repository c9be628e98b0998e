// Six, ten and fifteen presses, choice of family and all: what a technician waits for.
#include "calibration/joint/calibrate.h"
#include "tests/support/made_press.h"

#include <random>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace alltact {
namespace {

void solve(benchmark::State& state, int count, double incline) {
  using namespace made;
  std::mt19937 random(1);
  std::vector<Press> presses;
  std::optional<MadeScene> scene;
  for (int i = 0; i < count; ++i) {
    scene = finger_scene(40.0, incline * (2.0 * i / count - 1.0));
    const Ball ball{380.0 + 240.0 * i / count, 220.0 + 120.0 * i / count, 4.0,
                    0.4 + 0.9 * i / count};
    presses.push_back(make_press(*scene, {}, {}, {ball}, 1.0, random, fmt::format("p{}", i)).press);
  }
  for ([[maybe_unused]] const auto _ : state) {
    auto result = calibrate(presses, scene->camera, scene->face, {}, Job{});
    if (!result) state.SkipWithError(result.error().sentence().c_str());
    benchmark::DoNotOptimize(result);
  }
}

// At one incline, and at inclines that also have to decide along what thickness is measured.
void six_presses(benchmark::State& state) { solve(state, 6, static_cast<double>(state.range(0))); }
BENCHMARK(six_presses)->Arg(0)->Arg(24)->Unit(benchmark::kMillisecond)->UseRealTime();

void ten_presses(benchmark::State& state) { solve(state, 10, static_cast<double>(state.range(0))); }
BENCHMARK(ten_presses)->Arg(0)->Arg(24)->Unit(benchmark::kMillisecond)->UseRealTime();

void fifteen_presses(benchmark::State& state) {
  solve(state, 15, static_cast<double>(state.range(0)));
}
BENCHMARK(fifteen_presses)->Arg(0)->Arg(24)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace alltact
