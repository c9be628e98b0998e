// What the command line says of itself, and its exit statuses.
#include "core/finger/finger.h"
#include "core/sensing/pipeline_settings.h"
#include "tests/support/flat_sensor.h"
#include "tests/support/program.h"
#include "tests/support/slow_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact::test {
namespace {

using testing::HasSubstr;

const std::vector<std::string> kCommands = {
    "new",     "simulate", "lens",        "reference", "calibrate", "reconstruct",
    "merge",   "serve",    "record",      "force",     "check",     "export",
    "gripper", "study",    "experiments", "demo",      "thumbnail", "inspect"};

TEST(Usage, HelpNamesEveryCommand) {
  const ProgramRun run = run_alltact({"--help"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.errors, "");
  for (const std::string& command : kCommands)
    EXPECT_THAT(run.output, HasSubstr("\n  " + command + " "));
}

TEST(Usage, EveryCommandHasHelpAndJson) {
  for (const std::string& command : kCommands) {
    const ProgramRun run = run_alltact({command, "--help"});
    EXPECT_EQ(run.status, 0) << command;
    EXPECT_THAT(run.output, HasSubstr("alltact " + command)) << command;
    EXPECT_THAT(run.output, HasSubstr("--json")) << command;
    EXPECT_EQ(run.errors, "") << command;
  }
}

TEST(Usage, HelpTellsEachSettingWithRangeAndDefault) {
  const ProgramRun run = run_alltact({"reconstruct", "--help"});
  for (const auto& setting : pipeline_settings()) {
    EXPECT_THAT(run.output, HasSubstr("--" + setting.name));
    EXPECT_THAT(run.output, HasSubstr("default " + setting.default_value()));
  }
}

TEST(Usage, WrongUsageIsTwo) {
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"dance"},
      {"--loud"},
      {"check"},
      {"check", "a", "b"},
      {"new", "finger", "--layer-mm", "1.5"},
      {"new", "finger", "--camera", "c.yaml", "--layer-mm", "-1", "--width-mm", "24", "--per-row",
       "6"},
      {"new", "finger", "--camera", "c.yaml", "--layer-mm", "1.5", "--per-row", "6"},
      {"new", "finger", "--camera", "c.yaml", "--layer-mm", "1.5", "--width-mm", "24"},
      {"new", "finger", "--camera", "c.yaml", "--layer-mm", "3", "--kind", "round"},
      {"new", "finger", "--camera", "c.yaml", "--layer-mm", "3", "--kind", "flat", "--per-row",
       "6"},
      {"simulate"},
      {"simulate", "scene.yaml"},
      {"simulate", "scene.yaml", "-o", "x", "--costs"},
      {"simulate", "scene.yaml", "-o", "x", "--frames", "0"},
      {"lens", "boards", "--square-mm", "5", "-o", "c.yaml"},
      {"lens", "boards", "--board", "9", "--square-mm", "5", "-o", "c.yaml"},
      {"lens", "boards", "--board", "9x6", "--square-mm", "0", "-o", "c.yaml"},
      {"lens", "boards", "--board", "9x6", "--square-mm", "5"},
      {"lens", "boards", "--board", "9x6", "--square-mm", "5", "-o", "c.yaml", "--model", "eye"},
      {"lens", "b", "--board", "9x6", "--square-mm", "5", "-o", "c.yaml", "--port", "1,2,0.5,1.4"},
      {"lens", "b", "--board", "9x6", "--square-mm", "5", "-o", "c.yaml", "--port", "1,2"},
      {"lens", "b", "--board", "9x6", "--square-mm", "5", "-o", "c.yaml", "--known-length-mm", "9"},
      {"calibrate", "finger", "press.png"},
      {"calibrate", "finger", "press.png", "--ball-radius-mm", "0"},
      {"reconstruct", "finger", "a.png", "-o", "x", "--format", "glue"},
      {"reconstruct", "finger", "a.png", "-o", "x", "--method", "magic"},
      {"reconstruct", "finger", "a.png", "-o", "x", "--smoothing-px", "99"},
      {"reconstruct", "finger", "a.png", "-o", "x", "--smoothing-px", "much"},
      {"serve", "finger"},
      {"serve", "finger", "scene.yaml", "--schema"},
      {"serve", "finger", "scene.yaml", "--smoothing-px", "99"},
      {"export", "finger", "-o", "x"},
      {"export", "finger", "--to", "carrier-pigeon", "-o", "x"},
  };
  for (const auto& arguments : wrong) {
    const ProgramRun run = run_alltact(arguments);
    EXPECT_EQ(run.status, 2) << testing::PrintToString(arguments);
    EXPECT_NE(run.errors, "") << testing::PrintToString(arguments);
    EXPECT_EQ(run.output, "") << testing::PrintToString(arguments);
  }
}

TEST(Usage, VersionIsTold) {
  const ProgramRun run = run_alltact({"--version"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.output, testing::MatchesRegex("alltact [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(Usage, JsonIsOneObjectAlsoForAFailure) {
  const TemporaryFolder folder;
  write_flat_camera(folder / "camera.yaml");
  const std::vector<std::string> make = {"new",        (folder / "finger").string(),
                                         "--camera",   (folder / "camera.yaml").string(),
                                         "--layer-mm", "3",
                                         "--kind",     "flat",
                                         "--json"};
  const ProgramRun made = run_alltact(make);
  ASSERT_EQ(made.status, 0) << made.errors;
  EXPECT_EQ(nlohmann::json::parse(made.output).at("name"), "finger");
  EXPECT_EQ(made.errors, "");

  const ProgramRun again = run_alltact(make);
  EXPECT_EQ(again.status, 1);
  EXPECT_THAT(again.errors, HasSubstr("there is a finger already"));
  EXPECT_THAT(nlohmann::json::parse(again.output).at("error").get<std::string>(),
              HasSubstr("finger.yaml"));
}

TEST(Usage, ANewFingerMayBeToldWhereItSitsInTheGripper) {
  const TemporaryFolder folder;
  write_flat_camera(folder / "camera.yaml");
  const auto make = [&](std::vector<std::string> place) {
    std::vector<std::string> words{"new",
                                   (folder / "finger").string(),
                                   "--camera",
                                   (folder / "camera.yaml").string(),
                                   "--layer-mm",
                                   "3",
                                   "--kind",
                                   "flat",
                                   "--gripper-from-camera"};
    words.insert(words.end(), place.begin(), place.end());
    return run_alltact(words);
  };
  EXPECT_EQ(make({"-40", "0", "12.5"}).status, 2);
  EXPECT_EQ(make({"-40", "0", "12.5", "0", "-90", "up"}).status, 2);
  EXPECT_EQ(make({"-40000", "0", "12.5", "0", "-90", "0"}).status, 2);
  const ProgramRun made = make({"-40", "0", "12.5", "0", "-90", "0"});
  ASSERT_EQ(made.status, 0) << made.errors;
  const Finger finger = Finger::load(folder / "finger").value();
  ASSERT_TRUE(finger.gripper_from_camera);
  // The camera looks against the gripper's x.
  const Eigen::Vector3d at = finger.gripper_from_camera->point({0, 0, 30});
  EXPECT_LT((at - Eigen::Vector3d(-70, 0, 12.5)).norm(), 1e-12);
}

TEST(Usage, ChecksTheComputersOwnNumbers) {
  if (is_slow_run()) {  // the same once more, in words
    const ProgramRun run = run_alltact({"check", "--numerics"});
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_THAT(run.output, HasSubstr("are within their error bounds on this computer"));
    EXPECT_THAT(run.output, testing::Not(HasSubstr("  NO ")));
  }
  const ProgramRun json = run_alltact({"check", "--numerics", "--json"});
  EXPECT_EQ(json.status, 0);
  const auto answer = nlohmann::json::parse(json.output);
  EXPECT_GT(answer.at("numerics").size(), 30U);
  for (const auto& row : answer.at("numerics")) {
    EXPECT_TRUE(row.at("holds").get<bool>()) << row;
    EXPECT_LE(row.at("our_error").get<double>(), row.at("bound").get<double>()) << row;
  }
  EXPECT_EQ(run_alltact({"check", "finger", "--numerics"}).status, 2);
}

TEST(Usage, ProgressStaysAwayFromFiles) {
  const TemporaryFolder folder;
  const auto presses = write_flat_sensor(folder.path());
  ASSERT_EQ(run_alltact({"new", (folder / "finger").string(), "--camera",
                         (folder / "camera.yaml").string(), "--layer-mm", "3", "--kind", "flat"})
                .status,
            0);
  const ProgramRun run =
      run_alltact({"calibrate", (folder / "finger").string(), presses[0].string(), "--reference",
                   (folder / "ref.png").string(), "--ball-radius-mm", "4"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.errors, testing::Not(HasSubstr("\r")));
  EXPECT_THAT(run.output, testing::Not(HasSubstr("\r")));
  EXPECT_THAT(run.output, testing::Not(HasSubstr("\033")));
}

}  // namespace
}  // namespace alltact::test
