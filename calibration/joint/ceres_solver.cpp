#include "calibration/joint/ceres_solver.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <Eigen/Dense>

namespace alltact {
CompressedCost::CompressedCost(std::unique_ptr<ceres::CostFunction> full) : full_(std::move(full)) {
  *mutable_parameter_block_sizes() = full_->parameter_block_sizes();
  for (const int size : parameter_block_sizes()) columns_ += size;
  set_num_residuals(columns_ + 1);
}

bool CompressedCost::Evaluate(double const* const* parameters, double* residuals,
                              double** jacobians) const {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const int rows = full_->num_residuals();
  Eigen::Map<Eigen::VectorXd> few(residuals, num_residuals());
  Eigen::VectorXd many(rows);
  if (jacobians == nullptr) {
    if (!full_->Evaluate(parameters, many.data(), nullptr)) return false;
    few.setZero();
    few[columns_] = many.norm();
    return true;
  }
  const std::vector<int>& sizes = parameter_block_sizes();
  std::vector<RowMajor> parts(sizes.size());
  std::vector<double*> pointers(sizes.size(), nullptr);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (jacobians[i] == nullptr) continue;  // held constant
    parts[i].resize(rows, sizes[i]);
    pointers[i] = parts[i].data();
  }
  if (!full_->Evaluate(parameters, many.data(), pointers.data())) return false;
  // Constant blocks stay zero columns. A block with fewer samples than columns gets zero rows.
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(std::max(rows, num_residuals()), num_residuals());
  for (std::size_t i = 0, column = 0; i < sizes.size();
       column += static_cast<std::size_t>(sizes[i++]))
    if (jacobians[i] != nullptr)
      all.block(0, static_cast<Eigen::Index>(column), rows, sizes[i]) = parts[i];
  all.col(columns_).head(rows) = many;
  const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(all);
  const Eigen::MatrixXd upper =
      qr.matrixQR().topRows(num_residuals()).triangularView<Eigen::Upper>();
  few = upper.col(columns_);
  for (std::size_t i = 0, column = 0; i < sizes.size();
       column += static_cast<std::size_t>(sizes[i++]))
    if (jacobians[i] != nullptr)
      Eigen::Map<RowMajor>(jacobians[i], num_residuals(), sizes[i]) =
          upper.middleCols(static_cast<Eigen::Index>(column), sizes[i]);
  return true;
}

}  // namespace alltact
