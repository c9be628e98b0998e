// What can be made again, and is kept because making it takes long.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace alltact {

/// alltact/KIND below $XDG_CACHE_HOME, or below .cache of $HOME; nullopt: neither is told as an
/// absolute path, and nothing is to be kept.
[[nodiscard]] std::optional<std::filesystem::path> cache_folder(std::string_view kind);

/// Removes all entries of a cache but the `most` that were written last; hidden ones, which are not
/// finished, when nobody has written to them for a day. What cannot be removed stays.
void remove_oldest(const std::filesystem::path& cache, std::size_t most);

/// Of the bytes of the program or library that a function was loaded from; empty where those cannot
/// be read. To name what is kept by the code that made it: a version does not change with every
/// line of code.
[[nodiscard]] std::string checksum_of_code(const void* function);

}  // namespace alltact
