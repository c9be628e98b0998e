// Measures a recording on all cores; results do not depend on their number.
//
// The frames are split into pieces of kPieceFrames at positions that depend on frame numbers only.
// Each piece is measured independently, after its pipeline has located the markers in the
// kWarmUpFrames before it. No other state of earlier frames is required: the markers are tracked
// from frame to frame, and a frozen camera shows as two equal images. Contacts, which last longer,
// are tracked afterwards, in the frames' order (FingerContactTracker).
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/sensing/contact/finger_contact.h"
#include "core/sensing/pipeline.h"
#include "core/sources/source.h"

#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// Result of one frame by itself: its line of results.jsonl without a contact, and the evidence of
/// one.
struct FrameLine {
  std::string frame;  ///< its name
  std::string line;
  bool is_measured = false;           ///< it has a depth
  double total_ms = 0;                ///< time to measure it
  std::vector<std::string> warnings;  ///< for progress messages; not stored
  std::string depth_packet;           ///< of the run's depth video (depth_video.h); not stored
  std::optional<ContactEvidence> evidence;

  /// One line of a part's file; from_json() restores it to the bit.
  [[nodiscard]] std::string to_json() const;
  /// Error without `where`: it was not made by to_json().
  [[nodiscard]] static Result<FrameLine> from_json(std::string_view text);
};

/// The frame's line of results.jsonl, with its contact if it has one. Call in the frames' order.
///   contacts: of the frames before
[[nodiscard]] std::string complete_line(const FrameLine& frame, FingerContactTracker& contacts);

inline constexpr std::size_t kPieceFrames = 32, kWarmUpFrames = 8;

/// A frame of the batch.
struct BatchFrame {
  std::size_t index = 0;              ///< in the recording
  FramePtr frame;                     ///< null: it could not be read,
  std::optional<Error> problem;       ///< for this reason; or it cannot be measured
  std::optional<FrameResult> result;  ///< without `contact`
};

struct BatchFrames {
  std::size_t first = 0;  ///< a multiple of kPieceFrames
  std::size_t end = std::numeric_limits<std::size_t>::max();
};

/// Threads of a batch: `requested` or, where that is 0, all cores that this process may use.
[[nodiscard]] int batch_threads(int requested);

/// One pipeline for each thread, which share the large data (ReferenceLibrary::load); a single one
/// where it has long-lasting state. Error: the first one of `make`.
[[nodiscard]] Result<std::vector<Pipeline>> batch_pipelines(
    int threads, const std::function<Result<Pipeline>()>& make);

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
[[nodiscard]] Status measure_batch(Source& source, std::vector<Pipeline>& pipelines,
                                   const BatchFrames& frames, const BatchWork& work,
                                   const Job& job);

// Measures a recording frame by frame on request. Each result equals to the bit that of
// measure_batch() (batch.h) on any number of cores.

class SequentialBatch {
 public:
  /// `is_continuous`: Source::is_continuous().
  SequentialBatch(Pipeline pipeline, bool is_continuous);

  /// The next frame. Error: its size is not the finger's.
  [[nodiscard]] Result<FrameResult> operator()(const FramePtr& frame);
  /// The next frame could not be read.
  void skip();

  [[nodiscard]] const Pipeline& pipeline() const { return pipeline_; }

 private:
  void begin_piece();
  void remember(const FramePtr& frame);

  Pipeline pipeline_;
  bool is_continuous_, is_sequential_;
  FingerContactTracker contacts_;
  std::size_t index_ = 0;
  std::deque<FramePtr> before_;  // null: could not be read
};

}  // namespace alltact
