// Sources of frames: cameras, videos, images and simulated fingers.
#pragma once

#include "core/frame.h"
#include "core/job.h"
#include "core/result.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace alltact {

/// Returns frames one after the other.
class Source {
 public:
  virtual ~Source() = default;

  /// The next frame; nullptr after the last one. An error names the image that could not be read;
  /// the next call continues with the following image, where there is one.
  [[nodiscard]] virtual Result<FramePtr> next() = 0;

  /// Number of frames, where it is known.
  [[nodiscard]] virtual std::optional<std::size_t> count() const = 0;

  /// True when frames follow each other in time, so that a tracker may use the frame before.
  [[nodiscard]] virtual bool is_continuous() const = 0;

  /// True when frames come at their own times: a slow reader misses some.
  [[nodiscard]] virtual bool is_live() const { return false; }

  /// Approximate rate of the frames, 1/s.
  [[nodiscard]] virtual double frames_per_s() const { return 30.0; }

  /// Skips frames, no more than there are.
  virtual void skip(std::size_t count) {
    for (; count > 0; --count)
      if (const auto frame = next(); frame && !*frame) return;
  }
};

enum class Pace {
  kOnDemand = 1,  ///< as fast as they are requested
  kRecorded,      ///< at the recorded pace, or at a camera's
};

struct SourceOptions {
  Pace pace = Pace::kOnDemand;
  std::uint64_t seed = 1;  ///< seed of a simulated finger
  int threads = 1;         ///< rendering threads; the images are the same for any number
  /// Receives the progress of long opening (repair of a recording); stopping it ends waits at the
  /// recorded pace. May be null; else it outlives the source.
  const Job* job = nullptr;
};

}  // namespace alltact
