#include "core/sensing/contact/finger_contact_tracker.h"

namespace alltact {
namespace {

ContactSigns signs_of(const FingerContactTracker::FrameSigns& frame) {
  ContactSigns signs;
  signs.regions = frame.regions;
  if (frame.push == nullptr) return signs;
  signs.push = frame.push;
  signs.push_threshold_px = frame.settings->threshold_px;
  if (!(signs.push_strength() > ContactState::kRelease)) return signs;
  const auto& rest = frame.settings->rest_markers;
  signs.way = tip_way(*frame.markers, rest, *frame.shape, *frame.ways_px2);
  if (signs.way && face_of_way(*signs.way) == PushedFace::kBack && !(signs.depth_strength() > 1))
    signs.along_back =
        push_along_back(*frame.markers, rest, *frame.shape, *frame.ways_px2, *signs.way);
  return signs;
}

ContactState::Seen seen_in(const FingerContactTracker::FrameSigns& frame, double strength) {
  ContactState::Seen seen;
  seen.time_s = frame.time_s;
  seen.strength = strength;
  if (frame.regions == nullptr || frame.regions->empty()) return seen;
  const ContactRegion& region = frame.regions->front();
  const auto covariance = place_covariance_on_face_mm2(region, *frame.shape);
  if (!covariance) return seen;
  seen.place_mm = region.place_on_face_mm;
  seen.place_covariance_mm2 = *covariance;
  // The skin of a flat sensor stays where it is.
  if (frame.markers != nullptr)
    seen.skin_along_mm = skin_along_mm(*frame.markers, *frame.shape).value_or(0);
  return seen;
}

}  // namespace

std::optional<FingerContact> FingerContactTracker::operator()(const FrameSigns& frame) {
  const ContactSigns signs = signs_of(frame);
  const ContactState::Told told = state_.add(seen_in(frame, signs.strength()));
  if (!told.is_touched) {
    face_.reset();
    return std::nullopt;
  }
  FingerContact contact = finger_contact(signs, *frame.shape, face_);
  contact.is_new = told.is_new;
  contact.held_s = told.held_s;
  contact.is_slipping = told.is_slipping;
  face_ = contact.face;
  return contact;
}

FrameContacts FingerContactTracker::alone(const FrameSigns& frame) {
  const ContactSigns signs = signs_of(frame);
  FrameContacts contacts;
  contacts.seen = seen_in(frame, signs.strength());
  contacts.by_face[0] = finger_contact(signs, *frame.shape, std::nullopt);
  for (std::size_t face = 1; face < contacts.by_face.size(); ++face)
    contacts.by_face[face] = finger_contact(signs, *frame.shape, static_cast<PushedFace>(face));
  return contacts;
}

}  // namespace alltact
