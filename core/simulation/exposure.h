// When within its frame a picture is taken.
#pragma once

namespace alltact {

/// Times are in frames; 0 is the frame's own moment, which is that of the picture's middle row and
/// of the truth. As it stands here every row is taken at that moment.
struct Exposure {
  double open = 0;       ///< how long a row is exposed, half before its moment and half after
  int moments = 1;       ///< whose mean stands for that
  double readout = 0;    ///< from the first row's moment to the last's
  int rows_at_once = 1;  ///< neighbouring rows that share a moment

  [[nodiscard]] bool is_at_once() const { return open == 0 && readout == 0; }
  /// The moment of the rows around row `v` (which may be a half) of `rows`.
  [[nodiscard]] double moment_of(double v, int rows) const {
    return rows > 1 ? readout * (v / (rows - 1) - 0.5) : 0.0;
  }
  /// Middle of part `i` of the time that the shutter is open.
  [[nodiscard]] double offset_of(int i) const { return open * ((i + 0.5) / moments - 0.5); }
};

}  // namespace alltact
