#include "calibration/joint/contact_model.h"
#include "calibration/joint/joint_fit.h"
#include "core/numerics/median.h"

#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// A membrane on an elastic bed that a ball is pressed into, about its axis: the least-energy depth
/// w(rho) >= ball with l^2 (w'' + w' / rho) = w where it is free, by over-relaxation.
class Membrane {
 public:
  Membrane(double radius_mm, double pressed_mm, double lift_mm) : radius_(radius_mm) {
    height_ = radius_mm - pressed_mm;
    const double stiff = lift_mm * lift_mm / (kStepMm * kStepMm);
    const int count = static_cast<int>(
        (std::sqrt(2.0 * radius_mm * pressed_mm) + 10.0 * lift_mm + 0.2) / kStepMm);
    depth_.assign(static_cast<std::size_t>(count), 0.0);
    for (int round = 0; round < 6000; ++round)
      for (int i = 0; i + 1 < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double rho = (i + 0.5) * kStepMm;
        const double inner = (rho - 0.5 * kStepMm) / rho, outer = (rho + 0.5 * kStepMm) / rho;
        const double around = (i > 0 ? inner * depth_[k - 1] : 0.0) + outer * depth_[k + 1];
        const double free = stiff * around / (1.0 + stiff * ((i > 0 ? inner : 0.0) + outer));
        depth_[k] = std::max(ball(rho), depth_[k] + 1.8 * (free - depth_[k]));
      }
  }
  [[nodiscard]] double ball(double rho) const {
    const double square = radius_ * radius_ - rho * rho;
    return square > 0.0 ? std::sqrt(square) - height_ : -height_;
  }
  [[nodiscard]] double at(double rho) const {
    const double place = std::max(0.0, rho / kStepMm - 0.5);
    const auto i = static_cast<std::size_t>(place);
    if (i + 1 >= depth_.size()) return 0.0;
    return depth_[i] + (place - static_cast<double>(i)) * (depth_[i + 1] - depth_[i]);
  }
  [[nodiscard]] double height() const { return height_; }

 private:
  static constexpr double kStepMm = 0.02;
  double radius_, height_ = 0;
  std::vector<double> depth_;
};

TEST(LiftOff, IsThatOfASolvedMembrane) {
  for (const double radius : {3.5, 5.0})
    for (const double pressed : {0.4, 0.8})
      for (const double lift : {0.08, 0.2, 0.3}) {
        const Membrane membrane(radius, pressed, lift);
        double worst = 0, most = 0;
        for (double rho = 0.0; rho < std::sqrt(2.0 * radius * pressed) + 2.0 * lift; rho += 0.03) {
          const double ball = membrane.ball(rho), truth = membrane.at(rho);
          const SkinDepth skin = skin_depth(ball, membrane.height(), radius, lift);
          worst = std::max(worst, std::abs(skin.mm - truth));
          most = std::max(most, truth - std::max(0.0, ball));
        }
        EXPECT_GT(most, 0.008);
        EXPECT_LT(worst, std::max(0.004, 0.12 * most)) << radius << ' ' << pressed << ' ' << lift;
      }
}

TEST(LiftOff, IsTheBallWithoutALengthAndInTheMiddle) {
  for (const double ball : {0.6, 0.1, -0.2}) {
    const SkinDepth skin = skin_depth(ball, 3.4, 4.0, 0.0);
    EXPECT_EQ(skin.mm, ball);
    EXPECT_EQ(skin.by_ball, 1.0);
  }
  EXPECT_EQ(skin_depth(0.5, 3.4, 4.0, 0.2).mm, 0.5);
  EXPECT_EQ(skin_depth(-0.3, 4.1, 4.0, 0.2).mm, -0.3);  // a ball off the face
}

TEST(LiftOff, ItsDerivativesAreThoseOfDifferences) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  constexpr double kStep = 1e-6;
  for (int trial = 0; trial < 400; ++trial) {
    const double radius = 2.0 + 5.0 * uniform(random), height = radius - 0.2 - uniform(random),
                 lift = 0.02 + 0.4 * uniform(random), ball = 0.25 - 0.5 * uniform(random);
    const SkinDepth skin = skin_depth(ball, height, radius, lift);
    const auto slope = [&](double b, double h, double l) {
      const double up = skin_depth(ball + b, height + h, radius, lift + l).mm,
                   down = skin_depth(ball - b, height - h, radius, lift - l).mm;
      return (up - down) / (2.0 * kStep);
    };
    EXPECT_TRUE(std::isfinite(skin.mm));
    EXPECT_NEAR(skin.by_ball, slope(kStep, 0, 0), 1e-5);
    EXPECT_NEAR(skin.by_height, slope(0, kStep, 0), 1e-5);
    EXPECT_NEAR(skin.by_lift, slope(0, 0, kStep), 1e-5);
  }
}

/// Presses of a ball on a plane with a skin that lifts off, as block means 0.18 mm apart.
struct LiftedWorld {
  std::vector<PressSamples> samples;
  std::vector<Eigen::Vector3d> centres_mm;
  ChoiceInput input;  // the balls a little off

  static double x_of(double depth_mm) { return depth_mm / (2.6 - 0.7 * depth_mm); }

  LiftedWorld(double lift_mm, double x_sd, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::normal_distribution<double> noise(0.0, x_sd);
    const double radius = 4.0 + 1.5 * uniform(random);
    constexpr int kPresses = 6, kSide = 17;
    samples.reserve(kPresses);
    for (int i = 0; i < kPresses; ++i) {
      const double pressed = 0.35 + 0.14 * i + 0.05 * uniform(random);
      const Membrane membrane(radius, pressed, lift_mm);
      const Eigen::Vector3d centre(0.3 * uniform(random), 0.3 * uniform(random),
                                   40.0 + membrane.height());
      PressSamples press;
      press.ball_radius_mm = radius;
      press.block_px = 1;
      press.x_sd = x_sd;
      for (int v = -kSide; v <= kSide; ++v)
        for (int u = -kSide; u <= kSide; ++u) {
          Sample sample;
          sample.pixel = {u + kSide, v + kSide};
          sample.untouched_n = sample.untouched_z = {0.18 * u, 0.18 * v, 40.0};
          sample.normal = Eigen::Vector3d::UnitZ();
          sample.position_mm = sample.untouched_n.head<2>();
          sample.by_u = {0.18, 0.0, 0.0};
          sample.by_v = {0.0, 0.18, 0.0};
          const double rho = (sample.untouched_n - centre).head<2>().norm();
          if (rho > 1.06 * radius) continue;
          sample.x = x_of(membrane.at(rho)) + noise(random);
          press.samples.push_back(sample);
        }
      samples.push_back(std::move(press));
      centres_mm.push_back(centre);
      input.centres_mm.push_back(centre + Eigen::Vector3d(0.02, -0.02, 0.03 * uniform(random)));
    }
    for (const PressSamples& press : samples) input.presses.push_back(&press);
  }
};

TEST(LiftOff, IsThatOfTheMappingWhereOnlyABallIsFree) {
  std::mt19937 random(7);
  constexpr double kLiftMm = 0.2;
  const LiftedWorld world(kLiftMm, 0.001, random);
  MappingCurve curve({MappingKind::kMoebius, 2}, 0.5);
  curve.values() << 2.6, 0.7;
  JointOptions options;
  options.zone = 1.0;
  options.fix_mapping = true;
  for (const bool was_free : {false, true}) {
    options.free_lift = was_free;
    for (std::size_t i = 0; i < world.samples.size(); ++i) {
      const JointFit fit =
          fit_jointly({&world.samples[i]}, {curve, {world.input.centres_mm[i]}, false, kLiftMm},
                      options, Job{});
      EXPECT_TRUE(fit.converged);
      EXPECT_EQ(fit.lift_mm, kLiftMm);
      EXPECT_LT((fit.centres_mm[0] - world.centres_mm[i]).norm(), 0.004) << i;
    }
  }
}

TEST(LiftOff, DoesNotScaleTheMapping) {
  std::vector<double> off;
  for (unsigned run = 0; run < 6; ++run) {
    std::mt19937 random(100 + run);
    const double lift = 0.05 + 0.06 * run;
    LiftedWorld world(lift, 0.003, random);
    CalibrationSettings settings;
    settings.along = AlongChoice::kZ;
    const auto choice = choose_model(world.input, settings, Job{});
    ASSERT_TRUE(choice) << lift;
    const double x = 0.9 * choice->fit.curve.x_max();
    const double truth = 2.6 * x / (1.0 + 0.7 * x);
    off.push_back(std::abs(choice->fit.curve.depth_mm(x) / truth - 1.0));
    std::printf("[ figures  ] lift-off %.3f mm: scale %.4f, zone %.2f, told %.3f mm\n", lift,
                choice->fit.curve.depth_mm(x) / truth, choice->options.zone, choice->fit.lift_mm);
  }
  EXPECT_LT(upper_median(off), 0.01);
  EXPECT_LT(*std::max_element(off.begin(), off.end()), 0.03);
}

/// By the inner zone alone all balls lie too deep or too shallow by one amount, however quiet the
/// images are.
TEST(LiftOff, QuietImagesAreReadBeyondTheInnerZoneToo) {
  std::vector<double> inner_off, off;
  for (unsigned run = 0; run < 6; ++run) {
    std::mt19937 random(200 + run);
    LiftedWorld world(0.05 + 0.06 * run, 0.0004, random);
    CalibrationSettings settings;
    settings.along = AlongChoice::kZ;
    const auto choice = choose_model(world.input, settings, Job{});
    ASSERT_TRUE(choice);
    const JointOptions inner;
    const JointFit start = straight_start(world.input, inner.along, choice->fit.curve.x_max());
    const JointFit alone =
        fit_jointly(world.input.presses, as_family(start, kLayerFamily), inner, Job{});
    const double x = 0.9 * choice->fit.curve.x_max();
    const double truth = 2.6 * x / (1.0 + 0.7 * x);
    off.push_back(std::abs(choice->fit.curve.depth_mm(x) / truth - 1.0));
    inner_off.push_back(std::abs(alone.curve.depth_mm(x) / truth - 1.0));
    std::printf("[ figures  ] zone %.2f: scale off by %.4f, by the inner zone alone %.4f\n",
                choice->options.zone, off.back(), inner_off.back());
  }
  EXPECT_LT(upper_median(off), 0.7 * upper_median(inner_off));
}

}  // namespace
}  // namespace alltact
