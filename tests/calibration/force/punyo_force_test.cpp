// Features tracked in a real soft bubble, and the wrench that a sensor told beside.
#include "calibration/force/train_force.h"

#include <filesystem>

#include <gtest/gtest.h>

namespace alltact {
namespace {

const std::filesystem::path kPunyoTable = std::filesystem::path(ALLTACT_SOURCE_DIR) / ".." /
                                          "shared" / "data" / "punyo_force" /
                                          "tracks_and_wrench.csv";
/// Of plain ridge regression on the coordinates, by five stretches of time.
const Eigen::Vector3d kPlainRidgeN(0.157, 0.169, 0.178);

const TrainedForce& trained_on_punyo() {
  static const TrainedForce trained = [] {
    const auto table = ForceTable::load(kPunyoTable);
    EXPECT_TRUE(table) << table.error().sentence();
    ForceTraining options;
    auto result = train_force(*table, {}, options, Job());
    EXPECT_TRUE(result) << result.error().sentence();
    return *result;
  }();
  return trained;
}

class PunyoForce : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kPunyoTable)) GTEST_SKIP() << "no " << kPunyoTable;
  }
};

TEST_F(PunyoForce, ErrorOnStretchesNotSeenIsNotAbovePlainRidge) {
  const TrainedForce& trained = trained_on_punyo();
  for (const ForceComparison& row : trained.comparison)
    std::cout << to_string(row.kind) << ": " << row.mae_N.transpose() << " N, by frames "
              << row.random_mae_N.transpose() << " N, r2 " << row.r2.transpose() << " shuffled "
              << row.shuffled_r2.value_or(0) << "\n";
  std::cout << "kept " << to_string(trained.model.kind)
            << ", covered 90: " << trained.covered_90.transpose()
            << " 95: " << trained.covered_95.transpose() << " label noise "
            << trained.label_noise_N.transpose() << "\n";
  for (const Message& remark : trained.remarks) std::cout << remark.english() << "\n";
  const Eigen::VectorXd mae = trained.of(trained.model.kind).mae_N;
  ASSERT_EQ(mae.size(), 3);
  for (Eigen::Index axis = 0; axis < 3; ++axis) EXPECT_LE(mae[axis], kPlainRidgeN[axis]) << axis;
}

TEST_F(PunyoForce, SingleFramesHeldOutLookBetterThanStretches) {
  const TrainedForce& trained = trained_on_punyo();
  for (const ForceKind kind : {ForceKind::kRidge, ForceKind::kQuadratic, ForceKind::kNetwork})
    EXPECT_LT(trained.of(kind).random_mae_N.mean(), trained.of(kind).mae_N.mean())
        << to_string(kind);
}

TEST_F(PunyoForce, IntervalsCoverStretchesNotSeen) {
  const TrainedForce& trained = trained_on_punyo();
  EXPECT_GE(trained.covered_90.mean(), 0.85);
  EXPECT_LE(trained.covered_90.mean(), 0.95);
  for (const double covered : trained.covered_90) EXPECT_NEAR(covered, 0.9, 0.07);
}

TEST_F(PunyoForce, ShuffledForcesCannotBeTold) {
  for (const ForceComparison& row : trained_on_punyo().comparison) {
    ASSERT_TRUE(row.shuffled_r2) << to_string(row.kind);
    EXPECT_LE(*row.shuffled_r2, 0.0) << to_string(row.kind);
  }
}

// The wrench sensor's own noise: its unloaded first and last seconds scatter by about 0.1 N.
TEST_F(PunyoForce, LabelNoiseIsThatOfTheSensorAtRest) {
  const TrainedForce& trained = trained_on_punyo();
  for (const double noise : trained.label_noise_N) {
    EXPECT_GT(noise, 0.03);
    EXPECT_LT(noise, 0.2);
  }
}

}  // namespace
}  // namespace alltact
