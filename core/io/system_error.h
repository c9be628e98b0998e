// Errors of the operating system, in words a technician can act on.
#pragma once

#include "core/result.h"

#include <filesystem>

namespace alltact {

/// `doing`: the attempt ("could not write the file"); error_number: errno of the failed call. The
/// error's `where` is the path, its advice a remedy for that kind of failure.
[[nodiscard]] Error system_error(const Message& doing,
                                 const std::filesystem::path& path,
                                 int error_number);

/// Reason and remedy for an errno. An empty reason: the system's own text.
struct FailureWords {
  Message reason, advice;
};

/// The error "doing: reason".
[[nodiscard]] Error errno_error(const Message& doing,
                                Where where,
                                const FailureWords& words,
                                int error_number);

}  // namespace alltact
