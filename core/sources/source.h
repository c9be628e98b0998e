// Sources of frames: cameras, videos, images and simulated fingers.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/base/worker.h"
#include "core/image/frame.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace alltact {

/// Returns frames one after the other.
class Source {
 public:
  virtual ~Source() = default;

  /// The next frame; nullptr after the last one. An error names the image that could not be read;
  /// the next call continues with the following image, where there is one.
  [[nodiscard]] virtual Result<FramePtr> next() = 0;

  /// Number of frames, where it is known.
  [[nodiscard]] virtual std::optional<std::size_t> count() const = 0;

  /// True when frames follow each other in time, so that a tracker may use the frame before.
  [[nodiscard]] virtual bool is_continuous() const = 0;

  /// True when frames come at their own times: a slow reader misses some.
  [[nodiscard]] virtual bool is_live() const { return false; }

  /// Approximate rate of the frames, 1/s.
  [[nodiscard]] virtual double frames_per_s() const { return 30.0; }

  /// The video file whose frames these are, all of them, where copy_frames() can copy them: it
  /// stores them without loss.
  [[nodiscard]] virtual std::optional<std::filesystem::path> lossless_file() const {
    return std::nullopt;
  }

  /// What was assumed about the frames so far, and what makes them hard to measure; a sentence
  /// each.
  [[nodiscard]] virtual std::vector<Message> remarks() const { return {}; }

  /// Skips frames, no more than there are.
  virtual void skip(std::size_t count) {
    for (; count > 0; --count)
      if (const auto frame = next(); frame && !*frame) return;
  }
};

enum class Pace {
  kOnDemand = 1,  ///< as fast as they are requested
  kRecorded,      ///< at the recorded pace, or at a camera's
};

struct SourceOptions {
  Pace pace = Pace::kOnDemand;
  std::uint64_t seed = 1;  ///< seed of a simulated finger
  int threads = 1;         ///< rendering threads; the images are the same for any number
  /// Receives the progress of long opening (repair of a recording); stopping it ends waits at the
  /// recorded pace. May be null; else it outlives the source.
  const Job* job = nullptr;
};

// Delays frames to their recorded pace.

/// Waits until a frame is due. The first frame is due at once and starts the clock. A late caller
/// does not wait, and the frames behind it retain their times. With Pace::kOnDemand nothing waits.
/// One thread.
class Pacer {
 public:
  explicit Pacer(const SourceOptions& options) : pace_(options.pace), job_(options.job) {}

  /// time_ns: time of the frame, on any clock. False: the job was stopped during the wait.
  [[nodiscard]] bool wait_for(std::int64_t time_ns);

 private:
  using Clock = std::chrono::steady_clock;

  Pace pace_;
  const Job* job_;
  std::optional<Clock::time_point> begin_;
  std::int64_t first_ns_ = 0;
};

/// Waits one frame period, at most, for images, which have no times.
void wait_frame_period(double frames_per_s, const std::function<bool()>& is_stopped);

// A source without backlog, for work that must not fall behind a live source.

/// Reads another source on a thread of its own. next() returns the newest frame, and never the same
/// one twice. Replaced frames are missing from the sequence. Images, which have no times, come at a
/// camera's rate. Errors come in their order. The destructor waits for the source's next frame.
class NewestSource : public Source {
 public:
  explicit NewestSource(std::unique_ptr<Source> source);
  [[nodiscard]] Result<FramePtr> next() override;
  [[nodiscard]] std::optional<std::size_t> count() const override { return std::nullopt; }
  [[nodiscard]] bool is_continuous() const override { return source_->is_continuous(); }
  [[nodiscard]] bool is_live() const override { return true; }
  [[nodiscard]] double frames_per_s() const override { return source_->frames_per_s(); }
  /// Frames that a newer one replaced.
  [[nodiscard]] std::uint64_t skipped() const;

 private:
  void run(const std::stop_token& stop);
  /// True: nothing will follow.
  bool take(Result<FramePtr> frame);

  std::unique_ptr<Source> source_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Error> errors_;
  FramePtr newest_;
  std::uint64_t skipped_ = 0;
  bool is_over_ = false;
  Worker worker_;  // last: it ends first
};

// One writer, many readers: viewers get the latest frame, recorders get every frame.

/// State shared by a FrameHub and its readers.
struct FrameHubState;

/// Reads the latest frame only. A slow reader misses frames, which it counts, and never gets an old
/// one. One thread, but for wake(); may outlive the hub.
class LatestFrameReader {
 public:
  /// Waits for a frame that this reader has not returned yet. nullptr: none came within `timeout`,
  /// the hub has closed, or wake() was called.
  [[nodiscard]] FramePtr next(std::chrono::milliseconds timeout);
  /// Ends the wait of next(), or else that of its next call. Any thread.
  void wake();
  /// Frames published since this reader was made that it never returned.
  [[nodiscard]] std::uint64_t missed() const { return missed_; }

 private:
  friend class FrameHub;
  LatestFrameReader(std::shared_ptr<FrameHubState> state, std::uint64_t seen)
      : state_(std::move(state)), seen_(seen) {}
  std::shared_ptr<FrameHubState> state_;
  std::uint64_t seen_;  // frames published at the last call of next()
  std::uint64_t missed_ = 0;
  bool is_woken_ = false;  // under the lock
};

/// Returns every frame in order, and every fault between them. Holds at most `capacity` frames;
/// when full it drops and counts new ones. Any thread may call.
class FrameQueue {
 public:
  ~FrameQueue();
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;

  /// The next frame or fault. Empty: none came within `timeout`. A null frame: the hub has closed
  /// and the queue is empty.
  [[nodiscard]] std::optional<Result<FramePtr>> next(std::chrono::milliseconds timeout);
  /// Frames that were dropped because the queue was full.
  [[nodiscard]] std::uint64_t dropped() const;

 private:
  friend class FrameHub;
  friend struct FrameHubState;
  FrameQueue(std::shared_ptr<FrameHubState> state, std::size_t capacity)
      : state_(std::move(state)), capacity_(capacity) {}
  void put(const Result<FramePtr>& item);  // under the lock

  std::shared_ptr<FrameHubState> state_;
  std::size_t capacity_;
  std::size_t frames_ = 0;  // number of frames among items_
  std::uint64_t dropped_ = 0;
  std::deque<Result<FramePtr>> items_;
};

/// The writer's side. Frames are shared, never copied. One thread calls publish(), fault() and
/// close(); any thread may make readers.
class FrameHub {
 public:
  FrameHub();
  ~FrameHub();  ///< closes
  FrameHub(const FrameHub&) = delete;
  FrameHub& operator=(const FrameHub&) = delete;

  void publish(FramePtr frame);
  /// Reports a fault of the stream to the queues; frames may follow.
  void fault(const Error& error);
  /// Ends the stream and wakes all waiting readers.
  void close();

  /// Null before the first frame.
  [[nodiscard]] FramePtr latest() const;
  /// A reader of frames published from now on.
  [[nodiscard]] LatestFrameReader reader() const;
  [[nodiscard]] std::unique_ptr<FrameQueue> subscribe(std::size_t capacity) const;

 private:
  std::shared_ptr<FrameHubState> state_;
};

}  // namespace alltact
