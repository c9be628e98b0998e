// How sure the direction of a push is when some markers are estimates.
#include "core/sensing/contact/push.h"
#include "core/sensing/markers/marker_model.h"
#include "tests/support/marked_finger.h"

#include <numbers>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::MarkedFinger;

struct NoisyFinger {
  MarkedFinger finger;
  MarkerModel model;
};

NoisyFinger recorded_finger(double noise_px, std::mt19937& random) {
  MarkedFinger finger;
  finger.per_row = 12;
  std::normal_distribution<double> noise(0.0, noise_px);
  constexpr int kFrames = 600;
  Eigen::MatrixXd layouts(kFrames, 4 * finger.per_row);
  for (int i = 0; i < kFrames; ++i) {
    layouts.row(i) = finger.layout(test::random_bend(random)).transpose();
    for (Eigen::Index k = 0; k < layouts.cols(); ++k) layouts(i, k) += noise(random);
  }
  return {finger, MarkerModel::learn(layouts, finger.typical({})).value()};
}

// The squared error of a push's direction in its own variances, mean of many: 1 where these are
// true.
double nees_with_hidden(int hidden, double noise_px) {
  constexpr int kFingers = 4, kPushes = 400;
  double sum = 0;
  int count = 0;
  for (int f = 0; f < kFingers; ++f) {
    std::mt19937 random(static_cast<unsigned>(900 + 10 * f + hidden));
    std::normal_distribution<double> noise(0.0, noise_px);
    const NoisyFinger known = recorded_finger(noise_px, random);
    const Eigen::VectorXd rest = known.finger.layout({});
    for (int i = 0; i < kPushes; ++i) {
      const Eigen::VectorXd truth = known.finger.layout(test::random_bend(random, 0.8));
      const auto n = static_cast<std::size_t>(known.model.marker_count());
      ContactSettings settings;
      settings.threshold_px = 60;
      Markers markers(n);
      std::vector<std::size_t> order(n);
      for (std::size_t m = 0; m < n; ++m) {
        const auto k = static_cast<Eigen::Index>(2 * m);
        order[m] = m;
        settings.rest_markers.emplace_back(rest[k] + noise(random), rest[k + 1] + noise(random));
        markers[m] = {truth[k] + noise(random), truth[k + 1] + noise(random), true, noise_px};
      }
      std::shuffle(order.begin(), order.end(), random);
      for (int h = 0; h < hidden; ++h) markers[order[static_cast<std::size_t>(h)]].seen = false;
      const auto completed = known.model.complete(markers);
      if (!completed) continue;
      Eigen::Vector2d offset = Eigen::Vector2d::Zero();
      for (Eigen::Index k = 0; k < truth.size(); k += 2) offset += (truth - rest).segment<2>(k);
      const Push told =
          push_of(*completed, settings, true,
                  displacement_covariance_px2(*completed, known.model.covariance_px2(*completed)));
      if (!told.direction) continue;
      const double error = std::remainder(
          std::atan2(told.direction->y(), told.direction->x()) - std::atan2(offset.y(), offset.x()),
          2 * std::numbers::pi);
      sum += std::pow(error * 180 / std::numbers::pi / *told.sd_deg, 2);
      ++count;
    }
  }
  EXPECT_GT(count, 1000);
  return sum / count;
}

TEST(PushHidden, StatedUncertaintyIsTrueWithMarkersHidden) {
  for (const double noise_px : {0.05, 0.15})
    for (const int hidden : {0, 4, 8}) {
      const double nees = nees_with_hidden(hidden, noise_px);
      printf("%d of 24 hidden, noise %.2f px: NEES %.3f\n", hidden, noise_px, nees);
      EXPECT_GT(nees, 0.85) << hidden;
      EXPECT_LT(nees, 1.15) << hidden;
    }
}

}  // namespace
}  // namespace alltact
