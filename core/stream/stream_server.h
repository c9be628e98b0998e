// Sends results to other programs of this user on this computer.
#pragma once

#include "core/base/atomic_file.h"
#include "core/base/descriptor.h"
#include "core/base/result.h"
#include "core/stream/stream_format.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <sys/types.h>

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

// A Unix socket for programs of one user on this computer only.

/// Default socket of a finger: alltact/NAME.sock in $XDG_RUNTIME_DIR, which belongs to the user
/// alone. Without that variable: in alltact-UID in the folder for temporary files.
[[nodiscard]] std::filesystem::path default_socket(const std::string& finger_name);

/// A Unix socket (SOCK_STREAM) that listens at a path, which is removed with it. Clients connect
/// through the file, so none on another computer can; the file's mode is 0600.
class ListeningSocket {
 public:
  /// Makes the folder (mode 0700) where it is missing, and replaces the socket of a killed server.
  /// Errors: another server listens there, with its `doing`; others may write in the folder, or own
  /// it; something else than a socket at the path; the path is too long for a socket (107 bytes).
  [[nodiscard]] static Result<ListeningSocket> listen(const std::filesystem::path& path,
                                                      const std::string& doing);
  ListeningSocket(ListeningSocket&&) noexcept = default;
  ListeningSocket& operator=(ListeningSocket&&) noexcept = default;
  ~ListeningSocket();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] int descriptor() const { return socket_.number(); }
  /// The next connection, without blocking. Not open: nobody is waiting, or accept() failed
  /// (`errno`).
  [[nodiscard]] Descriptor accept() const;

 private:
  ListeningSocket(std::filesystem::path path, LockFile held, Descriptor socket)
      : path_(std::move(path)), held_(std::move(held)), socket_(std::move(socket)) {}

  std::filesystem::path path_;
  std::optional<LockFile> held_;
  Descriptor socket_;
  ino_t inode_ = 0;  // of the file, which is removed only while it is this socket's
};

/// True when the other end of a connection is a program of this program's user.
[[nodiscard]] bool is_own_peer(int connection);

}  // namespace alltact
