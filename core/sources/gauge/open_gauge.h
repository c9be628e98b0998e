// Any gauge by its name.
#pragma once

#include "core/sources/gauge/gauge_source.h"

#include <string>

namespace alltact {

/// What a person says of a gauge.
struct GaugeChoice {
  /// "typed" (on standard input), "serial:NODE", "hid:DEVICE" as open_hid() takes it.
  std::string gauge;
  std::string model;      ///< "mark10", "imada", "sauter" or nothing: speed, question and format
  std::string unit;       ///< of what names none; empty: N
  std::string direction;  ///< as GaugeDirections::parse takes it; empty: x, or x, y, z
  std::string ask;        ///< of a serial gauge, with \r, \n, \xHH for what cannot be typed
  int baud = 0;           ///< 0: the model's, 9600
  double ask_every_s = 0.05;
  std::string report;  ///< of a HID gauge, as GaugeReport::from() takes it
};

/// Opens it now and, after it was unplugged, again. Errors: what is said does not go together or is
/// not understood.
[[nodiscard]] Result<GaugeOpener> gauge_opener(const GaugeChoice& choice);

/// "?\r" from what a person can type. Error: a backslash before something else.
[[nodiscard]] Result<std::string> unescaped(const std::string& text);

}  // namespace alltact
