#include "calibration/presses/press_input.h"

#include "calibration/presses/held_frames.h"
#include "core/sources/files/image_source.h"
#include "core/sources/open/open_source.h"

#include <algorithm>

namespace alltact {

Result<std::unique_ptr<Source>> open_presses(const PressInput& input) {
  if (!input.frames.empty())
    return std::unique_ptr<Source>(std::make_unique<FrameSource>(input.frames));
  if (input.bursts)
    return std::unique_ptr<Source>(
        std::make_unique<BurstSource>(input.files, input.frames_per_press));
  auto source = open_source(input.files);
  if (source || std::none_of(input.files.begin(), input.files.end(), is_video)) return source;
  Error several = source.error();
  several.advice = en::list(
      {several.advice, en::say("or --bursts where each video shows one press held still")});
  return several;
}

bool is_one_video(const Source& presses) {
  const bool is_images = dynamic_cast<const ImageSource*>(&presses) != nullptr ||
                         dynamic_cast<const FrameSource*>(&presses) != nullptr;
  return presses.is_continuous() && !is_images;
}

std::vector<Message> made_of(const Source& presses) {
  const auto* bursts = dynamic_cast<const BurstSource*>(&presses);
  return bursts == nullptr ? std::vector<Message>() : bursts->made_of();
}

}  // namespace alltact
