#include "core/sensing/contact/finger_contact.h"

#include "core/sensing/contact/contact_frame.h"
#include "core/sensing/contact/contact_state.h"
#include "core/sensing/contact/face_touch.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kStep_mm = 0.5;    // of what moves in the picture; straight enough over that
constexpr double kWellTold = 1e-6;  // least share of the smaller of both motions' information

double whole_length_mm(const FaceShape& shape) {
  return shape.length_at(shape.base_at_low_u() ? shape.width_px() - 1.0 : 0.0);
}

// A marker's part in the two motions.
struct MarkerMotion {
  Eigen::Matrix2d px_per_mm;  // of the tip: towards the back, aside
  Eigen::Vector3d towards_back;
  double share;  // of the tip's way
};

Eigen::Vector3d at_depth(const Ray& ray, double z_mm) {
  return ray.origin_mm + (z_mm - ray.origin_mm.z()) / ray.direction.z() * ray.direction;
}

// Where a marker's ray meets the side face it lies on, which stands behind the face's edge.
std::optional<Eigen::Vector3d> on_side_face(const Marker& marker, const FaceShape& shape) {
  const auto middle = shape.middle_at(marker.u);
  const auto ray = shape.camera().unproject({marker.u, marker.v});
  if (!middle || !ray) return std::nullopt;
  const double across_at_face = at_depth(*ray, middle->point_mm.z()).y() - middle->point_mm.y();
  const double side_y_mm =
      middle->point_mm.y() + std::copysign(0.5 * shape.face().width_mm, across_at_face);
  const double z_mm = ray->origin_mm.z() +
                      (side_y_mm - ray->origin_mm.y()) / ray->direction.y() * ray->direction.z();
  if (!(std::isfinite(z_mm) && z_mm > 0)) return std::nullopt;
  return at_depth(*ray, z_mm);
}

std::optional<MarkerMotion> motion_at(const Marker& marker,
                                      const FaceShape& shape,
                                      double length_mm) {
  const auto at = on_side_face(marker, shape);
  const auto foot = at ? shape.foot_of(at->x(), at->z()) : std::nullopt;
  if (!foot) return std::nullopt;
  const double t = std::clamp(shape.length_at(foot->u) / length_mm, 0.0, 1.0);
  Eigen::Vector3d back(foot->tangent_z, 0, -foot->tangent_x);
  if (back.z() > 0) back = -back;
  const double to_tip = shape.base_at_low_u() ? 1 : -1;
  const Eigen::Vector3d tangent = to_tip * Eigen::Vector3d(foot->tangent_x, 0, foot->tangent_z);
  // The section turns with the slope 2 t / L of the deflection, and what stands off the face is
  // carried along it.
  const double off_mm = (*at - foot->point_mm).dot(back);
  MarkerMotion motion{Eigen::Matrix2d::Zero(), back, t * t};
  const std::array<Eigen::Vector3d, 2> ways{t * t * back - off_mm * 2 * t / length_mm * tangent,
                                            t * t * Eigen::Vector3d::UnitY()};
  for (int way = 0; way < 2; ++way) {
    const Eigen::Vector3d step = kStep_mm * ways[static_cast<std::size_t>(way)];
    const auto to = shape.camera().project(*at + step), from = shape.camera().project(*at - step);
    if (!to || !from) return std::nullopt;
    motion.px_per_mm.col(way) = (*to - *from) / (2 * kStep_mm);
  }
  return motion;
}

PushedFace face_of_way(const Eigen::Vector2d& way_mm) {
  if (std::abs(way_mm.x()) >= std::abs(way_mm.y()))
    return way_mm.x() > 0 ? PushedFace::kContact : PushedFace::kBack;
  return way_mm.y() > 0 ? PushedFace::kUpper : PushedFace::kLower;
}

void tell_direction(const TipWay& way, FingerContact& contact) {
  const double length = way.way_mm.norm();
  if (!(length > 0)) return;
  const Eigen::Vector2d unit = way.way_mm / length, across(-unit.y(), unit.x());
  contact.direction =
      (unit.x() * way.towards_back + unit.y() * Eigen::Vector3d::UnitY()).normalized();
  contact.direction_sd_deg = std::sqrt(std::max(0.0, across.dot(way.covariance_mm2 * across))) /
                             length * 180.0 / std::numbers::pi;
}

PlaceOnFinger place_of_region(const ContactRegion& region, const FaceShape& shape) {
  PlaceOnFinger place;
  place.along_mm = region.deepest_on_face_mm.x();
  place.across_mm = region.deepest_on_face_mm.y();
  place.depth_mm = region.deepest_mm;
  place.depth_sd_mm = region.deepest_sd_mm;
  if (const auto covariance = place_covariance_on_face_mm2(region, shape)) {
    if (const auto base_sd_mm = shape.base_sd_mm())
      place.along_sd_mm = std::hypot(std::sqrt((*covariance)(0, 0)), *base_sd_mm);
    place.across_sd_mm = std::sqrt((*covariance)(1, 1));
  }
  return place;
}

}  // namespace

std::optional<TipWay> tip_way(const Markers& markers,
                              const std::vector<Eigen::Vector2d>& rest,
                              const FaceShape& shape,
                              const Eigen::MatrixXd& ways_px2) {
  const double length_mm = whole_length_mm(shape);
  const auto size = static_cast<Eigen::Index>(2 * markers.size());
  if (markers.size() != rest.size() || ways_px2.rows() != size || !(length_mm > 0))
    return std::nullopt;
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(size, 2);
  Eigen::VectorXd ways = Eigen::VectorXd::Zero(size);
  TipWay result;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    const auto motion = motion_at(markers[m], shape, length_mm);
    if (!motion) continue;
    const auto k = static_cast<Eigen::Index>(2 * m);
    motions.middleRows<2>(k) = motion->px_per_mm;
    ways.segment<2>(k) = Eigen::Vector2d(markers[m].u, markers[m].v) - rest[m];
    result.towards_back += motion->share * motion->towards_back;
  }
  const Eigen::Matrix2d information = motions.transpose() * motions;
  const double product = information(0, 0) * information(1, 1);
  if (!(information.determinant() > kWellTold * product) || !ways.allFinite()) return std::nullopt;
  const Eigen::MatrixXd told = information.inverse() * motions.transpose();
  result.way_mm = told * ways;
  result.covariance_mm2 = told * ways_px2 * told.transpose();
  result.towards_back.normalize();
  return result;
}

std::optional<Eigen::Matrix2d> place_covariance_on_face_mm2(const ContactRegion& region,
                                                            const FaceShape& shape) {
  const auto plane = contact_plane(shape, region.place_px);
  if (!plane || !region.place_covariance_mm2 || !region.centre_covariance_mm2) return std::nullopt;
  return Eigen::Matrix2d(plane->transpose() * *region.place_covariance_mm2 * *plane +
                         *region.centre_covariance_mm2);
}

double ContactSigns::push_strength() const {
  return push != nullptr && push_threshold_px > 0 ? push->offset_px.norm() / push_threshold_px : 0;
}

double ContactSigns::depth_strength() const {
  double deepest_mm = 0;
  if (regions != nullptr)
    for (const ContactRegion& region : *regions)
      deepest_mm = std::max(deepest_mm, region.deepest_mm);
  return deepest_mm / kTouchedDepth_mm;
}

double ContactSigns::strength() const {
  return std::max(push_strength(), depth_strength());
}

FingerContact finger_contact(const ContactSigns& signs,
                             const FaceShape& shape,
                             std::optional<PushedFace> before) {
  FingerContact contact;
  const bool has_region = signs.regions != nullptr && !signs.regions->empty();
  const bool is_pressed =
      has_region && (signs.depth_strength() > 1 || before == PushedFace::kContact);
  const bool is_pushed = signs.way && signs.push_strength() > ContactState::kRelease;
  contact.face = is_pressed  ? PushedFace::kContact
                 : is_pushed ? face_of_way(signs.way->way_mm)
                             : before.value_or(PushedFace::kContact);
  if (is_pushed) tell_direction(*signs.way, contact);
  if (is_pressed) {
    const ContactRegion& region = signs.regions->front();
    contact.place = place_of_region(region, shape);
    if (!contact.direction && region.normal) contact.direction = -*region.normal;
  } else if (contact.face != PushedFace::kContact) {
    contact.no_place = en::say(
        "the markers tell from which side the finger is pushed, but not how far from its "
        "base: that hangs on how its stiffness falls towards the tip");
  } else if (signs.regions == nullptr) {
    contact.no_place = en::say("without a depth there is no place on the contact face");
  } else {
    contact.no_place =
        en::say("nothing is seen to be pressed into the part of the contact face in view");
  }
  return contact;
}

std::optional<double> skin_along_mm(const Markers& markers, const FaceShape& shape) {
  if (markers.empty() || !(whole_length_mm(shape) > 0)) return std::nullopt;
  double sum = 0;
  for (const Marker& marker : markers) sum += shape.length_at(marker.u);
  const double mean = sum / static_cast<double>(markers.size());
  if (!std::isfinite(mean)) return std::nullopt;
  return mean;
}

}  // namespace alltact
