#include "core/live/recording_feed.h"

#include "core/sources/file_source.h"

#include <chrono>

namespace alltact {

namespace {

std::size_t bytes_of(const Frame& frame) {
  return frame.grey.total() + (frame.jpeg ? frame.jpeg->size() : 0);
}

}  // namespace

void RecordingFeed::begin(double frames_per_s, VideoCodec codec) {
  const std::lock_guard lock(mutex_);
  frames_per_s_ = frames_per_s;
  codec_ = codec;
  changed_.notify_all();
}

void RecordingFeed::add(const FramePtr& frame) {
  const std::lock_guard lock(mutex_);
  if (extent_.frames == 0) is_packets_ = frame->jpeg != nullptr;
  ++extent_.frames;
  const std::size_t bytes = bytes_of(*frame);
  is_overtaken_ = is_overtaken_ || waiting_bytes_ + bytes > most_bytes_;
  if (!is_overtaken_) {
    waiting_.push_back(frame);
    waiting_bytes_ += bytes;
  }
  changed_.notify_all();
}

void RecordingFeed::end(bool is_complete) {
  const std::lock_guard lock(mutex_);
  extent_.is_ended = true;
  extent_.is_complete = is_complete;
  changed_.notify_all();
}

RecordingFeed::Extent RecordingFeed::extent() const {
  const std::lock_guard lock(mutex_);
  return extent_;
}

/// False: stopped.
template <class Condition>
bool FollowedRecording::wait(std::unique_lock<std::mutex>& lock, Condition condition) const {
  constexpr std::chrono::milliseconds kBetweenLooks{50};  // at the job, which wakes nobody
  while (!job_.stop_requested())
    if (feed_->changed_.wait_for(lock, kBetweenLooks, condition)) return true;
  return false;
}

Result<FramePtr> FollowedRecording::next() {
  if (file_) return file_->next();
  std::unique_lock lock(feed_->mutex_);
  RecordingFeed& feed = *feed_;
  if (!wait(lock, [&] { return !feed.waiting_.empty() || feed.extent_.is_ended; }))
    return Error{en::say("stopped"), feed.file_, ""};
  if (!feed.waiting_.empty()) {
    FramePtr frame = std::move(feed.waiting_.front());
    feed.waiting_.pop_front();
    feed.waiting_bytes_ -= bytes_of(*frame);
    ++given_;
    return frame;
  }
  if (!feed.extent_.is_complete)
    return Error{en::say("the recording is not complete"), feed.file_, en::say("record again")};
  if (given_ == feed.extent_.frames) return FramePtr();
  lock.unlock();
  return next_of_file();
}

Result<FramePtr> FollowedRecording::next_of_file() {
  auto video = VideoFile::open(feed_->file(), job_);
  if (!video) return video.error();
  file_ = std::make_unique<VideoSource>(std::move(*video), SourceOptions{});
  file_->skip(given_);
  return file_->next();
}

std::optional<std::size_t> FollowedRecording::count() const {
  const RecordingFeed::Extent extent = feed_->extent();
  if (!extent.is_ended) return std::nullopt;
  return extent.is_complete ? extent.frames : given_;
}

double FollowedRecording::frames_per_s() const {
  std::unique_lock lock(feed_->mutex_);
  wait(lock, [&] { return feed_->frames_per_s_ || feed_->extent_.is_ended; });
  return feed_->frames_per_s_.value_or(Source::frames_per_s());
}

std::optional<std::filesystem::path> FollowedRecording::lossless_file() const {
  std::unique_lock lock(feed_->mutex_);
  wait(lock, [&] { return feed_->extent_.frames > 0 || feed_->extent_.is_ended; });
  const bool is_own = feed_->codec_ == VideoCodec::kMagicYuv ||
                      (feed_->codec_ == VideoCodec::kAuto && !feed_->is_packets_);
  return is_own && feed_->extent_.frames > 0 && given_ == 0 ? std::optional(feed_->file_)
                                                            : std::nullopt;
}

std::vector<Message> FollowedRecording::remarks() const {
  if (!feed_->extent().is_complete) return {};
  const auto video = VideoFile::open(feed_->file(), job_);
  return video ? video->remarks() : std::vector<Message>{};
}

}  // namespace alltact
