// What an effect takes, as it is told to people, and the tables of the help pages against that.
#include "core/simulation/effect_catalogue.h"

#include <fstream>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(EffectParameters, AreToldOfEveryKind) {
  const auto effects = describe_effects();
  EXPECT_EQ(effects.size(), effect_kinds().size());
  for (const EffectDescription& effect : effects) {
    SCOPED_TRACE(effect.kind->name);
    EXPECT_FALSE(effect.sentence.empty());
    std::set<std::string> keys;
    for (const EffectParameter& parameter : effect.parameters) {
      EXPECT_TRUE(keys.insert(parameter.key).second) << parameter.key;
      EXPECT_GT(parameter.values.size(), 5U) << parameter.key;
      EXPECT_THAT(parameter.values, Not(HasSubstr("'x'"))) << parameter.key;
      EXPECT_THAT(parameter.values, Not(HasSubstr("missing"))) << parameter.key;
      const bool stands = effect.kind->example.find(parameter.key + ":") != std::string_view::npos;
      EXPECT_EQ(parameter.in_example, stands) << parameter.key;
    }
    EXPECT_EQ(effect.parameters.empty(), effect.kind->example.empty());
  }
}

TEST(EffectParameters, AreThoseOfTheReader) {
  const auto of = [](std::string_view name, std::string_view key) {
    for (const EffectDescription& effect : describe_effects())
      for (const EffectParameter& parameter : effect.parameters)
        if (effect.kind->name == name && parameter.key == key) return parameter;
    return EffectParameter{};
  };
  EXPECT_EQ(of("read", "sd").values, "a number above 0 and up to 100");
  EXPECT_EQ(of("layer", "along").values, "one of normal, z");
  EXPECT_FALSE(of("layer", "absorb_per_mm").in_example);
  EXPECT_EQ(of("mjpeg", "quality").values, "an integer from 1 to 100");
  EXPECT_EQ(of("bend", "q1_mm").values, "{from: ..., to: ...}, each a number from -100 to 100");
  EXPECT_EQ(of("scratch", "to_mm").values, "a list, each a number from -1000 to 1000");
  EXPECT_THAT(of("leak", "lux").values, HasSubstr("together with grey_per_lux"));
}

TEST(EffectParameters, TellOfThoseThatMayBeSeveral) {
  for (const EffectDescription& effect : describe_effects()) {
    if (effect.kind->name == "ball") {
      EXPECT_TRUE(effect.is_repeatable);
    }
    if (effect.kind->name == "layer") {
      EXPECT_FALSE(effect.is_repeatable);
    }
  }
}

// The rows of a page's table, without the spaces around a cell.
std::vector<std::vector<std::string>> rows_of(const std::string& page) {
  std::ifstream in(std::string(ALLTACT_SOURCE_DIR "/resources/help/") + page);
  EXPECT_TRUE(in.good()) << page;
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("| ") || line.starts_with("| ---")) continue;
    std::vector<std::string> cells;
    std::istringstream cut(line.substr(1));
    for (std::string cell; std::getline(cut, cell, '|');)
      if (cell.size() > 2) cells.push_back(cell.substr(1, cell.size() - 2));
    rows.push_back(cells);
  }
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}

TEST(EffectTable, HoldsEveryEffectInTheOrderTheyRun) {
  const auto effects = describe_effects();
  for (const char* page : {"effects.md", "effects_de.md", "effects_zh_CN.md"}) {
    SCOPED_TRACE(page);
    const auto rows = rows_of(page);
    ASSERT_EQ(rows.size(), effects.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      ASSERT_EQ(rows[i].size(), 5U) << i;
      EXPECT_EQ(rows[i][0], effects[i].kind->name);
      EXPECT_THAT(rows[i][4], testing::MatchesRegex("[0-9]+([.,][0-9])?"));
    }
  }
  const auto rows = rows_of("effects.md");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][1], to_string(effects[i].kind->stage)) << rows[i][0];
    EXPECT_EQ(rows[i][2], effects[i].sentence.english()) << rows[i][0];
  }
}

}  // namespace
}  // namespace alltact
