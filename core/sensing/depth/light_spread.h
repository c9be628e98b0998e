// Light that comes back next to where it went in.
//
// A translucent layer is translucent because it scatters. Part of the light of a pixel scattered
// once: it shows the skin where the line of sight meets it, the core. The rest was scattered
// several times and comes from up to some layer thicknesses around, the skirt. With d the depth of
// the skin along the normal, y(d) the brightness difference of an even layer as thin, and T the
// thickness,
//   x(p) = core y(d(p + (1 - d / T) u)) + (1 - core) q(p + s u)
// u is the displacement along the face from where a line of sight enters the layer to where it
// meets the untouched outer side: it meets a pressed skin sooner. q is the part of the skirt's
// light that the indentation swallows. That light walks along the face at random, and is lost
// where the layer is thinner,
//   q - width^2 laplace q = loss (1 - q),   loss = y / (1 - y),
// so that q is y on even layers, and around small indentations y's mean over K0(r / width). Light
// that one part of an indentation swallowed is not there for the next.
//
// All of it follows from one number, t = LightSpread::scattering. The formulas below were fitted to
// paths of light walked through layers of five thicknesses with isotropic scattering over a black
// outside, for five angles of sight and two of light, pressed by balls, cylinders and plates; they
// leave 0.002 to 0.009 of the untouched brightness (van de Hulst's similarity relates other phase
// functions to these). With m = 1 / cos(angle of sight in the layer) - 1,
//   core = exp(-t (1 + 0.47 m))     width = 0.63 / t^0.55 layers     s = 0.46 - 0.1 t
//
// DEPTH
// Even layers over black follow d = rho T (1 + b) y / (1 + b y) within 0.003 T up to 0.6 T for any
// angles of light and sight and optical thicknesses of 0.3 to 4. rho is 0.93 to 1.05 for wide
// indentations without absorption, and 0.8 to 0.9 for those that are as wide as the layer is thick.
// b grows with t, with the angle of light and with that of sight, about as 1 + 1.1 m.
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
  double b_factor = 1;     ///< of b for sight along the normal
};
/// `cos_sight`: between the line of sight and the normal, in the layer; limited to 0.3 and 1.
[[nodiscard]] ObliqueSpread oblique_spread(const LightSpread& spread, double cos_sight);

/// Width of the skirt, mm, at most three layers.
[[nodiscard]] double skirt_width_mm(const LightSpread& spread, double layer_mm);

/// The skirt's loss where an even layer would show y.
[[nodiscard]] double skirt_loss(double y);

/// Part of the path through the untouched layer after which a line of sight first meets the skin: 1
/// where nothing presses. `depth_at(part)`: depth of the skin above the line there, in thicknesses;
/// `deepest`: none is larger.
template <class DepthAt>
[[nodiscard]] double meeting_part(const DepthAt& depth_at, double deepest);

/// b of the curve at a length along the face.
[[nodiscard]] double b_at(const LightSpread& spread, double along_mm, double cos_sight);

/// The difference at which the curve of `mapping` gives the depth that x means where b is `b_here`.
[[nodiscard]] double difference_on_curve(double x, double b_here, const MappingParameters& mapping);

/// Solves x for y on the face, by some rounds of y += x - (what y would show) from y = x (van
/// Cittert): detail that the core hardly transmits is left weak instead of its noise being raised
/// without limit. Before, what is finer than some tenths of a millimetre is smoothed away. Then
/// converts to the one curve of the mapping. Pixels without a measurement stay so. A difference
/// that was treated before, and a mapping with local light, change nothing.
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
