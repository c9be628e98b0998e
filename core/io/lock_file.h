// A lock file with the name of its owner.
#pragma once

#include "core/result.h"

#include <chrono>
#include <filesystem>
#include <string>

namespace alltact {

/// The lock is held from hold() until destruction or the end of the program, even by a crash; the
/// file exists meanwhile. Threads of one program exclude each other like programs. It works between
/// computers where the folder's server supports flock() (NFS does).
class LockFile {
 public:
  /// Makes the file, locks it and writes the owner into it. Waits up to `timeout` for another
  /// owner. Errors: another owner, with the line it wrote; the folder cannot be written.
  ///   who: one line ("calibrating, alltact on ada, since 12:00:05")
  [[nodiscard]] static Result<LockFile> hold(const std::filesystem::path& file,
                                             const std::string& who,
                                             std::chrono::milliseconds timeout);
  LockFile(LockFile&& other) noexcept;
  LockFile& operator=(LockFile&& other) noexcept;
  ~LockFile();

 private:
  LockFile(std::filesystem::path file, int descriptor)
      : file_(std::move(file)), descriptor_(descriptor) {}

  std::filesystem::path file_;
  int descriptor_ = -1;
};

/// Returns "DOING, process 4711 on ada, since 12:00:05 UTC", for `who`.
[[nodiscard]] std::string this_process(const std::string& doing);

}  // namespace alltact
