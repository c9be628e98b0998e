// Noise of one strength, drawn for every pixel on its own: what shot and read noise share.
#pragma once

#include "core/simulation/effect.h"
#include "core/simulation/noise.h"

#include <string_view>

namespace alltact {

class NoiseEffect final : public SensorEffect {
 public:
  /// Adds to the values of a row what n normal numbers make of them.
  using Add = void (*)(int n, float strength, const float* normal, float* value);

  /// Draws under `who`.
  NoiseEffect(std::string_view who, double strength, Add add, Message sentence)
      : strength_(static_cast<float>(strength)),
        add_(add),
        noise_(who),
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
