// The shape of the face where it leaves the pressing object.
//   hertz:  a ball is in contact only within a = sqrt(R delta) of its axis. Outside, the elastic
//           half space's (delta / pi) ((2 - q^2) asin(1/q) + sqrt(q^2 - 1)), q = r/a, scaled to
//           join the ball at a. `length_mm` fades it by exp(-(r - a) / length), as a thin layer
//           does.
//   smooth: the press is blurred with a Gaussian of standard deviation `length_mm`.
#include "core/simulation/effect.h"
#include "core/simulation/frame_geometry.h"
#include "core/simulation/mechanics/ball_contact.h"

namespace alltact {

namespace {

constexpr double kNegligible_mm = 1e-5;

void hertz(BallPress& press, double fade_length_mm, double max_reach_mm) {
  const double depth = press.pose.normal_depth_mm();
  const double a = std::sqrt(press.radius_mm * depth);
  const double at_rim = press.ball_profile(a);
  press.contact_radius_mm = press.rim_mm = a;
  press.profile_mm.clear();
  for (int i = 0;; ++i) {
    const double r = i * BallPress::kStep_mm;
    double h = press.ball_profile(std::min(r, a));
    if (r > a) {
      h = at_rim * 2 * hertz_tail(a / r);
      if (fade_length_mm > 0) h *= std::exp(-(r - a) / fade_length_mm);
      if (h < kNegligible_mm || r > max_reach_mm) break;
    }
    press.profile_mm.push_back(static_cast<float>(h));
  }
  press.profile_mm.push_back(0);
}

std::vector<double> gaussian(double sd_steps) {
  const int half = static_cast<int>(std::ceil(4 * sd_steps));
  std::vector<double> weights;
  double sum = 0;
  for (int i = -half; i <= half; ++i) {
    weights.push_back(std::exp(-0.5 * i * i / (sd_steps * sd_steps)));
    sum += weights.back();
  }
  for (double& w : weights) w /= sum;
  return weights;
}

void smooth(BallPress& press, double length_mm) {
  const double step = length_mm / 6;
  const std::vector<double> weights = gaussian(6);
  const int half = static_cast<int>(weights.size() / 2);
  const auto blurred_at = [&](double r) {
    double sum = 0;
    for (int j = -half; j <= half; ++j) {
      const double along = r + j * step,
                   weight = weights[static_cast<std::size_t>(std::ptrdiff_t{j} + half)];
      for (int k = 0; k <= half; ++k) {  // symmetric
        const double from_axis = std::sqrt(along * along + k * step * k * step);
        if (from_axis >= press.rim_mm) break;
        sum += (k == 0 ? weight : 2 * weight) *
               weights[static_cast<std::size_t>(std::ptrdiff_t{k} + half)] *
               press.ball_profile(from_axis);
      }
    }
    return sum;
  };
  const int n = static_cast<int>((press.rim_mm + 4 * length_mm) / BallPress::kStep_mm) + 2;
  press.profile_mm.clear();
  // Fills up to `end` from every `some`-th sample with Lagrange's cubic through them.
  const auto fill = [&](int end, int some) {
    const int first = static_cast<int>(press.profile_mm.size());
    const auto radius_at = [&](int i) { return std::abs(i) * BallPress::kStep_mm; };
    double before = blurred_at(radius_at(first - some)), a = blurred_at(radius_at(first)),
           b = blurred_at(radius_at(first + some));
    for (int i = first; i < end; i += some) {
      const double after = blurred_at(radius_at(i + 2 * some));
      for (int k = 0; k < some && i + k < end; ++k) {
        const double t = static_cast<double>(k) / some;
        press.profile_mm.push_back(static_cast<float>(
            -t * (t - 1) * (t - 2) / 6 * before + (t + 1) * (t - 1) * (t - 2) / 2 * a -
            (t + 1) * t * (t - 2) / 2 * b + (t + 1) * t * (t - 1) / 6 * after));
      }
      before = a, a = b, b = after;
    }
  };
  // Away from the rim the profile is as smooth as the ball, elsewhere as the Gaussian. Both stay
  // within 1e-6 mm.
  constexpr int kSome = 8;
  const double inner_mm = press.rim_mm - 4.2 * length_mm - 2 * kSome * BallPress::kStep_mm;
  if (inner_mm > 0) fill(static_cast<int>(inner_mm / BallPress::kStep_mm), kSome);
  fill(n, std::clamp(static_cast<int>(length_mm / 16 / BallPress::kStep_mm), 1, kSome));
  press.contact_radius_mm = 0;
}

cv::Mat_<float> blurred_rows(const cv::Mat_<float>& in, const std::vector<double>& weights) {
  const int half = static_cast<int>(weights.size() / 2);
  cv::Mat_<float> out(in.size());
  for (int row = 0; row < in.rows; ++row)
    for (int column = 0; column < in.cols; ++column) {
      double sum = 0;
      const int low = std::max(-half, -column), high = std::min(half, in.cols - 1 - column);
      for (int k = low; k <= high; ++k)
        sum += weights[static_cast<std::size_t>(std::ptrdiff_t{k} + half)] * in(row, column + k);
      out(row, column) = static_cast<float>(sum);
    }
  return out;
}

void smooth(SampledPress& press, double length_mm) {
  const double sd_steps = length_mm / press.step_mm;
  pad_grid(press, static_cast<int>(std::ceil(4 * sd_steps)) + 1);
  const std::vector<double> weights = gaussian(sd_steps);
  cv::Mat_<float> along;
  cv::transpose(blurred_rows(press.depth_mm, weights), along);
  cv::transpose(blurred_rows(along, weights), press.depth_mm);
}

class Rolloff final : public GeometryEffect {
 public:
  explicit Rolloff(YamlSection& p) : hertz_(p.choice("kind", {"hertz", "smooth"}) == 0) {
    length_mm_ = hertz_ ? p.number_or("length_mm", 0, strength_up_to(100))
                        : p.number("length_mm", {0.005, 5});
  }

  Status validate(const SceneFacts& scene) const override {
    if (!scene.ball_presses && !scene.body_presses)
      return Error{en::say("nothing is pressed in, so nothing rolls off"), "",
                   en::say("add ball or relief")};
    if (hertz_ && scene.body_presses)
      return Error{en::say("kind hertz is for balls only"), "",
                   en::say("kind: smooth with a length_mm")};
    return {};
  }

  void apply(const FrameContext&, FrameGeometry& geometry) const override {
    const FaceCurve* curve = geometry.curve();
    const double max_reach = curve ? curve->length_mm() + geometry.face().width_mm : 200;
    sample_bodies(geometry);
    for (auto& press : geometry.presses) {
      auto* ball = std::get_if<BallPress>(&press);
      if (ball && hertz_)
        hertz(*ball, length_mm_, max_reach);
      else if (ball)
        smooth(*ball, length_mm_);
      else
        smooth(std::get<SampledPress>(press), length_mm_);
    }
  }

 private:
  bool hertz_;
  double length_mm_;  // hertz: 0 is the half space, which does not fade
};

}  // namespace

EffectKind effect_rolloff() {
  return effect_kind<Rolloff>("rolloff", 40,
                              en::say("The face separates gradually from the object"),
                              "kind: hertz, length_mm: 0.8", {"ball"});
}

}  // namespace alltact
