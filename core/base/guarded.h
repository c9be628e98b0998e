// Work whose exceptions become errors.
#pragma once

#include "core/base/result.h"

#include <functional>
#include <type_traits>

namespace alltact {

// Errors that nobody waits for, as those of a thread of its own.

/// Any thread. Goes to the receiver; without one, as one line to the standard error stream.
void report_unexpected(const Error& error);
/// Called on the reporting thread, one report at a time; must not report itself.
void set_unexpected_receiver(std::function<void(const Error&)> receiver);

/// The error for the exception that is being handled. Only within `catch`.
[[nodiscard]] Error caught_error();

/// Calls `work`, which returns a Result or nothing. What it throws becomes an error: on a thread of
/// its own an exception would end the program. Every thread calls its work through it.
template <class Work>
[[nodiscard]] auto guarded(const Work& work) {
  using Returned = std::invoke_result_t<const Work&>;
  using Outcome = std::conditional_t<std::is_void_v<Returned>, Status, Returned>;
  try {
    if constexpr (!std::is_void_v<Returned>) return Outcome(work());
    if constexpr (std::is_void_v<Returned>) work();
  } catch (...) {
    return Outcome(caught_error());
  }
  if constexpr (std::is_void_v<Returned>) return Outcome();
}

}  // namespace alltact
