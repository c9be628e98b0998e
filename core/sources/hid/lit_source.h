// A source that adds the setting of the finger's light to its frames.
#pragma once

#include "core/sources/hid/led_dimmer.h"
#include "core/sources/source.h"

#include <memory>

namespace alltact {

/// Appends a dimmer's setting to each frame's own settings. One thread.
class LightStamp {
 public:
  explicit LightStamp(const DimmerSetting& light);
  /// Shares the pixels. `frame` must not be null.
  [[nodiscard]] FramePtr operator()(const FramePtr& frame);

 private:
  std::string light_;
  std::shared_ptr<const std::string> before_, with_light_;  // usually the same from frame to frame
};

/// Another source, with stamped frames.
class LitSource : public Source {
 public:
  LitSource(std::unique_ptr<Source> source, const DimmerSetting& light)
      : source_(std::move(source)), stamp_(light) {}

  [[nodiscard]] Result<FramePtr> next() override;
  [[nodiscard]] std::optional<std::size_t> count() const override { return source_->count(); }
  [[nodiscard]] bool is_continuous() const override { return source_->is_continuous(); }
  [[nodiscard]] bool is_live() const override { return source_->is_live(); }
  [[nodiscard]] double frames_per_s() const override { return source_->frames_per_s(); }

 private:
  std::unique_ptr<Source> source_;
  LightStamp stamp_;
};

}  // namespace alltact
