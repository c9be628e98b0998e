// Training on fingers whose forces are known by formula.
#include "calibration/force/train_force.h"

#include "tests/calibration/force/force_worlds.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/core/utility.hpp>

namespace alltact {
namespace {

/// Without a network that is worth anything.
ForceTraining quick_training() {
  ForceTraining options;
  options.comparison_only = true;
  auto& network = options.network;
  made::make_network_quick(network.hidden_1, network.hidden_2, network.steps, network.members);
  return options;
}

TrainedForce trained_on(const ForceTable& table, const std::vector<Eigen::Vector2d>& rest,
                        const ForceTraining& options) {
  auto trained = train_force(table, rest, options, Job());
  EXPECT_TRUE(trained) << trained.error().sentence();
  return *trained;
}

/// What a model is off by on rows of blocks that it was not trained with.
struct NewRows {
  double mean_absolute_N = 0, covered_90 = 0, covered_95 = 0, in_range = 0;
  Eigen::Vector2d by_axis_N = {0, 0};
};

NewRows on_new_rows(const TrainedForce& trained, const ForceTable& table,
                    const std::vector<Eigen::Vector2d>& rest) {
  NewRows result;
  const auto inputs = force_inputs(table, rest);
  const double count = static_cast<double>(inputs.size()), both = 2 * count;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto force = trained.model(inputs[i]);
    EXPECT_TRUE(force);
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const double off =
          std::abs(force->force_N[axis] - table.force_N(static_cast<Eigen::Index>(i), axis));
      result.mean_absolute_N += off / both;
      result.by_axis_N[axis] += off / count;
      result.covered_90 += off <= force->half_90_N[axis] ? 1 / both : 0;
      result.covered_95 += off <= force->half_95_N[axis] ? 1 / both : 0;
    }
    result.in_range += force->in_range ? 1 / count : 0;
  }
  return result;
}

TEST(TrainForce, LinearTruthIsRecovered) {
  made::LatentFinger finger(1);
  const ForceTable table = finger.rows(10, 60);
  const TrainedForce trained = trained_on(table, finger.rest(), quick_training());
  EXPECT_EQ(trained.model.kind, ForceKind::kRidge);
  for (const double rmse : trained.of(ForceKind::kRidge).rmse_N) EXPECT_NEAR(rmse, 0.05, 0.01);
  // Against the truth itself: rows whose forces have no noise.
  finger.noise_N = 0;
  EXPECT_LT(on_new_rows(trained, finger.rows(10, 60), finger.rest()).mean_absolute_N, 0.02);
}

TEST(TrainForce, QuadraticBeatsRidgeOnQuadraticTruth) {
  made::LatentFinger finger(2);
  finger.bent = 1;
  const TrainedForce trained = trained_on(finger.rows(10, 60), finger.rest(), quick_training());
  EXPECT_EQ(trained.model.kind, ForceKind::kQuadratic);
  EXPECT_LT(trained.of(ForceKind::kQuadratic).mae_N.maxCoeff(), 0.06);
  EXPECT_GT(trained.of(ForceKind::kRidge).mae_N.minCoeff(), 0.2);
}

TEST(TrainForce, NetworkDoesNotBeatRidgeOnLinearTruthAndSaysSo) {
  made::LatentFinger finger(3);
  const TrainedForce trained = trained_on(finger.rows(8, 40), finger.rest(), {});
  EXPECT_EQ(trained.model.kind, ForceKind::kRidge);
  ASSERT_FALSE(trained.remarks.empty());
  EXPECT_NE(trained.remarks.front().english().find("The network does not beat ridge"),
            std::string::npos);
  // Yet it learns: it is no stub.
  EXPECT_GT(trained.of(ForceKind::kNetwork).r2.minCoeff(), 0.9);
  for (const ForceComparison& row : trained.comparison) EXPECT_LE(row.shuffled_r2.value(), 0);
}

TEST(TrainForce, NetworkLearnsWhatNeitherRidgeNorQuadraticCan) {
  made::LatentFinger finger(4);
  ForceTable table = finger.rows(10, 120);
  // A kink and a saturation of the first two markers' motion.
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    const double a = (table.layouts(row, 0) - finger.rest()[0].x()) / 4;
    const double b = (table.layouts(row, 2) - finger.rest()[1].x()) / 4;
    table.force_N.row(row) << std::max(0.0, a) - 2 * std::max(0.0, b), std::tanh(3 * a);
  }
  ForceTraining options;
  options.comparison_only = true;
  const TrainedForce trained = trained_on(table, finger.rest(), options);
  EXPECT_EQ(trained.model.kind, ForceKind::kNetwork);
  EXPECT_LT(trained.of(ForceKind::kNetwork).relative,
            0.6 * trained.of(ForceKind::kQuadratic).relative);
}

TEST(TrainForce, HiddenMarkersCostLittle) {
  made::LatentFinger finger(5);
  finger.hidden = 0.2;
  const TrainedForce trained = trained_on(finger.rows(10, 60), finger.rest(), quick_training());
  finger.noise_N = 0;
  const NewRows found = on_new_rows(trained, finger.rows(10, 60), finger.rest());
  EXPECT_LT(found.mean_absolute_N, 0.035);
  EXPECT_GT(found.in_range, 0.95);
}

TEST(TrainForce, BeamsAreToldWithin100mN) {
  double worst = 0;
  Eigen::Vector2d sum(0, 0);
  constexpr int kFingers = 20;
  for (int seed = 0; seed < kFingers; ++seed) {
    made::BeamFinger finger(static_cast<std::uint64_t>(100 + seed));
    const ForceTable table = finger.rows(40, 30);
    const TrainedForce trained = trained_on(table, finger.rest(), quick_training());
    finger.noise_N = 0;
    const NewRows found = on_new_rows(trained, finger.rows(10, 40), finger.rest());
    worst = std::max(worst, found.by_axis_N.maxCoeff());
    sum += found.by_axis_N / kFingers;
  }
  RecordProperty("mean_fx_N", fmt::format("{:.4f}", sum[0]));
  RecordProperty("mean_fy_N", fmt::format("{:.4f}", sum[1]));
  RecordProperty("worst_N", fmt::format("{:.4f}", worst));
  std::cout << fmt::format("beams: {:.4f} {:.4f} N, worst {:.4f} N\n", sum[0], sum[1], worst);
  EXPECT_LT(sum.maxCoeff(), 0.07);
  EXPECT_LT(worst, 0.1);
}

TEST(TrainForce, IntervalsHoldOn200Worlds) {
  double covered_90 = 0, covered_95 = 0, own_95 = 0;
  constexpr int kWorlds = 200;
  for (int seed = 0; seed < kWorlds; ++seed) {
    made::LatentFinger finger(static_cast<std::uint64_t>(1000 + seed));
    finger.bent = seed % 2;
    finger.hidden = seed % 3 == 0 ? 0.1 : 0;
    finger.noise_N = seed % 5 == 0 ? 0.3 : 0.05;
    const TrainedForce trained = trained_on(finger.rows(10, 30), finger.rest(), quick_training());
    const NewRows found = on_new_rows(trained, finger.rows(10, 30), finger.rest());
    covered_90 += found.covered_90 / kWorlds, covered_95 += found.covered_95 / kWorlds;
    own_95 += trained.covered_95.mean() / kWorlds;
  }
  std::cout << fmt::format("covered 90: {:.4f}, 95: {:.4f}, own 95: {:.4f}\n", covered_90,
                           covered_95, own_95);
  EXPECT_GT(covered_90, 0.88);
  EXPECT_LT(covered_90, 0.93);
  EXPECT_GT(covered_95, 0.93);
  EXPECT_LT(covered_95, 0.97);
  EXPECT_NEAR(own_95, covered_95, 0.015) << "what training says of itself is what comes";
}

TEST(TrainForce, FramesBeyondTheTableAreFlagged) {
  made::LatentFinger finger(6);
  const ForceTable table = finger.rows(10, 60);
  const TrainedForce trained = trained_on(table, finger.rest(), quick_training());
  ForceInput input = force_inputs(table, finger.rest())[0];
  ASSERT_TRUE(trained.model(input)->in_range);
  ForceInput far = input;
  far.displacement_px *= 20;
  EXPECT_FALSE(trained.model(far)->in_range) << "far within the motions that it knows";
  ForceInput torn = input;
  torn.displacement_px[7] += 30;
  EXPECT_FALSE(trained.model(torn)->in_range) << "a motion that no row shows";
  ForceInput blind = input;
  blind.seen.tail(9).setZero();
  EXPECT_FALSE(trained.model(blind)->in_range) << "fewer markers than any row shows";
}

TEST(TrainForce, ABlockIsNeverOnBothSides) {
  made::LatentFinger finger(7);
  ForceTable table = finger.rows(13, 20);
  const auto folds = force_folds(table, ForceSplit::kBlock, 1);
  ASSERT_TRUE(folds);
  EXPECT_EQ(folds->count, kMaxFolds);
  for (std::size_t i = 0; i < table.block.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const bool is_same_block = table.block[i] == table.block[k];
      EXPECT_TRUE(!is_same_block || folds->of[i] == folds->of[k]);
    }
  const auto by_day = force_folds(table, ForceSplit::kDay, 1);
  ASSERT_FALSE(by_day);
  EXPECT_NE(by_day.error().sentence().find("no column 'day'"), std::string::npos);
  table.day.assign(table.block.size(), "Monday");
  EXPECT_NE(force_folds(table, ForceSplit::kDay, 1).error().sentence().find("the same in all rows"),
            std::string::npos);
}

TEST(TrainForce, SameBytesForAnyNumberOfThreads) {
  made::LatentFinger finger(8);
  const ForceTable table = finger.rows(6, 30);
  ForceTraining options;
  options.comparison_only = true;
  options.kind = ForceKind::kNetwork;
  options.network.steps = 100;
  const int threads = cv::getNumThreads();
  cv::setNumThreads(2);
  const std::string two = trained_on(table, finger.rest(), options).model.to_json();
  cv::setNumThreads(1);
  const std::string one = trained_on(table, finger.rest(), options).model.to_json();
  cv::setNumThreads(threads);
  EXPECT_EQ(one, two);
}

// Rubber that goes on yielding under a load: displacement is 1 at once and a third more with 2 s.
TEST(TrainForce, CreepAsAnInputTellsALoadFromItsAge) {
  constexpr int kBlocks = 10, kRows = 80;
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal(0, 1);
  ForceTable table = made::empty_force_table(kBlocks * kRows, 4, 2);
  table.time_s = Eigen::VectorXd::Zero(table.rows());
  Eigen::Index row = 0;
  for (int block = 0; block < kBlocks; ++block) {
    Eigen::Vector2d force(0, 0), yielded(0, 0);
    for (int i = 0; i < kRows; ++i, ++row) {
      constexpr double kStepS = 0.1, kYieldS = 2.0;
      if (i % 15 == 0) force = {2 * normal(random), 2 * normal(random)};
      yielded += (1 - std::exp(-kStepS / kYieldS)) * (force / 3 - yielded);
      const Eigen::Vector2d moved = 5 * (force + yielded);
      for (int m = 0; m < 4; ++m)
        for (int k = 0; k < 2; ++k)
          table.layouts(row, 2 * m + k) = 100 * m + moved[k] * (1 + m) + 0.05 * normal(random);
      table.force_N.row(row) = force.transpose();
      table.block.push_back(std::to_string(block));
      table.time_s[row] = 100.0 * block + kStepS * i;
    }
  }
  ForceTraining options = quick_training();
  options.kind = ForceKind::kRidge;
  const double without = trained_on(table, {}, options).of(ForceKind::kRidge).mae_N.mean();
  options.creep_s = 2;
  const double with = trained_on(table, {}, options).of(ForceKind::kRidge).mae_N.mean();
  EXPECT_LT(with, 0.7 * without);
  table.time_s.resize(0);
  const auto untimed = train_force(table, {}, options, Job());
  ASSERT_FALSE(untimed);
  EXPECT_NE(untimed.error().sentence().find("has times"), std::string::npos);
}

TEST(TrainForce, LabelNoiseIsFoundWhereRowsFollowEachOther) {
  constexpr int kRows = 600;
  std::mt19937_64 random(10);
  std::normal_distribution<double> normal(0, 1);
  ForceTable table = made::empty_force_table(kRows, 4, 2);
  for (Eigen::Index row = 0; row < kRows; ++row) {
    const double phase = 0.05 * static_cast<double>(row);
    table.force_N.row(row) << 3 * std::sin(phase) + 0.08 * normal(random),
        2 * std::cos(phase) + 0.2 * normal(random);
  }
  const auto folds = force_folds(table, ForceSplit::kBlock, 1);
  const Eigen::VectorXd noise = force_label_noise_N(table, *folds);
  EXPECT_NEAR(noise[0], 0.08, 0.012);
  EXPECT_NEAR(noise[1], 0.2, 0.03);
}

TEST(TrainForce, StopsWhenAsked) {
  made::LatentFinger finger(11);
  Job job;
  job.request_stop();
  const auto trained = train_force(finger.rows(5, 20), finger.rest(), {}, job);
  ASSERT_FALSE(trained);
  EXPECT_NE(trained.error().sentence().find("stopped"), std::string::npos);
}

}  // namespace
}  // namespace alltact
