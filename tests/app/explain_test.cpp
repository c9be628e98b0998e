// What `alltact simulate --explain` tells of a scene.
#include "tests/support/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact::test {
namespace {

using testing::HasSubstr;

const std::string kScene = ALLTACT_SOURCE_DIR "/resources/scenes/studio_finger.yaml";

TEST(Explain, TellsWhatIsBuiltWhenAndWhyInTheOrderOfRunning) {
  const ProgramRun run = run_alltact({"simulate", "--explain", kScene});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("150 frames"));
  EXPECT_THAT(run.output, HasSubstr("What the Studio shows where no camera is plugged in"));
  std::size_t last = 0;
  for (const char* line :
       {"bend           frames 0 to 149: ",
        "ball           frames 45 to 149: A ball is pressed into the face\n",
        "read           frames 0 to 149: ", "quantisation   frames 0 to 149: "}) {
    const std::size_t at = run.output.find(line);
    ASSERT_NE(at, std::string::npos) << line;
    EXPECT_GT(at, last) << line;
    last = at;
  }
}

TEST(Explain, GivesTheSameAsJson) {
  const ProgramRun run = run_alltact({"simulate", "--explain", "--json", kScene});
  EXPECT_EQ(run.status, 0) << run.errors;
  const auto answer = nlohmann::json::parse(run.output);
  EXPECT_EQ(answer.at("frames"), 150);
  EXPECT_EQ(answer.at("effects").at(2).at("name"), "ball");
  EXPECT_EQ(answer.at("effects").at(2).at("first"), 45);
  EXPECT_EQ(answer.at("effects").at(2).at("last"), 149);
}

TEST(Explain, NeedsNoFolderAndTakesNone) {
  EXPECT_EQ(run_alltact({"simulate", "--explain", "-o", "x", kScene}).status, 2);
  EXPECT_EQ(run_alltact({"simulate", kScene}).status, 2);
  EXPECT_EQ(run_alltact({"simulate", "--explain", "/nowhere/scene.yaml"}).status, 1);
}

}  // namespace
}  // namespace alltact::test
