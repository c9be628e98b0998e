// A disk that is quickly full, or that forbids writing.
#pragma once

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>

#include <sys/mount.h>
#include <unistd.h>

namespace alltact::test {

/// A file system of `kilobytes` in memory, mounted on a folder that is made for it. Only root can.
class SmallDisk {
 public:
  SmallDisk(const std::filesystem::path& place, int kilobytes) : place_(place) {
    std::filesystem::create_directories(place);
    const std::string size = "size=" + std::to_string(kilobytes) + "k";
    is_mounted_ = ::mount("tmpfs", place.c_str(), "tmpfs", 0, size.c_str()) == 0;
    if (!is_mounted_)
      problem_ = geteuid() == 0
                     ? std::string("a small disk cannot be mounted here: ") + std::strerror(errno)
                     : "only root can mount a small disk";
  }
  ~SmallDisk() {
    if (is_mounted_) ::umount2(place_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  [[nodiscard]] bool mounted() const { return is_mounted_; }
  /// Why it is not mounted, for a skipped test.
  [[nodiscard]] const std::string& problem() const { return problem_; }
  [[nodiscard]] bool forbid_writing() const {
    return ::mount(nullptr, place_.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr) == 0;
  }

 private:
  std::filesystem::path place_;
  std::string problem_;
  bool is_mounted_ = false;
};

}  // namespace alltact::test
