// What smooth curves along the face are polynomials of.
#pragma once

#include <vector>

namespace alltact {

/// A parameter t that grows along the picture nearly as the face's length does. Far off, a column
/// shows more of the face than nearby; as functions of the column the edges of a bent face are steep
/// there and no polynomial of a low degree, as functions of the length they are: of degree 7, edges
/// of a face that bends by 35 degrees are off by 0.5 px in the one.
///   dt/du = width(u)^-1.5, width: of the face in the picture, as z ~ 1 / width.
/// With the power 2 it would be the length where the face is a plane; 1.5 leaves 0.1 px of those
/// 0.5 px, and a plane's own straight edges are still polynomials of t to a millionth.
/// Any smooth growing function would do; how exact the widths are does not matter.
class ArcParameter {
 public:
  /// t = u: for a plane.
  ArcParameter() = default;
  /// width_px: of the face, > 0, by column; t is -1 at column `first` and 1 at `last`. Beyond both
  /// it goes on evenly.
  ArcParameter(const std::vector<double>& width_px, double first, double last);

  [[nodiscard]] double at(double u) const;
  [[nodiscard]] double slope_at(double u) const;  ///< dt/du, > 0

 private:
  [[nodiscard]] std::size_t cell_of(double u) const;

  std::vector<double> t_, slope_;  // by column
};

}  // namespace alltact
