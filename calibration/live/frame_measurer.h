// Frames of a recording, in any order, measured for display: with the finger's own settings and the
// uncertainty of each depth, and optionally a second method, setting or frame for comparison.
#pragma once

#include "calibration/presses/press.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"
#include "core/sensing/pipeline.h"
#include "core/sources/file_source.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <opencv2/core.hpp>

namespace alltact {

/// The second measurement of a comparison.
enum class OtherMethod {
  kNone = 1,
  kPaper,      ///< itself, by the source paper's method
  kSetting,    ///< itself, with one setting of the pipeline set to another value
  kFrame,      ///< another frame of the recording, at the same positions on the face
  kRecording,  ///< a frame of another recording, likewise
  kFinger,     ///< a frame of another finger's recording, measured with that finger, likewise
  kBody,       ///< a nominal body in the pose that fits best (body_comparison.h)
};

[[nodiscard]] constexpr bool is_other_frame(OtherMethod method) {
  return method == OtherMethod::kFrame || method == OtherMethod::kRecording ||
         method == OtherMethod::kFinger;
}
[[nodiscard]] constexpr bool needs_file(OtherMethod method) {
  return method == OtherMethod::kRecording || method == OtherMethod::kFinger ||
         method == OtherMethod::kBody;
}
struct ComparisonSpec {
  OtherMethod method = OtherMethod::kNone;
  std::string setting = {}, value = {};  ///< of pipeline_settings()
  std::size_t frame = 0;                 ///< of another frame: its number
  std::filesystem::path file = {};    ///< kRecording, kFinger: a video or folder; kBody: its mesh
  std::filesystem::path finger = {};  ///< kFinger: the other finger's folder
  bool operator==(const ComparisonSpec&) const = default;
};

/// One frame, measured.
struct MeasuredFrame {
  std::size_t number = 0;  ///< within the recording
  FrameResult result;
  Face face;
  bool is_calibrated = false;  ///< else there is no depth
  std::optional<Camera> camera;
  /// Of the depth (depth_sd_and_limits()); both are empty where there is no depth.
  cv::Mat sd_mm, limits;
  std::optional<Mapping> mapping;  ///< that the depth was read with
  double smoothing_px = 0;         ///< applied before the mapping
  /// The second measurement, where it succeeded.
  std::optional<FrameResult> other;
  Face other_face;  ///< of `other`; that of another finger, or the same
  /// Depth minus that of `other`, mm, CV_32FC1, the image's size; NaN where one of them is missing.
  /// Empty where one has no depth. Another frame is compared at the same position on the face,
  /// which lies in another pixel where the finger has bent since. kBody: signed distance instead
  /// (PosedNominal::distance_mm).
  cv::Mat difference_mm;
  std::optional<double> body_rms_mm;  ///< kBody: distance of the skin that lies on it from the body
  /// Why the requested comparison is impossible.
  std::optional<Error> other_problem;
};

struct RecordingInfo {
  std::filesystem::path input;
  std::size_t count = 0;
  double frames_per_s = 30;
  std::shared_ptr<const FrameTimes> times_ns;  ///< null for single images
};

/// The pipeline that a finger is measured by, live and in recordings; without a reference it
/// measures the finger's shape.
[[nodiscard]] Result<Pipeline> measuring_pipeline(const FingerSnapshot& finger,
                                                  const PipelineSettings& settings, const Job& job);

/// Holds a recording, a finger and one or two pipelines of it. Used by one thread.
class FrameMeasurer {
 public:
  /// A video or a folder of images; does nothing where it is open already. Errors: it does not
  /// exist any more; those of RecordedFrames::open.
  [[nodiscard]] Status open_recording(const std::filesystem::path& input, const Job& job);
  /// Does nothing where the folder's present state is open. Errors: an empty folder; those of
  /// FingerStore::snapshot and Pipeline::create. A finger without a reference is no error. The
  /// previous finger is closed in any case.
  [[nodiscard]] Status load_finger(const std::filesystem::path& folder, const Job& job);

  /// The finger at the time of loading; null: none is open.
  [[nodiscard]] const FingerPtr& finger() const { return finger_; }
  /// Both are open, so that measure() may be called.
  [[nodiscard]] bool is_open() const { return frames_ && first_; }
  /// Requires an open recording.
  [[nodiscard]] RecordingInfo recording() const;

  /// Requires both open. `number`: beyond the recording's end the last frame is used. Errors: the
  /// frame cannot be read, or is not of the finger's size.
  [[nodiscard]] Result<MeasuredFrame> measure(std::size_t number, const ComparisonSpec& other,
                                              const Job& job);

  /// Completes a frame that `finger` has measured live. Another method or setting is measured with
  /// the finger in `folder`, opened for that purpose; with an empty folder, not at all. There is no
  /// other frame. Errors: those of load_finger() and FingerSnapshot::of.
  [[nodiscard]] Result<MeasuredFrame> complete(const FrameResult& live, const Finger& finger,
                                               const std::filesystem::path& folder,
                                               const ComparisonSpec& other, const Job& job);

 private:
  Result<Pipeline> other_pipeline(const ComparisonSpec& other, const Job& job) const;
  Status open_other(const ComparisonSpec& other, const Job& job);
  void compare(MeasuredFrame& frame, const ComparisonSpec& other, bool is_next, const Job& job);
  void compare_with_body(MeasuredFrame& frame, const std::filesystem::path& file, const Job& job);
  Result<FrameResult> measure_other_frame(const ComparisonSpec& other, const Job& job);

  std::filesystem::path folder_, input_;
  std::shared_ptr<FingerStore> store_;
  FingerPtr finger_;
  std::optional<Pipeline> first_, other_;
  ComparisonSpec other_comparison_;  // that other_ measures with
  ComparisonSpec other_frame_of_;    // that other_frame_ belongs to
  std::optional<FrameResult> other_frame_;
  std::filesystem::path other_input_;
  std::optional<RecordedFrames> other_frames_;
  std::optional<KnownBody> body_;
  std::filesystem::path body_file_;
  std::optional<RecordedFrames> frames_;
  std::shared_ptr<const FrameTimes> times_ns_;
  std::optional<std::size_t> last_;
};

}  // namespace alltact
