#include "core/sensing/contact/finger_contact.h"

#include "core/sensing/contact/contact_geometry.h"
#include "core/sensing/contact/contact_state.h"
#include "core/sensing/contact/face_contact.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace alltact {
namespace {

void set_direction(const TipDisplacement& displacement, FingerContact& contact) {
  const double length = displacement.displacement_mm.norm();
  if (!(length > 0)) return;
  const Eigen::Vector2d unit = displacement.displacement_mm / length, across(-unit.y(), unit.x());
  contact.direction =
      (unit.x() * displacement.towards_back + unit.y() * Eigen::Vector3d::UnitY()).normalized();
  contact.direction_sd_deg =
      std::sqrt(std::max(0.0, across.dot(displacement.covariance_mm2 * across))) / length * 180.0 /
      std::numbers::pi;
}

PositionOnFinger position_of_region(const ContactRegion& region, const FaceShape& shape) {
  PositionOnFinger position;
  position.along_mm = region.deepest_on_face_mm.x();
  position.across_mm = region.deepest_on_face_mm.y();
  position.depth_mm = region.deepest_mm;
  position.depth_sd_mm = region.deepest_sd_mm;
  position.limits = region.limits;
  if (const auto covariance = position_covariance_on_face_mm2(region, shape)) {
    if (const auto base_sd_mm = shape.base_sd_mm())
      position.along_sd_mm = std::hypot(std::sqrt((*covariance)(0, 0)), *base_sd_mm);
    position.across_sd_mm = std::sqrt((*covariance)(1, 1));
  }
  return position;
}

PositionOnFinger position_of_push(const AlongFinger& along, const FaceShape& shape) {
  PositionOnFinger position;
  position.along_mm = along.mm;
  if (const auto base_sd_mm = shape.base_sd_mm())
    position.along_sd_mm = std::hypot(along.sd_mm, *base_sd_mm);
  return position;
}

}  // namespace

PushedFace face_of_motion(const TipDisplacement& displacement) {
  const Eigen::Vector2d& mm = displacement.displacement_mm;
  if (std::abs(mm.x()) >= std::abs(mm.y()))
    return mm.x() > 0 ? PushedFace::kContact : PushedFace::kBack;
  return mm.y() > 0 ? PushedFace::kUpper : PushedFace::kLower;
}

std::optional<Eigen::Matrix2d> position_covariance_on_face_mm2(const ContactRegion& region,
                                                               const FaceShape& shape) {
  const auto plane = contact_plane(shape, region.position_px);
  if (!plane || !region.position_covariance_mm2 || !region.centre_covariance_mm2)
    return std::nullopt;
  return Eigen::Matrix2d(plane->transpose() * *region.position_covariance_mm2 * *plane +
                         *region.centre_covariance_mm2);
}

double ContactEvidence::push_strength() const {
  return push != nullptr && push_threshold_px > 0 ? push->offset_px.norm() / push_threshold_px : 0;
}

double ContactEvidence::depth_strength() const {
  double deepest_mm = 0;
  if (regions != nullptr)
    for (const ContactRegion& region : *regions)
      deepest_mm = std::max(deepest_mm, region.deepest_mm);
  return deepest_mm / kContactDepth_mm;
}

double ContactEvidence::strength() const {
  return std::max(push_strength(), depth_strength());
}

FingerContact finger_contact(const ContactEvidence& evidence,
                             const FaceShape& shape,
                             std::optional<PushedFace> before) {
  FingerContact contact;
  const bool has_region = evidence.regions != nullptr && !evidence.regions->empty();
  const bool is_pressed =
      has_region && (evidence.depth_strength() > 1 || before == PushedFace::kContact);
  const bool is_pushed = evidence.displacement && evidence.push_strength() > ContactState::kRelease;
  contact.face = is_pressed  ? PushedFace::kContact
                 : is_pushed ? face_of_motion(*evidence.displacement)
                             : before.value_or(PushedFace::kContact);
  if (is_pushed) set_direction(*evidence.displacement, contact);
  if (is_pressed) {
    const ContactRegion& region = evidence.regions->front();
    contact.position = position_of_region(region, shape);
    if (!contact.direction && region.normal) contact.direction = -*region.normal;
  } else if (contact.face != PushedFace::kContact) {
    if (contact.face != PushedFace::kBack)
      contact.no_position = en::say(
          "the markers tell from which side the finger is pushed, but not how far from its base: a "
          "push on a side moves them alike wherever it is");
    else if (is_pushed && evidence.along_back)
      contact.position = position_of_push(*evidence.along_back, shape);
    else
      contact.no_position = en::say(
          "the push on the back moves the markers too little, or bends the finger too far, to tell "
          "how far from the base it is");
  } else if (evidence.regions == nullptr) {
    contact.no_position = en::say("without a depth there is no place on the contact face");
  } else {
    contact.no_position =
        en::say("nothing is seen to be pressed into the part of the contact face in view");
  }
  return contact;
}

std::optional<double> skin_along_mm(const Markers& markers, const FaceShape& shape) {
  if (markers.empty() || !(base_to_tip_mm(shape) > 0)) return std::nullopt;
  double sum = 0;
  for (const Marker& marker : markers) sum += shape.length_at(marker.u);
  const double mean = sum / static_cast<double>(markers.size());
  if (!std::isfinite(mean)) return std::nullopt;
  return mean;
}

}  // namespace alltact
