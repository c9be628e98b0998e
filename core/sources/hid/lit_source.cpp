#include "core/sources/hid/lit_source.h"

#include "core/sources/frame_settings.h"

namespace alltact {

LitSource::LitSource(std::unique_ptr<Source> source, const DimmerSetting& light)
    : source_(std::move(source)),
      light_(fmt::format("{:.4g} by {} ({})", light.level, light.device, light.control)) {}

Result<FramePtr> LitSource::next() {
  auto frame = source_->next();
  if (!frame || !*frame) return frame;
  if (with_light_ == nullptr || (*frame)->controls != before_) {
    before_ = (*frame)->controls;
    std::string settings = before_ == nullptr ? std::string() : *before_;
    add_setting(settings, "Light", light_);
    with_light_ = std::make_shared<const std::string>(std::move(settings));
  }
  auto lit = std::make_shared<Frame>(**frame);  // shares the pixels
  lit->controls = with_light_;
  return FramePtr(std::move(lit));
}

}  // namespace alltact
