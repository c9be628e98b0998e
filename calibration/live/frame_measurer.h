// Frames of a recording, in any order, measured as they are shown: with the finger's own settings,
// how sure each depth is, and on wish beside another method, another setting or another frame.
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
#include <string>

#include <opencv2/core.hpp>

namespace alltact {

/// What a frame is compared with.
enum class OtherMethod {
  kNone = 1,
  kPaper,    ///< itself, by the source paper's method
  kSetting,  ///< itself, with one setting of the pipeline set to another value
  kFrame,    ///< another frame of the recording, at the same places of the face
};

struct Comparand {
  OtherMethod method = OtherMethod::kNone;
  std::string setting = {}, value = {};  ///< kSetting: of pipeline_settings()
  std::size_t frame = 0;                 ///< kFrame: its number
  bool operator==(const Comparand&) const = default;
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
  double smoothing_px = 0;         ///< and what came before that
  /// What it is compared with, where that could be measured.
  std::optional<FrameResult> other;
  /// Depth less that of `other`, CV_32FC1, the picture's size; NaN where one of them is missing.
  /// Empty where one of both has no depth. Of another frame at the same place of the face, which
  /// lies in another pixel where the finger has bent since.
  cv::Mat difference_mm;
  /// Why no frame of this finger can be compared so, where that was wished.
  std::optional<Error> other_problem;
};

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
  /// FingerStore::snapshot and Pipeline::create. A finger without a reference is no error: its
  /// shape is measured. What was open before is closed in any case.
  [[nodiscard]] Status load_finger(const std::filesystem::path& folder, const Job& job);

  /// As it was loaded; null: none is.
  [[nodiscard]] const FingerPtr& finger() const { return finger_; }
  /// Both are open, so that measure() may be called.
  [[nodiscard]] bool is_open() const { return frames_ && first_; }
  /// With a recording open.
  [[nodiscard]] RecordingInfo recording() const;

  /// With both open. `number`: beyond the recording's end the last frame is taken. Errors: the
  /// frame cannot be read, or is not of the finger's size.
  [[nodiscard]] Result<MeasuredFrame> measure(std::size_t number,
                                              const Comparand& other,
                                              const Job& job);

  /// A frame that `finger` has measured live. Another method or setting measures it with the finger
  /// in `folder`, opened for that; where that is empty, not at all. There is no other frame.
  /// Errors: those of load_finger() and FingerSnapshot::of.
  [[nodiscard]] Result<MeasuredFrame> complete(const FrameResult& live,
                                               const Finger& finger,
                                               const std::filesystem::path& folder,
                                               const Comparand& other,
                                               const Job& job);

 private:
  Status open_other(const Comparand& other, const Job& job);
  void compare(MeasuredFrame& frame, const Comparand& other, bool is_next, const Job& job);
  Result<FrameResult> measure_other_frame(std::size_t number);

  std::filesystem::path folder_, input_;
  std::shared_ptr<FingerStore> store_;
  FingerPtr finger_;
  std::optional<Pipeline> first_, other_;
  Comparand other_is_;  // that other_ measures with
  struct OtherFrame {
    std::size_t number;
    FrameResult result;
  };
  std::optional<OtherFrame> other_frame_;
  std::optional<RecordedFrames> frames_;
  std::shared_ptr<const FrameTimes> times_ns_;
  std::optional<std::size_t> last_;
};

}  // namespace alltact
