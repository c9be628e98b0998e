// Readings that a person types, one per line.
#pragma once

#include "core/sources/gauge/gauge_source.h"

#include <optional>

namespace alltact {

/// A line is
///   1.23   1,23   1.23 N   250 g    the gauge's display, along the current direction
///   0.5 1.2                         Fx and Fy; three numbers: Fz too
///   y 1.23                          along y from now on
///   block NAME   indenter NAME      for the readings from now on
///   nothing                         the last reading is no longer valid
/// The time of a reading is that of its Enter; it is valid around that time. Without named blocks
/// each reading is a block: "typed 1", "typed 2".
class TypedGauge : public GaugeSource {
 public:
  /// `descriptor`: usually standard input; the caller owns it.
  TypedGauge(int descriptor, const GaugeLineRules& rules, const GaugeDirections& directions);

  /// Remarks report each line that is not understood and confirm each other one. The source is over
  /// at the input's end.
  [[nodiscard]] Result<GaugeUpdate> read(int timeout_ms) override;
  [[nodiscard]] int axes() const override { return 0; }

 private:
  void take(std::string line, double time_s, GaugeUpdate& update);
  bool take_name(const std::string& line, GaugeUpdate& update);

  int descriptor_;
  GaugeLineRules rules_;
  GaugeDirections directions_;
  std::string unfinished_, block_, indenter_;
  int count_ = 0;
  double last_s_ = 0;
  bool is_over_ = false;
};

}  // namespace alltact
