#include "core/sensing/reference/cubic_sampler.h"

#include "core/numerics/dispatch.h"
#include "core/sensing/reference/grey_steps.h"
#include "core/sensing/reference/position_steps.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace alltact {
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
[[gnu::always_inline]] inline Taps find_taps(
    const float* __restrict positions, int n, int count, int border, int per_position) {
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
ALLTACT_WIDE bool sample_piece(const std::uint8_t* pixels,
                               std::ptrdiff_t stride,
                               const cv::Size& size,
                               const float* at_u,
                               const float* at_v,
                               int n,
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
  cv::copyMakeBorder(
      grey, bordered_, kAbovePx, kAbovePx, kMarginPx, kMarginPx, cv::BORDER_REPLICATE);
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

}  // namespace alltact
