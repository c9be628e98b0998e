// Words are put together, and written down, with the punctuation of their language.
#include "app/studio/main_window.h"
#include "tests/support/program.h"
#include "tests/support/ts_file.h"
#include "widgets/language.h"

#include <QRegularExpression>
#include <filesystem>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

class Punctuation : public testing::Test {
 protected:
  ~Punctuation() override { speak("en"); }
  void speak(const char* language) {
    appearance_.apply({Theme::kLight, QString::fromLatin1(language)});
  }
  ProgramAppearance appearance_;
};

TEST_F(Punctuation, IsThatOfTheWindowsLanguage) {
  const QStringList words{QStringLiteral("A"), QString(), QStringLiteral("B")};
  for (const char* language : {"en", "de"}) {
    speak(language);
    EXPECT_EQ(joined(words).toStdString(), "A, B");
    EXPECT_EQ(joined_clauses({"A", "B"}).toStdString(), "A; B");
    EXPECT_EQ(listed({"A", "B", "C"}).toStdString(), "A, B, C");
    EXPECT_EQ(labelled("A", "B").toStdString(), "A: B");
    EXPECT_EQ(as_sentence(QStringLiteral("a")).toStdString(), "a.");
  }
  speak("zh_CN");
  EXPECT_EQ(joined(words).toStdString(), "A，B");
  EXPECT_EQ(joined_clauses({"A", "B"}).toStdString(), "A；B");
  EXPECT_EQ(listed({"A", "B", "C"}).toStdString(), "A、B、C");
  EXPECT_EQ(labelled("A", "B").toStdString(), "A：B");
  EXPECT_EQ(as_sentence(QStringLiteral("好")).toStdString(), "好。");
}

/// Western punctuation that touches a Chinese character, or a comma without its space, which was
/// one; what is typed into a terminal, and a dot before a file's ending, are none.
QString western_beside_chinese(QString text) {
  static const QRegularExpression typed(QStringLiteral("`[^`]*`"));
  static const QRegularExpression form(
      QStringLiteral("\\p{Han}\\s*[,:;?!]|[,:;?!]\\s*\\p{Han}|\\p{Han}\\.(?![a-z])|\\(\\p{Han}|["
                     "\\w}],[\\p{L}%{]"));
  return form.match(text.remove(typed)).captured();
}

TEST(ChineseText, IsSeenWhereItIsPunctuatedAsInTheWest) {
  for (const char* wrong : {"好, 坏", "好:B", "A;坏", "好.", "好?", "u %1 px,v %2"})
    EXPECT_NE(western_beside_chinese(QString::fromUtf8(wrong)), QString()) << wrong;
  for (const char* right : {"好，坏", "以 .ply 结尾", "1, 2", "文件(&F)", "`hid:设备`"})
    EXPECT_EQ(western_beside_chinese(QString::fromUtf8(right)), QString()) << right;
}

TEST(ChineseText, OfTheWindowHasChinesePunctuation) {
  for (const TsMessage& message : messages_of(ts_file("zh_CN")))
    for (const QString& text : message.translations)
      EXPECT_EQ(western_beside_chinese(text), QString()) << text.toStdString();
}

TEST(ChineseText, OfTheHelpHasChinesePunctuation) {
  const std::filesystem::path help = std::filesystem::path(ALLTACT_SOURCE_DIR) / "resources/help";
  int pages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(help)) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with("_zh_CN.md")) continue;
    ++pages;
    const QStringList lines =
        QString::fromStdString(text_of(entry.path())).split(QLatin1Char('\n'));
    for (const QString& line : lines)
      EXPECT_EQ(western_beside_chinese(line), QString()) << name << ": " << line.toStdString();
  }
  EXPECT_GE(pages, 6);
}

}  // namespace
}  // namespace alltact::test
