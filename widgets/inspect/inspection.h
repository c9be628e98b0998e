// Measures frames of a recording or of the live stream on a background thread. The newest request
// wins.
#pragma once

#include "calibration/live/live_finger.h"
#include "widgets/inspect/inspected_frame.h"

#include <QObject>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace alltact {

/// Belongs to the window's thread; works on a thread of its own.
class Inspection : public QObject {
  Q_OBJECT
 public:
  explicit Inspection(QObject* parent = nullptr);
  /// Stops the work and waits for it: at most one frame, or one stage of loading.
  ~Inspection() override;

  /// Folder of the finger that measures recordings; empty: none.
  void set_finger(const std::filesystem::path& folder);
  void set_other(const ComparisonSpec& other);
  /// While on and without a request, measures all frames of a recording in sequence for their
  /// summaries.
  void set_scanning(bool is_on);
  /// A video, or a folder of images; an empty path closes it.
  ///   number: the first frame to show; past the end, the last frame
  void open(const std::filesystem::path& input, std::size_t number = 0);
  void show_frame(std::size_t number);
  /// The finger's folder has changed.
  void measure_again();
  /// A live frame that was measured already, with its finger.
  void show_live(std::shared_ptr<const LiveView> view, const Finger& finger);

  /// Null before the first and while another recording is being opened.
  [[nodiscard]] const std::shared_ptr<const InspectedFrame>& frame() const { return frame_; }
  [[nodiscard]] const std::optional<RecordingInfo>& recording() const { return recording_; }
  /// Why nothing can be shown at all.
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }
  /// A request is being processed.
  [[nodiscard]] bool is_busy() const;
  /// Summaries of the frames measured so far, in any order.
  [[nodiscard]] const std::vector<FrameSummary>& summaries() const { return summaries_; }

 Q_SIGNALS:
  void frame_ready();
  /// recording(), problem() or is_busy() changed.
  void state_changed();
  /// More frames have summaries, or none.
  void summaries_changed();

 private:
  struct Shared;
  void take();
  void take_summaries();

  std::shared_ptr<Shared> shared_;
  std::shared_ptr<const InspectedFrame> frame_;
  std::optional<RecordingInfo> recording_;
  std::optional<Error> problem_;
  std::vector<FrameSummary> summaries_;
};

// The worker of Inspection: measures frames and builds surfaces. Used by one thread.

/// A frame to be measured.
struct InspectRequest {
  std::filesystem::path finger;
  std::filesystem::path input;
  std::uint64_t opened = 0;  ///< number of the opening of `input`
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
    bool is_from_scratch = false;  ///< earlier summaries are of another opening or finger
    std::vector<FrameSummary> summaries;
  };
  [[nodiscard]] SummaryUpdate update();

 private:
  void note(const MeasuredFrame& frame);
  void add(const FrameSummary& summary);
  void resend(std::uint64_t opened);
  Result<MeasuredFrame> measured(const InspectRequest& request, const Job& job,
                                 std::optional<RecordingInfo>& recording);
  std::shared_ptr<const InspectedFrame> with_surfaces(MeasuredFrame measured);

  FrameMeasurer measurer_;
  std::filesystem::path grid_of_;  // a finger's folder
  cv::Size grid_;                  // the same for all its frames
  // By frame, with the recording and finger of these summaries.
  std::vector<std::optional<FrameSummary>> summaries_;
  std::size_t next_ = 0;  // all frames before it have one
  std::uint64_t opened_ = 0;
  std::filesystem::path summaries_of_;
  std::shared_ptr<const FingerSnapshot> summaries_by_;
  SummaryUpdate update_;
};

}  // namespace alltact
