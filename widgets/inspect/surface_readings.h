// Readings of the face between the points A and B.
#pragma once

#include "core/sensing/surface/surface_patch.h"
#include "widgets/inspect/inspected_frame.h"

#include <QString>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// One line of the table. `reason` is set where `measured` is empty.
struct SurfaceReading {
  QString name, unit;
  std::optional<MeasuredValue> measured;
  int decimals = 2;
  Message reason;
  bool is_lower_bound = false;  ///< a part is at the layer's limit: shown as "at least"
};

/// Straight distance from A to B; within the box whose corners are A and B the ball radius, contact
/// area, volume, mean depth and roughness; the step along the line from A to B; the angle between
/// the surfaces 13 pixels wide around A and B. Empty for a frame without depth.
[[nodiscard]] std::vector<SurfaceReading> surface_readings(const InspectedFrame& frame,
                                                           cv::Point2d a,
                                                           cv::Point2d b);

/// "4.02 ± 0.03 mm"; a dash where nothing was measured.
[[nodiscard]] QString value_text(const SurfaceReading& reading);

/// A line each: "Ball's radius: 4.020 ± 0.031 mm".
[[nodiscard]] QString text_of(const std::vector<SurfaceReading>& readings);

/// A header and a line each: name, value, standard deviation, unit, limits. Numbers in the C
/// locale.
[[nodiscard]] QString csv_of(const std::vector<SurfaceReading>& readings);

}  // namespace alltact
