// Which frame of a second recording belongs to a frame of the first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace alltact {

/// Times of capture of a recording's frames, ns; empty where it has none (pictures).
using FrameTimes = std::vector<std::int64_t>;

enum class JoinedBy {
  kTime = 1,   ///< both clocks are one: recorded at the same time
  kBeginning,  ///< recorded one after the other: their beginnings count as one moment
  kNumber,     ///< one of them has no times
};

struct FrameBeside {
  std::size_t number = 0;
  JoinedBy by = JoinedBy::kNumber;
  double later_ms = 0;  ///< than the first recording's frame; 0 by number
};

/// The frame nearest in time; the last one where the second recording is shorter.
///   number: below the first recording's count; other_count: at least 1
[[nodiscard]] FrameBeside frame_beside(std::size_t number,
                                       const FrameTimes& times_ns,
                                       const FrameTimes& other_times_ns,
                                       std::size_t other_count);

}  // namespace alltact
