// A YAML file while it is read: what was asked for, and what becomes of the rest.
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

/// A file while it is read.
class YamlFile {
 public:
  /// Larger files are a mistake.
  static constexpr std::size_t kMaxBytes = std::size_t{4} << 20;
  /// What becomes of keys that nobody asks for.
  enum class Unknown { kKept = 1, kRefused };

  explicit YamlFile(std::filesystem::path path, Unknown policy = Unknown::kKept);

  /// `reader` asks for all that it knows, from the top of the file; `content` is what that holds.
  /// What it did not ask for is kept and warned of, or refused. The first problem ends it.
  Status read(const std::string& content, const std::function<void(YamlSection&)>& reader);
  /// Reads the file itself.
  Status load(const std::function<void(YamlSection&)>& reader);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::vector<Message>& warnings() { return warnings_; }
  [[nodiscard]] UnknownKeys& unknown() { return unknown_; }
  /// An error about a key that was read becomes one about a line of the file.
  [[nodiscard]] Error located(const Error& error) const;

 private:
  friend class YamlSection;
  [[nodiscard]] Error error(Message what, int line, std::string_view key, Message advice) const;
  void count(std::size_t parts);
  void look_at_the_rest();

  struct Section;
  std::filesystem::path path_;
  Unknown policy_;
  std::vector<std::shared_ptr<Section>> sections_;  // that were read
  std::map<std::string, int> lines_;                // of every key in them, by its full name
  std::size_t parts_ = 0;                           // that were read
  std::vector<Message> warnings_;
  UnknownKeys unknown_;
};

}  // namespace alltact
