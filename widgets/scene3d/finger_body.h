// The finger's body behind its face as far as it is known, and a stand-in for the rest. Inside this
// folder and its tests only.
#pragma once

#include "widgets/scene3d/face_surface.h"

#include <array>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Cross-sections of a Fin Ray from its base to its tip; mm, in the camera's frame.
///
/// Known: the face with its bend, sway and twist, and the side faces. These stand straight behind
/// its edges as far as the dots engraved in them lie. Not known, and drawn plainly: the back and
/// the base. The back is, at the base, as deep as the camera sits behind the face. From there it
/// thins evenly to the tip, but is nowhere less deep than the dots. The base is a plain block.
struct FingerBody {
  /// Corners in order round the section, looking from the base to the tip or from the tip to the
  /// base: face at row 0, face at the last row, and behind these the back.
  using Section = std::array<Eigen::Vector3d, 4>;
  std::vector<Section> sections;  ///< empty: no body
  /// The base's block: its two ends, the second one where the face begins.
  std::array<Section, 2> base;
  /// All corners, for fitting the view.
  [[nodiscard]] std::vector<Eigen::Vector3d> corners() const;
};

/// Empty for a flat sensor.
[[nodiscard]] FingerBody body_of(const FaceSurface& surface);

}  // namespace alltact
