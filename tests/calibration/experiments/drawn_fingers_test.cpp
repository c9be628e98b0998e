// What is asked for of one finger holds for fingers that others might have cast.
#include "calibration/experiments/experiments.h"
#include "calibration/experiments/force_experiments.h"
#include "core/base/atomic_file.h"
#include "tests/support/slow_run.h"
#include "tests/support/temporary_folder.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr std::uint64_t kDrawSeed = 31;
constexpr std::array kRoomLevels{1.2, 4.4, 10.0};  // 300, 1100, 2500 lux of experiment_room_light

class DrawnFingers : public testing::Test {
 protected:
  static void TearDownTestSuite() {
    last_.reset();
    folder_.reset();
  }
  /// The one that was made last is there for the next test.
  ///   scale: of its pictures
  ExperimentBench bench(int number, double scale = 1) {
    BenchOptions options;
    if (!folder_) folder_.emplace();
    options.folder = folder_->path();
    options.seed = kDrawSeed;
    options.recording_every = test::as_many_as(3, 1);
    options.finger = FingerVariant::draw(kDrawSeed, number);
    options.finger.scale = scale;
    options.name = fmt::format("finger_{}_{}", number, scale);
    if (last_ && last_->options().name == options.name) return *last_;
    last_.reset();
    auto made = ExperimentBench::make(options, job_);
    EXPECT_TRUE(made) << made.error().sentence();
    last_ = std::move(made).value();
    return *last_;
  }
  static ExperimentBench::Measuring in_room(double level) {
    ExperimentBench::Measuring measuring;
    measuring.room_level = level;
    return measuring;
  }
  /// By how much the largest of the means is above the least.
  static double change(const std::array<ErrorSamples, kRoomLevels.size()>& rooms) {
    double least = rooms[0].mean(), most = least;
    for (const ErrorSamples& room : rooms) {
      least = std::min(least, room.mean());
      most = std::max(most, room.mean());
    }
    return (most - least) / least;
  }
  /// The scene's text on a drawn finger.
  static Plan references_with(const FingerVariant& finger, const char* from, const char* to) {
    const std::filesystem::path file =
        ALLTACT_SOURCE_DIR "/resources/scenes/experiment_references.yaml";
    std::string text = read_file(file).value();
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos);
    text.replace(at, std::string(from).size(), to);
    return Plan::compile(scene_on_finger(text, file, finger).value(), kDrawSeed).value();
  }

  static inline const Job job_;
  static inline std::optional<test::TemporaryFolder> folder_;
  static inline std::optional<ExperimentBench> last_;
};

TEST_F(DrawnFingers, PlacesAreTheSameInEveryRoomAndAsNearAsAskedFor) {
  const int fingers = test::as_many_as(1, 8);
  for (int number = 1; number <= fingers; ++number) {
    const ExperimentBench one = bench(number);
    std::array<ErrorSamples, kRoomLevels.size()> rooms;
    for (std::size_t room = 0; room < kRoomLevels.size(); ++room) {
      ErrorSamples inner, tip;
      const auto frames =
          one.measure("experiment_room_light", in_room(kRoomLevels[room]),
                      [&](std::size_t, const Truth& truth, const FrameResult& result) {
                        ASSERT_FALSE(result.regions.empty());
                        const ContactTruth& contact = truth.contacts.front();
                        const double error = position_error_mm(result.regions.front(), contact);
                        rooms[room].add(error);
                        if (std::abs(contact.along_mm - 60) <= 20) inner.add(error);
                        if (contact.along_mm >= 100) tip.add(error);
                      });
      ASSERT_TRUE(frames) << frames.error().sentence();
      EXPECT_LT(inner.mean(), 0.2) << number;
      EXPECT_LT(tip.mean(), 0.5) << number;
    }
    EXPECT_EQ(rooms[0].count, 27);
    EXPECT_LT(change(rooms), 0.1) << number;
    printf("[ figures  ] finger %d: places off by %.3f mm, %.1f %% apart between rooms\n", number,
           rooms[0].mean(), 100 * change(rooms));
  }
}

// At half the size each way a ball at the tip is ten pixels across.
TEST_F(DrawnFingers, SmallPicturesSayThatTheyDoNotTellAlongWhichThicknessLightGoes) {
  if (!test::is_slow_run()) GTEST_SKIP() << "packaging/test --slow";
  BenchOptions options;
  const test::TemporaryFolder folder;
  options.folder = folder.path();
  options.finger = FingerVariant::draw(1, 1);
  options.finger.scale = 0.5;
  const auto made = ExperimentBench::make(options, job_);
  ASSERT_TRUE(made) << made.error().sentence();
  const auto report = read_file(made->finger().folder / "calibration_report.json");
  ASSERT_TRUE(report);
  EXPECT_THAT(*report, testing::HasSubstr("the presses do not show whether brightness follows"));
}

TEST_F(DrawnFingers, ForcesAreTheSameInEveryRoom) {
  if (!test::is_slow_run()) GTEST_SKIP() << "packaging/test --slow";
  ExperimentBench one = bench(3);
  const auto table = table_of_pushes(one, kForceScene, kForcePositions);
  ASSERT_TRUE(table) << table.error().sentence();
  ASSERT_TRUE(one.learn_force(*table, training_of_experiments()));
  std::array<ErrorSamples, kRoomLevels.size()> rooms;
  for (std::size_t room = 0; room < kRoomLevels.size(); ++room)
    ASSERT_TRUE(one.measure("experiment_room_force", in_room(kRoomLevels[room]),
                            [&](std::size_t, const Truth& truth, const FrameResult& result) {
                              if (!result.force) return;
                              for (Eigen::Index axis = 0; axis < 2; ++axis)
                                rooms[room].add(
                                    std::abs(result.force->force_N[axis] -
                                             truth.contacts.front().force_N.value()[axis]));
                            }));
  EXPECT_GT(rooms[0].count, 80);
  EXPECT_LT(rooms[0].mean(), 0.1);
  EXPECT_LT(change(rooms), 0.1);
  printf("[ figures  ] forces off by %.3f N, %.1f %% apart between rooms\n", rooms[0].mean(),
         100 * change(rooms));
}

TEST_F(DrawnFingers, APoseHasANearReferenceOrIsToldNotToBeRecorded) {
  int frames = 0, near_a_dot = 0, near_together = 0, told_beyond = 0, beyond = 0;
  for (const int number : {test::as_many_as(1, 4)}) {
    const ExperimentBench one = bench(number);
    auto pipeline = Pipeline::create(one.finger(), {}, job_).value();
    const auto measured = [&](const Plan& plan, int frame) {
      pipeline.forget();
      return pipeline(one.frames(plan, frame, frame + 1).front()).value();
    };
    const Plan within = one.plan("experiment_references").value();
    for (int i = 0; i < within.frame_count(); ++i) {
      const FrameResult result = measured(within, i);
      ASSERT_TRUE(result.reference && result.markers);
      const auto dots = std::count_if(result.markers->begin(), result.markers->end(),
                                      [](const auto& m) { return m.seen; });
      const bool is_told = !result.reference->known_pose || result.reference->is_sparse();
      EXPECT_EQ(is_told,
                std::any_of(result.problems.begin(), result.problems.end(), [](const auto& p) {
                  return p.english().find("recorded") != std::string::npos;
                }));
      ++frames;
      near_a_dot += result.reference->distance_px < 10;
      near_together +=
          static_cast<double>(dots) * one.library().combined_distance_px(*result.markers) < 10 ||
          is_told;
    }
    // The recording bends the finger by 6 mm and sways it by 3 mm.
    const FingerVariant& finger = one.options().finger;
    for (const Plan& plan :
         {references_with(finger, "q1_mm: {from: -5.0, to: 5.0}", "q1_mm: {from: 9.0, to: 12.0}"),
          references_with(finger, "sway_mm: {from: -2.5, to: 2.5}",
                          "sway_mm: {from: -7.0, to: -5.0}")})
      for (int i = 0; i < plan.frame_count(); i += 4) {
        const FrameResult result = measured(plan, i);
        ++beyond;
        told_beyond +=
            std::any_of(result.problems.begin(), result.problems.end(), [](const Message& p) {
              return p.english().starts_with("this pose was never recorded");
            });
      }
  }
  printf("[ figures  ] of %d poses %d near a dot, %d summed or told; %d of %d beyond are told\n",
         frames, near_a_dot, near_together, told_beyond, beyond);
  EXPECT_EQ(near_a_dot, frames);
  EXPECT_GE(near_together, 0.995 * frames);
  EXPECT_EQ(told_beyond, beyond);
}

// Small pictures tell the least force as well, in a quarter of the time.
TEST_F(DrawnFingers, TheLeastForceIsFeltOnEveryFace) {
  const auto outcome = run_min_force(bench(6, test::is_slow_run() ? 1 : 0.5));
  ASSERT_TRUE(outcome) << outcome.error().sentence();
  EXPECT_EQ(outcome->figures.size(), 4U);  // faces
  for (const ExperimentFigure& figure : outcome->figures) {
    EXPECT_LT(figure.simulated, figure.paper.value()) << figure.what.english();
    EXPECT_GT(figure.simulated, 0);
    printf("[ figures  ] %s: %.2f N\n", figure.what.english().c_str(), figure.simulated);
  }
}

}  // namespace
}  // namespace alltact
