// What every effect costs, as `alltact simulate --costs` tells it.
#include "core/simulation/effect_catalogue.h"
#include "tests/support/program.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact::test {
namespace {

TEST(SimulateCosts, ListsEveryKindThereIs) {
  const ProgramRun run = run_alltact({"simulate", "--costs", "--frames", "1", "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const auto answer = nlohmann::json::parse(run.output);
  std::set<std::string> listed, all;
  for (const auto& cost : answer.at("costs")) {
    listed.insert(cost.at("effect").get<std::string>());
    EXPECT_TRUE(cost.at("ms_per_megapixel").is_number());
    EXPECT_TRUE(cost.at("stage").is_string());
    EXPECT_TRUE(cost.at("example").is_string());
  }
  for (const EffectKind* kind : effect_kinds()) all.insert(kind->name);
  EXPECT_EQ(listed, all);
  EXPECT_EQ(answer.at("costs").size(), all.size());
}

TEST(SimulateCosts, IsATableForPeople) {
  const ProgramRun run = run_alltact({"simulate", "--costs", "--frames", "1"});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.output, testing::HasSubstr("ms per million pixels"));
  EXPECT_THAT(run.output, testing::ContainsRegex("shot +sensor +-?[0-9]+\\.[0-9]+\n"));
}

}  // namespace
}  // namespace alltact::test
