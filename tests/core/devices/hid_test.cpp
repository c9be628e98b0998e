#include "core/devices/hid_button.h"
#include "core/devices/led_dimmer.h"

#include <chrono>
#include <condition_variable>
#include <deque>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace std::chrono_literals;
using Report = std::vector<std::uint8_t>;
using testing::ElementsAre;
using testing::HasSubstr;

/// A device that says what it is told to, and remembers what it is sent.
class FakeHid {
 public:
  void say(const Report& report) {
    const std::lock_guard lock(mutex_);
    said_.push_back(report);
    changed_.notify_all();
  }
  void unplug(bool is_gone) {
    const std::lock_guard lock(mutex_);
    is_gone_ = is_gone;
    changed_.notify_all();
  }
  std::vector<Report> sent, features;
  std::function<Report(const Report&)> answer;

  Result<std::unique_ptr<HidPort>> open() {
    const std::lock_guard lock(mutex_);
    if (is_gone_)
      return Error{en::say("there is no such HID device"), std::string("fake"),
                   en::say("plug it in")};
    return std::unique_ptr<HidPort>(std::make_unique<Port>(*this));
  }

 private:
  class Port : public HidPort {
   public:
    explicit Port(FakeHid& device) : device_(device) {}
    Result<Report> read(int timeout_ms) override {
      std::unique_lock lock(device_.mutex_);
      device_.changed_.wait_for(lock, std::chrono::milliseconds(timeout_ms),
                                [&] { return device_.is_gone_ || !device_.said_.empty(); });
      if (device_.is_gone_)
        return Error{en::say("the device was unplugged"), std::string("fake"),
                     en::say("plug it in again")};
      if (device_.said_.empty()) return Report();
      Report report = device_.said_.front();
      device_.said_.pop_front();
      return report;
    }
    Status write(std::span<const std::uint8_t> report) override {
      device_.sent.emplace_back(report.begin(), report.end());
      if (device_.answer) device_.say(device_.answer(device_.sent.back()));
      return {};
    }
    Status send_feature(std::span<const std::uint8_t> report) override {
      device_.features.emplace_back(report.begin(), report.end());
      return {};
    }

   private:
    FakeHid& device_;
  };

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Report> said_;
  bool is_gone_ = false;
};

std::string learnt(const std::vector<Report>& rest, const std::vector<Report>& presses) {
  ButtonLearner learner;
  for (const Report& report : rest) learner.feed(report);
  learner.begin();
  for (const Report& report : presses) learner.feed(report);
  return learner.pattern() ? learner.pattern()->text() : "nothing";
}

TEST(ButtonLearner, APedalThatSendsAKeyIsLearntFromTwoPresses) {
  const Report down = {0, 0, 5, 0, 0, 0, 0, 0}, up(8, 0);
  EXPECT_EQ(learnt({}, {down, up, down, up}), "8 2:05=05");
  EXPECT_EQ(learnt({}, {down, down, down, up, down, down, up}), "8 2:05=05") << "keys repeat";
  EXPECT_EQ(learnt({}, {down, up}), "nothing") << "once may be chance";
}

TEST(ButtonLearner, BytesThatMoveAtRestAreLeftOut) {
  // A device that always talks: a counter, a trembling axis, buttons in the third byte.
  auto report = [count = std::uint8_t{0}](bool is_down) mutable {
    ++count;
    return Report{count, static_cast<std::uint8_t>(0x80 + count % 3),
                  static_cast<std::uint8_t>(is_down ? 0x12 : 0x10)};
  };
  std::vector<Report> rest, presses;
  for (int i = 0; i < 255; ++i) rest.push_back(report(false));
  for (int i = 0; i < 60; ++i) presses.push_back(report(i / 10 % 2 == 1));
  EXPECT_EQ(learnt(rest, presses), "3 2:02=02");
}

TEST(ButtonLearner, OfAButtonWithAHintOfChanceOnlyTheLastingBitsCount) {
  const Report up = {1, 0, 0};
  EXPECT_EQ(learnt({up}, {{1, 4, 9}, up, {1, 4, 6}, up}), "3 1:04=04");
}

TEST(ButtonPattern, TextSaysAllAndNonsenseIsRefused) {
  const ButtonPattern pattern{8, {{2, 0xFF, 0x05}, {7, 0x01, 0x00}}};
  EXPECT_EQ(pattern.text(), "8 2:ff=05,7:01=00");
  EXPECT_EQ(*ButtonPattern::parse(pattern.text()), pattern);
  for (const char* nonsense : {"", "8", "8 ", "8 2:ff", "8 2:ff=05,", "8 8:ff=05", "8 2:00=00",
                               "8 2:01=02", "8 2:fff=05", "x 2:ff=05", "8 2:ff=05 3:ff=01"})
    EXPECT_FALSE(ButtonPattern::parse(nonsense).ok()) << nonsense;
}

TEST(LearntButton, ReadsWhatItWrites) {
  for (const char* text : {"0c45:7403/0 4 2:05=05", "0c45:7403:my serial 8 2:ff=05,3:01=01",
                           "/dev/hidraw3 1 0:01=01"}) {
    const auto button = LearntButton::parse(text);
    ASSERT_TRUE(button.ok()) << text;
    EXPECT_EQ(button->text(), text);
  }
  EXPECT_EQ(LearntButton::parse("0c45:7403:my serial 8 2:ff=05")->device, "0c45:7403:my serial");
  for (const char* nonsense :
       {"", " ", "0c45:7403", "4 2:05=05", " 4 2:05=05", "x 4 2:05", "x y z"})
    EXPECT_FALSE(LearntButton::parse(nonsense).ok()) << nonsense;
}

TEST(LearnButton, FindsTheDeviceThatWasPressed) {
  FakeHid mouse, pedal;
  const auto mouse_port = mouse.open(), pedal_port = pedal.open();
  mouse.say({0, 1, 1});
  mouse.say({0, 2, 1});
  std::string asked;
  const Job job([&](double, const Message& what) {
    if (asked.empty()) {
      for (int i = 0; i < 2; ++i) {
        pedal.say({1, 0x10});
        pedal.say({1, 0x00});
      }
    }
    asked = what.english();
  });
  const auto found = learn_button({mouse_port->get(), pedal_port->get()}, 3000, job);
  ASSERT_TRUE(found.ok()) << found.error().sentence();
  EXPECT_EQ(found->first, 1U);
  EXPECT_EQ(found->second.text(), "2 1:10=10");
  EXPECT_THAT(asked, HasSubstr("press it"));
}

TEST(LearnButton, SaysThatNothingCame) {
  FakeHid pedal;
  const auto port = pedal.open();
  const auto found = learn_button({port->get()}, 100, Job());
  ASSERT_FALSE(found.ok());
  EXPECT_THAT(found.error().what.english(), HasSubstr("no button was pressed"));
  Job stopped;
  stopped.request_stop();
  EXPECT_THAT(learn_button({port->get()}, 1000, stopped).error().what.english(),
              HasSubstr("stopped"));
}

template <class Condition>
bool comes_true(const Condition& condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(5ms);
  return condition();
}

TEST(HidButton, CallsOnceAPressAndComesBackAfterPluggingIn) {
  FakeHid pedal;
  std::atomic<int> presses{0};
  const HidButton button([&] { return pedal.open(); }, *ButtonPattern::parse("2 1:10=10"),
                         [&] { ++presses; });
  const auto press = [&] {
    pedal.say({1, 0x10});
    pedal.say({1, 0x10});
    pedal.say({7, 0x10, 0, 0});  // another kind of report in between
    pedal.say({1, 0x11});
    pedal.say({1, 0x00});
  };
  press();
  press();
  EXPECT_TRUE(comes_true([&] { return presses == 2; }));
  EXPECT_TRUE(button.status().ok());
  pedal.unplug(true);
  EXPECT_TRUE(comes_true([&] { return !button.status().ok(); }));
  EXPECT_FALSE(button.status().error().sentence().empty());
  pedal.unplug(false);
  EXPECT_TRUE(comes_true([&] { return button.status().ok(); }));
  press();
  EXPECT_TRUE(comes_true([&] { return presses == 3; }));
}

TEST(HidButton, GoesOnWhereOpeningOrAPressThrows) {
  FakeHid pedal;
  std::atomic<int> openings{0}, presses{0};
  const HidButton button(
      [&]() -> Result<std::unique_ptr<HidPort>> {
        if (++openings == 1) throw std::bad_alloc();
        return pedal.open();
      },
      *ButtonPattern::parse("2 1:10=10"),
      [&] {
        if (++presses == 1) throw 7;
      });
  EXPECT_TRUE(comes_true([&] { return openings == 1 && !button.status().ok(); }));
  EXPECT_TRUE(comes_true([&] { return button.status().ok(); })) << "opened again";
  const auto press = [&] {
    pedal.say({1, 0x10});
    pedal.say({1, 0x00});
  };
  press();
  EXPECT_TRUE(comes_true([&] { return presses == 1 && !button.status().ok(); }));
  EXPECT_TRUE(comes_true([&] { return button.status().ok(); }));
  press();
  EXPECT_TRUE(comes_true([&] { return presses == 2; }));
}

TEST(LedDimmer, AnMcp2221aKeepsItsOtherPinsAndTakesItsThirtyTwoSteps) {
  FakeHid chip;
  Report settings(64, 0);
  settings[0] = 0x61;
  settings[7] = 0x14;  // analogue input: 2.048 V reference
  const Report pins = {0x08, 0x12, 0x02, 0x09};
  std::copy(pins.begin(), pins.end(), settings.begin() + 22);
  chip.answer = [&](const Report& command) {
    if (command[1] == 0x61) return settings;
    Report done(64, 0);
    done[0] = command[1];
    return done;
  };
  auto dimmer = LedDimmer::create(chip.open().value(), "04d8:00dd", "mcp2221a gp3");
  ASSERT_TRUE(dimmer.ok()) << dimmer.error().sentence();
  ASSERT_EQ(chip.sent.size(), 2U);
  ASSERT_EQ(chip.sent[1].size(), 65U) << "report id 0 and 64 bytes";
  const Report first(chip.sent[1].begin(), chip.sent[1].begin() + 13);
  EXPECT_THAT(first, ElementsAre(0, 0x60, 0, 0, 0x80, 0, 0x85, 0, 0x80, 0x08, 0x12, 0x02, 0x0B));
  ASSERT_TRUE(dimmer->set(0.5).ok());
  const Report second(chip.sent[2].begin(), chip.sent[2].begin() + 9);
  EXPECT_THAT(second, ElementsAre(0, 0x60, 0, 0, 0x80, 0x80 | 16, 0, 0, 0)) << "pins untouched";
  EXPECT_DOUBLE_EQ(dimmer->setting().level, 16.0 / 31) << "what is stored is what is set";
  EXPECT_EQ(dimmer->setting().control, "mcp2221a gp3");
  ASSERT_TRUE(dimmer->set(1).ok());
  EXPECT_EQ(chip.sent[3][5], 0x80 | 31);
  EXPECT_FALSE(dimmer->set(1.01).ok());
  EXPECT_FALSE(dimmer->set(std::nan("")).ok());

  chip.answer = [](const Report& command) {
    Report refused(64, 0);
    refused[0] = command[1];
    refused[1] = 1;
    return refused;
  };
  EXPECT_THAT(dimmer->set(0).error().what.english(), HasSubstr("did not answer as expected"));
  EXPECT_DOUBLE_EQ(dimmer->setting().level, 1.0);
}

TEST(LedDimmer, ADescribedReportIsSentAsDescribed) {
  FakeHid device;
  auto wide =
      LedDimmer::create(device.open().value(), "1:2", "feature id=3 bytes=5 at=2 range=0..1000");
  ASSERT_TRUE(wide.ok());
  ASSERT_TRUE(wide->set(0.5).ok());
  ASSERT_EQ(device.features.size(), 1U);
  EXPECT_THAT(device.features[0], ElementsAre(3, 0, 0, 0xF4, 0x01, 0));
  auto inverted =
      LedDimmer::create(device.open().value(), "1:2", "output id=0 bytes=2 at=1 range=255..55");
  ASSERT_TRUE(inverted.ok());
  ASSERT_TRUE(inverted->set(0.25).ok());
  EXPECT_THAT(device.sent.back(), ElementsAre(0, 0, 205));
  EXPECT_DOUBLE_EQ(inverted->setting().level, 0.25);
}

TEST(LedDimmer, DescriptionsAreReadBackAndNonsenseIsRefused) {
  const auto report = DimmerReport::parse("feature id=3 bytes=5 at=2 range=0..1000");
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(*DimmerReport::parse(report->text()), *report);
  for (const char* nonsense :
       {"", "mcp2221a", "output id=256", "output bytes=0", "output bytes=2 at=2",
        "output bytes=2 at=1 range=0..256", "output range=5..5", "output range=0..70000 bytes=4",
        "output range=0", "output speed=3"}) {
    FakeHid device;
    EXPECT_FALSE(LedDimmer::create(device.open().value(), "1:2", nonsense).ok()) << nonsense;
  }
}

}  // namespace
}  // namespace alltact
