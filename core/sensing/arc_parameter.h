// What smooth curves along the face are polynomials of.
#pragma once

#include <vector>

namespace alltact {

/// A parameter t that grows along the picture: dt/du = width(u)^-1.5. With the same width
/// everywhere it is the column itself, scaled to -1 .. 1, and what is a polynomial of the column
/// stays exact. How exact the widths are does not matter: any smooth growing function would do.
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
