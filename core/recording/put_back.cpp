#include "core/recording/put_back.h"

#include "core/io/atomic_file.h"
#include "core/io/system_error.h"

#include <cerrno>

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

namespace alltact {
namespace {

constexpr off_t kPutBackUnit = 1000000;  // MB

Message putting_back() {
  return en::say("could not put the recording back");
}

off_t size_of(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 ? status.st_size : 0;
}

/// Each step lies on the disk before the next, so that what is reported is true and no long wait
/// is left for the end.
Status copy_all(int from, int to, const std::filesystem::path& file, const Job& job) {
  constexpr std::size_t kStep = std::size_t{16} << 20U;
  const bool can_stop = !job.stop_requested();
  const off_t size = size_of(from);
  for (off_t at = 0;;) {
    if (can_stop && job.stop_requested())
      return Error{en::say("stopped when {} of {} MB of the recording were put back",
                           at / kPutBackUnit,
                           size / kPutBackUnit),
                   file.string(),
                   ""};
    const ssize_t copied = ::sendfile(to, from, &at, kStep);
    if (copied == 0) return {};
    if (copied < 0 && errno == EINTR) continue;
    if (copied < 0 || ::fdatasync(to) != 0) return system_error(putting_back(), file, errno);
    job.report(static_cast<double>(at) / static_cast<double>(std::max(at, size)),
               en::say("putting the removed recording back: {} of {} MB",
                       at / kPutBackUnit,
                       size / kPutBackUnit));
  }
}

Status bring(int from, int to, const std::filesystem::path& file, const Job& job) {
  if (::ioctl(to, FICLONE, from) != 0)
    if (Status status = copy_all(from, to, file, job); !status) return status;
  if (::fsync(to) != 0) return system_error(putting_back(), file, errno);
  return {};
}

}  // namespace

bool is_removed(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && status.st_nlink == 0;
}

Status put_back(int descriptor, const std::filesystem::path& file, const Job& job) {
  if (file.has_parent_path())
    if (Status status = make_folder(file.parent_path()); !status) return status;
  // Ours is open for writing only; the same file once more, for reading.
  const int from =
      ::open(fmt::format("/proc/self/fd/{}", descriptor).c_str(), O_RDONLY | O_CLOEXEC);
  if (from < 0) return system_error(putting_back(), file, errno);
  const int to = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  Status status = to < 0 ? system_error(putting_back(), file, errno) : bring(from, to, file, job);
  ::close(from);
  if (to >= 0) ::close(to);
  return status;
}

}  // namespace alltact
