#include "core/stream/stream_socket.h"

#include "core/io/atomic_file.h"
#include "core/io/system_error.h"
#include "core/printable.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr int kBacklog = 16;  // length of the queue of new connections

fs::path lock_of(const fs::path& socket) {
  return socket.string() + ".lock";
}

Error cannot_listen(const fs::path& path, int error_number) {
  return system_error(en::say("programs could not be let in here"), path, error_number);
}

Result<sockaddr_un> address_of(const fs::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string& name = path.native();
  if (name.size() >= sizeof address.sun_path)
    return Error{en::say("the path is longer than the {} bytes that a socket's may have",
                         sizeof address.sun_path - 1),
                 path,
                 en::say("a shorter one with --socket")};
  name.copy(address.sun_path, name.size());
  return address;
}

Descriptor new_socket() {
  return Descriptor(socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

/// Only this user may replace files in the folder.
Status make_private_folder(const fs::path& folder) {
  std::error_code failed;
  if (folder.has_parent_path()) fs::create_directories(folder.parent_path(), failed);
  if (mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST) return cannot_listen(folder, errno);
  struct stat of {};
  if (stat(folder.c_str(), &of) != 0) return cannot_listen(folder, errno);
  if (!S_ISDIR(of.st_mode)) return cannot_listen(folder, ENOTDIR);
  if (of.st_uid != geteuid())
    return Error{en::say("this folder belongs to somebody else, who could read along"),
                 folder,
                 en::say("a folder of your own with --socket")};
  if ((of.st_mode & (S_IWGRP | S_IWOTH)) != 0)
    return Error{en::say("others may write in this folder, and could put their own socket there"),
                 folder,
                 en::say("chmod 700, or another folder with --socket")};
  return {};
}

Status check_free(const fs::path& path, const sockaddr_un& address) {
  struct stat of {};
  if (lstat(path.c_str(), &of) != 0) return errno == ENOENT ? Status() : cannot_listen(path, errno);
  if (!S_ISSOCK(of.st_mode))
    return Error{en::say("there is something here that is no socket, and it is left alone"),
                 path,
                 en::say("another path with --socket")};
  const Descriptor probe = new_socket();
  if (connect(probe.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 &&
      errno != EAGAIN)
    return {};
  const auto who = read_file(lock_of(path));
  return Error{
      en::say("another program serves here already ({})", who ? printable(*who) : std::string("?")),
      path,
      en::say("connecting to that one, ending it, or another path with --socket")};
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) close(number_);
}

fs::path default_socket(const std::string& finger_name) {
  std::string name = finger_name + ".sock";
  std::replace(name.begin(), name.end(), '/', '_');
  std::error_code failed;
  const char* own = std::getenv("XDG_RUNTIME_DIR");
  if (own != nullptr && fs::path(own).is_absolute() && fs::is_directory(own, failed))
    return fs::path(own) / "alltact" / name;
  return fs::temp_directory_path(failed) / fmt::format("alltact-{}", geteuid()) / name;
}

Result<ListeningSocket> ListeningSocket::listen(const fs::path& given, const std::string& doing) {
  std::error_code failed;
  const fs::path path = fs::absolute(given, failed);
  const auto address = address_of(path);
  if (!address) return address.error();
  if (Status made = make_private_folder(path.parent_path()); !made) return made.error();
  if (Status free = check_free(path, *address); !free) return free.error();
  auto held = LockFile::hold(lock_of(path), this_process(doing), std::chrono::milliseconds(0));
  if (!held) return held.error();
  // The lock excludes other servers: an existing file is a rest.
  if (Status free = check_free(path, *address); !free) return free.error();
  unlink(path.c_str());
  ListeningSocket made(path, std::move(*held), new_socket());
  if (bind(made.descriptor(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address) != 0)
    return cannot_listen(path, errno);
  struct stat of {};
  if (stat(path.c_str(), &of) == 0) made.inode_ = of.st_ino;
  // Before anybody can connect.
  if (chmod(path.c_str(), S_IRUSR | S_IWUSR) != 0 || ::listen(made.descriptor(), kBacklog) != 0)
    return cannot_listen(path, errno);
  return made;
}

ListeningSocket::~ListeningSocket() {
  struct stat of {};
  if (socket_.is_open() && stat(path_.c_str(), &of) == 0 && of.st_ino == inode_)
    unlink(path_.c_str());
}

Descriptor ListeningSocket::accept() const {
  return Descriptor(accept4(socket_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
}

bool is_own_peer(int connection) {
  ucred peer{};
  socklen_t size = sizeof peer;
  return getsockopt(connection, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 &&
         size == sizeof peer && peer.uid == geteuid();
}

}  // namespace alltact
