// Readings that a person types, a line each.
#pragma once

#include "core/sources/gauge/gauge_source.h"

#include <optional>

namespace alltact {

/// A line is
///   1.23   1,23   1.23 N   250 g    what the gauge shows, along the direction set
///   0.5 1.2                         Fx and Fy; three numbers: Fz too
///   y 1.23                          along y from now on
///   block NAME   indenter NAME      of what is typed from now on
///   nothing                         what was typed holds no longer
/// Each reading is of the moment of its Enter and holds around it. Unless blocks are named, each is
/// one: "typed 1", "typed 2".
class TypedGauge : public GaugeSource {
 public:
  /// `descriptor`: of standard input, as a rule; it stays the caller's.
  TypedGauge(int descriptor, const GaugeLineRules& rules, const GaugeDirections& directions);

  /// Lines that are not understood are told in remarks, and so is each that is. Over at the
  /// input's end.
  [[nodiscard]] Result<GaugeNews> read(int timeout_ms) override;
  [[nodiscard]] int axes() const override { return 0; }

 private:
  void take(std::string line, double time_s, GaugeNews& news);
  bool take_name(const std::string& line, GaugeNews& news);

  int descriptor_;
  GaugeLineRules rules_;
  GaugeDirections directions_;
  std::string unfinished_, block_, indenter_;
  int count_ = 0;
  double last_s_ = 0;
  bool is_over_ = false;
};

}  // namespace alltact
