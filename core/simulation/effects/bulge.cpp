// A soft layer that is bonded and keeps its volume swells around a press: beyond the contact's rim
// it thickens by share * layer * q^2 exp(1 - q^2), q = (distance from the rim) / width_mm, a
// smooth ring of that height one width away from the rim.
#include "core/simulation/effect.h"
#include "core/simulation/press_sampling.h"

#include <opencv2/imgproc.hpp>

namespace alltact {

namespace {

double ring(double q) {
  return q > 0 ? q * q * std::exp(1 - q * q) : 0.0;
}
constexpr double kEnd = 4.5;  // where the ring is below 1e-7

void swell(BallPress& press, double height_mm, double width_mm) {
  const double end = press.rim_mm + kEnd * width_mm;
  const auto n = static_cast<std::size_t>(end / BallPress::kStep_mm) + 1;
  if (press.profile_mm.size() < n) press.profile_mm.resize(n, 0.0F);
  for (std::size_t i = 0; i < press.profile_mm.size(); ++i) {
    const double r = static_cast<double>(i) * BallPress::kStep_mm;
    press.profile_mm[i] -= static_cast<float>(height_mm * ring((r - press.rim_mm) / width_mm));
  }
}

void swell(SampledPress& press, double height_mm, double width_mm) {
  widen(press, static_cast<int>(kEnd * width_mm / press.step_mm) + 1);
  cv::Mat_<float>& grid = press.depth_mm;
  // The rim of a smoothed press: where it has lost most of its depth.
  const cv::Mat outside = grid <= 0.05 * press.place.depth_mm;
  cv::Mat_<float> distance;
  cv::distanceTransform(outside, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  const double height_along_z_mm = height_mm / press.place.normal.z();
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.cols; ++column)
      grid(row, column) -= static_cast<float>(
          height_along_z_mm * ring(distance(row, column) * press.step_mm / width_mm));
}

class Bulge final : public GeometryEffect {
 public:
  explicit Bulge(YamlSection& p)
      : share_(p.number("share", strength_up_to(0.5))),
        width_mm_(p.number("width_mm", strength_up_to(20))) {}

  Message sentence() const override { return en::say("The layer swells around what presses"); }

  Status fits(const SceneFacts& scene) const override {
    if (scene.pressed.empty())
      return Error{
          en::say("nothing presses, so nothing bulges"), "", en::say("name ball or relief too")};
    return {};
  }

  void place(const FrameContext&, FrameGeometry& geometry) const override {
    sample_bodies(geometry);
    for (auto& press : geometry.presses) {
      if (auto* ball = std::get_if<BallPress>(&press))
        swell(*ball, share_ * ball->place.layer_mm, width_mm_);
      else if (auto* grid = std::get_if<SampledPress>(&press))
        swell(*grid, share_ * grid->place.layer_mm, width_mm_);
    }
  }

 private:
  double share_, width_mm_;
};

}  // namespace

const EffectKind& effect_bulge() {
  static const EffectKind kKind{
      "bulge",
      Stage::kGeometry,
      50,
      [](YamlSection& p) -> std::shared_ptr<const Effect> { return std::make_shared<Bulge>(p); },
      "share: 0.03, width_mm: 1.5",
      {"ball"}};
  return kKind;
}

}  // namespace alltact
