// The work behind Inspection: frames measured and made into surfaces. Of one thread.
#pragma once

#include "calibration/live/live_finger.h"
#include "widgets/inspect/inspected_frame.h"

#include <memory>
#include <optional>

namespace alltact {

/// What is wished for.
struct InspectWish {
  std::filesystem::path finger;
  std::filesystem::path input;
  OtherMethod other = OtherMethod::kNone;
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

 private:
  Result<MeasuredFrame> measured(const InspectWish& wish,
                                 const Job& job,
                                 std::optional<RecordingInfo>& recording);
  std::shared_ptr<const InspectedFrame> with_surfaces(MeasuredFrame measured);

  FrameMeasurer measurer_;
  std::filesystem::path grid_of_;  // a finger's folder
  cv::Size grid_;                  // the same for all its frames
};

}  // namespace alltact
