// The state of the lamps and of their light in one frame.
#pragma once

#include "core/simulation/row_view.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>

#include <Eigen/Core>

namespace alltact {

// Light that arrives not directly from the lamps but from lit surfaces.

/// Sets irradiance[first, last) to the irradiance of a surface directly from lamps and room.
using DirectLight = std::function<void(const Surface& surface, float* irradiance)>;

/// Sets irradiance[first, last) of a surface of this row. Several threads call it at once.
using IndirectRows =
    std::function<void(const RowView& row, const Surface& surface, float* irradiance)>;

/// Of one frame. Built with the geometry; the effect that owns the lamps calls it.
using IndirectLight = std::function<IndirectRows(const DirectLight& direct)>;

/// Default: every lamp has its full power, nothing else shines, nothing absorbs.
struct Illumination {
  double lamp_share = 1;               ///< fraction of their power, for all lamps
  std::map<int, double> single_share;  ///< additional fraction for one lamp, by number
  double room_level = 0;     ///< light from all directions, grey levels of a white surface
  double absorb_per_mm = 0;  ///< of the clear body, along the path from a lamp and to the camera
  IndirectLight indirect;    ///< empty: only lamps and room shine

  [[nodiscard]] double share_of(int lamp) const {
    const auto single = single_share.find(lamp);
    return single == single_share.end() ? lamp_share : lamp_share * single->second;
  }
};

// The fraction of a point's view that a polygon fills.

using Quadrilateral = std::array<Eigen::Vector3d, 4>;

/// Form factor from a small area at `point` with unit normal `normal` to a quadrilateral, 0..1: the
/// polygon's light at the point, as a share of its radiosity. By Lambert's formula,
///   F = 1 / (2 pi) sum over edges of angle_k (normal . (r_k+1 x r_k) / |r_k+1 x r_k|),
/// r_k from the point to the corners and angle_k between two of them (J. H. Lambert, "Photometria",
/// 1760; used for radiosity by D. Baum, H. Rushmeier and J. Winget, SIGGRAPH 1989). It is exact at
/// any distance. The part behind the point's own plane is clipped. Corners run counter-clockwise as
/// viewed from the lit side; from behind it is 0. Any unit of length.
[[nodiscard]] double form_factor(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                 const Quadrilateral& corners);

// Reflectance of a translucent layer on its coat.

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
