#include "core/sensing/reference_picture.h"

#include "core/numerics/blocks.h"
#include "core/numerics/dispatch.h"
#include "core/sensing/grey_steps.h"
#include "core/sensing/picture_pool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr int kWeightBits = 14;  // weights reach 2
constexpr double kMostWeight = 3.0;

// (grey 2^7) (weight 2^14) / 2^15 = grey weight 2^6. Sums may wrap around on the way: what comes
// out in the end fits.
ALLTACT_WIDE void mix_rows(const std::uint8_t* const* rows,
                           const std::int16_t* weights,
                           int count,
                           int n,
                           std::int16_t* __restrict out) {
  constexpr int kFactor = 1 << 7;
  static_assert(kGreySteps << (15 - kWeightBits) == kFactor);
  in_blocks(
      n, [=](int first, auto size) __attribute__((always_inline)) {
        // Widened in a loop of its own: inside the sum the compiler would carry 32-bit numbers.
        std::array<std::int16_t, kBlock> sum, wide;
        for (int i = 0; i < size; ++i) sum[static_cast<std::size_t>(i)] = 0;
        for (int k = 0; k < count; ++k) {
          const std::uint8_t* grey = rows[k] + first;
          const std::int16_t weight = weights[k];
          for (int i = 0; i < size; ++i)
            wide[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(grey[i] * kFactor);
          for (int i = 0; i < size; ++i) {
            std::int16_t& here = sum[static_cast<std::size_t>(i)];
            here =
                static_cast<std::int16_t>(here + times(wide[static_cast<std::size_t>(i)], weight));
          }
        }
        for (int i = 0; i < size; ++i) out[first + i] = sum[static_cast<std::size_t>(i)];
      });
}

/// Each number with the one after it.
ALLTACT_WIDE void pair_up(const std::int16_t* __restrict values,
                          int count,
                          std::int32_t* __restrict pairs) {
  for (int i = 0; i < count; ++i)
    pairs[i] = static_cast<std::int32_t>(static_cast<std::uint16_t>(values[i])) |
               static_cast<std::int32_t>(values[i + 1]) * 65536;
}

/// Bilinear, to 1/128 of a pixel. In three loops a block: the first and the last run in vectors,
/// which one loop with the loads in it would not.
ALLTACT_WIDE void look_up(const std::int32_t* __restrict pairs,
                          const cv::Size& size,
                          const cv::Point& origin,
                          const float* __restrict u,
                          const float* __restrict v,
                          int count,
                          std::int16_t* __restrict out) {
  constexpr int kBits = 7;
  const int stride = size.width, last_u = (size.width - 1) << kBits,
            last_v = ((size.height - 1) << kBits) - 1;
  const auto from_u = static_cast<float>(origin.x), from_v = static_cast<float>(origin.y);
  in_blocks(
      count, [=](int first, auto n) __attribute__((always_inline)) {
        std::array<std::int32_t, kBlock> place, part_u, part_v, top, bottom;
        for (int i = 0; i < n; ++i) {
          const auto k = static_cast<std::size_t>(i);
          // Never outside, whatever the shape of the face came to.
          int fixed_u = static_cast<int>((u[first + i] - from_u) * (1 << kBits) + 0.5F);
          int fixed_v = static_cast<int>((v[first + i] - from_v) * (1 << kBits) + 0.5F);
          fixed_u = fixed_u > 0 ? fixed_u : 0;
          fixed_u = fixed_u < last_u ? fixed_u : last_u;
          fixed_v = fixed_v > 0 ? fixed_v : 0;
          fixed_v = fixed_v < last_v ? fixed_v : last_v;
          part_u[k] = fixed_u & ((1 << kBits) - 1);
          part_v[k] = fixed_v & ((1 << kBits) - 1);
          place[k] = (fixed_v >> kBits) * stride + (fixed_u >> kBits);
        }
        for (int i = 0; i < n; ++i) {
          const auto k = static_cast<std::size_t>(i);
          top[k] = pairs[place[k]];
          bottom[k] = pairs[place[k] + stride];
        }
        for (int i = 0; i < n; ++i) {
          const auto k = static_cast<std::size_t>(i);
          const int a = static_cast<std::int16_t>(top[k]), b = top[k] >> 16;
          const int c = static_cast<std::int16_t>(bottom[k]), d = bottom[k] >> 16;
          const int above = (a << kBits) + (b - a) * part_u[k],
                    below = (c << kBits) + (d - c) * part_u[k];
          const int sum = (above << kBits) + (below - above) * part_v[k];
          out[first + i] = static_cast<std::int16_t>((sum + (1 << (2 * kBits - 1))) >> (2 * kBits));
        }
      });
}

// Rounded so that they still sum to 1: what is left over goes to the largest.
std::vector<std::int16_t> whole_weights(const std::vector<float>& weights) {
  constexpr double kOne = 1 << kWeightBits;
  std::vector<std::int16_t> whole(weights.size());
  double left = kOne, magnitude = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double weight = static_cast<double>(weights[i]);
    whole[i] = static_cast<std::int16_t>(std::clamp(std::round(kOne * weight), -32767.0, 32767.0));
    left -= whole[i];
    magnitude += std::abs(weight);
  }
  CV_Assert(magnitude <= kMostWeight && std::abs(left) < 0.01 * kOne);
  std::int16_t& largest = *std::max_element(whole.begin(), whole.end());
  largest = static_cast<std::int16_t>(std::min(largest + left, 32767.0));
  return whole;
}

}  // namespace

ReferencePicture::ReferencePicture(const cv::Mat& grey)
    : single_(grey.size(), CV_16SC1), size_(grey.size()) {
  CV_Assert(grey.type() == CV_32FC1);
  for (int v = 0; v < grey.rows; ++v)
    std::transform(
        grey.ptr<float>(v), grey.ptr<float>(v) + grey.cols, single_.ptr<std::int16_t>(v), to_steps);
}

ReferencePicture::ReferencePicture(const FaceGrid& grid,
                                   const std::vector<const FacePicture*>& faces,
                                   const std::vector<float>& weights,
                                   const FaceChart& now,
                                   const cv::Size& size)
    : origin_(grid.origin), warp_(now, grid.chart), size_(size) {
  CV_Assert(!faces.empty() && faces.size() == weights.size());
  mix(grid, faces, weights);
  // The part of the warp that stays within the columns that all faces show.
  int shown_first = 0, shown_end = grid.size.width;
  for (const FacePicture* face : faces) {
    shown_first = std::max(shown_first, face->first);
    shown_end = std::min(shown_end, face->end);
  }
  const auto is_shown = [&](int u) {
    const auto [low, high] = warp_.reach(u);
    return low >= shown_first + grid.origin.x && high <= shown_end - 1 + grid.origin.x;
  };
  first_ = std::max(0, warp_.first());
  end_ = std::min(size.width, warp_.end());
  while (first_ < end_ && !is_shown(first_)) ++first_;
  while (first_ < end_ && !is_shown(end_ - 1)) --end_;
}

void ReferencePicture::mix(const FaceGrid& grid,
                           const std::vector<const FacePicture*>& faces,
                           const std::vector<float>& weights) {
  const std::vector<std::int16_t> whole = whole_weights(weights);
  pairs_ = pooled_picture(grid.size, CV_32SC1);
  std::vector<const std::uint8_t*> rows(faces.size());
  std::vector<std::int16_t> sum(static_cast<std::size_t>(grid.size.width) + 1);
  for (const FaceRun& run : grid.runs.runs) {
    for (std::size_t k = 0; k < faces.size(); ++k) rows[k] = faces[k]->grey.data() + run.before;
    mix_rows(rows.data(), whole.data(), static_cast<int>(rows.size()), run.size(), sum.data());
    sum[static_cast<std::size_t>(run.size())] = sum[static_cast<std::size_t>(run.size()) - 1];
    auto* pairs = pairs_.ptr<std::int32_t>(run.row);
    pair_up(sum.data(), run.size(), pairs + run.first);
    // Where the face's edge is steep, what is looked up may lie a little beside the run.
    constexpr int kBeside = 3;
    std::fill(pairs + std::max(0, run.first - kBeside), pairs + run.first, pairs[run.first]);
    std::fill(
        pairs + run.end, pairs + std::min(grid.size.width, run.end + kBeside), pairs[run.end - 1]);
  }
}

cv::Mat ReferencePicture::grey() const {
  if (size_.empty()) return {};
  cv::Mat grey = pooled_picture(size_, CV_32FC1);
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
      if (const double t = warp_.across(u, v); t >= 0.0 && t <= 1.0)
        runs.push_back({v, u, u + 1, 0});
    const std::int16_t* row = reader.row(v, runs);
    for (const FaceRun& run : runs)
      std::transform(row + run.first, row + run.end, grey.ptr<float>(v) + run.first, level);
  }
  return grey;
}

ReferencePicture::Reader::Reader(const ReferencePicture& picture)
    : picture_(picture),
      u_(static_cast<std::size_t>(picture.size_.width)),
      v_(u_.size()),
      buffer_(u_.size(), kNoGrey) {}

const std::int16_t* ReferencePicture::Reader::row(int v, std::span<const FaceRun> runs) {
  if (picture_.is_single()) return picture_.single_.ptr<std::int16_t>(v);
  for (const FaceRun& run : runs) {
    const int first = std::clamp(picture_.first_, run.first, run.end);
    const int end = std::clamp(picture_.end_, first, run.end);
    std::fill(buffer_.data() + run.first, buffer_.data() + first, kNoGrey);
    std::fill(buffer_.data() + end, buffer_.data() + run.end, kNoGrey);
    if (first == end) continue;
    picture_.warp_.places(v, first, end - first, u_.data(), v_.data());
    look_up(picture_.pairs_.ptr<std::int32_t>(0),
            picture_.pairs_.size(),
            picture_.origin_,
            u_.data(),
            v_.data(),
            end - first,
            buffer_.data() + first);
  }
  return buffer_.data();
}

}  // namespace alltact
