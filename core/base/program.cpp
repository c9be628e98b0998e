#include "core/base/program.h"

#include <dlfcn.h>

namespace alltact {

std::string program_version() { return ALLTACT_VERSION; }

std::filesystem::path binary_of(const void* function) {
  Dl_info info{};
  if (dladdr(function, &info) == 0 || info.dli_fname == nullptr) return {};
  std::error_code failed;
  return std::filesystem::canonical(info.dli_fname, failed);
}

Result<std::filesystem::path> find_resource(const std::filesystem::path& name) {
  namespace fs = std::filesystem;
  static const fs::path own =
      binary_of(reinterpret_cast<const void*>(&program_version)).parent_path();
  std::error_code failed;
  // In lib or in a build tree, or in lib/ARCHITECTURE.
  for (const char* up : {"..", "../.."}) {
    if (own.empty()) break;
    const fs::path file = (own / up / "share/alltact" / name).lexically_normal();
    if (fs::exists(file, failed)) return file;
  }
  return Error{en::say("this file of the program is missing"), name.string(),
               en::say("installing the program again")};
}

}  // namespace alltact
