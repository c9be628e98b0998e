// Which views of two cameras belong together: those taken at the same moment.
#pragma once

#include "calibration/live/live_finger.h"

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

namespace alltact {

struct ViewPair {
  std::array<std::shared_ptr<const LiveView>, 2> views;
  /// How much later the second was taken; absent where a source has no times, so that the newest
  /// of both stand together.
  std::optional<double> later_ms;
  bool is_in_time = true;  ///< false: further apart than half a frame
};

/// Of views as they come. Two are of one moment where none is nearer in time and they are at most
/// half a frame apart, of the slower camera's frames: whatever two cameras that run freely can do,
/// as long as each of their frames is measured. Keeps kKept views of each.
class ViewPairing {
 public:
  static constexpr std::size_t kKept = 8;
  /// For so long nothing is shown rather than what is not of one moment.
  static constexpr double kPatience_s = 1.0;

  /// which: 0 or 1. time_ns: of capture, of one clock for both; absent: not known.
  /// The pair that is to be shown from now on; nullopt: what was shown still is.
  [[nodiscard]] std::optional<ViewPair> add(std::size_t which,
                                            std::shared_ptr<const LiveView> view,
                                            std::optional<std::int64_t> time_ns);
  void forget() { *this = ViewPairing(); }
  /// Between frames of this camera, as measured; absent before its second.
  [[nodiscard]] std::optional<double> period_ms(std::size_t which) const;

 private:
  struct Timed {
    std::shared_ptr<const LiveView> view;
    std::optional<std::int64_t> time_ns;
  };
  void measure_period(std::size_t which, const Timed& now);
  [[nodiscard]] double tolerance_ns() const;

  std::array<std::deque<Timed>, 2> kept_;
  std::array<std::optional<double>, 2> period_ms_;
  std::optional<std::array<std::int64_t, 2>> shown_ns_;  // of the last pair in time
  std::optional<std::int64_t> waiting_since_ns_;
};

}  // namespace alltact
