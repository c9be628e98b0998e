// An edge, as of a box or a blade: two planes that form `angle_deg`, rounded by `radius_mm`. Their
// line lies along the finger's length unless rotated:
//   gap(y) = r - sqrt(r^2 - y^2)                 for |y| <= r cos(a), a half of the angle,
//   gap(y) = r (1 - 1 / sin a) + |y| / tan a     beyond, for |x| <= length / 2.
#include "core/simulation/press.h"
#include "core/simulation/rigid_press.h"

#include <numbers>

namespace alltact {

namespace {

constexpr double kHighest_mm = 20;  // height of an edge: above any layer's thickness

class EdgeBody final : public HeightField {
 public:
  EdgeBody(double angle_deg, double radius_mm, double length_mm)
      : half_rad_(angle_deg * std::numbers::pi / 360),
        radius_mm_(radius_mm),
        length_mm_(length_mm) {}
  double gap_mm(double x, double y) const override {
    if (std::abs(x) > length_mm_ / 2) return kNothing_mm;
    const double sin = std::sin(half_rad_), cos = std::cos(half_rad_), far = std::abs(y);
    if (far <= radius_mm_ * cos)
      return far * far / (radius_mm_ + std::sqrt(radius_mm_ * radius_mm_ - far * far) + 1e-300);
    return radius_mm_ * (1 - 1 / sin) + far * cos / sin;
  }
  Eigen::Vector2d half_size_mm() const override {
    return {length_mm_ / 2, kHighest_mm * std::tan(half_rad_) + radius_mm_};
  }

 private:
  double half_rad_, radius_mm_, length_mm_;
};

class Edge final : public RigidPress {
 public:
  explicit Edge(YamlSection& p) : RigidPress(p) {
    const double angle = p.number("angle_deg", {10, 170});
    const double radius = p.number_or("radius_mm", 0, strength_up_to(20));
    set_body(std::make_shared<EdgeBody>(angle, radius, p.number("length_mm", strength_up_to(200))));
  }
  Message sentence() const override { return en::say("An edge is pressed into the face"); }
};

}  // namespace

const EffectKind& effect_edge() {
  static const EffectKind kKind{
      "edge",
      Stage::kGeometry,
      33,
      [](YamlSection& p) -> std::shared_ptr<const Effect> { return std::make_shared<Edge>(p); },
      "angle_deg: 90, radius_mm: 0.2, length_mm: 14, rotation_deg: 30, s_mm: 50, y_mm: 0, "
      "depth_mm: 0.7"};
  return kKind;
}

}  // namespace alltact
