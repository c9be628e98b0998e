#include "calibration/finger/find_contradictions.h"

#include "calibration/reference/reference_suspect.h"
#include "core/finger/quantity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

// A layer is measured with a caliper to a few hundredths of a millimetre.
constexpr double kLayerTolerance = 1.03;
// The mapping ends at the darkest sample, which is below the deepest point by noise.
constexpr double kReachTolerance = 1.05;
// Working distances of lenses that fit into a finger: endoscopes focus from 5 mm on, and no finger
// is longer than half a metre.
constexpr double kNearestFaceMm = 5, kFarthestFaceMm = 500;

// Distance of bright spots that count as the same spot of skin.
constexpr double kSameSpotMm = 3;

/// Adds a press that shows the contradiction.
void add_press(Contradiction& to, const std::string& press, double mm) {
  to.measured_mm = to.presses.empty() ? mm : std::min(to.measured_mm, mm);
  to.measured_to_mm = std::max(to.measured_to_mm, mm);
  to.presses.push_back(press);
}

/// A ball's contact is at most as wide as its own circle, at any depth.
Contradiction wider_than_ball(const FingerCalibration& done) {
  Contradiction wider;
  wider.kind = ContradictionKind::kContactWiderThanBall;
  for (const TakenPress& taken : done.presses) {
    if (!taken.press || taken.press->step_mm) continue;
    if (const auto& note = done.inputs.press_set.of(taken.name); note.excluded) continue;
    Press press = *taken.press;
    const double radius_mm = press.ball_radius_mm;
    if (!(radius_mm > 0)) continue;
    press.ball_radius_mm = kBallRadius.possible.high;  // so that no disc is too wide to be measured
    press.ball_mm.reset();
    const auto disc = find_ball(press, done.finger.face);
    if (!disc) continue;
    ++wider.of;
    if (disc->disc_radius_mm <= radius_mm) continue;
    wider.given_mm = radius_mm;
    add_press(wider, taken.name, disc->disc_radius_mm);
  }
  return wider;
}

double indentation_mm(const BallFit& ball) {
  return ball.indentation_mm > 0 ? ball.indentation_mm : ball.depth_mm;
}

Contradiction deeper_than_layer(const FingerCalibration& done) {
  Contradiction deeper;
  deeper.kind = ContradictionKind::kContactDeeperThanLayer;
  deeper.given_mm = done.finger.face.layer_mm;
  deeper.of = static_cast<int>(done.calibration.balls.size());
  for (const BallFit& ball : done.calibration.balls)
    if (indentation_mm(ball) > kLayerTolerance * deeper.given_mm)
      add_press(deeper, ball.press, indentation_mm(ball));
  return deeper;
}

/// Measured depths beyond the range of the brightness curve.
Contradiction beyond_mapping(const FingerCalibration& done) {
  Contradiction beyond;
  beyond.kind = ContradictionKind::kDepthBeyondMapping;
  const auto mapping = Mapping::create(done.calibration.mapping);
  if (!mapping) return beyond;
  beyond.given_mm = mapping->depth_mm(mapping->x_max());
  for (const TakenPress& taken : done.presses) {
    const PressNote& note = done.inputs.press_set.of(taken.name);
    if (!note.depth || note.excluded || !taken.press) continue;
    ++beyond.of;
    if (note.depth->mm > kReachTolerance * beyond.given_mm + 3 * note.depth->sd_mm)
      add_press(beyond, taken.name, note.depth->mm);
  }
  return beyond;
}

/// The face's distance is in proportion to its width: z = f W / (width in the image).
Contradiction width_against_camera(const FingerCalibration& done) {
  Contradiction width;
  width.kind = ContradictionKind::kFaceWidthAgainstCamera;
  width.given_mm = done.finger.face.width_mm;
  if (done.finger.face.kind != FaceKind::kFinRay) return width;
  double least = 0, most = std::numeric_limits<double>::max();
  std::vector<std::string> presses;
  for (const TakenPress& taken : done.presses) {
    if (!taken.press) continue;
    double nearest = std::numeric_limits<double>::max(), farthest = 0;
    for (const FaceColumn& column : taken.press->shape.columns()) {
      if (!column.valid) continue;
      nearest = std::min(nearest, column.z_mm);
      farthest = std::max(farthest, column.z_mm);
    }
    if (!(farthest > 0)) continue;
    presses.push_back(taken.name);
    least = std::max(least, width.given_mm * kNearestFaceMm / nearest);
    most = std::min(most, width.given_mm * kFarthestFaceMm / farthest);
  }
  width.of = static_cast<int>(presses.size());
  if (presses.empty() || (width.given_mm >= least && width.given_mm <= most)) return width;
  width.presses = std::move(presses);
  width.measured_mm = least;
  width.measured_to_mm = std::max(least, most);
  return width;
}

/// Skin that is brighter than the reference at one position in two presses or more: in a single one
/// it may be a glint of the ball.
Contradiction reference_contact(const FingerCalibration& done) {
  Contradiction contact;
  contact.kind = ContradictionKind::kReferenceContact;
  std::vector<std::pair<std::string, ReferenceSuspect>> spots;
  for (const TakenPress& taken : done.presses) {
    if (!taken.press || !taken.sign.known_pose) continue;
    ++contact.of;
    if (const auto spot = find_reference_suspect(taken.press->difference, taken.press->shape))
      spots.emplace_back(taken.name, *spot);
  }
  for (const auto& [name, spot] : spots) {
    std::vector<std::string> alike;
    for (const auto& [other, there] : spots)
      if (std::hypot(there.along_mm - spot.along_mm, there.across_mm - spot.across_mm) <
          kSameSpotMm)
        alike.push_back(other);
    if (alike.size() >= 2 && alike.size() > contact.presses.size()) {
      contact.presses = alike;
      contact.measured_mm = spot.along_mm;
    }
  }
  return contact;
}

}  // namespace

std::vector<Contradiction> find_contradictions(const FingerCalibration& done) {
  std::vector<Contradiction> all;
  for (Contradiction& one : std::vector{width_against_camera(done),
                                        wider_than_ball(done),
                                        reference_contact(done),
                                        deeper_than_layer(done),
                                        beyond_mapping(done)})
    if (!one.presses.empty()) all.push_back(std::move(one));
  return all;
}

}  // namespace alltact
