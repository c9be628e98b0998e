// Frames of a recording, in any order, measured as they are shown: with the finger's own settings,
// how sure each depth is, and on wish a second time by another method.
#pragma once

#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/recording/time_match.h"
#include "core/result.h"
#include "core/sensing/pipeline.h"
#include "core/sources/files/recorded_frames.h"

#include <filesystem>
#include <memory>
#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

/// What a frame is measured with a second time.
enum class OtherMethod { kNone = 1, kPaper };

/// One frame, measured.
struct MeasuredFrame {
  std::size_t number = 0;  ///< within the recording
  FrameResult result;
  Face face;
  bool is_calibrated = false;  ///< else there is no depth
  std::optional<Camera> camera;
  cv::Mat sd_mm;                   ///< of the depth (depth_sd_mm()); empty where there is no depth
  std::optional<Mapping> mapping;  ///< that the depth was read with
  double smoothing_px = 0;         ///< and what came before that
  /// The other method's, where two are compared and it could measure the frame.
  std::optional<FrameResult> other;
  /// Why no frame of this finger can be measured by the other method, where that was wished.
  std::optional<Error> other_problem;
};

/// Depth less the other method's, CV_32FC1, the picture's size; NaN where one of them is missing.
/// Both must have depth.
[[nodiscard]] cv::Mat depth_difference_mm(const MeasuredFrame& frame);

struct RecordingInfo {
  std::filesystem::path input;
  std::size_t count = 0;
  double frames_per_s = 30;
  std::shared_ptr<const FrameTimes> times_ns;  ///< null for pictures
};

/// Holds a recording, a finger and one or two pipelines of it. Used by one thread.
class FrameMeasurer {
 public:
  /// A video or a folder of pictures; does nothing where it is open already. Errors: it is not
  /// there any more; those of RecordedFrames::open.
  [[nodiscard]] Status open_recording(const std::filesystem::path& input, const Job& job);
  /// Does nothing where it is open as it stands there now. Errors: an empty folder; those of
  /// FingerStore::snapshot and Pipeline::create. What was open before is closed in any case.
  [[nodiscard]] Status load_finger(const std::filesystem::path& folder, const Job& job);

  /// With a recording open.
  [[nodiscard]] RecordingInfo recording() const;

  /// With both open. `number`: beyond the recording's end the last frame is taken. Errors: the
  /// frame cannot be read, or is not of the finger's size.
  [[nodiscard]] Result<MeasuredFrame> measure(std::size_t number,
                                              OtherMethod other,
                                              const Job& job);

  /// A frame that `finger` has measured live. The other method measures it with the finger in
  /// `folder`, opened for that; where that is empty, not at all. Errors: those of load_finger() and
  /// FingerSnapshot::of.
  [[nodiscard]] Result<MeasuredFrame> complete(const FrameResult& live,
                                               const Finger& finger,
                                               const std::filesystem::path& folder,
                                               OtherMethod other,
                                               const Job& job);

 private:
  Status open_other(const Job& job);
  void measure_by_other(MeasuredFrame& frame, bool is_next, const Job& job);

  std::filesystem::path folder_, input_;
  std::shared_ptr<FingerStore> store_;
  FingerPtr finger_;
  std::optional<Pipeline> first_, other_;
  std::optional<RecordedFrames> frames_;
  std::shared_ptr<const FrameTimes> times_ns_;
  std::optional<std::size_t> last_;
};

}  // namespace alltact
