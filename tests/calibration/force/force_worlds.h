// Fingers whose forces are known by formula: latent motions that move the markers, and beams.
#pragma once

#include "calibration/force/force_table.h"

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>

namespace alltact::made {

inline ForceTable empty_force_table(Eigen::Index rows, int markers, int axes) {
  ForceTable table;
  table.marker_count = markers, table.axes = axes;
  table.layouts = Eigen::MatrixXd::Zero(rows, 2 * markers);
  table.seen = Eigen::MatrixXd::Ones(rows, markers);
  table.force_N = Eigen::MatrixXd::Zero(rows, axes);
  return table;
}

/// Three latent motions t move 12 markers along straight lines; F = B t + bent * (t' C t). Each
/// block wanders on its own.
class LatentFinger {
 public:
  double bent = 0;  ///< 0: the truth is linear
  double noise_px = 0.05, noise_N = 0.05, hidden = 0;

  explicit LatentFinger(std::uint64_t seed) : random_(seed) {
    const auto drawn = [&](Eigen::Index rows, Eigen::Index columns, double sd) {
      Eigen::MatrixXd m(rows, columns);
      for (double& value : m.reshaped()) value = sd * normal_(random_);
      return m;
    };
    moves_ = drawn(2 * kMarkers, 3, 4.0);
    linear_ = drawn(2, 3, 1.0);
    for (Eigen::MatrixXd& curved : curved_) curved = drawn(3, 3, 0.4);
  }

  [[nodiscard]] std::vector<Eigen::Vector2d> rest() const {
    std::vector<Eigen::Vector2d> rest;
    for (int m = 0; m < kMarkers; ++m) rest.emplace_back(150 + 110 * (m % 6), m < 6 ? 120 : 420);
    return rest;
  }

  [[nodiscard]] ForceTable rows(int blocks, int rows_a_block) {
    ForceTable table = empty_force_table(blocks * rows_a_block, kMarkers, 2);
    const auto at_rest = rest();
    Eigen::Index row = 0;
    for (int block = 0; block < blocks; ++block) {
      Eigen::Vector3d t = draw3();
      for (int i = 0; i < rows_a_block; ++i, ++row) {
        t = 0.8 * t + 0.6 * draw3();  // variance 1, each row near the one before
        const Eigen::VectorXd d = moves_ * t;
        for (int m = 0; m < kMarkers; ++m) {
          table.seen(row, m) = uniform_(random_) < hidden ? 0 : 1;
          for (int k = 0; k < 2; ++k)
            table.layouts(row, 2 * m + k) =
                table.seen(row, m) * (at_rest[static_cast<std::size_t>(m)][k] + d[2 * m + k] +
                                      noise_px * normal_(random_));
        }
        table.force_N.row(row) = truth(t).transpose();
        for (double& force : table.force_N.row(row)) force += noise_N * normal_(random_);
        table.block.push_back("press " + std::to_string(block));
      }
    }
    return table;
  }

 private:
  static constexpr int kMarkers = 12;
  Eigen::Vector3d draw3() { return {normal_(random_), normal_(random_), normal_(random_)}; }
  [[nodiscard]] Eigen::Vector2d truth(const Eigen::Vector3d& t) const {
    return linear_ * t + bent * Eigen::Vector2d(t.dot(curved_[0] * t), t.dot(curved_[1] * t));
  }

  std::mt19937_64 random_;
  std::normal_distribution<double> normal_{0, 1};
  std::uniform_real_distribution<double> uniform_{0, 1};
  Eigen::MatrixXd moves_, linear_;
  std::array<Eigen::MatrixXd, 2> curved_;
};

/// A cantilever that leans away from the camera, pushed at one place along it, normal to its face
/// (Fx) and aside (Fy): Euler-Bernoulli deflection that stiffens with the square of itself, six
/// dots on either side, seen through a pinhole.
class BeamFinger {
 public:
  double noise_px = 0.1, noise_N = 0.03, hidden = 0.05;

  explicit BeamFinger(std::uint64_t seed) : random_(seed) {
    length_mm_ = between(60, 90), near_mm_ = between(25, 35), lean_ = between(0.5, 0.9);
    half_width_mm_ = between(10, 14);
    normal_mm_per_N_ = between(1.0, 2.5), aside_mm_per_N_ = between(0.6, 1.5);
    stiffens_ = between(0, 0.004);
  }

  [[nodiscard]] std::vector<Eigen::Vector2d> rest() const {
    std::vector<Eigen::Vector2d> rest;
    for (int m = 0; m < kMarkers; ++m) rest.push_back(seen(m, length_mm_, 0, 0));
    return rest;
  }

  /// Each block is a press at one place: in, aside, and out again.
  [[nodiscard]] ForceTable rows(int blocks, int rows_a_block) {
    ForceTable table = empty_force_table(blocks * rows_a_block, kMarkers, 2);
    table.position_mm = Eigen::MatrixXd::Zero(table.rows(), 2);
    Eigen::Index row = 0;
    for (int block = 0; block < blocks; ++block) {
      const double along_mm = between(0.45, 1.0) * length_mm_, most_N = between(1.5, 4.0);
      const double aside_N = between(-1.5, 1.5), phase = between(0, 2 * M_PI);
      for (int i = 0; i < rows_a_block; ++i, ++row) {
        const double part = static_cast<double>(i) / rows_a_block;
        const double fx = most_N * std::sin(M_PI * part);
        const double fy = aside_N * std::sin(2 * M_PI * part + phase);
        for (int m = 0; m < kMarkers; ++m) {
          const Eigen::Vector2d at = seen(m, along_mm, fx, fy);
          table.seen(row, m) = between(0, 1) < hidden ? 0 : 1;
          for (int k = 0; k < 2; ++k)
            table.layouts(row, 2 * m + k) =
                table.seen(row, m) * (at[k] + noise_px * normal_(random_));
        }
        table.force_N.row(row) << fx + noise_N * normal_(random_), fy + noise_N * normal_(random_);
        table.position_mm.row(row) << along_mm + 0.3 * normal_(random_), 0.3 * normal_(random_);
        table.block.push_back("press " + std::to_string(block));
      }
    }
    return table;
  }

 private:
  static constexpr int kMarkers = 12;
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  /// Of a tip that a force of 1 at `at` bends by 1 when `at` is the tip.
  [[nodiscard]] double deflection(double s, double at) const {
    const double near = std::min(s, at), far = std::max(s, at);
    return near * near * (3 * far - near) / (2 * std::pow(length_mm_, 3));
  }
  [[nodiscard]] double bent_mm(double s, double at, double force, double mm_per_N) const {
    const double linear = force * mm_per_N * deflection(s, at);
    const double tip = force * mm_per_N * deflection(length_mm_, at);
    return linear / (1 + stiffens_ * tip * tip);
  }
  [[nodiscard]] Eigen::Vector2d seen(int m, double at, double fx, double fy) const {
    constexpr double kFocalPx = 523.9;
    const double s = length_mm_ * (0.15 + 0.16 * (m % 6));
    const double w = bent_mm(s, at, fx, normal_mm_per_N_), a = bent_mm(s, at, fy, aside_mm_per_N_);
    const double x = -0.3 * length_mm_ + s * std::cos(lean_) - w * std::sin(lean_);
    const double z = near_mm_ + s * std::sin(lean_) + w * std::cos(lean_);
    const double y = (m < 6 ? -half_width_mm_ : half_width_mm_) + a;
    return {479.5 + kFocalPx * x / z, 269.5 + kFocalPx * y / z};
  }

  std::mt19937_64 random_;
  std::normal_distribution<double> normal_{0, 1};
  double length_mm_, near_mm_, lean_, half_width_mm_, normal_mm_per_N_, aside_mm_per_N_, stiffens_;
};

/// A few steps of a small network: for tests that ask nothing of it.
inline void make_network_quick(int& hidden_1, int& hidden_2, int& steps, int& members) {
  hidden_1 = hidden_2 = 2, steps = 5, members = 1;
}

}  // namespace alltact::made
