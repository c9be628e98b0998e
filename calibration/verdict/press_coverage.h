// Coverage of a face by presses, which limits the evidence for its parts.
#pragma once

#include <array>
#include <vector>

namespace alltact {

/// Distribution of a calibration's presses over the face.
struct PressCoverage {
  /// Distinct positions: contacts whose middles are further apart than the larger one's radius.
  /// Closer contacts share more than a third of their area, and with it light, layer and camera.
  /// They count as repeats.
  int positions = 0;
  std::array<int, 3> thirds = {};  ///< of them in base, middle, tip (flat: left, middle, right)
  /// Cost of predicting from a straight line along the face through the positions, in variances of
  /// one position, as the mean over the face: 1 / n + mean((s - mean s)^2) / sum((s - mean s)^2),
  /// at most kMaxLeverage. 0 with one position.
  double leverage = 0;
};
inline constexpr double kMaxLeverage = 16;

/// Position of one contact on the face, mm.
struct ContactSpot {
  double along_mm = 0, across_mm = 0;
  double radius_mm = 0;       ///< of the contact's rim
  double face_length_mm = 0;  ///< visible to the camera
};
/// The distinct position of each, numbered from 0. Which contacts share one does not depend on the
/// order.
[[nodiscard]] std::vector<int> position_numbers(const std::vector<ContactSpot>& spots);

/// The order does not matter.
[[nodiscard]] PressCoverage coverage_of(std::vector<ContactSpot> spots);

}  // namespace alltact
