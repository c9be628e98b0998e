// What the libraries say, in German, in Chinese and in English.
#include "widgets/language.h"

#include "app/studio/main_window.h"
#include "calibration/report/press_errors.h"
#include "calibration/verdict/verdict.h"
#include "core/base/result.h"
#include "tests/studio/studio_rig.h"
#include "tests/support/good_evidence.h"
#include "tests/support/ts_file.h"
#include "tests/support/words_left.h"
#include "widgets/verdict_text.h"

#include <QLocale>
#include <QMenuBar>
#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class InLanguage : public testing::Test {
 protected:
  ~InLanguage() override { speak("en"); }
  void speak(const char* language) {
    appearance_.apply({Theme::kLight, QString::fromLatin1(language)});
  }
  static std::string reported(const Message& message) {
    return in_window_language(message).toStdString();
  }
  static std::vector<TsMessage> all_said(const char* language) {
    std::vector<TsMessage> messages = messages_of(ts_file(language));
    std::erase_if(messages, [](const TsMessage& message) {
      return message.context != QLatin1String(kSaidContext);
    });
    EXPECT_GT(messages.size(), 700U);
    return messages;
  }
  ProgramAppearance appearance_;
};

TEST_F(InLanguage, EnglishIsAsTheSourcesSayIt) {
  speak("en");
  const Message verdict = en::say("good");
  EXPECT_EQ(reported(verdict), "good");
  EXPECT_EQ(window_sentence(en::say("the disk is full")).toStdString(), "The disk is full.");
  EXPECT_EQ(window_sentence(en::say("The disk is full.")).toStdString(), "The disk is full.");
  EXPECT_EQ(window_sentence(en::say("is it there?")).toStdString(), "Is it there?");
  EXPECT_EQ(window_sentence(en::say("there it is!")).toStdString(), "There it is!");
  EXPECT_EQ(window_sentence({}).toStdString(), "");
  EXPECT_EQ(window_sentence(Message::typed("...")).toStdString(), "");
}

TEST_F(InLanguage, ASentenceEndsAsItsLanguageEndsSentences) {
  speak("de");
  EXPECT_EQ(window_sentence(en::say("the contact covers too few pixels")).toStdString(),
            "Der Kontakt bedeckt zu wenige Pixel.");
  speak("zh_CN");
  EXPECT_EQ(window_sentence(en::say("the contact covers too few pixels")).toStdString(),
            "接触覆盖的像素太少。");
  const Message at_end = en::say("{}.", en::say("the contact covers too few pixels"));
  EXPECT_EQ(window_sentence(at_end).toStdString(), "接触覆盖的像素太少。");
}

TEST_F(InLanguage, WhatSomebodyTypedStaysAsItIs) {
  for (const char* language : {"de", "zh_CN"}) {
    SCOPED_TRACE(language);
    speak(language);
    EXPECT_NE(reported(en::say("left")), "left");
    const std::string press = "left";
    const Message no_face = en::say("no face was found");
    EXPECT_EQ(reported(en::at(Message::typed(press), no_face)).rfind("left: ", 0), 0U);
    const std::filesystem::path folder = "no face was found";
    const Error error{no_face, folder, en::say("another frame")};
    EXPECT_EQ(reported(error.message()).rfind("no face was found: ", 0), 0U);
    EXPECT_THAT(reported(error.message()), Not(HasSubstr("another frame")));
    const Message twice = en::say("two presses are called '{}'", press);
    EXPECT_THAT(reported(twice), HasSubstr("left"));
    EXPECT_THAT(reported(twice), Not(HasSubstr(reported(en::say("left")))));
  }
}

TEST_F(InLanguage, NoTemplateIsTranslatedWhereItWasTyped) {
  for (const char* language : {"de", "zh_CN"}) {
    SCOPED_TRACE(language);
    speak(language);
    for (const TsMessage& message : all_said(language)) {
      const std::string words = message.source.toStdString();
      EXPECT_EQ(reported(Message::typed(words)), words);
      EXPECT_EQ(reported(en::say("{}: {}", words, en::say("stopped"))).rfind(words + ":", 0), 0U)
          << words;
    }
  }
}

TEST_F(InLanguage, EveryTemplateIsSaidAsItsTranslation) {
  const std::vector<Message> parts{
      Message::typed("<0>"), Message::typed("<1>"), Message::typed("<2>"), Message::typed("<3>"),
      Message::typed("<4>"), Message::typed("<5>"), Message::typed("<6>"), Message::typed("<7>")};
  for (const char* language : {"de", "zh_CN"}) {
    SCOPED_TRACE(language);
    speak(language);
    for (const TsMessage& message : all_said(language)) {
      const std::string words = message.source.toStdString();
      const std::string comment = message.comment.toStdString();
      const auto filled = [&](const QString& form) {
        return Message::compose(Message::Kind::kTemplate, form.toStdString(), {}, -1, parts)
            .english();
      };
      if (!message.is_counted) {
        const Message whole = Message::compose(Message::Kind::kTemplate, words, comment, -1, parts);
        EXPECT_EQ(reported(whole), filled(message.translations.first()));
        continue;
      }
      for (const int count : {0, 1, 2}) {
        const bool is_one = count == 1 && language == std::string("de");
        const Message whole =
            Message::compose(Message::Kind::kCounted, words, comment, count, parts);
        EXPECT_EQ(reported(whole),
                  filled(is_one ? message.translations.first() : message.translations.last()));
      }
    }
  }
}

TEST_F(InLanguage, NoEnglishIsLeftInWhatIsPutTogether) {
  const std::vector<ZoneError> zones{
      {en::say("base"), 3, 0.012}, {en::say("middle"), 1, 0.01}, {en::say("tip"), 0, std::nullopt}};
  std::vector<Message> sentences{zone_sentence(zones), verdict(test::good_evidence()).sentence};
  for (const double scale_mm : {0.07, 0.2}) {
    CalibrationEvidence evidence = test::good_evidence();
    evidence.scale_sd_mm = scale_mm;
    sentences.push_back(verdict(evidence).sentence);
  }
  CalibrationEvidence poor = test::good_evidence();
  poor.thirds = {1, 0, 0};
  poor.positions = 1;
  poor.held_out_mm = 0;
  poor.changed = {en::say("width"), en::say("layer")};
  poor.reference = ReferenceState::kCut;
  for (int kind = 1; kind <= 5; ++kind)
    sentences.push_back(
        sentence({static_cast<ContradictionKind>(kind), {"a", "b"}, 4, 2.1, 2.4, 6}));
  sentences.push_back(verdict(poor).sentence);
  for (const char* language : {"de", "zh_CN"}) {
    SCOPED_TRACE(language);
    speak(language);
    for (const Message& message : sentences) {
      const QString text = in_window_language(message);
      EXPECT_TRUE(words_left(text).isEmpty()) << text.toStdString() << "\n"
                                              << words_left(text).join("; ").toStdString();
      EXPECT_NE(text.toStdString(), message.english());
    }
  }
}

TEST_F(InLanguage, CountsAreSaidOfNoneOneAndMore) {
  const auto frames = [](int count) { return reported(en::count("{} frames", "{} frame", count)); };
  speak("en");
  EXPECT_EQ(frames(0), "0 frames");
  EXPECT_EQ(frames(1), "1 frame");
  EXPECT_EQ(frames(2), "2 frames");
  speak("de");
  EXPECT_EQ(frames(0), "0 Bilder");
  EXPECT_EQ(frames(1), "1 Bild");
  EXPECT_EQ(frames(2), "2 Bilder");
  speak("zh_CN");
  EXPECT_EQ(frames(0), "0 帧");
  EXPECT_EQ(frames(1), "1 帧");
  EXPECT_EQ(frames(2), "2 帧");
}

TEST_F(InLanguage, SettingsAreNamedWithTheirCountsAndDecimalMarks) {
  PipelineSettings one, many;
  one.average_frames = one.edge_columns = 1;
  one.resolution = Resolution::kHalf;
  one.smoothing_px = 0.5;
  many.average_frames = 4;
  many.smoothing_px = 0;
  many.reference_neighbours = 16;
  const PipelineSettings usual;
  const auto texts = [&] {
    return std::array{difference_words(one, usual).toStdString(),
                      difference_words(many, usual).toStdString(),
                      difference_words(usual, many).toStdString()};
  };
  using Texts = std::array<std::string, 3>;
  speak("en");
  EXPECT_EQ(texts(), (Texts{"half the pixels per side, edges from 1 column, smoothing of 0.5 px",
                            "4 images averaged, reference from 16 images, no smoothing",
                            "1 image averaged, reference from 8 images, smoothing of 1 px"}));
  speak("de");
  EXPECT_EQ(texts(),
            (Texts{"halb so viele Pixel je Seite, Kanten aus 1 Spalte, Glättung von 0,5 px",
                   "4 Bilder gemittelt, Referenz aus 16 Bildern, ohne Glättung",
                   "1 Bild gemittelt, Referenz aus 8 Bildern, Glättung von 1 px"}));
  speak("zh_CN");
  EXPECT_EQ(texts(), (Texts{"每边一半像素，边缘取自 1 列，平滑 0.5 px",
                            "4 张图像取平均，参考取自 16 张图像，不平滑",
                            "1 张图像取平均，参考取自 8 张图像，平滑 1 px"}));
}

TEST_F(InLanguage, EveryCountIsRightInEnglishWithoutATranslation) {
  speak("en");
  for (const TsMessage& message : all_said("de")) {
    if (!message.is_counted) continue;
    for (const int count : {0, 1, 2}) {
      const Message whole = Message::compose(Message::Kind::kCounted, message.source.toStdString(),
                                             message.comment.toStdString(), count,
                                             {Message::typed("N"), Message::typed("A")});
      EXPECT_EQ(reported(whole), whole.english());
    }
  }
}

/// Of the menu bar and of each menu.
std::vector<QSize> menu_sizes(QMainWindow& window) {
  std::vector<QSize> sizes{window.menuBar()->sizeHint()};
  for (const QAction* action : window.menuBar()->actions()) {
    action->menu()->ensurePolished();
    sizes.push_back(action->menu()->sizeHint());
  }
  return sizes;
}

TEST_F(InLanguage, MenusOfARunningWindowAreAsLargeAsThoseOfANewOne) {
  Studio running;
  static_cast<void>(menu_sizes(running.window()));
  for (const char* language : {"zh_CN", "de", "zh_CN", "en"}) {
    speak(language);
    StudioOptions options;
    options.session_folder = running.folder() / "another";
    options.lister = [] { return std::vector<FoundCamera>{}; };
    MainWindow anew(options, appearance_);
    anew.show();
    QApplication::processEvents();
    EXPECT_EQ(menu_sizes(running.window()), menu_sizes(anew)) << language;
  }
}

}  // namespace
}  // namespace alltact::test
