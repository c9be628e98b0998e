// Empty folders by name, below one of the program's own that is gone when it ends.
#pragma once

#include "tests/support/temporary_folder.h"

namespace alltact::test {

inline std::filesystem::path scratch_folder(const std::string& name) {
  static const TemporaryFolder all;
  const std::filesystem::path folder = all / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  return folder;
}

}  // namespace alltact::test
