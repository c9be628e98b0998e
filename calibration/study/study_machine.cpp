#include "calibration/study/study_machine.h"

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>
#include <sys/utsname.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

std::string first_line(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

/// Of "name : value" lines; empty where there is none of the name.
std::string value_of(const fs::path& file, const std::string& name) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind(name, 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
  }
  return {};
}

std::optional<bool> on_battery(const fs::path& supplies) {
  std::error_code failed;
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(supplies, failed))
    folders.push_back(entry.path());
  std::optional<bool> is_on;
  for (const fs::path& supply : folders) {
    const std::string type = first_line(supply / "type");
    if (type == "Mains" || type == "USB") {
      const std::string online = first_line(supply / "online");
      if (online == "1") return false;
      if (online == "0" && !is_on) is_on = true;
    } else if (type == "Battery") {
      const std::string status = first_line(supply / "status");
      if (status == "Discharging") is_on = true;
      if ((status == "Charging" || status == "Full") && !is_on) is_on = false;
    }
  }
  return is_on;
}

}  // namespace

StudyMachine this_machine(const fs::path& root) {
  StudyMachine machine;
  const std::string processor = value_of(root / "proc/cpuinfo", "model name");
  if (!processor.empty()) machine.processor = processor;
  machine.cores = static_cast<int>(std::thread::hardware_concurrency());
  const std::string mhz = value_of(root / "proc/cpuinfo", "cpu MHz");
  if (const double clock = std::strtod(mhz.c_str(), nullptr); clock > 0) machine.clock_mhz = clock;
  utsname system{};
  if (uname(&system) == 0)
    machine.system = std::string(system.sysname) + ' ' + system.release + ' ' + system.machine;
  const std::string governor =
      first_line(root / "sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  if (!governor.empty()) machine.governor = governor;
  machine.is_on_battery = on_battery(root / "sys/class/power_supply");
  return machine;
}

nlohmann::json json_of(const StudyMachine& machine) {
  nlohmann::json json{{"processor", machine.processor},
                      {"cores", machine.cores},
                      {"system", machine.system},
                      {"power", {{"governor", machine.governor}}}};
  if (machine.clock_mhz) json["power"]["clock_mhz"] = *machine.clock_mhz;
  if (machine.is_on_battery)
    json["power"]["on_battery"] = *machine.is_on_battery;
  else
    json["power"]["on_battery"] = nullptr;
  return json;
}

double thread_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace alltact
