// What is said: its English, its other languages, and its way through JSON.
#include "core/base/message.h"

#include "core/base/message_json.h"
#include "core/base/result.h"

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using Json = nlohmann::ordered_json;
using Random = std::mt19937;
using testing::ElementsAre;

int up_to(Random& random, int most) { return std::uniform_int_distribution<int>(0, most)(random); }

/// Braces in every neighbourhood, digits, colons, and letters of more than one byte.
std::string any_text(Random& random) {
  static constexpr std::array<const char*, 10> kPieces{"{", "}", "{}", "{0}", ":",
                                                       "7", " ", "a",  "ü",   "标"};
  std::string text;
  for (int left = up_to(random, 6); left > 0; --left)
    text += kPieces[static_cast<std::size_t>(up_to(random, kPieces.size() - 1))];
  return text;
}

Message number(std::string words) {
  return Message::compose(Message::Kind::kNumber, std::move(words), {}, -1, {});
}

Message any_message(Random& random, int depth) {
  const int kind = up_to(random, depth > 0 ? 3 : 1);
  if (kind == 0) return Message::typed(any_text(random));
  if (kind == 1) return number(fmt::format("{}", up_to(random, 1000) / 8.0));
  std::vector<Message> parts;
  for (int left = up_to(random, 3); left > 0; --left)
    parts.push_back(any_message(random, depth - 1));
  return kind == 2
             ? Message::compose(Message::Kind::kTemplate, any_text(random),
                                up_to(random, 1) == 0 ? "" : any_text(random), -1, std::move(parts))
             : Message::compose(Message::Kind::kCounted, any_text(random), any_text(random),
                                up_to(random, 4) - 1, std::move(parts));
}

/// A template and what it must give, made side by side.
struct Made {
  Message message;
  std::string english;
};

/// Holes all with numbers or all without, some with a way to write numbers, between any text.
Made any_template(Random& random) {
  const bool has_numbers = up_to(random, 1) == 0;
  std::vector<Message> parts;
  for (int left = 1 + up_to(random, 3); left > 0; --left)
    parts.push_back(Message::typed(any_text(random)));
  std::string words, english;
  std::size_t next = 0;
  for (int left = up_to(random, 8); left > 0; --left) {
    if (up_to(random, 1) == 0) {
      for (const char c : any_text(random)) {
        words += c == '{' || c == '}' ? std::string(2, c) : std::string(1, c);
        english += c;
      }
    } else {
      // One more than there are parts: that hole stays empty.
      const std::size_t part =
          has_numbers ? static_cast<std::size_t>(up_to(random, parts.size())) : next++;
      words += "{" + (has_numbers ? std::to_string(part) : "") +
               (up_to(random, 1) == 0 ? ":>8.2f" : "") + "}";
      if (part < parts.size()) english += parts[part].words();
    }
  }
  return {Message::compose(Message::Kind::kTemplate, words, {}, -1, parts), english};
}

TEST(Message, NothingSaidIsEmptyHoweverItIsWritten) {
  EXPECT_TRUE(Message().empty());
  EXPECT_EQ(Message(""), Message());
  EXPECT_EQ(Message::typed(""), Message());
  EXPECT_EQ(Message().english(), "");
  EXPECT_FALSE(en::say("no").empty());
}

TEST(Message, HolesAreFilledInTheirOrderOrByTheirNumbers) {
  EXPECT_EQ(en::say("{} of {}", 3, 7).english(), "3 of 7");
  EXPECT_EQ(en::say("{1} before {0}", std::string("a"), std::string("b")).english(), "b before a");
  EXPECT_EQ(en::say("{0}, {1} and {0} again", 5, 6).english(), "5, 6 and 5 again");
  EXPECT_EQ(en::say("{}{}{}", 1, std::string("-"), 2).english(), "1-2");
  EXPECT_EQ(en::say("in {}", std::filesystem::path("/a/b c")).english(), "in /a/b c");
  EXPECT_EQ(en::say("nothing to fill").english(), "nothing to fill");
}

TEST(Message, EnglishIsWhatFmtMakesOfTheSame) {
  Random random(1);
  std::uniform_real_distribution<double> any(-1e4, 1e4);
  for (int i = 0; i < 500; ++i) {
    const double x = any(random), y = any(random) * 1e-8;
    const int n = up_to(random, 100000) - 50000;
    const std::string name = any_text(random);
    EXPECT_EQ(en::say("{:.2f} mm, {:+d} of {:g} in '{}'", x, n, y, name).english(),
              fmt::format("{:.2f} mm, {:+d} of {:g} in '{}'", x, n, y, name));
    EXPECT_EQ(en::say("{2:>12}|{0:.3g}|{1:05d}|{0:.3g}", y, n, name).english(),
              fmt::format("{2:>12}|{0:.3g}|{1:05d}|{0:.3g}", y, n, name));
    EXPECT_EQ(en::say("{{{}}} {{}} {{{{{:x}", x, i).english(),
              fmt::format("{{{}}} {{}} {{{{{:x}", x, i));
    EXPECT_EQ(en::count("{:4d} of {:.0f} %", "{:4d} of {:.0f} %", n, x).english(),
              fmt::format("{:4d} of {:.0f} %", n, x));
  }
}

TEST(Message, AnyTemplateGivesItsTextAndItsParts) {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const Made made = any_template(random);
    EXPECT_EQ(made.message.english(), made.english) << made.message.words();
    // The same words of another language, and as a part of another message.
    EXPECT_EQ(made.message.in([](const Message& message) { return message.words(); }),
              made.english);
    EXPECT_EQ(en::say("<{}>", made.message).english(), "<" + made.english + ">");
  }
}

TEST(Message, DoubledBracesAreBraces) {
  EXPECT_EQ(en::say("{{}}").english(), "{}");
  EXPECT_EQ(en::say("{{}} {} {{{}}}", 1, 2).english(), "{} 1 {2}");
  EXPECT_EQ(en::say("{{0}} is {0}", 4).english(), "{0} is 4");
  EXPECT_EQ(en::count("{{{}}} holes", "{{{}}} hole", 1).english(), "{1} hole");
}

TEST(Message, HolesThatAnotherLanguageGotWrongHarmNothing) {
  const Message message = en::say("{} of {}", 3, 7);
  const auto reported = [&](std::string words) {
    return message.in([&](const Message&) { return words; });
  };
  EXPECT_EQ(reported("{1} davon {0}"), "7 davon 3");
  EXPECT_EQ(reported("{0} davon"), "3 davon") << "a part that is not told";
  EXPECT_EQ(reported("{} {} {} {2} {9}."), "3 7   .") << "holes without a part";
  EXPECT_EQ(reported("open {"), "open {");
  EXPECT_EQ(reported("open {0"), "open {0");
  EXPECT_EQ(reported("closed } {1}"), "closed } 7");
  EXPECT_EQ(reported(""), "");
}

TEST(Message, NoTemplateEverCrashes) {
  Random random(3);
  constexpr std::string_view kLetters = "{}{}0123456789:-. a";
  for (int i = 0; i < 20000; ++i) {
    std::string words;
    for (int left = up_to(random, 24); left > 0; --left)
      words += kLetters[static_cast<std::size_t>(up_to(random, kLetters.size() - 1))];
    const Message message = Message::compose(Message::Kind::kTemplate, words, {}, -1,
                                             {number("1"), any_message(random, 2)});
    const std::string english = message.english();
    if (words.find_first_of("{}") == std::string::npos) {
      EXPECT_EQ(english, words);
    }
  }
}

TEST(Message, WhatSomebodyTypedIsTheSameInEveryLanguage) {
  const Message::Language loud = [](const Message& message) {
    return message.words() == "no" ? std::string("NEIN") : "<" + message.words() + ">";
  };
  for (const std::string text : {"no", "{}", "{0} {{x}}", "{", "}}", "'{}' is not {}"}) {
    EXPECT_EQ(Message::typed(text).english(), text);
    EXPECT_EQ(Message::typed(text).in(loud), text);
    EXPECT_EQ(en::say("'{}'", text).english(), "'" + text + "'");
    EXPECT_EQ(en::say("'{}'", text).in(loud), "<'" + text + "'>");
    EXPECT_EQ(en::say("in {}", std::filesystem::path(text)).in(loud), "<in " + text + ">");
  }
  EXPECT_EQ(en::say("{} or {}", std::string("no"), en::say("no")).in(loud), "<no or NEIN>");
}

TEST(Message, OnlyWhatWasSaidIsTranslatedAndEachMessageOnce) {
  const Message reason = en::say("{:.1f} mm off", 0.26);
  const Message frames = en::count("{} frames of {}", "{} frame of {}", 2, std::string("left"));
  const Message all = en::say("{}: {}", frames, en::list({reason, Message::typed("as told")}));
  std::vector<std::string> asked;
  const std::string text = all.in([&](const Message& message) {
    asked.push_back(message.words());
    return message.words();
  });
  EXPECT_EQ(text, "2 frames of left: 0.3 mm off, as told");
  EXPECT_THAT(asked, ElementsAre("{}: {}", "{} frames of {}", "{}, {}", "{:.1f} mm off"));
}

TEST(Message, OneThingIsToldFromMany) {
  const auto frames = [](auto n) { return en::count("{} frames", "{} frame", n); };
  EXPECT_EQ(frames(0).english(), "0 frames");
  EXPECT_EQ(frames(1).english(), "1 frame");
  EXPECT_EQ(frames(2).english(), "2 frames");
  EXPECT_EQ(frames(-1).english(), "-1 frames");
  EXPECT_EQ(frames(std::size_t{1}).english(), "1 frame");
  EXPECT_EQ(frames(std::size_t{101}).english(), "101 frames");
  const auto lit = [](int n) {
    return en::count("of {1}, {0} are lit", "of {1}, {0} is lit", n, std::string("7"));
  };
  EXPECT_EQ(lit(0).english(), "of 7, 0 are lit");
  EXPECT_EQ(lit(1).english(), "of 7, 1 is lit");
  EXPECT_EQ(lit(2).english(), "of 7, 2 are lit");
}

TEST(Message, LanguagesWithMoreFormsThanTwoHaveTheCount) {
  const Message::Language polish = [](const Message& message) -> std::string {
    EXPECT_EQ(message.kind(), Message::Kind::kCounted);
    EXPECT_EQ(message.words(), "{} frames");
    EXPECT_EQ(message.context(), "{} frame");
    const long n = message.count();
    if (n == 1) return "{} klatka";
    const bool is_few = n % 10 >= 2 && n % 10 <= 4 && (n % 100 < 12 || n % 100 > 14);
    return is_few ? "{} klatki" : "{} klatek";
  };
  std::vector<std::string> told;
  for (const int n : {0, 1, 2, 5, 12, 22, 112})
    told.push_back(en::count("{} frames", "{} frame", n).in(polish));
  EXPECT_THAT(told, ElementsAre("0 klatek", "1 klatka", "2 klatki", "5 klatek", "12 klatek",
                                "22 klatki", "112 klatek"));
}

TEST(Message, AWordKnowsWhatItIsSaidOf) {
  const Message press = en::word("left", "press"), third = en::word("left", "third");
  EXPECT_EQ(press.english(), "left");
  EXPECT_EQ(third.english(), "left");
  EXPECT_NE(press, third);
  const Message::Language german = [](const Message& message) -> std::string {
    return message.context() == "press" ? "linker" : message.context() == "third" ? "linkes" : "?";
  };
  EXPECT_EQ(press.in(german), "linker");
  EXPECT_EQ(third.in(german), "linkes");
}

TEST(Message, RowsLeaveOutWhatIsEmpty) {
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    std::vector<Message> messages;
    std::vector<std::string> kept;
    for (int left = up_to(random, 6); left > 0; --left) {
      const bool is_empty = up_to(random, 2) == 0;
      messages.push_back(is_empty ? Message() : en::say("thing {}", left));
      if (!is_empty) kept.push_back(fmt::format("thing {}", left));
    }
    EXPECT_EQ(en::list(messages).english(), fmt::format("{}", fmt::join(kept, ", ")));
    EXPECT_EQ(en::clauses(messages).english(), fmt::format("{}", fmt::join(kept, "; ")));
    EXPECT_EQ(en::sentences(messages).english(), fmt::format("{}", fmt::join(kept, ". ")));
    EXPECT_EQ(en::list(messages).empty(), kept.empty());
    if (kept.size() == 1) {
      const auto only = std::find_if(messages.begin(), messages.end(),
                                     [](const Message& m) { return !m.empty(); });
      EXPECT_EQ(en::list(messages), *only) << "nothing is put around one";
      EXPECT_EQ(en::sentences(messages), *only);
    }
  }
  EXPECT_EQ(en::list({}), Message());
  EXPECT_EQ(en::at("", en::say("it is")), en::say("it is"));
  EXPECT_EQ(en::at(en::say("here"), en::say("it is")).english(), "here: it is");
}

TEST(Message, RowsAreJoinedAsTheLanguageDoes) {
  const Message::Language chinese = [](const Message& message) -> std::string {
    return message.words() == "{}, {}" ? "{}、{}" : message.words();
  };
  EXPECT_EQ(en::list({en::say("a"), Message(), en::say("b"), en::say("c")}).in(chinese), "a、b、c");
}

TEST(Message, IsWrittenInEnglishByFmt) {
  const Message message = en::count("{} presses", "{} press", 1);
  EXPECT_EQ(fmt::format("[{}] [{:>10}]", message, message), "[1 press] [   1 press]");
}

TEST(Message, ErrorsNameThePlaceAndWhatCanBeTried) {
  const Message what = en::say("it is missing");
  EXPECT_EQ((Error{what, "", ""}.sentence()), "it is missing.");
  EXPECT_EQ((Error{what, std::filesystem::path("a/b"), ""}.sentence()), "a/b: it is missing.");
  EXPECT_EQ(
      (Error{what, std::string("camera.fx"), en::say("add {}", std::string("it"))}.sentence()),
      "camera.fx: it is missing. Try: add it.");
  const Error error{what, en::say("the image"), ""};
  EXPECT_EQ(error.message().in([](const Message& message) -> std::string {
    return message.words() == "the image"       ? "das Bild"
           : message.words() == "it is missing" ? "es fehlt"
                                                : message.words();
  }),
            "das Bild: es fehlt");
}

TEST(MessageJson, IsAsDescribed) {
  EXPECT_EQ(message_json(Message()).dump(), R"({"text":""})");
  EXPECT_EQ(message_json(Message::typed("a \"b\"")).dump(), R"({"text":"a \"b\""})");
  EXPECT_EQ(message_json(en::word("left", "press")).dump(), R"({"say":"left","of":"press"})");
  EXPECT_EQ(message_json(en::say("{:.2f} mm", 0.123)).dump(),
            R"({"say":"{:.2f} mm","parts":[{"number":"0.12"}]})");
  EXPECT_EQ(message_json(en::count("{} views", "{} view", 3)).dump(),
            R"({"count":3,"many":"{} views","one":"{} view","parts":[{"number":"3"}]})");
}

TEST(MessageJson, AnyMessageComesBackThroughAFile) {
  Random random(5);
  for (int i = 0; i < 3000; ++i) {
    const Message message = any_message(random, 4);
    const Message back = message_of(Json::parse(message_json(message).dump()));
    EXPECT_EQ(back, message) << message_json(message).dump();
    EXPECT_EQ(back.english(), message.english());
  }
}

TEST(MessageJson, WhatHasAnotherFormIsTakenAsItIs) {
  EXPECT_EQ(message_of("from an old file"), Message::typed("from an old file"));
  for (const char* text : {"null", "7", "true", "[]", "[{\"say\": \"x\"}]", "{}", R"({"text": 5})"})
    EXPECT_EQ(message_of(Json::parse(text)), Message()) << text;
  const auto english = [](const char* text) { return message_of(Json::parse(text)).english(); };
  EXPECT_EQ(english(R"({"say": 5, "parts": {}})"), "");
  EXPECT_EQ(english(R"({"say": "{} x {}", "parts": "no"})"), " x ");
  EXPECT_EQ(english(R"({"say": "{} {}.", "parts": [1, "two"]})"), " two.");
  EXPECT_EQ(english(R"({"say": "{1}{0}{7}", "parts": ["a", {"text": "b"}]})"), "ba");
  EXPECT_EQ(english(R"({"many": "{} a", "one": "{} b", "count": "1", "parts": ["1"]})"), "1 a");
  EXPECT_EQ(english(R"({"many": "many", "one": "one", "count": 1.0})"), "many");
  EXPECT_EQ(english(R"({"many": "many", "one": "one", "count": 1})"), "one");
  EXPECT_EQ(english(R"({"many": "many", "count": 18446744073709551615})"), "many");
  EXPECT_EQ(english(R"({"number": [3]})"), "");
}

/// Any JSON, of the keys that messages have, with values that these should have and others.
Json any_json(Random& random, int depth) {
  switch (up_to(random, depth > 0 ? 7 : 4)) {
    case 0:
      return any_text(random);
    case 1:
      return up_to(random, 4) - 1;
    case 2:
      return nullptr;
    case 3:
      return 0.5;
    case 4:
      return true;
    case 5: {
      Json list = Json::array();
      for (int left = up_to(random, 3); left > 0; --left)
        list.push_back(any_json(random, depth - 1));
      return list;
    }
    default: {
      Json object = Json::object();
      for (const char* key :
           {"text", "number", "say", "of", "count", "many", "one", "parts", "odd"})
        if (up_to(random, 2) == 0) object[key] = any_json(random, depth - 1);
      return object;
    }
  }
}

TEST(MessageJson, AnyJsonIsSomeMessageThatIsTheSameAgain) {
  Random random(6);
  for (int i = 0; i < 5000; ++i) {
    const Json json = any_json(random, 5);
    const Message message = message_of(json);
    EXPECT_EQ(message_of(message_json(message)), message) << json.dump();
    static_cast<void>(message.english());
  }
}

TEST(MessageJson, EndsWhereMessagesAreNestedDeeperThanAnyoneSays) {
  constexpr int kDeepest = 32, kAbsurd = 1000;
  const auto nested = [](int times) {
    Message message = Message::typed("x");
    for (int i = 0; i < times; ++i) message = en::say("({})", message);
    return message;
  };
  EXPECT_EQ(message_of(message_json(nested(kDeepest))), nested(kDeepest));
  const std::string left(kDeepest + 1, '('), right(kDeepest + 1, ')');
  EXPECT_EQ(message_of(message_json(nested(kAbsurd))).english(), left + right);
  Json lists = "x";
  for (int i = 0; i < kAbsurd; ++i) lists = Json::array({lists});
  EXPECT_EQ(message_of({{"say", "a{}"}, {"parts", lists}}).english(), "a");
}

}  // namespace
}  // namespace alltact
