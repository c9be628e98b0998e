// The lamp's dimmer beside the window, with a device that remembers what it is sent.
#include "widgets/controls/control_panel.h"
#include "widgets/controls/devices.h"

#include <QSignalSpy>
#include <QTest>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using Report = std::vector<std::uint8_t>;

/// What the dimmer got, whoever opened it.
struct Sent {
  std::mutex mutex;
  std::vector<Report> reports;
  bool is_gone = false;
  std::vector<int> levels() {
    const std::lock_guard lock(mutex);
    std::vector<int> all;
    for (const Report& report : reports) all.push_back(report.at(2));
    return all;
  }
};

class Port : public HidPort {
 public:
  explicit Port(std::shared_ptr<Sent> sent) : sent_(std::move(sent)) {}
  Result<Report> read(int) override { return Report(); }
  Status write(std::span<const std::uint8_t> report) override {
    const std::lock_guard lock(sent_->mutex);
    if (sent_->is_gone)
      return Error{en::say("the device was unplugged"), "", en::say("plug it in again")};
    sent_->reports.emplace_back(report.begin(), report.end());
    return {};
  }
  Status send_feature(std::span<const std::uint8_t>) override { return {}; }

 private:
  std::shared_ptr<Sent> sent_;
};

HidPorts ports_of(const std::shared_ptr<Sent>& sent) {
  HidPorts ports;
  ports.list = [] {
    FoundHid found;
    found.identity.vendor = 0x1234;
    found.identity.product = 0x0001;
    found.identity.name = "Lab Dimmer";
    return std::vector{found};
  };
  ports.open = [sent](const std::string&) -> Result<std::unique_ptr<HidPort>> {
    return std::unique_ptr<HidPort>(std::make_unique<Port>(sent));
  };
  return ports;
}

DimmerSetting at(double level) {
  return {"1234:0001", "output id=0 bytes=2 at=1 range=0..200", level};
}

TEST(Lamp, IsSetBesideTheWindowAndTheNewestWins) {
  const auto sent = std::make_shared<Sent>();
  Lamp lamp(ports_of(sent));
  for (const double level : {0.1, 0.2, 0.3, 0.4, 0.5}) lamp.set(at(level));
  ASSERT_TRUE(QTest::qWaitFor([&] { return lamp.setting() && lamp.setting()->level == 0.5; }));
  EXPECT_EQ(sent->levels().back(), 100);
  EXPECT_LE(sent->levels().size(), 3U) << "what was overtaken was never told";
  lamp.set(at(1));
  ASSERT_TRUE(QTest::qWaitFor([&] { return lamp.setting() && lamp.setting()->level == 1; }));
  EXPECT_EQ(sent->levels().back(), 200);
}

TEST(Lamp, SaysWhatFailsAndWorksAgainOncePluggedIn) {
  const auto sent = std::make_shared<Sent>();
  Lamp lamp(ports_of(sent));
  sent->is_gone = true;
  lamp.set(at(0.5));
  ASSERT_TRUE(QTest::qWaitFor([&] { return lamp.problem().has_value(); }));
  EXPECT_FALSE(lamp.setting());
  sent->is_gone = false;
  lamp.set(at(0.6));
  ASSERT_TRUE(QTest::qWaitFor([&] { return lamp.setting().has_value(); }));
  EXPECT_FALSE(lamp.problem());
}

TEST(LampPanel, ChoosesADeviceAndDimsItByKeys) {
  const auto sent = std::make_shared<Sent>();
  Lamp lamp(ports_of(sent));
  LampPanel panel(lamp);
  QObject::connect(&panel, &LampPanel::setting_requested, &panel,
                   [&](const auto& wanted) { lamp.set(wanted); });
  panel.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  auto* device = panel.findChild<QComboBox*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return device->count() == 2; }));
  EXPECT_EQ(device->itemText(1), "Lab Dimmer");
  auto* slider = panel.findChild<QSlider*>();
  EXPECT_FALSE(slider->isEnabled()) << "no device is chosen";
  lamp.set(at(0.5));
  EXPECT_TRUE(slider->isEnabled());
  EXPECT_EQ(slider->value(), 50);
  EXPECT_EQ(panel.findChild<QLineEdit*>()->text().toStdString(), at(0).control);
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_Right);
  ASSERT_TRUE(QTest::qWaitFor([&] { return lamp.setting() && lamp.setting()->level > 0.505; }));
  EXPECT_EQ(sent->levels().back(), 102);
}

FoundCamera camera_at(const char* name, const char* bus, const char* node) {
  FoundCamera found;
  found.identity.name = name;
  found.identity.bus = bus;
  found.identity.node = node;
  return found;
}

TEST(CameraLabel, TellsAlikeOnesByWhereTheyArePluggedIn) {
  const std::vector cameras{camera_at("HD Camera", "usb-0000:00:14.0-1.4", "/dev/video0"),
                            camera_at("HD Camera", "usb-0000:00:14.0-2", "/dev/video2"),
                            camera_at("Other", "usb-0000:00:14.0-3", "/dev/video4"),
                            camera_at("HD Camera", "platform:cam", "/dev/video6")};
  EXPECT_EQ(camera_label(cameras[0], cameras), "HD Camera (USB port 1.4)");
  EXPECT_EQ(camera_label(cameras[1], cameras), "HD Camera (USB port 2)");
  EXPECT_EQ(camera_label(cameras[2], cameras), "Other");
  EXPECT_EQ(camera_label(cameras[3], cameras), "HD Camera (/dev/video6)");
}

}  // namespace
}  // namespace alltact
