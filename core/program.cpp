#include "core/program.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/stat.h>

namespace alltact {
namespace {

/// This library; empty where the loader does not tell.
std::filesystem::path own_file() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<void*>(&program_version), &info) == 0) return {};
  std::error_code failed;
  return std::filesystem::canonical(info.dli_fname, failed);
}

}  // namespace

std::string program_version() {
  return ALLTACT_VERSION;
}

const std::string& program_build() {
  static const std::string build = [] {
    struct stat of {};
    if (stat(own_file().c_str(), &of) != 0) return program_version();
    return fmt::format(
        "{} {} {}.{}", program_version(), of.st_size, of.st_mtim.tv_sec, of.st_mtim.tv_nsec);
  }();
  return build;
}

Result<std::filesystem::path> find_resource(const std::filesystem::path& name) {
  namespace fs = std::filesystem;
  static const fs::path own = own_file().parent_path();
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
