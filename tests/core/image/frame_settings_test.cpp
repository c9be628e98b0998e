#include "core/devices/led_dimmer.h"
#include "core/image/frame.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

FramePtr frame_with(const char* settings) {
  auto frame = std::make_shared<Frame>();
  frame->grey = cv::Mat(2, 3, CV_8UC1, cv::Scalar(7));
  if (settings != nullptr) frame->controls = std::make_shared<const std::string>(settings);
  return frame;
}

TEST(FrameSettings, EntriesStandInTheirOrderAndCannotRunIntoEachOther) {
  std::string text;
  add_setting(text, "Camera", "usb-1");
  add_setting(text, "A=b; c", "1; D=2\n");
  EXPECT_EQ(text, "Camera=usb-1; A b  c=1  D=2 ");
  EXPECT_EQ(differences(text, "Camera=usb-2; D=3").english(), "Camera changed from usb-1 to usb-2");
}

TEST(FrameSettings, OnlyWhatBothTellCanDiffer) {
  EXPECT_EQ(differences("Gain=3; Focus=200", "Focus=200; Gain=3").english(), "");
  EXPECT_EQ(differences("Gain=3; Focus=200", "Gain=5; Focus=0; Zoom=1").english(),
            "Focus changed from 200 to 0, Gain changed from 3 to 5");
  EXPECT_EQ(differences("", "Gain=5").english(), "");
  EXPECT_EQ(differences("Gain=5", "").english(), "");
  EXPECT_EQ(differences("nonsense; =; x", "nonsense; =1; x=2").english(), " changed from  to 1");
}

TEST(FrameSettings, ARecordingsAreThoseOfItsFirstFrameAndTheFirstChangeIsKept) {
  SettingsMonitor seen;
  seen.add(*frame_with(nullptr));
  EXPECT_EQ(seen.first(), "");
  for (const char* text : {"Gain=3", "Gain=3", "Gain=4", "Gain=9"}) seen.add(*frame_with(text));
  EXPECT_EQ(seen.first(), "Gain=3");
  EXPECT_EQ(seen.change().english(), "Gain changed from 3 to 4");
}

/// Gives these frames, then an error, then the end.
class Given : public Source {
 public:
  std::vector<FramePtr> frames;
  Result<FramePtr> next() override {
    if (at_ < frames.size()) return frames[at_++];
    if (at_++ == frames.size()) return Error{en::say("broken"), "", ""};
    return FramePtr();
  }
  [[nodiscard]] std::optional<std::size_t> count() const override { return frames.size(); }
  [[nodiscard]] bool is_continuous() const override { return true; }

 private:
  std::size_t at_ = 0;
};

TEST(LitSource, TheLightStandsBehindTheCamerasSettings) {
  auto given = std::make_unique<Given>();
  given->frames = {frame_with("Gain=3"), frame_with(nullptr), frame_with("Gain=4")};
  const std::vector<FramePtr> raw = given->frames;
  LitSource source(std::move(given), {"04d8:00dd", "mcp2221a gp2", 10.0 / 31});
  const std::string light = "Light=0.3226 by 04d8:00dd (mcp2221a gp2)";
  for (const std::string before : {"Gain=3; ", "", "Gain=4; "}) {
    const FramePtr frame = *source.next();
    EXPECT_EQ(*frame->controls, before + light);
    EXPECT_EQ(frame->grey.data, raw[before.empty() ? 1 : before == "Gain=3; " ? 0 : 2]->grey.data);
  }
  EXPECT_FALSE(source.next().ok());
  EXPECT_EQ(*source.next(), nullptr);
  EXPECT_EQ(source.count(), 3U);
}

}  // namespace
}  // namespace alltact
