// Sends results to other programs of this user on this computer.
#pragma once

#include "core/result.h"
#include "core/stream/stream_format.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace alltact {

struct StreamCounts {
  std::size_t clients = 0;    ///< currently connected
  std::uint64_t served = 0;   ///< in total
  std::uint64_t refused = 0;  ///< of other users, too many, or with an invalid request
  std::uint64_t lost = 0;     ///< frames for which clients were too slow, summed over all of them
};

/// A socket (ListeningSocket) and its clients, on a thread of its own. Each client gets the
/// description, then every later message. A slow client loses frames, which its header counts, and
/// gets the newest one next. The server never waits for a client. Any thread may call any function.
class StreamServer {
 public:
  static constexpr std::size_t kMaxClients = 16;

  /// Errors: those of ListeningSocket::listen. `doing`: this program's activity, for another
  /// server's message.
  [[nodiscard]] static Result<std::unique_ptr<StreamServer>> start(
      const std::filesystem::path& socket, const std::string& doing);
  ~StreamServer();
  StreamServer(const StreamServer&) = delete;
  StreamServer& operator=(const StreamServer&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const;
  /// Sends a message without waiting. The last one of type kFinger is also the first message for
  /// later clients; before it, nobody gets anything.
  void publish(StreamMessage message);
  /// Parts that any client requested; the others need not be made.
  [[nodiscard]] StreamPartSet requested() const;
  [[nodiscard]] StreamCounts counts() const;
  /// Sends the reason to the clients, waits at most a second until they have it, and accepts no
  /// more connections. `json`: of the kEnd message.
  void end(std::string json);

 private:
  struct State;
  explicit StreamServer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace alltact
