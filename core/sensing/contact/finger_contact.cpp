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
  place.limits = region.limits;
  if (const auto covariance = place_covariance_on_face_mm2(region, shape)) {
    if (const auto base_sd_mm = shape.base_sd_mm())
      place.along_sd_mm = std::hypot(std::sqrt((*covariance)(0, 0)), *base_sd_mm);
    place.across_sd_mm = std::sqrt((*covariance)(1, 1));
  }
  return place;
}

PlaceOnFinger place_of_push(const AlongFinger& along, const FaceShape& shape) {
  PlaceOnFinger place;
  place.along_mm = along.mm;
  if (const auto base_sd_mm = shape.base_sd_mm())
    place.along_sd_mm = std::hypot(along.sd_mm, *base_sd_mm);
  return place;
}

}  // namespace

PushedFace face_of_way(const TipWay& way) {
  const Eigen::Vector2d& mm = way.way_mm;
  if (std::abs(mm.x()) >= std::abs(mm.y()))
    return mm.x() > 0 ? PushedFace::kContact : PushedFace::kBack;
  return mm.y() > 0 ? PushedFace::kUpper : PushedFace::kLower;
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
                 : is_pushed ? face_of_way(*signs.way)
                             : before.value_or(PushedFace::kContact);
  if (is_pushed) tell_direction(*signs.way, contact);
  if (is_pressed) {
    const ContactRegion& region = signs.regions->front();
    contact.place = place_of_region(region, shape);
    if (!contact.direction && region.normal) contact.direction = -*region.normal;
  } else if (contact.face != PushedFace::kContact) {
    if (contact.face != PushedFace::kBack)
      contact.no_place = en::say(
          "the markers tell from which side the finger is pushed, but not how far from its base: a "
          "push on a side moves them alike wherever it is");
    else if (is_pushed && signs.along_back)
      contact.place = place_of_push(*signs.along_back, shape);
    else
      contact.no_place = en::say(
          "the push on the back moves the markers too little, or bends the finger too far, to tell "
          "how far from the base it is");
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
