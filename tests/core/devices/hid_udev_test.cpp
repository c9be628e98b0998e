#include "core/devices/hid_button.h"
#include "core/devices/led_dimmer.h"
#include "core/devices/open_gauge.h"
#include "tests/rigs/hid_device.h"

#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace alltact {
namespace {

using Device = test::HidDevice;
using test::TestBed;
using testing::ElementsAre;
using testing::HasSubstr;
using Report = std::vector<std::uint8_t>;

TEST(HidPort, APedalIsFoundLearntHeardAndMissed) {
  TestBed bed;
  bed.add(TestBed::hid(0, "0C45", "7403", "FootSwitch"));
  const Device pedal(bed);
  const auto hids = list_hids();
  ASSERT_EQ(hids.size(), 1U);
  EXPECT_EQ(hids[0].identity.stable_name(), "0c45:7403/0");
  EXPECT_EQ(hids[0].identity.name, "FootSwitch");
  EXPECT_FALSE(hids[0].problem.has_value());

  const Report down = {1, 0, 5, 0}, up = {1, 0, 0, 0};
  ButtonPattern pattern;
  {
    const auto port = open_hid("0c45:7403");
    ASSERT_TRUE(port.ok()) << port.error().sentence();
    std::thread foot([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(700));
      for (int i = 0; i < 2; ++i) {
        pedal.say(down);
        pedal.say(up);
      }
    });
    const auto found = learn_button({port->get()}, 5000, Job());
    foot.join();
    ASSERT_TRUE(found.ok()) << found.error().sentence();
    pattern = found->second;
    EXPECT_EQ(pattern.text(), "4 2:05=05");
  }
  std::atomic<int> presses{0};
  const HidButton button([] { return open_hid("0c45:7403/0"); }, pattern, [&] { ++presses; });
  while (!open_hid("0c45:7403/0").ok()) {
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  for (int i = 0; i < 3; ++i) {
    pedal.say(down);
    pedal.say(up);
  }
  EXPECT_EQ(presses, 3);
}

TEST(HidPort, WhatIsNotThereIsNamedWithWhatIs) {
  TestBed bed;
  EXPECT_THAT(open_hid("0c45:7403").error().sentence(), HasSubstr("no HID device was found"));
  bed.add(TestBed::hid(0, "04D8", "00DD", "MCP2221"));
  EXPECT_THAT(open_hid("0c45:7403").error().sentence(),
              AllOf(HasSubstr("no such HID device"), HasSubstr("04d8:00dd/0 (MCP2221)")));
}

TEST(HidPort, WithoutAccessTheRuleToInstallIsNamed) {
  TestBed bed;
  bed.add(TestBed::hid(0, "ABCD", "0123", "Pedal"));
  gchar* folder = umockdev_testbed_get_root_dir(bed.get());
  const std::string root = folder;
  g_free(folder);
  chmod(root.c_str(), 0755);
  chmod((root + "/dev/hidraw0").c_str(), 0600);
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {  // root may do all; someone else may not
    if (getuid() != 0 || setuid(65534) == 0) {
      const auto hids = list_hids();
      const auto port = open_hid("abcd:0123");
      const std::string reported = hids.size() == 1 && hids[0].problem && !port.ok()
                                       ? hids[0].problem->sentence() + port.error().sentence()
                                       : "no problem";
      [[maybe_unused]] const auto written = ::write(ends[1], reported.data(), reported.size());
    }
    _exit(0);
  }
  close(ends[1]);
  std::string reported(4096, ' ');
  const auto size = ::read(ends[0], reported.data(), reported.size());
  close(ends[0]);
  waitpid(child, nullptr, 0);
  reported.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  const std::string rule = "ATTRS{idVendor}==\"abcd\", ATTRS{idProduct}==\"0123\"";
  EXPECT_THAT(reported, AllOf(HasSubstr("not allowed"), HasSubstr("packaging/70-alltact.rules"),
                              HasSubstr(rule)));
  EXPECT_NE(reported.find(rule), reported.rfind(rule))
      << "in the list and on opening: " << reported;
}

TEST(HidPort, ADimmerTakesOutputAndFeatureReports) {
  TestBed bed;
  bed.add(TestBed::hid(0, "1209", "0001", "Dimmer"));
  Device device(bed);
  {
    auto port = open_hid("1209:0001");
    ASSERT_TRUE(port.ok()) << port.error().sentence();
    auto dimmer =
        LedDimmer::create(std::move(*port), "1209:0001", "output id=2 bytes=3 at=1 range=0..255");
    ASSERT_TRUE(dimmer.ok());
    ASSERT_TRUE(dimmer->set(1).ok());
    EXPECT_THAT(device.hear(), ElementsAre(2, 0, 255, 0));
  }
  auto port = open_hid("1209:0001");
  ASSERT_TRUE(port.ok()) << port.error().sentence();
  auto dimmer =
      LedDimmer::create(std::move(*port), "1209:0001", "feature id=7 bytes=2 at=0 range=0..100");
  ASSERT_TRUE(dimmer.ok());
  const Status status = dimmer->set(0.42);
  ASSERT_TRUE(status.ok()) << status.error().sentence();
  EXPECT_THAT(device.feature(), ElementsAre(7, 42, 0));
}

TEST(HidPort, AForceGaugeIsReadByItsDescription) {
  TestBed bed;
  bed.add(TestBed::hid(0, "1209", "0002", "Gauge"));
  const Device device(bed);
  GaugeChoice choice;
  choice.gauge = "hid:1209:0002";
  choice.report = "id=3 at=1 type=s16 scale=0.01 unit=N";
  choice.direction = "-y";
  const auto opener = gauge_opener(choice);
  ASSERT_TRUE(opener.ok()) << opener.error().sentence();
  auto gauge = (*opener)();
  ASSERT_TRUE(gauge.ok()) << gauge.error().sentence();
  std::vector<GaugeSample> samples;
  // What is not read before the next one merges with it on this kind of node.
  for (const Report& report : {Report{3, 0, 0x2E, 0xFB},     // -1234
                               Report{4, 0, 1, 0},           // another report
                               Report{3, 0, 0xFF, 0x7F}}) {  // over range
    device.say(report);
    const auto news = (*gauge)->read(500);
    ASSERT_TRUE(news.ok()) << news.error().sentence();
    samples.insert(samples.end(), news->samples.begin(), news->samples.end());
  }
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_NEAR(samples[0].force_N.y(), 12.34, 1e-9);
  EXPECT_FALSE(samples[1].has_force);
}

}  // namespace
}  // namespace alltact
