// Dots engraved in both side faces, `setback_mm` behind the face's edge (along the face's normal,
// towards the camera), evenly from `first` to `last` (fractions of the length). With
// `last_radius_mm` their radius goes evenly from radius_mm at the first to that at the last, so
// that those far from the camera do not get too small to see.
#include "core/simulation/coverage.h"
#include "core/simulation/effect.h"

#include <numbers>

namespace alltact {

namespace {

constexpr int kCorners = 96;

class Markers final : public GeometryEffect {
 public:
  explicit Markers(YamlSection& p)
      : radius_mm_(p.number("radius_mm", strength_up_to(20))),
        setback_mm_(p.number("setback_mm", strength_up_to(100))),
        first_(p.number("first", {0, 1})),
        last_(p.number("last", {0, 1})),
        albedo_(p.number("albedo", {0, 1})),
        last_radius_mm_(p.number_or("last_radius_mm", radius_mm_, strength_up_to(20))) {
    if (!(first_ < last_))
      p.refuse("first", en::say("'first' is not below 'last'"), en::say("e.g. 0.1 and 0.9"));
    if (radius_mm_ >= setback_mm_)
      p.refuse("radius_mm",
               en::say("the dots would cut the face's edge"),
               en::say("less than setback_mm"));
    if (last_radius_mm_ >= setback_mm_)
      p.refuse("last_radius_mm",
               en::say("the dots would cut the face's edge"),
               en::say("less than setback_mm"));
  }

  Message sentence() const override { return en::say("Dots are engraved in the side faces"); }

  Status fits(const SceneFacts& scene) const override {
    if (scene.finger.markers.per_row < 2)
      return Error{en::say("the finger has no markers"),
                   "",
                   en::say("finger.markers with per_row and polarity")};
    if (!scene.names("sides"))
      return Error{en::say("markers are engraved in the side faces"),
                   "",
                   en::say("name the effect sides too")};
    return {};
  }

  void place(const FrameContext& frame, FrameGeometry& geometry) const override {
    const int n = frame.finger.markers.per_row;
    for (const int side : {-1, 1})
      for (int i = 0; i < n; ++i) {
        const double fraction = first_ + (last_ - first_) * i / (n - 1);
        const double radius = radius_mm_ + (last_radius_mm_ - radius_mm_) * i / (n - 1);
        geometry.discs.push_back(
            disc(geometry, fraction * geometry.curve()->length_mm(), side, radius));
      }
  }

 private:
  MarkerDisc disc(const FrameGeometry& geometry, double s_mm, int side, double radius_mm) const {
    const FaceCurve::Node p = geometry.curve()->at(s_mm);
    Eigen::Vector3d centre(p.x_mm + setback_mm_ * p.z_s,
                           p.shift_mm + side * geometry.face().width_mm / 2,
                           p.z_mm - setback_mm_ * p.x_s);
    centre += side_displacement_mm(geometry.drags, side, centre);
    const Camera& camera = geometry.rays().camera();
    std::vector<Eigen::Vector2d> outline;
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2 * std::numbers::pi * i / kCorners;
      const auto pixel =
          camera.project(centre + radius_mm * Eigen::Vector3d(std::cos(angle), 0, std::sin(angle)));
      if (pixel) outline.push_back(*pixel);
    }
    MarkerDisc result{side, {0, 0}, outline.size() == kCorners, albedo_, {}, {}};
    if (!result.visible) return result;
    result.centre_px = centre_of_area(outline);
    const Coverage coverage = convex_coverage(outline, camera.size());
    result.corner = coverage.corner;
    result.coverage = coverage.part;
    result.visible = !coverage.part.empty();
    return result;
  }

  double radius_mm_, setback_mm_, first_, last_, albedo_, last_radius_mm_;
};

}  // namespace

const EffectKind& effect_markers() {
  static const EffectKind kKind{
      "markers",
      Stage::kGeometry,
      60,
      [](YamlSection& p) -> std::shared_ptr<const Effect> { return std::make_shared<Markers>(p); },
      "radius_mm: 1.5, setback_mm: 4, first: 0.1, last: 0.92, albedo: 0.9",
      {"sides"}};
  return kKind;
}

}  // namespace alltact
