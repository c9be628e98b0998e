// Errors of a calibration on its presses: residuals by sample and zone, errors of single pixels,
// and depth that the mapping reads next to contacts.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"
#include "core/base/message.h"
#include "core/finger/mapping.h"
#include "core/sensing/depth/depth_resolution.h"

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
  std::optional<DepthResolution> resolution = std::nullopt;  ///< at the contact's middle
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
                                                 const Calibration& calibration, FaceKind kind);

/// "base 0.004 mm (2 presses), middle 0.003 mm (1 press), tip unknown: no press there".
[[nodiscard]] Message zone_sentence(const std::vector<ZoneError>& zones);

// Error of a pixel's depth inside a contact, from all known causes.

struct Reference;

/// A press and its reference, both of which must outlive it.
struct ComparedPress {
  const Press* press = nullptr;
  const Reference* reference = nullptr;
};

/// Errors of single pixels under the balls, mm along z.
struct ContactError {
  double mean_mm = 0;                ///< mean absolute, of all causes; 0: unknown
  double sd_without_mapping_mm = 0;  ///< standard deviation of all causes but the mapping
};

/// The median over presses of the pixels' mean standard deviation by noise, mapping, reference,
/// light and neighbouring contacts (depth_sd.h). The median is used because gaps of the recording
/// at one position do not apply to the others. Poses beyond the recording count as known ones.
/// `contacts`: those of press_residuals(), found by name. 0 where no press shows a contact deeper
/// than 0.1 mm.
[[nodiscard]] ContactError contact_error(const std::vector<ComparedPress>& presses,
                                         const std::vector<PressResiduals>& contacts,
                                         const MappingParameters& mapping);

// Depth that a mapping reads next to contacts, where light scatters sideways through the layer.
//
// A mapping treats brightness as local to one pixel. In a layer that scatters, part of a pixel's
// light comes from up to a layer's thickness away. Presses of balls, which determine the mapping,
// hide that inside their contacts. Bodies of other shape are misread by about as much as the
// mapping reads next to a ball, so the rings around the contacts are measured.
//
// Skin itself is pressed in next to a contact, as an elastic half space (K. L. Johnson, Contact
// Mechanics, eq. 3.42a) that a bonded layer fades within a part of its thickness (ibid. 5.8). Depth
// beyond that, with the decay of light, may be light; skin that leaves the ball unusually early
// looks the same. A skirt of less than about a third of the light cannot be separated from skin,
// nor one under a bulge. ErrorCause::kBody covers these.

/// Means over all presses, mm of depth.
struct Halo {
  double near_mm = 0;       ///< read in the ring 0.5 to 1 mm outside the ball's cap, mean
  double far_mm = 0;        ///< in the ring 1.5 to 2 mm outside
  double excess_mm = 0;     ///< near_mm beyond the possible indentation of skin there, mean
  double excess_sd_mm = 0;  ///< standard error of that, by the scatter of the presses
  int presses = 0;          ///< with a visible ring
  bool is_seen = false;     ///< significant, and decays as light does; skin may as well
};
[[nodiscard]] Halo measure_halo(const std::vector<const Press*>& presses, const Face& face,
                                const Calibration& calibration);

}  // namespace alltact
