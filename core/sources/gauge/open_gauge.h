// Opens any gauge by its name.
#pragma once

#include "core/sources/gauge/gauge_source.h"

#include <string>

namespace alltact {

/// A gauge as a person specifies it.
struct GaugeChoice {
  /// "typed" (on standard input), "serial:NODE", "hid:DEVICE" as open_hid() takes it.
  std::string gauge;
  std::string model;      ///< "mark10", "imada", "sauter" or empty: preset of speed, question and
                          ///< format
  std::string unit;       ///< of values without a unit; empty: N
  std::string direction;  ///< as GaugeDirections::parse takes it; empty: x, or x, y, z
  std::string ask;        ///< question for a serial gauge, with \r,
                          ///< , \xHH for control characters
  int baud = 0;           ///< 0: the model's, 9600
  double ask_every_s = 0.05;
  std::string report;  ///< of a HID gauge, as GaugeReport::from() takes it
};

/// Returns a function that opens the gauge, also after it was unplugged. Errors: the specification
/// contradicts itself or is not understood.
[[nodiscard]] Result<GaugeOpener> gauge_opener(const GaugeChoice& choice);

/// Converts escapes, such as "?\r" typed by a person, to bytes. Error: an unknown escape.
[[nodiscard]] Result<std::string> unescaped(const std::string& text);

}  // namespace alltact
