// When within its frame an image is exposed.
#pragma once

namespace alltact {

/// Times in frames; 0 is the frame's own time, which is that of the image's middle row and of the
/// truth. By default every row is exposed at that time.
struct Exposure {
  double open = 0;       ///< exposure of a row, half before its time and half after
  int moments = 1;       ///< number of samples averaged over the exposure
  double readout = 0;    ///< from the first row's time to the last's
  int rows_at_once = 1;  ///< neighbouring rows that share one time

  [[nodiscard]] bool is_instantaneous() const { return open == 0 && readout == 0; }
  /// Time of the rows around row `v` (may be fractional) of `rows`.
  [[nodiscard]] double moment_of(double v, int rows) const {
    return rows > 1 ? readout * (v / (rows - 1) - 0.5) : 0.0;
  }
  /// Middle of sample `i` of the exposure.
  [[nodiscard]] double offset_of(int i) const { return open * ((i + 0.5) / moments - 0.5); }
};

}  // namespace alltact
