// What all programs of the project know of themselves.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <string>

namespace alltact {

/// "0.1.0"
[[nodiscard]] std::string program_version();

/// A file of the resources, "scenes/NAME.yaml": beside the program once installed, in the source
/// tree while developing. Error: it is in neither.
[[nodiscard]] Result<std::filesystem::path> find_resource(const std::filesystem::path& name);

}  // namespace alltact
