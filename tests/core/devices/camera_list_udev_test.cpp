#include "core/devices/camera_list.h"
#include "core/devices/hot_plug.h"
#include "tests/rigs/fake_camera.h"
#include "tests/rigs/test_bed.h"

#include <cerrno>
#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace std::chrono_literals;
using test::FakeCamera;
using test::FakeOptions;
using test::TestBed;
using testing::HasSubstr;

/// Several fake cameras behind one set of calls.
class Cameras : public V4l2Calls {
 public:
  FakeCamera& add(FakeOptions options) {
    options.sizes = {{64, 48}};
    options.rates = {100};
    return *cameras_.emplace_back(std::make_unique<FakeCamera>(options));
  }
  int open(const char* node, int flags) override {
    for (const auto& camera : cameras_)
      if (const int descriptor = camera->open(node, flags); descriptor >= 0 || errno != ENOENT)
        return descriptor;
    return -1;
  }
  int close(int descriptor) override { return owner(descriptor).close(descriptor); }
  int ioctl(int descriptor, unsigned long request, void* argument) override {
    return owner(descriptor).ioctl(descriptor, request, argument);
  }
  void* mmap(std::size_t length, int descriptor, std::int64_t offset) override {
    return owner(descriptor).mmap(length, descriptor, offset);
  }
  int munmap(void* address, std::size_t length) override {
    return cameras_.front()->munmap(address, length);
  }
  int poll(pollfd* descriptors, nfds_t count, int timeout_ms) override {
    return owner(descriptors[count - 1].fd).poll(descriptors, count, timeout_ms);
  }

 private:
  FakeCamera& owner(int descriptor) {
    for (const auto& camera : cameras_)
      if (camera->owns(descriptor)) return *camera;
    return *cameras_.front();
  }
  std::vector<std::unique_ptr<FakeCamera>> cameras_;
};

FakeOptions at(const std::string& node) {
  FakeOptions options;
  options.node = node;
  return options;
}

template <class Condition>
bool comes_true(const Condition& condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(5ms);
  return condition();
}

TEST(CameraList, ListsCamerasByLastingNamesAndHidesWhatIsNone) {
  TestBed bed;
  for (const auto& entry : {TestBed::camera(10, "BBBB", 4), TestBed::camera(2, "AAAA", 3),
                            TestBed::camera(3, "AAAA", 3, 1)})
    bed.add(entry);
  Cameras cameras;
  cameras.add(at("/dev/video2"));
  FakeOptions metadata = at("/dev/video3");
  metadata.is_metadata = true;
  cameras.add(metadata);
  cameras.add(at("/dev/video10"));

  const auto found = list_cameras(cameras);
  ASSERT_EQ(found.size(), 2U);
  const CameraIdentity& first = found[0].identity;
  EXPECT_EQ(first.node, "/dev/video2");
  EXPECT_EQ(first.name, "Fake Camera");
  EXPECT_EQ(first.by_id, "usb-Fake_Camera_AAAA-video-index0");
  EXPECT_EQ(first.by_path, "pci-0000:00:14.0-usb-0:3:1.0-video-index0");
  EXPECT_EQ(first.serial, "AAAA");
  EXPECT_EQ(first.bus, "usb-0000:00:14.0-2");
  EXPECT_EQ(first.stable_name(), first.by_id);
  EXPECT_EQ(found[1].identity.node, "/dev/video10");
  EXPECT_FALSE(found[0].problem.has_value());
  ASSERT_EQ(found[0].formats.size(), 1U);
  EXPECT_EQ(found[0].formats[0].text().english(), "64x48 MJPG at 100 frames per second");
  EXPECT_EQ(found[0].controls.size(), 8U);

  const auto node = [&](const std::string& wanted) {
    const auto identity = find_camera(wanted, found);
    return identity.ok() ? identity->node : identity.error().sentence();
  };
  for (const char* wanted : {"/dev/video10", "BBBB", "usb-Fake_Camera_BBBB-video-index0",
                             "/dev/v4l/by-id/usb-Fake_Camera_BBBB-video-index0",
                             "pci-0000:00:14.0-usb-0:4:1.0-video-index0",
                             "/dev/v4l/by-path/pci-0000:00:14.0-usb-0:4:1.0-video-index0"})
    EXPECT_EQ(node(wanted), "/dev/video10") << wanted;
  EXPECT_THAT(node("CCCC"), AllOf(HasSubstr("no such camera"), HasSubstr("AAAA")));
  EXPECT_THAT(node("/dev/video7"), HasSubstr("no such camera"));
}

TEST(CameraList, SaysWhatIsWrongWithThoseThatCannotBeUsed) {
  TestBed bed;
  for (int i = 0; i < 4; ++i) bed.add(TestBed::camera(i, "SAME", i + 1));
  Cameras cameras;
  FakeCamera& closed = cameras.add(at("/dev/video0"));
  closed.fail_open(EACCES, 100);
  FakeCamera& busy = cameras.add(at("/dev/video1"));
  FakeOptions strange = at("/dev/video2");
  strange.fourccs = {V4L2_PIX_FMT_HEVC};
  cameras.add(strange);
  FakeOptions planes = at("/dev/video3");
  planes.is_multi_planar = true;
  cameras.add(planes);
  const auto other = open_camera("/dev/video1", {}, {}, cameras);
  ASSERT_TRUE(other.ok()) << other.error().sentence();
  ASSERT_TRUE(busy.is_streaming());
  EXPECT_EQ((*other)->settings().identity, "pci-0000:00:14.0-usb-0:2:1.0-video-index0")
      << "all have the same serial, so that only the port tells them apart";

  const auto found = list_cameras(cameras, true);
  ASSERT_EQ(found.size(), 4U);
  for (const FoundCamera& camera : found) ASSERT_TRUE(camera.problem.has_value());
  EXPECT_THAT(found[0].problem->sentence(),
              AllOf(HasSubstr("access is not allowed"), HasSubstr("70-alltact.rules")));
  EXPECT_THAT(found[1].problem->sentence(), HasSubstr("another program is using it"));
  EXPECT_THAT(found[2].problem->sentence(), HasSubstr("no supported format"));
  EXPECT_THAT(found[3].problem->sentence(), HasSubstr("in several planes, which is not supported"));
  EXPECT_TRUE(busy.is_streaming()) << "looking does not disturb";
  const auto several = find_camera("SAME", found);
  ASSERT_FALSE(several.ok());
  EXPECT_THAT(
      several.error().what.english(),
      AllOf(HasSubstr("several cameras"), HasSubstr("/dev/video0"), HasSubstr("/dev/video2")));
}

TEST(CameraList, ACameraComesBackAtAnotherNode) {
  TestBed bed;
  bed.add(TestBed::camera(0, "AAAA", 1));
  Cameras cameras;
  FakeCamera& here = cameras.add(at("/dev/video0"));
  FakeCamera& there = cameras.add(at("/dev/video5"));
  there.unplug();
  const auto camera = open_camera("AAAA", {}, {}, cameras);
  ASSERT_TRUE(camera.ok()) << camera.error().sentence();
  ASSERT_TRUE((*camera)->set_control({V4L2_CID_GAIN, "Gain", 33}).ok());
  here.unplug();
  bed.remove(TestBed::camera_path(0, 1));
  ASSERT_TRUE(comes_true([&] { return (*camera)->status().state == CameraState::kGone; }));
  bed.add(TestBed::camera(1, "BBBB", 2));  // another camera is not taken for it
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ((*camera)->status().state, CameraState::kGone);
  there.plug_in();
  bed.add(TestBed::camera(5, "AAAA", 3));
  bed.tell_added(TestBed::camera_path(5, 3));
  ASSERT_TRUE(comes_true([&] { return (*camera)->status().state == CameraState::kStreaming; }));
  EXPECT_EQ(there.control(V4L2_CID_GAIN), 33);
  EXPECT_EQ((*camera)->settings().identity, "usb-Fake_Camera_AAAA-video-index0");
}

TEST(HotPlug, TellsWhatCameAndWhatWent) {
  TestBed bed;
  const auto plug = HotPlug::watch();
  ASSERT_NE(plug, nullptr);
  EXPECT_TRUE(plug->read().empty());
  bed.add(TestBed::camera(0, "AAAA", 1));
  bed.tell_added(TestBed::camera_path(0, 1));
  pollfd wait{plug->descriptor(), POLLIN, 0};
  ASSERT_EQ(poll(&wait, 1, 5000), 1);
  auto news = plug->read();
  ASSERT_FALSE(news.empty());
  EXPECT_TRUE(news.back().is_added);
  EXPECT_EQ(news.back().node, "/dev/video0");
  bed.remove(TestBed::camera_path(0, 1));
  ASSERT_EQ(poll(&wait, 1, 5000), 1);
  news = plug->read();
  ASSERT_FALSE(news.empty());
  EXPECT_FALSE(news.back().is_added);
}

}  // namespace
}  // namespace alltact
