// The fraction of a point's view that a polygon fills.
#pragma once

#include <array>

#include <Eigen/Core>

namespace alltact {

using Quadrilateral = std::array<Eigen::Vector3d, 4>;

/// Form factor from a small area at `point` with unit normal `normal` to a quadrilateral, 0..1: the
/// polygon's light at the point, as a share of its radiosity. By Lambert's formula,
///   F = 1 / (2 pi) sum over edges of angle_k (normal . (r_k+1 x r_k) / |r_k+1 x r_k|),
/// r_k from the point to the corners and angle_k between two of them (J. H. Lambert, "Photometria",
/// 1760; used for radiosity by D. Baum, H. Rushmeier and J. Winget, SIGGRAPH 1989). It is exact at
/// any distance. The part behind the point's own plane is clipped. Corners run counter-clockwise as
/// viewed from the lit side; from behind it is 0. Any unit of length.
[[nodiscard]] double form_factor(const Eigen::Vector3d& point,
                                 const Eigen::Vector3d& normal,
                                 const Quadrilateral& corners);

}  // namespace alltact
