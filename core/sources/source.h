// Where frames come from: cameras, videos, pictures and simulated fingers, all alike.
#pragma once

#include "core/frame.h"
#include "core/job.h"
#include "core/result.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace alltact {

/// Gives frames one after the other.
class Source {
 public:
  virtual ~Source() = default;

  /// The next frame; nullptr after the last one; an error names the picture that could not be
  /// read. After an error the next call goes on with the picture behind it, where there is one.
  [[nodiscard]] virtual Result<FramePtr> next() = 0;

  /// How many frames there will be, where that is known.
  [[nodiscard]] virtual std::optional<std::size_t> count() const = 0;

  /// True when frames follow each other in time, so that what was seen in one helps in the next.
  [[nodiscard]] virtual bool is_continuous() const = 0;

  /// True when frames come when they come, not when they are asked for: whoever is too slow misses
  /// them.
  [[nodiscard]] virtual bool is_live() const { return false; }

  /// About how often frames come or came.
  [[nodiscard]] virtual double frames_per_s() const { return 30.0; }

  /// Passes over frames without giving them, as far as there are so many.
  virtual void skip(std::size_t count) {
    for (; count > 0; --count)
      if (const auto frame = next(); frame && !*frame) return;
  }
};

enum class Pace {
  kAsked = 1,  ///< as fast as they are asked for
  kRecorded,   ///< as they were recorded, or as a camera gives them
};

struct SourceOptions {
  Pace pace = Pace::kAsked;
  std::uint64_t seed = 1;  ///< of a simulated finger
  int threads = 1;         ///< that render it; the pictures are the same for any number
  /// Told of long opening (mending a recording); ends waits at the recorded pace. May be null; else
  /// it outlives the source.
  const Job* job = nullptr;
};

}  // namespace alltact
