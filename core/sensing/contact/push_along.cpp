#include "core/sensing/contact/push_along.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kPositions = 47;
constexpr double kFirstAlong = 0.08, kAlongStep = 0.02;  // of the length
/// Fractions of EI that fall: for ribs that carry 0.01 to 0.7 of the shear between walls of 4 mm,
/// 30 mm apart at the base.
constexpr std::array kFalls{0.67, 0.89, 0.971, 0.992};
constexpr double kTipDistance = 0.27;  // of the walls, relative to the base
constexpr std::array kDrags{-0.15, 0.0, 0.15};
constexpr double kBendScale_mm = 10.0;  // typical deflection of a finger
constexpr double kModelSd = 0.03;       // of the length: fingers are not exactly beams
// Beyond these limits a finger folds, and neither its modes nor its shape apply.
constexpr double kMaxBend = 0.4;          // q1, of the length
constexpr double kMaxNoiseRatio = 100.0;  // squared, of the residual without bending

/// From the view face to the back, relative to the length.
double body_depth(double t) {
  return 0.28 - 0.18 * t;
}

/// K of q1 and q2, up to its scale.
Eigen::Matrix2d bending_stiffness(double falls) {
  // Gauss-Legendre with three nodes: exact for EI (w'')^2.
  constexpr std::array<double, 3> kAt{0.1127016653792583, 0.5, 0.8872983346207417};
  constexpr std::array<double, 3> kWeight{5.0 / 18, 8.0 / 18, 5.0 / 18};
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < kAt.size(); ++i) {
    const double t = kAt[i], distance = 1 - (1 - kTipDistance) * t;
    const Eigen::Vector2d curvature(2, 6 * t - 2);
    stiffness +=
        kWeight[i] * (1 - falls + falls * distance * distance) * curvature * curvature.transpose();
  }
  return stiffness;
}

/// q2 / q1 of a push on the back at t with a drag along the finger.
double share_of_modes(const Eigen::Matrix2d& stiffness, double t, double drag) {
  const double arm = drag * body_depth(t);
  const Eigen::Vector2d force(t * t + arm * 2 * t, t * t * (t - 1) + arm * t * (3 * t - 2));
  const Eigen::Vector2d q = stiffness.inverse() * force;
  return q[1] / q[0];
}

/// Whitened marker motion, projected to remove sway and twist.
class BendingPart {
 public:
  BendingPart(const Eigen::MatrixXd& covariance_px2, const Eigen::MatrixXd& nuisance_px)
      : noise_(covariance_px2) {
    if (!is_valid()) return;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(noise_.matrixL().solve(nuisance_px));
    nuisance_ =
        qr.householderQ() * Eigen::MatrixXd::Identity(nuisance_px.rows(), nuisance_px.cols());
  }
  [[nodiscard]] bool is_valid() const { return noise_.info() == Eigen::Success; }
  [[nodiscard]] Eigen::VectorXd operator()(const Eigen::VectorXd& motion_px) const {
    const Eigen::VectorXd motion = noise_.matrixL().solve(motion_px);
    return motion - nuisance_ * (nuisance_.transpose() * motion);
  }

 private:
  Eigen::LLT<Eigen::MatrixXd> noise_;
  Eigen::MatrixXd nuisance_;
};

/// The log likelihood of each position, for each combination of the unknown parameters.
using PositionLogs = std::vector<std::array<double, kPositions>>;

std::optional<AlongFinger> mean_of(const PositionLogs& logs, double length_mm) {
  double best_log = logs.front().front();
  for (const auto& by_position : logs)
    best_log = std::max(best_log, *std::max_element(by_position.begin(), by_position.end()));
  if (!std::isfinite(best_log)) return std::nullopt;
  double sum = 0, first = 0, second = 0;
  for (const auto& by_position : logs)
    for (std::size_t i = 0; i < by_position.size(); ++i) {
      const double weight = std::exp(by_position[i] - best_log);
      const double t = kFirstAlong + kAlongStep * static_cast<double>(i);
      sum += weight, first += weight * t, second += weight * t * t;
    }
  const double mean = first / sum;
  const double sd = std::sqrt(std::max(0.0, second / sum - mean * mean) + kModelSd * kModelSd);
  if (!(sd <= kMaxAlongSd)) return std::nullopt;
  return AlongFinger{mean * length_mm, sd * length_mm};
}

}  // namespace

std::optional<AlongFinger> push_along_back(const Markers& markers,
                                           const std::vector<Eigen::Vector2d>& rest,
                                           const FaceShape& shape,
                                           const Eigen::MatrixXd& displacement_cov_px2,
                                           const TipDisplacement& displacement) {
  const auto size = static_cast<Eigen::Index>(2 * markers.size());
  if (markers.size() != rest.size() || displacement_cov_px2.rows() != size) return std::nullopt;
  const auto body = BodyMarkers::create(markers, shape);
  if (!body) return std::nullopt;
  // Linearised about the rest position.
  const Eigen::MatrixXd motions = body->motions_px(displacement.modes_mm);
  Eigen::VectorXd displacements_px = body->pixels_before(BeamModes::Zero()) -
                                     body->pixels_before(displacement.modes_mm) +
                                     motions * displacement.modes_mm;
  for (std::size_t m = 0; m < markers.size(); ++m)
    if (body->positions()[m].is_known)
      displacements_px.segment<2>(static_cast<Eigen::Index>(2 * m)) +=
          rest[m] - Eigen::Vector2d(markers[m].u, markers[m].v);
  Eigen::MatrixXd nuisance(size, 2);
  nuisance << motions.col(2), body->twist_px();
  if (!displacements_px.allFinite() || !motions.allFinite() || !nuisance.allFinite())
    return std::nullopt;
  const BendingPart bending(displacement_cov_px2, nuisance);
  if (!bending.is_valid()) return std::nullopt;
  const Eigen::VectorXd observed = bending(displacements_px), q1 = bending(motions.col(0)),
                        q2 = bending(motions.col(1));
  // The residual of the best bending scales the noise.
  Eigen::MatrixXd bends(size, 2);
  bends << q1, q2;
  const Eigen::Vector2d free_bends = bends.colPivHouseholderQr().solve(observed);
  const double left = (observed - bends * free_bends).squaredNorm();
  const auto known = std::count_if(
      body->positions().begin(), body->positions().end(), [](const auto& p) { return p.is_known; });
  const double free = 2.0 * static_cast<double>(known) - 4;  // sway, twist and both bends
  const double times_noise = free > 0 ? std::max(1.0, left / free) : 1.0;
  if (!(times_noise <= kMaxNoiseRatio) ||
      !(std::abs(free_bends[0]) <= kMaxBend * body->length_mm()))
    return std::nullopt;
  PositionLogs logs;
  for (const double falls : kFalls) {
    const Eigen::Matrix2d stiffness = bending_stiffness(falls);
    for (const double drag : kDrags) {
      auto& by_position = logs.emplace_back();
      for (std::size_t i = 0; i < by_position.size(); ++i) {
        const double t = kFirstAlong + kAlongStep * static_cast<double>(i);
        const Eigen::VectorXd push = q1 + share_of_modes(stiffness, t, drag) * q2;
        // Marginalised over all amplitudes, whose prior sd is kBendScale_mm.
        const double all = push.squaredNorm() + 1 / (kBendScale_mm * kBendScale_mm);
        by_position[i] =
            0.5 * std::pow(push.dot(observed), 2) / all / times_noise - 0.5 * std::log(all);
      }
    }
  }
  return mean_of(logs, body->length_mm());
}

}  // namespace alltact
