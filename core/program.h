// What all programs of the project know of themselves.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <string>

namespace alltact {

/// "0.1.0"
[[nodiscard]] std::string program_version();

/// Of the bytes of the file that a function was loaded from; empty where that cannot be read. A
/// version alone does not change with every line of code: for what is kept from one run to the next
/// and must have been made by the same code.
[[nodiscard]] std::string checksum_of_code(const void* function);

/// A file of the resources, "scenes/NAME.yaml", in share/alltact beside the folder that this
/// library was loaded from, so that an installed tree may be moved; in a build's tree that is a
/// link to the sources. Error: it is not there.
[[nodiscard]] Result<std::filesystem::path> find_resource(const std::filesystem::path& name);

}  // namespace alltact
