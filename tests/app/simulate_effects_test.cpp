// What effects there are, as `alltact simulate --effects` tells it.
#include "core/simulation/effect.h"
#include "tests/support/program.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact::test {
namespace {

using testing::HasSubstr;

TEST(SimulateEffects, ListsEveryKindThereIs) {
  const ProgramRun run = run_alltact({"simulate", "--effects", "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  std::set<std::string> listed, all;
  const auto answer = nlohmann::json::parse(run.output);
  for (const auto& effect : answer.at("effects")) {
    listed.insert(effect.at("name").get<std::string>());
    EXPECT_FALSE(effect.at("what").get<std::string>().empty());
  }
  for (const EffectKind* kind : effect_kinds()) all.insert(kind->name);
  EXPECT_EQ(listed, all);
}

TEST(SimulateEffects, TellsWhatOneTakesWithAnExampleToCopy) {
  const ProgramRun run = run_alltact({"simulate", "--effects", "ball"});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("ball (geometry): A ball is pressed into the face.\n"));
  EXPECT_THAT(run.output, HasSubstr("Can be used several times"));
  EXPECT_THAT(run.output, testing::ContainsRegex("  radius_mm +a number above 0 and up to 100\n"));
  EXPECT_THAT(run.output, testing::ContainsRegex("  give_mm .*; optional\n"));
  EXPECT_THAT(run.output, HasSubstr("  - {use: ball, radius_mm: 4,"));
}

TEST(SimulateEffects, RefusesWhatThereIsNot) {
  const ProgramRun run = run_alltact({"simulate", "--effects", "bal"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("there is no effect 'bal'"));
  EXPECT_THAT(run.errors, HasSubstr("'ball'"));
  EXPECT_EQ(run_alltact({"simulate", "--effects", "--costs"}).status, 2);
  EXPECT_EQ(run_alltact({"simulate", "scene.yaml", "--effects"}).status, 2);
}

}  // namespace
}  // namespace alltact::test
