// A press is measured once for a given finger, reference and settings.
#include "calibration/finger/calibrate_presses.h"
#include "core/sources/file_source.h"
#include "tests/support/flat_calibration.h"

#include <functional>
#include <memory>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::FlatFinger;

class PressMeters : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(flat_.make().status, 0);
    const auto done = calibrate_finger(flat_calibration(flat_), Job());
    ASSERT_TRUE(done) << done.error().sentence();
    finger_.emplace((*open_finger(flat_.finger()).value()).without_mapping());
    auto frame = read_stored_press(flat_.finger(), "press_1");
    ASSERT_TRUE(frame) << frame.error().sentence();
    frame_ = *frame;
  }
  [[nodiscard]] PressMeter meter(const std::string& checksum,
                                 const PipelineSettings& settings = {}) {
    return {Pipeline::create(*finger_, settings_for_presses(settings), Job()).value(), checksum};
  }
  /// Measurements that were made for it.
  static std::int64_t made_for(PressMeter meter, const FramePtr& frame) {
    const auto before = press_measurements();
    const auto press = meter(frame, Job());
    EXPECT_TRUE(press && (*press)->press);
    return press_measurements() - before;
  }

  FlatFinger flat_;
  std::optional<FingerSnapshot> finger_;
  FramePtr frame_;
};

TEST_F(PressMeters, ShareAPressAsLongAsItIsHeld) {
  auto first = meter("reference");
  auto held = first(frame_, Job()).value();
  auto second = meter("reference");
  EXPECT_EQ(second(frame_, Job()).value(), held);
  EXPECT_EQ(made_for(meter("reference"), frame_), 0);
  const auto copy = std::make_shared<Frame>(*frame_);
  copy->grey = frame_->grey.clone();
  copy->origin = "elsewhere";
  EXPECT_EQ(made_for(meter("reference"), copy), 0) << "the same image, read again";
  held.reset();
  EXPECT_EQ(made_for(meter("reference"), frame_), 1);
}

TEST_F(PressMeters, MeasureAgainWhereAnythingDiffers) {
  const auto held = meter("reference")(frame_, Job()).value();
  EXPECT_EQ(made_for(meter("another reference"), frame_), 1);
  EXPECT_EQ(made_for(meter(""), frame_), 1) << "an unknown reference";
  PipelineSettings smoother;
  smoother.smoothing_px += 1;
  EXPECT_EQ(made_for(meter("reference", smoother), frame_), 1);
  const auto renamed = std::make_shared<Frame>(*frame_);
  renamed->name = "press_7";
  EXPECT_EQ(made_for(meter("reference"), renamed), 1);
  const auto brighter = std::make_shared<Frame>(*frame_);
  brighter->grey = frame_->grey.clone();
  brighter->grey.at<std::uint8_t>(5, 5) ^= 1;
  EXPECT_EQ(made_for(meter("reference"), brighter), 1);
  finger_->finger.face.layer_mm += 0.1;
  EXPECT_EQ(made_for(meter("reference"), frame_), 1);
}

TEST_F(PressMeters, SolveTheSamePressesOnce) {
  const auto solved = [&](double radius_mm,
                          const std::function<void(CalibrationSettings&)>& change = {}) {
    FingerCalibrationInput input = flat_calibration(flat_);
    input.press_set.ball_radius_mm = radius_mm;
    if (change) change(input.calibration);
    return calibrate_finger(input, Job()).value().solution;
  };
  const double radius_mm = flat_calibration(flat_).press_set.ball_radius_mm;
  auto held = solved(radius_mm);
  ASSERT_TRUE(held);
  EXPECT_EQ(solved(radius_mm), held);
  EXPECT_NE(solved(radius_mm + 0.01), held) << "of another ball";
  EXPECT_NE(solved(radius_mm, [](CalibrationSettings& how) { how.degree = 2; }), held);
  const std::weak_ptr<const Calibration> released = held;
  held.reset();
  EXPECT_TRUE(released.expired());
}

TEST_F(PressMeters, DoNotShareThePressesOfOneVideo) {
  auto video = meter("reference");
  const auto held = video(frame_, Job()).value();
  const auto before = press_measurements();
  ASSERT_TRUE(video.next(frame_));
  EXPECT_EQ(press_measurements(), before + 1);
}

}  // namespace
}  // namespace alltact
