// Cache of simulated fingers, recorded and calibrated, so that the next run of an experiment takes
// seconds.
//
// A folder of the cache holds one complete finger: it is filled in an adjacent folder and renamed.
// Its name encodes everything that the finger depends on, so that another program, scene or seed
// uses another folder. The folder holds a checksum of every file. A damaged finger is not loaded,
// and is replaced by the next one. Any number of programs may use the cache at once.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// The name for a finger made by this program (its version and its code bytes) from these texts, in
/// this order.
[[nodiscard]] std::string cached_finger_name(const std::vector<std::string_view>& made_by);

/// Copies a cached finger to `to`, which must not exist, and returns the `note` stored with it.
/// nullopt: there is none, or it is damaged; then nothing exists at `to` either.
[[nodiscard]] std::optional<std::string> load_cached_finger(const std::filesystem::path& cache,
                                                            const std::string& name,
                                                            const std::filesystem::path& to);

/// Caches the files of a finger's folder. The eight newest fingers are retained. Errors: the cache
/// cannot be made or written.
[[nodiscard]] Status cache_finger(const std::filesystem::path& cache,
                                  const std::string& name,
                                  const std::filesystem::path& finger_folder,
                                  const std::string& note);

}  // namespace alltact
