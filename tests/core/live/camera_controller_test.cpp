// A camera's controls set from a thread that must not wait for it.
#include "core/live/camera_controller.h"

#include "tests/core/devices/fake_camera_use.h"

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

class CameraControllerTest : public testing::Test {
 protected:
  /// The controller's thread may be at the camera still.
  void TearDown() override {
    controller_.attach(nullptr, {});
    EXPECT_TRUE(comes_true([&] { return camera_.use_count() == 1; }));
  }
  [[nodiscard]] bool comes_to_lock(bool is_locked) const {
    return comes_true([&] { return controller_.status().is_locked == is_locked; });
  }

  FakeCamera fake_{raw(true)};
  std::shared_ptr<V4l2Camera> camera_ = opened(fake_);
  CameraController controller_;
};

TEST_F(CameraControllerTest, SetsWhatIsWantedAndLocksANewCamera) {
  EXPECT_FALSE(controller_.status().has_camera);
  controller_.attach(camera_, {{V4L2_CID_GAIN, "Gain", 33}});
  EXPECT_TRUE(controller_.status().has_camera);
  EXPECT_TRUE(comes_to_lock(true));
  EXPECT_EQ(fake_.control(V4L2_CID_GAIN), 33);
  EXPECT_EQ(controller_.status().controls.size(), 8U);
  controller_.attach(nullptr, {});
  EXPECT_FALSE(controller_.status().has_camera);
  EXPECT_TRUE(controller_.status().controls.empty());
}

TEST_F(CameraControllerTest, SetsALaterWishAndLetsGoOfTheLock) {
  controller_.attach(camera_, {});
  ASSERT_TRUE(comes_to_lock(true));
  controller_.set({V4L2_CID_GAIN, "Gain", 21});
  controller_.set({V4L2_CID_GAIN, "Gain", 22});
  EXPECT_TRUE(comes_true([&] { return fake_.control(V4L2_CID_GAIN) == 22; }));
  controller_.set_lock(false);
  EXPECT_TRUE(comes_to_lock(false));
  controller_.set_lock(true);
  EXPECT_TRUE(comes_to_lock(true));
}

TEST_F(CameraControllerTest, KeepsTheWishForNoLockForTheNextCamera) {
  controller_.set_lock(false);
  controller_.attach(camera_, {});
  ASSERT_TRUE(comes_true([&] { return !controller_.status().controls.empty(); }));
  EXPECT_FALSE(controller_.status().is_locked);
}

TEST_F(CameraControllerTest, TellsOfAChangeThatWasRefusedUntilOneSucceeds) {
  controller_.attach(camera_, {});
  ASSERT_TRUE(comes_to_lock(true));
  controller_.set({V4L2_CID_GAIN, "Gain", 1'000'000});
  EXPECT_TRUE(comes_true([&] { return controller_.status().problem.has_value(); }));
  controller_.set({V4L2_CID_GAIN, "Gain", 12});
  EXPECT_TRUE(comes_true([&] { return !controller_.status().problem; }));
}

}  // namespace
}  // namespace alltact::test
