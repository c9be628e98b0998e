// Light that comes back next to where it went in.
//
// A translucent layer is translucent because it scatters. Part of the light of a pixel scattered
// once: it shows the layer where the line of sight crosses it, the core. The rest was scattered
// several times and comes from up to some layer thicknesses around, the skirt. With y(p) the
// brightness difference that an even layer as thin as at p would show, and k * y its mean over the
// skirt,
//   x(p) = core y(p + c u) + (1 - core) (k * y)(p + s u)
// holds for any indentation within 0.5 to 2.5 % of x. u is the displacement along the face to where
// the line of sight meets the layer's outer side, and k the point response of diffusion with loss,
// K0(r / width) / (2 pi width^2), i.e. k * y solves q - width^2 laplace q = y.
//
// All of it follows from one number, t = LightSpread::scattering. The formulas below were fitted to
// paths of light walked through layers of five thicknesses with isotropic scattering over a black
// outside, for five angles of sight and two of light (van de Hulst's similarity relates other phase
// functions to these). With m = 1 / cos(angle of sight in the layer) - 1,
//   core  = exp(-t (1 + 0.2 m))                 width = 0.6 / sqrt(t) layers
//   c     = 0.85                                s     = 0.48 - 0.04 t^2 - 0.08 t m
//
// DEPTH
// Even layers over black follow d = rho T (1 + b) y / (1 + b y) within 0.003 T up to 0.6 T, T the
// thickness, for any angles of light and sight and optical thicknesses of 0.3 to 4. rho is 0.93 to
// 1.05 without absorption and 0.82 to 0.98 with 3 % of it: a layer pressed to nothing gives no
// light. b grows with t, with the angle of light and with that of sight, about as 1 + 1.1 m.
#pragma once

#include "core/finger/mapping.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/face/face_shape.h"

#include <Eigen/Core>

namespace alltact {

/// Spread for one angle of sight.
struct ObliqueSpread {
  double core = 1;         ///< part of the light, 0 to 1
  double core_shift = 0;   ///< c above
  double skirt_shift = 0;  ///< s above
  double b_factor = 1;     ///< of b for sight along the normal
};
/// `cos_sight`: between the line of sight and the normal, in the layer; limited to 0.3 and 1.
[[nodiscard]] ObliqueSpread oblique_spread(const LightSpread& spread, double cos_sight);

/// Width of the skirt, mm, at most three layers.
[[nodiscard]] double skirt_width_mm(const LightSpread& spread, double layer_mm);

/// Where a pixel's line of sight leads within the layer.
struct SightInLayer {
  Eigen::Vector2d displacement_mm;  ///< u above: along the face and across it
  double cos_sight = 1;
};
/// nullopt off the face.
[[nodiscard]] std::optional<SightInLayer> sight_in_layer(const FaceShape& shape, double u,
                                                         double v);

/// b of the curve at a length along the face.
[[nodiscard]] double b_at(const LightSpread& spread, double along_mm, double cos_sight);

/// The difference at which the curve of `mapping` gives the depth that x means where b is `b_here`.
[[nodiscard]] double difference_on_curve(double x, double b_here, const MappingParameters& mapping);

/// Solves x for y on the face, by five rounds of y += x - A y from y = x (van Cittert): detail that
/// the core hardly transmits is left weak instead of its noise being raised without limit. Before,
/// what is finer than some tenths of a millimetre is smoothed away. Then converts to the one curve
/// of the mapping. Pixels without a measurement stay so. A difference that was treated before, and
/// a mapping with local light, change nothing.
void remove_light_spread(const MappingParameters& mapping, const FaceShape& shape,
                         Difference* difference);

/// The inverse, for simulated frames: what a face shows whose differences on the curve of
/// `mapping` are y. CV_64FC1, finite; without meaning off the face.
[[nodiscard]] cv::Mat with_light_spread(const cv::Mat& y, const MappingParameters& mapping,
                                        const FaceShape& shape);

}  // namespace alltact
