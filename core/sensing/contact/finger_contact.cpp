#include "core/sensing/contact/finger_contact.h"

#include "core/sensing/contact/contact_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Dense>

namespace alltact {
namespace {

/// The face from which the finger was deflected.
PushedFace face_of_motion(const TipDisplacement& displacement) {
  const Eigen::Vector2d& mm = displacement.displacement_mm;
  if (std::abs(mm.x()) >= std::abs(mm.y()))
    return mm.x() > 0 ? PushedFace::kContact : PushedFace::kBack;
  return mm.y() > 0 ? PushedFace::kUpper : PushedFace::kLower;
}

std::optional<ContactDeflection> deflection_of(const TipDisplacement& displacement) {
  const double length = displacement.displacement_mm.norm();
  if (!(length > 0)) return std::nullopt;
  const Eigen::Vector2d unit = displacement.displacement_mm / length, across(-unit.y(), unit.x());
  ContactDeflection deflection;
  deflection.face = face_of_motion(displacement);
  deflection.direction =
      (unit.x() * displacement.towards_back + unit.y() * Eigen::Vector3d::UnitY()).normalized();
  deflection.direction_sd_deg =
      std::sqrt(std::max(0.0, across.dot(displacement.covariance_mm2 * across))) / length * 180.0 /
      std::numbers::pi;
  return deflection;
}

PositionOnFinger position_of_region(const ContactRegion& region, const FaceShape& shape,
                                    const std::optional<Eigen::Matrix2d>& covariance) {
  PositionOnFinger position;
  position.along_mm = region.deepest_on_face_mm.x();
  position.across_mm = region.deepest_on_face_mm.y();
  position.depth_mm = region.deepest_mm;
  position.depth_sd_mm = region.deepest_sd_mm;
  position.limits = region.limits;
  if (covariance) {
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

/// Mean over all markers of the position of their columns along the face, mm. This is the skin's
/// position in the coordinates of PositionOnFinger::along_mm, whose origin moves as the finger
/// bends. 0 where it is unknown.
double skin_along_mm(const Markers& markers, const FaceShape& shape) {
  if (markers.empty() || !(base_to_tip_mm(shape) > 0)) return 0;
  double sum = 0;
  for (const Marker& marker : markers) sum += shape.length_at(marker.u);
  const double mean = sum / static_cast<double>(markers.size());
  return std::isfinite(mean) ? mean : 0;
}

/// Skin that is pressed slightly belongs to a contact that pressed there before, and else to none.
bool is_pressed(const ContactEvidence& evidence, std::optional<PushedFace> before) {
  return evidence.indentation && (evidence.depth.value_or(0) > 1 || before == PushedFace::kContact);
}

/// `before`: the face of the contact in the frame before.
PushedFace face_of(const ContactEvidence& evidence, std::optional<PushedFace> before) {
  if (is_pressed(evidence, before)) return PushedFace::kContact;
  return evidence.deflection ? evidence.deflection->face : before.value_or(PushedFace::kContact);
}

/// Of a frame with a contact on `face`.
FingerContact contact_of(const ContactEvidence& evidence, PushedFace face) {
  FingerContact contact;
  const auto& deflection = evidence.deflection;
  contact.face = face;
  if (deflection) {
    contact.direction = deflection->direction;
    contact.direction_sd_deg = deflection->direction_sd_deg;
  }
  if (is_pressed(evidence, face)) {
    contact.position = evidence.indentation->position;
    if (!contact.direction) contact.direction = evidence.indentation->direction;
  } else if (contact.face != PushedFace::kContact) {
    if (contact.face != PushedFace::kBack)
      contact.no_position = en::say(
          "the markers show from which side the finger is pushed, but not how far from its base: a "
          "push on a side moves them alike wherever it is");
    else if (deflection && deflection->face == PushedFace::kBack && deflection->position)
      contact.position = deflection->position;
    else
      contact.no_position = en::say(
          "the push on the back moves the markers too little, or bends the finger too far, to "
          "estimate its distance from the base");
  } else if (!evidence.depth) {
    contact.no_position = en::say("without a depth there is no position on the contact face");
  } else {
    contact.no_position = en::say("the visible part of the contact face is not indented");
  }
  return contact;
}

}  // namespace

void ContactEvidence::add_regions(const std::vector<ContactRegion>& regions, const FaceShape& shape,
                                  const Markers* markers) {
  double deepest_mm = 0;
  for (const ContactRegion& region : regions) deepest_mm = std::max(deepest_mm, region.deepest_mm);
  depth = deepest_mm / kContactDepth_mm;
  is_face_pressed = *depth > 1;
  if (regions.empty()) return;
  const ContactRegion& region = regions.front();
  const auto& covariance_mm2 = region.on_face_covariance_mm2;
  indentation.emplace();
  indentation->position = position_of_region(region, shape, covariance_mm2);
  if (region.normal) indentation->direction = -*region.normal;
  if (!covariance_mm2) return;
  // The skin of a flat sensor does not move.
  const double skin_mm = markers != nullptr ? skin_along_mm(*markers, shape) : 0;
  indentation->on_skin_mm = region.position_on_face_mm - Eigen::Vector2d(skin_mm, 0);
  indentation->on_skin_covariance_mm2 = *covariance_mm2;
}

void ContactEvidence::add_push(const Push& seen, const ContactSettings& settings,
                               const Markers& markers, const FaceShape& shape,
                               const Eigen::MatrixXd& displacement_cov_px2) {
  push = settings.threshold_px > 0 ? seen.offset_px.norm() / settings.threshold_px : 0;
  if (!(push > FingerContactTracker::kRelease)) return;
  const auto& rest = settings.rest_markers;
  const auto displacement = tip_displacement(markers, rest, shape, displacement_cov_px2);
  if (displacement) deflection = deflection_of(*displacement);
  if (!deflection || deflection->face != PushedFace::kBack || depth.value_or(0) > 1) return;
  if (const auto along = push_along_back(markers, rest, shape, displacement_cov_px2, *displacement))
    deflection->position = position_of_push(*along, shape);
}

std::optional<bool> is_face_dark(const Difference& difference) {
  constexpr double kContactDarkening = 0.12;  // of x: about a tenth of a layer
  constexpr double kContactFraction =
      0.001;  // of the face: less than a ball of 4 mm pressed in 0.2 mm
  std::size_t measured = 0, dark = 0;
  for (int v = 0; v < difference.x.rows; ++v) {
    const float* x = difference.x.ptr<float>(v);
    for (int u = 0; u < difference.x.cols; ++u) {
      measured += std::isfinite(x[u]) ? 1U : 0U;
      dark += x[u] > static_cast<float>(kContactDarkening) ? 1U : 0U;
    }
  }
  if (measured == 0) return std::nullopt;
  return static_cast<double>(dark) > kContactFraction * static_cast<double>(measured);
}

std::optional<FingerContact> FingerContactTracker::operator()(
    const std::optional<ContactEvidence>& seen) {
  if (!is_continuous_) forget();
  if (!seen) return std::nullopt;
  const auto& time_s = seen->time_s;
  if (time_s && last_s_ && (*time_s < *last_s_ || *time_s - *last_s_ > kMaxGap_s)) forget();
  const bool is_new = begins(*seen);
  has_begun_ = true;
  last_s_ = time_s;
  if (!has_contact_) {
    face_.reset();
    other_face_s_.reset();
    samples_.clear();
    return std::nullopt;
  }
  const bool is_another = changes_face(*seen);
  FingerContact contact = contact_of(*seen, *face_);
  contact.is_new = is_new || is_another;
  if (time_s && began_s_) contact.held_s = *time_s - *began_s_;
  contact.is_slipping = is_slipping(*seen);
  return contact;
}

/// True once `holds` has been true for this duration. `since`: when that began.
bool FingerContactTracker::holds_for(double duration_s, bool holds, std::optional<double> time_s,
                                     std::optional<double>& since) const {
  if (!holds) {
    since.reset();
    return false;
  }
  if (!time_s || !has_begun_) return true;
  if (!since) since = time_s;
  return *time_s - *since >= duration_s;
}

/// Updates has_contact_. True: it begins now.
bool FingerContactTracker::begins(const ContactEvidence& seen) {
  bool is_new = false;
  if (has_contact_) {
    if (holds_for(kRelease_s, seen.strength() < kRelease, seen.time_s, weak_s_))
      has_contact_ = false;
  } else if (holds_for(kOnset_s, seen.strength() >= 1, seen.time_s, strong_s_)) {
    has_contact_ = is_new = true;
    began_s_ = strong_s_ ? strong_s_ : seen.time_s;
  }
  if (has_contact_) strong_s_.reset();
  if (!has_contact_) weak_s_.reset();
  return is_new;
}

/// Updates face_ of a frame with a contact. True: another contact begins.
bool FingerContactTracker::changes_face(const ContactEvidence& seen) {
  const PushedFace now = face_of(seen, face_);
  const bool is_first = !face_;
  const double duration_s = is_pressed(seen, std::nullopt) ? 0 : kRelease_s;
  if (!is_first && !holds_for(duration_s, now != *face_, seen.time_s, other_face_s_)) return false;
  face_ = now;
  if (is_first) return false;
  began_s_ = std::exchange(other_face_s_, std::nullopt);
  samples_.clear();
  return true;
}

std::optional<bool> FingerContactTracker::is_slipping(const ContactEvidence& seen) {
  if (!seen.time_s || !seen.indentation || !seen.indentation->on_skin_mm) {
    samples_.clear();
    return std::nullopt;
  }
  const Sample now{*seen.time_s, *seen.indentation->on_skin_mm,
                   seen.indentation->on_skin_covariance_mm2};
  while (!samples_.empty() && now.time_s - samples_.front().time_s > kWindow_s)
    samples_.pop_front();
  // Relative to the sample in the window that is furthest from here.
  bool slips = false;
  double furthest_mm = 0;
  for (const Sample& before : samples_) {
    const Eigen::Vector2d displacement = now.on_skin_mm - before.on_skin_mm;
    const double length = displacement.norm();
    if (!(length > furthest_mm)) continue;
    furthest_mm = length;
    const Eigen::Vector2d unit = displacement / length;
    const double sd =
        std::sqrt(std::max(0.0, unit.dot((now.covariance_mm2 + before.covariance_mm2) * unit)));
    slips = length > std::max(kSlipSds * sd, kMinSlip_mm);
  }
  samples_.push_back(now);
  return slips;
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

std::size_t at(int piece, int across) {
  return static_cast<std::size_t>(std::ptrdiff_t{piece} * kAcross + across);
}

Patches levels_of(const cv::Mat& grey, const FaceShape& shape) {
  std::vector<double> sum(std::size_t{kPieces} * kAcross, 0.0);
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
  skin_.resize(std::size_t{kPieces} * kAcross);
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
