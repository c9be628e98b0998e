// Recorded layouts in which some markers were not seen.
#pragma once

#include <Eigen/Core>

namespace alltact {

/// layouts: one row a frame, (u0, v0, u1, ...), px; NaN where not seen. The rows that are complete
/// where these are plenty (40, and two thirds of the rows that show at least half of the markers)
/// or all there are. Else all rows that show at least half, their gaps filled by expectation and
/// maximisation: principal modes of all rows, and what they make of each row's seen markers, in
/// turn; then from the rows nearest to each (local_layout.h). A marker that is in none of these
/// rows leaves none of them usable. No rows when fewer than 2 are usable.
[[nodiscard]] Eigen::MatrixXd without_gaps(const Eigen::MatrixXd& layouts);

}  // namespace alltact
