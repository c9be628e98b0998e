// Six presses, choice of family and all: what a technician waits for.
#include "calibration/calibrate.h"
#include "tests/support/made_press.h"

#include <random>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace alltact {
namespace {

void six_presses(benchmark::State& state) {
  using namespace made;
  std::mt19937 random(1);
  const double incline = static_cast<double>(state.range(0));
  std::vector<Press> presses;
  std::optional<Scene> scene;
  for (int i = 0; i < 6; ++i) {
    scene = finger_scene(40.0, incline * (i - 3) / 3.0);
    const Ball ball{380.0 + 40 * i, 220.0 + 20 * i, 4.0, 0.4 + 0.15 * i};
    presses.push_back(make_press(*scene, {}, {}, {ball}, 1.0, random, fmt::format("p{}", i)).press);
  }
  for (auto _ : state) {
    auto result = calibrate(presses, scene->camera, scene->face, {}, Job{});
    if (!result) state.SkipWithError(result.error().sentence().c_str());
    benchmark::DoNotOptimize(result);
  }
}
// At one incline, and at inclines that also have to decide along what thickness is measured.
BENCHMARK(six_presses)->Arg(0)->Arg(24)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace alltact
