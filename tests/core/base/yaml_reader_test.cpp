// What every YAML file of the program is read with: whatever stands in the file, it is read as it
// was meant, kept, or refused with file, line and key.
#include "core/base/message.h"
#include "core/base/yaml.h"

#include <cmath>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace alltact {
namespace {

using testing::HasSubstr;
using testing::Not;
using Unknown = YamlFile::Unknown;
using Reader = std::function<void(YamlSection&)>;

constexpr Limits kFraction{0, 1, true, false, true};

/// What is said of a file; "read" where nothing is.
std::string reported(const std::string& text, const Reader& reader,
                     Unknown policy = Unknown::kRetained) {
  YamlFile file("a/b.yaml", policy);
  const Status status = file.read(text, reader);
  return status ? "read" : status.error().sentence();
}

void read_nothing(YamlSection&) {}

void read_share(YamlSection& top) { (void)top.number("share", kFraction); }

TEST(YamlReader, TakesBothDecimalMarksAndRefusesThousands) {
  for (const char* text : {"share: 0,25", "share: 0.25", "share: +0.25", "share: ０．２５"}) {
    double share = 0;
    EXPECT_EQ(reported(text, [&](YamlSection& top) { share = top.number("share", kFraction); }),
              "read");
    EXPECT_EQ(share, 0.25) << text;
  }
  const auto any = [](YamlSection& top) { (void)top.number("layer_mm", en::say("in mm")); };
  EXPECT_THAT(reported("layer_mm: 1,500", any),
              HasSubstr("layer_mm: '1,500' can mean 1.5 or 1500: write 1.5 or 1500"));
  EXPECT_THAT(reported("layer_mm: 1.500,5", any), HasSubstr("write 1500.5"));
  EXPECT_EQ(reported("layer_mm: 1.500", any), "read") << "in files the point is the decimal mark";
  const auto count = [](YamlSection& top) { (void)top.integer("count", 0, 5000); };
  EXPECT_THAT(reported("count: 1,500", count), HasSubstr("can mean 1.5 or 1500"));
  // In braces the comma ends the value: 1 and a key '6' would be read.
  EXPECT_THAT(reported("face: {layer_mm: 1,6}",
                       [&](YamlSection& top) {
                         YamlSection face = top.section("face");
                         any(face);
                       }),
              HasSubstr("face.layer_mm: a comma separates entries here, and '6' is none"));
}

TEST(YamlReader, SaysFileLineKeyAndWhatWouldBeRight) {
  EXPECT_EQ(reported("share: 0.5", read_share), "read");
  EXPECT_EQ(reported("# only a remark", read_share),
            "a/b.yaml:1: share: is missing. Try: add 'share: ...'.");
  EXPECT_EQ(reported("\nshare: 2", read_share),
            "a/b.yaml:2: share: must be a number above 0 and up to 1, not '2'.");
  EXPECT_EQ(reported("share: half", read_share),
            "a/b.yaml:1: share: must be a number above 0 and up to 1, not 'half'. Try: a number "
            "such as 24.0, with a point and without a unit.");
  EXPECT_THAT(reported("share: 0", read_share), HasSubstr("leave out what is absent"));
  EXPECT_THAT(reported("share: 1\nshare: 1", read_share),
              HasSubstr("b.yaml:2: share: is given twice"));
  EXPECT_THAT(reported("- 1", read_share), HasSubstr("not a list"));
  EXPECT_THAT(reported("[a, b]: 1", read_share), HasSubstr("not a word"));
  EXPECT_THAT(reported("share: [", read_share), HasSubstr("this is not YAML"));
  EXPECT_THAT(reported("a:\n  b: {c: 1}",
                       [](YamlSection& top) {
                         (void)top.section("a").section("b").number("share", kFraction);
                       }),
              HasSubstr("b.yaml:2: a.b.share: is missing. Try: add 'share: ...' under 'a.b:'"));
  EXPECT_THAT(
      reported("list:\n  - {x: 1}\n  - 2", [](YamlSection& top) { (void)top.sections("list"); }),
      HasSubstr("b.yaml:3: list[1]: must be a block"));
}

TEST(YamlReader, ListsAreOfTheRightLengthAndEveryNumberInItsLimits) {
  const auto size = [](YamlSection& top) { (void)top.numbers("size", 2, 2, {16, 99}); };
  EXPECT_EQ(reported("size: [16, 99]", size), "read");
  EXPECT_THAT(reported("size: [16]", size), HasSubstr("right length. Try: [2 numbers]"));
  EXPECT_THAT(reported("size: [16, 100]", size),
              HasSubstr("holds '100', which is not a number from"));
  EXPECT_THAT(reported("size: 16", size), HasSubstr("must be a list, not '16'"));
  const auto rows = [](YamlSection& top) { (void)top.rows("rows", {0, 1}); };
  EXPECT_EQ(reported("rows: [[], [0, 1]]", rows), "read");
  EXPECT_THAT(reported("rows: [[0], 1]", rows), HasSubstr("holds '1', which is not a list"));
  EXPECT_THAT(reported("rows: [[0, 2]]", rows), HasSubstr("holds '2', which is not a number"));
  const auto count = [](YamlSection& top) { (void)top.integer("count", 1, 8); };
  for (const char* good : {"1", "8", "+3", "4.0"})
    EXPECT_EQ(reported(fmt::format("count: {}", good), count), "read") << good;
  for (const char* bad : {"0", "9", "2.5", "'3'", "1e99", "0x4", "3 mm", ".nan", "[3]", "~"})
    EXPECT_THAT(reported(fmt::format("count: {}", bad), count), HasSubstr("integer from 1 to 8"))
        << bad;
}

TEST(YamlReader, UnknownKeysAreKeptOrRefused) {
  const std::string text = "share: 1\nlater: {a: [1, ~]}\nsub: {weather: dry, place: 1}\n";
  const auto reader = [](YamlSection& top) {
    read_share(top);
    (void)top.section("sub").text("place");
  };
  EXPECT_EQ(reported(text, reader, Unknown::kRefused),
            "a/b.yaml:2: later: unknown key 'later'. Try: one of share, sub.");
  YamlFile file("b.yaml");
  ASSERT_TRUE(file.read(text, reader));
  ASSERT_EQ(file.warnings().size(), 2U);
  EXPECT_THAT(file.warnings()[0].english(), HasSubstr("b.yaml:2: later: is not known here"));
  EXPECT_THAT(file.warnings()[1].english(), HasSubstr("b.yaml:3: sub.weather: is not known here"));
  YamlBlock top(""), sub("sub");
  top.add_unknown(file.unknown()), sub.add_unknown(file.unknown());
  EXPECT_EQ(top.on_many_lines() + "sub: " + sub.in_braces(),
            "later: {a: [1, ~]}\nsub: {weather: dry}");
}

TEST(YamlReader, NamesTheNearestKeyAndWord) {
  const auto reader = [](YamlSection& top) {
    if (top.has("layer_mm")) (void)top.number("layer_mm", kAnyNumber);
    if (top.has("fy")) (void)top.number("fx", kAnyNumber);
    if (top.has("kind")) (void)top.choice("kind", {"fin_ray", "flat"});
  };
  EXPECT_THAT(reported("layer_nm: 1", reader, Unknown::kRefused),
              HasSubstr("Try: 'layer_mm', or else one of layer_mm, fy, kind"));
  EXPECT_THAT(reported("kind: finray", reader),
              HasSubstr("Try: 'fin_ray', or else one of fin_ray"));
  EXPECT_THAT(reported("kind: round", reader), HasSubstr("known here. Try: one of fin_ray, flat"));
  EXPECT_THAT(reported("fy: 1", reader), HasSubstr("Try: add 'fx: ...'"));  // no slip
  YamlFile file("b.yaml");
  ASSERT_TRUE(file.read("layer_nm: 1", reader));
  EXPECT_THAT(file.warnings()[0].english(), HasSubstr("it stays unchanged. Try: 'layer_mm'"));
  EXPECT_THAT(reported("shaer: 1", read_share), HasSubstr("Try: write 'share' instead of 'shaer'"));
}

TEST(YamlReader, ASlipOfOneLetterIsNamed) {
  const std::vector<std::string> words{"width_mm", "layer_mm", "polarity", "incline_deg",
                                       "effects"};
  EXPECT_TRUE(rc::check("slips", [&] {
    const std::string word = *rc::gen::elementOf(words);
    std::string slip = word;
    const auto at = *rc::gen::inRange<std::size_t>(0, word.size() - 1);
    const char letter = *rc::gen::inRange<char>('a', 'z');
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        slip[at] = letter;
        break;
      case 1:
        slip.erase(at, 1);
        break;
      case 2:
        slip.insert(at, 1, letter);
        break;
      default:
        std::swap(slip[at], slip[at + 1]);
    }
    RC_ASSERT(nearest_word(slip, words) == word);
  }));
  EXPECT_EQ(nearest_word("sparkle", words), "");
  EXPECT_EQ(nearest_word(std::string(100'000, 'w'), words), "");
  EXPECT_EQ(nearest_word("x", {}), "");
}

/// Texts that no sane hand writes; what reads them asks for a list of rows.
std::vector<std::string> hostile_texts() {
  std::string bomb = "rows: [[1]]\nb0: &b0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 9; ++i)
    bomb += fmt::format("b{0}: &b{0} [*b{1}, *b{1}, *b{1}, *b{1}, *b{1}, *b{1}]\n", i, i - 1);
  std::string wide = "row: &row [", rows = "rows: [*row", spread;
  for (int i = 0; i < 3000; ++i) wide += "1, ", rows += ", *row";
  for (int i = 0; i < 300; ++i) spread += fmt::format("k{}: *row\n", i);
  const std::string deep(5000, '['), deep_map(5000, '{');
  return {bomb,
          wide + "1]\n" + rows + "]\n",
          wide + "1]\nrows: [[1]]\n" + spread,
          "rows: " + deep,
          "rows: " + deep + std::string(5000, ']'),
          "other: " + deep_map,
          "rows: &x [*x]",
          "rows: [[1]]\nself: &x {a: *x}",
          "rows: [[1]]\nrows: [[1]]",
          "rows: [[1]]\n---\nrows: [[1]]",
          "rows: [[1]]\n" + std::string("ke\0y: 1\n", 8),
          "rows: [[1" + std::string(1, '\0') + "]]",
          "rows: [[1]]\n" + std::string(300, 'k') + "\x01: 1\n",
          "rows: [[1, 2]\n  , [.nan]]",
          "? {a: 1}\n: 2\n"};
}

TEST(YamlReader, HostileTextsAreRefused) {
  const auto reader = [](YamlSection& top) { (void)top.rows("rows"); };
  for (const Unknown policy : {Unknown::kRetained, Unknown::kRefused})
    for (const std::string& text : hostile_texts())
      EXPECT_THAT(reported(text, reader, policy), HasSubstr("a/b.yaml")) << text.substr(0, 80);
  const auto texts = hostile_texts();
  EXPECT_THAT(reported(texts[0], reader), HasSubstr("too large or too unusual to be stored"));
  EXPECT_THAT(reported(texts[1], reader), HasSubstr("too large to be read"));
  EXPECT_THAT(reported(texts[2], reader), HasSubstr("too large or too unusual to be stored"));
  EXPECT_THAT(reported("\"\\e\": \"\\\x1b\"", reader), Not(HasSubstr("\x1b")));
  const auto within = [](YamlSection& top) {
    (void)top.section("\x1f").number("share", kFraction);
  };
  EXPECT_THAT(reported("\x1f: {b: 1}", within), Not(HasSubstr("\x1f")));
}

TEST(YamlReader, AReaderThatIsRefusedReadsNoFurther) {
  int reached = 0;
  (void)reported("a: x", [&](YamlSection& top) {
    ++reached;
    (void)top.number("a", kAnyNumber);
    ++reached;
  });
  EXPECT_EQ(reached, 1);
  EXPECT_THAT(reported("a: 1", [](YamlSection&) { throw std::runtime_error("no memory"); }),
              HasSubstr("a/b.yaml: no memory"));
}

TEST(YamlReader, NumbersThatWereWrittenAreTheSameAgain) {
  EXPECT_TRUE(rc::check("numbers", [] {
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    double number = 0;
    std::memcpy(&number, &bits, sizeof number);
    RC_PRE(std::isfinite(number));
    double back = std::nan("");
    std::vector<double> list;
    YamlFile file("b.yaml");
    RC_ASSERT(file.read(fmt::format("n: {}\nl: {}\n", yaml_number(number), yaml_numbers({number})),
                        [&](YamlSection& top) {
                          back = top.number("n", kAnyNumber);
                          list = top.numbers("l");
                        })
                  .ok());
    RC_ASSERT(back == number);
    RC_ASSERT(list == std::vector<double>{number});
  }));
}

TEST(YamlReader, ANumberIsReadExactlyWhereItLiesInItsLimits) {
  EXPECT_TRUE(rc::check("limits", [] {
    const auto some = [] { return 0.5 * *rc::gen::inRange(-8, 9); };
    Limits limits{some(), 0, *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
    limits.high = limits.low + 0.5 * *rc::gen::inRange(0, 6);
    limits.zero_is_absence = *rc::gen::arbitrary<bool>();
    const double number = some();
    const bool is_below = number < limits.low || (limits.low_open && number == limits.low);
    const bool is_above = number > limits.high || (limits.high_open && number == limits.high);
    const std::string answer = reported("n: " + yaml_number(number), [&](YamlSection& top) {
      if (top.number("n", limits) != number) top.refuse("n", "", "");
    });
    RC_ASSERT((answer == "read") == (!is_below && !is_above));
  }));
}

TEST(YamlReader, WhatIsKeptIsTheSameWhenItIsReadAgain) {
  const auto kept = [](const std::string& text) {
    YamlFile file("b.yaml");
    EXPECT_TRUE(file.read(text, read_nothing)) << text;
    YamlBlock block("");
    block.add_unknown(file.unknown());
    return block.on_many_lines();
  };
  EXPECT_TRUE(rc::check("kept keys", [&] {
    const auto word = rc::gen::container<std::string>(
        rc::gen::oneOf(rc::gen::inRange<char>(1, 127),
                       rc::gen::elementOf(std::string("\"'\\:#\n\t-?,[]{}&*!~ "))));
    const std::string key = yaml_text("k" + (*word).substr(0, 50));
    const std::string once =
        fmt::format("{}: [{{{}: {}}}, {}, ~]\n", key, yaml_text("a" + (*word).substr(0, 50)),
                    yaml_text_or_number(*word), yaml_number(*rc::gen::inRange(-99, 99) / 8.0));
    RC_ASSERT(kept(once) == once);
  }));
}

TEST(YamlReader, AStrayCommaIsNoDocumentWithoutEnd) {
  for (const char* text : {", ", ",a: 1\n", ",\nname: x\n", "a: 1\n---\nb: 2\n"}) {
    YamlFile file("b.yaml");
    const Status status = file.read(text, read_nothing);
    ASSERT_FALSE(status) << text;
    EXPECT_NE(status.error().sentence().find("b.yaml"), std::string::npos);
  }
}

}  // namespace
}  // namespace alltact
