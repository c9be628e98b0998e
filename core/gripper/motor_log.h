// Where the motor stood while a recording was made.
#pragma once

#include "core/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace alltact {

/// A table of motor positions by time, on the clock of the frames: a line "time_ns,turns", then a
/// whole number and a number a line, in the order of time. A value.
class MotorLog {
 public:
  /// Errors, with file and line: not readable; no such table; a number that is none; a time that is
  /// not after the one before; fewer than two lines.
  static Result<MotorLog> load(const std::filesystem::path& file);
  static Result<MotorLog> parse(const std::string& content, const std::filesystem::path& origin);

  /// Straight between the lines; nullopt before the first and after the last.
  [[nodiscard]] std::optional<double> turns_at(std::int64_t time_ns) const;

 private:
  std::vector<std::pair<std::int64_t, double>> lines_;
};

}  // namespace alltact
