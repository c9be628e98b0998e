// The work behind Inspection: a recording, a finger, one or two pipelines. Of one thread.
#pragma once

#include "core/sources/files/recorded_frames.h"
#include "widgets/inspect/inspection.h"

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
  Status load_finger(const std::filesystem::path& folder, const Job& job);
  Status load_other(const Job& job);
  Status open(const std::filesystem::path& input, const Job& job);
  Result<std::shared_ptr<InspectedFrame>> measure(const InspectWish& wish, const Job& job);
  Result<std::shared_ptr<InspectedFrame>> take_live(const InspectWish& wish, const Job& job);
  void compare(InspectedFrame& frame, bool is_next);
  void finish(InspectedFrame& frame, const std::optional<MappingParameters>& mapping);

  std::filesystem::path folder_, input_;
  FingerPtr finger_;
  std::optional<Pipeline> first_, other_;
  std::optional<RecordedFrames> frames_;
  std::shared_ptr<const FrameTimes> times_ns_;
  std::optional<std::size_t> last_;
  cv::Size grid_;  // the same for all frames of a finger
};

}  // namespace alltact
