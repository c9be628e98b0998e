// Commands are found by their words, in every language, and run as from their menu or page.
#include "app/studio/command_search.h"

#include "app/studio/help.h"
#include "app/studio/main_window.h"
#include "tests/studio/studio_rig.h"
#include "widgets/shell/settings_dialog.h"

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

class FindCommand : public testing::Test {
 protected:
  FindCommand() : studio_(simulated()) {}
  CommandSearch& open() {
    QTest::keyClick(&studio_.window(), Qt::Key_K, Qt::ControlModifier);
    auto* search = studio_.window().findChild<CommandSearch*>();
    EXPECT_NE(search, nullptr);
    return *search;
  }
  static QStringList found(const CommandSearch& search) {
    QStringList names;
    const auto* list = search.findChild<QTreeWidget*>();
    for (int i = 0; i < list->topLevelItemCount(); ++i) names << list->topLevelItem(i)->text(0);
    return names;
  }
  static void type(CommandSearch& search, const QString& words) {
    QTest::keyClicks(search.findChild<QLineEdit*>(), words);
  }
  Studio studio_;
};

TEST_F(FindCommand, ListsEveryEntryOfTheMenusWithItsKeys) {
  CommandSearch& search = open();
  const QStringList all = found(search);
  for (const char* name : {"Settings…", "Export finger…", "Record", "Full screen"})
    EXPECT_TRUE(all.contains(QString::fromUtf8(name))) << name;
  const auto* list = search.findChild<QTreeWidget*>();
  const auto rows = list->findItems(QStringLiteral("Settings…"), Qt::MatchExactly);
  ASSERT_EQ(rows.size(), 1);
  EXPECT_EQ(rows.front()->text(2), "Ctrl+,");
  search.close();
}

/// What is typed in no menu: in the images, in 3D, along a recording, in the plots.
TEST_F(FindCommand, ListsTheKeysOfTheViews) {
  ProgramAppearance appearance;
  qsizetype rows = 0;  // of the help's tables
  for (const char* language : {"en", "de", "zh_CN"}) {
    appearance.apply({Theme::kLight, QLatin1String(language)});
    QTest::qWait(30);
    QApplication::setActiveWindow(&studio_.window());
    CommandSearch& search = open();
    std::map<QString, QStringList> keys;  // of each view
    const auto* list = search.findChild<QTreeWidget*>();
    for (int i = 0; i < list->topLevelItemCount(); ++i)
      keys[list->topLevelItem(i)->text(1)] << list->topLevelItem(i)->text(2);
    const QString plus = QLatin1String(language) == QLatin1String("en") ? "+ and -"
                         : QLatin1String(language) == QLatin1String("de")
                             ? "+ und -"
                             : QStringLiteral("+ 和 -");
    int zooms = 0, ones = 0, zeros = 0;
    for (const auto& [view, all] : keys) {
      zooms += all.contains(plus) ? 1 : 0;
      ones += all.contains(QStringLiteral("1")) ? 1 : 0;
      zeros += all.contains(QStringLiteral("0")) ? 1 : 0;
    }
    EXPECT_EQ(zooms, 2) << language << ": the image and the 3D view";
    EXPECT_EQ(zeros, 2) << language;
    EXPECT_EQ(ones, 1) << language;
    const qsizetype here = help_text(QStringLiteral("keys")).count(QLatin1String("\n|"));
    if (rows == 0) {
      rows = here;
      for (const auto& [view, key] : {std::pair{"Calibrate", "Space"},
                                      {"Calibrate", "Delete"},
                                      {"Frames of a recording", "Home, End"},
                                      {"Every image and plot", "Ctrl+C"},
                                      {"Plot of Accuracy", "Enter"},
                                      {"Image", "Shift and arrows"}})
        EXPECT_TRUE(keys[QLatin1String(view)].contains(QLatin1String(key))) << view << " " << key;
    }
    EXPECT_EQ(here, rows) << language << ": the same rows in every language";
    search.close();
    QTest::qWait(30);
  }
  appearance.apply({Theme::kLight, QStringLiteral("en")});
}

TEST_F(FindCommand, RunsWhatIsFoundByReturn) {
  CommandSearch& search = open();
  type(search, "page rec");
  type(search, " x");
  EXPECT_TRUE(found(search).isEmpty());
  search.findChild<QLineEdit*>()->clear();
  type(search, "settings");
  EXPECT_EQ(found(search), QStringList{QStringLiteral("Settings…")});
  QTest::keyClick(search.findChild<QLineEdit*>(), Qt::Key_Return);
  EXPECT_TRUE(wait_until([&] { return studio_.window().findChild<SettingsDialog*>() != nullptr; }));
}

TEST_F(FindCommand, ClicksTheButtonsOfThePage) {
  studio_.window().go_to("inspect");
  CommandSearch& search = open();
  type(search, "this page live finger");
  ASSERT_EQ(found(search), QStringList{QStringLiteral("Live finger")});
  QTest::keyClick(search.findChild<QLineEdit*>(), Qt::Key_Escape);
  EXPECT_TRUE(wait_until([&] { return studio_.window().findChild<CommandSearch*>() == nullptr; }));
}

TEST_F(FindCommand, SpeaksTheWindowsLanguage) {
  ProgramAppearance appearance;
  appearance.apply({Theme::kLight, QStringLiteral("zh_CN")});
  CommandSearch& search = open();
  for (const QString& name : found(search)) EXPECT_FALSE(name.contains(QLatin1String("(&")));
  appearance.apply({Theme::kLight, QStringLiteral("de")});
  EXPECT_TRUE(wait_until([&] { return found(search).contains(QStringLiteral("Einstellungen…")); }));
  appearance.apply({Theme::kLight, QStringLiteral("en")});
}

}  // namespace
}  // namespace alltact::test
