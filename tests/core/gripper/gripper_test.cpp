#include "core/gripper/gripper.h"

#include "core/base/atomic_file.h"
#include "core/finger/finger.h"
#include "tests/core/finger/finger_files.h"
#include "tests/core/gripper/gripper_files.h"
#include "tests/support/temporary_folder.h"

#include <cmath>
#include <cstdio>
#include <random>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::kGripper;
using testing::HasSubstr;

Gripper lab_gripper() {
  auto gripper = Gripper::parse(kGripper, "gripper.yaml");
  EXPECT_TRUE(gripper) << gripper.error().sentence();
  return *gripper;
}

TEST(Gripper, ThePinStaysARodAwayFromTheNutAndACrankFromThePivot) {
  const Gripper gripper = lab_gripper();
  for (double m = 0; m <= 10; m += 0.05) {
    const auto pose = gripper.pose_at(m);
    ASSERT_TRUE(pose) << pose.error().sentence();
    for (std::size_t i = 0; i < 2; ++i) {
      const GripperFinger& finger = gripper.fingers[i];
      const LinkageParameters& p = finger.linkage;
      // The pin as the camera would see it, taken to the gripper.
      const Eigen::Vector3d seen = finger.link_from_camera->inverse().point({0, 0, p.crank_mm});
      const Eigen::Vector3d pin = pose->fingers[i].gripper_from_camera.point(seen);
      const Eigen::Vector3d nut(p.nut_mm.x(), 0, p.nut_mm.y() + 2.0 * m);
      const Eigen::Vector3d pivot(p.pivot_mm.x(), 0, p.pivot_mm.y());
      EXPECT_NEAR((pin - nut).norm(), p.rod_mm, 1e-12);
      EXPECT_NEAR((pin - pivot).norm(), p.crank_mm, 1e-12);
      EXPECT_NEAR(pin.y(), 0, 1e-12);
    }
  }
}

TEST(Gripper, BothSidesOfASymmetricalOneMirrorEachOther) {
  // The right link's camera is the left one's turned by half a turn about z.
  const Gripper gripper = lab_gripper();
  const RigidTransform half_turn{Eigen::Quaterniond(0, 0, 0, 1), {0, 0, 0}};
  for (double m = 0; m <= 10; m += 0.5) {
    const auto pose = gripper.pose_at(m);
    ASSERT_TRUE(pose);
    const RigidTransform left = half_turn * pose->fingers[0].gripper_from_camera,
                         right = pose->fingers[1].gripper_from_camera;
    EXPECT_NEAR((left.translation_mm - right.translation_mm).norm(), 0, 1e-12);
    EXPECT_NEAR(left.rotation.angularDistance(right.rotation), 0, 1e-7);
    EXPECT_NEAR(pose->fingers[0].angle.rad_per_turn, -pose->fingers[1].angle.rad_per_turn, 1e-14);
  }
}

TEST(Gripper, PointsMoveAsTheirRateSaysAndScatterAsTheMotorDoes) {
  const Gripper gripper = lab_gripper();
  const Eigen::Vector3d seen(3, -7, 60);
  std::mt19937 random(5);
  for (double m = 1; m <= 9; m += 1) {
    const auto pose = gripper.pose_at(m);
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->sd_turns, 0.01);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto at = [&](double turns) {
        return gripper.pose_at(turns)->fingers[i].gripper_from_camera.point(seen);
      };
      const Eigen::Vector3d differences = (at(m + 1e-5) - at(m - 1e-5)) / 2e-5;
      const FingerPose& finger = pose->fingers[i];
      EXPECT_NEAR((finger.rate_mm(at(m)) - differences).norm(), 0, 1e-7);
      ASSERT_TRUE(finger.angle_sd_rad);
      EXPECT_NEAR(*finger.angle_sd_rad, 0.01 * std::abs(finger.angle.rad_per_turn), 1e-15);
      double squares = 0;
      constexpr int kRuns = 2000;
      std::normal_distribution<double> motor(m, 0.01);
      for (int run = 0; run < kRuns; ++run) {
        const double turns = motor(random);
        squares += std::pow((at(turns) - at(m)).norm(), 2) / kRuns;
      }
      EXPECT_NEAR(std::sqrt(squares) / (0.01 * finger.rate_mm(at(m)).norm()), 1, 0.06);
    }
  }
}

TEST(Gripper, AMotorPositionOutOfRangeIsASentence) {
  const Gripper gripper = lab_gripper();
  EXPECT_EQ(gripper.pose_at(10.2).error().sentence(),
            "lab gripper: the motor cannot stand at 10.2 turns: its range is from 0 to 10. Try: a "
            "motor position in that range, or correct range_turns.");
  EXPECT_FALSE(gripper.pose_at(-0.1));
  EXPECT_FALSE(gripper.pose_at(std::nan("")));
  EXPECT_FALSE(gripper.pose_at(5, std::nan("")));
  EXPECT_TRUE(gripper.pose_at(10 + 1e-7)) << "a counter's rounding";
}

TEST(Gripper, ARangeBeyondTheLinkagesReachIsRefusedWithWhatItReaches) {
  std::string text = kGripper;
  text.replace(text.find("[0.0, 10.0]"), 11, "[0.0, 60.0]");
  const auto gripper = Gripper::parse(text, "gripper.yaml");
  ASSERT_FALSE(gripper);
  // Stretched where (20 mm)^2 + h^2 = (55 mm)^2 beside pivot and nut, 15 mm above the nut at 0.
  const double end = (15 + std::sqrt(55.0 * 55.0 - 20.0 * 20.0)) / 2;
  EXPECT_EQ(gripper.error().where.english(), "gripper.yaml:5: motor.range_turns");
  EXPECT_THAT(gripper.error().sentence(), HasSubstr("the finger left can reach"));
  EXPECT_THAT(gripper.error().sentence(), HasSubstr(fmt::format("at {:.6g} turns", end)));
  EXPECT_THAT(gripper.error().sentence(), HasSubstr("stretched into one line"));
}

TEST(Gripper, SaysWhereItsFingersStandStill) {
  Gripper gripper = lab_gripper();
  EXPECT_TRUE(gripper.dead_points_in_range(0).empty());
  gripper.motor.first_turns = -15, gripper.motor.last_turns = 30;
  ASSERT_TRUE(gripper.validate()) << gripper.validate().error().sentence();
  // The pin at the nut's height, 20 - 30 mm beside the pivot: h = sqrt(25^2 - 10^2), on one side.
  const auto still = gripper.dead_points_in_range(1);
  ASSERT_EQ(still.size(), 1U);
  EXPECT_EQ(still[0].kind, DeadPointKind::kAcross);
  EXPECT_NEAR(std::abs(still[0].motor_turns * 2 - 15), std::sqrt(25.0 * 25 - 10 * 10), 1e-9);
  EXPECT_NEAR(gripper.pose_at(still[0].motor_turns)->fingers[1].angle.rad_per_turn, 0, 1e-12);
}

TEST(Gripper, AFingersOwnFileCanSayWhereItsCameraWas) {
  const test::TemporaryFolder folder;
  auto finger = Finger::parse(test::kFinRay, "finger.yaml");
  ASSERT_TRUE(finger) << finger.error().sentence();
  std::filesystem::create_directory(folder / "left");
  ASSERT_TRUE(finger->save(folder / "left"));
  std::string text = kGripper;
  const std::string place =
      "link_from_camera: {translation_mm: [5.0, 0.0, 10.0], rotation: [0.0, 0.0, 0.0, 1.0]}";
  text.replace(text.find(place), place.size(), "known_at_turns: 4.0");
  ASSERT_TRUE(write_file_atomically(folder / "gripper.yaml", text));
  const auto gripper = Gripper::load(folder.path());
  ASSERT_TRUE(gripper) << gripper.error().sentence();
  const auto there = gripper->pose_at(4.0);
  const RigidTransform& known = *finger->gripper_from_camera;
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(10, -20, 70)})
    EXPECT_NEAR((there->fingers[0].gripper_from_camera.point(p) - known.point(p)).norm(), 0, 1e-11);
  // Elsewhere it has turned about the pivot's axis, which stays.
  const auto elsewhere = gripper->pose_at(6.0);
  const Eigen::Vector3d pivot_seen = known.inverse().point({-30, 8, 20});
  EXPECT_NEAR(
      (elsewhere->fingers[0].gripper_from_camera.point(pivot_seen) - Eigen::Vector3d(-30, 8, 20))
          .norm(),
      0, 1e-11);
  EXPECT_GT(elsewhere->fingers[0].gripper_from_camera.rotation.angularDistance(known.rotation),
            0.05);
  finger->gripper_from_camera.reset();
  ASSERT_TRUE(finger->save(folder / "left"));
  EXPECT_THAT(Gripper::load(folder.path()).error().sentence(),
              HasSubstr("does not specify the camera's pose in the gripper"));
  std::filesystem::remove_all(folder / "left");
  EXPECT_THAT(Gripper::load(folder.path()).error().sentence(), HasSubstr("finger.yaml"));
}

// ---- the file

TEST(GripperFile, IsNamedWhereItIsMissing) {
  const test::TemporaryFolder folder;
  const auto gripper = Gripper::load(folder / "elsewhere.yaml");
  ASSERT_FALSE(gripper);
  EXPECT_THAT(gripper.error().sentence(), HasSubstr("elsewhere.yaml"));
}

TEST(GripperFile, IsTheSameBytesAfterReadingAndWriting) {
  std::string text = kGripper;
  EXPECT_EQ(*lab_gripper().to_yaml(), text);
  // What this version does not know is kept where it stood, and named.
  text = text.substr(0, text.find("  - name: right")) + "    colour: blue\n" +
         text.substr(text.find("  - name: right")) + "maker: somebody\n";
  std::vector<Message> warnings;
  const auto gripper = Gripper::parse(text, "gripper.yaml", &warnings);
  ASSERT_TRUE(gripper) << gripper.error().sentence();
  EXPECT_EQ(warnings.size(), 2U);
  EXPECT_EQ(*gripper->to_yaml(), text);
}

std::vector<std::string> gripper_lines() {
  std::vector<std::string> lines;
  std::istringstream stream(kGripper);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(GripperFile, EveryLineRemovedOrSpoiledIsNamedOrOptional) {
  const std::vector<std::string> lines = gripper_lines();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t colon = lines[i].find(':');
    std::vector<std::string> variants{""};
    for (const char* value :
         {"purple", "-3", ".nan", ".inf", "", "~", "1e300", "[]", "[1, [2]]", "[.nan, 1.0]",
          "{a: 1}", "\"5\"", "[", "*nowhere", "[1.0, 2.0, 3.0]", "{translation_mm: [0, 0, .nan]}"})
      variants.push_back(fmt::format("{}: {}", lines[i].substr(0, colon), value));
    for (const std::string& variant : variants) {
      if (variant == lines[i] + " ") continue;  // a block as it was
      auto changed = lines;
      changed[i] = variant;
      const auto gripper =
          Gripper::parse(fmt::format("{}\n", fmt::join(changed, "\n")), "gripper.yaml");
      if (gripper) {
        // Whatever was taken is fit to be used; names are any text, a lead may be negative, a play
        // may be left out.
        EXPECT_TRUE(gripper->validate()) << variant;
        EXPECT_TRUE(gripper->pose_at(gripper->motor.first_turns)) << variant;
        const std::string key = lines[i].substr(0, colon);
        EXPECT_TRUE(key.ends_with("name") || key.ends_with("folder") || key.ends_with("lead_mm") ||
                    (key.ends_with("sd_turns") && variant.empty()))
            << lines[i] << " -> " << variant;
        continue;
      }
      const std::string sentence = gripper.error().sentence();
      EXPECT_THAT(sentence, testing::MatchesRegex("gripper.yaml:[0-9]+: .*")) << variant;
      EXPECT_EQ(sentence.find('\n'), std::string::npos);
    }
  }
}

TEST(GripperFile, EveryTruncationIsRefusedOrReadAndNeverACrash) {
  const std::string text = kGripper;
  int read = 0;
  for (std::size_t size = 0; size < text.size(); ++size) {
    const auto gripper = Gripper::parse(text.substr(0, size), "gripper.yaml");
    if (gripper) {
      EXPECT_TRUE(gripper->validate()) << size;
      ++read;
    } else {
      EXPECT_THAT(gripper.error().where.english(), HasSubstr("gripper.yaml")) << size;
      EXPECT_FALSE(gripper.error().what.english().empty());
    }
  }
  EXPECT_EQ(read, 1) << "only that without the last line's end says all";
}

TEST(GripperFile, DamagedBytesNeverCrash) {
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i) {
    std::string text = kGripper;
    for (int k = 0; k < 3; ++k)
      text[random() % text.size()] =
          i % 2 == 0 ? static_cast<char>(random()) : "[]{}:,-#&*!|>'\"%@`\n\t 0x"[random() % 24];
    const auto gripper = Gripper::parse(text, "gripper.yaml");
    if (gripper) {
      EXPECT_TRUE(gripper->validate());
      const auto pose = gripper->pose_at(gripper->motor.last_turns);
      if (!pose) continue;
      for (const FingerPose& finger : pose->fingers)
        EXPECT_TRUE(finger.gripper_from_camera.translation_mm.allFinite());
    }
  }
}

TEST(GripperFile, WhatCannotBeIsRefusedByItsKey) {
  const auto refused = [](auto change) {
    Gripper gripper = lab_gripper();
    change(gripper);
    const Status status = gripper.validate();
    return status ? std::string("accepted") : status.error().where.english();
  };
  EXPECT_EQ(refused([](auto&) {}), "accepted");
  EXPECT_EQ(refused([](auto& g) { g.name.clear(); }), "name");
  EXPECT_EQ(refused([](auto& g) { g.motor.lead_mm = 0; }), "motor.lead_mm");
  EXPECT_EQ(refused([](auto& g) { g.motor.last_turns = g.motor.first_turns; }),
            "motor.range_turns");
  EXPECT_EQ(refused([](auto& g) { g.motor.sd_turns = std::nan(""); }), "motor.sd_turns");
  EXPECT_EQ(refused([](auto& g) { g.fingers[1].name = "left"; }), "fingers[1].name");
  EXPECT_EQ(refused([](auto& g) { g.fingers[0].folder.clear(); }), "fingers[0].folder");
  EXPECT_EQ(refused([](auto& g) { g.fingers[1].linkage.crank_mm = -1; }), "fingers[1].crank_mm");
  EXPECT_EQ(refused([](auto& g) { g.fingers[1].link_from_camera.reset(); }),
            "fingers[1].link_from_camera");
  EXPECT_EQ(refused([](auto& g) { g.fingers[0].known_at_turns = 3; }),
            "fingers[0].link_from_camera");
  EXPECT_EQ(refused([](auto& g) { g.fingers[0].link_from_camera->rotation.w() = 3; }),
            "fingers[0].link_from_camera.rotation");
  EXPECT_EQ(refused([](auto& g) {
              g.fingers[0].link_from_camera.reset();
              g.fingers[0].known_at_turns = 11;
            }),
            "fingers[0].known_at_turns");
  Gripper gripper = lab_gripper();
  gripper.motor.lead_mm = std::nan("");
  const test::TemporaryFolder folder;
  EXPECT_FALSE(gripper.save(folder / "gripper.yaml"));
  EXPECT_FALSE(std::filesystem::exists(folder / "gripper.yaml"));
}

}  // namespace
}  // namespace alltact
