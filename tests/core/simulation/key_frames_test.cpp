// Numbers that go from key frame to key frame.
#include "core/simulation/scene_time.h"
#include "tests/core/simulation/scene_text.h"

#include <numbers>
#include <random>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

Result<Varying> read_varying(const std::string& value,
                             const std::string& top = "frames: 300\nframes_per_s: 30\n",
                             Limits limits = {-1000, 1000}) {
  YamlFile file("test.yaml", YamlFile::Unknown::kRefused);
  Varying varying;
  const Status status = file.read(top + "ball:\n  x_mm: " + value + "\n", [&](YamlSection& scene) {
    SceneTime::of(scene);
    YamlSection section = scene.section("ball");
    varying = Varying::read(section, "x_mm", limits);
  });
  if (!status) return status.error();
  return varying;
}

TEST(KeyFrames, GoStraightOrSoftlyAsComputedByHand) {
  const Varying straight = read_varying("[{at: 0 s, is: 40}, {at: 2 s, is: 74}]").value();
  EXPECT_EQ(straight.at(1, 0), 40.0);
  EXPECT_DOUBLE_EQ(straight.at(1, 15), 48.5);  // a quarter of 34 above 40
  EXPECT_DOUBLE_EQ(straight.at(1, 30), 57.0);
  EXPECT_EQ(straight.at(1, 60), 74.0);
  EXPECT_EQ(straight.at(1, 299), 74.0);

  const Varying smooth = read_varying("[{at: 0 s, is: 40}, {at: 2 s, is: 74, by: smooth}]").value();
  // (1 - cos(45 degrees)) / 2 = (2 - sqrt 2) / 4 of the way, then half, then the rest of it.
  EXPECT_NEAR(smooth.at(1, 15), 40 + 34 * (2 - std::numbers::sqrt2) / 4, 1e-13);
  EXPECT_NEAR(smooth.at(1, 30), 57.0, 1e-13);
  EXPECT_NEAR(smooth.at(1, 45), 40 + 34 * (2 + std::numbers::sqrt2) / 4, 1e-13);
  EXPECT_EQ(smooth.at(1, 60), 74.0);
  EXPECT_EQ(smooth.min_value(), 40.0);
  EXPECT_EQ(smooth.max_value(), 74.0);
}

TEST(KeyFrames, EachSaysHowItIsReachedAndTheEndsStay) {
  const Varying varying =
      read_varying(
          "[{at: 10, is: 1}, {at: 20, is: 5, by: smooth}, {at: 1 s, is: -3, by: straight}]")
          .value();
  EXPECT_EQ(varying.at(1, 0), 1.0);
  EXPECT_EQ(varying.at(1, 10), 1.0);
  EXPECT_NEAR(varying.at(1, 12), 1 + 2 * (1 - std::cos(0.2 * std::numbers::pi)), 1e-14);
  EXPECT_EQ(varying.at(1, 20), 5.0);
  EXPECT_NEAR(varying.at(1, 25), 1.0, 1e-14);
  EXPECT_EQ(varying.at(1, 30), -3.0);
  EXPECT_EQ(varying.at(1, 299), -3.0);
  // Played without end, they come again.
  EXPECT_EQ(varying.at(1, 300), 1.0);
  EXPECT_EQ(varying.at(9, 312), varying.at(1, 12));
}

TEST(KeyFrames, SecondsAreTheScenesOwn) {
  const std::string keys = "[{at: 0.25 s, is: 0}, {at: 1.5s, is: 100}]";
  const Varying slow = read_varying(keys, "frames: 40\nframes_per_s: 8\n").value();
  EXPECT_EQ(slow.at(1, 2), 0.0);
  EXPECT_EQ(slow.at(1, 7), 50.0);
  EXPECT_EQ(slow.at(1, 12), 100.0);
  // Times that lie between frames, in a scene of 30 a second unless said.
  const Varying between =
      read_varying("[{at: 0.05 s, is: 0}, {at: 2.5, is: 1}]", "frames: 9\n").value();
  EXPECT_EQ(between.at(1, 1), 0.0);
  EXPECT_NEAR(between.at(1, 2), 0.5, 1e-14);
  EXPECT_EQ(between.at(1, 3), 1.0);
}

TEST(KeyFrames, OneAloneIsAConstant) {
  const Varying one = read_varying("[{at: 5, is: 3}]").value();
  for (const int frame : {0, 5, 100}) EXPECT_EQ(one.at(1, frame), 3.0);
}

TEST(KeyFrames, WrongOnesAreRefusedWithFileLineAndKey) {
  const auto problem = [](const std::string& value) {
    const auto read = read_varying(value, "frames: 300\n", strength_up_to(50));
    return read ? "" : read.error().sentence();
  };
  const std::string list = "\n    - {at: 1 s, is: 1}\n    - ";
  ASSERT_EQ(problem(list + "{at: 2 s, is: 1, by: smooth}"), "");
  EXPECT_THAT(problem(list + "{at: 20, is: 1}"),
              HasSubstr("test.yaml:5: ball.x_mm[1].at: the key frame before it has a later time. "
                        "Try: key frames in order of time"));
  EXPECT_THAT(problem(list + "{at: 30, is: 1}"),
              HasSubstr("test.yaml:5: ball.x_mm[1].at: the key frame before it has the same time"));
  EXPECT_THAT(problem(list + "{at: 2 s}"),
              HasSubstr("test.yaml:5: ball.x_mm[1].is: is missing. Try: add 'is: ...'"));
  EXPECT_THAT(problem(list + "{is: 2}"), HasSubstr("ball.x_mm[1].at: is missing"));
  EXPECT_THAT(problem(list + "{at: 2 s, is: 0}"), HasSubstr("leave out what is absent"));
  EXPECT_THAT(problem(list + "{at: 2 s, is: 51}"), HasSubstr("ball.x_mm[1].is: must be"));
  EXPECT_THAT(problem(list + "{at: 2 s, is: 1, by: smoth}"),
              HasSubstr("ball.x_mm[1].by: 'smoth' is not known here. Try: 'smooth'"));
  EXPECT_THAT(problem(list + "{at: 2 s, is: 1, via: smooth}"), HasSubstr("unknown key 'via'"));
  EXPECT_THAT(problem(list + "3"), HasSubstr("test.yaml:5: ball.x_mm[1]: must be a block"));
  EXPECT_THAT(problem("[3, {at: 2 s, is: 1}]"), HasSubstr("ball.x_mm: holds a block of keys"));
  for (const char* wrong : {"pancake", ".nan", ".inf", "[[]]", "1e999", "", "-1", "2 minutes"}) {
    EXPECT_THAT(problem(list + fmt::format("{{at: {}, is: 1}}", wrong)),
                HasSubstr("test.yaml:5: ball.x_mm[1].at: must be"))
        << wrong;
    EXPECT_NE(problem(list + fmt::format("{{at: 2 s, is: {}}}", wrong)), "") << wrong;
  }
}

// Any key frames: reached exactly, never beyond their neighbours, and always on the way there.
TEST(KeyFrames, StayBetweenTheirNeighboursForAnyNumbers) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-20, 20);
  std::uniform_int_distribution<int> step(1, 25), kind(0, 1);
  for (int run = 0; run < 200; ++run) {
    struct Key {
      int at;
      double is;
    };
    std::vector<Key> keys;
    std::vector<std::string> reported;
    for (int at = step(random); at < 290 && keys.size() < 12; at += step(random)) {
      keys.push_back({at, value(random)});
      reported.push_back(
          fmt::format("{{at: {}, is: {}{}}}",
                      kind(random) == 0 ? fmt::format("{}", at) : fmt::format("{} s", at / 30.0),
                      keys.back().is, kind(random) == 0 ? "" : ", by: smooth"));
    }
    const Varying varying = read_varying(fmt::format("[{}]", fmt::join(reported, ", "))).value();
    for (std::size_t i = 0; i < keys.size(); ++i) {
      EXPECT_NEAR(varying.at(1, keys[i].at), keys[i].is, 1e-9);
      if (i == 0) continue;
      const auto [low, high] = std::minmax(keys[i - 1].is, keys[i].is);
      double last = keys[i - 1].is;
      for (int frame = keys[i - 1].at + 1; frame < keys[i].at; ++frame) {
        const double now = varying.at(1, frame);
        EXPECT_GE(now, low - 1e-9);
        EXPECT_LE(now, high + 1e-9);
        EXPECT_GE((now - last) * (keys[i].is - keys[i - 1].is), -1e-9) << "turns back";
        last = now;
      }
    }
  }
}

// A press by key frames is the press by a list of the same numbers, to the byte.
TEST(KeyFrames, PressAsAListOfTheirNumbersDoes) {
  const std::string rest =
      "  - {use: layer, scatter_per_mm: 0.6, along: z}\n"
      "  - {use: leds, lamps: [{at_mm: [0, 3, 0], power: 500000}]}\n  - {use: read, sd: 1}\n";
  const auto text = [&](const std::string& s, const std::string& depth) {
    std::string all =
        scene_text(fmt::format("  - {{use: ball, radius_mm: 4, s_mm: {}, y_mm: 1, depth_mm: {}}}\n",
                               s, depth) +
                   rest);
    return all.replace(all.find("frames: 3"), 9, "frames: 9");
  };
  std::vector<double> s, depth;
  for (int frame = 0; frame < 9; ++frame) {
    s.push_back(30 + (60.0 - 30) * (frame / 8.0));
    const double t = std::min(frame / 4.0, 1.0);
    depth.push_back(0.1 + (1.1 - 0.1) * (0.5 - 0.5 * std::cos(std::numbers::pi * t)));
  }
  depth[4] = depth[5] = depth[6] = depth[7] = depth[8] = 1.1;
  for (const std::uint64_t seed : {2, 77}) {
    const Plan by_list = plan_of(
        text(fmt::format("[{}]", fmt::join(s, ", ")), fmt::format("[{}]", fmt::join(depth, ", "))),
        seed);
    const Plan by_keys = plan_of(text("[{at: 0, is: 30}, {at: 8, is: 60}]",
                                      "[{at: 0, is: 0.1}, {at: 4, is: 1.1, by: smooth}]"),
                                 seed);
    for (int frame = 0; frame < 9; ++frame)
      for (const int threads : {1, 4})
        EXPECT_TRUE(same_bytes(by_keys.render(frame, threads), by_list.render(frame))) << frame;
  }
}

}  // namespace
}  // namespace alltact
