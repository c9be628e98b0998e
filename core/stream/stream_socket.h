// A Unix socket for programs of one user on this computer only.
#pragma once

#include "core/io/lock_file.h"
#include "core/result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include <sys/types.h>

namespace alltact {

/// A file descriptor that is closed with its owner.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

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
