// A temporary folder for one run.
#pragma once

#include "core/message.h"
#include "core/result.h"

#include <cstdlib>
#include <filesystem>
#include <string>

namespace alltact {

/// Removed when it is destroyed.
class TemporaryFolder {
 public:
  /// Error: `cannot`, there is no room or no permission.
  static Result<TemporaryFolder> make(const Message& cannot) {
    std::error_code failed;
    std::string path = (std::filesystem::temp_directory_path(failed) / "alltact-XXXXXX").string();
    if (failed || mkdtemp(path.data()) == nullptr)
      return Error{cannot, path, en::say("free space, or -o with a folder")};
    return TemporaryFolder(path);
  }
  TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::move(other.path_)) {
    other.path_.clear();
  }
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder() {
    std::error_code failed;
    if (!path_.empty()) std::filesystem::remove_all(path_, failed);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

}  // namespace alltact
