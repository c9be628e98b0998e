// Noise of one strength, drawn independently for every pixel: common to shot and read noise.
#pragma once

#include "core/simulation/effect.h"
#include "core/simulation/noise.h"

#include <string_view>

namespace alltact {

class NoiseEffect final : public SensorEffect {
 public:
  /// Adds noise made of n normal numbers to the values of a row.
  using Add = void (*)(int n, float strength, const float* normal, float* value);

  /// Draws from this stream.
  NoiseEffect(std::string_view stream, double strength, Add add, Message sentence)
      : strength_(static_cast<float>(strength)),
        add_(add),
        noise_(stream),
        sentence_(std::move(sentence)) {}

  Message sentence() const override { return sentence_; }

  void row(const FrameContext& frame, RowView& row) const override {
    float* normal = row.scratch.floats();
    noise_.normals(frame.seed, frame.frame, row.v, row.width, normal);
    add_(row.width, strength_, normal, row.value);
  }

 private:
  float strength_;
  Add add_;
  RowNoise noise_;
  Message sentence_;
};

}  // namespace alltact
