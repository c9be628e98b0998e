#include "calibration/reference/rest_pose.h"

#include "core/numerics/median.h"

#include <vector>

namespace alltact {

Eigen::Index middle_pose(const Eigen::MatrixXd& layouts) {
  Eigen::RowVectorXd middle(layouts.cols());
  for (Eigen::Index k = 0; k < layouts.cols(); ++k) {
    const Eigen::VectorXd column = layouts.col(k);
    std::vector<double> values(column.begin(), column.end());
    middle[k] = upper_median(values);
  }
  Eigen::Index nearest = 0;
  (layouts.rowwise() - middle).rowwise().squaredNorm().minCoeff(&nearest);
  return nearest;
}

}  // namespace alltact
