// Parallel loops, cut into chunks for several threads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <exception>
#include <thread>
#include <vector>

namespace alltact {

/// Threads for work that runs before live measuring starts: the processor's, 1 to 8.
[[nodiscard]] inline int default_threads() {
  return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 8U));
}

/// Calls work(first, last) for all of [0, count), cut into `threads` chunks (at least 1), the first
/// in this thread. The results must not depend on the cuts. An exception of a chunk is rethrown
/// here after all have ended.
template <class Work>
void parallel_for(int count, int threads, const Work& work) {
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
