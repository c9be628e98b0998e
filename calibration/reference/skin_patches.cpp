#include "calibration/reference/skin_patches.h"

#include "core/grey_range.h"
#include "core/numerics/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace alltact {
namespace {

// Next to the face's edges a shift of a tenth of a pixel is visible as a change of brightness.
constexpr double kPatchRimPx = 1.5, kRimMm = 1.0;
constexpr double kEndMm = 4.0;     // from either end of the visible part: light ends there
constexpr float kMinPixels = 2;    // of a patch
constexpr float kMaxHidden = 0.1;  // maximum fraction of a patch that a frame does not show

/// Arc length from the face's base of a column of the grid; below 0 before it.
double length_at(const FaceChart& chart, std::size_t column) {
  return chart.base_at_low_u ? chart.along_mm[column] : -chart.along_mm[column];
}

/// By pixel of the grid's runs, its patch; -1 where there is none.
std::vector<std::int32_t> patch_of_pixels(const FaceGrid& grid, SkinPatches& patches) {
  const FaceChart& chart = grid.chart;
  const auto [from_mm, to_mm] =
      std::minmax({length_at(chart, 0), length_at(chart, chart.along_mm.size() - 1)});
  patches.begin_mm = from_mm;
  patches.along = std::max(1, static_cast<int>((to_mm - from_mm) / patches.along_mm));
  std::vector<std::int32_t> patch(grid.runs.pixels(), -1);
  for (const FaceRun& run : grid.runs.runs)
    for (int u = run.first; u < run.end; ++u) {
      const auto column = static_cast<std::size_t>(u);
      const double v = run.row + grid.origin.y;
      const double upper = chart.upper_v[column], lower = chart.lower_v[column];
      if (v < upper + kPatchRimPx || v > lower - kPatchRimPx) continue;
      const double t = (v - upper) / (lower - upper);
      if (std::min(t, 1 - t) * patches.width_mm < kRimMm) continue;
      const int i =
          static_cast<int>((length_at(chart, column) - patches.begin_mm) / patches.along_mm);
      const int j = std::min(patches.across - 1, static_cast<int>(t * patches.across));
      if (i >= patches.along) continue;
      patch[run.before + static_cast<std::uint32_t>(u - run.first)] = i * patches.across + j;
    }
  return patch;
}

/// The part of the face, mm from its base, that a frame shows well within its ends.
struct Shown {
  double from_mm, to_mm;
};
Shown shown_of(const FaceGrid& grid, const FaceImage& face) {
  if (face.first >= face.end) return {1.0, 0.0};
  const auto [from_mm, to_mm] =
      std::minmax({length_at(grid.chart, static_cast<std::size_t>(face.first)),
                   length_at(grid.chart, static_cast<std::size_t>(face.end - 1))});
  return {from_mm + kEndMm, to_mm - kEndMm};
}

}  // namespace

SkinPatches skin_patches(const FaceGrid& grid,
                         const std::vector<FaceImage>& faces,
                         double face_width_mm,
                         double patch_mm) {
  SkinPatches patches;
  patches.along_mm = patch_mm;
  patches.width_mm = face_width_mm;
  patches.across = std::max(3, static_cast<int>(std::lround(face_width_mm / patch_mm)));
  patches.across_mm = face_width_mm / patches.across;
  const std::vector<std::int32_t> patch = patch_of_pixels(grid, patches);
  const auto count = static_cast<std::size_t>(patches.count());
  patches.pixels.assign(count, 0.0F);
  for (const std::int32_t p : patch)
    if (p >= 0) patches.pixels[static_cast<std::size_t>(p)] += 1;
  patches.log_level.resize(static_cast<Eigen::Index>(faces.size()), patches.count());
  patches.log_level.setConstant(std::numeric_limits<float>::quiet_NaN());
  parallel_for(static_cast<int>(faces.size()), default_threads(), [&](int first, int last) {
    std::vector<std::uint32_t> sum(count), seen(count);
    for (int i = first; i < last; ++i) {
      const FaceImage& face = faces[static_cast<std::size_t>(i)];
      std::fill(sum.begin(), sum.end(), 0);
      std::fill(seen.begin(), seen.end(), 0);
      for (const FaceRun& run : grid.runs.runs)
        for (int u = std::max(run.first, face.first); u < std::min(run.end, face.end); ++u) {
          const std::uint32_t pixel = run.before + static_cast<std::uint32_t>(u - run.first);
          const std::int32_t p = patch[pixel];
          if (p < 0 || face.grey[pixel] >= kClippedFrom) continue;
          sum[static_cast<std::size_t>(p)] += face.grey[pixel];
          ++seen[static_cast<std::size_t>(p)];
        }
      const Shown visible = shown_of(grid, face);
      for (std::size_t p = 0; p < count; ++p) {
        const double s_mm = patches.s_mm(static_cast<int>(p));
        if (s_mm < visible.from_mm || s_mm > visible.to_mm) continue;
        const float pixels = patches.pixels[p];
        const auto shown = static_cast<float>(seen[p]);
        if (pixels < kMinPixels || shown < (1 - kMaxHidden) * pixels) continue;
        const float level = static_cast<float>(sum[p]) / shown;
        if (level < kTooDarkBelow) continue;
        patches.log_level(i, static_cast<Eigen::Index>(p)) = std::log(level);
      }
    }
  });
  return patches;
}

}  // namespace alltact
