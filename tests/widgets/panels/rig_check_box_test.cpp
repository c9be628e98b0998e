// The list before the first recording, in words.
#include "widgets/panels/recording_checks.h"

#include <QLabel>
#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/videodev2.h>

namespace alltact {
namespace {

using testing::HasSubstr;

std::string words_of(const RigCheckBox& box) {
  QStringList texts;
  for (const QLabel* label : box.findChildren<QLabel*>())
    if (label->isVisible()) texts << label->text();
  return texts.join(QLatin1Char('\n')).toStdString();
}

CameraControl exposure(int value) {
  CameraControl mode;
  mode.id = V4L2_CID_EXPOSURE_AUTO;
  mode.name = "Auto Exposure";
  mode.type = ControlType::kMenu;
  mode.menu = {{1, "Manual Mode"}, {3, "Aperture Priority Mode"}};
  mode.value = value;
  return mode;
}

TEST(RigCheckBox, NamesWhatIsToBeDoneAndTheControlToLock) {
  RigCheckBox box;
  box.show();
  box.set_needed(true);
  box.show_findings(
      {{RigItem::kFocusTip, RigState::kBad,
        en::say("edges at the {} are {:.1f} px wide", en::say("tip"), 7.0),
        en::say("turn the lens until the {} is sharp, and let the other end stay so",
                en::say("tip"))},
       {RigItem::kDots, RigState::kFine, en::say("{} of {} dots are found", 12, 12), ""}},
      {exposure(3)});
  QTest::qWait(20);  // new rows show themselves with the next turn of the event loop
  EXPECT_THAT(words_of(box), HasSubstr("Focus at the tip: edges at the tip are 7.0 px wide."));
  EXPECT_THAT(words_of(box), HasSubstr("Turn the lens until the tip is sharp"));
  EXPECT_THAT(words_of(box), HasSubstr("Dots: 12 of 12 dots are found."));
  EXPECT_THAT(words_of(box), HasSubstr("Automatic exposure is on"));
  EXPECT_THAT(box.findChild<QToolButton*>()->text().toStdString(), HasSubstr("2"));
  box.show_findings({}, {exposure(1)});
  QTest::qWait(20);
  EXPECT_THAT(words_of(box), HasSubstr("all modes are manual"));
  box.set_needed(false);
  EXPECT_EQ(words_of(box), "") << "folded away";
}

}  // namespace
}  // namespace alltact
