// Work on many alike, cut into parts for several threads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <exception>
#include <thread>
#include <vector>

namespace alltact {

/// Threads for what is done before anything live is measured beside it.
[[nodiscard]] inline int all_cores() {
  return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 8U));
}

/// Calls work(first, last) for all of [0, count), cut into as many parts as there are `threads` (at
/// least 1), the first in this thread. What the parts write must not depend on where the cuts are.
/// What a part throws is thrown here, when all have ended.
template <class Work>
void over_parts(int count, int threads, const Work& work) {
  const int parts = std::clamp(threads, 1, std::max(1, count));
  const auto begin_of = [&](int part) {
    return static_cast<int>(std::int64_t{count} * part / parts);
  };
  std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(parts));
  const auto run = [&](int part) noexcept {
    try {
      work(begin_of(part), begin_of(part + 1));
    } catch (...) {
      thrown[static_cast<std::size_t>(part)] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int part = 1; part < parts; ++part) helpers.emplace_back([&, part] { run(part); });
    run(0);
  }
  for (const std::exception_ptr& one : thrown)
    if (one) std::rethrow_exception(one);
}

}  // namespace alltact
