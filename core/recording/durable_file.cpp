#include "core/recording/durable_file.h"

#include "core/base/atomic_file.h"
#include "core/base/guarded.h"
#include "core/base/result.h"
#include "core/base/slow_disk.h"

#include <cerrno>

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

namespace alltact {
namespace {

constexpr off_t kRestoreUnit = 1000000;  // MB

Message restoring() { return en::say("could not restore the recording"); }

off_t size_of(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 ? status.st_size : 0;
}

/// Each step is on the disk before the next, so that the reported progress is true and no long wait
/// remains at the end.
Status copy_all(int from, int to, const std::filesystem::path& file, const Job& job) {
  constexpr std::size_t kStep = std::size_t{16} << 20U;
  const bool can_stop = !job.stop_requested();
  const off_t size = size_of(from);
  for (off_t at = 0;;) {
    if (can_stop && job.stop_requested())
      return Error{en::say("stopped when {} of {} MB of the recording were restored",
                           at / kRestoreUnit, size / kRestoreUnit),
                   file.string(), ""};
    const ssize_t copied = ::sendfile(to, from, &at, kStep);
    if (copied == 0) return {};
    if (copied < 0 && errno == EINTR) continue;
    if (copied < 0 || ::fdatasync(to) != 0) return system_error(restoring(), file, errno);
    job.report(static_cast<double>(at) / static_cast<double>(std::max(at, size)),
               en::say("restoring the removed recording: {} of {} MB", at / kRestoreUnit,
                       size / kRestoreUnit));
  }
}

Status copy_file(int from, int to, const std::filesystem::path& file, const Job& job) {
  if (::ioctl(to, FICLONE, from) != 0)
    if (Status status = copy_all(from, to, file, job); !status) return status;
  if (::fsync(to) != 0) return system_error(restoring(), file, errno);
  return {};
}

}  // namespace

bool is_removed(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && status.st_nlink == 0;
}

Status restore_file(int descriptor, const std::filesystem::path& file, const Job& job) {
  if (file.has_parent_path())
    if (Status status = make_folder(file.parent_path()); !status) return status;
  // The descriptor is write-only: opens the same file again for reading.
  const Descriptor from(
      ::open(fmt::format("/proc/self/fd/{}", descriptor).c_str(), O_RDONLY | O_CLOEXEC));
  if (!from.is_open()) return system_error(restoring(), file, errno);
  const Descriptor to(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!to.is_open()) return system_error(restoring(), file, errno);
  return copy_file(from.number(), to.number(), file, job);
}

SteadySync::SteadySync(std::vector<std::filesystem::path> files, std::chrono::milliseconds every)
    : files_(std::move(files)),
      descriptors_(files_.size()),
      worker_([this, every](const std::stop_token& stop) {
        while (!is_stopped_within(stop, every))
          static_cast<void>(guarded([this] { sync(); }));  // the writer reports failures
      }) {}

void SteadySync::sync() {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    Descriptor& descriptor = descriptors_[i];
    const bool is_new = !descriptor.is_open();
    // An open descriptor follows its file, wherever it is moved.
    if (is_new) descriptor = Descriptor(::open(files_[i].c_str(), O_RDONLY | O_CLOEXEC));
    if (!descriptor.is_open()) continue;
    const DiskWait waiting(files_[i]);
    (void)::fdatasync(descriptor.number());
    if (!is_new) continue;
    const std::filesystem::path folder =
        files_[i].has_parent_path() ? files_[i].parent_path() : std::filesystem::path(".");
    (void)sync_folder(folder);
  }
}

}  // namespace alltact
