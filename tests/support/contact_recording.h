// Recordings of a simulated finger that bends untouched, but for touches that are drawn at random
// and known frame by frame.
#pragma once

#include "core/finger/finger.h"
#include "core/simulation/plan.h"
#include "core/simulation/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace alltact::test {

/// How the depth of a touch changes in time.
enum class TouchProfile {
  kSlow = 1,  ///< sin^2 from nothing to nothing
  kAbrupt,    ///< full depth from its first to its last frame
  kHeld,      ///< grows softly, is held, relaxes softly
  kFading,    ///< begins at full depth, relaxes as the second half of sin^2 does
  kGrowing,   ///< the same in reverse
};

struct DrawnTouch {
  TouchProfile profile = TouchProfile::kSlow;
  int first = 0, end = 0;  ///< frames
  double depth_mm = 0;     ///< greatest
  double s_mm = 50, y_mm = 0;
  double to_s_mm = 50;  ///< where it has moved to in its last frame
  std::string body;     ///< the simulation's effect with its own parameters
  double give_mm = 0;   ///< how far the tip goes back at full depth

  /// 0 outside its frames.
  [[nodiscard]] double depth_at(int frame) const {
    if (frame < first || frame >= end) return 0;
    const double part = (frame - first + 0.5) / (end - first);
    const auto soft = [](double x) { return std::pow(std::sin(0.5 * std::numbers::pi * x), 2); };
    switch (profile) {
      case TouchProfile::kSlow:
        return depth_mm * std::pow(std::sin(std::numbers::pi * part), 2);
      case TouchProfile::kAbrupt:
        return depth_mm;
      case TouchProfile::kHeld:
        return depth_mm * soft(std::min({1.0, 4 * part, 4 * (1 - part)}));
      case TouchProfile::kFading:
        return depth_mm * soft(1 - part);
      case TouchProfile::kGrowing:
        return depth_mm * soft(part);
    }
    return 0;
  }
};

/// A recording as the scene that makes it.
struct TouchedRecording {
  std::uint64_t seed = 0;
  int width = 240, height = 135;
  int frames = 200;
  int frames_per_move = 12;
  std::vector<DrawnTouch> touches;
  std::string light;                         ///< effects that change it, as lines of the scene
  double lamp_power = 1, lamp_moved_mm = 0;  ///< of the lamp that shines along the finger
  double noise_sd = 1.0;
  bool bulges = false;

  [[nodiscard]] double depth_at(int frame) const {
    double depth = 0;
    for (const DrawnTouch& touch : touches) depth = std::max(depth, touch.depth_at(frame));
    return depth;
  }

  [[nodiscard]] std::string scene() const {
    const double scale = width / 960.0;
    std::string text = fmt::format(
        "name: touched recording\nwhy: a test\nframes: {}\nframes_per_s: 30\nfinger:\n"
        "  camera: {{model: pinhole, size: [{}, {}], fx: {}, fy: {}, cx: {}, cy: {}}}\n"
        "  face: {{kind: fin_ray, width_mm: 24.0, layer_mm: 1.5}}\n"
        "  markers: {{per_row: 6, polarity: bright}}\n"
        "untouched: {{x_mm: -25.0, z_mm: 28.0, incline_deg: 34.0, length_mm: 116.0}}\n"
        "motion: {{kind: wander, frames_per_move: {}}}\n"
        "effects:\n"
        "  - {{use: bend, q1_mm: {{from: -6.0, to: 6.0}}, q2_mm: {{from: -5.0, to: 5.0}}}}\n"
        "  - {{use: sway, sway_mm: {{from: -3.0, to: 3.0}}}}\n",
        frames, width, height, 523.9 * scale, 523.9 * scale, 0.5 * (width - 1), 0.5 * (height - 1),
        frames_per_move);
    for (const DrawnTouch& touch : touches) {
      std::vector<std::string> depths, places, gives;
      for (int i = 0; i < frames; ++i) {
        const double depth = std::max(touch.depth_at(i), 1e-4);
        const double part =
            std::clamp((i - touch.first) / (touch.end - touch.first - 0.999), 0., 1.);
        depths.push_back(fmt::format("{:.4f}", depth));
        gives.push_back(
            fmt::format("{:.4f}", std::max(1e-4, touch.give_mm * depth / touch.depth_mm)));
        places.push_back(fmt::format("{:.3f}", touch.s_mm + part * (touch.to_s_mm - touch.s_mm)));
      }
      text += fmt::format(
          "  - {{use: {}, from: {}, until: {}, s_mm: [{}], y_mm: {:.3f}, depth_mm: [{}]{}}}\n",
          touch.body, touch.first, touch.end, fmt::join(places, ", "), touch.y_mm,
          fmt::join(depths, ", "),
          touch.give_mm > 0 ? fmt::format(", give_mm: [{}]", fmt::join(gives, ", ")) : "");
    }
    if (bulges)
      for (const DrawnTouch& touch : touches)
        if (touch.body.starts_with("ball")) {
          text +=
              fmt::format("  - {{use: bulge, from: {}, until: {}, share: 0.05, width_mm: 1.5}}\n",
                          touch.first, touch.end);
          break;
        }
    text +=
        "  - {use: markers, radius_mm: 1.5, setback_mm: 4.0, first: 0.1, last: 0.92, albedo: 0.9}\n"
        "  - {use: layer, scatter_per_mm: 0.6, along: normal}\n"
        "  - {use: sides, albedo: 0.12, depth_mm: 14.0}\n"
        "  - use: leds\n    lamps:\n"
        "      - {at_mm: [0.0, -3.0, 0.0], power: 270000.0}\n"
        "      - {at_mm: [0.0, 3.0, 0.0], power: 270000.0}\n";
    text += fmt::format(
        "      - {{at_mm: [4.0, {:.1f}, -20.0], power: {:.1f}, aim_mm: [71.0, 0.0, 93.0], lobe: "
        "8}}\n",
        lamp_moved_mm, 3300000.0 * lamp_power);
    text += light;
    text += fmt::format("  - {{use: read, sd: {:.2f}}}\n  - {{use: quantisation}}\n", noise_sd);
    return text;
  }

  /// The scene compiled; a failed test where it cannot be.
  [[nodiscard]] Plan plan() const {
    const auto parsed = Scene::parse(scene(), "touched recording");
    if (!parsed) ADD_FAILURE() << "seed " << seed << ": " << parsed.error().sentence();
    auto plan = Plan::compile(*parsed, seed);
    if (!plan) ADD_FAILURE() << "seed " << seed << ": " << plan.error().sentence();
    return std::move(*plan);
  }

  [[nodiscard]] std::string description() const {
    std::string text = fmt::format("seed {}: {} frames, {} a move, noise {:.2f}{}{}", seed, frames,
                                   frames_per_move, noise_sd, light.empty() ? "" : ", light drifts",
                                   bulges ? ", bulges" : "");
    for (const DrawnTouch& t : touches)
      text += fmt::format(
          "; {} to {} {} of {:.2f} mm at {:.0f} mm to {:.0f} mm, {:.1f} mm across, {}, give {:.1f}",
          t.first, t.end - 1,
          std::vector<const char*>{"", "slow", "abrupt", "held", "fading",
                                   "growing"}[static_cast<std::size_t>(t.profile)],
          t.depth_mm, t.s_mm, t.to_s_mm, t.y_mm, t.body, t.give_mm);
    return text;
  }
};

/// Draws the same on every machine, which the library's distributions do not.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) / 9007199254740992.0;
  }
  int whole(int low, int high) {  ///< both ends included
    return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(double part) { return between(0, 1) < part; }

 private:
  std::mt19937_64 random_;
};

inline std::string drawn_body(Draw& draw) {
  switch (draw.whole(0, 5)) {
    case 0:
      return fmt::format("cylinder, radius_mm: {:.2f}, length_mm: {:.1f}, rotation_deg: {:.0f}",
                         draw.between(2, 6), draw.between(6, 16), draw.between(-90, 90));
    case 1:
      return fmt::format(
          "edge, angle_deg: {:.0f}, radius_mm: {:.2f}, length_mm: {:.1f}, rotation_deg: {:.0f}",
          draw.between(80, 130), draw.between(0.5, 1.5), draw.between(6, 14),
          draw.between(-90, 90));
    case 2:
      return fmt::format("punch, radius_mm: {:.2f}", draw.between(1.5, 4));
    default:
      return fmt::format("ball, radius_mm: {:.2f}", draw.between(2.5, 8));
  }
}

/// One touch within frames [first, end).
inline DrawnTouch drawn_touch(Draw& draw, int first, int end) {
  DrawnTouch touch;
  touch.first = first, touch.end = end;
  constexpr TouchProfile kProfiles[] = {TouchProfile::kSlow,   TouchProfile::kSlow,
                                        TouchProfile::kAbrupt, TouchProfile::kHeld,
                                        TouchProfile::kFading, TouchProfile::kGrowing};
  touch.profile = kProfiles[draw.whole(0, 5)];
  if (touch.profile == TouchProfile::kFading && first > 0) touch.profile = TouchProfile::kHeld;
  // Between these a pixel of half a millimetre does not show it above its noise.
  touch.depth_mm = draw.chance(0.25) ? draw.between(0.03, 0.1) : draw.between(0.25, 0.9);
  touch.s_mm = touch.to_s_mm = draw.between(12, 92);
  if (draw.chance(0.3)) touch.to_s_mm = std::clamp(touch.s_mm + draw.between(-18, 18), 12.0, 92.0);
  touch.y_mm = draw.chance(0.25) ? (draw.chance(0.5) ? 1 : -1) * draw.between(8.5, 11.5)
                                 : draw.between(-8.5, 8.5);
  touch.body = drawn_body(draw);
  if (draw.chance(0.5)) touch.give_mm = touch.depth_mm * draw.between(0.5, 3);
  return touch;
}

inline TouchedRecording drawn_recording(std::uint64_t seed, bool touched) {
  Draw draw(seed);
  TouchedRecording recording;
  recording.seed = seed;
  recording.frames = draw.whole(220, 280);
  recording.frames_per_move = draw.whole(6, 10);
  recording.noise_sd = draw.between(0.6, 1.4);
  switch (draw.whole(0, 3)) {
    case 0:
      recording.light = fmt::format("  - {{use: warming, loss: {:.3f}, after_s: {:.1f}}}\n",
                                    draw.between(0.01, 0.1), draw.between(1, 8));
      break;
    case 1:
      recording.light = fmt::format("  - {{use: gain-drift, sd: {:.3f}, every_s: {:.1f}}}\n",
                                    draw.between(0.003, 0.02), draw.between(0.5, 5));
      break;
    default:
      break;
  }
  recording.bulges = draw.chance(0.3);
  if (!touched) return recording;
  // At most half of the frames, in one to four stretches that do not meet.
  const int count = draw.whole(1, 4);
  int left = recording.frames / 2;
  const int slot = recording.frames / count;
  for (int i = 0; i < count && left >= 8; ++i) {
    const int most = std::min({left, slot - 2, 110});
    const int length =
        draw.chance(0.3) && count > 1 ? draw.whole(4, 12) : draw.whole(std::min(12, most), most);
    int first = i * slot + draw.whole(0, std::max(0, slot - length - 1));
    if (i == 0 && draw.chance(0.35)) first = 0;
    recording.touches.push_back(drawn_touch(draw, first, first + length));
    left -= length;
  }
  return recording;
}

/// Made apart: slow touches, 0.35 to 0.8 mm deep, in half of the frames from the first one on.
inline TouchedRecording half_touched_recording(std::uint64_t seed, int frames = 240) {
  Draw draw(seed);
  TouchedRecording recording;
  recording.seed = seed;
  recording.frames = frames;
  recording.frames_per_move = 8;
  const int count = 4, slot = frames / 8;
  for (int i = 0; i < count; ++i) {
    DrawnTouch touch;
    touch.first = 2 * i * slot, touch.end = touch.first + slot;
    touch.depth_mm = draw.between(0.35, 0.8);
    touch.s_mm = touch.to_s_mm = draw.between(20, 95);
    touch.y_mm = draw.between(-7, 7);
    touch.body = fmt::format("ball, radius_mm: {:.2f}", draw.between(3, 6));
    recording.touches.push_back(touch);
  }
  return recording;
}

}  // namespace alltact::test
