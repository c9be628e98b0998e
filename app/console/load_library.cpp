#include "app/console/load_library.h"

#include <cstdio>
#include <exception>
#include <filesystem>

#include <dlfcn.h>
#include <unistd.h>

namespace alltact {
namespace {

/// Third-party libraries end the program where there is no memory for their start.
[[noreturn]] void end_without_memory() {
  std::fputs("there is not enough memory. Try: close other programs.\n", stderr);
  ::_exit(1);
}

void* load(const std::string& library) {
  const auto before = std::set_terminate(end_without_memory);
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  std::set_terminate(before);
  return handle;
}

}  // namespace

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
    if (void* const handle = load(library); handle != nullptr)
      if (void* const found = dlsym(handle, function); found != nullptr) return {found, {}};
    problem = dlerror();
  }
  return {nullptr, problem};
}

}  // namespace alltact
