#include "core/program.h"

#include <dlfcn.h>

namespace alltact {
namespace {

/// Where this library lies; empty where the loader does not tell.
std::filesystem::path own_folder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<void*>(&program_version), &info) == 0) return {};
  std::error_code failed;
  return std::filesystem::canonical(info.dli_fname, failed).parent_path();
}

}  // namespace

std::string program_version() {
  return ALLTACT_VERSION;
}

Result<std::filesystem::path> find_resource(const std::filesystem::path& name) {
  namespace fs = std::filesystem;
  static const fs::path own = own_folder();
  std::error_code failed;
  // In lib or in the build's tree, or in lib/ARCHITECTURE.
  for (const char* up : {"..", "../.."}) {
    if (own.empty()) break;
    const fs::path file = (own / up / "share/alltact" / name).lexically_normal();
    if (fs::exists(file, failed)) return file;
  }
  return Error{en::say("this file that comes with the program is not there"),
               name.string(),
               en::say("installing the program again")};
}

}  // namespace alltact
