#include "core/sensing/reference/image_warp.h"

#include "core/numerics/dispatch.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <vector>

namespace alltact {
namespace {

constexpr int kPositionBits = 11;  ///< of a position's fraction: 1/2048 px

/// Adjacent pixels of one image map to nearly adjacent positions in the other, so the positions of
/// a chunk differ by a few steps only. Instead of a gather, full chunks are read at each of these
/// steps, and every position selects the value at its own step.
template <std::size_t kCount>
struct PositionSteps {
  /// from `min_step` on; in units of 2^-15
  alignas(64) std::array<std::int16_t, kCount> steps, part;
  int min_step, max_step;  ///< integer steps
};

/// `fixed`: positions in units of 2^-kPositionBits px, each minus the advance of the read window.
/// Its content is undefined afterwards.
template <std::size_t kCount>
[[gnu::always_inline]] inline void find_steps(std::array<int, kCount>& fixed,
                                              PositionSteps<kCount>& piece) {
  constexpr int kFraction = (1 << kPositionBits) - 1;
  int min_fixed = fixed[0], max_fixed = fixed[0];
  for (const int position : fixed) {
    min_fixed = position < min_fixed ? position : min_fixed;
    max_fixed = position > max_fixed ? position : max_fixed;
  }
  piece.min_step = min_fixed >> kPositionBits;
  piece.max_step = max_fixed >> kPositionBits;
  const int base = piece.min_step * (1 << kPositionBits);
  for (std::size_t k = 0; k < kCount; ++k) fixed[k] -= base;
  for (std::size_t k = 0; k < kCount; ++k)
    piece.steps[k] = static_cast<std::int16_t>(fixed[k] >> kPositionBits);
  for (std::size_t k = 0; k < kCount; ++k)
    piece.part[k] = static_cast<std::int16_t>((fixed[k] & kFraction) << (15 - kPositionBits));
}

constexpr int kRowsAhead = 5;  // prefetched, because an image is larger than the caches

using PieceSteps = PositionSteps<kWarpChunk>;

/// A position in a row, in units of 2^-kPositionBits px.
[[gnu::always_inline]] inline int position_in(float constant, float slope, float bow, float row,
                                              float origin) {
  constexpr float kOne = 1 << kPositionBits;
  return static_cast<int>((constant + row * (slope + row * bow) - origin) * kOne + 0.5F);
}

/// `per_position`: steps that the read window advances from one position to the next.
[[gnu::always_inline]] inline PieceSteps find_piece(const float* __restrict constant,
                                                    const float* __restrict slope,
                                                    const float* __restrict bow, float row,
                                                    float origin, int last, int per_position) {
  std::array<int, kWarpChunk> fixed;
  for (int i = 0; i < kWarpChunk; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int exact = position_in(constant[i], slope[i], bow[i], row, origin);
    const int above = exact > 0 ? exact : 0;
    fixed[k] = (above < last ? above : last) - ((i * per_position) << kPositionBits);
  }
  PieceSteps piece;
  find_steps(fixed, piece);
  return piece;
}

/// 16-bit numbers that stay in registers from one step to the next, and their unaligned form.
using Half = std::int16_t __attribute__((vector_size(32)));
using HalfAt = std::int16_t __attribute__((vector_size(32), aligned(2), may_alias));
using HalfAround = std::uint16_t __attribute__((vector_size(32)));
constexpr std::size_t kHalf = sizeof(Half) / sizeof(std::int16_t);
static_assert(kWarpChunk == 2 * kHalf);

/// Half a chunk's grey levels: out[k] at its position k, which lies part[k] of 2^15 of a step
/// behind steps[k]. Each half is finished by itself: loading two stored halves at once would stall.
[[gnu::always_inline]] inline void take_half(const std::int16_t* from, std::ptrdiff_t step,
                                             int steps_apart, const std::int16_t* steps,
                                             const std::int16_t* part,
                                             std::int16_t* __restrict out) {
  const auto at = [](const std::int16_t* address) __attribute__((always_inline)) {
    return reinterpret_cast<const HalfAt*>(address);
  };
  const Half own = *at(steps);
  Half now = *at(from), next = *at(from + step);
  for (int s = 1; s <= steps_apart; ++s) {
    from += step;
    const Half reaches = own >= static_cast<std::int16_t>(s);
    const Half candidate = *at(from), beyond = *at(from + step);
    now = (candidate & reaches) | (now & ~reaches);
    next = (beyond & reaches) | (next & ~reaches);
  }
  alignas(Half) std::array<std::int16_t, kHalf> here, further;
  *reinterpret_cast<HalfAt*>(here.data()) = now;
  // Positions outside of the request hold anything: their difference may wrap around.
  *reinterpret_cast<HalfAt*>(further.data()) = reinterpret_cast<Half>(
      reinterpret_cast<HalfAround>(next) - reinterpret_cast<HalfAround>(now));
#pragma GCC unroll 1  // as a loop it is vectorised
  for (std::size_t k = 0; k < kHalf; ++k)
    out[k] = static_cast<std::int16_t>(here[k] + multiply_q15(further[k], part[k]));
}

[[gnu::always_inline]] inline void take_piece(const std::int16_t* from, std::ptrdiff_t step,
                                              const PieceSteps& piece,
                                              std::int16_t* __restrict out) {
  for (std::size_t k = 0; k < kWarpChunk; k += kHalf)
    take_half(from + k, step, piece.max_step - piece.min_step, piece.steps.data() + k,
              piece.part.data() + k, out + k);
}

/// The last position that lies before the image's last pixel.
int last_position(int count) { return std::max(0, ((count - 1) << kPositionBits) - 1); }

/// Positions of one row at nodes, in units of 2^-kPositionBits px.
constexpr int kNodeStep = ColumnQuadratics::kNodeStep;
constexpr int kGroup = 64;  // nodes at a time, plus one before and two behind them
static_assert(kWarpChunk == 2 * kNodeStep && kGroup % 2 == 0);
using Nodes = std::array<int, kGroup + 3>;

[[gnu::always_inline]] inline void find_nodes(const RowQuadratics& positions, std::size_t first,
                                              int count, float row, float origin, Nodes& nodes) {
  const float* constant = positions.constant.data() + first;
  const float* slope = positions.slope.data() + first;
  const float* bow = positions.bow.data() + first;
  constexpr int kFar = 1 << 27;  // far outside of every image; 8 of them still fit an int
  for (int i = 0; i < count; ++i) {
    const int exact = position_in(constant[i], slope[i], bow[i], row, origin);
    const int above = exact > -kFar ? exact : -kFar;
    nodes[static_cast<std::size_t>(i)] = above < kFar ? above : kFar;
  }
}

/// Weights of the parabola through a chunk's first position and that behind its last, by position
/// k. The span between both ends has weight k / 32; the midpoint's offset from their mean has
/// weight 4 k / 32 (1 - k / 32).
struct PieceShares {
  alignas(64) std::array<std::int16_t, kWarpChunk> span, bend;
};
constexpr PieceShares kShares = [] {
  PieceShares shares{};
  for (int k = 0; k < kWarpChunk; ++k) {
    constexpr int kOneQ15 = 1 << 15;
    const auto i = static_cast<std::size_t>(k);
    shares.span[i] = static_cast<std::int16_t>(k * (kOneQ15 / kWarpChunk));
    const int bend = 4 * k * (kWarpChunk - k) * (kOneQ15 / (kWarpChunk * kWarpChunk));
    shares.bend[i] = static_cast<std::int16_t>(bend < kOneQ15 ? bend : kOneQ15 - 1);
  }
  return shares;
}();

/// A chunk's positions from three nodes, in 16-bit numbers. false where these overflow, and where
/// some would have to be clamped. Also false where the nodes before and behind them show that the
/// parabola's error exceeds 1/500 px: at most a 15th of the nodes' third differences.
[[gnu::always_inline]] inline bool find_smooth_piece(const int* nodes, int last, int per_position,
                                                     PieceSteps& piece) {
  constexpr int kMaxSpread = INT16_MAX - (1 << kPositionBits);
  constexpr int kMaxThird = 15 * (1 << kPositionBits) / 500;
  const int begin = nodes[0], end = nodes[2];
  for (const int third :
       {end - nodes[-1] + 3 * (begin - nodes[1]), nodes[3] - begin + 3 * (nodes[1] - end)})
    if (third > kMaxThird || -third > kMaxThird) return false;
  const int bend = nodes[1] - (begin + end) / 2, bend_size = bend < 0 ? -bend : bend;
  const int span = end - begin - ((kWarpChunk * per_position) << kPositionBits);
  if (span > kMaxSpread - bend_size || -span > kMaxSpread - bend_size) return false;
  const int low = begin < end ? begin : end, high = begin < end ? end : begin;
  if (low - bend_size < 0 || high + bend_size > last) return false;
  const auto span_16 = static_cast<std::int16_t>(span), bend_16 = static_cast<std::int16_t>(bend);
  alignas(64) std::array<std::int16_t, kWarpChunk> from_begin;
  std::int16_t min_offset = 0, max_offset = 0;
  for (std::size_t k = 0; k < kWarpChunk; ++k) {
    const auto here = static_cast<std::int16_t>(multiply_q15(kShares.span[k], span_16) +
                                                multiply_q15(kShares.bend[k], bend_16));
    from_begin[k] = here;
    min_offset = here < min_offset ? here : min_offset;
    max_offset = here > max_offset ? here : max_offset;
  }
  piece.min_step = (begin + min_offset) >> kPositionBits;
  piece.max_step = (begin + max_offset) >> kPositionBits;
  const auto base = static_cast<std::int16_t>(begin - piece.min_step * (1 << kPositionBits));
  constexpr std::int16_t kFraction = (1 << kPositionBits) - 1;
  for (std::size_t k = 0; k < kWarpChunk; ++k) {
    const auto position = static_cast<std::int16_t>(from_begin[k] + base);
    piece.steps[k] = static_cast<std::int16_t>(position >> kPositionBits);
    piece.part[k] = static_cast<std::int16_t>((position & kFraction) << (15 - kPositionBits));
  }
  return true;
}

[[gnu::always_inline]] inline void warp_row(const std::int16_t* image, std::ptrdiff_t step,
                                            const RowWarp& warp, int last, int n,
                                            std::int16_t* __restrict out, int per_position) {
  const ColumnQuadratics& positions = warp.positions;
  const auto exactly = [&](int i, PieceSteps& piece) __attribute__((always_inline)) {
    const std::ptrdiff_t column = warp.first + i;
    piece = find_piece(positions.constant.data() + column, positions.slope.data() + column,
                       positions.bow.data() + column, warp.row, warp.origin, last, per_position);
  };
  const auto take = [&](int i, const PieceSteps& piece) __attribute__((always_inline)) {
    const std::int16_t* from = image + (per_position != 0 ? 0 : i) + piece.min_step * step;
    if (per_position == 0)
      __builtin_prefetch(from + (piece.max_step - piece.min_step + kRowsAhead) * step);
    take_piece(from, step, piece, out + i);
  };
  PieceSteps piece;
  // Nodes lie where full chunks begin.
  const auto ahead = static_cast<int>((kWarpChunk - warp.first % kWarpChunk) % kWarpChunk);
  if (ahead != 0) {
    exactly(0, piece);
    take(0, piece);
  }
  Nodes nodes;
  for (int group = ahead; group < n; group += kGroup * kNodeStep) {
    const auto node = static_cast<std::size_t>(warp.first + group) / kNodeStep;
    const std::size_t before = node > 0 ? 1 : 0;
    const int end = std::min(n, group + kGroup * kNodeStep);
    const int pieces = (end - group + kWarpChunk - 1) / kWarpChunk;
    find_nodes(positions.nodes, node - before, 2 * pieces + 2 + static_cast<int>(before), warp.row,
               warp.origin, nodes);
    for (int i = group; i < end; i += kWarpChunk) {
      const std::ptrdiff_t column = warp.first + i;
      const bool is_inside = column > 0 && column + kWarpChunk < positions.columns;
      const int* at = nodes.data() + before + (i - group) / kNodeStep;
      if (!is_inside || !find_smooth_piece(at, last, per_position, piece)) exactly(i, piece);
      take(i, piece);
    }
  }
}

ALLTACT_WIDE void warp_row_along(const std::int16_t* image, const RowWarp& warp, int last, int n,
                                 std::int16_t* out) {
  warp_row(image, 1, warp, last, n, out, 1);
}

ALLTACT_WIDE void warp_row_across(const std::int16_t* image, std::ptrdiff_t stride,
                                  const RowWarp& warp, int last, int n, std::int16_t* out) {
  warp_row(image, stride, warp, last, n, out, 0);
}

}  // namespace

void warp_along(const std::int16_t* image, const RowWarp& warp, int n, std::int16_t* out) {
  warp_row_along(image, warp, last_position(warp.count), n, out);
}

void warp_across(const std::int16_t* image, std::ptrdiff_t stride, const RowWarp& warp, int n,
                 std::int16_t* out) {
  warp_row_across(image, stride, warp, last_position(warp.count), n, out);
}

namespace {

// positions per batch; with fewer the compiler unrolls instead of vectorising
constexpr int kPiece = 32;
constexpr int kTaps = 4;   // pixels per axis from which a level is interpolated
constexpr int kReach = 2;  // px outside of the image; further out all taps are its border
// Border on each side: the pixels read for a batch of positions, of which the last may lie at the
// image's first column.
constexpr int kMarginPx = kPiece + kTaps + kReach;
constexpr int kAbovePx = kTaps + kReach;

constexpr int kMaxSteps = 16;  // between the positions of a batch: a stretch by half

using Lanes = std::array<std::int16_t, kPiece>;

/// Per position and axis: the first of its four pixels, and their weights.
struct Taps {
  PositionSteps<kPiece> first;
  alignas(64) std::array<Lanes, kTaps> weights;  // units of 2^-14
};

/// Keys' kernel as an integer polynomial in the fractional position. Intermediate sums may wrap
/// around.
[[gnu::always_inline]] inline void find_weights(Taps& taps) {
  for (std::size_t k = 0; k < kPiece; ++k) {
    const std::int16_t t = taps.first.part[k], t2 = multiply_q15(t, t), t3 = multiply_q15(t2, t);
    const auto before = static_cast<std::int16_t>((t2 - (t >> 1) - (t3 >> 1)) >> 1);
    const auto next = static_cast<std::int16_t>((t >> 2) + t2 - t3 + (t3 >> 2));
    const auto beyond = static_cast<std::int16_t>((t3 - t2) >> 2);
    taps.weights[0][k] = before;
    taps.weights[1][k] = static_cast<std::int16_t>((1 << 14) - before - next - beyond);
    taps.weights[2][k] = next;
    taps.weights[3][k] = beyond;
  }
}

/// For `n` positions, 1 to kPiece; entries behind them repeat the last one. `per_position`: pixels
/// that the read window advances from one position to the next. `border`: pixels before the image's
/// first one.
[[gnu::always_inline]] inline Taps find_taps(const float* __restrict positions, int n, int count,
                                             int border, int per_position) {
  constexpr float kOne = 1 << kPositionBits;
  const float limit = static_cast<float>(count - 1 + kReach);
  std::array<int, kPiece> fixed;
  for (int k = 0; k < kPiece; ++k) {
    const float above = positions[k] > -kReach ? positions[k] : -kReach;
    const float within = above < limit ? above : limit;
    fixed[static_cast<std::size_t>(k)] =
        static_cast<int>((within + static_cast<float>(border)) * kOne + 0.5F) -
        ((1 + k * per_position) << kPositionBits);
  }
  for (int k = n; k < kPiece; ++k)
    fixed[static_cast<std::size_t>(k)] = fixed[static_cast<std::size_t>(n - 1)];
  Taps taps;
  find_steps(fixed, taps.first);
  find_weights(taps);
  return taps;
}

/// Weights of the pixels at offset `at` from the smallest first pixel of all positions; 0 for
/// positions that do not reach them. A mask: the compiler would not vectorise a conditional.
[[gnu::always_inline]] inline Lanes weights_at(const Taps& taps, int at) {
  Lanes weights{};
  for (std::size_t j = 0; j < kTaps; ++j) {
    const auto step = static_cast<std::int16_t>(at - static_cast<int>(j));
    for (std::size_t k = 0; k < kPiece; ++k) {
      const std::int16_t mask = taps.first.steps[k] == step ? std::int16_t{-1} : std::int16_t{0};
      weights[k] = static_cast<std::int16_t>(weights[k] | (taps.weights[j][k] & mask));
    }
  }
  return weights;
}

/// Interpolates a batch of positions that lie about a pixel apart. Rows are read in blocks, once
/// per offset between the positions and their regular spacing, and weighted. `pixels`: the first of
/// the bordered image. false: the spacing is too irregular.
ALLTACT_WIDE bool sample_piece(const std::uint8_t* pixels, std::ptrdiff_t stride,
                               const cv::Size& size, const float* at_u, const float* at_v, int n,
                               std::uint8_t* __restrict out) {
  constexpr int kFactor = 1 << 7;
  const Taps u = find_taps(at_u, n, size.width, kMarginPx, 1);
  const int columns = u.first.max_step - u.first.min_step + kTaps;
  if (columns > kMaxSteps + kTaps) return false;
  std::array<Lanes, kMaxSteps + kTaps> along;
  for (int m = 0; m < columns; ++m) along[static_cast<std::size_t>(m)] = weights_at(u, m);
  const Taps v = find_taps(at_v, n, size.height, kAbovePx, 0);
  const std::uint8_t* row = pixels + v.first.min_step * stride + u.first.min_step;
  Lanes sum{};  // grey levels in units of 2^-5
  for (int r = 0; r < v.first.max_step - v.first.min_step + kTaps; ++r, row += stride) {
    Lanes level{};  // in units of 2^-6
    for (int m = 0; m < columns; ++m) {
      const Lanes& weights = along[static_cast<std::size_t>(m)];
      Lanes grey;
      for (std::size_t k = 0; k < kPiece; ++k)
        grey[k] = static_cast<std::int16_t>(row[k + static_cast<std::size_t>(m)] * kFactor);
      for (std::size_t k = 0; k < kPiece; ++k)
        level[k] = static_cast<std::int16_t>(level[k] + multiply_q15(grey[k], weights[k]));
    }
    const Lanes across = weights_at(v, r);
    for (std::size_t k = 0; k < kPiece; ++k)
      sum[k] = static_cast<std::int16_t>(sum[k] + multiply_q15(level[k], across[k]));
  }
  for (std::size_t k = 0; k < kPiece; ++k) {
    const auto grey = static_cast<std::int16_t>((sum[k] + 16) >> 5);
    const std::int16_t above = grey > 0 ? grey : std::int16_t{0};
    out[k] = static_cast<std::uint8_t>(above < 255 ? above : std::int16_t{255});
  }
  return true;
}

}  // namespace

CubicSampler::CubicSampler(const cv::Mat& grey) : size_(grey.size()) {
  CV_Assert(!grey.empty() && grey.type() == CV_8UC1);
  cv::copyMakeBorder(grey, bordered_, kAbovePx, kAbovePx, kMarginPx, kMarginPx,
                     cv::BORDER_REPLICATE);
}

void CubicSampler::sample(const float* u, const float* v, int count, std::uint8_t* out) const {
  const auto sample_full = [&](const float* at_u, const float* at_v, int n, std::uint8_t* to) {
    const auto stride = static_cast<std::ptrdiff_t>(bordered_.step);
    return sample_piece(bordered_.data, stride, size_, at_u, at_v, n, to);
  };
  const auto sample_few = [&](int from, int n) {
    std::array<float, kPiece> at_u{}, at_v{};
    std::array<std::uint8_t, kPiece> levels;
    std::copy_n(u + from, n, at_u.begin());
    std::copy_n(v + from, n, at_v.begin());
    const bool is_even = sample_full(at_u.data(), at_v.data(), n, levels.data());
    if (is_even) std::copy_n(levels.begin(), n, out + from);
    return is_even;
  };
  for (int from = 0; from < count; from += kPiece) {
    const int n = std::min(kPiece, count - from);
    if (n == kPiece ? sample_full(u + from, v + from, n, out + from) : sample_few(from, n))
      continue;
    for (int i = from; i < from + n; ++i) sample_few(i, 1);
  }
}

namespace {

constexpr std::size_t kMaxIdleBytes = std::size_t{256} << 20;

/// Blocks by size. Never destroyed: images may outlive everything else.
class Pool final : public cv::MatAllocator {
 public:
  cv::UMatData* allocate(int dims, const int* sizes, int type, void* data, std::size_t* step,
                         cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
    CV_Assert(data == nullptr && dims == 2);
    (void)flags, (void)usage;
    step[1] = CV_ELEM_SIZE(type);
    step[0] = static_cast<std::size_t>(sizes[1]) * step[1];
    auto* block = new cv::UMatData(this);
    block->size = static_cast<std::size_t>(sizes[0]) * step[0];
    block->data = block->origdata = take(block->size);
    return block;
  }
  bool allocate(cv::UMatData* block, cv::AccessFlag, cv::UMatUsageFlags) const override {
    return block != nullptr;
  }
  void deallocate(cv::UMatData* block) const override {
    give_back(block->size, block->origdata);
    block->origdata = nullptr;
    delete block;
  }

 private:
  [[nodiscard]] uchar* take(std::size_t bytes) const {
    {
      const std::lock_guard lock(mutex_);
      const auto found = idle_.find(bytes);
      if (found != idle_.end() && !found->second.empty()) {
        uchar* block = found->second.back();
        found->second.pop_back();
        idle_bytes_ -= bytes;
        return block;
      }
    }
    return static_cast<uchar*>(cv::fastMalloc(bytes));
  }
  void give_back(std::size_t bytes, uchar* block) const {
    {
      const std::lock_guard lock(mutex_);
      if (idle_bytes_ + bytes <= kMaxIdleBytes) {
        idle_[bytes].push_back(block);
        idle_bytes_ += bytes;
        return;
      }
    }
    cv::fastFree(block);
  }

  mutable std::mutex mutex_;
  mutable std::map<std::size_t, std::vector<uchar*>> idle_;
  mutable std::size_t idle_bytes_ = 0;
};

}  // namespace

cv::Mat pooled_image(const cv::Size& size, int type) {
  static auto* pool = new Pool;
  cv::Mat image;
  image.allocator = pool;
  image.create(size, type);
  return image;
}

}  // namespace alltact
