// The fraction of each pixel that a convex outline covers.
#include "core/simulation/effect.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

struct Coverage {
  cv::Point corner;          ///< top left pixel
  cv::Mat_<float> fraction;  ///< 0..1; empty when the outline lies outside the image
};

using Outline = std::vector<Eigen::Vector2d>;

// Clips a convex polygon to sign * coordinate <= sign * limit.
Outline clip(const Outline& polygon, int axis, double limit, double sign) {
  Outline clipped;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (limit - a[axis]), db = sign * (limit - b[axis]);
    if (da >= 0) clipped.push_back(a);
    if ((da >= 0) != (db >= 0)) clipped.push_back(a + (b - a) * (da / (da - db)));
  }
  return clipped;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Coordinates are relative to the first corner, so that large values do not cancel.
double area(const Outline& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return 0.5 * std::abs(twice);
}

/// Exact areas of a convex polygon within pixels, clipped to the image. Pixel (0, 0) covers -0.5 to
/// 0.5.
Coverage convex_coverage(const Outline& outline, cv::Size size) {
  Eigen::Vector2d low = outline.front(), high = low;
  for (const auto& p : outline) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const auto pixel = [](double x, int end) {
    return static_cast<int>(std::clamp(std::floor(x + 0.5), -1.0, static_cast<double>(end)));
  };
  const int u0 = std::max(0, pixel(low.x(), size.width));
  const int u1 = std::min(size.width, pixel(high.x(), size.width) + 1);
  const int v0 = std::max(0, pixel(low.y(), size.height));
  const int v1 = std::min(size.height, pixel(high.y(), size.height) + 1);
  Coverage coverage{{u0, v0}, {}};
  if (u0 >= u1 || v0 >= v1) return coverage;
  coverage.fraction = cv::Mat_<float>::zeros(v1 - v0, u1 - u0);
  for (int v = v0; v < v1; ++v) {
    const Outline strip = clip(clip(outline, 1, v - 0.5, -1), 1, v + 0.5, 1);
    if (strip.size() < 3) continue;
    for (int u = u0; u < u1; ++u) {
      const Outline cell = clip(clip(strip, 0, u - 0.5, -1), 0, u + 0.5, 1);
      if (cell.size() >= 3) coverage.fraction(v - v0, u - u0) = static_cast<float>(area(cell));
    }
  }
  return coverage;
}

/// Centroid of the polygon.
Eigen::Vector2d centre_of_area(const Outline& outline) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weight = 0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const Eigen::Vector2d a = outline[i] - outline[0], b = outline[i + 1] - outline[0];
    sum += (a + b) * cross(a, b);
    weight += 3 * cross(a, b);
  }
  return outline[0] + (weight != 0 ? Eigen::Vector2d(sum / weight) : Eigen::Vector2d::Zero());
}

// Dots engraved in both side faces, `setback_mm` behind the face's edge (along the face's normal,
// towards the camera), evenly from `first` to `last` (fractions of the length). With
// `last_radius_mm` the radius changes linearly from radius_mm to that of the last dot. With
// `step_ratio` the steps grow by one factor, the last one being `step_ratio` times the first. Dots
// far from the camera are then neither too small nor too close together.

constexpr int kCorners = 96;

class Markers final : public GeometryEffect {
 public:
  explicit Markers(YamlSection& p)
      : radius_mm_(p.number("radius_mm", strength_up_to(20))),
        setback_mm_(p.number("setback_mm", strength_up_to(100))),
        first_(p.number("first", {0, 1})),
        last_(p.number("last", {0, 1})),
        albedo_(p.number("albedo", {0, 1})),
        last_radius_mm_(p.number_or("last_radius_mm", radius_mm_, strength_up_to(20))),
        step_ratio_(p.number_or("step_ratio", 1, {0.05, 20})) {
    if (!(first_ < last_))
      p.refuse("first", en::say("'first' is not below 'last'"), en::say("e.g. 0.1 and 0.9"));
    if (radius_mm_ >= setback_mm_)
      p.refuse("radius_mm", en::say("the dots would cut the face's edge"),
               en::say("less than setback_mm"));
    if (last_radius_mm_ >= setback_mm_)
      p.refuse("last_radius_mm", en::say("the dots would cut the face's edge"),
               en::say("less than setback_mm"));
  }

  Status validate(const SceneFacts& scene) const override {
    if (scene.finger.markers.per_row < 2)
      return Error{en::say("the finger has no markers"), "",
                   en::say("finger.markers with per_row and polarity")};
    if (!scene.has_effect("sides"))
      return Error{en::say("markers are engraved in the side faces"), "",
                   en::say("add the effect sides")};
    return {};
  }

  void apply(const FrameContext& frame, FrameGeometry& geometry) const override {
    const int n = frame.finger.markers.per_row;
    for (const int side : {-1, 1})
      for (int i = 0; i < n; ++i) {
        const double fraction = first_ + (last_ - first_) * fraction_at(i, n);
        const double radius = radius_mm_ + (last_radius_mm_ - radius_mm_) * i / (n - 1);
        geometry.discs.push_back(
            disc(geometry, fraction * geometry.curve()->length_mm(), side, radius));
      }
  }

 private:
  // Position of dot i of n, as a fraction from the first to the last: a geometric sum.
  [[nodiscard]] double fraction_at(int i, int n) const {
    const double factor = n > 2 ? std::pow(step_ratio_, 1.0 / (n - 2)) : 1.0;
    if (std::abs(factor - 1) < 1e-9) return static_cast<double>(i) / (n - 1);
    return std::expm1(i * std::log(factor)) / std::expm1((n - 1) * std::log(factor));
  }

  MarkerDisc disc(const FrameGeometry& geometry, double s_mm, int side, double radius_mm) const {
    const double across = side * geometry.face().width_mm / 2;
    auto body = geometry.body_point(s_mm, across, setback_mm_);
    body.point_mm += side_displacement_mm(geometry.drags, side, body.point_mm);
    const double incline = std::atan2(body.along.z(), body.along.x());
    const Camera& camera = geometry.rays().camera();
    std::vector<Eigen::Vector2d> outline;
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2 * std::numbers::pi * i / kCorners - incline;
      const auto pixel =
          camera.project(body.point_mm + radius_mm * (std::cos(angle) * body.along +
                                                      std::sin(angle) * body.normal));
      if (pixel) outline.push_back(*pixel);
    }
    MarkerDisc result{side, {0, 0}, outline.size() == kCorners, albedo_, {}, {}};
    if (!result.visible) return result;
    result.centre_px = centre_of_area(outline);
    const Coverage coverage = convex_coverage(outline, camera.size());
    result.corner = coverage.corner;
    result.coverage = coverage.fraction;
    result.visible = !coverage.fraction.empty();
    return result;
  }

  double radius_mm_, setback_mm_, first_, last_, albedo_, last_radius_mm_, step_ratio_;
};

}  // namespace

EffectKind effect_markers() {
  return effect_kind<Markers>("markers", 60, en::say("Dots are engraved in the side faces"),
                              "radius_mm: 1.5, setback_mm: 4, first: 0.1, last: 0.92, albedo: 0.9",
                              {"sides"});
}

}  // namespace alltact
