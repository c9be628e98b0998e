// What a camera is set to: format and controls, kept, put back and held still.
#include "tests/core/devices/fake_camera_use.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::HasSubstr;

TEST(V4l2Camera, TheSameSettingsAreBackAfterPluggingIn) {
  FakeCamera fake(raw(true));
  const auto camera = opened(fake, {"YUYV", 64, 48, 30});
  ASSERT_TRUE(
      camera->set_control({V4L2_CID_AUTO_WHITE_BALANCE, "White Balance, Automatic", 0}).ok());
  ASSERT_TRUE(
      camera->set_control({V4L2_CID_WHITE_BALANCE_TEMPERATURE, "White Balance Temperature", 3300})
          .ok());
  ASSERT_TRUE(camera->set_control({V4L2_CID_GAIN, "Gain", 42}).ok());
  const CameraSettings before = camera->settings();
  fake.unplug();
  ASSERT_TRUE(comes_true([&] { return camera->status().state == CameraState::kGone; }));
  EXPECT_EQ(camera->settings().controls, before.controls) << "known without the camera too";
  EXPECT_THAT(camera->set_control({V4L2_CID_GAIN, "Gain", 1}).error().what.english(),
              HasSubstr("unplugged"));
  fake.plug_in();
  EXPECT_EQ(fake.control(V4L2_CID_GAIN), 10);
  ASSERT_TRUE(comes_true([&] { return camera->status().state == CameraState::kStreaming; }));
  EXPECT_EQ(fake.control(V4L2_CID_GAIN), 42);
  EXPECT_EQ(fake.control(V4L2_CID_WHITE_BALANCE_TEMPERATURE), 3300);
  const CameraSettings after = camera->settings();
  EXPECT_EQ(after.controls, before.controls);
  EXPECT_EQ(after.format, before.format);
  EXPECT_EQ(after.identity, before.identity);
}

TEST(V4l2Camera, StoredSettingsArePutBackAtTheStart) {
  FakeCamera fake(raw(true));
  std::vector<ControlValue> stored;
  {
    const auto camera = opened(fake);
    ASSERT_TRUE(camera->lock().ok());
    ASSERT_TRUE(camera->set_control({V4L2_CID_EXPOSURE_ABSOLUTE, "Exposure", 77}).ok());
    stored = camera->settings().controls;
  }
  fake.unplug();
  fake.plug_in();
  const auto camera = V4l2Camera::open(place_of(fake), {}, stored);
  ASSERT_TRUE(camera.ok());
  EXPECT_EQ(fake.control(V4L2_CID_EXPOSURE_ABSOLUTE), 77);
  EXPECT_EQ((*camera)->settings().controls, stored);
}

TEST(V4l2Camera, TheLockHoldsWhatOthersChangeWhetherTheyTellOrNot) {
  FakeCamera fake(raw(true));
  const auto camera = opened(fake);
  ASSERT_TRUE(camera->lock().ok());
  EXPECT_EQ(fake.control(V4L2_CID_EXPOSURE_AUTO), V4L2_EXPOSURE_MANUAL);
  EXPECT_EQ(fake.control(V4L2_CID_AUTO_WHITE_BALANCE), 0);
  EXPECT_EQ(fake.control(V4L2_CID_FOCUS_AUTO), 0);
  fake.set_from_outside(V4L2_CID_EXPOSURE_ABSOLUTE, 999);
  EXPECT_TRUE(comes_true([&] { return fake.control(V4L2_CID_EXPOSURE_ABSOLUTE) == 250; }, 1s));
  fake.drift(V4L2_CID_GAIN, 55);
  EXPECT_TRUE(comes_true([&] { return fake.control(V4L2_CID_GAIN) == 10; }, 3s));
  EXPECT_TRUE(comes_true([&] { return camera->status().restored == 2; }));
  EXPECT_THAT(remarks_of(*camera),
              Contains("'Exposure Time, Absolute' was changed from 250 to 999 by something else; "
                       "it was restored."));
  // Our own change is no such thing.
  ASSERT_TRUE(camera->set_control({V4L2_CID_GAIN, "Gain", 20}).ok());
  std::this_thread::sleep_for(1500ms);
  EXPECT_EQ(fake.control(V4L2_CID_GAIN), 20);
  EXPECT_EQ(camera->status().restored, 2U);
  camera->unlock();
  fake.set_from_outside(V4L2_CID_GAIN, 66);
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(fake.control(V4L2_CID_GAIN), 66);
}

TEST(V4l2Camera, ControlsCarryRangesMenusAndWhoHasThemInHand) {
  FakeCamera fake(raw(true));
  const auto camera = opened(fake);
  const auto controls = camera->controls();
  ASSERT_TRUE(controls.ok());
  const auto named = [&](const std::string& name) -> const CameraControl& {
    for (const CameraControl& control : *controls)
      if (control.name == name) return control;
    throw std::runtime_error(name);
  };
  EXPECT_EQ(controls->size(), 8U) << "without the two class titles";
  const CameraControl& exposure = named("Auto Exposure");
  EXPECT_EQ(exposure.type, ControlType::kMenu);
  ASSERT_EQ(exposure.menu.size(), 2U);
  EXPECT_EQ(exposure.menu[1].value, 3);
  EXPECT_EQ(exposure.menu[1].name, "Aperture Priority Mode");
  EXPECT_EQ(exposure.value, 3);
  const CameraControl& temperature = named("White Balance Temperature");
  EXPECT_EQ(temperature.low, 2800);
  EXPECT_EQ(temperature.high, 6500);
  EXPECT_EQ(temperature.step, 10);
  EXPECT_EQ(temperature.default_value, 4600);
  EXPECT_TRUE(temperature.is_inactive);
  EXPECT_FALSE(named("Gain").is_inactive);

  const auto sentence = [&](std::uint32_t id, const char* name, std::int64_t value) {
    return camera->set_control({id, name, value}).error().sentence();
  };
  EXPECT_THAT(sentence(V4L2_CID_WHITE_BALANCE_TEMPERATURE, "Temperature", 3000),
              HasSubstr("automatic mode controls it"));
  EXPECT_THAT(sentence(V4L2_CID_GAIN, "Gain", 1000), HasSubstr("the camera uses 100 instead"));
  EXPECT_THAT(sentence(V4L2_CID_EXPOSURE_AUTO, "Auto", 9), HasSubstr("refuses this value"));
}

TEST(ChooseFormat, TakesTheLargestThatIsFastEnoughAndLosesLeast) {
  const auto format = [](PixelFormat pixels, int width, int height, std::uint32_t rate) {
    return CameraFormat{static_cast<std::uint32_t>(pixels), width, height, 1, rate};
  };
  const std::vector<CameraFormat> offered = {
      format(PixelFormat::kYuyv, 1920, 1080, 5), format(PixelFormat::kMjpeg, 1920, 1080, 30),
      format(PixelFormat::kMjpeg, 640, 480, 30), format(PixelFormat::kYuyv, 640, 480, 30),
      format(PixelFormat::kGrey, 640, 480, 30),  {0x34363248, 3840, 2160, 1, 30}};  // H264
  const auto chosen = [&](const FormatCriteria& criteria) {
    const auto best = choose_format(offered, criteria, "node");
    return best.ok() ? best->text().english() : best.error().sentence();
  };
  EXPECT_EQ(chosen({}), "1920x1080 MJPG at 30 frames per second");
  EXPECT_EQ(chosen({"", 640, 480, 0}), "640x480 GREY at 30 frames per second");
  EXPECT_EQ(chosen({"YUYV", 0, 0, 0}), "640x480 YUYV at 30 frames per second");
  EXPECT_EQ(chosen({"YUYV", 1920, 1080, 0}), "1920x1080 YUYV at 5 frames per second");
  EXPECT_EQ(chosen({"H264", 0, 0, 0}), "3840x2160 H264 at 30 frames per second");
  EXPECT_THAT(chosen({"BA81", 0, 0, 0}), HasSubstr("no such readable format"));
}

TEST(V4l2Camera, AutomaticModesThatAreOnAreNamedUntilTheLockSwitchesThemOff) {
  FakeCamera fake(raw(true));
  const auto camera = opened(fake);
  const auto names = [&] {
    std::vector<std::uint32_t> ids;
    for (const CameraControl& control : automatic_modes_on(camera->controls().value()))
      ids.push_back(control.id);
    return ids;
  };
  fake.set_from_outside(V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_APERTURE_PRIORITY);
  EXPECT_THAT(names(), Contains(V4L2_CID_EXPOSURE_AUTO));
  EXPECT_THAT(names(), testing::Not(Contains(V4L2_CID_GAIN)));
  ASSERT_TRUE(camera->lock().ok());
  EXPECT_THAT(names(), testing::IsEmpty());
}

}  // namespace
}  // namespace alltact::test
