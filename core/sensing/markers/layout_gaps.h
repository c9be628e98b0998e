// Completes recorded layouts in which some markers were not seen.
#pragma once

#include <Eigen/Core>

namespace alltact {

/// layouts: one row a frame, (u0, v0, u1, ...), px; NaN where not seen. Returns the complete rows
/// where these suffice: 40, and two thirds of the rows that show at least half of the markers, or
/// all rows. Otherwise returns all rows that show at least half, with filled gaps. Expectation
/// maximisation fills them: principal modes of all rows and their fit to each row's seen markers
/// alternate. Then the rows nearest to each refine them (local_layout.h). Returns no rows when
/// fewer than 2 are usable, or when a marker is in none of them.
[[nodiscard]] Eigen::MatrixXd without_gaps(const Eigen::MatrixXd& layouts);

}  // namespace alltact
