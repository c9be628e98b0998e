// What it costs to bring the mesh of a face up to date, apart from drawing it.
#include "tests/support/made_surface.h"
#include "widgets/scene3d/face_mesh.h"

#include <cmath>
#include <cstring>

#include <benchmark/benchmark.h>

namespace alltact {
namespace {

/// Points, normals and colours of every vertex, beside a copy of the same bytes.
void mesh_update(benchmark::State& state) {
  const double side = std::sqrt(static_cast<double>(state.range(0)) * 16 / 9);
  const cv::Size grid(static_cast<int>(std::ceil(side)),
                      static_cast<int>(std::ceil(side * 9 / 16)));
  const FaceSurface surface = test::MadeSurface().make(grid.width, grid.height);
  FaceMesh mesh;
  for ([[maybe_unused]] const auto _ : state) {
    mesh.update(surface.untouched_mm, surface.depth_mm, 1, surface.depth_mm, {0, 1});
    benchmark::ClobberMemory();
  }
  state.counters["vertices"] = grid.area();
}
BENCHMARK(mesh_update)->Arg(25000)->Arg(100000)->Unit(benchmark::kMillisecond);

void mesh_copy(benchmark::State& state) {
  constexpr std::size_t kBytes = 3 * 4 + 3 * 4 + 3;  // of a vertex: place, normal, colour
  const std::vector<char> from(static_cast<std::size_t>(state.range(0)) * kBytes, 1);
  std::vector<char> to(from.size());
  for ([[maybe_unused]] const auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(mesh_copy)->Arg(25000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace alltact
