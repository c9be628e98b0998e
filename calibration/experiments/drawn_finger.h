// Scenes on other fingers than the one they were written for.
//
// BACKGROUND
// What holds for one finger may hold for that one alone. A scene says what happens to a finger and
// what finger that is; the second can be exchanged, so that the same experiment is made on fingers
// of other sizes, lenses, light, markers and stiffness.
#pragma once

#include "core/result.h"
#include "core/simulation/scene.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace alltact {

/// What a scene says of its finger. As it stands here: that of the demonstration.
struct DrawnFinger {
  double width_mm = 24, layer_mm = 1.5;
  double x_mm = -25, z_mm = 28, incline_deg = 34, length_mm = 116;
  double focal_px = 523.9;  ///< in a picture of 960 x 540
  double cx_px = 479.5, cy_px = 269.5;
  int per_row = 6;
  double dot_radius_mm = 1.5, setback_mm = 4, first = 0.1, last = 0.92, dot_albedo = 0.9;
  double scatter_per_mm = 0.6, side_albedo = 0.12;
  double light = 1;  ///< of all lamps, as a part of what the scene says
  double shore_a = 40, wall_mm = 4, base_depth_mm = 34, tip_depth_mm = 12, coupling = 0.6;
  double layer_shore_a = 5;
  double scale = 1;                  ///< of the picture: 0.5 is 480 x 270
  std::optional<double> room_level;  ///< of the effect ambient; absent: what the scene says

  /// A finger as somebody else might have cast it, in pictures of 960 x 540. Half of that each way
  /// costs a quarter of the time, but shows a ball at the tip on ten pixels: its presses do not
  /// tell along which thickness of the layer the brightness goes, and the wrong one moves every
  /// place by layer_mm tan(incline), a millimetre. The same for the same seed and number.
  [[nodiscard]] static DrawnFinger draw(std::uint64_t seed, int number);
};

/// A scene of the resources with its finger exchanged: camera, face, how it lies and how many
/// markers it has, and of the effects markers, layer, sides, leds, body and push what describes the
/// finger, and the light of the room where one is given. Keys that a scene does not name are not
/// added. Errors: those of Scene::parse.
///   origin: the file, for errors, and beside which other files that it names lie
[[nodiscard]] Result<Scene> scene_on_finger(std::string_view yaml,
                                            const std::filesystem::path& origin,
                                            const DrawnFinger& finger);

/// The text of that scene.
[[nodiscard]] Result<std::string> scene_text_on_finger(std::string_view yaml,
                                                       const std::filesystem::path& origin,
                                                       const DrawnFinger& finger);

}  // namespace alltact
