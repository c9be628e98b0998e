// Parts of the face that an object over its end hides from a frame.
#pragma once

#include "core/sensing/reference/face_chart.h"

#include <optional>
#include <vector>

namespace alltact {

/// A column in which the face continues although the frame does not show it.
struct HiddenColumn {
  int u = 0;
  double upper_v = 0, lower_v = 0;  ///< edges, extended linearly, px
};

/// Arc lengths at which recorded faces end.
class EndLengths {
 public:
  EndLengths() = default;
  /// charts: of recorded frames of width_px columns, registered to each other. An end at the image
  /// border is ignored; an end in fewer than half of the frames is unknown.
  EndLengths(const std::vector<FaceChart>& charts, int width_px);

  /// Columns after a frame's chart (registered alike) up to where the face must end, within the
  /// image. Empty where the chart ends within 0.5 mm of it, or within 6 sd of the recorded ends,
  /// and where the end is unknown.
  [[nodiscard]] std::vector<HiddenColumn> hidden_columns(const FaceChart& now, int width_px) const;

 private:
  struct End {
    double mm = 0, tolerance_mm = 0;
  };
  static std::optional<End> end_of(std::vector<double> lengths_mm, std::size_t frames);
  std::optional<End> first_, last_;  // at small and at large u
};

}  // namespace alltact
