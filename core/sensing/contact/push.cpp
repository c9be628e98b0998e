#include "core/sensing/contact/push.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace alltact {
namespace {

PushedFace face_towards(const Eigen::Vector2d& direction, bool base_at_low_u) {
  const double towards_tip = base_at_low_u ? direction.x() : -direction.x();
  if (std::abs(towards_tip) >= std::abs(direction.y()))
    return towards_tip > 0 ? PushedFace::kContact : PushedFace::kBack;
  return direction.y() > 0 ? PushedFace::kUpper : PushedFace::kLower;
}

}  // namespace

Eigen::MatrixXd displacement_covariance_px2(const Markers& markers,
                                            const std::optional<Eigen::MatrixXd>& now_px2) {
  double seen_square = 0, seen = 0;
  for (const Marker& marker : markers)
    if (marker.seen) seen_square += marker.sd_px * marker.sd_px, ++seen;
  const auto size = static_cast<Eigen::Index>(2 * markers.size());
  Eigen::MatrixXd covariance = now_px2 ? *now_px2 : Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index k = 0; k < size; ++k) {
    const Marker& marker = markers[static_cast<std::size_t>(k / 2)];
    const double own = marker.sd_px * marker.sd_px;
    if (!now_px2) covariance(k, k) += own;
    covariance(k, k) += marker.seen || seen == 0 ? own : seen_square / seen;
  }
  return covariance;
}

Push push_of(const Markers& markers, const ContactSettings& settings, bool base_at_low_u,
             const Eigen::MatrixXd& displacement_cov_px2) {
  Push result;
  const auto& rest = settings.rest_markers;
  if (markers.empty() || markers.size() != rest.size()) return result;
  for (std::size_t m = 0; m < markers.size(); ++m)
    result.offset_px += Eigen::Vector2d(markers[m].u, markers[m].v) - rest[m];
  const double length = result.offset_px.norm();
  if (!std::isfinite(length)) {
    result.offset_px.setZero();
    return result;
  }
  const Eigen::MatrixXd covariance = displacement_cov_px2.size() == 0
                                         ? displacement_covariance_px2(markers)
                                         : displacement_cov_px2;
  for (Eigen::Index i = 0; i < covariance.rows(); i += 2)
    for (Eigen::Index k = 0; k < covariance.cols(); k += 2)
      result.offset_covariance_px2 += covariance.block<2, 2>(i, k);
  if (!(length > settings.threshold_px && length > 0)) return result;
  const Eigen::Vector2d direction = result.offset_px / length;
  const Eigen::Vector2d across(-direction.y(), direction.x());
  result.direction = Eigen::Vector3d(direction.x(), direction.y(), 0.0);
  result.sd_deg = std::sqrt(across.dot(result.offset_covariance_px2 * across)) / length * 180.0 /
                  std::numbers::pi;
  result.face = face_towards(direction, base_at_low_u);
  return result;
}

namespace {

constexpr double kStep_mm = 0.25;         // of a mode, for its derivative
constexpr double kTwist_rad = 1e-3;       // for the same
constexpr double kMinDeterminant = 1e-6;  // smallest relative determinant that determines a line

std::optional<MiddleLine> line_of(const FaceShape& shape, double length_mm) {
  const double to_tip = shape.base_at_low_u() ? 1 : -1;
  MiddleLine line;
  double u = shape.base_at_low_u() ? 0 : shape.width_px() - 1.0;
  const double last = shape.base_at_low_u() ? shape.width_px() - 1.0 : 0;
  for (int k = 0; k <= kBeamCells; ++k) {
    const double s_mm = length_mm * k / kBeamCells;
    while (u != last && shape.length_at(u + to_tip) < s_mm) u += to_tip;
    const double here = shape.length_at(u), next = shape.length_at(u + to_tip);
    const double part = next > here ? std::clamp((s_mm - here) / (next - here), 0.0, 1.0) : 0.0;
    const auto middle = shape.middle_at(u + to_tip * part);
    if (!middle) return std::nullopt;
    line[static_cast<std::size_t>(k)] = {
        middle->point_mm.x(),
        middle->point_mm.z(),
        middle->point_mm.y(),
        std::atan2(to_tip * middle->tangent_z, to_tip * middle->tangent_x),
        {to_tip * middle->tangent_x, to_tip * middle->tangent_z}};
  }
  return line;
}

/// Pose at a length in cells; extrapolated straight beyond both ends.
LinePose pose_at(const MiddleLine& line, double cells, double cell_mm) {
  const double within = std::clamp(cells, 0.0, static_cast<double>(kBeamCells));
  const auto k = static_cast<std::size_t>(std::min(within, kBeamCells - 1e-9));
  const double part = within - static_cast<double>(k), beyond_mm = (cells - within) * cell_mm;
  const LinePose &a = line[k], &b = line[k + 1];
  LinePose pose{a.x + part * (b.x - a.x),
                a.z + part * (b.z - a.z),
                a.y + part * (b.y - a.y),
                a.theta + part * (b.theta - a.theta),
                {0, 0}};
  if (beyond_mm != 0) {
    pose.x += beyond_mm * std::cos(pose.theta);
    pose.z += beyond_mm * std::sin(pose.theta);
  }
  return pose;
}

/// Length at which a smooth function falls through 0, at most a cell beyond both ends. The function
/// is nearly linear over a cell, so that two secant steps suffice.
template <class Function>
double cells_where_zero(const Function& function) {
  double low = -1, high = kBeamCells + 1;
  while (high - low > 1.5) {
    const double middle = std::floor(0.5 * (low + high));
    (function(middle) > 0 ? low : high) = middle;
  }
  double at_low = function(low), at_high = function(high);
  double cells = low;
  for (int step = 0; step < 2; ++step) {
    cells = at_low > at_high ? low + (high - low) * at_low / (at_low - at_high) : low;
    cells = std::clamp(cells, low, high);
    const double here = function(cells);
    if (here > 0)
      low = cells, at_low = here;
    else
      high = cells, at_high = here;
  }
  return at_low > at_high ? std::clamp(low + (high - low) * at_low / (at_low - at_high), low, high)
                          : cells;
}

/// The line before the modes moved it.
MiddleLine unbent(const MiddleLine& now, const BeamModes& q_mm, double length_mm) {
  MiddleLine line = now;
  Eigen::Vector2d turned_before = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k <= kBeamCells; ++k) {
    const double t = static_cast<double>(k) / kBeamCells;
    LinePose& here = line[k];
    here.theta -= (2 * t * q_mm[0] + (3 * t * t - 2 * t) * q_mm[1]) / length_mm;
    here.y -= t * t * q_mm[2];
    // Integrates only the difference of the tangents, so that the seen shape stays exact.
    here.tangent = {std::cos(here.theta), std::sin(here.theta)};
    const Eigen::Vector2d turned = here.tangent - now[k].tangent;
    if (k > 0) {
      const Eigen::Vector2d step = 0.5 * length_mm / kBeamCells * (turned_before + turned);
      here.x = line[k - 1].x + now[k].x - now[k - 1].x + step.x();
      here.z = line[k - 1].z + now[k].z - now[k - 1].z + step.y();
    }
    turned_before = turned;
  }
  return line;
}

}  // namespace

double base_to_tip_mm(const FaceShape& shape) {
  return shape.length_at(shape.base_at_low_u() ? shape.width_px() - 1.0 : 0.0);
}

std::optional<BodyMarkers> BodyMarkers::create(const Markers& markers, const FaceShape& shape) {
  const double length_mm = base_to_tip_mm(shape);
  if (!(length_mm > 0)) return std::nullopt;
  const auto line = line_of(shape, length_mm);
  if (!line) return std::nullopt;
  BodyMarkers body(shape, length_mm);
  body.line_ = *line;
  body.positions_.resize(markers.size());
  body.find_setback(markers);
  for (std::size_t m = 0; m < markers.size(); ++m) body.locate(markers[m], body.positions_[m]);
  return body;
}

/// Distance of the markers behind the face: a line along the finger, fitted to where each ray meets
/// its side face. Each ray is weighted by how well it determines this point.
void BodyMarkers::find_setback(const Markers& markers) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t m = 0; m < markers.size(); ++m) {
    const auto middle = shape_->middle_at(markers[m].u);
    const auto ray = shape_->camera().unproject({markers[m].u, markers[m].v});
    if (!middle || !ray) continue;
    const double face_z = middle->point_mm.z(), ray_y = ray->point_at(face_z).y();
    positions_[m].is_known = true;
    positions_[m].side_mm =
        std::copysign(0.5 * shape_->face().width_mm, ray_y - middle->point_mm.y());
    const double y = middle->point_mm.y() + positions_[m].side_mm;
    const double z = ray->origin_mm.z() + (y - ray->origin_mm.y()) / ray->direction.y();
    if (!(z > 0.5 * face_z && z < 1.2 * face_z)) continue;  // the side face is seen edge on
    const Eigen::Vector3d at = ray->point_at(z);
    const double cells = foot_cells(at.x(), at.z());
    const LinePose foot = pose_at(line_, cells, length_mm_ / kBeamCells);
    const double off_mm =
        (at.x() - foot.x) * std::sin(foot.theta) - (at.z() - foot.z) * std::cos(foot.theta);
    const double weight = std::pow(y / (z * z), 2);
    const Eigen::Vector2d row(1.0, cells / kBeamCells - 0.5);
    normal += weight * row * row.transpose();
    right += weight * off_mm * row;
  }
  if (normal.determinant() > kMinDeterminant * normal(0, 0) * normal(0, 0))
    setback_mm_ = normal.inverse() * right;
  else if (normal(0, 0) > 0)
    setback_mm_ = {right[0] / normal(0, 0), 0};
}

/// Foot of the normal through a point.
double BodyMarkers::foot_cells(double x, double z) const {
  return cells_where_zero([&](double cells) {
    const LinePose at = pose_at(line_, cells, length_mm_ / kBeamCells);
    return (x - at.x) * std::cos(at.theta) + (z - at.z) * std::sin(at.theta);
  });
}

/// Position where the ray meets the row of markers, from its x alone: near the image's middle line
/// a ray runs along the side face.
void BodyMarkers::locate(const Marker& marker, BodyPosition& position) const {
  if (!position.is_known) return;
  const auto ray = shape_->camera().unproject({marker.u, marker.v});
  const double to_tip = shape_->base_at_low_u() ? 1 : -1;
  position.cells = cells_where_zero([&](double cells) {
    const double off = off_at(cells);
    const LinePose at = pose_at(line_, cells, length_mm_ / kBeamCells);
    const double x = at.x + off * std::sin(at.theta), z = at.z - off * std::cos(at.theta);
    return to_tip * (ray->point_at(z).x() - x);
  });
  position.off_mm = off_at(position.cells);
}

Eigen::Vector3d BodyMarkers::point_of(const BodyPosition& position, const MiddleLine& line) const {
  const LinePose at = pose_at(line, position.cells, length_mm_ / kBeamCells);
  return {at.x + position.off_mm * std::sin(at.theta), at.y + position.side_mm,
          at.z - position.off_mm * std::cos(at.theta)};
}

Eigen::VectorXd BodyMarkers::pixels_before(const BeamModes& q_mm) const {
  const MiddleLine line = unbent(line_, q_mm, length_mm_);
  Eigen::VectorXd seen = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * positions_.size()));
  for (std::size_t m = 0; m < positions_.size(); ++m) {
    if (!positions_[m].is_known) continue;
    if (const auto pixel = shape_->camera().project(point_of(positions_[m], line)))
      seen.segment<2>(static_cast<Eigen::Index>(2 * m)) = *pixel;
  }
  return seen;
}

Eigen::Matrix<double, Eigen::Dynamic, 3> BodyMarkers::motions_px(const BeamModes& q_mm) const {
  Eigen::Matrix<double, Eigen::Dynamic, 3> motions(2 * positions_.size(), 3);
  for (int mode = 0; mode < 3; ++mode) {
    const BeamModes step = kStep_mm * BeamModes::Unit(mode);
    motions.col(mode) = (pixels_before(q_mm + step) - pixels_before(q_mm - step)) / (2 * kStep_mm);
  }
  return motions;
}

Eigen::VectorXd BodyMarkers::twist_px() const {
  Eigen::VectorXd twist = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * positions_.size()));
  for (std::size_t m = 0; m < positions_.size(); ++m) {
    const BodyPosition& position = positions_[m];
    if (!position.is_known) continue;
    const double theta = pose_at(line_, position.cells, 0).theta;
    const Eigen::Vector3d back(std::sin(theta), 0, -std::cos(theta));
    const Eigen::Vector3d step =
        kTwist_rad * position.cells / kBeamCells *
        (position.off_mm * Eigen::Vector3d::UnitY() - position.side_mm * back);
    const Eigen::Vector3d point = point_of(position, line_);
    const auto after = shape_->camera().project(point + step);
    const auto before = shape_->camera().project(point - step);
    if (after && before)
      twist.segment<2>(static_cast<Eigen::Index>(2 * m)) = (*after - *before) / (2 * kTwist_rad);
  }
  return twist;
}

Eigen::Vector3d BodyMarkers::towards_back() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const BodyPosition& marker : positions_) {
    const double theta = pose_at(line_, marker.cells, 0).theta;
    sum += marker.cells * marker.cells * Eigen::Vector3d(std::sin(theta), 0, -std::cos(theta));
  }
  return sum.normalized();
}

namespace {

constexpr int kSteps = 4;  // each reduces the residual to a tenth
constexpr double kMinInformation =
    1e-6;                             // smallest share of the smaller of both motions' information
constexpr double kModelPart = 0.005;  // of the displacement: error of modes and face
// Prior of q2 / q1: -0.9 to -0.5 in an even beam that is pushed from its base to its tip, -1.3 to
// 0.1 in beams that taper to a quarter.
constexpr double kTypicalRatio = -0.6, kRatioSd = 0.6;

}  // namespace

std::optional<TipDisplacement> tip_displacement(const Markers& markers,
                                                const std::vector<Eigen::Vector2d>& rest,
                                                const FaceShape& shape,
                                                const Eigen::MatrixXd& displacement_cov_px2) {
  const auto size = static_cast<Eigen::Index>(2 * markers.size());
  if (markers.size() != rest.size() || markers.empty() || displacement_cov_px2.rows() != size)
    return std::nullopt;
  const auto body = BodyMarkers::create(markers, shape);
  if (!body) return std::nullopt;
  const Eigen::VectorXd now = body->pixels_before(BeamModes::Zero());
  const Eigen::MatrixXd motions = body->motions_px(BeamModes::Zero());
  Eigen::VectorXd displacements_px =
      Eigen::VectorXd::Zero(size);  // from the current positions back to rest
  for (std::size_t m = 0; m < markers.size(); ++m)
    if (body->positions()[m].is_known)
      displacements_px.segment<2>(static_cast<Eigen::Index>(2 * m)) =
          rest[m] - Eigen::Vector2d(markers[m].u, markers[m].v);
  const Eigen::LLT<Eigen::MatrixXd> noise(displacement_cov_px2);
  if (noise.info() != Eigen::Success || !displacements_px.allFinite() || !motions.allFinite())
    return std::nullopt;
  const Eigen::MatrixXd weighted = noise.solve(motions);
  const Eigen::Matrix3d measured = motions.transpose() * weighted;
  if (!(measured(0, 0) * measured(2, 2) - measured(0, 2) * measured(0, 2) >
        kMinInformation * measured(0, 0) * measured(2, 2)))
    return std::nullopt;

  const BeamModes prior(-kTypicalRatio, 1, 0);
  BeamModes q_mm = BeamModes::Zero();
  Eigen::Matrix3d information;
  Eigen::VectorXd left = displacements_px;
  for (int step = 0; step < kSteps; ++step) {
    const double displacement_mm = std::max(1.0, std::hypot(q_mm[0], q_mm[2]));
    const double prior_weight = 1 / std::pow(kRatioSd * displacement_mm, 2);
    information = measured + prior_weight * prior * prior.transpose();
    q_mm += information.inverse() *
            (weighted.transpose() * left - prior_weight * prior.dot(q_mm) * prior);
    left = displacements_px - (body->pixels_before(q_mm) - now);
    if (!q_mm.allFinite() || !left.allFinite()) return std::nullopt;
  }
  const Eigen::Matrix3d covariance = information.inverse();
  TipDisplacement result;
  result.displacement_mm = {-q_mm[0], q_mm[2]};
  result.covariance_mm2 << covariance(0, 0), -covariance(0, 2), -covariance(0, 2), covariance(2, 2);
  result.covariance_mm2 +=
      std::pow(kModelPart, 2) * result.displacement_mm.squaredNorm() * Eigen::Matrix2d::Identity();
  result.towards_back = body->towards_back();
  result.modes_mm = q_mm;
  return result;
}

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
double body_depth(double t) { return 0.28 - 0.18 * t; }

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
  const auto known = std::count_if(body->positions().begin(), body->positions().end(),
                                   [](const auto& p) { return p.is_known; });
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
