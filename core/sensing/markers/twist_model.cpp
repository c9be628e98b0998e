#include "core/sensing/markers/twist_model.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace alltact {
namespace {

constexpr Eigen::Index kTerms = FaceTwist::kTerms;
constexpr std::size_t kMinPairs = kTerms + 1;
constexpr double kMaxTurn = 0.7;       // of a pair in the image
constexpr double kSignificant = 16.3;  // chi squared with 3 degrees of freedom: 1 in 1000
constexpr double kSlopeReach = 0.02;   // fraction of the image's width, to both sides
constexpr double kMinSd = 2e-4;        // rad

double median_of(std::vector<double> values) { return upper_median(values); }

}  // namespace

/// A pair in one frame.
struct TwistModel::Lean {
  std::size_t pair = 0;
  double turn = 0;                   // of the pair in the image
  double sd = 0;                     // of the turn, from the dots' sd
  double t = 0;                      // position along the face, -1 to 1
  double by_twist = 0;               // turn per unit tangent of the twist
  double by_yaw = 0;                 // turn per unit yaw
  double slope = 0;                  // of the middle line from the edges: dy/ds
  Eigen::RowVector3d slope_by_term;  // change of the slope by each term of the twist
  [[nodiscard]] Eigen::RowVector3d terms() const { return FaceTwist::terms_at(t); }
};

namespace {

/// nullopt: one of them is not seen, or they are no pair.
std::optional<Eigen::Vector4d> directions_of(const Marker& upper, const Marker& lower,
                                             const FaceShape& shape) {
  if (!upper.seen || !lower.seen) return std::nullopt;
  const auto a = shape.direction_of({upper.u, upper.v}), b = shape.direction_of({lower.u, lower.v});
  if (!a || !b) return std::nullopt;
  const Eigen::Vector2d across = *b - *a;
  if (!(across.y() > 0.0) || std::abs(across.x()) > kMaxTurn * across.y()) return std::nullopt;
  return Eigen::Vector4d(a->x(), a->y(), b->x(), b->y());
}

}  // namespace

TwistModel::Leans TwistModel::leans_of(const Markers& markers, const FaceShape& shape) const {
  const double width_mm = shape.face().width_mm, half_mm = 0.5 * width_mm;
  const double reach_px = kSlopeReach * static_cast<double>(shape.width_px());
  // Offset of the middle line from the middle of the edges: h^2 twist / z.
  const auto lateral_offset = [&](const FaceShape::Middle& m) -> Eigen::RowVector3d {
    return half_mm * half_mm * m.tangent_x / m.point_mm.z() * FaceTwist::terms_at(m.t);
  };
  Leans leans;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (std::max(pairs_[i].upper, pairs_[i].lower) >= markers.size()) continue;
    const Marker &upper = markers[pairs_[i].upper], &lower = markers[pairs_[i].lower];
    const auto seen = directions_of(upper, lower, shape);
    if (!seen) continue;
    const Eigen::Vector2d across = seen->tail<2>() - seen->head<2>();
    const Eigen::Vector2d ray = 0.5 * (seen->tail<2>() + seen->head<2>());
    const double z_mm = width_mm / across.y();
    const auto foot = shape.foot_of(ray.x() * z_mm, z_mm);
    if (!foot) continue;
    const auto before = shape.middle_at(foot->u - reach_px);
    const auto after = shape.middle_at(foot->u + reach_px);
    if (!before || !after) continue;
    const Eigen::Vector3d chord_mm = after->point_mm - before->point_mm;
    const double ds = std::hypot(chord_mm.x(), chord_mm.z());
    if (!(ds > 0.0)) continue;
    const double sin = foot->tangent_z, cos = foot->tangent_x;
    Lean lean;
    lean.pair = i;
    lean.t = foot->t;
    lean.turn = -across.x() / across.y();
    lean.by_twist = sin + ray.x() * cos + lean.turn * ray.y() * cos;
    lean.by_yaw = cos - ray.x() * sin;
    lean.sd =
        std::hypot(upper.sd_px, lower.sd_px) / std::hypot(lower.v - upper.v, lower.u - upper.u);
    lean.slope = chord_mm.y() / ds;
    lean.slope_by_term = (lateral_offset(*after) - lateral_offset(*before)) / ds;
    leans.push_back(lean);
  }
  return leans;
}

std::optional<FaceTwist> TwistModel::fit(const Leans& leans) const {
  if (leans.size() < kMinPairs) return std::nullopt;
  const auto n = static_cast<Eigen::Index>(leans.size());
  Eigen::MatrixXd design(n, kTerms);
  Eigen::VectorXd target(n), weights = Eigen::VectorXd::Ones(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Lean& lean = leans[static_cast<std::size_t>(i)];
    const Pair& pair = pairs_[lean.pair];
    const double yaw = lean.by_yaw * yaw_per_slope_;
    const double sd = std::hypot(lean.sd, std::max(pair.sd, kMinSd));
    design.row(i) = (lean.by_twist * lean.terms() + yaw * lean.slope_by_term) / sd;
    target[i] = (lean.turn - lean.by_yaw * pair.offset - yaw * lean.slope) / sd;
  }
  // A weak prior of half a radian around zero twist stabilises the fit to few pairs.
  constexpr double kPriorRad = 0.5;
  const Eigen::Matrix3d prior = Eigen::Matrix3d::Identity() / (kPriorRad * kPriorRad);
  FaceTwist twist;
  twist.yaw_per_slope = yaw_per_slope_;
  Eigen::Matrix3d information;
  constexpr int kRounds = 4;
  constexpr double kHuber = 2.0;
  for (int round = 0; round < kRounds; ++round) {
    information = design.transpose() * weights.asDiagonal() * design + prior;
    const Eigen::LLT<Eigen::Matrix3d> factor(information);
    if (factor.info() != Eigen::Success) return std::nullopt;
    twist.coefficients = factor.solve(design.transpose() * weights.cwiseProduct(target));
    const Eigen::VectorXd residuals = target - design * twist.coefficients;
    for (Eigen::Index i = 0; i < n; ++i)
      weights[i] = std::min(1.0, kHuber / std::max(std::abs(residuals[i]), 1e-9));
  }
  twist.covariance = information.inverse();
  if (!twist.coefficients.allFinite() || !twist.covariance.allFinite()) return std::nullopt;
  return twist;
}

std::optional<FaceTwist> TwistModel::operator()(const Markers& markers,
                                                const FaceShape& shape) const {
  const Leans leans = leans_of(markers, shape);
  constexpr double kShorter = 1e-4;  // fraction of the width: a smaller change of z is negligible
  const bool sways = std::any_of(leans.begin(), leans.end(), [&](const Lean& lean) {
    const double yaw = yaw_per_slope_ * lean.slope;
    return 0.5 * yaw * yaw > kShorter;
  });
  auto twist = fit(leans);
  if (!twist) return std::nullopt;
  const double chi2 = twist->coefficients.dot(twist->covariance.inverse() * twist->coefficients);
  if (chi2 < kSignificant) {
    if (!sways) return std::nullopt;
    twist->coefficients.setZero();
  }
  return twist;
}

std::optional<FaceShape> TwistModel::twisted(const Markers& markers, const FaceShape& shape) const {
  // The turned shape gives a better position of the pairs along the face and a better slope there.
  const auto first = (*this)(markers, shape);
  const auto turned = first ? shape.twisted(*first) : std::nullopt;
  if (!turned) return std::nullopt;
  const auto second = (*this)(markers, *turned);
  auto result = second ? shape.twisted(*second) : std::nullopt;
  return result ? result : turned;
}

std::optional<TwistModel> TwistModel::learn(const std::vector<Pose>& recording) {
  TwistModel model;
  model.find_pairs(recording);
  std::vector<Leans> leans;
  for (const Pose& pose : recording) leans.push_back(model.leans_of(pose.markers, pose.shape));
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds; ++round) {
    if (!model.find_offsets(leans)) return std::nullopt;
    model.find_yaw(leans);
  }
  model.find_sd(leans);
  return model;
}

// Pairs are markers of both sides of the face that are each other's nearest along it.
void TwistModel::find_pairs(const std::vector<Pose>& recording) {
  if (recording.empty()) return;
  const std::size_t count = recording.front().markers.size();
  std::vector<double> u(count), v(count), below(count);
  for (std::size_t m = 0; m < count; ++m) {
    std::vector<double> us, vs;
    for (const Pose& pose : recording) {
      if (pose.markers.size() != count || !pose.markers[m].seen) continue;
      us.push_back(pose.markers[m].u), vs.push_back(pose.markers[m].v);
    }
    if (us.empty()) return;
    u[m] = median_of(us), v[m] = median_of(vs);
  }
  const double middle = median_of(v);
  const auto nearest = [&](std::size_t of) {
    std::size_t best = of;
    for (std::size_t m = 0; m < count; ++m)
      if ((v[m] < middle) != (v[of] < middle) &&
          (best == of || std::abs(u[m] - u[of]) < std::abs(u[best] - u[of])))
        best = m;
    return best;
  };
  for (std::size_t m = 0; m < count; ++m) {
    const std::size_t other = nearest(m);
    if (other != m && v[m] < v[other] && nearest(other) == m) pairs_.push_back({m, other, 0, 0});
  }
}

bool TwistModel::find_offsets(const std::vector<Leans>& recording) {
  std::vector<std::vector<double>> offsets(pairs_.size());
  for (const Leans& leans : recording)
    for (const Lean& lean : leans)
      offsets[lean.pair].push_back(lean.turn / lean.by_yaw - yaw_per_slope_ * lean.slope);
  std::size_t known = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    known += offsets[i].size() >= 2;
    pairs_[i].offset = median_of(std::move(offsets[i]));
  }
  return known >= kMinPairs;
}

// Splits the observed leans into twist and sway by the smallest sum of twists. Absolute values, not
// squares, let frames that only sway decide. Without sway the yaw cannot be determined and is 0.
void TwistModel::find_yaw(const std::vector<Leans>& recording) {
  constexpr double kRidge = 2e-3;     // rad: of negligible sway
  constexpr double kMinTwist = 2e-3;  // rad
  TwistModel straight = *this, turned = *this;
  straight.yaw_per_slope_ = 0, turned.yaw_per_slope_ = 1;
  // Without yaw; change with full yaw
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> twists;
  for (const Leans& leans : recording) {
    const auto without = straight.fit(leans), with = turned.fit(leans);
    if (without && with)
      twists.emplace_back(without->coefficients, with->coefficients - without->coefficients);
  }
  constexpr int kRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    double product = 0, square = 0;
    for (const auto& [twist, change] : twists) {
      const double weight = 1.0 / std::max(kMinTwist, (twist + yaw_per_slope_ * change).norm());
      product -= weight * change.dot(twist);
      square += weight * change.squaredNorm();
    }
    const double ridge = kRidge * static_cast<double>(twists.size());
    yaw_per_slope_ = std::clamp(product / (square + ridge), 0.0, 1.0);
  }
}

void TwistModel::find_sd(const std::vector<Leans>& recording) {
  std::vector<std::vector<double>> residuals(pairs_.size());
  for (const Leans& leans : recording) {
    const auto twist = fit(leans);
    if (!twist) continue;
    for (const Lean& lean : leans) {
      const double slope = lean.slope + lean.slope_by_term * twist->coefficients;
      const double predicted = lean.by_twist * twist->at(lean.t) +
                               lean.by_yaw * (yaw_per_slope_ * slope + pairs_[lean.pair].offset);
      residuals[lean.pair].push_back(std::abs(lean.turn - predicted));
    }
  }
  constexpr double kMadToSd = 1.4826;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const auto n = static_cast<double>(pairs_.size());
    // Correction for the degrees of freedom of the fit
    const double shared = std::sqrt(n / std::max(1.0, n - kTerms));
    pairs_[i].sd = kMadToSd * shared * median_of(std::move(residuals[i]));
  }
}

}  // namespace alltact
