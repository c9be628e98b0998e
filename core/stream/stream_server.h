// Sends what is measured to other programs of this user on this computer.
#pragma once

#include "core/result.h"
#include "core/stream/stream_format.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace alltact {

struct StreamCounts {
  std::size_t clients = 0;    ///< that are served now
  std::uint64_t served = 0;   ///< and were ever
  std::uint64_t refused = 0;  ///< of other users, too many, or not understood
  std::uint64_t lost = 0;     ///< frames that clients were too slow for, summed over all of them
};

/// A socket (ListeningSocket) and the programs that have connected to it, on a thread of its own.
/// Each gets the description, then what is published from then on. One that is slow loses frames,
/// which its header counts: the newest is sent next. Nobody is ever waited for. Any thread may call
/// any function.
class StreamServer {
 public:
  static constexpr std::size_t kMostClients = 16;

  /// Errors: those of ListeningSocket::listen. `doing`: who this is, for another server.
  [[nodiscard]] static Result<std::unique_ptr<StreamServer>> start(
      const std::filesystem::path& socket, const std::string& doing);
  ~StreamServer();
  StreamServer(const StreamServer&) = delete;
  StreamServer& operator=(const StreamServer&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const;
  /// Puts a message on its way and returns. One of type kFinger is also the first that whoever
  /// connects later gets; until there was one, nobody gets anything.
  void publish(StreamMessage message);
  /// What any of the clients asked for: the rest need not be made.
  [[nodiscard]] StreamPartSet wanted() const;
  [[nodiscard]] StreamCounts counts() const;
  /// Tells the clients why, waits until they have heard it, at most a second, and lets nobody in
  /// any more. `json`: of the kEnd message.
  void end(std::string json);

 private:
  struct State;
  explicit StreamServer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace alltact
