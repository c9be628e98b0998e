// Normal random numbers for full rows of pixels, as a pure function of stream name and position.
#pragma once

#include "core/simulation/effect.h"

#include <cstdint>
#include <string_view>

namespace alltact {

/// Draws from one effect's stream. The first object builds a table of 64 Ki quantiles (once a
/// program).
class RowNoise {
 public:
  explicit RowNoise(std::string_view stream);

  /// n numbers of mean 0 and standard deviation 1 (at most 4.2 from 0) for one row of one frame.
  void normals(std::uint64_t seed, int frame, int row, int n, float* out) const;

 private:
  std::uint32_t stream_;
};

// Noise of one strength, drawn independently for every pixel: common to shot and read noise.

class NoiseEffect : public SensorEffect {
 public:
  /// Adds noise made of n normal numbers to the values of a row.
  using Add = void (*)(int n, float strength, const float* normal, float* value);

  /// Draws from this stream.
  NoiseEffect(std::string_view stream, double strength, Add add)
      : strength_(static_cast<float>(strength)), add_(add), noise_(stream) {}

  void row(const FrameContext& frame, RowView& row) const override {
    float* normal = row.scratch.floats();
    noise_.normals(frame.seed, frame.frame, row.v, row.width, normal);
    add_(row.width, strength_, normal, row.value);
  }

 private:
  float strength_;
  Add add_;
  RowNoise noise_;
};

}  // namespace alltact
