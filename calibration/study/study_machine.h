// What a study's times depend on besides the program: the computer and its power supply.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace alltact {

struct StudyMachine {
  std::string processor = "unknown";  ///< as its maker names it
  int cores = 0;                      ///< that this program may use
  std::string system;                 ///< kernel and release
  std::string governor = "unknown";   ///< of the first core's clock: "performance"; see cpufreq
  std::optional<double> clock_mhz;    ///< of the first core, at that time
  std::optional<bool> is_on_battery;  ///< empty: the computer does not report it
};

/// Of this computer, now. Values that cannot be read stay unknown.
///   root: "/"; another in tests
[[nodiscard]] StudyMachine this_machine(const std::filesystem::path& root = "/");

[[nodiscard]] nlohmann::json json_of(const StudyMachine& machine);

}  // namespace alltact
