// A calibrated flat finger made by the program itself, for tests of what comes after.
#pragma once

#include "tests/support/flat_sensor.h"
#include "tests/support/program.h"

#include <string>
#include <vector>

namespace alltact::test {

/// Pictures of a flat sensor and, below finger/, its folder.
struct FlatFinger {
  TemporaryFolder folder;
  std::vector<std::filesystem::path> presses = write_flat_sensor(folder.path());

  FlatFinger() = default;
  /// A copy in a folder of its own.
  FlatFinger(const FlatFinger& other) : presses(other.presses) {
    std::filesystem::copy(other.folder.path(), folder.path(),
                          std::filesystem::copy_options::recursive |
                              std::filesystem::copy_options::overwrite_existing);
    for (auto& press : presses) press = folder / press.filename().string();
  }
  FlatFinger& operator=(const FlatFinger&) = delete;

  [[nodiscard]] std::string finger() const { return (folder / "finger").string(); }
  [[nodiscard]] std::string file(const std::string& name) const { return (folder / name).string(); }

  [[nodiscard]] ProgramRun make() const {
    return run_alltact(
        {"new", finger(), "--camera", file("camera.yaml"), "--layer-mm", "3", "--kind", "flat"});
  }
  /// Calibrates with these presses, or all four.
  [[nodiscard]] ProgramRun calibrate(const std::vector<std::string>& inputs = {},
                                     const std::string& reference = "ref.png") const {
    std::vector<std::string> arguments = {"calibrate",     finger(),           "--reference",
                                          file(reference), "--ball-radius-mm", "4"};
    if (inputs.empty()) {
      for (const auto& press : presses) arguments.push_back(press.string());
    }
    arguments.insert(arguments.end(), inputs.begin(), inputs.end());
    return run_alltact(arguments);
  }
  [[nodiscard]] ProgramRun reconstruct(const std::vector<std::string>& inputs,
                                       const std::string& output,
                                       const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments = {"reconstruct", finger(), "-o", file(output)};
    arguments.insert(arguments.end(), inputs.begin(), inputs.end());
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_alltact(arguments);
  }
};

/// A Fin Ray finger's folder with nothing but what it was made with.
inline ProgramRun make_fin_ray(const std::string& finger, const std::filesystem::path& camera) {
  return run_alltact({"new", finger, "--camera", camera.string(), "--layer-mm", "1.5", "--width-mm",
                      "24", "--per-row", "6"});
}

}  // namespace alltact::test
