// A folder for what one run needs and nobody afterwards.
#pragma once

#include "core/message.h"
#include "core/result.h"

#include <cstdlib>
#include <filesystem>
#include <string>

namespace alltact {

/// A folder for this run alone, gone when it is over.
class PassingFolder {
 public:
  /// Error: `cannot`, there is no room or no permission.
  static Result<PassingFolder> make(const Message& cannot) {
    std::error_code failed;
    std::string path = (std::filesystem::temp_directory_path(failed) / "alltact-XXXXXX").string();
    if (failed || mkdtemp(path.data()) == nullptr)
      return Error{cannot, path, en::say("free space, or -o with a folder")};
    return PassingFolder(path);
  }
  PassingFolder(PassingFolder&& other) noexcept : path_(std::move(other.path_)) {
    other.path_.clear();
  }
  PassingFolder& operator=(PassingFolder&&) = delete;
  ~PassingFolder() {
    std::error_code failed;
    if (!path_.empty()) std::filesystem::remove_all(path_, failed);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  explicit PassingFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

}  // namespace alltact
