#include "core/sensing/reference/face_image.h"

#include "core/sensing/reference/cubic_sampler.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kFaceMarginPx =
    2.0;  // around the face, because sampled positions lie between pixels

/// Columns of one row that lie between the edges of the grid's chart.
std::vector<FaceRun> runs_of(const FaceGrid& grid, int row) {
  std::vector<FaceRun> runs;
  bool is_open = false;
  for (int u = 0; u < grid.size.width; ++u) {
    const auto i = static_cast<std::size_t>(u);
    const double v = row + grid.origin.y;
    const bool is_face =
        v >= grid.chart.upper_v[i] - kFaceMarginPx && v <= grid.chart.lower_v[i] + kFaceMarginPx;
    if (is_face && !is_open) runs.push_back({row, u, u, 0});
    if (is_face) runs.back().end = u + 1;
    is_open = is_face;
  }
  return runs;
}

}  // namespace

FaceGrid face_grid(const FaceChart& rest, double part) {
  FaceGrid grid;
  grid.chart = widened(rest, part);
  const double top = *std::min_element(grid.chart.upper_v.begin(), grid.chart.upper_v.end());
  const double bottom = *std::max_element(grid.chart.lower_v.begin(), grid.chart.lower_v.end());
  grid.origin = {grid.chart.first, static_cast<int>(std::floor(top - kFaceMarginPx)) - 1};
  grid.size = {static_cast<int>(grid.chart.along_mm.size()),
               static_cast<int>(std::ceil(bottom + kFaceMarginPx)) + 2 - grid.origin.y};
  std::uint32_t pixels = 0;
  grid.runs.row_begin.push_back(0);
  for (int row = 0; row < grid.size.height; ++row) {
    for (FaceRun run : runs_of(grid, row)) {
      run.before = pixels;
      pixels += static_cast<std::uint32_t>(run.size());
      grid.runs.runs.push_back(run);
    }
    grid.runs.row_begin.push_back(static_cast<std::uint32_t>(grid.runs.runs.size()));
  }
  return grid;
}

FaceImage warp_face(const cv::Mat& grey, const FaceChart& chart, const FaceGrid& grid) {
  const ChartWarp warp(grid.chart, chart);
  FaceImage image;
  image.first = warp.inner_first() - grid.origin.x;
  image.end = warp.inner_end() - grid.origin.x;
  image.grey.assign(grid.runs.pixels(), 0);
  const CubicSampler seen(grey);
  std::vector<float> u(static_cast<std::size_t>(grid.size.width)), v(u.size());
  for (const FaceRun& run : grid.runs.runs) {
    const int first = std::max(run.first, image.first), end = std::min(run.end, image.end);
    if (first >= end) continue;
    warp.positions(run.row + grid.origin.y, first + grid.origin.x, end - first, u.data(), v.data());
    seen.sample(
        u.data(), v.data(), end - first, image.grey.data() + run.before + (first - run.first));
  }
  return image;
}

}  // namespace alltact
