// One program at the other end of a connection, never waited for.
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

/// Of one thread. No call blocks. What goes to it beside one whole message: the newest frame, and
/// of every other kind of message the newest, before that frame.
class StreamClient {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kToAsk{5};    ///< for its line
  static constexpr std::chrono::seconds kToLeave{1};  ///< for what it is told at its end

  StreamClient(Descriptor connection, Clock::time_point now)
      : connection_(std::move(connection)), leave_by_(now + kToAsk) {}

  [[nodiscard]] int descriptor() const { return connection_.number(); }
  /// It takes messages; what it asked for.
  [[nodiscard]] bool has_asked() const { return wanted_.has_value() && !is_leaving_; }
  [[nodiscard]] StreamPartSet wanted() const { return wanted_.value_or(StreamPartSet()); }
  [[nodiscard]] bool wants_to_read() const { return !has_closed_input_; }
  [[nodiscard]] bool wants_to_write() const { return sending_ || !due_.empty() || newest_; }
  /// It has left, or there is nothing to be said to it any more.
  [[nodiscard]] bool is_over(Clock::time_point now) const;
  /// When is_over() may change by itself; nothing: never.
  [[nodiscard]] std::optional<Clock::time_point> deadline() const;
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  [[nodiscard]] bool is_refused() const { return is_refused_; }

  /// When there is something to read. What cannot be understood ends the connection, with the
  /// reason.
  void read(Clock::time_point now);
  /// When it takes more.
  void write();
  /// Its end is gone.
  void hang_up() { is_gone_ = true; }

  void offer(const StreamMessagePtr& message, Clock::time_point now);
  /// Says why and ends the connection.
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
  std::optional<StreamPartSet> wanted_;
  std::optional<Sending> sending_;
  std::deque<StreamMessagePtr> due_;
  StreamMessagePtr newest_;  // frame
  std::uint64_t lost_ = 0;
  bool has_closed_input_ = false, is_leaving_ = false, is_refused_ = false, is_gone_ = false;
};

}  // namespace alltact
