#include "core/sensing/reference/cubic_picture.h"

#include "core/numerics/dispatch.h"
#include "core/sensing/reference/grey_steps.h"
#include "core/sensing/reference/place_steps.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace alltact {
namespace {

constexpr int kPiece = 32;  // places at a time; fewer the compiler unrolls instead of widening
constexpr int kTaps = 4;    // pixels that a level is made of, each way
constexpr int kReach = 2;   // px beyond the picture, from where on all taps are its border
// Beside the picture: what the places of a piece, of which the last may lie at the picture's first
// column, are looked for in.
constexpr int kBesidePx = kPiece + kTaps + kReach;
constexpr int kAbovePx = kTaps + kReach;

constexpr int kMostSteps = 16;  // between the places of a piece: a stretch by half

using Lanes = std::array<std::int16_t, kPiece>;

/// Along one axis, of each place: the first of its four pixels, and their weights.
struct Taps {
  PlaceSteps<kPiece> first;
  alignas(64) std::array<Lanes, kTaps> weights;  // of 2^14
};

/// Keys' kernel by the place's part of a pixel, a polynomial in it of whole numbers. All may wrap
/// around on the way.
[[gnu::always_inline]] inline void find_weights(Taps& taps) {
  for (std::size_t k = 0; k < kPiece; ++k) {
    const std::int16_t t = taps.first.part[k], t2 = times(t, t), t3 = times(t2, t);
    const auto before = static_cast<std::int16_t>((t2 - (t >> 1) - (t3 >> 1)) >> 1);
    const auto next = static_cast<std::int16_t>((t >> 2) + t2 - t3 + (t3 >> 2));
    const auto beyond = static_cast<std::int16_t>((t3 - t2) >> 2);
    taps.weights[0][k] = before;
    taps.weights[1][k] = static_cast<std::int16_t>((1 << 14) - before - next - beyond);
    taps.weights[2][k] = next;
    taps.weights[3][k] = beyond;
  }
}

/// Of `n` places, 1 to kPiece; those behind them are like the last. `per_place`: pixels by which
/// the picture itself advances from one place to the next; `border`: pixels before the picture's
/// first.
[[gnu::always_inline]] inline Taps find_taps(
    const float* __restrict places, int n, int count, int border, int per_place) {
  constexpr float kOne = 1 << kPlaceBits;
  const float most = static_cast<float>(count - 1 + kReach);
  std::array<int, kPiece> fixed;
  for (int k = 0; k < kPiece; ++k) {
    const float above = places[k] > -kReach ? places[k] : -kReach;
    const float within = above < most ? above : most;
    fixed[static_cast<std::size_t>(k)] =
        static_cast<int>((within + static_cast<float>(border)) * kOne + 0.5F) -
        ((1 + k * per_place) << kPlaceBits);
  }
  for (int k = n; k < kPiece; ++k)
    fixed[static_cast<std::size_t>(k)] = fixed[static_cast<std::size_t>(n - 1)];
  Taps taps;
  find_steps(fixed, taps.first);
  find_weights(taps);
  return taps;
}

/// The weights of the pixels that lie `at` whole pixels from the least of all places' first ones: 0
/// for places that do not reach them. A mask: the compiler would not widen a choice.
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

/// A piece of places that lie about a pixel apart: whole stretches of rows are read, each at as
/// many steps as the places lie apart more or less than that, and are weighed. `pixels`: the first
/// of the bordered picture. false: the places lie too unevenly.
ALLTACT_WIDE bool look_up_piece(const std::uint8_t* pixels,
                                std::ptrdiff_t stride,
                                const cv::Size& size,
                                const float* at_u,
                                const float* at_v,
                                int n,
                                std::uint8_t* __restrict out) {
  constexpr int kFactor = 1 << 7;
  const Taps u = find_taps(at_u, n, size.width, kBesidePx, 1);
  const int columns = u.first.most - u.first.least + kTaps;
  if (columns > kMostSteps + kTaps) return false;
  std::array<Lanes, kMostSteps + kTaps> along;
  for (int m = 0; m < columns; ++m) along[static_cast<std::size_t>(m)] = weights_at(u, m);
  const Taps v = find_taps(at_v, n, size.height, kAbovePx, 0);
  const std::uint8_t* row = pixels + v.first.least * stride + u.first.least;
  Lanes sum{};  // grey levels of 2^5
  for (int r = 0; r < v.first.most - v.first.least + kTaps; ++r, row += stride) {
    Lanes level{};  // of 2^6
    for (int m = 0; m < columns; ++m) {
      const Lanes& weights = along[static_cast<std::size_t>(m)];
      Lanes grey;
      for (std::size_t k = 0; k < kPiece; ++k)
        grey[k] = static_cast<std::int16_t>(row[k + static_cast<std::size_t>(m)] * kFactor);
      for (std::size_t k = 0; k < kPiece; ++k)
        level[k] = static_cast<std::int16_t>(level[k] + times(grey[k], weights[k]));
    }
    const Lanes across = weights_at(v, r);
    for (std::size_t k = 0; k < kPiece; ++k)
      sum[k] = static_cast<std::int16_t>(sum[k] + times(level[k], across[k]));
  }
  for (std::size_t k = 0; k < kPiece; ++k) {
    const auto grey = static_cast<std::int16_t>((sum[k] + 16) >> 5);
    const std::int16_t above = grey > 0 ? grey : std::int16_t{0};
    out[k] = static_cast<std::uint8_t>(above < 255 ? above : std::int16_t{255});
  }
  return true;
}

}  // namespace

CubicPicture::CubicPicture(const cv::Mat& grey) : size_(grey.size()) {
  CV_Assert(!grey.empty() && grey.type() == CV_8UC1);
  cv::copyMakeBorder(
      grey, bordered_, kAbovePx, kAbovePx, kBesidePx, kBesidePx, cv::BORDER_REPLICATE);
}

void CubicPicture::look_up(const float* u, const float* v, int count, std::uint8_t* out) const {
  const auto look = [&](const float* at_u, const float* at_v, int n, std::uint8_t* to) {
    const auto stride = static_cast<std::ptrdiff_t>(bordered_.step);
    return look_up_piece(bordered_.data, stride, size_, at_u, at_v, n, to);
  };
  const auto look_at_few = [&](int from, int n) {
    std::array<float, kPiece> at_u{}, at_v{};
    std::array<std::uint8_t, kPiece> levels;
    std::copy_n(u + from, n, at_u.begin());
    std::copy_n(v + from, n, at_v.begin());
    const bool is_even = look(at_u.data(), at_v.data(), n, levels.data());
    if (is_even) std::copy_n(levels.begin(), n, out + from);
    return is_even;
  };
  for (int from = 0; from < count; from += kPiece) {
    const int n = std::min(kPiece, count - from);
    if (n == kPiece ? look(u + from, v + from, n, out + from) : look_at_few(from, n)) continue;
    for (int i = from; i < from + n; ++i) look_at_few(i, 1);
  }
}

}  // namespace alltact
