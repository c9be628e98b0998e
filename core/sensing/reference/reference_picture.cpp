#include "core/sensing/reference/reference_picture.h"

#include "core/numerics/blocks.h"
#include "core/numerics/dispatch.h"
#include "core/sensing/reference/grey_steps.h"
#include "core/sensing/reference/picture_pool.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>

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

constexpr int kBits = 7;    // of a place's fraction
constexpr int kPiece = 32;  // pixels that are looked up at a time: a vector of 16-bit numbers

/// Where the pixels of a piece lie in a picture: index of the one to the left above, and fractions.
struct Places {
  std::array<std::int32_t, kPiece> index;
  std::array<std::int16_t, kPiece> part_u, part_v;  // of 2^15
  /// 1 where the skin does not go on with the next number in memory.
  alignas(8) std::array<std::uint8_t, kPiece> jumps;
};

ALLTACT_WIDE void find_places(const float* __restrict u,
                              const float* __restrict v,
                              const cv::Size& size,
                              const cv::Point& origin,
                              Places& places) {
  const int stride = size.width, last_u = ((size.width - 1) << kBits) - 1,
            last_v = ((size.height - 1) << kBits) - 1;
  const auto from_u = static_cast<float>(origin.x), from_v = static_cast<float>(origin.y);
  constexpr int kMask = (1 << kBits) - 1, kShift = 15 - kBits;
  for (std::size_t i = 0; i < kPiece; ++i) {
    // Never outside, whatever the shape of the face came to.
    int fixed_u = static_cast<int>((u[i] - from_u) * (1 << kBits) + 0.5F);
    int fixed_v = static_cast<int>((v[i] - from_v) * (1 << kBits) + 0.5F);
    fixed_u = fixed_u > 0 ? fixed_u : 0;
    fixed_u = fixed_u < last_u ? fixed_u : last_u;
    fixed_v = fixed_v > 0 ? fixed_v : 0;
    fixed_v = fixed_v < last_v ? fixed_v : last_v;
    places.part_u[i] = static_cast<std::int16_t>((fixed_u & kMask) << kShift);
    places.part_v[i] = static_cast<std::int16_t>((fixed_v & kMask) << kShift);
    places.index[i] = (fixed_v >> kBits) * stride + (fixed_u >> kBits);
  }
  places.jumps[0] = 1;
  for (std::size_t i = 1; i < kPiece; ++i)
    places.jumps[i] = places.index[i] - places.index[i - 1] != 1;
}

/// The four numbers around each place.
struct Corners {
  // Copied a whole piece at a time, wherever it begins.
  std::array<std::int16_t, 2 * kPiece> a, b, c, d;
};

/// Skin that lies side by side in one picture mostly does so in the other: it is copied in runs,
/// which costs a quarter of looking up number by number.
void take_corners(const std::int16_t* picture, int stride, const Places& places, Corners& corners) {
  constexpr std::size_t kBytes = kPiece * sizeof(std::int16_t);
  for (std::size_t word = 0; word < kPiece; word += 8) {
    std::uint64_t jumps = 0;
    std::memcpy(&jumps, places.jumps.data() + word, sizeof jumps);
    for (; jumps != 0; jumps &= jumps - 1) {
      const std::size_t i = word + static_cast<std::size_t>(std::countr_zero(jumps)) / 8;
      const std::int16_t* from = picture + places.index[i];
      std::memcpy(corners.a.data() + i, from, kBytes);
      std::memcpy(corners.b.data() + i, from + 1, kBytes);
      std::memcpy(corners.c.data() + i, from + stride, kBytes);
      std::memcpy(corners.d.data() + i, from + stride + 1, kBytes);
    }
  }
}

ALLTACT_WIDE void blend(const Corners& corners, const Places& places, std::int16_t* out) {
  for (std::size_t i = 0; i < kPiece; ++i) {
    const std::int16_t a = corners.a[i], c = corners.c[i];
    const auto right_above = static_cast<std::int16_t>(corners.b[i] - a),
               right_below = static_cast<std::int16_t>(corners.d[i] - c);
    const auto above = static_cast<std::int16_t>(a + times(right_above, places.part_u[i])),
               below = static_cast<std::int16_t>(c + times(right_below, places.part_u[i]));
    out[i] = static_cast<std::int16_t>(
        above + times(static_cast<std::int16_t>(below - above), places.part_v[i]));
  }
}

/// Bilinear, to 1/128 of a pixel. `u`, `v` and `out` hold kPiece numbers more than `count`.
void look_up(const cv::Mat& picture,
             const cv::Size& size,
             const cv::Point& origin,
             const float* u,
             const float* v,
             int count,
             std::int16_t* out) {
  Places places;
  Corners corners;
  for (int first = 0; first < count; first += kPiece) {
    find_places(u + first, v + first, size, origin, places);
    take_corners(picture.ptr<std::int16_t>(0), size.width, places, corners);
    blend(corners, places, out + first);
  }
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

std::pair<int, int> FaceMix::shown(const FaceGrid& grid) const {
  int first = 0, end = grid.size.width;
  for (const FacePicture* face : faces)
    first = std::max(first, face->first), end = std::min(end, face->end);
  return {first, std::max(first, end)};
}

ReferencePicture::ReferencePicture(const FaceGrid& grid,
                                   const std::vector<FaceMix>& mixes,
                                   ChartWarp warp,
                                   const cv::Size& size)
    : mixed_(pooled_picture({grid.size.width, grid.size.height + 2 + 2 * kPiece / grid.size.width},
                            CV_16SC1)),
      mixed_rows_(grid.size.height),
      origin_(grid.origin),
      warp_(std::move(warp)),
      size_(size) {
  CV_Assert(!mixes.empty());
  std::pair<int, int> done = mixes.front().shown(grid);
  mix(grid, mixes.front(), done.first, done.second);
  std::tie(inner_first_, inner_end_) = columns_within(done.first, done.second);
  for (std::size_t k = 1; k < mixes.size(); ++k) {
    const auto [first, end] = mixes[k].shown(grid);
    mix(grid, mixes[k], first, std::min(end, done.first));
    mix(grid, mixes[k], std::max(first, done.second), end);
    if (end >= done.first) done.first = std::min(done.first, first);
    if (first <= done.second) done.second = std::max(done.second, end);
  }
  std::tie(whole_first_, whole_end_) = columns_within(done.first, done.second);
  std::tie(first_, end_) = columns_touching(done.first, done.second);
  least_u_ = static_cast<float>(done.first + origin_.x);
  most_u_ = static_cast<float>(done.second - 1 + origin_.x);
}

namespace {

/// The columns from the first to the last that are wanted.
template <class IsWanted>
std::pair<int, int> between(int low, int high, IsWanted is_wanted) {
  while (low < high && !is_wanted(low)) ++low;
  while (low < high && !is_wanted(high - 1)) --high;
  return {low, high};
}

}  // namespace

/// The part of the warp that stays within columns of the grid.
std::pair<int, int> ReferencePicture::columns_within(int first, int end) const {
  return between(
      std::max(0, warp_.inner_first()), std::min(size_.width, warp_.inner_end()), [&](int u) {
        const auto [low, high] = warp_.reach(u);
        return low >= first + origin_.x && high <= end - 1 + origin_.x;
      });
}

/// The part of the warp that comes into columns of the grid.
std::pair<int, int> ReferencePicture::columns_touching(int first, int end) const {
  return between(std::max(0, warp_.first()), std::min(size_.width, warp_.end()), [&](int u) {
    const auto [low, high] = warp_.reach(u);
    return high >= first + origin_.x && low <= end - 1 + origin_.x;
  });
}

void ReferencePicture::mix(const FaceGrid& grid, const FaceMix& mix, int first, int end) {
  if (first >= end) return;
  CV_Assert(!mix.faces.empty() && mix.faces.size() == mix.weights.size());
  const std::vector<std::int16_t> whole = whole_weights(mix.weights);
  std::vector<const std::uint8_t*> rows(mix.faces.size());
  for (const FaceRun& run : grid.runs.runs) {
    const int from = std::max(run.first, first), to = std::min(run.end, end);
    if (from >= to) continue;
    for (std::size_t k = 0; k < rows.size(); ++k)
      rows[k] = mix.faces[k]->grey.data() + run.before + (from - run.first);
    auto* mixed = mixed_.ptr<std::int16_t>(run.row);
    mix_rows(rows.data(), whole.data(), static_cast<int>(rows.size()), to - from, mixed + from);
    // Where the face's edge is steep, what is looked up may lie a little beside the run.
    constexpr int kBeside = 3;
    if (from == run.first)
      std::fill(mixed + std::max(0, from - kBeside), mixed + from, mixed[from]);
    if (to == run.end)
      std::fill(mixed + to, mixed + std::min(grid.size.width, to + kBeside), mixed[to - 1]);
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

ReferencePicture::Reader::Reader(const ReferencePicture& picture)
    : picture_(picture),
      u_(static_cast<std::size_t>(picture.size_.width) + kPiece),
      v_(u_.size()),
      buffer_(u_.size(), kNoGrey) {}

const std::int16_t* ReferencePicture::Reader::row(int v, std::span<const FaceRun> runs) {
  if (picture_.is_single()) return picture_.single_.ptr<std::int16_t>(v);
  for (const FaceRun& run : runs) {
    const int first = std::clamp(picture_.first_, run.first, run.end);
    const int end = std::clamp(picture_.end_, first, run.end);
    if (first == end) {
      std::fill(buffer_.data() + run.first, buffer_.data() + run.end, kNoGrey);
      continue;
    }
    picture_.warp_.places(v, first, end - first, u_.data(), v_.data());
    look_up(picture_.mixed_,
            {picture_.mixed_.cols, picture_.mixed_rows_},
            picture_.origin_,
            u_.data(),
            v_.data(),
            end - first,
            buffer_.data() + first);
    const auto clear_hidden = [&](int from, int to) {
      for (int u = from; u < to; ++u) {
        const float at_u = u_[static_cast<std::size_t>(u - first)];
        if (!(at_u >= picture_.least_u_ && at_u <= picture_.most_u_))
          buffer_[static_cast<std::size_t>(u)] = kNoGrey;
      }
    };
    const int whole = std::clamp(picture_.whole_first_, first, end);
    clear_hidden(first, whole);
    clear_hidden(std::clamp(picture_.whole_end_, whole, end), end);
    std::fill(buffer_.data() + run.first, buffer_.data() + first, kNoGrey);
    std::fill(buffer_.data() + end, buffer_.data() + run.end, kNoGrey);  // and what is too much
  }
  return buffer_.data();
}

}  // namespace alltact
