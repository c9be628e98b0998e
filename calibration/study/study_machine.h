// What a study's times hang on beside the program: the computer and the power it runs on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace alltact {

struct StudyMachine {
  std::string processor = "unknown";  ///< its maker's name for it
  int cores = 0;                      ///< that this program may use
  std::string system;                 ///< kernel and release
  std::string governor = "unknown";   ///< of the first core's clock: "performance"; see cpufreq
  std::optional<double> clock_mhz;    ///< of the first core, then
  std::optional<bool> is_on_battery;  ///< absent: the computer does not tell
};

/// Of this computer, now. What cannot be read stays unknown.
///   root: "/"; another in tests
[[nodiscard]] StudyMachine this_machine(const std::filesystem::path& root = "/");

[[nodiscard]] nlohmann::json json_of(const StudyMachine& machine);

}  // namespace alltact
