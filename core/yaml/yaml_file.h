// A YAML file during reading: its keys, and the treatment of unknown ones.
#pragma once

#include "core/result.h"
#include "core/yaml/yaml_value.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

class YamlSection;

/// A YAML file during reading.
class YamlFile {
 public:
  /// Larger files are refused.
  static constexpr std::size_t kMaxBytes = std::size_t{4} << 20;
  /// Treatment of keys that the reader does not request.
  enum class Unknown { kRetained = 1, kRefused };

  explicit YamlFile(std::filesystem::path path, Unknown policy = Unknown::kRetained);

  /// `reader` requests all keys that it knows, starting at the top section; `content` is the file's
  /// text. Unrequested keys are retained with a warning, or refused. The first problem ends the
  /// reading.
  Status read(const std::string& content, const std::function<void(YamlSection&)>& reader);
  /// Reads the file from the disk.
  Status load(const std::function<void(YamlSection&)>& reader);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::vector<Message>& warnings() { return warnings_; }
  [[nodiscard]] UnknownKeys& unknown() { return unknown_; }
  /// Adds the file's line to an error about a key that was read.
  [[nodiscard]] Error located(const Error& error) const;

 private:
  friend class YamlSection;
  [[nodiscard]] Error error(Message what, int line, std::string_view key, Message advice) const;
  void count(std::size_t parts);
  void check_unread_keys();

  struct Section;
  std::filesystem::path path_;
  Unknown policy_;
  std::vector<std::shared_ptr<Section>> sections_;  // sections that were read
  std::map<std::string, int> lines_;                // of every key in them, by its full name
  std::size_t parts_ = 0;                           // number of values that were read
  std::vector<Message> warnings_;
  UnknownKeys unknown_;
};

}  // namespace alltact
