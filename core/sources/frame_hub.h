// One writer, many readers: whoever looks gets the latest frame, whoever records gets every frame.
#pragma once

#include "core/frame.h"
#include "core/result.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace alltact {

/// What a FrameHub and its readers share.
struct FrameHubState;

/// Sees the latest frame only. A slow reader misses frames, counted here, and is never shown an old
/// one. Used by one thread; may outlive the hub.
class LatestFrameReader {
 public:
  /// The latest frame, as soon as there is one that this reader has not seen; nullptr when none
  /// came within `patience` or the hub has closed.
  [[nodiscard]] FramePtr next(std::chrono::milliseconds patience);
  /// Frames published since this reader was made that it was never shown.
  [[nodiscard]] std::uint64_t missed() const { return missed_; }

 private:
  friend class FrameHub;
  LatestFrameReader(std::shared_ptr<FrameHubState> state, std::uint64_t seen)
      : state_(std::move(state)), seen_(seen) {}
  std::shared_ptr<FrameHubState> state_;
  std::uint64_t seen_;  // how many had been published when it last looked
  std::uint64_t missed_ = 0;
};

/// Gets every frame in order, and every fault between them. Holds at most `capacity` frames: those
/// that come while it is full are dropped and counted. Any thread may call.
class FrameQueue {
 public:
  ~FrameQueue();
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;

  /// The next frame or fault; empty when none came within `patience`; a null frame once the hub has
  /// closed and everything was taken.
  [[nodiscard]] std::optional<Result<FramePtr>> next(std::chrono::milliseconds patience);
  /// Frames that found the queue full.
  [[nodiscard]] std::uint64_t dropped() const;

 private:
  friend class FrameHub;
  friend struct FrameHubState;
  FrameQueue(std::shared_ptr<FrameHubState> state, std::size_t capacity)
      : state_(std::move(state)), capacity_(capacity) {}
  void put(const Result<FramePtr>& item);  // under the lock

  std::shared_ptr<FrameHubState> state_;
  std::size_t capacity_;
  std::size_t frames_ = 0;  // of items_, those that are frames
  std::uint64_t dropped_ = 0;
  std::deque<Result<FramePtr>> items_;
};

/// The writer's side. Frames are shared, never copied. publish(), fault() and close() belong to one
/// thread; readers may be made from any.
class FrameHub {
 public:
  FrameHub();
  ~FrameHub();  ///< closes
  FrameHub(const FrameHub&) = delete;
  FrameHub& operator=(const FrameHub&) = delete;

  void publish(FramePtr frame);
  /// Tells the queues that the stream has a fault here; frames may go on behind it.
  void fault(const Error& error);
  /// Nothing will come any more; wakes all who wait.
  void close();

  /// Null before the first frame.
  [[nodiscard]] FramePtr latest() const;
  /// A reader of what is published from now on.
  [[nodiscard]] LatestFrameReader reader() const;
  [[nodiscard]] std::unique_ptr<FrameQueue> subscribe(std::size_t capacity) const;

 private:
  std::shared_ptr<FrameHubState> state_;
};

}  // namespace alltact
