// The soft layer's surface around a ball that presses into it.
#pragma once

#include "core/simulation/mechanics/bonded_layer.h"

#include <vector>

namespace alltact {

/// How deep the surface lies below where it was, at r = 0, step_mm, 2 step_mm, ... from the ball's
/// axis, along the normal: on the ball (d - R + sqrt(R^2 - r^2)) within the contact, beyond it what
/// the contact's pressure makes of a bonded, incompressible layer,
///   w(r) = int g(t) / sqrt(r^2 - t^2) dt - int (1 - phi(kh)) g^(k) J0(kr) dk,
/// the first term the half space's, with g the pressure's Abel transform, g^ its cosine transform
/// and phi = (sinh 2x - 2x) / (cosh 2x + 1 + 2x^2) the layer's compliance (I. N. Sneddon, Fourier
/// Transforms, 1951), corrected near the rim by the hundredths of d that it misses the ball by. It
/// bulges (negative) beyond about one thickness from the rim, for the rubber keeps its volume. Ends
/// where nothing is left to see.
[[nodiscard]] std::vector<float> dented_surface_mm(const BondedLayerContact& contact,
                                                   double indentation_mm,
                                                   double step_mm);

}  // namespace alltact
