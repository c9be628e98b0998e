// The loop from brightness difference to depth, over one 1920 x 1080 picture.
#include "core/finger/mapping.h"

#include <vector>

#include <benchmark/benchmark.h>

namespace {

using alltact::Mapping;
using alltact::MappingKind;
using alltact::MappingParameters;

void run(benchmark::State& state, const MappingParameters& parameters) {
  const Mapping mapping = *Mapping::create(parameters);
  constexpr int kPixels = 1920 * 1080;
  std::vector<float> x(kPixels), depth(kPixels);
  for (int i = 0; i < kPixels; ++i) x[i] = static_cast<float>(i % 1000) * 8e-4F - 0.1F;
  for ([[maybe_unused]] const auto _ : state) {
    mapping.depths_mm(x.data(), depth.data(), kPixels);
    benchmark::DoNotOptimize(depth.data());
  }
  state.counters["ns_per_px"] =
      benchmark::Counter(1e-9 * kPixels * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void polynomial_depths(benchmark::State& state) {
  MappingParameters parameters;
  parameters.x_max = 0.62;
  parameters.chebyshev.assign(static_cast<std::size_t>(state.range(0)), 0.01);
  parameters.chebyshev[0] = 2;
  run(state, parameters);
}
BENCHMARK(polynomial_depths)->Arg(3)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);

void moebius_depths(benchmark::State& state) {
  MappingParameters parameters;
  parameters.kind = MappingKind::kMoebius;
  parameters.x_max = 0.62;
  parameters.a_mm = 2.5;
  parameters.b = 0.7;
  run(state, parameters);
}
BENCHMARK(moebius_depths)->Unit(benchmark::kMillisecond);

}  // namespace
