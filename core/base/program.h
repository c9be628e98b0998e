// Version, location and resources of the program.
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>

namespace alltact {

/// "0.1.0"
[[nodiscard]] std::string program_version();

/// The program or library that holds a function; empty where the loader does not know.
[[nodiscard]] std::filesystem::path binary_of(const void* function);

/// Finds a resource, "scenes/NAME.yaml", in share/alltact next to this library's folder, so that an
/// installed tree may be moved. In a build tree share/alltact is a link to the sources. Error: it
/// is not there.
[[nodiscard]] Result<std::filesystem::path> find_resource(const std::filesystem::path& name);

}  // namespace alltact
