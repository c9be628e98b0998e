#include "core/sensing/contact/push_along.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kAlongPlaces = 47;
constexpr double kFirstAlong = 0.08, kAlongStep = 0.02;  // of the length
/// Parts of EI that fall: of ribs that carry 0.01 to 0.7 of the shear between walls of 4 mm, 30 mm
/// apart at the base.
constexpr std::array kFalls{0.67, 0.89, 0.971, 0.992};
constexpr double kTipDistance = 0.27;  // of the walls, by that at the base
constexpr std::array kDrags{-0.15, 0.0, 0.15};
constexpr double kBendScale_mm = 10.0;  // how far pushes bend a finger
constexpr double kModelSd = 0.03;       // of the length: fingers are no beams
// Bent further a finger folds, and nothing here holds any more: neither its modes nor its shape.
constexpr double kMostBend = 0.4;          // q1, of the length
constexpr double kMostTimesNoise = 100.0;  // squared, of what no bending explains

/// From the view face to the back, by the length.
double body_depth(double t) {
  return 0.28 - 0.18 * t;
}

/// K of q1 and q2, but for its scale.
Eigen::Matrix2d bending_stiffness(double falls) {
  // Gauss-Legendre with three places: exact for EI (w'')^2.
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

/// q2 / q1 of a push on the back at t that drags along the finger, too.
double share_of_modes(const Eigen::Matrix2d& stiffness, double t, double drag) {
  const double arm = drag * body_depth(t);
  const Eigen::Vector2d force(t * t + arm * 2 * t, t * t * (t - 1) + arm * t * (3 * t - 2));
  const Eigen::Vector2d q = stiffness.inverse() * force;
  return q[1] / q[0];
}

/// What the markers did, in units of its noise, with sway and twist taken out.
class BendingAlone {
 public:
  BendingAlone(const Eigen::MatrixXd& covariance_px2, const Eigen::MatrixXd& besides_px)
      : noise_(covariance_px2) {
    if (!is_told()) return;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(noise_.matrixL().solve(besides_px));
    besides_ = qr.householderQ() * Eigen::MatrixXd::Identity(besides_px.rows(), besides_px.cols());
  }
  [[nodiscard]] bool is_told() const { return noise_.info() == Eigen::Success; }
  [[nodiscard]] Eigen::VectorXd operator()(const Eigen::VectorXd& motion_px) const {
    const Eigen::VectorXd motion = noise_.matrixL().solve(motion_px);
    return motion - besides_ * (besides_.transpose() * motion);
  }

 private:
  Eigen::LLT<Eigen::MatrixXd> noise_;
  Eigen::MatrixXd besides_;
};

/// The log likelihood of each place, once for each of all that is not known.
using PlaceLogs = std::vector<std::array<double, kAlongPlaces>>;

std::optional<AlongFinger> mean_of(const PlaceLogs& logs, double length_mm) {
  double most = logs.front().front();
  for (const auto& of_places : logs)
    most = std::max(most, *std::max_element(of_places.begin(), of_places.end()));
  if (!std::isfinite(most)) return std::nullopt;
  double sum = 0, first = 0, second = 0;
  for (const auto& of_places : logs)
    for (std::size_t i = 0; i < of_places.size(); ++i) {
      const double weight = std::exp(of_places[i] - most);
      const double t = kFirstAlong + kAlongStep * static_cast<double>(i);
      sum += weight, first += weight * t, second += weight * t * t;
    }
  const double mean = first / sum;
  const double sd = std::sqrt(std::max(0.0, second / sum - mean * mean) + kModelSd * kModelSd);
  if (!(sd <= kMostAlongSd)) return std::nullopt;
  return AlongFinger{mean * length_mm, sd * length_mm};
}

}  // namespace

std::optional<AlongFinger> push_along_back(const Markers& markers,
                                           const std::vector<Eigen::Vector2d>& rest,
                                           const FaceShape& shape,
                                           const Eigen::MatrixXd& ways_px2,
                                           const TipWay& way) {
  const auto size = static_cast<Eigen::Index>(2 * markers.size());
  if (markers.size() != rest.size() || ways_px2.rows() != size) return std::nullopt;
  const auto body = BodyMarkers::create(markers, shape);
  if (!body) return std::nullopt;
  // As if the motions about where it rested were straight.
  const Eigen::MatrixXd motions = body->motions_px(way.modes_mm);
  Eigen::VectorXd ways_px = body->seen_before(BeamModes::Zero()) - body->seen_before(way.modes_mm) +
                            motions * way.modes_mm;
  for (std::size_t m = 0; m < markers.size(); ++m)
    if (body->places()[m].is_known)
      ways_px.segment<2>(static_cast<Eigen::Index>(2 * m)) +=
          rest[m] - Eigen::Vector2d(markers[m].u, markers[m].v);
  Eigen::MatrixXd besides(size, 2);
  besides << motions.col(2), body->twist_px();
  if (!ways_px.allFinite() || !motions.allFinite() || !besides.allFinite()) return std::nullopt;
  const BendingAlone alone(ways_px2, besides);
  if (!alone.is_told()) return std::nullopt;
  const Eigen::VectorXd did = alone(ways_px), q1 = alone(motions.col(0)),
                        q2 = alone(motions.col(1));
  // Where no place explains what the markers did, all are less sure by as much.
  Eigen::MatrixXd bends(size, 2);
  bends << q1, q2;
  const Eigen::Vector2d free_bends = bends.colPivHouseholderQr().solve(did);
  const double left = (did - bends * free_bends).squaredNorm();
  const auto known = std::count_if(
      body->places().begin(), body->places().end(), [](const auto& p) { return p.is_known; });
  const double free = 2.0 * static_cast<double>(known) - 4;  // sway, twist and both bends
  const double times_noise = free > 0 ? std::max(1.0, left / free) : 1.0;
  if (!(times_noise <= kMostTimesNoise) ||
      !(std::abs(free_bends[0]) <= kMostBend * body->length_mm()))
    return std::nullopt;
  PlaceLogs logs;
  for (const double falls : kFalls) {
    const Eigen::Matrix2d stiffness = bending_stiffness(falls);
    for (const double drag : kDrags) {
      auto& of_places = logs.emplace_back();
      for (std::size_t i = 0; i < of_places.size(); ++i) {
        const double t = kFirstAlong + kAlongStep * static_cast<double>(i);
        const Eigen::VectorXd push = q1 + share_of_modes(stiffness, t, drag) * q2;
        // Over all amplitudes, whose sd is kBendScale_mm before anything is seen.
        const double all = push.squaredNorm() + 1 / (kBendScale_mm * kBendScale_mm);
        of_places[i] = 0.5 * std::pow(push.dot(did), 2) / all / times_noise - 0.5 * std::log(all);
      }
    }
  }
  return mean_of(logs, body->length_mm());
}

}  // namespace alltact
