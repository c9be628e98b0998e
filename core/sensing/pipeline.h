// Measures one frame: from an image to millimetres.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"
#include "core/sensing/contact/finger_contact.h"
#include "core/sensing/frame_result.h"
#include "core/sensing/pipeline_settings.h"
#include "core/sensing/reference/reference_library.h"

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>

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

/// A method that measures frames, in the order of one source. The program has its own
/// (Pipeline::create), and the source paper's to compare with (paper_method.h).
class MeasuringMethod {
 public:
  virtual ~MeasuringMethod() = default;

  /// All but `contact`. Error: the frame's size is not the finger's. Any other failure is a problem
  /// in the result.
  [[nodiscard]] virtual Result<FrameResult> measure(const FramePtr& frame) = 0;
  virtual void warm_up(const FramePtr& /*frame*/) {}
  [[nodiscard]] virtual bool has_long_memory() const { return true; }
  virtual void forget() = 0;
  [[nodiscard]] virtual bool has_reference() const { return true; }
  /// Only of a known finger.
  [[nodiscard]] virtual const Finger& finger() const = 0;
  [[nodiscard]] virtual const Camera& camera() const = 0;
};

/// Turns frames into results. Built once from what is known of a finger, which decides how far each
/// result reaches:
///   nothing known                    edges
///   a finger                         and shape, markers or dots, evidence; flat sensor: edges
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

  /// Measures by another method than the program's own.
  explicit Pipeline(std::unique_ptr<MeasuringMethod> method, const PipelineSettings& settings = {})
      : method_(std::move(method)), settings_(settings) {}

  /// For a finger before its reference recording; one that it names is not read.
  static Pipeline without_reference(const FingerSnapshot& finger, const PipelineSettings& settings);

  /// For an unknown finger: images of any size.
  static Pipeline without_finger(const PipelineSettings& settings = {});

  /// Error: the frame's size is not the finger's. Any other failure is a problem in the result.
  [[nodiscard]] Result<FrameResult> operator()(const FramePtr& frame) {
    auto result = method_->measure(frame);
    if (result) result->contact = contacts_(result->evidence);
    return result;
  }

  /// Leaves `contact` empty, for a tracker that takes `evidence` once the frames before are known
  /// (batch.h).
  [[nodiscard]] Result<FrameResult> measure_untracked(const FramePtr& frame) {
    return method_->measure(frame);
  }

  /// Updates only the state that the next frame needs: the marker positions and the last frame.
  void warm_up(const FramePtr& frame) { method_->warm_up(frame); }

  /// True when results depend on more than the few frames before: averaged frames, creep in the
  /// force model, or the source paper's method. Such a recording is measured in one piece.
  [[nodiscard]] bool has_long_memory() const { return method_->has_long_memory(); }

  /// Call before a frame that does not follow the last one in time.
  void forget() {
    method_->forget();
    contacts_.forget();
  }

  [[nodiscard]] bool has_reference() const { return method_->has_reference(); }
  /// As it appears in the measured images (finger_store.h). An unknown finger has neither
  /// finger() nor camera().
  [[nodiscard]] const Finger& finger() const { return method_->finger(); }
  [[nodiscard]] const Camera& camera() const { return method_->camera(); }

  [[nodiscard]] const PipelineSettings& settings() const { return settings_; }

 private:
  std::unique_ptr<MeasuringMethod> method_;
  PipelineSettings settings_;
  FingerContactTracker contacts_;
};

}  // namespace alltact
