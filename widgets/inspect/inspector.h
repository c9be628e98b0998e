// The work behind Inspection: frames measured and made into surfaces. Of one thread.
#pragma once

#include "calibration/live/live_finger.h"
#include "widgets/inspect/frame_summary.h"
#include "widgets/inspect/inspected_frame.h"

#include <memory>
#include <optional>
#include <vector>

namespace alltact {

/// What is wished for.
struct InspectWish {
  std::filesystem::path finger;
  std::filesystem::path input;
  Comparand other;
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
  /// Opens and loads what has changed since the last wish.
  [[nodiscard]] InspectAnswer operator()(const InspectWish& wish, const Job& job);

  /// Measures the next frame of the recording that has no summary yet, as the last wish had it;
  /// false: there is none, or nothing to measure it with.
  [[nodiscard]] bool look_further(const Job& job);
  /// Those that came since the last call, also of frames that were wished for.
  struct News {
    bool is_from_scratch = false;  ///< those before are of another recording, or another finger
    std::vector<FrameSummary> summaries;
  };
  [[nodiscard]] News news();

 private:
  void note(const MeasuredFrame& frame);
  Result<MeasuredFrame> measured(const InspectWish& wish,
                                 const Job& job,
                                 std::optional<RecordingInfo>& recording);
  std::shared_ptr<const InspectedFrame> with_surfaces(MeasuredFrame measured);

  FrameMeasurer measurer_;
  std::filesystem::path grid_of_;  // a finger's folder
  cv::Size grid_;                  // the same for all its frames
  // Which frames have a summary, and of what.
  std::vector<char> has_summary_;
  std::size_t next_ = 0;  // all before have one
  std::filesystem::path summaries_of_;
  std::shared_ptr<const FingerSnapshot> summaries_by_;
  News news_;
};

}  // namespace alltact
