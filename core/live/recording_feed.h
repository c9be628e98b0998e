// The frames of a recording while it is written, for a second reader: what is made of it is nearly
// done when it ends.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/image/frame.h"
#include "core/recording/video_file.h"
#include "core/sources/source.h"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace alltact {

/// From the thread that records to one that reads. Any thread may call any function.
class RecordingFeed {
 public:
  /// `most_bytes`: of frames that wait for the reader.
  explicit RecordingFeed(std::filesystem::path file, std::size_t most_bytes = kMostBytes)
      : file_(std::move(file)), most_bytes_(most_bytes) {}

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  // The recording's side.

  /// `frames_per_s`: of its source.
  void begin(double frames_per_s, VideoCodec codec);
  /// A frame that the file will hold. Never waits: a reader that is far behind gets the rest from
  /// the file.
  void add(const FramePtr& frame);
  /// Nothing follows. `is_complete`: the file holds all frames, and can be read.
  void end(bool is_complete);

  // The reader's side.

  /// How many frames were added, and what became of the recording.
  struct Extent {
    std::size_t frames = 0;
    bool is_ended = false, is_complete = false;
  };
  [[nodiscard]] Extent extent() const;

 private:
  friend class FollowedRecording;
  static constexpr std::size_t kMostBytes = std::size_t{256} << 20;

  std::filesystem::path file_;
  std::size_t most_bytes_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::optional<double> frames_per_s_;
  VideoCodec codec_ = VideoCodec::kAuto;
  std::deque<FramePtr> waiting_;
  std::size_t waiting_bytes_ = 0;
  bool is_overtaken_ = false;  // frames were added that do not wait
  bool is_packets_ = false;    // the frames come as packets of the camera
  Extent extent_;
};

/// A source of the frames of a recording that still runs: the same as of its file afterwards. Its
/// functions wait for the frames, or for the job to be stopped. One thread.
class FollowedRecording : public Source {
 public:
  /// `job` must outlive this.
  FollowedRecording(std::shared_ptr<RecordingFeed> feed, const Job& job)
      : feed_(std::move(feed)), job_(job) {}

  /// Error: the recording did not become complete; stopped.
  [[nodiscard]] Result<FramePtr> next() override;
  /// Known when the recording has ended.
  [[nodiscard]] std::optional<std::size_t> count() const override;
  [[nodiscard]] bool is_continuous() const override { return true; }
  [[nodiscard]] double frames_per_s() const override;
  [[nodiscard]] std::optional<std::filesystem::path> lossless_file() const override;
  [[nodiscard]] std::vector<Message> remarks() const override;

 private:
  template <class Condition>
  bool wait(std::unique_lock<std::mutex>& lock, Condition condition) const;
  [[nodiscard]] Result<FramePtr> next_of_file();

  std::shared_ptr<RecordingFeed> feed_;
  const Job& job_;
  std::size_t given_ = 0;
  std::unique_ptr<Source> file_;  // that the reader follows once it was overtaken
};

}  // namespace alltact
