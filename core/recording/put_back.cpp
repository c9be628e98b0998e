#include "core/recording/put_back.h"

#include "core/io/atomic_file.h"
#include "core/io/system_error.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

namespace alltact {
namespace {

constexpr std::string_view kPuttingBack = "could not put the recording back";

Status copy_all(int from, int to, const std::filesystem::path& file) {
  constexpr std::size_t kStep = std::size_t{1} << 30;
  off_t at = 0;
  while (true) {
    const ssize_t copied = ::sendfile(to, from, &at, kStep);
    if (copied == 0) break;
    if (copied < 0 && errno != EINTR) return system_error(kPuttingBack, file, errno);
  }
  if (::fsync(to) != 0) return system_error(kPuttingBack, file, errno);
  return {};
}

}  // namespace

bool is_removed(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && status.st_nlink == 0;
}

Status put_back(int descriptor, const std::filesystem::path& file) {
  if (file.has_parent_path())
    if (Status status = make_folder(file.parent_path()); !status) return status;
  // Ours is open for writing only; the same file once more, for reading.
  const int from =
      ::open(fmt::format("/proc/self/fd/{}", descriptor).c_str(), O_RDONLY | O_CLOEXEC);
  if (from < 0) return system_error(kPuttingBack, file, errno);
  const int to = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  Status status = to < 0 ? system_error(kPuttingBack, file, errno) : copy_all(from, to, file);
  ::close(from);
  if (to >= 0) ::close(to);
  return status;
}

}  // namespace alltact
