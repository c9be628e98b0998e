#include "core/sensing/contact/body_markers.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace alltact {
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
  return {at.x + position.off_mm * std::sin(at.theta),
          at.y + position.side_mm,
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

}  // namespace alltact
