// Files as a shell is told of them.
#pragma once

#include <filesystem>
#include <string>

namespace alltact::test {

inline const std::filesystem::path kTop = ALLTACT_SOURCE_DIR;

/// Of a name without quotes in it.
inline std::string quoted(const std::filesystem::path& file) { return "'" + file.string() + "'"; }

}  // namespace alltact::test
