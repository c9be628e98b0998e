#include "core/sensing/contact/tip_way.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kCells = 24;            // along the finger
constexpr double kStep_mm = 0.25;     // of a mode, for its derivative
constexpr int kSteps = 4;             // each leaves a tenth of what is left
constexpr double kWellTold = 1e-6;    // least share of the smaller of both motions' information
constexpr double kModelPart = 0.005;  // of the way, that modes and face leave
// Of q2 by q1: -0.9 to -0.5 in an even beam that is pushed from its base to its tip, -1.3 to 0.1 in
// ones that taper to a quarter.
constexpr double kUsualRatio = -0.6, kRatioSd = 0.6;

using Modes = Eigen::Vector3d;  // q1, q2, q3, mm

/// A place of the middle line, in the x-z plane and in y, and its slope there.
struct LinePlace {
  double x = 0, z = 0, y = 0, theta = 0;
  Eigen::Vector2d tangent = Eigen::Vector2d::Zero();  // of the line's own places alone
};

/// The middle line in even steps of its length, from base to tip.
using Line = std::array<LinePlace, kCells + 1>;

double whole_length_mm(const FaceShape& shape) {
  return shape.length_at(shape.base_at_low_u() ? shape.width_px() - 1.0 : 0.0);
}

std::optional<Line> line_of(const FaceShape& shape, double length_mm) {
  const double to_tip = shape.base_at_low_u() ? 1 : -1;
  Line line;
  double u = shape.base_at_low_u() ? 0 : shape.width_px() - 1.0;
  const double last = shape.base_at_low_u() ? shape.width_px() - 1.0 : 0;
  for (int k = 0; k <= kCells; ++k) {
    const double s_mm = length_mm * k / kCells;
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

/// At a length in cells; straight on beyond both ends.
LinePlace place_at(const Line& line, double cells, double cell_mm) {
  const double within = std::clamp(cells, 0.0, static_cast<double>(kCells));
  const auto k = static_cast<std::size_t>(std::min(within, kCells - 1e-9));
  const double part = within - static_cast<double>(k), beyond_mm = (cells - within) * cell_mm;
  const LinePlace &a = line[k], &b = line[k + 1];
  LinePlace place{a.x + part * (b.x - a.x),
                  a.z + part * (b.z - a.z),
                  a.y + part * (b.y - a.y),
                  a.theta + part * (b.theta - a.theta),
                  {0, 0}};
  if (beyond_mm != 0) {
    place.x += beyond_mm * std::cos(place.theta);
    place.z += beyond_mm * std::sin(place.theta);
  }
  return place;
}

/// Where along the finger a smooth function falls through 0; beyond both ends a cell at most. Even
/// over a cell, so that the chord's place is near enough twice.
template <class Function>
double cells_where_zero(const Function& function) {
  double low = -1, high = kCells + 1;
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
Line unbent(const Line& now, const Modes& q_mm, double length_mm) {
  Line line = now;
  Eigen::Vector2d turned_before = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k <= kCells; ++k) {
    const double t = static_cast<double>(k) / kCells;
    LinePlace& here = line[k];
    here.theta -= (2 * t * q_mm[0] + (3 * t * t - 2 * t) * q_mm[1]) / length_mm;
    here.y -= t * t * q_mm[2];
    // Only what is turned is summed up, so that nothing is lost of where it was seen.
    here.tangent = {std::cos(here.theta), std::sin(here.theta)};
    const Eigen::Vector2d turned = here.tangent - now[k].tangent;
    if (k > 0) {
      const Eigen::Vector2d step = 0.5 * length_mm / kCells * (turned_before + turned);
      here.x = line[k - 1].x + now[k].x - now[k - 1].x + step.x();
      here.z = line[k - 1].z + now[k].z - now[k - 1].z + step.y();
    }
    turned_before = turned;
  }
  return line;
}

/// A marker's place in the finger.
struct BodyPlace {
  bool is_known = false;
  double cells = 0;    // along the finger
  double side_mm = 0;  // from the middle line, in y
  double off_mm = 0;   // behind the face
};

/// The markers in the finger, and where a bend makes them lie.
class BodyMarkers {
 public:
  BodyMarkers(const Markers& markers, const FaceShape& shape, const Line& line, double length_mm)
      : shape_(shape), line_(line), length_mm_(length_mm), places_(markers.size()) {
    find_setback(markers);
    for (std::size_t m = 0; m < markers.size(); ++m) place(markers[m], places_[m]);
  }

  [[nodiscard]] const std::vector<BodyPlace>& places() const { return places_; }

  /// Picture places of all markers; 0 of those that lie nowhere.
  [[nodiscard]] Eigen::VectorXd seen_before(const Modes& q_mm) const {
    const Line line = unbent(line_, q_mm, length_mm_);
    Eigen::VectorXd seen = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * places_.size()));
    for (std::size_t m = 0; m < places_.size(); ++m) {
      if (!places_[m].is_known) continue;
      const LinePlace at = place_at(line, places_[m].cells, length_mm_ / kCells);
      const Eigen::Vector3d point(at.x + places_[m].off_mm * std::sin(at.theta),
                                  at.y + places_[m].side_mm,
                                  at.z - places_[m].off_mm * std::cos(at.theta));
      if (const auto pixel = shape_.camera().project(point))
        seen.segment<2>(static_cast<Eigen::Index>(2 * m)) = *pixel;
    }
    return seen;
  }

 private:
  /// Where a marker's ray meets the side face it lies on, told to be this far along and behind;
  /// weighted by how well its ray tells that. A line along the finger through all of them.
  void find_setback(const Markers& markers) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (std::size_t m = 0; m < markers.size(); ++m) {
      const auto middle = shape_.middle_at(markers[m].u);
      const auto ray = shape_.camera().unproject({markers[m].u, markers[m].v});
      if (!middle || !ray) continue;
      const double face_z = middle->point_mm.z(), ray_y = ray->point_at(face_z).y();
      places_[m].is_known = true;
      places_[m].side_mm =
          std::copysign(0.5 * shape_.face().width_mm, ray_y - middle->point_mm.y());
      const double y = middle->point_mm.y() + places_[m].side_mm;
      const double z = ray->origin_mm.z() + (y - ray->origin_mm.y()) / ray->direction.y();
      if (!(z > 0.5 * face_z && z < 1.2 * face_z)) continue;  // the side face is seen edge on
      const Eigen::Vector3d at = ray->point_at(z);
      const double cells = foot_cells(at.x(), at.z());
      const LinePlace foot = place_at(line_, cells, length_mm_ / kCells);
      const double off_mm =
          (at.x() - foot.x) * std::sin(foot.theta) - (at.z() - foot.z) * std::cos(foot.theta);
      const double weight = std::pow(y / (z * z), 2);
      const Eigen::Vector2d row(1.0, cells / kCells - 0.5);
      normal += weight * row * row.transpose();
      right += weight * off_mm * row;
    }
    if (normal.determinant() > kWellTold * normal(0, 0) * normal(0, 0))
      setback_mm_ = normal.inverse() * right;
    else if (normal(0, 0) > 0)
      setback_mm_ = {right[0] / normal(0, 0), 0};
  }

  /// Of the normal through a point.
  [[nodiscard]] double foot_cells(double x, double z) const {
    return cells_where_zero([&](double cells) {
      const LinePlace at = place_at(line_, cells, length_mm_ / kCells);
      return (x - at.x) * std::cos(at.theta) + (z - at.z) * std::sin(at.theta);
    });
  }

  /// Where the ray meets the row, by its x alone: near its own side of the picture's middle a ray
  /// runs along the side face.
  void place(const Marker& marker, BodyPlace& place) const {
    if (!place.is_known) return;
    const auto ray = shape_.camera().unproject({marker.u, marker.v});
    const double to_tip = shape_.base_at_low_u() ? 1 : -1;
    place.cells = cells_where_zero([&](double cells) {
      const double off = off_at(cells);
      const LinePlace at = place_at(line_, cells, length_mm_ / kCells);
      const double x = at.x + off * std::sin(at.theta), z = at.z - off * std::cos(at.theta);
      return to_tip * (ray->point_at(z).x() - x);
    });
    place.off_mm = off_at(place.cells);
  }
  [[nodiscard]] double off_at(double cells) const {
    return setback_mm_[0] + setback_mm_[1] * (cells / kCells - 0.5);
  }

  const FaceShape& shape_;
  const Line& line_;
  double length_mm_;
  std::vector<BodyPlace> places_;
  Eigen::Vector2d setback_mm_ = Eigen::Vector2d::Zero();
};

/// Unit, at the places of the markers on average, by their share in the tip's way.
Eigen::Vector3d towards_back(const Line& line, const std::vector<BodyPlace>& places) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const BodyPlace& marker : places) {
    const double theta = place_at(line, marker.cells, 0).theta;
    sum += marker.cells * marker.cells * Eigen::Vector3d(std::sin(theta), 0, -std::cos(theta));
  }
  return sum.normalized();
}

}  // namespace

std::optional<TipWay> tip_way(const Markers& markers,
                              const std::vector<Eigen::Vector2d>& rest,
                              const FaceShape& shape,
                              const Eigen::MatrixXd& ways_px2) {
  const double length_mm = whole_length_mm(shape);
  const auto size = static_cast<Eigen::Index>(2 * markers.size());
  if (markers.size() != rest.size() || markers.empty() || ways_px2.rows() != size ||
      !(length_mm > 0))
    return std::nullopt;
  const auto line = line_of(shape, length_mm);
  if (!line) return std::nullopt;
  const BodyMarkers body(markers, shape, *line, length_mm);
  const Eigen::VectorXd now = body.seen_before(Modes::Zero());
  Eigen::MatrixXd motions(size, 3);
  for (int mode = 0; mode < 3; ++mode) {
    const Modes step = kStep_mm * Modes::Unit(mode);
    motions.col(mode) = (body.seen_before(step) - body.seen_before(-step)) / (2 * kStep_mm);
  }
  Eigen::VectorXd ways = Eigen::VectorXd::Zero(size);  // back to rest
  for (std::size_t m = 0; m < markers.size(); ++m)
    if (body.places()[m].is_known)
      ways.segment<2>(static_cast<Eigen::Index>(2 * m)) =
          rest[m] - Eigen::Vector2d(markers[m].u, markers[m].v);
  const Eigen::LLT<Eigen::MatrixXd> noise(ways_px2);
  if (noise.info() != Eigen::Success || !ways.allFinite() || !motions.allFinite())
    return std::nullopt;
  const Eigen::MatrixXd weighted = noise.solve(motions);
  const Eigen::Matrix3d told = motions.transpose() * weighted;
  if (!(told(0, 0) * told(2, 2) - told(0, 2) * told(0, 2) > kWellTold * told(0, 0) * told(2, 2)))
    return std::nullopt;

  const Modes usual(-kUsualRatio, 1, 0);
  Modes q_mm = Modes::Zero();
  Eigen::Matrix3d information;
  Eigen::VectorXd left = ways;
  for (int step = 0; step < kSteps; ++step) {
    const double way_mm = std::max(1.0, std::hypot(q_mm[0], q_mm[2]));
    const double believed = 1 / std::pow(kRatioSd * way_mm, 2);
    information = told + believed * usual * usual.transpose();
    q_mm +=
        information.inverse() * (weighted.transpose() * left - believed * usual.dot(q_mm) * usual);
    left = ways - (body.seen_before(q_mm) - now);
    if (!q_mm.allFinite() || !left.allFinite()) return std::nullopt;
  }
  const Eigen::Matrix3d covariance = information.inverse();
  TipWay result;
  result.way_mm = {-q_mm[0], q_mm[2]};
  result.covariance_mm2 << covariance(0, 0), -covariance(0, 2), -covariance(0, 2), covariance(2, 2);
  result.covariance_mm2 +=
      std::pow(kModelPart, 2) * result.way_mm.squaredNorm() * Eigen::Matrix2d::Identity();
  result.towards_back = towards_back(*line, body.places());
  return result;
}

}  // namespace alltact
