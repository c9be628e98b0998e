#include "core/sources/files/recorded_frames.h"

#include "core/sources/files/image_source.h"

namespace alltact {

Result<RecordedFrames> RecordedFrames::open(const std::filesystem::path& input, const Job& job) {
  RecordedFrames frames;
  std::error_code ignored;
  if (std::filesystem::is_directory(input, ignored)) {
    auto images = images_in(input);
    if (!images) return images.error();
    frames.images_ = std::move(*images);
    frames.is_continuous_ = ImageSource(frames.images_).is_continuous();
    return frames;
  }
  auto video = VideoFile::open(input, job);
  if (!video) return video.error();
  frames.video_ = std::move(*video);
  return frames;
}

std::size_t RecordedFrames::count() const {
  return video_ ? video_->frame_count() : images_.size();
}

Result<FramePtr> RecordedFrames::frame(std::size_t number) {
  if (video_) return video_->frame(number);
  return ImageSource({images_.at(number)}).next();
}

std::shared_ptr<const FrameTimes> RecordedFrames::times_ns() const {
  if (!video_) return nullptr;
  auto times = std::make_shared<FrameTimes>();
  for (std::size_t i = 0; i < count(); ++i) times->push_back(video_->time_ns(i));
  return times;
}

double RecordedFrames::frames_per_s() const {
  constexpr double kImagesPerS = 10;
  return video_ ? video_->frames_per_s() : kImagesPerS;
}

}  // namespace alltact
