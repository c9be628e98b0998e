// `alltact devices` and programs that know nothing of us, with a made-up camera and pedal.
#include "tests/support/program.h"
#include "tests/support/sanitized.h"

#include <regex>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact::test {
namespace {

using testing::HasSubstr;

constexpr const char* kDevices = R"(P: /devices/pci/usb1/1-2/video4linux/video0
N: video0
E: SUBSYSTEM=video4linux
E: DEVNAME=/dev/video0
E: MAJOR=81
E: MINOR=0
E: ID_SERIAL_SHORT=AAAA
E: DEVLINKS=/dev/v4l/by-id/usb-Fake_AAAA-video-index0
A: name=Fake Camera\n
A: dev=81:0\n

P: /devices/pci/usb1/1-2/video4linux/video9
N: video9
E: SUBSYSTEM=video4linux
E: DEVNAME=/dev/video9
E: MAJOR=81
E: MINOR=9
A: name=Broken Camera\n
A: dev=81:9\n

P: /devices/pci/usb1/2-0
E: SUBSYSTEM=usb
E: DEVTYPE=usb_device
A: product=FootSwitch\n

P: /devices/pci/usb1/2-0/2-0:1.0
E: SUBSYSTEM=usb
E: DEVTYPE=usb_interface
A: bInterfaceNumber=01\n

P: /devices/pci/usb1/2-0/2-0:1.0/0003:0C45:7403.0001
E: SUBSYSTEM=hid
E: HID_ID=0003:00000C45:00007403
E: HID_NAME=FootSwitch
E: HID_UNIQ=

P: /devices/pci/usb1/2-0/2-0:1.0/0003:0C45:7403.0001/hidraw/hidraw0
N: hidraw0
E: SUBSYSTEM=hidraw
E: DEVNAME=/dev/hidraw0
E: MAJOR=240
E: MINOR=0
A: dev=240:0\n
)";

/// Runs a command where these devices are; /dev/video0 is the fake camera.
ProgramRun run_among_devices(const std::string& command, const std::string& camera) {
  const TemporaryFolder folder;
  write_text(folder / "devices", kDevices);
  return run_shell(
      fmt::format("ALLTACT_FAKE_CAMERA='node=/dev/video0 {}' umockdev-run --device '{}' -- "
                  "env LD_PRELOAD='{}:libumockdev-preload.so.0' timeout 100 {}",
                  camera, (folder / "devices").string(), ALLTACT_FAKE_CAMERA_LIBRARY, command));
}

TEST(Devices, ListsWhatThereIsAndWhatIsWrongWithIt) {
  if (kIsSanitized) GTEST_SKIP() << "sanitizers do not stand other preloaded libraries";
  const std::string program = std::string("'") + ALLTACT_PROGRAM + "' devices";
  const std::string camera = "pixels=MJPG,YUYV size=640x480,1920x1080 rate=30";
  const ProgramRun text = run_among_devices(program, camera);
  ASSERT_EQ(text.status, 0) << text.errors;
  EXPECT_THAT(text.output,
              HasSubstr("camera  usb-Fake_AAAA-video-index0 (/dev/video0, Fake Camera): "
                        "1920x1080 YUYV at 30 frames per second\n"));
  EXPECT_THAT(text.output, HasSubstr("(/dev/video9, Broken Camera): cannot be used: "));
  EXPECT_THAT(text.output,
              HasSubstr("hid     0c45:7403/1 (/dev/hidraw0, FootSwitch): can be used"));
  EXPECT_THAT(text.output, testing::Not(HasSubstr("Exposure")));
  EXPECT_THAT(run_among_devices(program + " --details", camera).output,
              AllOf(HasSubstr("    640x480 MJPG at 30 frames per second\n"),
                    HasSubstr("    Exposure Time, Absolute: 250 (3 to 2047 in steps of 1, default "
                              "250), now set by an automatic mode\n")));

  const ProgramRun run = run_among_devices(program + " --json", camera);
  const auto json = nlohmann::json::parse(run.output);
  ASSERT_EQ(json.at("cameras").size(), 2U);
  const auto& first = json["cameras"][0];
  EXPECT_EQ(first.at("by_id"), "usb-Fake_AAAA-video-index0");
  EXPECT_EQ(first.at("serial"), "AAAA");
  EXPECT_EQ(first.at("usable"), true);
  EXPECT_EQ(first.at("formats").size(), 4U);
  EXPECT_EQ(first.at("controls").size(), 8U);
  EXPECT_EQ(json["cameras"][1].at("usable"), false);
  EXPECT_FALSE(json["cameras"][1].at("problem").get<std::string>().empty());
  EXPECT_EQ(json.at("hid")[0].at("device"), "0c45:7403/1");
}

TEST(Devices, ACameraIsRecordedByItsLastingName) {
  if (kIsSanitized) GTEST_SKIP() << "sanitizers do not stand other preloaded libraries";
  for (const char* format : {"MJPG", "GREY"}) {
    const TemporaryFolder folder;
    const std::string video = (folder / "v.mkv").string();
    const ProgramRun run = run_among_devices(
        fmt::format("'{}' record usb-Fake_AAAA-video-index0 -o '{}' --frames 25 --json",
                    ALLTACT_PROGRAM, video),
        fmt::format("pixels={} size=320x240 rate=60", format));
    ASSERT_EQ(run.status, 0) << run.errors;
    const auto json = nlohmann::json::parse(run.output);
    EXPECT_EQ(json.at("frames"), 25);
    EXPECT_EQ(json.at("dropped"), 0);
    EXPECT_EQ(json.at("codec") == "the camera's own JPEG packets", std::string(format) == "MJPG");
    const std::string journal = text_of(folder / "v.frames.csv");
    EXPECT_THAT(journal, HasSubstr("# source: usb-Fake_AAAA-video-index0\n"));
    EXPECT_THAT(journal, HasSubstr("Brightness="));
    EXPECT_EQ(run_shell("ffprobe -v error '" + video + "'").errors, "");
  }
  const ProgramRun none = run_among_devices(
      fmt::format("'{}' record no-such-camera -o /tmp/none.mkv", ALLTACT_PROGRAM), "");
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.errors, HasSubstr("no-such-camera"));
}

TEST(Devices, WithoutAnyItSaysSo) {
  const ProgramRun run =
      run_shell(std::string("umockdev-run -- '") + ALLTACT_PROGRAM + "' devices");
  if (kIsSanitized) GTEST_SKIP() << "sanitizers do not stand other preloaded libraries";
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.output, "No camera was found.\nNo HID device (pedal, dimmer) was found.\n");
}

TEST(FakeCamera, AnotherProgramStreamsFromItEveryFormat) {
  for (const char* format : {"mjpeg", "yuyv422", "gray"}) {
    const ProgramRun run = run_among_devices(
        fmt::format("ffmpeg -hide_banner -nostdin -f v4l2 -input_format {} -video_size 320x240 "
                    "-i /dev/video0 -frames:v 40 -f framecrc -",
                    format),
        "pixels=MJPG,YUYV,GREY size=640x480,320x240 rate=60");
    EXPECT_EQ(run.status, 0) << run.errors;
    const auto lines = std::count(run.output.begin(), run.output.end(), '\n');
    EXPECT_GE(lines, 40) << run.output;
    EXPECT_THAT(run.errors, HasSubstr("320x240"));
  }
}

TEST(FakeCamera, PassesTheKernelsOwnTestOfCameras) {
  const ProgramRun run = run_among_devices("v4l2-compliance -d /dev/video0 -s",
                                           "pixels=MJPG,YUYV,GREY size=640x480,320x240 rate=60");
  std::set<std::string> failed, passed;
  std::string text = run.output;
  std::replace(text.begin(), text.end(), '\r', '\n');
  static const std::regex line(R"(test ([^\n]*): (OK|FAIL))");
  for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it)
    ((*it)[2] == "FAIL" ? failed : passed).insert((*it)[1]);
  EXPECT_GE(passed.size(), 40U) << run.output << run.errors;
  for (const char* needed :
       {"MMAP (no poll)", "MMAP (select)", "MMAP (epoll)", "blocking wait", "VIDIOC_QUERYCAP",
        "VIDIOC_QUERY_EXT_CTRL/QUERYMENU", "VIDIOC_REQBUFS/CREATE_BUFS/QUERYBUF", "VIDIOC_S_FMT"})
    EXPECT_TRUE(passed.contains(needed)) << needed << "\n" << run.output;
  // As USB cameras do, it refuses controls that an automatic mode has in hand, which the test holds
  // against it; and select() cannot be told of events.
  const std::set<std::string> known = {"VIDIOC_G/S_CTRL", "VIDIOC_G/S/TRY_EXT_CTRLS",
                                       "VIDIOC_(UN)SUBSCRIBE_EVENT/DQEVENT"};
  for (const std::string& test : failed) EXPECT_TRUE(known.contains(test)) << test << run.output;
}

}  // namespace
}  // namespace alltact::test
