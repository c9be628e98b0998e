// `alltact gripper`: an object that is put between two fingers is told from their recordings.
#include "core/gripper/gripper.h"

#include "core/image/image_file.h"
#include "tests/core/gripper/gripper_files.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

/// Both fingers touch a stick 20 mm wide that leans by 30 degrees, at 4 turns of the motor.
class GripperCommand : public testing::Test {
 protected:
  GripperCommand() {
    write_text(folder_ / "gripper.yaml", kGripper);
    write_results("left", {100, 133, 400}, 0);
    write_results("right", {104, 131, 700}, 1);
  }
  void write_results(const std::string& name, const std::vector<int>& times_ms,
                     std::size_t finger) {
    std::filesystem::create_directory(folder_ / name);
    std::string lines;
    for (std::size_t i = 0; i < times_ms.size(); ++i)
      lines += line(fmt::format("{}_{}", name, i), times_ms[i], finger) + "\n";
    write_text(folder_.path() / name / "results.jsonl", lines);
  }
  [[nodiscard]] static std::string line(const std::string& frame, int time_ms, std::size_t finger) {
    const auto pose = Gripper::parse(kGripper, "gripper.yaml")->pose_at(4.0);
    const RigidTransform camera = pose->fingers[finger].gripper_from_camera.inverse();
    const auto list = [](const Eigen::Vector3d& v) { return Json{v.x(), v.y(), v.z()}; };
    const double side = finger == 0 ? -1 : 1;
    const Json region{{"place_mm", list(camera.point({side * 10, 1, 90}))},
                      {"place_covariance_mm2", {1e-4, 0, 0, 1e-4, 0, 1e-4}},
                      {"angle_sd_deg", 0.5},
                      {"axis", list(camera.direction({0, std::sin(M_PI / 6), std::cos(M_PI / 6)}))},
                      {"normal", list(camera.direction(-side * Eigen::Vector3d::UnitX()))}};
    return Json{{"frame", frame},
                {"time_ns", time_ms * 1000000LL},
                {"regions", {region}},
                {"face", {{"u", {0, 100}}, {"z_sd_mm", {0.01, 0.01}}}}}
        .dump();
  }
  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] std::vector<std::string> recorded(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"gripper",
                                       folder_.path().string(),
                                       "--motor",
                                       "4",
                                       "--results",
                                       file("left/results.jsonl"),
                                       file("right/results.jsonl")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  TemporaryFolder folder_;
};

TEST_F(GripperCommand, TellsBothCamerasForAMotorPosition) {
  const ProgramRun run = run_alltact({"gripper", file("gripper.yaml"), "--motor", "4", "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const Json json = Json::parse(run.output);
  const auto pose = Gripper::parse(kGripper, "gripper.yaml")->pose_at(4.0);
  for (std::size_t i = 0; i < 2; ++i) {
    const RigidTransform& truth = pose->fingers[i].gripper_from_camera;
    const Json& told = json.at("fingers")[i].at("gripper_from_camera");
    EXPECT_NEAR(told.at("translation_mm")[0], truth.translation_mm.x(), 1e-12);
    EXPECT_NEAR(told.at("rotation")[2], truth.rotation.y(), 1e-12);
    EXPECT_GT(json.at("fingers")[i].at("crank_sd_deg"), 0);
  }
  EXPECT_EQ(json.at("motor_sd_turns"), 0.01);
  EXPECT_FALSE(json.contains("pairs"));
  EXPECT_THAT(run_alltact({"gripper", file("gripper.yaml")}).output,
              HasSubstr("rod and crank are stretched into one line"));
}

TEST_F(GripperCommand, TellsWidthAndTurnOfWhatIsHeldAndWhatHasNoPartner) {
  const ProgramRun run = run_alltact(recorded({"--json"}));
  ASSERT_EQ(run.status, 0) << run.errors;
  const Json json = Json::parse(run.output);
  ASSERT_EQ(json.at("pairs").size(), 2U);
  const Json& pair = json.at("pairs")[0];
  EXPECT_EQ(pair.at("frames"), Json({"left_0", "right_0"}));
  EXPECT_NEAR(pair.at("later_ms"), 4, 1e-9);
  EXPECT_NEAR(pair.at("width_mm"), 20, 1e-9);
  EXPECT_GT(pair.at("width_sd_mm"), 0.014) << "both places err by 0.01 mm, and the motor";
  // It leans from z by 30 degrees towards y; up is -z, and a stick has no direction.
  EXPECT_NEAR(pair.at("turn_deg"), 30, 1e-6);
  EXPECT_NEAR(pair.at("turn_sd_deg"), 0.5 / std::sqrt(2.0), 0.01);
  EXPECT_EQ(pair.at("agree"), true);
  EXPECT_FALSE(pair.contains("gap_mm")) << "no points were kept";
  EXPECT_EQ(json.at("unpaired").at("left"), Json({"left_2"}));
  EXPECT_THAT(run.errors, HasSubstr("Without a frame of the same time: 1 frames of left: left_2"));
  const ProgramRun sideways = run_alltact(recorded({"--json", "--up", "0", "1", "0"}));
  EXPECT_NEAR(Json::parse(sideways.output).at("pairs")[0].at("turn_deg"), -60, 1e-6);
}

TEST_F(GripperCommand, TellsTheGapWhereTheFacesWereKept) {
  const auto pose = Gripper::parse(kGripper, "gripper.yaml")->pose_at(4.0);
  for (std::size_t finger = 0; finger < 2; ++finger) {
    const RigidTransform camera = pose->fingers[finger].gripper_from_camera.inverse();
    cv::Mat points(60, 60, CV_32FC3);
    for (int v = 0; v < 60; ++v)
      for (int u = 0; u < 60; ++u) {
        const double y = 0.2 * (u - 30), z = 0.2 * (v - 30), side = finger == 0 ? -1 : 1;
        const Eigen::Vector3d p = camera.point({side * (7 + (y * y + z * z) / 60), y, 90 + z});
        points.at<cv::Vec3f>(v, u) = {static_cast<float>(p.x()), static_cast<float>(p.y()),
                                      static_cast<float>(p.z())};
      }
    const std::string name = finger == 0 ? "left" : "right";
    ASSERT_TRUE(write_image(folder_.path() / name / (name + "_0.points.tiff"), points));
  }
  const ProgramRun run = run_alltact(recorded({"--json"}));
  ASSERT_EQ(run.status, 0) << run.errors;
  const Json json = Json::parse(run.output);
  EXPECT_NEAR(json.at("pairs")[0].at("gap_mm"), 14, 1e-3);
  EXPECT_GT(json.at("pairs")[0].at("gap_sd_mm"), 0);
  EXPECT_FALSE(json.at("pairs")[1].contains("gap_mm"));
  EXPECT_THAT(run_alltact(recorded({})).output, HasSubstr("; gap 14.000 +- "));
}

TEST_F(GripperCommand, WhatCannotBeIsASentence) {
  const auto errors = [](const std::vector<std::string>& arguments) {
    const ProgramRun run = run_alltact(arguments);
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    return run.errors;
  };
  EXPECT_THAT(errors({"gripper", file("none")}), HasSubstr("none"));
  EXPECT_THAT(errors({"gripper", file("gripper.yaml"), "--motor", "11"}),
              HasSubstr("the motor cannot stand at 11 turns: its range is from 0 to 10"));
  EXPECT_THAT(errors(recorded({"--up", "1", "0", "0"})), HasSubstr("lies along x"));
  write_text(folder_.path() / "left" / "results.jsonl", "{\"frame\": 3}\n");
  EXPECT_THAT(errors(recorded({})), HasSubstr("results.jsonl:1: 'frame' must be text"));
  EXPECT_EQ(run_alltact({"gripper", file("gripper.yaml"), "--motor-sd", "1"}).status, 2);
  EXPECT_EQ(run_alltact({"gripper"}).status, 2);
}

TEST_F(GripperCommand, TheMotorsLogSaysWhereEachPairWasTaken) {
  // The motor goes through 4 turns half-way between the first two frames, by 1 turn a second, and
  // is read no more before the second pair.
  write_text(folder_ / "motor.csv", "time_ns,turns\n2000000,3.9\n102000000,4.0\n112000000,4.01\n");
  const ProgramRun run =
      run_alltact({"gripper", file("gripper.yaml"), "--motor-log", file("motor.csv"), "--results",
                   file("left/results.jsonl"), file("right/results.jsonl"), "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const Json pairs = Json::parse(run.output).at("pairs");
  EXPECT_NEAR(pairs[0].at("motor_turns"), 4.0, 1e-9);
  EXPECT_NEAR(pairs[0].at("width_mm"), 20, 1e-6);
  EXPECT_THAT(std::string(pairs[1].at("problem")), HasSubstr("log does not reach"));
  EXPECT_EQ(run_alltact({"gripper", file("gripper.yaml"), "--motor-log", file("motor.csv")}).status,
            2);
  write_text(folder_ / "late.csv", "t_s;Winkel [deg]\n2,5;0\n3,5;90\n");
  const ProgramRun late =
      run_alltact({"gripper", file("gripper.yaml"), "--motor-log", file("late.csv"), "--results",
                   file("left/results.jsonl"), file("right/results.jsonl")});
  EXPECT_EQ(late.status, 1);
  EXPECT_THAT(late.errors, HasSubstr("the motor's log runs from 2.5 to 3.5 s, the frames from"));
  EXPECT_THAT(late.output, HasSubstr("turns from 'Winkel [deg]' in deg"));
  EXPECT_EQ(run_alltact(recorded({"--motor-log", file("motor.csv")})).status, 2);
}

TEST_F(GripperCommand, RecordingsOfOtherTimesHaveNoPairs) {
  write_results("right", {5000, 6000}, 1);
  const ProgramRun run = run_alltact(recorded({}));
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("no frame of one finger has a partner of the other"));
}

}  // namespace
}  // namespace alltact::test
