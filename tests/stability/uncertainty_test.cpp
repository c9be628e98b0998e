// Reported uncertainties are true: over many runs the squared error, divided by the reported
// covariance, is one per unknown.
#include "calibration/joint/joint_fit.h"
#include "core/sensing/contact/push.h"
#include "tests/stability/trapping.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kRuns = 400;

/// Mean over runs of e' C^-1 e over the number of unknowns, in units of their standard deviations.
class Nees {
 public:
  void add(const Eigen::VectorXd& error, const Eigen::MatrixXd& covariance) {
    const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::VectorXd scaled = scale.cwiseProduct(error);
    const Eigen::MatrixXd correlation = scale.asDiagonal() * covariance * scale.asDiagonal();
    sum_ += scaled.dot(correlation.ldlt().solve(scaled)) / static_cast<double>(error.size());
    ++count_;
  }
  [[nodiscard]] double value() const { return sum_ / count_; }
  [[nodiscard]] int count() const { return count_; }

 private:
  double sum_ = 0;
  int count_ = 0;
};

void expect_true(const Nees& nees, const char* what) {
  std::printf("[ figures  ] normalised squared error of %s: %.3f\n", what, nees.value());
  EXPECT_EQ(nees.count(), kRuns) << what;
  EXPECT_GT(nees.value(), 0.85) << what;
  EXPECT_LT(nees.value(), 1.15) << what;
}

constexpr double kBallRadius = 4.0;

MappingCurve true_curve() {
  MappingCurve curve({MappingKind::kMoebius, 2}, 0.5);
  curve.values() << 2.4, 0.6;
  return curve;
}

/// How far each ring of a contact is off as a whole, in all presses of a run.
using RingOffsets = std::array<double, ContactDisc::kRings>;

RingOffsets draw_offsets(double sd_mm, std::mt19937& random) {
  std::normal_distribution<double> normal;
  RingOffsets offsets;
  for (double& offset : offsets) offset = sd_mm * normal(random);
  return offsets;
}

/// Block means of a press on a plane, 0.04 mm a pixel, with a pixel's noise as smoothing leaves it.
PressSamples noisy_press(const Eigen::Vector3d& centre, double pixel_sd, int block,
                         const RingOffsets& offsets, std::mt19937& random) {
  constexpr int kSide = 150;  // px
  constexpr double kMmPerPx = 0.04;
  cv::Mat grain(kSide, kSide, CV_32FC1);
  std::normal_distribution<double> normal;
  for (float& g : cv::Mat_<float>(grain)) g = static_cast<float>(pixel_sd * normal(random));
  cv::GaussianBlur(grain, grain, {9, 9}, 1.0);
  PressSamples press;
  press.block_px = block;
  // A block's mean of smoothed noise: nearly that of white noise, the blur only crosses its border.
  press.x_sd = pixel_sd / (block + 1.0);
  for (int v = 0; v + block <= kSide; v += block)
    for (int u = 0; u + block <= kSide; u += block) {
      Sample sample;
      sample.pixel = {u + 0.5 * (block - 1), v + 0.5 * (block - 1)};
      sample.untouched_n << kMmPerPx * (sample.pixel.array() - 0.5 * (kSide - 1)), 40.0;
      sample.untouched_z = sample.untouched_n;
      sample.normal = Eigen::Vector3d::UnitZ();
      double depth = ball_depth_mm(sample, MappingAlong::kZ, centre, kBallRadius);
      if (!std::isfinite(depth)) continue;
      sample.x = cv::mean(grain(cv::Rect(u, v, block, block)))[0];
      press.samples.push_back(sample);
    }
  press.ball_radius_mm = kBallRadius;
  const ContactDisc disc(press, MappingAlong::kZ, centre);
  for (Sample& sample : press.samples) {
    const auto ring =
        static_cast<std::size_t>(disc.position_of(sample).patch / ContactDisc::kSectors);
    const double depth =
        std::max(-0.3, ball_depth_mm(sample, MappingAlong::kZ, centre, kBallRadius)) +
        offsets[ring];
    sample.x += depth / (2.4 - 0.6 * depth);  // what the true curve reads as this depth
  }
  return press;
}

struct Presses {
  std::vector<PressSamples> samples;
  std::vector<Eigen::Vector3d> centres;
  [[nodiscard]] std::vector<const PressSamples*> pointers() const {
    std::vector<const PressSamples*> all;
    for (const auto& s : samples) all.push_back(&s);
    return all;
  }
};

Presses draw_presses(int count, double pixel_sd, int block, double ring_sd_mm,
                     std::mt19937& random) {
  const RingOffsets offsets = draw_offsets(ring_sd_mm, random);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Presses presses;
  for (int i = 0; i < count; ++i) {
    const double depth = count == 1 ? 0.9 : 0.4 + 0.8 * (i + uniform(random)) / count;
    presses.centres.emplace_back(0.3 * (uniform(random) - 0.5), 0.3 * (uniform(random) - 0.5),
                                 40.0 + kBallRadius - depth);
    presses.samples.push_back(
        noisy_press(presses.centres.back(), pixel_sd, block, offsets, random));
  }
  return presses;
}

JointOptions options() {
  JointOptions o;
  o.zone = 0.85;
  return o;
}

/// 1 grey level at a brightness of 120, of the picture and of its reference.
constexpr double kPixelSd = 1.4 / 120;

TEST(Uncertainty, OfTheBallIsTrue) {
  for (const int block : {2, 5}) {
    Nees nees;
    for (int run = 0; run < kRuns; ++run) {
      std::mt19937 random(3000 + run);
      const Presses presses = draw_presses(1, kPixelSd, block, kFloorMm, random);
      JointOptions o = options();
      o.fix_mapping = true;
      const JointFit fit =
          fit_jointly(presses.pointers(), {true_curve(), presses.centres}, o, Job{});
      const Eigen::MatrixXd found = covariance_of(presses.pointers(), fit, o);
      ASSERT_EQ(found.rows(), 2 + 3);
      EXPECT_TRUE(found.topRows<2>().isZero(0));
      nees.add(fit.centres_mm[0] - presses.centres[0], found.bottomRightCorner<3, 3>());
    }
    expect_true(nees, fmt::format("the ball, blocks of {} px", block).c_str());
  }
}

TEST(Uncertainty, OfTheMappingAndItsBallsIsTrue) {
  for (const int block : {3, 5}) {
    Nees mapping, ball, all;
    for (int run = 0; run < kRuns; ++run) {
      std::mt19937 random(4000 + run);
      const Presses presses = draw_presses(4, kPixelSd, block, kFloorMm, random);
      const JointFit fit =
          fit_jointly(presses.pointers(), {true_curve(), presses.centres}, options(), Job{});
      const Eigen::MatrixXd found = covariance_of(presses.pointers(), fit, options());
      ASSERT_EQ(found.rows(), 2 + 3 * 4);
      Eigen::VectorXd error(2 + 3 * 4);
      error.head<2>() = fit.curve.values() - true_curve().values();
      for (int i = 0; i < 4; ++i)
        error.segment<3>(2 + 3 * i) = fit.centres_mm[static_cast<std::size_t>(i)] -
                                      presses.centres[static_cast<std::size_t>(i)];
      mapping.add(error.head<2>(), found.topLeftCorner<2, 2>());
      ball.add(error.segment<3>(2), found.block<3, 3>(2, 2));
      all.add(error, found);
    }
    expect_true(mapping, fmt::format("the mapping, blocks of {} px", block).c_str());
    expect_true(ball, fmt::format("a ball beside it, blocks of {} px", block).c_str());
    expect_true(all, fmt::format("mapping and balls, blocks of {} px", block).c_str());
  }
}

TEST(Uncertainty, OfATouchsDirectionIsTrue) {
  const test::Trapping trapping;
  Nees nees;
  for (int run = 0; run < kRuns; ++run) {
    std::mt19937 random(6000 + run);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const double angle = 2 * M_PI * uniform(random), sd_px = 0.02 + 0.2 * uniform(random);
    std::normal_distribution<double> noise(0.0, sd_px);
    ContactSettings settings;
    settings.threshold_px = 1.0;
    Markers markers;
    for (int m = 0; m < 12; ++m) {
      const Eigen::Vector2d rest(100.0 + 40 * (m % 6), m < 6 ? 50.0 : 300.0);
      markers.push_back({rest.x() + 0.6 * std::cos(angle) + noise(random),
                         rest.y() + 0.6 * std::sin(angle) + noise(random), true, sd_px});
      settings.rest_markers.emplace_back(rest.x() + noise(random), rest.y() + noise(random));
    }
    const Push told = push_of(markers, settings, true);
    ASSERT_TRUE(told.direction && told.sd_deg);
    const double error =
        std::remainder(std::atan2(told.direction->y(), told.direction->x()) - angle, 2 * M_PI);
    nees.add(Eigen::VectorXd::Constant(1, error * 180 / M_PI),
             Eigen::MatrixXd::Constant(1, 1, *told.sd_deg * *told.sd_deg));
  }
  expect_true(nees, "a touch's direction");
}

}  // namespace
}  // namespace alltact
