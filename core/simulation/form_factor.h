// How much of what a point sees is a given polygon.
#pragma once

#include <array>

#include <Eigen/Core>

namespace alltact {

using Quadrilateral = std::array<Eigen::Vector3d, 4>;

/// Form factor from a small area at `point` with unit normal `normal` to a quadrilateral, 0..1:
/// what it lights the point with, as a share of its radiosity. By Lambert's formula,
///   F = 1 / (2 pi) sum over edges of angle_k (normal . (r_k+1 x r_k) / |r_k+1 x r_k|),
/// r_k from the point to the corners and angle_k between two of them (J. H. Lambert, "Photometria",
/// 1760; used for radiosity by D. Baum, H. Rushmeier and J. Winget, SIGGRAPH 1989), exact at any
/// distance. What lies behind the point's own plane is cut off. Corners go round counter-clockwise
/// as seen from the lit side; from behind it is 0. Any unit of length.
[[nodiscard]] double form_factor(const Eigen::Vector3d& point,
                                 const Eigen::Vector3d& normal,
                                 const Quadrilateral& corners);

}  // namespace alltact
