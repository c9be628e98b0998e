// `alltact record` with a foot pedal and a dimmer that are made up.
#include "core/image/image_file.h"
#include "core/recording/video_file.h"
#include "tests/rigs/hid_device.h"
#include "tests/support/program.h"

#include <csignal>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <spawn.h>
#include <sys/wait.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::HasSubstr;
using Report = HidDevice::Report;

constexpr const char* kButton = "0c45:7403/0 4 2:05=05";

std::string pedal_entry(int number = 0) {
  return TestBed::hid(number, "0C45", "7403", "FootSwitch");
}

void press(const HidDevice& pedal) {
  pedal.say({1, 0, 5, 0});
  pedal.say({1, 0, 0, 0});
}

/// A simulated finger that goes on without end.
void write_scene(const fs::path& file) {
  write_text(file,
             "name: small\nwhy: to record\nframes: 12\nframes_per_s: 60\nfinger:\n"
             "  camera: {model: orthographic, size: [160, 120], mm_per_px: 0.12, cx: 79.5, "
             "cy: 59.5}\n"
             "  face: {kind: flat, layer_mm: 3.0, plane_z_mm: 30.0}\neffects:\n"
             "  - use: leds\n    lamps: [{at_mm: [0.0, 0.0, 0.0], power: 130000.0}]\n"
             "  - {use: layer, scatter_per_mm: 0.6, along: normal}\n"
             "  - {use: read, sd: 1.0}\n  - {use: quantisation}\n");
}

/// alltact while it runs.
class Running {
 public:
  Running(const fs::path& folder, std::vector<std::string> words)
      : output_(folder / "said"), errors_(folder / "warned") {
    words.insert(words.begin(), ALLTACT_PROGRAM);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&files, 1, output_.c_str(), flags, 0666);
    posix_spawn_file_actions_addopen(&files, 2, errors_.c_str(), flags, 0666);
    EXPECT_EQ(posix_spawn(&child_, arguments[0], &files, nullptr, arguments.data(), environ), 0);
    posix_spawn_file_actions_destroy(&files);
  }
  ~Running() {
    if (child_ > 0) {
      ::kill(child_, SIGKILL);
      ::waitpid(child_, nullptr, 0);
    }
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  [[nodiscard]] std::string reported() const { return text_of(output_); }
  [[nodiscard]] std::string warned() const { return text_of(errors_); }
  /// Waits until it says or warns so.
  [[nodiscard]] bool tells(const std::string& words) const {
    for (int i = 0; i < 1000; ++i) {
      if ((reported() + warned()).find(words) != std::string::npos) return true;
      std::this_thread::sleep_for(10ms);
    }
    ADD_FAILURE() << "not told: " << words << "\n" << reported() << warned();
    return false;
  }
  void interrupt() const { ::kill(child_, SIGINT); }
  /// The exit status.
  int end() {
    int status = 0;
    ::waitpid(std::exchange(child_, 0), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  fs::path output_, errors_;
  pid_t child_ = 0;
};

class RecordByButton : public testing::Test {
 protected:
  RecordByButton() { write_scene(folder_ / "s.yaml"); }

  [[nodiscard]] std::vector<std::string> record(const std::string& output,
                                                const std::string& button = kButton) const {
    return {"record", (folder_ / "s.yaml").string(), "-o", file(output), "--button", button};
  }
  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }

  TestBed bed_;
  TemporaryFolder folder_;
};

TEST_F(RecordByButton, EachPairOfPressesIsARecordingOfItsOwn) {
  bed_.add(pedal_entry());
  const HidDevice pedal(bed_);
  write_text(folder_ / "v-002.mkv", "precious");
  Running run(folder_.path(), record("v.mkv"));
  ASSERT_TRUE(run.tells("Press the button"));
  for (const char* name : {"v-001.mkv", "v-003.mkv"}) {
    press(pedal);
    ASSERT_TRUE(run.tells("Recording " + file(name)));
    std::this_thread::sleep_for(200ms);
    press(pedal);
    ASSERT_TRUE(run.tells("in " + file(name)));
  }
  press(pedal);
  ASSERT_TRUE(run.tells("Recording " + file("v-004.mkv")));
  std::this_thread::sleep_for(200ms);
  run.interrupt();
  EXPECT_EQ(run.end(), 0) << run.warned();
  EXPECT_EQ(text_of(folder_ / "v-002.mkv"), "precious");
  for (const char* name : {"v-001", "v-003", "v-004"}) {
    const auto video = VideoFile::open(folder_ / (std::string(name) + ".mkv"));
    ASSERT_TRUE(video.ok()) << video.error().sentence();
    EXPECT_GT(video->frame_count(), 5U);
    const bool is_last = std::string(name) == "v-004";
    EXPECT_THAT(text_of(folder_ / (std::string(name) + ".frames.csv")),
                HasSubstr(is_last ? "# ended: stopped by hand\n" : "# ended: the button was"));
  }
}

TEST_F(RecordByButton, EachPressIsAPicture) {
  bed_.add(pedal_entry());
  const HidDevice pedal(bed_);
  auto words = record("p.png");
  words.insert(words.end(), {"--frames", "3"});
  Running run(folder_.path(), words);
  ASSERT_TRUE(run.tells("Press the button"));
  for (const char* name : {"p-001.png", "p-002.png", "p-003.png"}) {
    EXPECT_FALSE(fs::exists(folder_ / name));
    press(pedal);
    ASSERT_TRUE(run.tells(file(name)));
    const auto image = read_grey_image(folder_ / name);
    ASSERT_TRUE(image.ok()) << image.error().sentence();
    EXPECT_EQ(image->size(), cv::Size(160, 120));
  }
  EXPECT_EQ(run.end(), 0) << run.warned();
  EXPECT_FALSE(fs::exists(folder_ / "p-004.png"));
}

TEST_F(RecordByButton, WhatLearningTellsIsTakenAsItIs) {
  bed_.add(pedal_entry());
  const HidDevice pedal(bed_);
  std::string button;
  {
    Running learn(folder_.path(), {"devices", "--learn-button"});
    ASSERT_TRUE(learn.tells("press and release it twice"));
    std::this_thread::sleep_for(1s);
    press(pedal);
    press(pedal);
    ASSERT_TRUE(learn.tells("Use it: "));
    EXPECT_EQ(learn.end(), 0);
    const std::string reported = learn.reported();
    const std::size_t begin = reported.find("--button '") + 10;
    button = reported.substr(begin, reported.find('\'', begin) - begin);
  }
  EXPECT_EQ(button, kButton);
  auto words = record("p.png", button);
  words.insert(words.end(), {"--frames", "1"});
  Running run(folder_.path(), words);
  ASSERT_TRUE(run.tells("Press the button"));
  press(pedal);
  EXPECT_EQ(run.end(), 0) << run.warned();
}

TEST_F(RecordByButton, APedalThatIsUnpluggedIsWarnedOfAndWaitedFor) {
  bed_.add(pedal_entry());
  auto pedal = std::make_unique<HidDevice>(bed_);
  Running run(folder_.path(), record("v.mkv"));
  ASSERT_TRUE(run.tells("Press the button"));
  press(*pedal);
  ASSERT_TRUE(run.tells("Recording "));
  pedal->hang_up();
  pedal.reset();
  bed_.remove_hid(0, "0C45", "7403");
  ASSERT_TRUE(run.tells("The button is disconnected. "));
  bed_.add(pedal_entry(1));  // another node, the same device
  pedal = std::make_unique<HidDevice>(bed_, 1);
  ASSERT_TRUE(run.tells("The button is connected again."));
  press(*pedal);
  ASSERT_TRUE(run.tells("in " + file("v-001.mkv")));
  run.interrupt();
  EXPECT_EQ(run.end(), 0) << run.warned();
  EXPECT_THAT(run.warned(), HasSubstr("plug it in"));
}

TEST_F(RecordByButton, WithoutTheDeviceItSaysWhatThereIs) {
  Running none(folder_.path(), record("v.mkv"));
  EXPECT_EQ(none.end(), 1);
  EXPECT_THAT(none.warned(), HasSubstr("0c45:7403/0: no HID device was found. Try: plug it in"));
  EXPECT_FALSE(fs::exists(folder_ / "v-001.mkv"));
}

TEST_F(RecordByButton, TheLightIsSetAndToldWithEveryFrame) {
  bed_.add(TestBed::hid(0, "1209", "0001", "Dimmer"));
  const HidDevice dimmer(bed_);
  Running run(folder_.path(), {"record", file("s.yaml"), "-o", file("v.mkv"), "--frames", "3",
                               "--dimmer", "1209:0001", "--dimmer-control",
                               "output id=2 bytes=3 at=1 range=0..255", "--brightness", "0.2"});
  Report heard;
  for (int i = 0; i < 1000 && heard.empty(); ++i) {
    std::this_thread::sleep_for(10ms);
    heard = dimmer.hear();
  }
  EXPECT_THAT(heard, testing::ElementsAre(2, 0, 51, 0));
  EXPECT_EQ(run.end(), 0) << run.warned();
  auto video = VideoFile::open(folder_ / "v.mkv");
  ASSERT_TRUE(video.ok());
  for (std::size_t i = 0; i < 3; ++i) {
    const FramePtr frame = *video->frame(i);
    ASSERT_NE(frame->controls, nullptr);
    EXPECT_THAT(*frame->controls, HasSubstr("Light=0.2 by 1209:0001 (output id=2 bytes=3"));
  }
}

}  // namespace
}  // namespace alltact::test
