// What can be measured of the face between the points A and B.
#pragma once

#include "core/sensing/surface/surface_patch.h"
#include "widgets/inspect/inspected_frame.h"

#include <QString>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// One line of what is shown. Absent, it has a reason.
struct SurfaceReading {
  QString name, unit;
  std::optional<MeasuredValue> measured;
  int decimals = 2;
  Message reason;
  bool is_least = false;  ///< a part of it is at the layer's limit: shown as "at least"
};

/// The straight distance from A to B; radius of the ball, area, volume and mean depth of what
/// presses, and roughness, of the box whose corners are A and B; the step along the line from A to
/// B; the angle between the surfaces 13 pixels wide around A and B. Empty for a frame without
/// depth.
[[nodiscard]] std::vector<SurfaceReading> surface_readings(const InspectedFrame& frame,
                                                           cv::Point2d a,
                                                           cv::Point2d b);

/// "4.02 ± 0.03 mm"; a dash where it could not be had.
[[nodiscard]] QString value_text(const SurfaceReading& reading);

/// A line each: "Ball's radius: 4.020 ± 0.031 mm".
[[nodiscard]] QString text_of(const std::vector<SurfaceReading>& readings);

/// A headline and a line each: name, value, standard deviation, unit; numbers as programs read
/// them.
[[nodiscard]] QString csv_of(const std::vector<SurfaceReading>& readings);

}  // namespace alltact
