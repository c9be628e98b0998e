// What of the face a frame does not show because something lies over its end.
#pragma once

#include "core/sensing/reference/face_chart.h"

#include <optional>
#include <vector>

namespace alltact {

/// A column in which the face goes on although the frame does not show it.
struct HiddenColumn {
  int u = 0;
  double upper_v = 0, lower_v = 0;  ///< edges, continued straight, px
};

/// Where recorded faces end.
class EndLengths {
 public:
  EndLengths() = default;
  /// charts: of recorded frames of width_px columns, laid on one another (lay_on). An end at the
  /// picture's border is none, and an end that fewer than half of the frames show is not known.
  EndLengths(const std::vector<FaceChart>& charts, int width_px);

  /// The columns beyond a frame's chart (laid on the same) up to where the face must end, within
  /// the picture. Empty where it ends within 0.5 mm of there, or 6 times what the recorded ends
  /// scatter, and where no end is known.
  [[nodiscard]] std::vector<HiddenColumn> beyond(const FaceChart& now, int width_px) const;

 private:
  struct End {
    double mm = 0, tolerance_mm = 0;
  };
  static std::optional<End> end_of(std::vector<double> lengths_mm, std::size_t frames);
  std::optional<End> first_, last_;  // at small and at large u
};

}  // namespace alltact
