// The soft layer's surface around an indenting ball.
#pragma once

#include "core/simulation/mechanics/bonded_layer.h"

#include <vector>

namespace alltact {

/// Depth of the surface below its undeformed position along the normal, at r = 0, step_mm, 2
/// step_mm, ... from the ball's axis. Within the contact it follows the ball (d - R + sqrt(R^2 -
/// r^2)). Beyond it, the contact's pressure on a bonded, incompressible layer gives
///   w(r) = int g(t) / sqrt(r^2 - t^2) dt - int (1 - phi(kh)) g^(k) J0(kr) dk,
/// the first term the half space's, with g the pressure's Abel transform, g^ its cosine transform
/// and phi = (sinh 2x - 2x) / (cosh 2x + 1 + 2x^2) the layer's compliance (I. N. Sneddon, Fourier
/// Transforms, 1951). A correction near the rim removes the mismatch with the ball, some hundredths
/// of d. The surface bulges (negative) beyond about one thickness from the rim, since the rubber is
/// incompressible. The profile ends where nothing visible remains.
[[nodiscard]] std::vector<float> indented_surface_mm(const BondedLayerContact& contact,
                                                     double indentation_mm,
                                                     double step_mm);

}  // namespace alltact
