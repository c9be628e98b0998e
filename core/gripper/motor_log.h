// The motor's position during a recording.
#pragma once

#include "core/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace alltact {

/// A table of motor positions by time, on the clock of the frames: a header line "time_ns,turns",
/// then an integer and a number on each line, in order of time. A value.
class MotorLog {
 public:
  /// Errors, with file and line: not readable; no such table; not a number; a time that is not
  /// after the previous one; fewer than two lines.
  static Result<MotorLog> load(const std::filesystem::path& file);
  static Result<MotorLog> parse(const std::string& content, const std::filesystem::path& origin);

  /// Linear between the lines; nullopt before the first and after the last.
  [[nodiscard]] std::optional<double> turns_at(std::int64_t time_ns) const;

 private:
  std::vector<std::pair<std::int64_t, double>> lines_;
};

}  // namespace alltact
