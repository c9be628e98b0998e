// A file that one program at a time holds, and that tells the others who does.
#pragma once

#include "core/result.h"

#include <chrono>
#include <filesystem>
#include <string>

namespace alltact {

/// Held from hold() until it is destroyed or its program ends, however it ends; the file is there
/// for as long. Threads of one program exclude each other just as programs do. Works between
/// computers where the folder's server knows flock() (NFS does).
class HeldFile {
 public:
  /// Makes the file, holds it and writes into it who does. While another holds it, waits up to
  /// `patience`. Errors: another holds it, who is named as that one wrote; the folder cannot be
  /// written.
  ///   who: one line ("calibrating, alltact on ada, since 12:00:05")
  [[nodiscard]] static Result<HeldFile> hold(const std::filesystem::path& file,
                                             const std::string& who,
                                             std::chrono::milliseconds patience);
  HeldFile(HeldFile&& other) noexcept;
  HeldFile& operator=(HeldFile&& other) noexcept;
  ~HeldFile();

 private:
  HeldFile(std::filesystem::path file, int descriptor)
      : file_(std::move(file)), descriptor_(descriptor) {}

  std::filesystem::path file_;
  int descriptor_ = -1;
};

/// "DOING, process 4711 on ada, since 12:00:05 UTC": for who.
[[nodiscard]] std::string this_process(const std::string& doing);

}  // namespace alltact
