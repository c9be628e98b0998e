// What a picture tells as far as the finger is known: everything with a calibrated finger, its
// markers and edges before the reference recording, the edges alone of a finger nobody described.
#pragma once

#include "core/sensing/contact/reference_free_contact.h"
#include "core/finger/finger.h"
#include "core/job.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/markers/plain_rows.h"
#include "core/sensing/pipeline.h"

#include <filesystem>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// How surely something presses on the contact face now.
enum class FaceTouch {
  kUnknown = 1,  ///< cannot be told: no face in the picture, no finger, or its first frames
  kFree,
  kTouched,
};

/// One frame, looked at.
struct WatchedFrame {
  FrameResult result;
  /// Dots of a finger without a reference recording that are no markers yet, because the two rows
  /// are not plain.
  std::vector<Dot> dots;
  /// Against the reference; before there is one, against the frames before (ReferenceFreeContactDetector).
  FaceTouch touch = FaceTouch::kUnknown;
  std::optional<Error> problem;  ///< why the frame could not be looked at at all
};

/// Used by one thread.
class FingerWatch {
 public:
  /// Nothing known: edges alone.
  FingerWatch() = default;
  /// `folder`: where the finger's reference recording lies; empty for a finger that is only
  /// described. Errors: those of Pipeline::create.
  static Result<FingerWatch> create(const std::filesystem::path& folder,
                                    const Finger& finger,
                                    const PipelineSettings& settings,
                                    const Job& job);

  /// is_next: the frame follows the last one in time.
  [[nodiscard]] WatchedFrame operator()(const FramePtr& frame, bool is_next);

  [[nodiscard]] const std::optional<Finger>& finger() const { return finger_; }
  [[nodiscard]] bool has_reference() const { return pipeline_.has_value(); }

 private:
  void forget();
  void look_for_markers(WatchedFrame& watched);

  std::optional<Finger> finger_;
  std::optional<Camera> camera_;
  std::optional<Pipeline> pipeline_;
  std::optional<PlainRows> rows_;
  ReferenceFreeContactDetector dents_;
  FaceEdgeFinder edge_finder_;
  PipelineSettings settings_;
};

/// By depth; before calibration by a dark patch against the reference.
[[nodiscard]] FaceTouch face_touch(const FrameResult& result);

}  // namespace alltact
