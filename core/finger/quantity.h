// Physical quantities that people type: unit, possible and plausible range, each declared once.
// Flags, fields of the window, files and tables check against these.
#pragma once

#include "core/message.h"

#include <optional>
#include <string_view>

namespace alltact {

/// Both ranges are inclusive. A value outside `possible` is refused, one outside `plausible` is
/// accepted with a warning: often its decimal mark is at the wrong position, or its unit is another
/// one.
struct Quantity {
  struct Range {
    double low, high;
    [[nodiscard]] bool holds(double value) const { return value >= low && value <= high; }
  };
  std::string_view key;  ///< in files and flags: "layer_mm"
  std::string_view unit;
  Range possible;
  Range plausible;
  Message (*meaning)();  ///< "the thickness of the layer"

  /// "must be a number from 0.05 to 20 mm"; nullopt: possible. NaN is impossible.
  [[nodiscard]] std::optional<Message> refusal(double value) const;
  /// The warning for an implausible value, with the plausible range; nullopt: plausible. For an
  /// impossible value, the refusal.
  [[nodiscard]] std::optional<Message> warning(double value) const;
};

/// Sources of the plausible ranges: balls, layers and fingers of vision-based tactile sensors that
/// are published or sold (GelSight, DIGIT, 9DTact, DelTact, Fin Ray grippers), twice as wide on
/// either side. The possible ranges end where optics or a hand in a laboratory end.
inline constexpr Quantity kBallRadius{
    "ball_radius_mm", "mm", {0.1, 100}, {0.5, 20}, [] { return en::say("the radius of a ball"); }};
inline constexpr Quantity kFaceWidth{
    "width_mm", "mm", {0.5, 500}, {5, 120}, [] { return en::say("the width of a face"); }};
inline constexpr Quantity kLayerThickness{
    "layer_mm", "mm", {0.01, 50}, {0.3, 5}, [] { return en::say("the thickness of a layer"); }};
inline constexpr Quantity kPlaneDistance{"plane_z_mm", "mm", {0.001, 10000}, {2, 500}, [] {
                                           return en::say("the distance of a flat face");
                                         }};
inline constexpr Quantity kPressDepth{
    "depth_mm", "mm", {1e-4, 50}, {0.02, 5}, [] { return en::say("the depth of a press"); }};
inline constexpr Quantity kDepthSd{"depth_sd_mm", "mm", {1e-4, 50}, {1e-4, 0.3}, [] {
                                     return en::say("how well a depth is known");
                                   }};
inline constexpr Quantity kStepHeight{
    "step_mm", "mm", {1e-4, 50}, {0.02, 5}, [] { return en::say("the step of a punch"); }};
inline constexpr Quantity kBoardSquare{
    "square_mm", "mm", {0.01, 1000}, {0.5, 50}, [] { return en::say("the side of a square"); }};
inline constexpr Quantity kKnownLength{"known_length_mm", "mm", {0.001, 1000}, {1, 200}, [] {
                                         return en::say("a length on a finger");
                                       }};

}  // namespace alltact
