#include "core/sensing/face/face_runs.h"

#include <algorithm>
#include <numeric>

namespace alltact {
namespace {

/// Sorts runs that were closed column by column by rows and counts their pixels.
FaceRuns by_rows(const std::vector<FaceRun>& closed, int height) {
  FaceRuns result;
  result.row_begin.assign(static_cast<std::size_t>(height) + 1, 0);
  for (const FaceRun& run : closed) ++result.row_begin[static_cast<std::size_t>(run.row) + 1];
  for (std::size_t r = 1; r < result.row_begin.size(); ++r)
    result.row_begin[r] += result.row_begin[r - 1];
  std::vector<std::uint32_t> next = result.row_begin;
  result.runs.resize(closed.size());
  for (const FaceRun& run : closed) result.runs[next[static_cast<std::size_t>(run.row)]++] = run;
  std::uint32_t pixels = 0;
  for (FaceRun& run : result.runs) {
    run.before = pixels;
    pixels += static_cast<std::uint32_t>(run.size());
  }
  return result;
}

}  // namespace

FaceRuns face_runs(const FaceShape& shape,
                   double margin_px,
                   const cv::Size& size,
                   const cv::Range& columns) {
  const int width = std::min(size.width, shape.width_px());
  // First column of a row's open run
  std::vector<int> open(static_cast<std::size_t>(size.height), 0);
  std::vector<FaceRun> closed;
  closed.reserve(static_cast<std::size_t>(size.height));
  FaceShape::Rows before{0, -1};
  for (int u = 0; u <= width; ++u) {
    FaceShape::Rows here{0, -1};
    if (u < width && u >= columns.start && u < columns.end) {
      const auto [first, last] = shape.rows(u, margin_px);
      here = {std::max(first, 0), std::min(last, size.height - 1)};
    }
    const auto close = [&](int first, int last) {
      for (int row = first; row <= last; ++row)
        closed.push_back({row, open[static_cast<std::size_t>(row)], u, 0});
    };
    const auto begin = [&](int first, int last) {
      for (int row = first; row <= last; ++row) open[static_cast<std::size_t>(row)] = u;
    };
    // Rows of one range that are not in the other, above it and below it.
    const bool is_empty = here.first > here.last, was_empty = before.first > before.last;
    if (is_empty || was_empty) {
      close(before.first, before.last);
      begin(here.first, here.last);
    } else {
      close(before.first, std::min(before.last, here.first - 1));
      close(std::max(before.first, here.last + 1), before.last);
      begin(here.first, std::min(here.last, before.first - 1));
      begin(std::max(here.first, before.last + 1), here.last);
    }
    before = here;
  }
  return by_rows(closed, size.height);
}

double mean_brightness(const cv::Mat& grey, const FaceRuns& face) {
  constexpr int kRowStride = 16;
  double sum = 0, count = 0;
  for (int row = kRowStride / 2; row < grey.rows; row += kRowStride)
    for (const FaceRun& run : face.of_row(row)) {
      const std::uint8_t* values = grey.ptr<std::uint8_t>(row);
      sum += std::accumulate(values + run.first, values + run.end, 0);
      count += run.size();
    }
  return std::max(1.0, sum / std::max(1.0, count));
}

}  // namespace alltact
