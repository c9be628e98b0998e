// Residuals of the presses of a calibration, sample by sample, with their positions on the face:
// for plots, maps and verdicts by zone.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"
#include "core/message.h"

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A block of pixels under the ball. Depths are along z, or along the normal where the mapping is.
struct ResidualSample {
  Eigen::Vector2d pixel;     ///< its middle, in the oriented image
  double x = 0;              ///< brightness difference
  double ball_depth_mm = 0;  ///< depth of the fitted ball there
  double residual_mm = 0;    ///< mapping minus ball: positive where the mapping is too deep
  double along_mm = 0;       ///< from the base along the middle of the face
  double across_mm = 0;      ///< from the middle of the face towards large v
  double rim = 0;            ///< distance from the contact's middle, 1 at the rim of the ball's cap
  double factor = 1;         ///< of the mapping at this position, where it varies over the face
};

/// Skin and ball touch up to here on any material. Residuals further out may be those of the skin.
inline constexpr double kInnerRim = 0.65;

struct PressResiduals {
  std::string press;
  double along_mm = 0, across_mm = 0;   ///< the contact's middle
  double contact_radius_mm = 0;         ///< of the cap's rim on the face
  double face_length_mm = 0;            ///< visible length of the face in this press
  double face_width_mm = 0;             ///< there, across the contact
  std::vector<ResidualSample> samples;  ///< up to rim 1, at most about 800
};

/// Length of the face between the first and the last column that show it.
[[nodiscard]] double face_length_mm(const FaceShape& shape);

/// One for each ball of the calibration whose press is among `presses`, in the order of the balls.
/// Presses without a sample under the ball are left out.
[[nodiscard]] std::vector<PressResiduals> press_residuals(const std::vector<const Press*>& presses,
                                                          const Face& face,
                                                          const Calibration& calibration);

/// The error of the presses in one zone of the face.
struct ZoneError {
  Message zone;                    ///< "base", "upper half", ...
  int presses = 0;                 ///< with their contact's middle there
  std::optional<double> error_mm;  ///< mean, held-out or (one press only) own; empty: no press
};

/// Thirds along the face, then its halves across. Of a Fin Ray finger: base, middle, tip; of a flat
/// sensor: left, middle, right. Upper is where v is small.
[[nodiscard]] std::vector<ZoneError> zone_errors(const std::vector<PressResiduals>& residuals,
                                                 const Calibration& calibration,
                                                 FaceKind kind);

/// "base 0.004 mm (2 presses), middle 0.003 mm (1 press), tip unknown: no press there".
[[nodiscard]] Message zone_sentence(const std::vector<ZoneError>& zones);

}  // namespace alltact
