// A connected client program, which is never waited for.
#pragma once

#include "core/stream/stream_format.h"
#include "core/stream/stream_socket.h"

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

using StreamMessagePtr = std::shared_ptr<const StreamMessage>;

/// One thread. No call blocks. Besides the message being sent, it holds the newest frame and,
/// before it, the newest message of every other kind.
class StreamClient {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kRequestTimeout{5};  ///< for its request line
  static constexpr std::chrono::seconds kLeaveTimeout{1};    ///< for its last message

  StreamClient(Descriptor connection, Clock::time_point now)
      : connection_(std::move(connection)), leave_by_(now + kRequestTimeout) {}

  [[nodiscard]] int descriptor() const { return connection_.number(); }
  /// The client has sent its request and takes messages.
  [[nodiscard]] bool has_request() const { return requested_.has_value() && !is_leaving_; }
  [[nodiscard]] StreamPartSet requested() const { return requested_.value_or(StreamPartSet()); }
  [[nodiscard]] bool wants_to_read() const { return !has_closed_input_; }
  [[nodiscard]] bool wants_to_write() const { return sending_ || !due_.empty() || newest_; }
  /// The client has left, or there is nothing more to send.
  [[nodiscard]] bool is_over(Clock::time_point now) const;
  /// When is_over() may change by itself; empty: never.
  [[nodiscard]] std::optional<Clock::time_point> deadline() const;
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  [[nodiscard]] bool is_refused() const { return is_refused_; }

  /// Call when there is something to read. An invalid request ends the connection, with the reason.
  void read(Clock::time_point now);
  /// Call when the client accepts more bytes.
  void write();
  /// Call when the client's end is gone.
  void hang_up() { is_gone_ = true; }

  void offer(const StreamMessagePtr& message, Clock::time_point now);
  /// Sends the reason and ends the connection.
  void refuse(const Error& why, Clock::time_point now);

 private:
  void leave(Clock::time_point now);
  void take_line(Clock::time_point now);
  bool begin_next();
  struct Sending {
    StreamBytes bytes;
    std::size_t sent = 0, size = 0;
  };

  Descriptor connection_;
  Clock::time_point leave_by_;
  std::string line_;
  std::optional<StreamPartSet> requested_;
  std::optional<Sending> sending_;
  std::deque<StreamMessagePtr> due_;
  StreamMessagePtr newest_;  // newest_ holds a frame
  std::uint64_t lost_ = 0;
  bool has_closed_input_ = false, is_leaving_ = false, is_refused_ = false, is_gone_ = false;
};

}  // namespace alltact
