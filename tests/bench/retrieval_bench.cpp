// Finding the nearest recorded layout, beside a copy of the same bytes.
#include "core/sensing/reference/recorded_poses.h"

#include <cmath>
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

/// A finger of 12 markers that wanders through three modes of motion, a frame a thirtieth of a
/// second.
Eigen::MatrixXd motion(Eigen::Index frames) {
  Eigen::MatrixXd rows(frames, kMarkers);
  for (Eigen::Index i = 0; i < frames; ++i) {
    const double t = static_cast<double>(i) / 30.0;
    const double bend = 40 * std::sin(0.9 * t), curl = 15 * std::sin(0.37 * t + 1),
                 sway = 10 * std::sin(0.211 * t + 2);
    for (Eigen::Index m = 0; m < kMarkers / 2; ++m) {
      const double along = static_cast<double>(m % 6) / 5;
      rows(i, 2 * m) = 100 + 150 * along + bend * along * along;
      rows(i, 2 * m + 1) = (m < 6 ? 80 : 460) + curl * along * (1 - along) + sway * along;
    }
  }
  return rows;
}

/// Time of one retrieval in a recording of so many frames, its memory beside.
void retrieval_of_a_finger(benchmark::State& state) {
  const Eigen::MatrixXd layouts = motion(state.range(0));
  const LayoutSearch search(layouts);
  std::vector<Markers> asked;
  std::mt19937 random(2);
  std::normal_distribution<double> off(0, 0.3);
  for (Eigen::Index i = 7; asked.size() < 64; i = (i + 7919) % layouts.rows()) {
    Markers& markers = asked.emplace_back(static_cast<std::size_t>(kMarkers / 2));
    for (std::size_t m = 0; m < markers.size(); ++m)
      markers[m] = {layouts(i, static_cast<Eigen::Index>(2 * m)) + off(random),
                    layouts(i, static_cast<Eigen::Index>(2 * m + 1)) + off(random), m % 5 != 0,
                    0.05};
  }
  std::size_t next = 0;
  for ([[maybe_unused]] const auto _ : state)
    benchmark::DoNotOptimize(search.nearest(asked[next++ % asked.size()]));
  state.counters["MB"] = static_cast<double>(search.memory_bytes()) / 1e6;
  state.SetComplexityN(state.range(0));
}
BENCHMARK(retrieval_of_a_finger)
    ->RangeMultiplier(10)
    ->Range(100, 100000)
    ->Complexity()
    ->Unit(benchmark::kMicrosecond);

void retrieval(benchmark::State& state) {
  const LayoutSearch search(layouts());
  Markers markers(kMarkers);
  for (int m = 0; m < kMarkers; ++m)
    markers[static_cast<std::size_t>(m)] = {40.0 * m, 300.0 + m, true, 0.05};
  for ([[maybe_unused]] const auto _ : state) benchmark::DoNotOptimize(search.nearest(markers));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * kFrames * kMarkers * 8);
}
BENCHMARK(retrieval)->Unit(benchmark::kMicrosecond);

void copy_of_the_same_bytes(benchmark::State& state) {
  std::vector<float> from(static_cast<std::size_t>(kFrames) * kMarkers * 2, 1.0F), to(from.size());
  for ([[maybe_unused]] const auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size() * sizeof(float));
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * kFrames * kMarkers * 8);
}
BENCHMARK(copy_of_the_same_bytes)->Unit(benchmark::kMicrosecond);

}  // namespace
