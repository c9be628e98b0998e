#include "core/io/lock_file.h"

#include "core/io/system_error.h"
#include "core/printable.h"

#include <array>
#include <cerrno>
#include <ctime>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace alltact {
namespace {

constexpr auto kLockPoll = std::chrono::milliseconds(5);

/// True when the file's name still refers to the opened file: nobody removed it in between.
bool is_still_there(const std::filesystem::path& file, int descriptor) {
  struct stat opened {
  }, named{};
  return fstat(descriptor, &opened) == 0 && stat(file.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

std::string owner_in(int descriptor) {
  std::array<char, 400> text{};
  const ssize_t read = pread(descriptor, text.data(), text.size(), 0);
  return read > 0 ? printable({text.data(), static_cast<std::size_t>(read)}) : std::string();
}

Error held_by(const std::string& who, const std::filesystem::path& file) {
  const Message other = who.empty() ? en::say("another program") : Message::typed(who);
  Message what = en::say("somebody else is at work here: {0}", other);
  return {std::move(what), file.parent_path(), en::say("waiting until that is done")};
}

}  // namespace

Result<LockFile> LockFile::hold(const std::filesystem::path& file,
                                const std::string& who,
                                std::chrono::milliseconds timeout) {
  const auto end = std::chrono::steady_clock::now() + timeout;
  while (true) {
    const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor < 0)
      return system_error(en::say("could not be written"), file.parent_path().string(), errno);
    LockFile held(file, descriptor);
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
      if (!is_still_there(file, descriptor)) {
        held.file_.clear();  // now another owner's, who removes it
        continue;
      }
      // The text is for people only; the lock does not depend on it.
      if (ftruncate(descriptor, 0) == 0) (void)!pwrite(descriptor, who.data(), who.size(), 0);
      return held;
    }
    const int problem = errno;
    held.file_.clear();
    if (problem != EWOULDBLOCK && problem != EINTR)
      return system_error(en::say("could not be held"), file.string(), problem);
    if (std::chrono::steady_clock::now() >= end) return held_by(owner_in(descriptor), file);
    std::this_thread::sleep_for(kLockPoll);
  }
}

LockFile::LockFile(LockFile&& other) noexcept
    : file_(std::exchange(other.file_, {})), descriptor_(std::exchange(other.descriptor_, -1)) {}

LockFile& LockFile::operator=(LockFile&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

LockFile::~LockFile() {
  if (descriptor_ < 0) return;
  // Removed under the lock: a program that opened it meanwhile detects that it is gone, and
  // retries.
  if (!file_.empty()) unlink(file_.c_str());
  close(descriptor_);
}

std::string this_process(const std::string& doing) {
  std::array<char, 256> computer{};
  if (gethostname(computer.data(), computer.size() - 1) != 0) computer[0] = '?';
  return fmt::format("{}, process {} on {}, since {:%H:%M:%S} UTC",
                     doing,
                     getpid(),
                     computer.data(),
                     fmt::gmtime(std::time(nullptr)));
}

}  // namespace alltact
