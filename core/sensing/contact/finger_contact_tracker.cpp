#include "core/sensing/contact/finger_contact_tracker.h"

namespace alltact {
namespace {

ContactEvidence evidence_of(const FingerContactTracker::FrameInput& frame) {
  ContactEvidence evidence;
  evidence.regions = frame.regions;
  if (frame.push == nullptr) return evidence;
  evidence.push = frame.push;
  evidence.push_threshold_px = frame.settings->threshold_px;
  if (!(evidence.push_strength() > ContactState::kRelease)) return evidence;
  const auto& rest = frame.settings->rest_markers;
  evidence.displacement =
      tip_displacement(*frame.markers, rest, *frame.shape, *frame.displacement_cov_px2);
  if (evidence.displacement && face_of_motion(*evidence.displacement) == PushedFace::kBack &&
      !(evidence.depth_strength() > 1))
    evidence.along_back = push_along_back(
        *frame.markers, rest, *frame.shape, *frame.displacement_cov_px2, *evidence.displacement);
  return evidence;
}

ContactState::Observation observation_of(const FingerContactTracker::FrameInput& frame,
                                         double strength) {
  ContactState::Observation seen;
  seen.time_s = frame.time_s;
  seen.strength = strength;
  if (frame.regions == nullptr || frame.regions->empty()) return seen;
  const ContactRegion& region = frame.regions->front();
  const auto covariance = position_covariance_on_face_mm2(region, *frame.shape);
  if (!covariance) return seen;
  seen.position_mm = region.position_on_face_mm;
  seen.position_covariance_mm2 = *covariance;
  // The skin of a flat sensor does not move.
  if (frame.markers != nullptr)
    seen.skin_along_mm = skin_along_mm(*frame.markers, *frame.shape).value_or(0);
  return seen;
}

}  // namespace

std::optional<FingerContact> FingerContactTracker::operator()(const FrameInput& frame) {
  const ContactEvidence evidence = evidence_of(frame);
  const ContactState::Estimate estimate = state_.add(observation_of(frame, evidence.strength()));
  if (!estimate.has_contact) {
    face_.reset();
    return std::nullopt;
  }
  FingerContact contact = finger_contact(evidence, *frame.shape, face_);
  contact.is_new = estimate.is_new;
  contact.held_s = estimate.held_s;
  contact.is_slipping = estimate.is_slipping;
  face_ = contact.face;
  return contact;
}

FrameContacts FingerContactTracker::single_frame(const FrameInput& frame) {
  const ContactEvidence evidence = evidence_of(frame);
  FrameContacts contacts;
  contacts.seen = observation_of(frame, evidence.strength());
  contacts.by_face[0] = finger_contact(evidence, *frame.shape, std::nullopt);
  for (std::size_t face = 1; face < contacts.by_face.size(); ++face)
    contacts.by_face[face] = finger_contact(evidence, *frame.shape, static_cast<PushedFace>(face));
  return contacts;
}

}  // namespace alltact
