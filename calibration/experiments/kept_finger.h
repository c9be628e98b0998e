// Simulated fingers that were recorded and calibrated before, kept so that the next run of an
// experiment takes seconds.
//
// A folder of the cache holds one finger, whole or not at all: it is filled beside its place and
// renamed into it. Its name says everything that the finger was made by, so that another program,
// another scene, another seed looks for another folder. The checksum of every file stands in it;
// what is damaged is not taken, and replaced by the next that is kept. Any number of programs may
// take and keep at once.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// The name for a finger made by this program (its version and its very bytes) from these words, in
/// this order.
[[nodiscard]] std::string kept_finger_name(const std::vector<std::string_view>& made_by);

/// Copies a kept finger to `to`, which must not be there, and tells what `note` was when it was
/// kept. nullopt: there is none, or one that is damaged; then there is nothing at `to` either.
[[nodiscard]] std::optional<std::string> take_kept_finger(const std::filesystem::path& cache,
                                                          const std::string& name,
                                                          const std::filesystem::path& to);

/// Keeps the files of a finger's folder. The eight that were kept last stay. Errors: the cache
/// cannot be made or written.
[[nodiscard]] Status keep_finger(const std::filesystem::path& cache,
                                 const std::string& name,
                                 const std::filesystem::path& finger_folder,
                                 const std::string& note);

}  // namespace alltact
