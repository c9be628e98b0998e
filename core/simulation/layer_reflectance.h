// Reflectance of a translucent layer on its coat.
#pragma once

#include <cmath>

namespace alltact {

/// A layer that scatters S and absorbs K of the light per mm, on a coat that reflects the share G
/// of it (P. Kubelka, F. Munk, Zeitschrift fuer technische Physik 12, 1931).
struct LayerOptics {
  double scatter_per_mm = 0;  ///< S, above 0
  double absorb_per_mm = 0;   ///< K
  double coat = 0;            ///< G, 0 (black) up to but not 1

  /// Share of the light that a layer of this thickness reflects:
  ///   R = (1 - G (a - b coth(bSt))) / (a - G + b coth(bSt)),  a = (S + K) / S, b = sqrt(a^2 - 1),
  /// without absorption ((1 - G) St + G) / ((1 - G) St + 1). With coth(bSt) = (E + 2) / E, E =
  /// expm1(2 b S t), nothing cancels for thin layers or weak absorption.
  [[nodiscard]] double reflectance(double thickness_mm) const {
    const double st = scatter_per_mm * thickness_mm;
    if (absorb_per_mm == 0) return ((1 - coat) * st + coat) / ((1 - coat) * st + 1);
    const double k = absorb_per_mm / scatter_per_mm;
    const double a = 1 + k, b = std::sqrt(k * (2 + k));
    const double e = std::expm1(2 * b * st);
    if (std::isinf(e)) return 1 / (a + b);
    if (coat == 0) return e / (a * e + b * (e + 2));
    return (e - coat * (a * e - b * (e + 2))) / ((a - coat) * e + b * (e + 2));
  }
};

}  // namespace alltact
