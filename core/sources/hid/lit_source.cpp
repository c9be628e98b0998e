#include "core/sources/hid/lit_source.h"

#include "core/sources/frame_settings.h"

namespace alltact {

LightStamp::LightStamp(const DimmerSetting& light)
    : light_(fmt::format("{:.4g} by {} ({})", light.level, light.device, light.control)) {}

FramePtr LightStamp::operator()(const FramePtr& frame) {
  if (with_light_ == nullptr || frame->controls != before_) {
    before_ = frame->controls;
    std::string settings = before_ == nullptr ? std::string() : *before_;
    add_setting(settings, "Light", light_);
    with_light_ = std::make_shared<const std::string>(std::move(settings));
  }
  auto lit = std::make_shared<Frame>(*frame);  // shares the pixels
  lit->controls = with_light_;
  return lit;
}

Result<FramePtr> LitSource::next() {
  auto frame = source_->next();
  if (!frame || !*frame) return frame;
  return stamp_(*frame);
}

}  // namespace alltact
