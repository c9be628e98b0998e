#include "core/base/settings.h"

#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

enum class Colour { kRed, kGreen, kBlue };

struct Choices {
  int count = 4;
  double share = 0.5;
  Colour colour = Colour::kGreen;
};

const Setting<Choices> kCount =
    number_setting<Choices>("count", en::say("how many"), &Choices::count, 1, 64);
const Setting<Choices> kShare =
    number_setting<Choices>("share", en::say("how much"), &Choices::share, 0.0, 1.0);
const Setting<Choices> kColour = choice_setting<Choices, Colour>(
    "colour", en::say("of the light"), &Choices::colour,
    {{"red", Colour::kRed}, {"green", Colour::kGreen}, {"blue", Colour::kBlue}});

/// What is said of a value; empty where it is taken.
Message refusal(const Setting<Choices>& setting, std::string_view text) {
  Choices choices;
  const std::string before = setting.get(choices);
  const Status status = setting.set(choices, text);
  if (status) return {};
  EXPECT_EQ(setting.get(choices), before) << "what is refused changes nothing";
  EXPECT_EQ(status.error().where.english(), setting.name);
  return status.error().what;
}

TEST(Setting, SaysItsRangeItsDefaultAndWhatItDoes) {
  EXPECT_EQ(kCount.range.text(), "1 to 64");
  EXPECT_EQ(kCount.default_value(), "4");
  EXPECT_EQ(kColour.range.text(), "red or green or blue");
  EXPECT_EQ(kColour.default_value(), "green");
  EXPECT_EQ(kColour.sentence.english(), "of the light");
  EXPECT_EQ(kColour.sentence.in([](const Message&) { return "des Lichts"; }), "des Lichts");
}

TEST(Setting, TakesWhatIsInItsRangeToTheBorders) {
  for (const char* text : {"1", "64", "33"}) {
    Choices choices;
    ASSERT_TRUE(kCount.set(choices, text)) << text;
    EXPECT_EQ(kCount.get(choices), text);
  }
  for (const char* text : {"0", "1", "0.25", "1e-3"}) EXPECT_TRUE(refusal(kShare, text).empty());
  for (const char* text : {"red", "green", "blue"}) {
    Choices choices;
    ASSERT_TRUE(kColour.set(choices, text)) << text;
    EXPECT_EQ(kColour.get(choices), text);
  }
}

TEST(Setting, TakesNumbersAsPeopleTypeThem) {
  Choices choices;
  for (const char* text : {"4 ", " 4", "+4", "４"}) {
    choices.count = 1;
    ASSERT_TRUE(kCount.set(choices, text)) << text;
    EXPECT_EQ(choices.count, 4);
  }
  ASSERT_TRUE(kShare.set(choices, "0,25"));
  EXPECT_EQ(choices.share, 0.25);
  EXPECT_EQ(refusal(kCount, "1,000").english(), "'1,000' can mean 1 or 1000: write 1 or 1000");
}

TEST(Setting, RefusesEverythingElse) {
  for (const char* text : {"", "0", "65", "-1", "1.5", "0x4", "four", "99999999999999"})
    EXPECT_EQ(refusal(kCount, text).english(),
              fmt::format("'{}' is not a number from 1 to 64", text));
  for (const char* text : {"nan", "inf", "-0.001", "1.001", "1e999"})
    EXPECT_EQ(refusal(kShare, text).english(),
              fmt::format("'{}' is not a number from 0 to 1", text));
  for (const char* text : {"", "Red", "red ", "red or green", "{}"})
    EXPECT_EQ(refusal(kColour, text).english(),
              fmt::format("'{}' is not red or green or blue", text));
}

TEST(Setting, ItsWordsStayInEveryLanguageAndWhatJoinsThemDoesNot) {
  const auto german = [](const Message& message) -> std::string {
    return message.words() == "{} or {}"         ? "{} oder {}"
           : message.words() == "'{}' is not {}" ? "'{}' ist nicht {}"
                                                 : message.words();
  };
  EXPECT_EQ(refusal(kColour, "or").in(german), "'or' ist nicht red oder green oder blue");
}

}  // namespace
}  // namespace alltact
