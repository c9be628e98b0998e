// A finger that is calibrated anew while it is measured.
#include "calibration/live/watched_finger.h"

#include "core/base/atomic_file.h"
#include "core/image/image_file.h"
#include "tests/support/flat_sensor.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace std::chrono_literals;
using test::FlatSensor;
using testing::HasSubstr;

template <class Condition>
bool wait_until(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + 20s;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

class FollowedFingerTest : public testing::Test {
 protected:
  void SetUp() override {
    Finger finger = test::flat_sensor_finger(true);
    finger.reference.emplace();
    finger.reference->image = "ref.png";
    ASSERT_TRUE(write_image(folder_ / "ref.png", test::untouched_picture(1)).ok());
    ASSERT_TRUE(finger.save(folder_.path()).ok());
    auto opened = WatchedFinger::open(folder_.path(), make_, Job(), 5ms);
    ASSERT_TRUE(opened.ok()) << opened.error().sentence();
    followed_ = std::move(*opened);
  }
  /// As another program does it: behind this one's back.
  void write_finger(double a_mm) const {
    Finger finger = *Finger::load(folder_.path());
    finger.mapping->a_mm = a_mm;
    ASSERT_TRUE(finger.save(folder_.path()).ok());
  }
  [[nodiscard]] double deepest_mm() const {
    auto frame = std::make_shared<Frame>();
    frame->grey = test::pressed_picture(test::ball_depth_mm(160, 120, 0.8), 2);
    const auto result = followed_->pipeline()(frame);
    EXPECT_TRUE(result.ok() && !result->regions.empty());
    return result->regions.front().deepest_mm;
  }

  test::TemporaryFolder folder_;
  WatchedFinger::MakePipeline make_ = [](const FingerSnapshot& finger, const Job& job) {
    return Pipeline::create(finger, PipelineSettings(), job);
  };
  std::unique_ptr<WatchedFinger> followed_;
};

TEST_F(FollowedFingerTest, MeasuresAsItIsAfterAChangeAndNotBeforeItIsTaken) {
  const double before = deepest_mm();
  EXPECT_NEAR(before, 0.8, 0.05);
  const std::uint64_t revision = followed_->finger().revision;
  write_finger(2 * FlatSensor::kA);
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(deepest_mm(), before);
  ASSERT_TRUE(wait_until([&] { return followed_->take_update(); }));
  EXPECT_GT(followed_->finger().revision, revision);
  EXPECT_NEAR(deepest_mm(), 2 * before, 0.01);
  EXPECT_FALSE(followed_->take_problem());
  std::this_thread::sleep_for(50ms);
  EXPECT_FALSE(followed_->take_update());  // nothing has changed since
}

TEST_F(FollowedFingerTest, GoesOnAndSaysOnceWhyWhereItCannotBeRead) {
  const double before = deepest_mm();
  ASSERT_TRUE(write_file_atomically(folder_ / "finger.yaml", "name: half").ok());
  std::optional<Error> problem;
  ASSERT_TRUE(wait_until([&] { return (problem = followed_->take_problem()).has_value(); }));
  EXPECT_THAT(problem->sentence(), HasSubstr("finger.yaml"));
  std::this_thread::sleep_for(50ms);
  EXPECT_FALSE(followed_->take_problem());
  EXPECT_FALSE(followed_->take_update());
  EXPECT_EQ(deepest_mm(), before);
}

TEST_F(FollowedFingerTest, GoesOnWhereItCannotBeMeasuredBy) {
  ASSERT_TRUE(std::filesystem::remove(folder_ / "ref.png"));
  write_finger(1.0);
  std::optional<Error> problem;
  ASSERT_TRUE(wait_until([&] { return (problem = followed_->take_problem()).has_value(); }));
  EXPECT_THAT(problem->sentence(), HasSubstr("ref.png"));
  EXPECT_NEAR(deepest_mm(), 0.8, 0.05);
  ASSERT_TRUE(write_image(folder_ / "ref.png", test::untouched_picture(1)).ok());
  write_finger(2 * FlatSensor::kA);
  ASSERT_TRUE(wait_until([&] { return followed_->take_update(); }));
  EXPECT_NEAR(deepest_mm(), 1.6, 0.1);
}

TEST_F(FollowedFingerTest, GoesOnWhereLoadingThrows) {
  std::atomic<bool> is_throwing{false};
  auto watched = WatchedFinger::open(
      folder_.path(),
      [&](const FingerSnapshot& finger, const Job& job) -> Result<Pipeline> {
        if (is_throwing) throw std::bad_alloc();
        return make_(finger, job);
      },
      Job(), 5ms);
  ASSERT_TRUE(watched.ok());
  is_throwing = true;
  write_finger(1.0);
  std::optional<Error> problem;
  ASSERT_TRUE(wait_until([&] { return (problem = (*watched)->take_problem()).has_value(); }));
  EXPECT_THAT(problem->sentence(), HasSubstr("not enough memory"));
  is_throwing = false;
  write_finger(2.0);
  ASSERT_TRUE(wait_until([&] { return (*watched)->take_update(); }));
}

TEST_F(FollowedFingerTest, EndsWhileItLoads) {
  std::atomic<bool> is_loading{false};
  auto slow = WatchedFinger::open(
      folder_.path(),
      [&](const FingerSnapshot& finger, const Job& job) -> Result<Pipeline> {
        if (finger.finger.mapping->a_mm != FlatSensor::kA) is_loading = true;
        while (is_loading && !job.stop_requested()) std::this_thread::sleep_for(1ms);
        return make_(finger, job);
      },
      Job(), 5ms);
  ASSERT_TRUE(slow.ok());
  write_finger(1.0);
  ASSERT_TRUE(wait_until([&] { return is_loading.load(); }));
  slow->reset();  // or this test never ends
}

}  // namespace
}  // namespace alltact
