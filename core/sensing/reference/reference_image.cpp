#include "core/sensing/reference/reference_image.h"

#include "core/numerics/blocks.h"
#include "core/numerics/dispatch.h"
#include "core/sensing/reference/grey_steps.h"
#include "core/sensing/reference/image_pool.h"
#include "core/sensing/reference/warped_row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace alltact {
namespace {

constexpr int kWeightBits = 14;  // weights reach 2
constexpr double kMaxWeight = 3.0;
constexpr int kMarginColumns = 3;  // columns by which a run is extended
constexpr int kAhead = 512;  // bytes: several recorded faces are streamed from memory at a time

// (grey 2^7) (weight 2^14) / 2^15 = grey weight 2^6. Intermediate sums may wrap around; the final
// sum fits.
ALLTACT_WIDE void mix_rows(const std::uint8_t* const* rows,
                           const std::int16_t* weights,
                           int count,
                           int n,
                           std::int16_t* __restrict out) {
  constexpr int kFactor = 1 << 7;
  static_assert(kGreySteps << (15 - kWeightBits) == kFactor);
  in_blocks(
      n, [=](int first, auto size) __attribute__((always_inline)) {
        // Widened in a loop of its own: inside the sum the compiler would use 32-bit numbers.
        std::array<std::int16_t, kBlock> sum, wide;
        const auto widen = [&](int k) __attribute__((always_inline)) {
          const std::uint8_t* grey = rows[k] + first;
          __builtin_prefetch(grey + kAhead);
          for (int i = 0; i < size; ++i)
            wide[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(grey[i] * kFactor);
        };
        widen(0);
        for (int i = 0; i < size; ++i)
          sum[static_cast<std::size_t>(i)] =
              multiply_q15(wide[static_cast<std::size_t>(i)], weights[0]);
        for (int k = 1; k < count; ++k) {
          const std::int16_t weight = weights[k];
          widen(k);
          for (int i = 0; i < size; ++i) {
            std::int16_t& here = sum[static_cast<std::size_t>(i)];
            here = static_cast<std::int16_t>(
                here + multiply_q15(wide[static_cast<std::size_t>(i)], weight));
          }
        }
        for (int i = 0; i < size; ++i) out[first + i] = sum[static_cast<std::size_t>(i)];
      });
}

// Rounded so that they still sum to 1: the remainder goes to the largest.
std::vector<std::int16_t> fixed_weights(const std::vector<float>& weights) {
  constexpr double kOne = 1 << kWeightBits;
  std::vector<std::int16_t> rounded(weights.size());
  double left = kOne, magnitude = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double weight = static_cast<double>(weights[i]);
    rounded[i] =
        static_cast<std::int16_t>(std::clamp(std::round(kOne * weight), -32767.0, 32767.0));
    left -= rounded[i];
    magnitude += std::abs(weight);
  }
  CV_Assert(magnitude <= kMaxWeight && std::abs(left) < 0.01 * kOne);
  std::int16_t& largest = *std::max_element(rounded.begin(), rounded.end());
  largest = static_cast<std::int16_t>(std::min(largest + left, 32767.0));
  return rounded;
}

}  // namespace

ReferenceImage::ReferenceImage(const cv::Mat& grey)
    : single_(grey.size(), CV_16SC1), size_(grey.size()) {
  CV_Assert(grey.type() == CV_32FC1);
  for (int v = 0; v < grey.rows; ++v)
    std::transform(
        grey.ptr<float>(v), grey.ptr<float>(v) + grey.cols, single_.ptr<std::int16_t>(v), to_steps);
}

std::pair<int, int> FaceMix::shown(const FaceGrid& grid) const {
  int first = 0, end = grid.size.width;
  for (const FaceImage* face : faces)
    first = std::max(first, face->first), end = std::min(end, face->end);
  return {first, std::max(first, end)};
}

/// Columns of the grid for which one mix is used.
struct ReferenceImage::MixedColumns {
  const FaceMix& mix;
  int first, end;
  std::vector<std::int16_t> weights;
  std::vector<const std::uint8_t*> rows;  // of the faces, where a run begins

  MixedColumns(const FaceMix& of, int from, int to)
      : mix(of), first(from), end(to), weights(fixed_weights(of.weights)), rows(of.faces.size()) {
    CV_Assert(!mix.faces.empty() && mix.faces.size() == mix.weights.size());
  }

  /// Mixes the part of a run within these columns into a row of the grid.
  void mix_run(const FaceRun& run, std::int16_t* mixed) {
    const int from = std::max(run.first, first), to = std::min(run.end, end);
    if (from >= to) return;
    // A full block also for few columns, because partial vectors are slow.
    std::array<std::int16_t, kBlock> block;
    const bool is_narrow = to - from < kBlock && run.size() >= kBlock;
    const int begin = is_narrow ? std::min(from, run.end - kBlock) : from;
    for (std::size_t k = 0; k < rows.size(); ++k)
      rows[k] = mix.faces[k]->grey.data() + run.before + (begin - run.first);
    mix_rows(rows.data(),
             weights.data(),
             static_cast<int>(rows.size()),
             is_narrow ? kBlock : to - from,
             is_narrow ? block.data() : mixed + from);
    if (is_narrow) std::copy_n(block.data() + (from - begin), to - from, mixed + from);
    // Where the face's edge is steep, sampled positions may lie slightly outside of the run.
    if (from == run.first) std::fill(mixed + from - kMarginColumns, mixed + from, mixed[from]);
    if (to == run.end) std::fill(mixed + to, mixed + to + kMarginColumns, mixed[to - 1]);
  }
};

ReferenceImage::ReferenceImage(const FaceGrid& grid,
                               const std::vector<FaceMix>& mixes,
                               ChartWarp warp,
                               const cv::Size& size)
    : origin_(grid.origin), warp_(std::move(warp)), size_(size) {
  CV_Assert(!mixes.empty());
  std::pair<int, int> done = mixes.front().shown(grid);
  std::vector<MixedColumns> parts;
  const auto take = [&](const FaceMix& mix, int first, int end) {
    if (first < end) parts.emplace_back(mix, first, end);
  };
  take(mixes.front(), done.first, done.second);
  std::tie(inner_first_, inner_end_) = columns_within(done.first, done.second);
  for (std::size_t k = 1; k < mixes.size(); ++k) {
    const auto [first, end] = mixes[k].shown(grid);
    take(mixes[k], first, std::min(end, done.first));
    take(mixes[k], std::max(first, done.second), end);
    if (end >= done.first) done.first = std::min(done.first, first);
    if (first <= done.second) done.second = std::max(done.second, end);
  }
  std::tie(full_first_, full_end_) = columns_within(done.first, done.second);
  std::tie(first_, end_) = columns_overlapping(done.first, done.second);
  min_u_ = static_cast<float>(done.first + origin_.x);
  max_u_ = static_cast<float>(done.second - 1 + origin_.x);
  mix_and_warp(grid, parts);
}

namespace {

/// Trims the columns at both ends to those that fulfil the condition.
template <class IsInside>
std::pair<int, int> between(int low, int high, IsInside is_inside) {
  while (low < high && !is_inside(low)) ++low;
  while (low < high && !is_inside(high - 1)) --high;
  return {low, high};
}

}  // namespace

/// The part of the warp that stays within columns of the grid.
std::pair<int, int> ReferenceImage::columns_within(int first, int end) const {
  return between(
      std::max(0, warp_.inner_first()), std::min(size_.width, warp_.inner_end()), [&](int u) {
        const auto [low, high] = warp_.reach(u);
        return low >= first + origin_.x && high <= end - 1 + origin_.x;
      });
}

/// The part of the warp that overlaps columns of the grid.
std::pair<int, int> ReferenceImage::columns_overlapping(int first, int end) const {
  return between(std::max(0, warp_.first()), std::min(size_.width, warp_.end()), [&](int u) {
    const auto [low, high] = warp_.reach(u);
    return high >= first + origin_.x && low <= end - 1 + origin_.x;
  });
}

/// Mixes each row of the grid and warps it along the frame's columns at once.
void ReferenceImage::mix_and_warp(const FaceGrid& grid, std::vector<MixedColumns>& parts) {
  warped_ = pooled_image({size_.width + kWarpChunk, grid.size.height + 1}, CV_16SC1);
  warped_rows_ = grid.size.height;
  std::vector<std::int16_t> row(static_cast<std::size_t>(grid.size.width + 2 * kWarpChunk));
  std::int16_t* mixed = row.data() + kWarpChunk;
  for (const FaceRun& run : grid.runs.runs) {
    for (MixedColumns& part : parts) part.mix_run(run, mixed);
    const auto [first, end] =
        warp_.columns_reaching(static_cast<float>(run.first - kMarginColumns + origin_.x),
                               static_cast<float>(run.end + kMarginColumns + origin_.x));
    const int from = std::max(first, 0), to = std::min(end, size_.width);
    if (from >= to) continue;
    warp_along(mixed,
               {warp_.columns(),
                from - warp_.origin(),
                static_cast<float>(run.row + origin_.y),
                static_cast<float>(origin_.x),
                grid.size.width},
               to - from,
               warped_.ptr<std::int16_t>(run.row) + from);
  }
}

cv::Mat ReferenceImage::grey() const {
  if (size_.empty()) return {};
  cv::Mat grey = pooled_image(size_, CV_32FC1);
  fill_nan(grey.ptr<float>(0), static_cast<int>(grey.total()));
  Reader reader(*this);
  const auto level = [](std::int16_t steps) {
    return steps == kNoGrey ? std::numeric_limits<float>::quiet_NaN()
                            : static_cast<float>(steps) / static_cast<float>(kGreySteps);
  };
  for (int v = 0; v < size_.height; ++v) {
    std::vector<FaceRun> runs;
    if (is_single()) runs.push_back({v, 0, size_.width, 0});
    for (int u = first_; u < end_ && !is_single(); ++u)
      if (const double t = warp_.across(u, v); t >= 0.0 && t <= 1.0) {
        if (runs.empty() || runs.back().end != u) runs.push_back({v, u, u, 0});
        ++runs.back().end;
      }
    const std::int16_t* row = reader.row(v, runs);
    for (const FaceRun& run : runs)
      std::transform(row + run.first, row + run.end, grey.ptr<float>(v) + run.first, level);
  }
  return grey;
}

ReferenceImage::Reader::Reader(const ReferenceImage& image)
    : image_(image),
      u_(static_cast<std::size_t>(image.size_.width)),
      v_(u_.size()),
      buffer_(u_.size() + kWarpChunk, kNoGrey) {}

const std::int16_t* ReferenceImage::Reader::row(int v, std::span<const FaceRun> runs) {
  if (image_.is_single()) return image_.single_.ptr<std::int16_t>(v);
  for (const FaceRun& run : runs) {
    const int first = std::clamp(image_.first_, run.first, run.end);
    const int end = std::clamp(image_.end_, first, run.end);
    if (first == end) {
      std::fill(buffer_.data() + run.first, buffer_.data() + run.end, kNoGrey);
      continue;
    }
    warp_across(image_.warped_.ptr<std::int16_t>(0) + first,
                image_.warped_.cols,
                {image_.warp_.rows(),
                 first - image_.warp_.origin(),
                 static_cast<float>(v),
                 static_cast<float>(image_.origin_.y),
                 image_.warped_rows_},
                end - first,
                buffer_.data() + first);
    const int full = std::clamp(image_.full_first_, first, end);
    clear_hidden(v, first, full);
    clear_hidden(v, std::clamp(image_.full_end_, full, end), end);
    std::fill(buffer_.data() + run.first, buffer_.data() + first, kNoGrey);
    // and the excess of warp_across()
    std::fill(buffer_.data() + end, buffer_.data() + run.end, kNoGrey);
  }
  return buffer_.data();
}

void ReferenceImage::Reader::clear_hidden(int v, int first, int end) {
  if (first == end) return;
  image_.warp_.positions(v, first, end - first, u_.data(), v_.data());
  for (int u = first; u < end; ++u) {
    const float at_u = u_[static_cast<std::size_t>(u - first)];
    if (!(at_u >= image_.min_u_ && at_u <= image_.max_u_))
      buffer_[static_cast<std::size_t>(u)] = kNoGrey;
  }
}

}  // namespace alltact
