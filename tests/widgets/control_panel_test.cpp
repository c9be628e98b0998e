// Controls made up in the test, moved by hand and by keys.
#include "widgets/controls/control_panel.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTest>

#include <gtest/gtest.h>
#include <linux/videodev2.h>

namespace alltact {
namespace {

CameraControl number(std::uint32_t id, const char* name, int low, int high, int step, int value) {
  CameraControl control;
  control.id = id;
  control.name = name;
  control.type = ControlType::kInteger;
  control.low = low;
  control.high = high;
  control.step = step;
  control.value = value;
  return control;
}

std::vector<CameraControl> usual() {
  CameraControl mode = number(V4L2_CID_EXPOSURE_AUTO, "Auto Exposure", 0, 3, 1, 1);
  mode.type = ControlType::kMenu;
  mode.menu = {{1, "Manual Mode"}, {3, "Aperture Priority Mode"}};
  CameraControl flicker = number(V4L2_CID_BACKLIGHT_COMPENSATION, "Backlight", 0, 1, 1, 0);
  flicker.type = ControlType::kBoolean;
  CameraControl button = number(1, "Pan Reset", 0, 0, 0, 0);
  button.type = ControlType::kButton;
  return {flicker, button, number(V4L2_CID_GAIN, "Gain", 0, 100, 5, 20),
          number(V4L2_CID_EXPOSURE_ABSOLUTE, "Exposure Time, Absolute", 3, 2047, 1, 200), mode};
}

class ControlPanelTest : public testing::Test {
 protected:
  ControlPanelTest() {
    panel_.resize(320, 500);
    panel_.show();
    static_cast<void>(QTest::qWaitForWindowExposed(&panel_));
  }
  template <class T>
  T* named(const char* name) {
    for (T* widget : panel_.findChildren<T*>())
      if (widget->accessibleName() == QLatin1String(name)) return widget;
    return nullptr;
  }
  ControlPanel panel_;
};

TEST_F(ControlPanelTest, SaysSoWhereTheSourceIsNoCamera) {
  EXPECT_EQ(panel_.findChildren<QSlider*>().size(), 0);
  bool is_said = false;
  for (const QLabel* label : panel_.findChildren<QLabel*>())
    is_said = is_said || (label->isVisible() && label->text().contains("not a camera"));
  EXPECT_TRUE(is_said);
}

TEST_F(ControlPanelTest, ShowsRangesAsTheCameraReportsThem) {
  panel_.set_controls(usual(), false);
  auto* exposure = named<QSlider>("Exposure time");
  ASSERT_NE(exposure, nullptr);
  EXPECT_EQ(exposure->minimum(), 3);
  EXPECT_EQ(exposure->maximum(), 2047);
  EXPECT_EQ(exposure->value(), 200);
  EXPECT_EQ(named<QSlider>("Gain")->singleStep(), 5);
  EXPECT_EQ(named<QComboBox>("Automatic exposure")->currentText(), "Manual Mode");
  EXPECT_EQ(panel_.findChildren<QSlider*>().size(), 2) << "a button is no setting";
}

TEST_F(ControlPanelTest, PutsExposureBeforeWhatMattersLess) {
  panel_.set_controls(usual(), false);
  QTest::qWait(50);
  const auto top = [&](QWidget* widget) { return widget->mapTo(&panel_, QPoint()).y(); };
  EXPECT_LT(top(named<QComboBox>("Automatic exposure")), top(named<QSlider>("Exposure time")));
  EXPECT_LT(top(named<QSlider>("Exposure time")), top(named<QSlider>("Gain")));
  const auto boxes = panel_.findChildren<QCheckBox*>();
  for (QCheckBox* box : boxes)
    if (box->text() == QLatin1String("Backlight")) {
      EXPECT_GT(top(box), top(named<QSlider>("Gain")));
    }
}

TEST_F(ControlPanelTest, KeysMoveASliderAndTellOldAndNewValue) {
  panel_.set_controls(usual(), false);
  QSignalSpy changed(&panel_, &ControlPanel::control_changed);
  auto* gain = named<QSlider>("Gain");
  QTest::keyClick(gain, Qt::Key_Right);
  ASSERT_EQ(changed.count(), 1);
  EXPECT_EQ(changed[0][0].toUInt(), V4L2_CID_GAIN);
  EXPECT_EQ(changed[0][1].toLongLong(), 20);
  EXPECT_EQ(changed[0][2].toLongLong(), 25);
  EXPECT_EQ(named<QSpinBox>("Gain")->value(), 25) << "the number beside it follows";
}

TEST_F(ControlPanelTest, TypingANumberTellsOnceWhenItIsDone) {
  panel_.set_controls(usual(), false);
  QSignalSpy changed(&panel_, &ControlPanel::control_changed);
  auto* exposure = named<QSpinBox>("Exposure time");
  exposure->setFocus();
  exposure->selectAll();
  QTest::keyClicks(exposure, "35.0");  // ms, of which the camera counts tenths
  EXPECT_EQ(changed.count(), 0);
  QTest::keyClick(exposure, Qt::Key_Return);
  ASSERT_EQ(changed.count(), 1);
  EXPECT_EQ(changed[0][2].toLongLong(), 350);
  EXPECT_EQ(named<QSlider>("Exposure time")->value(), 350);
}

TEST_F(ControlPanelTest, WhatTheCameraReportsIsNoChangeByHand) {
  panel_.set_controls(usual(), false);
  QSignalSpy changed(&panel_, &ControlPanel::control_changed);
  auto controls = usual();
  controls[2].value = 60;
  panel_.set_controls(controls, false);
  EXPECT_EQ(named<QSlider>("Gain")->value(), 60);
  EXPECT_EQ(changed.count(), 0);
}

TEST_F(ControlPanelTest, LockedNothingCanBeChanged) {
  panel_.set_controls(usual(), true);
  EXPECT_FALSE(named<QSlider>("Gain")->isEnabled());
  EXPECT_FALSE(named<QComboBox>("Automatic exposure")->isEnabled());
  QSignalSpy locked(&panel_, &ControlPanel::lock_changed);
  for (QCheckBox* box : panel_.findChildren<QCheckBox*>())
    if (box->text().contains("ock brightness")) {
      EXPECT_TRUE(box->isChecked());
      QTest::keyClick(box, Qt::Key_Space);
    }
  ASSERT_EQ(locked.count(), 1);
  EXPECT_FALSE(locked[0][0].toBool());
}

TEST_F(ControlPanelTest, WhatAnAutomaticModeHasInHandCannotBeMoved) {
  auto controls = usual();
  controls[3].is_inactive = true;
  panel_.set_controls(controls, false);
  EXPECT_FALSE(named<QSlider>("Exposure time")->isEnabled());
  EXPECT_TRUE(named<QSlider>("Gain")->isEnabled());
}

}  // namespace
}  // namespace alltact
