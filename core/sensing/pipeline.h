// Measures one frame: from an image to millimetres.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"
#include "core/sensing/contact/finger_contact.h"
#include "core/sensing/force/force_meter.h"
#include "core/sensing/frame_result.h"
#include "core/sensing/markers/marker_tracker.h"
#include "core/sensing/paper_method.h"
#include "core/sensing/pipeline_settings.h"
#include "core/sensing/reference/reference_library.h"

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Mean of the last frames of a source, for a finger that holds still. The time of a call does not
/// depend on the number of frames.
class RunningMean {
 public:
  /// Averages the last `max_frames` frames, 1 (no averaging) to 256.
  explicit RunningMean(int max_frames) : max_frames_(static_cast<std::size_t>(max_frames)) {}

  /// Returns the rounded mean of `grey` and the frames before it. `grey`: CV_8UC1, not written to
  /// from now on. Frames of another size are dropped.
  [[nodiscard]] cv::Mat operator()(const cv::Mat& grey);

  /// Drops all frames: the next one is the first.
  void forget() { last_.clear(); }

 private:
  std::size_t max_frames_;
  std::deque<cv::Mat> last_;
  cv::Mat sum_;  // of last_, CV_16UC1
};

/// Turns frames into results. Built once from what is known of a finger, which decides how far each
/// result reaches:
///   nothing known                    edges
///   a finger                         and shape, markers or dots, touch; of a flat sensor edges
///   and its reference recording      all but depth and regions
///   and its mapping                  all
/// A force is estimated where the finger also has a force model that was trained with the markers
/// of this reference. Its contact position is that of the largest region. Without a reference the
/// full image is not checked (frame_result.h).
///
/// State between frames of one continuous source: the last images where they are averaged
/// (PipelineSettings::average_frames), the marker positions, the last frame, the creep of the
/// markers and the tracked contact. Before there is a reference also the brightness of the skin.
/// Everything else depends on the frame only. A new frame of the source (is_same_frame in
/// frame_result.h) that equals the last one to the grey level is reported as that of a frozen
/// camera.
class Pipeline {
 public:
  /// Reads the finger's reference recording. A finger without a mapping is measured up to
  /// `difference`. Errors: those of ReferenceLibrary::load, and of DotNetwork::load where a network
  /// finds the markers.
  static Result<Pipeline> create(const FingerSnapshot& finger, const PipelineSettings& settings,
                                 const Job& job);

  /// Uses a library that is already in memory (ReferenceLibrary::load of finger_as_measured()). A
  /// marker network that cannot be used is a problem of every frame.
  static Pipeline with_library(ReferenceLibrary library, const FingerSnapshot& finger,
                               const PipelineSettings& settings);

  /// Measures by the source paper's method instead of the program's own.
  static Pipeline with_paper_method(PaperMethod method);

  /// For a finger before its reference recording; one that it names is not read.
  static Pipeline without_reference(const FingerSnapshot& finger, const PipelineSettings& settings);

  /// For an unknown finger: images of any size.
  static Pipeline without_finger(const PipelineSettings& settings = {});

  /// Error: the frame's size is not the finger's. Any other failure is a problem in the result.
  [[nodiscard]] Result<FrameResult> operator()(const FramePtr& frame);

  /// Measures a frame without tracking: `contact` stays empty. `contacts` receives the input of the
  /// tracker for when the frames before are known (batch.h); nullopt where there is none.
  [[nodiscard]] Result<FrameResult> measure_untracked(const FramePtr& frame,
                                                      std::optional<FrameContacts>& contacts);

  /// Updates only the state that the next frame needs: the marker positions and the last frame.
  void warm_up(const FramePtr& frame);

  /// True when results depend on more than the few frames before: averaged frames, creep in the
  /// force model, or the source paper's method. Such a recording is measured in one piece.
  [[nodiscard]] bool has_long_memory() const;

  /// Call before a frame that does not follow the last one in time.
  void forget();

  [[nodiscard]] bool has_reference() const { return library_ || paper_; }
  /// As it appears in the measured images (finger_store.h). An unknown finger has neither
  /// finger() nor camera().
  [[nodiscard]] const Finger& finger() const { return *finger_; }
  [[nodiscard]] const Camera& camera() const { return *camera_; }
  [[nodiscard]] const PipelineSettings& settings() const { return settings_; }

 private:
  explicit Pipeline(const PipelineSettings& settings);
  [[nodiscard]] Result<FrameResult> measure(const FramePtr& frame,
                                            std::optional<FrameContacts>* contacts);
  // The steps in their order.
  [[nodiscard]] Result<cv::Mat> oriented(const Frame& frame) const;
  void check_frame(FrameResult& result);
  void find_shape(FrameResult& result, StopWatch& watch) const;
  void find_without_reference(FrameResult& result, StopWatch& watch);
  bool find_markers(FrameResult& result);
  void find_markers_by_shape(FrameResult& result) const;
  void find_reference(FrameResult& result, StopWatch& watch);
  void find_depth(FrameResult& result, StopWatch& watch) const;
  void find_contact(FrameResult& result, StopWatch& watch) const;
  [[nodiscard]] Eigen::MatrixXd markers_covariance(const FrameResult& result) const;
  void track_contact(FrameResult& result, std::optional<FrameContacts>* contacts, StopWatch& watch);
  void find_force(FrameResult& result, StopWatch& watch);

  std::optional<PaperMethod> paper_;  // replaces all that follows except finger and camera
  PipelineSettings settings_;
  FaceEdgeFinder edge_finder_;
  std::optional<Finger> finger_;
  std::optional<Camera> camera_;            // with the finger
  std::optional<FingerSnapshot> snapshot_;  // the same, for converting frames
  RunningMean mean_;
  // Before there is a reference.
  std::optional<EvenRows> rows_;
  ReferenceFreeContactDetector contact_;
  // With the reference.
  std::optional<ReferenceLibrary> library_;
  std::optional<Mapping> mapping_;
  std::optional<FaceShape> plane_;         // known beforehand, of flat sensors
  std::unique_ptr<MarkerFinder> markers_;  // fingers with markers,
  std::optional<Error> marker_problem_;    // or why they cannot be found
  std::optional<ForceMeter> force_;        // fingers with a force model,
  std::optional<Error> force_problem_;     // or why it cannot be used
  FramePtr last_;                          // of a continuous source
  // Covariance of the markers' displacements, in a frame with a push
  Eigen::MatrixXd displacement_cov_px2_;
  FingerContactTracker contact_tracker_;
};

}  // namespace alltact
