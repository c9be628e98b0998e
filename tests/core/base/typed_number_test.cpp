// Numbers as people type them, in three languages: what is meant, or a refusal.
#include "core/base/typed_number.h"

#include "tests/support/typed_numbers.h"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

std::string sentence_for(std::string_view text, DecimalMark mark, const std::string& unit = "mm") {
  const auto value = parse_typed_number(text, {mark, unit});
  return value ? fmt::format("taken as {}", *value) : value.error().sentence();
}

TEST(TypedNumber, IsWhatAPersonMeansOrIsRefusedInEveryLanguage) {
  const auto examples = typed_examples();
  EXPECT_GE(examples.size(), 200U);
  int taken = 0, refused = 0;
  for (const TypedExample& example : examples)
    for (const DecimalMark mark : {DecimalMark::kPoint, DecimalMark::kComma}) {
      const auto& meant = mark == DecimalMark::kPoint ? example.with_point : example.with_comma;
      const auto value = parse_typed_number(example.text, {mark, "mm"});
      EXPECT_EQ(value.ok(), meant.has_value())
          << '\'' << example.text << "' " << sentence_for(example.text, mark);
      if (value && meant) {
        EXPECT_EQ(*value, *meant) << example.text;
      } else if (!value) {
        EXPECT_FALSE(value.error().what.empty());
      }
      ++(value ? taken : refused);
    }
  EXPECT_GT(taken, 150);
  EXPECT_GT(refused, 100);
}

TEST(TypedNumber, TheSentenceSaysWhatToWrite) {
  EXPECT_EQ(sentence_for("4,500", DecimalMark::kPoint),
            "'4,500' can mean 4.5 or 4500: write 4.5 or 4500.");
  EXPECT_EQ(sentence_for("1.234,5", DecimalMark::kComma),
            "'1.234,5' contains a thousands separator: write 1234.5.");
  EXPECT_EQ(sentence_for("1'000", DecimalMark::kPoint),
            "'1'000' contains a thousands separator: write 1000.");
  EXPECT_EQ(sentence_for("4.5 cm", DecimalMark::kPoint),
            "'4.5 cm' is in 'cm': give the number in mm.");
  EXPECT_EQ(sentence_for("4.5 cm", DecimalMark::kPoint, ""),
            "'4.5 cm' has 'cm' after the number: remove it.");
  EXPECT_EQ(sentence_for("four", DecimalMark::kPoint), "'four' is not a number.");
  EXPECT_EQ(sentence_for(" ", DecimalMark::kPoint), "a number is missing.");
}

TEST(TypedNumber, WholeNumbersTakeNoMarkThatCouldPartThousands) {
  for (const auto& [text, meant] : {std::pair{"6", "6"}, {"+6", "6"}, {"6.0", "6"}, {"-0", "0"}})
    EXPECT_EQ(*plain_integer(text), meant) << text;
  for (const char* text : {"6.5", "1.000", "1,000", "1 000", "6e3", "six", "", "6.000"})
    EXPECT_FALSE(plain_integer(text).ok()) << text;
  EXPECT_EQ(*plain_integer("18446744073709551615"), "18446744073709551615");
}

TEST(TypedNumber, DoubtIsOfDigitsAndMarksOnly) {
  for (const char* text : {"four", "", "nan", "4.5", "4.5 cm", "finger/1", "1.2.3", "-"})
    EXPECT_FALSE(number_ambiguity(text)) << text;
  for (const char* text : {"4,500", "1.234,5", "1 000", "1'000"})
    EXPECT_TRUE(number_ambiguity(text)) << text;
}

TEST(TypedNumber, EveryNumberThatIsWrittenIsReadAgain) {
  const bool holds = rc::check("read what was written", [] {
    const auto mark = *rc::gen::element(DecimalMark::kPoint, DecimalMark::kComma);
    const double value =
        *rc::gen::inRange(-1'000'000, 1'000'000) * std::pow(10.0, *rc::gen::inRange(-12, 12)) / 7;
    const auto read = parse_typed_number(format_typed_number(value, mark), {mark, {}});
    RC_ASSERT(read.ok());
    RC_ASSERT(*read == value);
  });
  EXPECT_TRUE(holds);
}

TEST(TypedNumber, AMarkIsNeverReadAsNothingAndNoTextAsAnotherNumber) {
  const bool holds = rc::check("the same digits or a refusal", [] {
    const auto text = *rc::gen::container<std::string>(
        rc::gen::oneOf(rc::gen::elementOf(std::string("0123456789")),
                       rc::gen::elementOf(std::string("0123456789.,' -+eE"))));
    const auto mark = *rc::gen::element(DecimalMark::kPoint, DecimalMark::kComma);
    const auto value = parse_typed_number(text, {mark, {}});
    if (!value) return;
    // What the C library makes of the one reading that is left.
    std::string one = text;
    std::replace(one.begin(), one.end(), ',', '.');
    RC_ASSERT(std::count(one.begin(), one.end(), '.') <= 1);
    RC_ASSERT(one.find('\'') == std::string::npos);
    RC_ASSERT(*value == std::strtod(one.c_str(), nullptr));
  });
  EXPECT_TRUE(holds);
}

}  // namespace
}  // namespace alltact::test
