// A recording measured on all cores, the same whatever their number.
//
// The frames are cut into pieces of kPieceFrames at places that depend on nothing but their
// numbers. Each piece is measured by itself, after a look at where the markers are in the
// kWarmUpFrames before it, which is all that the frames before have to tell: the markers are
// followed from frame to frame, and a camera that stands still shows by two pictures that are the
// same. What lasts longer, the contact, is told afterwards, in the frames' order (contact_lines.h).
#pragma once

#include "core/batch/contact_lines.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/pipeline.h"
#include "core/sources/source.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace alltact {

inline constexpr std::size_t kPieceFrames = 32, kWarmUpFrames = 8;

/// A frame of the batch.
struct BatchFrame {
  std::size_t index = 0;         ///< in the recording
  FramePtr frame;                ///< null: it could not be read,
  std::optional<Error> problem;  ///< for this reason; or it cannot be measured
  std::optional<FrameResult> result;
  std::optional<FrameContacts> contacts;
};

struct BatchFrames {
  std::size_t first = 0;  ///< a multiple of kPieceFrames
  std::size_t end = std::numeric_limits<std::size_t>::max();
};

struct BatchWork {
  /// Of a frame as it is read, in the order of their numbers, one at a time: may set its problem,
  /// and then it is not measured. May be empty.
  std::function<void(BatchFrame&)> look;
  /// Writes what one frame is to leave behind, and says what is to be kept of it. Several threads
  /// at once, in any order. Error: nothing more can be written, the batch ends.
  std::function<Result<FrameLine>(BatchFrame&, const Pipeline&)> write;
  /// In the order of their numbers, one at a time. Error: as above.
  std::function<Status(std::size_t index, FrameLine&&)> take;
};

/// Measures the frames with one thread for each pipeline; with one, on the caller's own. Holds no
/// more than about four pieces of pictures and one finished piece a thread. Where a pipeline
/// remembers_long(), only the first is used, frame after frame.
/// Error: that of `write` or `take`; what was taken before stays. When the job is stopped, what was
/// measured up to a piece's end is taken.
[[nodiscard]] Status measure_batch(Source& source,
                                   std::vector<Pipeline>& pipelines,
                                   const BatchFrames& frames,
                                   const BatchWork& work,
                                   const Job& job);

}  // namespace alltact
