// Pairs views of two cameras by capture time.
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
  /// Capture time of the second minus that of the first; empty where a source has no times, so that
  /// the newest views are paired.
  std::optional<double> later_ms;
  bool is_in_time = true;  ///< false: further apart than half a frame
};

/// Pairs views as they arrive. Two views are of one moment where none is nearer in time and they
/// are at most half a frame of the slower camera apart. Free-running cameras always reach that
/// while every frame is measured. Retains kMaxViews views of each.
class ViewPairing {
 public:
  static constexpr std::size_t kMaxViews = 8;
  /// For this long no pair is shown rather than one that is not in time.
  static constexpr double kTimeout_s = 1.0;

  /// which: 0 or 1. time_ns: of capture, of one clock for both; empty: not known.
  /// Returns the pair to be shown from now on; nullopt: the last one stays.
  [[nodiscard]] std::optional<ViewPair> add(std::size_t which,
                                            std::shared_ptr<const LiveView> view,
                                            std::optional<std::int64_t> time_ns);
  void forget() { *this = ViewPairing(); }
  /// Measured frame period of this camera; empty before its second frame.
  [[nodiscard]] std::optional<double> period_ms(std::size_t which) const;

 private:
  struct Timed {
    std::shared_ptr<const LiveView> view;
    std::optional<std::int64_t> time_ns;
  };
  void measure_period(std::size_t which, const Timed& now);
  [[nodiscard]] double tolerance_ns() const;

  std::array<std::deque<Timed>, 2> views_;
  std::array<std::optional<double>, 2> period_ms_;
  std::optional<std::array<std::int64_t, 2>> shown_ns_;  // of the last pair in time
  std::optional<std::int64_t> waiting_since_ns_;
};

}  // namespace alltact
