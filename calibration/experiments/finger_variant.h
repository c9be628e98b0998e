// Scenes on other fingers than the one they were written for.
//
// BACKGROUND
// A result on one finger may hold for that finger only. A scene describes a finger and what happens
// to it. The finger can be exchanged, so that the same experiment runs on other sizes, lenses,
// light, markers and stiffness.
#pragma once

#include "core/result.h"
#include "core/simulation/scene.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace alltact {

/// A scene's description of its finger. Defaults: that of the demonstration.
struct FingerVariant {
  double width_mm = 24, layer_mm = 1.5;
  double x_mm = -25, z_mm = 28, incline_deg = 34, length_mm = 116;
  double focal_px = 523.9;  ///< in an image of 960 x 540
  double cx_px = 479.5, cy_px = 269.5;
  int per_row = 6;
  double dot_radius_mm = 1.5, setback_mm = 4, first = 0.1, last = 0.92, dot_albedo = 0.9;
  double scatter_per_mm = 0.6, side_albedo = 0.12;
  double light = 1;  ///< of all lamps, as a factor on the scene's value
  double shore_a = 40, wall_mm = 4, base_depth_mm = 34, tip_depth_mm = 12, coupling = 0.6;
  double layer_shore_a = 5;
  double scale = 1;                  ///< of the image: 0.5 is 480 x 270
  std::optional<double> room_level;  ///< of the effect ambient; empty: the scene's value

  /// A random finger, as another maker might cast it, in images of 960 x 540; the same for the same
  /// seed and number. Half that resolution costs a quarter of the time, but a ball at the tip
  /// covers ten pixels only. Its presses do not determine the layer's direction of thickness, and
  /// the wrong one moves every position by layer_mm tan(incline), a millimetre.
  [[nodiscard]] static FingerVariant draw(std::uint64_t seed, int number);
};

/// A scene of the resources with its finger exchanged: camera, face, pose and number of markers. Of
/// the effects markers, layer, sides, leds, body and push the parts that describe the finger
/// change, and the light of the room where it is given. Keys that a scene does not name are not
/// added. Errors: those of Scene::parse.
///   origin: the file, for errors; other files that it names are relative to it
[[nodiscard]] Result<Scene> scene_on_finger(std::string_view yaml,
                                            const std::filesystem::path& origin,
                                            const FingerVariant& finger);

/// The text of that scene.
[[nodiscard]] Result<std::string> scene_text_on_finger(std::string_view yaml,
                                                       const std::filesystem::path& origin,
                                                       const FingerVariant& finger);

}  // namespace alltact
