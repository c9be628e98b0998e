// Light that comes back next to where it went in.
//
// A translucent layer is translucent because it scatters. Part of the light of a pixel turned last
// near the skin that its line of sight meets: the core. The rest comes from all of the layer that
// light reaches, some thicknesses around: the skirt. With d the depth of the skin along the normal
// and y(d) the brightness difference of an even layer as thin,
//   1 - x(p) = (1 - k(d at p + (1 - d / T) u)) (1 - q(p + s u)),   k = core y / (1 - (1 - core) y)
// T is the thickness, u the displacement along the face from where a line of sight enters the layer
// to where it meets the untouched outer side: it meets a pressed skin sooner. k is what the line of
// sight loses by ending sooner, q what the layer around it loses of its light:
//   q - width^2 (1 - 2.3 e) laplace q = e,   e = (1 - core) y.
// x is y on even layers. Around small indentations q is the mean of e over K0(r / width); where a
// deep one swallowed much, less light comes from further away.
//
// All of it follows from the optical thickness t, LightSpread::optical_thickness. The formulas
// below were fitted to solutions of the equation of transfer for layers with isotropic scattering
// over a black outside, t of 0.2 to 3.2, light at 25 to 65 degrees and sight at up to 52, up to 2 %
// absorbed, pressed by balls and punches half a thickness wide and wider; they leave 0.002 to 0.004
// of the untouched brightness (van de Hulst's similarity relates other phase functions to these).
// A core of exp(-0.68 ...) leaves least, but bodies narrower than the layer read up to a tenth too
// shallow with it.
// With m = 1 / cos(angle of sight in the layer) - 1,
//   core = exp(-0.74 t^0.78 (1 + 0.28 m))     width = 0.8 / t^0.4 layers     s = 0.43 - 0.066 t
//
// DEPTH
// Even layers follow d = rho T (1 + b) y / (1 + b y) within 0.002 T up to 0.6 T. Over black rho is
// about 0.986 - 0.01 t - 0.56 a t; an outside that gives back 1 % of the light adds 0.02 / t^1.3.
// Here a is absorption over scattering. b grows with the angle of sight and of light alike: with p
// the sum of both 1 / cos,
//   ln(1 + b) = 0.248 t^1.05 - 0.08 + 0.47 t exp(-0.35 t) (p - 2) + 2.7 a t^1.5
// within 0.02 (rms) for t of 0.2 to 3. Lamps stand near the camera: along a face 1 / cos of the
// light grows by about 0.7 of what that of sight does.
#pragma once

#include "core/finger/mapping.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/face/face_shape.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Spread for one angle of sight.
struct ObliqueSpread {
  double core = 1;         ///< part of the light, 0 to 1
  double skirt_shift = 0;  ///< s above
  double b_factor = 1;     ///< of 1 + b for sight along the normal
};
/// `cos_sight`: between the line of sight and the normal, in the layer; limited to 0.3 and 1.
[[nodiscard]] ObliqueSpread oblique_spread(const LightSpread& spread, double cos_sight);

/// Width of the skirt, mm, at most three layers.
[[nodiscard]] double skirt_width_mm(const LightSpread& spread, double layer_mm);

/// x where the core shows an even layer's difference y and the skirt has lost q.
[[nodiscard]] double seen_difference(double y, double q, double core);

/// Factor of the skirt's squared width where an even layer would lose e: 1 - 2.3 e, at least 0.2.
[[nodiscard]] double skirt_narrowing(double lost_even);

/// Part of the path through the untouched layer after which a line of sight first meets the skin: 1
/// where nothing presses. `depth_at(part)`: depth of the skin above the line there, in thicknesses;
/// `deepest`: none is larger.
template <class DepthAt>
[[nodiscard]] double meeting_part(const DepthAt& depth_at, double deepest);

/// b of the curve at a length along the face.
[[nodiscard]] double b_at(const LightSpread& spread, double along_mm, double cos_sight);

/// The difference at which the curve of `mapping` gives the depth that x means where b is `b_here`.
[[nodiscard]] double difference_on_curve(double x, double b_here, const MappingParameters& mapping);

/// Solves x for y on the face. The core's share is inverted cell by cell, once the skirt's is
/// known; that is the q for which both agree, found by Newton's method on waves. Detail that the
/// core hardly transmits is left weak instead of its noise being raised without limit: the core is
/// taken for larger there (core_for_removal()), as if (1 - core)^n of the detail were left after n
/// corrections (van Cittert). Before, what is finer than some tenths of a millimetre is smoothed
/// away. Then converts to the one curve of the mapping. Pixels without a measurement stay so. A
/// difference that was treated before, and a mapping with local light, change nothing.
void remove_light_spread(const MappingParameters& mapping, const FaceShape& shape,
                         Difference* difference);

/// What remove_light_spread() makes of a shallow wave of the skin, exp(i wave r): its gain and
/// phase. `displacement_mm`: SightInLayer. Without waves, and with local light, 1.
[[nodiscard]] std::complex<double> wave_after_removal(const LightSpread& spread, double layer_mm,
                                                      const Eigen::Vector2d& displacement_mm,
                                                      double cos_sight,
                                                      const Eigen::Vector2d& wave_per_mm);

/// The inverse, for simulated frames: what a face shows whose differences on the curve of
/// `mapping` are y. CV_64FC1, finite; without meaning off the face.
[[nodiscard]] cv::Mat with_light_spread(const cv::Mat& y, const MappingParameters& mapping,
                                        const FaceShape& shape);

template <class DepthAt>
double meeting_part(const DepthAt& depth_at, double deepest) {
  constexpr double kLongestStep = 0.1;
  constexpr double kHighest = 0.15;  // skin that bulges is not looked for further out
  const auto beyond = [&](double part) { return part - 1.0 + depth_at(part); };  // the skin
  double from = 1.0 - std::max(deepest, 0.0), before = beyond(from);
  if (before >= 0) return from;
  const double path = 1.0 + kHighest - from, steps = std::ceil(path / kLongestStep);
  const double step = path / steps;
  for (int i = 0; i < steps; ++i) {
    const double to = from + step, after = beyond(to);
    if (after >= 0) {
      const double between = from - before * step / (after - before), there = beyond(between);
      // Once more, in the half that holds the meeting.
      return there < 0 ? between - there * (to - between) / (after - there)
                       : from - before * (between - from) / (there - before);
    }
    from = to, before = after;
  }
  return 1.0 + kHighest;
}

}  // namespace alltact
