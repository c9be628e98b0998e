#include "core/recording/steady_sync.h"

#include "core/io/atomic_file.h"
#include "core/io/disk_wait.h"

#include <fcntl.h>
#include <unistd.h>

namespace alltact {

SteadySync::SteadySync(std::vector<std::filesystem::path> files, std::chrono::milliseconds every)
    : files_(std::move(files)),
      every_(every),
      descriptors_(files_.size(), -1),
      thread_([this] { run(); }) {}

SteadySync::~SteadySync() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  ending_.notify_all();
  thread_.join();
  for (const int descriptor : descriptors_)
    if (descriptor >= 0) ::close(descriptor);
}

void SteadySync::run() {
  std::unique_lock lock(mutex_);
  while (!ending_.wait_for(lock, every_, [&] { return is_ending_; })) {
    lock.unlock();
    sync();
    lock.lock();
  }
}

void SteadySync::sync() {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    int& descriptor = descriptors_[i];
    const bool is_new = descriptor < 0;
    // An open descriptor follows its file, wherever it is moved.
    if (is_new) descriptor = ::open(files_[i].c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) continue;
    const DiskWait waiting(files_[i]);
    (void)::fdatasync(descriptor);
    if (!is_new) continue;
    const std::filesystem::path folder =
        files_[i].has_parent_path() ? files_[i].parent_path() : std::filesystem::path(".");
    (void)sync_folder(folder);
  }
}

}  // namespace alltact
