// Grey levels interpolated between two pixels a step apart, for many adjacent positions.
#pragma once

#include "core/sensing/reference/face_chart.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <opencv2/core.hpp>

namespace alltact {

constexpr int kWarpChunk =
    ColumnQuadratics::kBeyond;  ///< positions that are interpolated at a time

/// Mapped positions of a row: column `first` of the polynomials and those after it, at `row`.
struct RowWarp {
  const ColumnQuadratics& positions;
  std::ptrdiff_t first;
  float row;
  float origin;  ///< position of the image's first pixel
  int count;     ///< pixels of the image; positions are clamped to them
};

/// out[i] = the row `image` of grey levels in steps at position i, linear between
/// its pixels to 1/400 px, as `multiply_q15` rounds. kWarpChunk pixels before and behind the row
/// must be readable, whatever they hold; n + kWarpChunk numbers are written.
void warp_along(const std::int16_t* image, const RowWarp& warp, int n, std::int16_t* out);

/// out[i] = pixel i of the image's row at position i, linear between rows as above. `stride`: from
/// row to row; kWarpChunk pixels behind the n must be readable in each row.
void warp_across(const std::int16_t* image, std::ptrdiff_t stride, const RowWarp& warp, int n,
                 std::int16_t* out);

// Interpolated grey levels of an image at many adjacent positions.

/// Cubic convolution (Keys 1981, a = -1/2) of third order: even slopes are neither shifted nor
/// bent. Outside of the image its outermost pixels continue.
class CubicSampler {
 public:
  explicit CubicSampler(const cv::Mat& grey);  ///< CV_8UC1, not empty

  /// out[i] = the grey level at (u[i], v[i]) px, for `count` positions rounded to 1/2048 px. The
  /// error is at most 0.2 levels before rounding. Fast where positions lie about a pixel apart.
  void sample(const float* u, const float* v, int count, std::uint8_t* out) const;

 private:
  cv::Size size_;
  cv::Mat bordered_;
};

// Grey levels as 16-bit integers in steps of 1/64: half the memory and twice the vector width of
// float. Rounding lies far below a camera's noise (0.0045 levels rms for a product).

constexpr int kGreySteps = 64;
constexpr std::int16_t kNoGrey = INT16_MIN;  ///< where an image has no value

/// a b / 2^15, rounded: one instruction on every processor with vectors.
[[gnu::always_inline]] inline std::int16_t multiply_q15(std::int16_t a, std::int16_t b) {
  return static_cast<std::int16_t>((((static_cast<std::int32_t>(a) * b) >> 14) + 1) >> 1);
}

/// Converts NaN to kNoGrey. `level` within -500 to 500.
[[nodiscard]] inline std::int16_t to_steps(float level) {
  return level == level ? static_cast<std::int16_t>(std::lround(level * kGreySteps)) : kNoGrey;
}

// Pool of image memory: a frame's results are as large as the last frame's.

/// An image of undefined content from a pool that all threads share. Its memory returns to the pool
/// with the last cv::Mat that refers to it, for the next image of the same size. Fresh pages from
/// the system cost more than the work done on them (0.25 us each, several thousand per frame at
/// 1920x1080). At most 256 MB stay idle in the pool.
[[nodiscard]] cv::Mat pooled_image(const cv::Size& size, int type);

/// Fills with the NaN whose four bytes are equal: as fast as the memory.
inline void fill_nan(float* values, int count) {
  std::memset(values, 0xFF, static_cast<std::size_t>(count) * sizeof(float));
}

}  // namespace alltact
