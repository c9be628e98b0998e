// Finding the nearest recorded layout, beside a copy of the same bytes.
#include "core/sensing/markers/layout_search.h"

#include <cstring>
#include <random>

#include <benchmark/benchmark.h>

namespace {

using alltact::LayoutSearch;
using alltact::Markers;

constexpr int kFrames = 1650, kMarkers = 24;

Eigen::MatrixXd layouts() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, 1000.0);
  Eigen::MatrixXd rows(kFrames, 2 * kMarkers);
  for (Eigen::Index i = 0; i < rows.size(); ++i) rows.data()[i] = place(random);
  return rows;
}

void retrieval(benchmark::State& state) {
  const LayoutSearch search(layouts());
  Markers markers(kMarkers);
  for (int m = 0; m < kMarkers; ++m)
    markers[static_cast<std::size_t>(m)] = {40.0 * m, 300.0 + m, true, 0.05};
  for (auto _ : state) benchmark::DoNotOptimize(search.nearest(markers));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * kFrames * kMarkers * 8);
}
BENCHMARK(retrieval)->Unit(benchmark::kMicrosecond);

void copy_of_the_same_bytes(benchmark::State& state) {
  std::vector<float> from(static_cast<std::size_t>(kFrames) * kMarkers * 2, 1.0F), to(from.size());
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size() * sizeof(float));
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * kFrames * kMarkers * 8);
}
BENCHMARK(copy_of_the_same_bytes)->Unit(benchmark::kMicrosecond);

}  // namespace
