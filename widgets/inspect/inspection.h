// Measures frames of a recording, or those that come live, beside the window: the newest wish wins.
#pragma once

#include "calibration/live/live_finger.h"
#include "widgets/inspect/frame_summary.h"
#include "widgets/inspect/inspected_frame.h"

#include <QObject>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace alltact {

/// An object of the window's thread; work goes on a thread of its own.
class Inspection : public QObject {
  Q_OBJECT
 public:
  explicit Inspection(QObject* parent = nullptr);
  /// The work is asked to stop and waited for: at most one frame, or a stretch of loading.
  ~Inspection() override;

  /// The finger that recordings are measured with; empty: none.
  void set_finger(const std::filesystem::path& folder);
  void set_other(const Comparand& other);
  /// While it waits for wishes it measures all frames of a recording one after the other, for their
  /// summaries.
  void set_looking_further(bool is_on);
  /// A video, or a folder of pictures; an empty path closes it.
  ///   number: the frame that is shown first; of a shorter one the last
  void open(const std::filesystem::path& input, std::size_t number = 0);
  void show_frame(std::size_t number);
  /// What stands in the finger's folder has changed.
  void measure_again();
  /// A frame that was measured live, with the finger it was measured with.
  void show_live(std::shared_ptr<const LiveView> view, const Finger& finger);

  /// Null before the first and while another recording is being opened.
  [[nodiscard]] const std::shared_ptr<const InspectedFrame>& frame() const { return frame_; }
  [[nodiscard]] const std::optional<RecordingInfo>& recording() const { return recording_; }
  /// Why nothing can be shown at all.
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }
  /// A wish is being worked on.
  [[nodiscard]] bool is_busy() const;
  /// Of the recording's frames that were measured so far, in any order.
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

}  // namespace alltact
