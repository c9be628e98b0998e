// What the operating system says, in words a technician can act on.
#pragma once

#include "core/result.h"

#include <filesystem>

namespace alltact {

/// `doing`: what was tried ("could not write the file"); error_number: errno of the call that
/// failed. The error's `where` is the path, its advice what helps against that kind of failure.
[[nodiscard]] Error system_error(const Message& doing,
                                 const std::filesystem::path& path,
                                 int error_number);

/// What an errno means for one kind of thing, and what helps. An empty reason: as the system says.
struct FailureWords {
  Message reason, advice;
};

/// The error that tells of it: "doing: reason".
[[nodiscard]] Error told(const Message& doing,
                         Where where,
                         const FailureWords& words,
                         int error_number);

}  // namespace alltact
