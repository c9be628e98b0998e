// The worker of Inspection: measures frames and builds surfaces. Used by one thread.
#pragma once

#include "calibration/live/live_finger.h"
#include "widgets/inspect/frame_summary.h"
#include "widgets/inspect/inspected_frame.h"

#include <memory>
#include <optional>
#include <vector>

namespace alltact {

/// A frame to be measured.
struct InspectRequest {
  std::filesystem::path finger;
  std::filesystem::path input;
  ComparisonSpec other;
  std::size_t number = 0;
  std::shared_ptr<const LiveView> live;  ///< instead of the recording's frame
  std::optional<Finger> live_finger;
};

struct InspectAnswer {
  std::shared_ptr<const InspectedFrame> frame;
  std::optional<RecordingInfo> recording;
  std::optional<Error> problem;
};

class Inspector {
 public:
  /// Opens and loads what has changed since the last request.
  [[nodiscard]] InspectAnswer operator()(const InspectRequest& request, const Job& job);

  /// Measures the next frame of the recording without a summary, with the settings of the last
  /// request. Returns false when there is none, or no finger to measure it with.
  [[nodiscard]] bool scan_next(const Job& job);
  /// Summaries since the last call, including those of requested frames.
  struct SummaryUpdate {
    bool is_from_scratch = false;  ///< earlier summaries are of another recording or finger
    std::vector<FrameSummary> summaries;
  };
  [[nodiscard]] SummaryUpdate update();

 private:
  void note(const MeasuredFrame& frame);
  Result<MeasuredFrame> measured(const InspectRequest& request,
                                 const Job& job,
                                 std::optional<RecordingInfo>& recording);
  std::shared_ptr<const InspectedFrame> with_surfaces(MeasuredFrame measured);

  FrameMeasurer measurer_;
  std::filesystem::path grid_of_;  // a finger's folder
  cv::Size grid_;                  // the same for all its frames
  // Frames with a summary, and the recording and finger of these summaries.
  std::vector<char> has_summary_;
  std::size_t next_ = 0;  // all frames before it have one
  std::filesystem::path summaries_of_;
  std::shared_ptr<const FingerSnapshot> summaries_by_;
  SummaryUpdate update_;
};

}  // namespace alltact
