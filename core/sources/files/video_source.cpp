#include "core/sources/files/video_source.h"

namespace alltact {

Result<FramePtr> VideoSource::next() {
  if (position_ == video_.frame_count()) return FramePtr();
  auto frame = video_.frame(position_++);
  if (!frame) return frame;
  if (!pacer_.wait_for((*frame)->time_ns)) return FramePtr();
  return frame;
}

}  // namespace alltact
