#include "core/sensing/reference/reference_picture.h"

#include "core/numerics/blocks.h"
#include "core/numerics/dispatch.h"
#include "core/sensing/reference/grey_steps.h"
#include "core/sensing/reference/laid_row.h"
#include "core/sensing/reference/picture_pool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace alltact {
namespace {

constexpr int kWeightBits = 14;  // weights reach 2
constexpr double kMostWeight = 3.0;
constexpr int kBeside = 3;   // columns that a run goes on for
constexpr int kAhead = 512;  // bytes: recorded faces come from afar, several side by side

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
        const auto widen = [&](int k) __attribute__((always_inline)) {
          const std::uint8_t* grey = rows[k] + first;
          __builtin_prefetch(grey + kAhead);
          for (int i = 0; i < size; ++i)
            wide[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(grey[i] * kFactor);
        };
        widen(0);
        for (int i = 0; i < size; ++i)
          sum[static_cast<std::size_t>(i)] = times(wide[static_cast<std::size_t>(i)], weights[0]);
        for (int k = 1; k < count; ++k) {
          const std::int16_t weight = weights[k];
          widen(k);
          for (int i = 0; i < size; ++i) {
            std::int16_t& here = sum[static_cast<std::size_t>(i)];
            here =
                static_cast<std::int16_t>(here + times(wide[static_cast<std::size_t>(i)], weight));
          }
        }
        for (int i = 0; i < size; ++i) out[first + i] = sum[static_cast<std::size_t>(i)];
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

std::pair<int, int> FaceMix::shown(const FaceGrid& grid) const {
  int first = 0, end = grid.size.width;
  for (const FacePicture* face : faces)
    first = std::max(first, face->first), end = std::min(end, face->end);
  return {first, std::max(first, end)};
}

/// Columns of the grid that one mix is taken for.
struct ReferencePicture::MixedColumns {
  const FaceMix& mix;
  int first, end;
  std::vector<std::int16_t> weights;
  std::vector<const std::uint8_t*> rows;  // of the faces, where a run begins

  MixedColumns(const FaceMix& of, int from, int to)
      : mix(of), first(from), end(to), weights(whole_weights(of.weights)), rows(of.faces.size()) {
    CV_Assert(!mix.faces.empty() && mix.faces.size() == mix.weights.size());
  }

  /// What of a run lies in these columns, into a row of the grid.
  void mix_run(const FaceRun& run, std::int16_t* mixed) {
    const int from = std::max(run.first, first), to = std::min(run.end, end);
    if (from >= to) return;
    // A whole block also where few columns are wanted: what does not fill vectors is slow.
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
    // Where the face's edge is steep, what is looked up may lie a little beside the run.
    if (from == run.first) std::fill(mixed + from - kBeside, mixed + from, mixed[from]);
    if (to == run.end) std::fill(mixed + to, mixed + to + kBeside, mixed[to - 1]);
  }
};

ReferencePicture::ReferencePicture(const FaceGrid& grid,
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
  std::tie(whole_first_, whole_end_) = columns_within(done.first, done.second);
  std::tie(first_, end_) = columns_touching(done.first, done.second);
  least_u_ = static_cast<float>(done.first + origin_.x);
  most_u_ = static_cast<float>(done.second - 1 + origin_.x);
  lay(grid, parts);
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

/// Each row of the grid is mixed and at once laid along the frame's columns.
void ReferencePicture::lay(const FaceGrid& grid, std::vector<MixedColumns>& parts) {
  laid_ = pooled_picture({size_.width + kLaidPiece, grid.size.height + 1}, CV_16SC1);
  laid_rows_ = grid.size.height;
  std::vector<std::int16_t> row(static_cast<std::size_t>(grid.size.width + 2 * kLaidPiece));
  std::int16_t* mixed = row.data() + kLaidPiece;
  for (const FaceRun& run : grid.runs.runs) {
    for (MixedColumns& part : parts) part.mix_run(run, mixed);
    const auto [first, end] =
        warp_.columns_into(static_cast<float>(run.first - kBeside + origin_.x),
                           static_cast<float>(run.end + kBeside + origin_.x));
    const int from = std::max(first, 0), to = std::min(end, size_.width);
    if (from >= to) continue;
    lay_along(mixed,
              {warp_.columns(),
               from - warp_.origin(),
               static_cast<float>(run.row + origin_.y),
               static_cast<float>(origin_.x),
               grid.size.width},
              to - from,
              laid_.ptr<std::int16_t>(run.row) + from);
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
      u_(static_cast<std::size_t>(picture.size_.width)),
      v_(u_.size()),
      buffer_(u_.size() + kLaidPiece, kNoGrey) {}

const std::int16_t* ReferencePicture::Reader::row(int v, std::span<const FaceRun> runs) {
  if (picture_.is_single()) return picture_.single_.ptr<std::int16_t>(v);
  for (const FaceRun& run : runs) {
    const int first = std::clamp(picture_.first_, run.first, run.end);
    const int end = std::clamp(picture_.end_, first, run.end);
    if (first == end) {
      std::fill(buffer_.data() + run.first, buffer_.data() + run.end, kNoGrey);
      continue;
    }
    lay_across(picture_.laid_.ptr<std::int16_t>(0) + first,
               picture_.laid_.cols,
               {picture_.warp_.rows(),
                first - picture_.warp_.origin(),
                static_cast<float>(v),
                static_cast<float>(picture_.origin_.y),
                picture_.laid_rows_},
               end - first,
               buffer_.data() + first);
    const int whole = std::clamp(picture_.whole_first_, first, end);
    clear_hidden(v, first, whole);
    clear_hidden(v, std::clamp(picture_.whole_end_, whole, end), end);
    std::fill(buffer_.data() + run.first, buffer_.data() + first, kNoGrey);
    std::fill(buffer_.data() + end, buffer_.data() + run.end, kNoGrey);  // and what is too much
  }
  return buffer_.data();
}

void ReferencePicture::Reader::clear_hidden(int v, int first, int end) {
  if (first == end) return;
  picture_.warp_.places(v, first, end - first, u_.data(), v_.data());
  for (int u = first; u < end; ++u) {
    const float at_u = u_[static_cast<std::size_t>(u - first)];
    if (!(at_u >= picture_.least_u_ && at_u <= picture_.most_u_))
      buffer_[static_cast<std::size_t>(u)] = kNoGrey;
  }
}

}  // namespace alltact
