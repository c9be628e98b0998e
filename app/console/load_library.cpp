#include "app/console/load_library.h"

#include <filesystem>

#include <dlfcn.h>

namespace alltact {

Loaded load_function(const std::string& name, const char* function) {
  namespace fs = std::filesystem;
  std::error_code failed;
  const fs::path folder = fs::read_symlink("/proc/self/exe", failed).parent_path();
  const std::string file = "liballtact-" + name + ".so";
  std::string problem;
  for (const fs::path& library : {folder / file, folder / ALLTACT_PARTS / file}) {
    if (!fs::exists(library, failed)) {
      if (problem.empty()) problem = file + " is not there";
      continue;
    }
    if (void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL); handle != nullptr)
      if (void* const found = dlsym(handle, function); found != nullptr) return {found, {}};
    problem = dlerror();
  }
  return {nullptr, problem};
}

}  // namespace alltact
