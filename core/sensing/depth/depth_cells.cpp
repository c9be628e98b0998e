#include "core/sensing/depth/depth_cells.h"

#include "core/numerics/dispatch.h"

#include <algorithm>

namespace alltact {
namespace {

ALLTACT_WIDE void add(const float* __restrict depth, int count, float* __restrict sum) {
  for (int u = 0; u < count; ++u)
    sum[u] += depth[u] == depth[u] ? depth[u] : 0.0F;  // NaN is not itself
}

ALLTACT_WIDE void average_columns(const float* __restrict sum, int cells, float* __restrict mean) {
  static_assert(kDepthCellPx == 4);
  for (int x = 0; x < cells; ++x) {
    const float* four = sum + 4 * x;
    mean[x] = (four[0] + four[1] + four[2] + four[3]) / 16;
  }
}

}  // namespace

DepthCells::DepthCells(const cv::Size& image_size)
    : image_size_(image_size),
      mean_mm_((image_size.height + kDepthCellPx - 1) / kDepthCellPx,
               (image_size.width + kDepthCellPx - 1) / kDepthCellPx,
               CV_32FC1),
      sum_(static_cast<std::size_t>(mean_mm_.cols * kDepthCellPx), 0.0F) {}

void DepthCells::add_row(int row, std::span<const FaceRun> runs, const float* depth_mm) {
  for (const FaceRun& run : runs) add(depth_mm + run.first, run.size(), sum_.data() + run.first);
  if ((row + 1) % kDepthCellPx != 0 && row + 1 != image_size_.height) return;
  average_columns(sum_.data(), mean_mm_.cols, mean_mm_.ptr<float>(row / kDepthCellPx));
  std::fill(sum_.begin(), sum_.end(), 0.0F);
}

cv::Mat depth_cells(const cv::Mat& depth_mm) {
  DepthCells cells(depth_mm.size());
  for (int row = 0; row < depth_mm.rows; ++row) {
    const FaceRun full_row{row, 0, depth_mm.cols, 0};
    cells.add_row(row, {&full_row, 1}, depth_mm.ptr<float>(row));
  }
  return cells.mean_mm();
}

}  // namespace alltact
