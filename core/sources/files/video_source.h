// A source of a video's frames.
#pragma once

#include "core/recording/video_file.h"
#include "core/sources/pacer.h"
#include "core/sources/source.h"

#include <algorithm>

namespace alltact {

class VideoSource : public Source {
 public:
  VideoSource(VideoFile video, const SourceOptions& options)
      : video_(std::move(video)), pacer_(options) {}

  [[nodiscard]] Result<FramePtr> next() override;
  void skip(std::size_t count) override {
    position_ += std::min(count, video_.frame_count() - position_);
  }
  [[nodiscard]] std::optional<std::size_t> count() const override { return video_.frame_count(); }
  [[nodiscard]] bool is_continuous() const override { return true; }
  [[nodiscard]] double frames_per_s() const override { return video_.frames_per_s(); }

 private:
  VideoFile video_;
  Pacer pacer_;
  std::size_t position_ = 0;
};

}  // namespace alltact
