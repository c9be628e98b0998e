// One writer, many readers: viewers get the latest frame, recorders get every frame.
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

/// State shared by a FrameHub and its readers.
struct FrameHubState;

/// Reads the latest frame only. A slow reader misses frames, which it counts, and never gets an old
/// one. One thread; may outlive the hub.
class LatestFrameReader {
 public:
  /// Waits for a frame that this reader has not returned yet. nullptr: none came within `timeout`,
  /// or the hub has closed.
  [[nodiscard]] FramePtr next(std::chrono::milliseconds timeout);
  /// Frames published since this reader was made that it never returned.
  [[nodiscard]] std::uint64_t missed() const { return missed_; }

 private:
  friend class FrameHub;
  LatestFrameReader(std::shared_ptr<FrameHubState> state, std::uint64_t seen)
      : state_(std::move(state)), seen_(seen) {}
  std::shared_ptr<FrameHubState> state_;
  std::uint64_t seen_;  // frames published at the last call of next()
  std::uint64_t missed_ = 0;
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
