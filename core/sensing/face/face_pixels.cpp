#include "core/sensing/face/face_pixels.h"

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

FaceRuns face_runs(const FaceShape& shape, double margin_px, const cv::Size& size,
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

cv::Range columns_of(const FaceRegion& region, const FaceShape& shape) {
  if (region == FaceRegion{}) return cv::Range::all();
  int first = shape.width_px(), end = 0;
  for (int u = 0; u < shape.width_px(); ++u) {
    const double mm = shape.length_at(u);
    if (mm < region.from_mm || mm > region.to_mm) continue;
    first = std::min(first, u);
    end = u + 1;
  }
  return first < end ? cv::Range(first, end) : cv::Range(0, 0);
}

namespace {

// Straight line through two trusted columns at a distance, evaluated at u.
struct Continuation {
  int from = 0, inner = 0;  // outermost trusted column and one further in

  float at(const std::vector<float>& v, int u) const {
    const float a = v[static_cast<std::size_t>(from)];
    if (inner == from) return a;
    const float slope = (a - v[static_cast<std::size_t>(inner)]) / static_cast<float>(from - inner);
    return a + slope * static_cast<float>(u - from);
  }
};

void continue_edge(std::vector<float>& v, const std::vector<int>& trusted, int reach) {
  const int width = static_cast<int>(v.size());
  const Continuation left{trusted.front(), std::min(trusted.front() + reach, trusted.back())};
  const Continuation right{trusted.back(), std::max(trusted.back() - reach, trusted.front())};
  for (int u = 0; u < left.from; ++u) v[static_cast<std::size_t>(u)] = left.at(v, u);
  for (int u = right.from + 1; u < width; ++u) v[static_cast<std::size_t>(u)] = right.at(v, u);
  for (std::size_t i = 1; i < trusted.size(); ++i)
    for (int u = trusted[i - 1] + 1; u < trusted[i]; ++u) {
      const float t =
          static_cast<float>(u - trusted[i - 1]) / static_cast<float>(trusted[i] - trusted[i - 1]);
      v[static_cast<std::size_t>(u)] = (1 - t) * v[static_cast<std::size_t>(trusted[i - 1])] +
                                       t * v[static_cast<std::size_t>(trusted[i])];
    }
}

}  // namespace

SideEdges::SideEdges(const FaceShape& shape) {
  const auto& columns = shape.columns();
  const std::size_t width = columns.size();
  upper.assign(width, 0.0F);
  lower.assign(width, 0.0F);
  std::vector<int> trusted;
  trusted.reserve(width);
  for (std::size_t u = 0; u < width; ++u) {
    if (!columns[u].valid) continue;
    trusted.push_back(static_cast<int>(u));
    upper[u] = static_cast<float>(columns[u].upper_v);
    lower[u] = static_cast<float>(columns[u].lower_v);
  }
  if (trusted.empty() || trusted.size() == width) return;
  // The end columns of the fit are its least certain; a twentieth of the width stabilises the
  // slope.
  const int reach = std::max(1, static_cast<int>(width) / 20);
  continue_edge(upper, trusted, reach);
  continue_edge(lower, trusted, reach);
  for (std::size_t u = 0; u < width; ++u)
    if (upper[u] > lower[u]) upper[u] = lower[u] = 0.5F * (upper[u] + lower[u]);
}

}  // namespace alltact
