// What to simulate, as data: a finger, its motion, and a list of named effects.
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace alltact {

/// A scene after reading and format checks: a finger and a list of effects with parameters.
/// Presence is the only switch: effects that are not listed are not built. Unknown effects and keys
/// are errors with file, line and key.
class Scene {
 public:
  static Result<Scene> load(const std::filesystem::path& file);
  /// `origin` names the text in errors.
  static Result<Scene> parse(std::string_view yaml, const std::string& origin);

  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] const std::string& why() const;  ///< purpose of its effects

  struct Content;
  [[nodiscard]] const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace alltact
