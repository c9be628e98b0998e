// A source whose frames also tell what the finger's light was set to.
#pragma once

#include "core/sources/hid/led_dimmer.h"
#include "core/sources/source.h"

#include <memory>

namespace alltact {

/// Puts a dimmer's setting behind each frame's own settings. One thread.
class LightStamp {
 public:
  explicit LightStamp(const DimmerSetting& light);
  /// The same pixels. Not for none.
  [[nodiscard]] FramePtr operator()(const FramePtr& frame);

 private:
  std::string light_;
  std::shared_ptr<const std::string> before_, with_light_;  // mostly the same from frame to frame
};

/// Another source as it is, its frames stamped.
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
