// What all programs of the project know of themselves.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <string>

namespace alltact {

/// "0.1.0"
[[nodiscard]] std::string program_version();

/// The program or library that a function was loaded from; empty where the loader does not tell.
[[nodiscard]] std::filesystem::path file_with(const void* function);

/// A file of the resources, "scenes/NAME.yaml", in share/alltact beside the folder that this
/// library was loaded from, so that an installed tree may be moved; in a build's tree that is a
/// link to the sources. Error: it is not there.
[[nodiscard]] Result<std::filesystem::path> find_resource(const std::filesystem::path& name);

}  // namespace alltact
