// Readings of a gauge during a recording, next to the video: NAME.mkv has NAME.gauge.csv.
//
//   # alltact-gauge/1
//   # gauge: serial:/dev/ttyUSB0
//   t_s,fx_n,fy_n,fz_n,sd_n,holds,block,indenter
//   81234.567890,0.123,0,0,0.000289,0,,
//   81234.617950,,,,,0,,
//
// t_s is the clock of the frames (their time_ns in seconds). A line without forces marks that there
// is none from then on: the gauge was over range or unplugged, or a typed value is no longer valid.
#pragma once

#include "core/base/descriptor.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/base/worker.h"
#include "core/devices/gauge_source.h"
#include "core/image/frame.h"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace alltact {

inline constexpr const char* kGaugeLogFormat = "# alltact-gauge/1";

[[nodiscard]] std::filesystem::path gauge_log_of(const std::filesystem::path& video);

/// Reads a gauge in a thread of its own and writes its readings while a recording runs. Waits for
/// an unplugged gauge to come back.
class GaugeLog {
 public:
  /// name: written at the top of each file. Errors: those of the opener.
  [[nodiscard]] static Result<std::unique_ptr<GaugeLog>> start(GaugeOpener open, std::string name);
  ~GaugeLog() = default;
  GaugeLog(const GaugeLog&) = delete;
  GaugeLog& operator=(const GaugeLog&) = delete;

  /// Starts a file, which is overwritten. The readings of the last second, and the value that is
  /// still valid, come first. Error: it cannot be written.
  [[nodiscard]] Status begin(const std::filesystem::path& file);
  /// Takes each frame of the recording. The first one determines the offset between the frames'
  /// clock and this computer's; nothing is written before.
  void sync_clock(const Frame& frame);
  struct Counts {
    std::uint64_t readings = 0, without_force = 0;
  };
  /// Ends the file. Error: it could not be written to the end.
  [[nodiscard]] Result<Counts> end();

  /// Remarks for the person at the gauge; each is returned once. Any thread.
  [[nodiscard]] std::vector<Message> take_remarks();

 private:
  GaugeLog(std::unique_ptr<GaugeSource> source, GaugeOpener open, std::string name);
  void run(const std::stop_token& stop);
  void take(const GaugeUpdate& update);
  void write(const GaugeSample& sample);
  void write_text(const std::string& text);
  void store_recent(const GaugeSample& sample);

  GaugeOpener open_;
  std::string name_;
  std::unique_ptr<GaugeSource> source_;
  std::mutex mutex_;
  std::vector<Message> remarks_;
  std::deque<GaugeSample> recent_, waiting_;
  std::filesystem::path file_;
  Descriptor descriptor_;
  bool is_clock_synced_ = false;
  double clock_offset_s_ = 0;
  Status status_;
  Counts counts_;
  Worker worker_;  // last: it ends first
};

}  // namespace alltact
