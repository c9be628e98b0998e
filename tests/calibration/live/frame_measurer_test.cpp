// Frames of a recording measured in any order: a flat sensor's, pressed by a ball of known place.
#include "calibration/live/frame_measurer.h"

#include "core/image/image_file.h"
#include "tests/support/flat_sensor.h"
#include "tests/support/made_meshes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using test::FlatSensor;

constexpr double kBall_u = 150, kBall_v = 110;
constexpr int kFrames = 3;

double depth_of(int number) { return 0.3 + 0.2 * number; }

class FrameMeasurerTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(recording_);
    ASSERT_TRUE(write_image(folder_ / "ref.png", test::untouched_picture(1)).ok());
    for (int i = 0; i < kFrames; ++i) {
      const auto depth_mm = test::ball_depth_mm(kBall_u, kBall_v, depth_of(i));
      const fs::path file = recording_ / ("frame_" + std::to_string(i) + ".png");
      ASSERT_TRUE(write_image(file, test::pressed_picture(depth_mm, 2 + i)).ok());
    }
    save_finger(true);
  }

  void save_finger(bool is_calibrated) {
    finger_ = test::flat_sensor_finger(is_calibrated);
    finger_.reference = ReferenceFiles{};
    finger_.reference->image = "ref.png";
    if (is_calibrated) finger_.mapping_record = MappingRecord{method_, {}, 0, 0, 0, 0, ""};
    const Status saved = finger_.save(folder_.path());
    ASSERT_TRUE(saved.ok()) << saved.error().sentence();
  }
  void open() {
    ASSERT_TRUE(measurer_.open_recording(recording_, job_).ok());
    const Status opened = measurer_.load_finger(folder_.path(), job_);
    ASSERT_TRUE(opened.ok()) << opened.error().sentence();
  }

  std::string method_ = "paper";
  test::TemporaryFolder folder_;
  fs::path recording_ = folder_ / "recording";
  Finger finger_;
  FrameMeasurer measurer_;
  Job job_;
};

TEST_F(FrameMeasurerTest, MeasuresFramesInAnyOrderWithTheirSd) {
  open();
  const RecordingInfo recording = measurer_.recording();
  EXPECT_EQ(recording.input, recording_);
  EXPECT_EQ(recording.count, std::size_t{kFrames});
  EXPECT_FALSE(recording.times_ns) << "pictures have none";
  for (const int number : {2, 0, 1, 1}) {
    const auto frame = measurer_.measure(static_cast<std::size_t>(number), {}, job_);
    ASSERT_TRUE(frame.ok());
    EXPECT_EQ(frame.value().number, static_cast<std::size_t>(number));
    EXPECT_TRUE(frame.value().is_calibrated);
    EXPECT_FALSE(frame.value().other);
    ASSERT_TRUE(frame.value().result.depth);
    const cv::Point ball(static_cast<int>(kBall_u), static_cast<int>(kBall_v));
    EXPECT_NEAR(frame.value().result.depth->depth_mm.at<float>(ball), depth_of(number), 0.05);
    ASSERT_EQ(frame.value().sd_mm.size(), frame.value().result.grey.size());
    const double sd_mm = frame.value().sd_mm.at<float>(ball);
    EXPECT_TRUE(sd_mm > 0 && sd_mm < 0.05) << sd_mm;
  }
  EXPECT_EQ(measurer_.measure(99, {}, job_).value().number, std::size_t{kFrames - 1});
}

TEST_F(FrameMeasurerTest, ComparesWithTheOtherMethod) {
  open();
  const auto frame = measurer_.measure(1, {OtherMethod::kPaper}, job_);
  ASSERT_TRUE(frame.ok() && frame.value().other);
  const cv::Mat difference = frame->difference_mm;
  EXPECT_EQ(difference.size(), frame.value().result.grey.size());
  EXPECT_GT(cv::countNonZero(cv::abs(difference) > 0), 100) << "the paper does not smooth";
}

TEST_F(FrameMeasurerTest, ThePaperTakesNothingOfOurCalibration) {
  method_ = "joint";
  save_finger(true);
  open();
  EXPECT_TRUE(measurer_.measure(1, {}, job_).ok());
  const auto frame = measurer_.measure(1, {OtherMethod::kPaper}, job_);
  ASSERT_TRUE(frame.ok()) << "ours is shown all the same";
  EXPECT_FALSE(frame->other);
  ASSERT_TRUE(frame->other_problem) << "no press is kept that it could calibrate with";
  EXPECT_NE(frame->other_problem->what.english().find("has no stored presses"), std::string::npos);
}

/// Of what is finite within so many pixels of the ball's middle.
struct Differences {
  double mean_mm = 0, worst_mm = 0;
};
Differences near_the_ball(const cv::Mat& difference_mm, double within_px) {
  Differences found;
  int count = 0;
  for (int v = 0; v < difference_mm.rows; ++v)
    for (int u = 0; u < difference_mm.cols; ++u) {
      const double mm = difference_mm.at<float>(v, u);
      if (std::hypot(u - kBall_u, v - kBall_v) > within_px || !std::isfinite(mm)) continue;
      found.mean_mm += mm, ++count;
      found.worst_mm = std::max(found.worst_mm, std::abs(mm));
    }
  found.mean_mm /= std::max(1, count);
  return found;
}

TEST_F(FrameMeasurerTest, ComparesWithANominalBody) {
  const fs::path right = folder_ / "ball.stl", small = folder_ / "small.stl";
  test::write_stl(right, test::ball(FlatSensor::kBallRadiusMm));
  test::write_stl(small, test::ball(0.6 * FlatSensor::kBallRadiusMm));
  open();
  const ComparisonSpec with_ball{OtherMethod::kBody, {}, {}, 0, right};
  const auto frame = measurer_.measure(1, with_ball, job_);
  ASSERT_TRUE(frame.ok());
  ASSERT_FALSE(frame->other_problem) << frame->other_problem->sentence();
  ASSERT_TRUE(frame->other && frame->body_rms_mm);
  EXPECT_LT(*frame->body_rms_mm, 0.02);
  // The contact of a ball pressed in 0.5 mm has a radius of 1.9 mm, 32 pixels; noise is 0.01 mm.
  const Differences same = near_the_ball(frame->difference_mm, 28);
  EXPECT_NEAR(same.mean_mm, 0, 0.01);
  EXPECT_LT(same.worst_mm, 0.08);
  const cv::Mat body_mm = frame->other->depth->depth_mm;
  EXPECT_NEAR(body_mm.at<float>(static_cast<int>(kBall_v), static_cast<int>(kBall_u)), depth_of(1),
              0.02);
  EXPECT_EQ(body_mm.at<float>(200, 60), 0) << "the body is not there";
  EXPECT_NE(frame->result.depth->depth_mm.data, body_mm.data);
  // A smaller ball fits worse: 2 mm^2 / (2 R) less deep at the rim of the contact.
  const auto other = measurer_.measure(1, {OtherMethod::kBody, {}, {}, 0, small}, job_);
  ASSERT_TRUE(other.ok() && other->body_rms_mm);
  EXPECT_GT(*other->body_rms_mm, 3 * *frame->body_rms_mm);
  const auto none = measurer_.measure(1, {OtherMethod::kBody, {}, {}, 0, folder_ / "no.stl"}, job_);
  ASSERT_TRUE(none.ok() && none->other_problem);
  EXPECT_FALSE(none->other);
}

TEST_F(FrameMeasurerTest, ComparesWithAnotherRecording) {
  const fs::path copy = folder_ / "copy";
  fs::copy(recording_, copy);
  open();
  const auto own = measurer_.measure(2, {OtherMethod::kFrame, {}, {}, 0}, job_);
  const auto other = measurer_.measure(2, {OtherMethod::kRecording, {}, {}, 0, copy}, job_);
  ASSERT_TRUE(own.ok() && other.ok());
  ASSERT_FALSE(other->other_problem) << other->other_problem->sentence();
  const Differences expected = near_the_ball(own->difference_mm, 3);
  EXPECT_NEAR(expected.mean_mm, depth_of(2) - depth_of(0), 0.05);
  EXPECT_EQ(near_the_ball(other->difference_mm, 3).mean_mm, expected.mean_mm);
  const auto gone =
      measurer_.measure(2, {OtherMethod::kRecording, {}, {}, 0, folder_ / "no"}, job_);
  ASSERT_TRUE(gone.ok() && gone->other_problem);
}

/// A ball of a larger radius in the pose that fits: on its flank the skin is off by less than the
/// difference of the depths, which is measured along z.
TEST_F(FrameMeasurerTest, TheDistanceFromABodyIsThatToItsNearestPoint) {
  const fs::path file = folder_ / "ball.stl";
  test::write_stl(file, test::ball(1.3 * FlatSensor::kBallRadiusMm));
  open();
  const auto frame = measurer_.measure(2, {OtherMethod::kBody, {}, {}, 0, file}, job_);
  ASSERT_TRUE(frame.ok());
  ASSERT_FALSE(frame->other_problem) << frame->other_problem->sentence();
  const cv::Mat own = frame->result.depth->depth_mm, body = frame->other->depth->depth_mm;
  int compared = 0;
  double most = 0;
  for (int v = 0; v < own.rows; ++v)
    for (int u = 0; u < own.cols; ++u) {
      const float distance = frame->difference_mm.at<float>(v, u), depth = own.at<float>(v, u);
      ASSERT_EQ(std::isfinite(distance), std::isfinite(depth));
      if (!std::isfinite(depth)) continue;
      const float apart = depth - body.at<float>(v, u);
      // Never farther than along z, on the same side.
      EXPECT_LE(std::abs(distance), std::abs(apart) + 1e-3F) << u << ' ' << v;
      if (std::abs(apart) > 0.02F) {
        EXPECT_GT(distance * apart, 0) << u << ' ' << v;
        ++compared;
        most = std::max(most, 1.0 - std::abs(distance / apart));
      }
    }
  EXPECT_GT(compared, 200);
  EXPECT_GT(most, 0.03) << "the flank is inclined";
}

/// The other finger reads twice the depth: what is compared is what each reads with its own
/// mapping.
TEST_F(FrameMeasurerTest, ComparesWithAnotherFingersRecordingByItsOwnCalibration) {
  const test::TemporaryFolder other;
  fs::copy(folder_ / "ref.png", other / "ref.png");
  const fs::path copy = other / "recording";
  fs::copy(recording_, copy);
  Finger twice = finger_;
  twice.mapping->a_mm *= 2;
  ASSERT_TRUE(twice.save(other.path()).ok());
  open();
  const ComparisonSpec with{OtherMethod::kFinger, {}, {}, 1, copy, other.path()};
  const auto frame = measurer_.measure(1, with, job_);
  ASSERT_TRUE(frame.ok());
  ASSERT_FALSE(frame->other_problem) << frame->other_problem->sentence();
  ASSERT_TRUE(frame->other && frame->other->depth);
  EXPECT_NEAR(near_the_ball(frame->difference_mm, 3).mean_mm, -depth_of(1), 0.05);
  EXPECT_NEAR(near_the_ball(measurer_.measure(2, with, job_)->difference_mm, 3).mean_mm,
              depth_of(2) - 2 * depth_of(1), 0.05);
  // Its own frames are measured as before.
  const auto alone = measurer_.measure(1, {}, job_);
  EXPECT_EQ(cv::norm(alone->result.depth->depth_mm, frame->result.depth->depth_mm, cv::NORM_INF),
            0);
  const auto none =
      measurer_.measure(1, {OtherMethod::kFinger, {}, {}, 1, copy, folder_ / "no finger"}, job_);
  ASSERT_TRUE(none.ok() && none->other_problem);
  EXPECT_FALSE(none->other);
}

TEST_F(FrameMeasurerTest, CompletesALiveFrameAsIfItWereRecorded) {
  open();
  const MeasuredFrame recorded = measurer_.measure(1, {OtherMethod::kPaper}, job_).value();
  FrameMeasurer live;
  const auto alone = live.complete(recorded.result, finger_, folder_.path(), {}, job_);
  ASSERT_TRUE(alone.ok());
  EXPECT_FALSE(alone.value().other);
  EXPECT_EQ(cv::norm(alone.value().sd_mm, recorded.sd_mm, cv::NORM_INF), 0);
  const auto compared =
      live.complete(recorded.result, finger_, folder_.path(), {OtherMethod::kPaper}, job_);
  ASSERT_TRUE(compared.ok() && compared.value().other);
  const cv::Mat apart = compared->difference_mm != recorded.difference_mm;
  cv::Mat number = recorded.difference_mm == recorded.difference_mm;
  EXPECT_EQ(cv::countNonZero(apart & number), 0);
  const auto no_folder = live.complete(recorded.result, finger_, {}, {OtherMethod::kPaper}, job_);
  ASSERT_TRUE(no_folder.ok());
  EXPECT_FALSE(no_folder.value().other);
}

TEST_F(FrameMeasurerTest, HasNoDepthBeforeCalibration) {
  save_finger(false);
  open();
  const auto frame = measurer_.measure(0, {}, job_);
  ASSERT_TRUE(frame.ok());
  EXPECT_FALSE(frame.value().is_calibrated);
  EXPECT_FALSE(frame.value().result.depth);
  EXPECT_TRUE(frame.value().sd_mm.empty());
}

TEST_F(FrameMeasurerTest, SaysWhyNothingIsMeasured) {
  EXPECT_NE(measurer_.open_recording(folder_ / "gone.mkv", job_)
                .error()
                .sentence()
                .find("no longer exists"),
            std::string::npos);
  EXPECT_NE(measurer_.load_finger({}, job_).error().sentence().find("no finger is open"),
            std::string::npos);
  EXPECT_FALSE(measurer_.load_finger(recording_, job_).ok()) << "there is no finger in it";
  open();  // and goes on
  EXPECT_TRUE(measurer_.measure(0, {}, job_).ok());
}

}  // namespace
}  // namespace alltact
