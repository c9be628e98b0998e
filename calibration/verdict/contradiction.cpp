#include "calibration/verdict/contradiction.h"

#include <algorithm>
#include <array>

namespace alltact {
namespace {

constexpr std::array kContradictionWords{
    std::string_view("contact_wider_than_ball"), std::string_view("contact_deeper_than_layer"),
    std::string_view("depth_beyond_mapping"), std::string_view("face_width_against_camera"),
    std::string_view("reference_touched")};

/// "2.17 to 2.44 mm", "2.17 mm".
Message range_mm(const Contradiction& one) {
  return one.measured_to_mm > one.measured_mm + 0.005
             ? en::say("{:.2f} to {:.2f} mm", one.measured_mm, one.measured_to_mm)
             : en::say("{:.2f} mm", one.measured_mm);
}

}  // namespace

std::string_view to_string(ContradictionKind kind) {
  return kContradictionWords.at(static_cast<std::size_t>(kind) - 1);
}

bool rules_out_use(ContradictionKind kind) {
  // Every depth is in proportion to the ball's radius and to the face's width.
  return kind == ContradictionKind::kContactWiderThanBall ||
         kind == ContradictionKind::kFaceWidthAgainstCamera;
}

Message sentence(const Contradiction& one) {
  const std::size_t count = std::max<std::size_t>(1, one.presses.size());
  const int of = std::max(one.of, static_cast<int>(count));
  switch (one.kind) {
    case ContradictionKind::kContactWiderThanBall:
      return en::count(
          "{0} of {1} presses have a dark part wider than the ball of {2:.2f} mm diameter "
          "({3} radius): check the ball's radius",
          "{0} of {1} presses has a dark part wider than the ball of {2:.2f} mm diameter "
          "({3} radius): check the ball's radius",
          count, of, 2 * one.given_mm, range_mm(one));
    case ContradictionKind::kContactDeeperThanLayer:
      return en::count(
          "{0} of {1} presses are deeper than the layer of {2:.2f} mm ({3}): check the layer's "
          "thickness and the ball's radius",
          "{0} of {1} presses is deeper than the layer of {2:.2f} mm ({3}): check the layer's "
          "thickness and the ball's radius",
          count, of, one.given_mm, range_mm(one));
    case ContradictionKind::kDepthBeyondMapping:
      return en::count(
          "{0} of {1} presses are darker than the mapping reaches ({3} deep, the mapping ends at "
          "{2:.2f} mm): calibrate again with them",
          "{0} of {1} presses is darker than the mapping reaches ({3} deep, the mapping ends at "
          "{2:.2f} mm): calibrate again with it",
          count, of, one.given_mm, range_mm(one));
    case ContradictionKind::kFaceWidthAgainstCamera:
      return en::say(
          "the specified face width is {:.2f} mm, but camera and presses show {}: check the width "
          "and the lens",
          one.given_mm, range_mm(one));
    case ContradictionKind::kReferenceContact:
      break;
  }
  return en::say(
      "in {} of {} presses the face is brighter than its reference {:.0f} mm along it: something "
      "pressed there when the reference was recorded; record it again, then calibrate again",
      count, of, one.measured_mm);
}

RecordedContradiction recorded(const Contradiction& one) {
  return {std::string(to_string(one.kind)),
          static_cast<int>(one.presses.size()),
          one.of,
          one.given_mm,
          one.measured_mm,
          one.measured_to_mm};
}

std::optional<Contradiction> from_record(const RecordedContradiction& recorded) {
  const auto* word =
      std::find(kContradictionWords.begin(), kContradictionWords.end(), recorded.kind);
  if (word == kContradictionWords.end()) return std::nullopt;
  Contradiction one;
  one.kind = static_cast<ContradictionKind>(word - kContradictionWords.begin() + 1);
  one.presses.resize(static_cast<std::size_t>(std::max(0, recorded.presses)));
  one.given_mm = recorded.given_mm;
  one.measured_mm = recorded.measured_mm;
  one.measured_to_mm = recorded.measured_to_mm;
  one.of = recorded.of;
  return one;
}

}  // namespace alltact
