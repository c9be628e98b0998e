// Gage R&R in the window: of fingers that are selected in the list of all, and of a table.
#include "calibration/checks/check_history.h"
#include "calibration/checks/gage_readings.h"
#include "core/finger/finger_store.h"
#include "tests/studio/studio_rig.h"
#include "tests/support/program.h"
#include "widgets/shell/finger_card.h"
#include "widgets/shell/gage_dialog.h"

#include <QClipboard>
#include <QTreeWidget>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class GageWindow : public testing::Test {
 protected:
  GageWindow() {
    double mm = 0.01;
    for (const char* name : {"left-01", "left-02", "left-03"}) {
      const fs::path folder = lab_ / name;
      fs::copy(MadeFingers::get().calibrated(), folder, fs::copy_options::recursive);
      folders_.push_back(folder);
      for (const char* person : {"Ann", "Bob"})
        for (int i = 0; i < 3; ++i) {
          CheckEntry check;
          check.time = "2026-01-31T12:00:00Z";
          check.presses = 3;
          check.ball_radius_mm = 4;
          check.operator_name = person;
          check.bias_mm = mm = std::fmod(mm * 7.3 + 0.013, 0.05);
          must(append_check(folder, check));
        }
    }
  }
  static QString cell(const GageDialog& dialog, const char* table, const QString& row, int column) {
    for (const auto* tree : dialog.findChildren<QTreeWidget*>())
      if (tree->accessibleName() == QLatin1String(table))
        for (int i = 0; i < tree->topLevelItemCount(); ++i)
          if (tree->topLevelItem(i)->text(0).trimmed() == row)
            return tree->topLevelItem(i)->text(column);
    return {};
  }
  TemporaryFolder lab_;
  std::vector<fs::path> folders_;
};

TEST_F(GageWindow, ComparesTheFingersThatAreSelected) {
  StudioOptions options;
  options.finger = folders_.front();
  Studio studio(options);
  QTest::keyClick(&studio.window(), Qt::Key_L, Qt::ControlModifier);
  auto* list = studio.window().findChild<FingerListDialog*>();
  ASSERT_NE(list, nullptr);
  ASSERT_TRUE(wait_until([&] { return list->cards().size() == 3; }));
  list->findChild<QTreeWidget*>()->selectAll();
  studio.click("Gage RR…");
  auto* dialog = studio.window().findChild<GageDialog*>();
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(wait_until([&] { return dialog->study().has_value(); }));

  const auto truth = gage_study(read_gage_checks(folders_, {})->readings);
  ASSERT_TRUE(truth.ok());
  EXPECT_DOUBLE_EQ(dialog->study()->gage, truth->gage);
  EXPECT_EQ(cell(*dialog, "Variation by source", "Gage R&R", 1),
            QString::number(truth->gage, 'f', 4));
  EXPECT_EQ(cell(*dialog, "Variation by source", "Gage R&R", 4), "") << "no tolerance";
  EXPECT_EQ(cell(*dialog, "Analysis of variance", "Total", 1), "17");
  auto* tolerance = dialog->findChild<NumberField*>();
  tolerance->setValue(0.2);
  EXPECT_EQ(cell(*dialog, "Variation by source", "Gage R&R", 4),
            QString::number(600 * truth->gage / 0.2, 'f', 1));
  studio.click("Copy");
  EXPECT_THAT(
      QGuiApplication::clipboard()->text().toStdString(),
      HasSubstr("Repeatability\t" + QString::number(truth->repeatability, 'f', 4).toStdString()));
  ProgramAppearance appearance;
  for (const char* language : {"en", "de", "zh_CN"}) {
    appearance.apply({Theme::kLight, QLatin1String(language)});
    QTest::qWait(100);
    ASSERT_TRUE(dialog->grab().save(
        QStringLiteral(ALLTACT_SCREENS "/gage_%1.png").arg(QLatin1String(language))));
  }
  appearance.apply({Theme::kLight, QStringLiteral("en")});
}

TEST_F(GageWindow, NamesWhatAFingerLacks) {
  GageDialog dialog({folders_.front()});
  dialog.show();
  const auto shown = [&dialog] {
    QStringList texts;
    for (const auto* label : dialog.findChildren<QLabel*>()) texts << label->text();
    return texts.join(QLatin1Char('\n')).toStdString();
  };
  ASSERT_TRUE(wait_until([&] { return dialog.study().has_value(); })) << "two operators suffice";
  EXPECT_EQ(dialog.study()->by_part.df, 0);
  write_text(lab_ / "one.csv", "part,operator,value_mm\na,Ann,1\nb,Bob,2\n");
  dialog.open_table(lab_ / "one.csv");
  ASSERT_TRUE(wait_until(
      [&] { return shown().find("only one reading of a by Ann") != std::string::npos; }));
  EXPECT_FALSE(dialog.study().has_value()) << "the study before is not shown with another table";
}

}  // namespace
}  // namespace alltact::test
