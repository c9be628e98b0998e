// Files that were removed while they are open.
#pragma once

#include "core/result.h"

#include <filesystem>

namespace alltact {

/// True when no folder holds the open file any more.
[[nodiscard]] bool is_removed(int descriptor);

/// Copies what a removed file holds to where it was, making its folder anew. Error: it cannot be
/// read or written there, or there is another file by now.
[[nodiscard]] Status put_back(int descriptor, const std::filesystem::path& file);

}  // namespace alltact
