#include "core/sensing/contact/finger_contact.h"

#include "core/sensing/contact/contact_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

double ContactEvidence::strength() const { return std::max(push_strength(), depth_strength()); }

FingerContact finger_contact(const ContactEvidence& evidence, const FaceShape& shape,
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
          "the markers show from which side the finger is pushed, but not how far from its base: a "
          "push on a side moves them alike wherever it is");
    else if (is_pushed && evidence.along_back)
      contact.position = position_of_push(*evidence.along_back, shape);
    else
      contact.no_position = en::say(
          "the push on the back moves the markers too little, or bends the finger too far, to "
          "estimate its distance from the base");
  } else if (evidence.regions == nullptr) {
    contact.no_position = en::say("without a depth there is no position on the contact face");
  } else {
    contact.no_position = en::say("nothing presses into the visible part of the contact face");
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

namespace {

constexpr double kContactDarkening = 0.12;  // of x: about a tenth of a layer
constexpr double kContactFraction =
    0.001;  // of the face: less than a ball of 4 mm pressed in 0.2 mm

}  // namespace

FaceContact face_contact(const std::vector<ContactRegion>& regions) {
  const bool has_contact = std::any_of(regions.begin(), regions.end(), [](const ContactRegion& r) {
    return r.deepest_mm > kContactDepth_mm;
  });
  return has_contact ? FaceContact::kInContact : FaceContact::kFree;
}

FaceContact face_contact(const Difference& difference) {
  std::size_t measured = 0, dark = 0;
  for (int v = 0; v < difference.x.rows; ++v) {
    const float* x = difference.x.ptr<float>(v);
    for (int u = 0; u < difference.x.cols; ++u) {
      measured += std::isfinite(x[u]) ? 1U : 0U;
      dark += x[u] > static_cast<float>(kContactDarkening) ? 1U : 0U;
    }
  }
  if (measured == 0) return FaceContact::kUnknown;
  return static_cast<double>(dark) > kContactFraction * static_cast<double>(measured)
             ? FaceContact::kInContact
             : FaceContact::kFree;
}

ContactState::Estimate ContactState::add(const Observation& seen) {
  if (seen.time_s && last_s_ && (*seen.time_s < *last_s_ || *seen.time_s - *last_s_ > kMaxGap_s))
    forget();
  Estimate estimate;
  update_contact(seen, estimate);
  has_begun_ = true;
  last_s_ = seen.time_s;
  if (!has_contact_) {
    samples_.clear();
    return estimate;
  }
  estimate.has_contact = true;
  if (seen.time_s && began_s_) estimate.held_s = *seen.time_s - *began_s_;
  detect_slip(seen, estimate);
  return estimate;
}

void ContactState::update_contact(const Observation& seen, Estimate& estimate) {
  const auto held_for = [&](bool holds, std::optional<double>& since, double duration_s) {
    if (!holds) {
      since.reset();
      return false;
    }
    if (!seen.time_s || !has_begun_) return true;
    if (!since) since = seen.time_s;
    return *seen.time_s - *since >= duration_s;
  };
  if (has_contact_) {
    if (held_for(seen.strength < kRelease, weak_s_, kRelease_s)) has_contact_ = false;
  } else if (held_for(seen.strength >= 1, strong_s_, kOnset_s)) {
    has_contact_ = estimate.is_new = true;
    began_s_ = strong_s_ ? strong_s_ : seen.time_s;
  }
  if (has_contact_) strong_s_.reset();
  if (!has_contact_) weak_s_.reset();
}

void ContactState::detect_slip(const Observation& seen, Estimate& estimate) {
  if (!seen.time_s || !seen.position_mm) {
    samples_.clear();
    return;
  }
  const Sample now{*seen.time_s, *seen.position_mm - Eigen::Vector2d(seen.skin_along_mm, 0),
                   seen.position_covariance_mm2};
  while (!samples_.empty() && now.time_s - samples_.front().time_s > kWindow_s)
    samples_.pop_front();
  estimate.is_slipping = false;
  estimate.slip_mm = Eigen::Vector2d::Zero();
  // Relative to the sample in the window that is furthest from here.
  for (const Sample& before : samples_) {
    const Eigen::Vector2d displacement = now.on_skin_mm - before.on_skin_mm;
    const double length = displacement.norm();
    if (!(length > estimate.slip_mm->norm())) continue;
    estimate.slip_mm = displacement;
    const Eigen::Vector2d unit = displacement / length;
    const double sd =
        std::sqrt(std::max(0.0, unit.dot((now.covariance_mm2 + before.covariance_mm2) * unit)));
    estimate.is_slipping = length > std::max(kSlipSds * sd, kMinSlip_mm);
  }
  samples_.push_back(now);
}

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
    evidence.along_back = push_along_back(*frame.markers, rest, *frame.shape,
                                          *frame.displacement_cov_px2, *evidence.displacement);
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

namespace {

constexpr double kPatchMm = 2.0;  // along the face; a ball of 4 mm pressed in 0.3 mm is 3 mm wide
constexpr int kPieces = 100;      // along
constexpr int kAcross = 12;
constexpr int kReach = 3;         // patches to each side that are the surroundings
constexpr double kRimPx = 4.0;    // at the edges a shift of a tenth of a pixel shows
constexpr double kEndMm = 5.0;    // of the face at both ends, where light ends with it
constexpr double kDarker = 0.05;  // about 0.2 mm of a typical layer
constexpr double kSigmas = 6.0;
constexpr double kDarkLearnt = 0.01;
constexpr int kMemory = 60;  // frames
constexpr int kMinPixels = 6;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// by piece and position across; NaN where the face is not seen
using Patches = std::vector<double>;

std::size_t at(int piece, int across) { return static_cast<std::size_t>(piece * kAcross + across); }

Patches levels_of(const cv::Mat& grey, const FaceShape& shape) {
  std::vector<double> sum(kPieces * kAcross, 0.0);
  std::vector<int> count(sum.size(), 0);
  const double end_mm = std::max(shape.length_at(0), shape.length_at(shape.width_px() - 1));
  for (int u = 0; u < shape.width_px(); u += 2) {
    const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
    const double along_mm = shape.length_at(u);
    const int piece = static_cast<int>(along_mm / kPatchMm);
    if (!column.valid || piece >= kPieces || along_mm < kEndMm || along_mm > end_mm - kEndMm)
      continue;
    const auto rows = shape.rows(u, kRimPx);
    const double height = (column.lower_v - column.upper_v) / kAcross;
    for (int v = rows.first; v <= rows.last; v += 2) {
      const int across =
          std::clamp(static_cast<int>((v - column.upper_v) / height), 0, kAcross - 1);
      sum[at(piece, across)] += grey.at<std::uint8_t>(v, u);
      ++count[at(piece, across)];
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] = count[i] >= kMinPixels ? std::log(std::max(1.0, sum[i] / count[i])) : kNaN;
  return sum;
}

/// Darkness of a patch against its surroundings on two opposite sides, so that an even change of
/// light cancels. Returns the smaller one of along and across the face.
double local_contrast(const Patches& levels, int piece, int across) {
  const double here = levels[at(piece, across)];
  double lowest = kNaN;
  for (const auto& [along_step, across_step] : {std::array{1, 0}, {0, 1}}) {
    double sum = 0;
    int sides = 0;
    for (const int side : {-kReach, kReach}) {
      const int p = piece + side * along_step, a = across + side * across_step;
      if (p < 0 || p >= kPieces || a < 0 || a >= kAcross || !std::isfinite(levels[at(p, a)]))
        continue;
      sum += levels[at(p, a)];
      ++sides;
    }
    if (sides == 2 && !(0.5 * sum - here < lowest)) lowest = 0.5 * sum - here;
  }
  return lowest;
}

}  // namespace

bool ReferenceFreeContactDetector::learn(Skin& skin, double now) {
  const double off = now - skin.typical;
  const double limit = std::max(kDarker, kSigmas * std::sqrt(skin.variance));
  if (skin.frames >= kFirstFrames && off > limit) return false;
  // A contact ended here.
  if (skin.frames >= kFirstFrames && off < -limit) skin = {};
  skin.frames = std::min(skin.frames + 1, kMemory);
  const double share = 1.0 / skin.frames;
  // Slowly increasing contacts must not be learnt. The variance is estimated from the bright side
  // alone, and the dark side changes the typical value only a little.
  if (skin.frames > 1 && off < 0) skin.variance += share * (off * off - skin.variance);
  skin.typical += share * (skin.frames > kFirstFrames ? std::min(off, kDarkLearnt) : off);
  return true;
}

std::optional<ReferenceFreeContact> ReferenceFreeContactDetector::operator()(
    const cv::Mat& grey, const FaceShape& shape) {
  CV_Assert(grey.type() == CV_8UC1 && grey.cols == shape.width_px());
  skin_.resize(kPieces * kAcross);
  ++frames_;
  const Patches levels = levels_of(grey, shape);
  std::optional<ReferenceFreeContact> contact;
  for (int piece = 0; piece < kPieces; ++piece)
    for (int across = 0; across < kAcross; ++across) {
      if (!std::isfinite(levels[at(piece, across)])) continue;
      const double now = local_contrast(levels, piece, across);
      if (!std::isfinite(now)) continue;
      Skin& skin = skin_[at(piece, across)];
      const double darker = now - skin.typical;
      if (learn(skin, now) || (contact && darker <= contact->darker)) continue;
      contact = ReferenceFreeContact{darker, (piece + 0.5) * kPatchMm};
    }
  return contact;
}

void ReferenceFreeContactDetector::forget() {
  skin_.clear();
  frames_ = 0;
}

}  // namespace alltact
