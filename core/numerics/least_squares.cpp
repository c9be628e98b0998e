#include "core/numerics/least_squares.h"

#include <Eigen/QR>

namespace alltact {

Eigen::VectorXd least_squares(const Eigen::MatrixXd& design, const Eigen::VectorXd& target) {
  return design.householderQr().solve(target);
}

}  // namespace alltact
