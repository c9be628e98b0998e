// Matches frames of two recordings by time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace alltact {

/// Times of capture of a recording's frames, ns; empty where it has none (images).
using FrameTimes = std::vector<std::int64_t>;

enum class MatchedBy {
  kTime = 1,   ///< one common clock: recorded at the same time
  kBeginning,  ///< recorded one after the other: their beginnings are aligned
  kNumber,     ///< one of them has no times
};

struct MatchedFrame {
  std::size_t number = 0;
  MatchedBy by = MatchedBy::kNumber;
  double later_ms = 0;  ///< relative to the first recording's frame; 0 for kNumber
};

/// The frame of the second recording that is nearest in time; its last one where it is shorter.
///   number: below the first recording's count; other_count: at least 1
[[nodiscard]] MatchedFrame match_frame(std::size_t number,
                                       const FrameTimes& times_ns,
                                       const FrameTimes& other_times_ns,
                                       std::size_t other_count);

}  // namespace alltact
