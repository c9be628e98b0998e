// Scenes for tests, as text.
#pragma once

#include "core/simulation/plan.h"

#include <cstring>
#include <string>

#include <gtest/gtest.h>

namespace alltact {

/// A small finger with these effects; lines 10 and on are `effects`.
inline std::string scene_text(const std::string& effects, const std::string& camera = "") {
  return "name: test\n"
         "why: a finger to test with\n"
         "finger:\n"
         "  camera: {" +
         (camera.empty()
              ? "model: pinhole, size: [320, 180], fx: 170, fy: 172, cx: 158.5, cy: 90.25"
              : camera) +
         "}\n"
         "  face: {kind: fin_ray, width_mm: 24.0, layer_mm: 1.5}\n"
         "  markers: {per_row: 6, polarity: bright}\n"
         "frames: 3\n"
         "untouched: {x_mm: -25.0, z_mm: 28.0, incline_deg: 34.0, length_mm: 116.0}\n" +
         (effects.empty() ? "effects: []\n" : "effects:\n" + effects);
}

inline Plan plan_of(const std::string& yaml, std::uint64_t seed = 7) {
  const auto scene = Scene::parse(yaml, "test.yaml");
  EXPECT_TRUE(scene) << scene.error().sentence();
  auto plan = Plan::compile(*scene, seed);
  EXPECT_TRUE(plan) << plan.error().sentence();
  return *plan;
}

/// The sentence that a scene is refused with; empty: it is not.
inline std::string refusal(const std::string& text) {
  const auto scene = Scene::parse(text, "test.yaml");
  if (!scene) return scene.error().sentence();
  const auto plan = Plan::compile(*scene, 1);
  return plan ? "" : plan.error().sentence();
}

inline bool same_bytes(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) return false;
  for (int v = 0; v < a.rows; ++v)
    if (std::memcmp(a.ptr(v), b.ptr(v), static_cast<std::size_t>(a.cols) * a.elemSize()) != 0)
      return false;
  return true;
}

}  // namespace alltact
