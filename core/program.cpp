#include "core/program.h"

namespace alltact {

std::string program_version() {
  return ALLTACT_VERSION;
}

Result<std::filesystem::path> find_resource(const std::filesystem::path& name) {
  namespace fs = std::filesystem;
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  const fs::path installed = program.parent_path() / ".." / "share" / "alltact";
  for (const fs::path& resources : {installed, fs::path(ALLTACT_RESOURCES)}) {
    const fs::path file = resources / name;
    if (fs::exists(file, failed)) return file;
  }
  return Error{en::say("this file that comes with the program is not there"),
               name.string(),
               en::say("installing the program again")};
}

}  // namespace alltact
