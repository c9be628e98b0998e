// How much of a face presses cover: what counts as evidence of its parts.
#pragma once

#include <array>
#include <vector>

namespace alltact {

/// Where a calibration's presses lie on the face.
struct PressCoverage {
  /// Distinct positions: contacts whose middles are further apart than the larger one's radius.
  /// Contacts closer than that share more than a third of their area, and with it light, layer and
  /// camera: as evidence of the face they are repeats.
  int positions = 0;
  std::array<int, 3> thirds = {};  ///< of them in base, middle, tip (flat: left, middle, right)
  /// What predicting from a straight line along the face through the positions costs, in variances
  /// of one position and as the mean over the face: 1 / n + mean((s - mean s)^2) / sum((s - mean
  /// s)^2), at most kMostLeverage. 0 with one position.
  double leverage = 0;
};
inline constexpr double kMostLeverage = 16;

/// Where one contact lies on the face, mm.
struct ContactSpot {
  double along_mm = 0, across_mm = 0;
  double radius_mm = 0;       ///< of the contact's rim
  double face_length_mm = 0;  ///< that the camera sees
};
/// The distinct position of each, numbered from 0; which contacts share one does not depend on the
/// order.
[[nodiscard]] std::vector<int> position_numbers(const std::vector<ContactSpot>& spots);

/// The order does not matter.
[[nodiscard]] PressCoverage coverage_of(std::vector<ContactSpot> spots);

}  // namespace alltact
