// Measures a recording on all cores; results do not depend on their number.
//
// The frames are split into pieces of kPieceFrames at positions that depend on frame numbers only.
// Each piece is measured independently, after its pipeline has located the markers in the
// kWarmUpFrames before it. No other state of earlier frames is required: the markers are tracked
// from frame to frame, and a frozen camera shows as two equal images. Contacts, which last longer,
// are determined afterwards, in the frames' order (contact_lines.h).
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
  /// Called for each frame as it is read, in order and one at a time. It may set the frame's
  /// problem, which excludes it from measuring. May be empty.
  std::function<void(BatchFrame&)> inspect;
  /// Writes the outputs of one frame and returns its line. Called by several threads at once, in
  /// any order. Error: nothing more can be written, the batch ends.
  std::function<Result<FrameLine>(BatchFrame&, const Pipeline&)> write;
  /// Takes the lines in the order of their frames, one at a time. Error: as above.
  std::function<Status(std::size_t index, FrameLine&&)> take;
};

/// Measures the frames with one thread per pipeline; with one pipeline, on the caller's thread.
/// Memory is limited to about four pieces of images and one finished piece per thread. Where a
/// pipeline has long-lasting state, only the first is used, frame by frame.
/// Error: that of `write` or `take`; lines taken before remain. When the job is stopped, lines up
/// to the end of a measured piece are taken.
[[nodiscard]] Status measure_batch(Source& source,
                                   std::vector<Pipeline>& pipelines,
                                   const BatchFrames& frames,
                                   const BatchWork& work,
                                   const Job& job);

}  // namespace alltact
