// A bonded soft layer of constant volume swells around a press. Beyond the contact's rim it
// thickens by share * layer * f(q), q = (distance from the rim) / width_mm: a ring of that height
// one width away from the rim.
//   tail gaussian (the default): f = q^2 exp(1 - q^2).
//   tail exponential: f = (q exp(1 - q))^steepness. A thin incompressible layer on a rigid base
//   decays exponentially (K. L. Johnson, Contact Mechanics, 5.8). Real sensors do so, with a halo
//   of four widths and more; the larger the steepness, the narrower the ring.
#include "core/simulation/effect.h"
#include "core/simulation/frame_geometry.h"

#include <opencv2/imgproc.hpp>

namespace alltact {

namespace {

constexpr double kRingEnd = 1e-7;  // of the ring's height: negligible

struct Ring {
  double height_mm = 0, width_mm = 1;
  double steepness = 0;  // 0: the Gaussian tail
  double end_mm = 0;     // from the rim

  [[nodiscard]] double at(double from_rim_mm) const {
    const double q = from_rim_mm / width_mm;
    if (q <= 0) return 0;
    if (steepness == 0) return height_mm * (q * q * std::exp(1 - q * q));
    return height_mm * std::exp(steepness * (std::log(q) + 1 - q));
  }
  void find_end() {
    end_mm = 4.5 * width_mm;
    if (steepness == 0) return;  // below kRingEnd there
    end_mm = width_mm;
    while (at(end_mm) > kRingEnd * height_mm) end_mm += 0.25 * width_mm;
  }
};

void swell(BallPress& press, const Ring& ring) {
  const double end = press.rim_mm + ring.end_mm;
  const auto n = static_cast<std::size_t>(end / BallPress::kStep_mm) + 1;
  if (press.profile_mm.size() < n) press.profile_mm.resize(n, 0.0F);
  for (std::size_t i = 0; i < press.profile_mm.size(); ++i) {
    const double r = static_cast<double>(i) * BallPress::kStep_mm;
    press.profile_mm[i] -= static_cast<float>(ring.at(r - press.rim_mm));
  }
}

void swell(SampledPress& press, const Ring& ring) {
  pad_grid(press, static_cast<int>(ring.end_mm / press.step_mm) + 1);
  cv::Mat_<float>& grid = press.depth_mm;
  // The rim of a smoothed press: where most of the depth is lost.
  const cv::Mat outside = grid <= 0.05 * press.pose.depth_mm;
  cv::Mat_<float> distance;
  cv::distanceTransform(outside, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.cols; ++column)
      grid(row, column) -= static_cast<float>(ring.at(distance(row, column) * press.step_mm) /
                                              press.pose.normal.z());
}

class Bulge final : public GeometryEffect {
 public:
  explicit Bulge(YamlSection& p)
      : share_(p.number("share", strength_up_to(0.5))),
        width_mm_(p.number("width_mm", strength_up_to(20))) {
    if (p.has("tail") && p.choice("tail", {"gaussian", "exponential"}) == 1)
      steepness_ = p.number("steepness", {0.5, 20});
  }

  Status validate(const SceneFacts& scene) const override {
    if (!scene.ball_presses && !scene.body_presses)
      return Error{en::say("nothing is pressed in, so nothing bulges"), "",
                   en::say("add ball or relief")};
    return {};
  }

  void apply(const FrameContext&, FrameGeometry& geometry) const override {
    sample_bodies(geometry);
    for (auto& press : geometry.presses) {
      if (auto* ball = std::get_if<BallPress>(&press))
        swell(*ball, ring_about(ball->pose));
      else if (auto* grid = std::get_if<SampledPress>(&press))
        swell(*grid, ring_about(grid->pose));
    }
  }

 private:
  [[nodiscard]] Ring ring_about(const PressPose& pose) const {
    Ring ring{share_ * pose.layer_mm, width_mm_, steepness_};
    ring.find_end();
    return ring;
  }

  double share_, width_mm_;
  double steepness_ = 0;  // 0: the Gaussian tail
};

}  // namespace

EffectKind effect_bulge() {
  return effect_kind<Bulge>("bulge", 50, en::say("The layer bulges around the object"),
                            "share: 0.03, width_mm: 1.5", {"ball"});
}

}  // namespace alltact
