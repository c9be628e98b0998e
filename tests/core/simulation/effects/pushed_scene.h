// Fingers that are pushed, and what a plan's truth does not tell of them.
#pragma once

#include "core/simulation/plan.h"
#include "tests/core/simulation/effects/effect_scene.h"

#include <optional>

namespace alltact {

inline const std::string kPushedBody =
    "  - {use: body, shore_a: 40, wall_mm: 4, base_depth_mm: 34, tip_depth_mm: 12, coupling: "
    "0.6}\n";

/// A push with these parameters.
inline std::string pushing(const std::string& how, const std::string& face = "contact") {
  return "  - {use: push, face: " + face + ", " + how +
         (face == "contact" ? ", layer_shore_a: 5}\n" : "}\n");
}

/// A frame as a Plan places it, with what the plan's truth does not tell.
class PlacedScene {
 public:
  explicit PlacedScene(const std::string& text)
      : scene_(Scene::parse(text, "test.yaml").value()),
        rays_(Camera::create(scene_.finger.camera).value()) {}

  [[nodiscard]] FrameGeometry at(int frame, double later = 0) const {
    FramePlan plan(scene_, 7, frame);
    plan.move_to(later);
    std::optional<FaceCurve> curve;
    if (scene_.finger.face.kind == FaceKind::kFinRay) {
      curve.emplace(scene_.base_mm, scene_.incline_rad, scene_.length_mm);
      for (const auto& step : plan.geometry) step.effect->shape(step.context, *curve);
      curve->integrate();
    }
    FrameGeometry geometry(rays_, scene_.finger.face, std::move(curve));
    for (const auto& step : plan.geometry) step.effect->apply(step.context, geometry);
    return geometry;
  }
  [[nodiscard]] const PixelRays& rays() const { return rays_; }

 private:
  Scene scene_;
  PixelRays rays_;
};

inline Eigen::Vector3d tip_of(const FrameGeometry& geometry) {
  const FaceCurve::Node p = geometry.curve()->at(geometry.curve()->length_mm());
  return {p.x_mm, p.shift_mm, p.z_mm};
}

/// A finger's scene that is so many frames long.
inline std::string with_frames(int n, const std::string& effects) {
  std::string text = scene_text(effects);
  return text.replace(text.find("frames: 3"), 9, fmt::format("frames: {}", n));
}

}  // namespace alltact
