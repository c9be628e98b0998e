// Caches on disk for results that take long to compute.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace alltact {

/// alltact/KIND below $XDG_CACHE_HOME, or below .cache of $HOME; nullopt: neither is an absolute
/// path, and nothing is cached.
[[nodiscard]] std::optional<std::filesystem::path> cache_folder(std::string_view kind);

/// Removes all entries of a cache but the `most` newest ones. Hidden entries, which are incomplete,
/// are removed after a day without a write. Entries that cannot be removed stay.
void remove_oldest(const std::filesystem::path& cache, std::size_t max_entries);

/// Checksum of the program or library that holds a function; empty where it cannot be read. It
/// identifies the code that made a cached result: a version does not change with every line of
/// code.
[[nodiscard]] std::string checksum_of_code(const void* function);

}  // namespace alltact
