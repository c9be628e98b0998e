// Alt and a letter does one thing on a page: no two of what is visible, nor a menu, have the same
// letter. Tested in all languages.
#include "tests/studio/calibrate_rig.h"
#include "tests/studio/measured_finger.h"
#include "widgets/pages/accuracy_page.h"

#include <QGroupBox>
#include <QMenuBar>
#include <QTabBar>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

class Mnemonics : public testing::Test {
 protected:
  ~Mnemonics() override { ProgramAppearance().apply({Theme::kLight, QStringLiteral("en")}); }

  static void expect_unique(MainWindow& window, const std::string& page) {
    ProgramAppearance appearance;
    for (const char* language : {"en", "de", "zh_CN"}) {
      appearance.apply({Theme::kLight, QLatin1String(language)});
      QTest::qWait(60);
      std::map<QString, QString> owners;
      const auto add = [&](const QString& text) {
        const QString letter = QKeySequence::mnemonic(text).toString();
        if (letter.isEmpty()) return;
        const auto [owner, is_new] = owners.emplace(letter, text);
        EXPECT_TRUE(is_new) << page << ", " << language << ": " << letter.toStdString()
                            << " is of '" << owner->second.toStdString() << "' and of '"
                            << text.toStdString() << "'";
      };
      for (const QAction* menu : window.menuBar()->actions()) add(menu->text());
      for (const auto* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->window() != &window) continue;
        const auto* label = qobject_cast<const QLabel*>(widget);
        if (label != nullptr && label->buddy() == nullptr) continue;
        if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
          for (int i = 0; i < tabs->count(); ++i) add(tabs->tabText(i));
        } else if (label != nullptr || qobject_cast<const QAbstractButton*>(widget) != nullptr) {
          add(widget->property("text").toString());
        } else if (const auto* group = qobject_cast<const QGroupBox*>(widget)) {
          add(group->title());
        }
      }
    }
    appearance.apply({Theme::kLight, QStringLiteral("en")});
    QTest::qWait(30);
  }
};

TEST_F(Mnemonics, OfTheStartPage) {
  Studio studio;
  expect_unique(studio.window(), "start");
}

TEST_F(Mnemonics, OfThePages) {
  StudioOptions options = simulated();
  options.finger = MeasuredFinger::get().folder();
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  expect_unique(studio.window(), "live");
  studio.window().go_to("record");
  expect_unique(studio.window(), "record");
  studio.window().go_to("inspect");
  auto& inspect = *studio.window().findChild<InspectPage*>();
  inspect.open(MadeFingers::get().touched_pictures());
  ASSERT_TRUE(wait_until([&] { return inspect.inspection().frame() != nullptr; }));
  expect_unique(studio.window(), "inspect");
  studio.window().go_to("accuracy");
  auto& accuracy = *studio.window().findChild<AccuracyPage*>();
  ASSERT_TRUE(wait_until([&] { return accuracy.run().study() != nullptr; }));
  expect_unique(studio.window(), "accuracy");
}

TEST_F(Mnemonics, OfTheStepsOfCalibrate) {
  {
    Studio studio;
    studio.click("Simulated finger");
    ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.finger.has_value(); }));
    studio.window().go_to("calibrate");
    expect_unique(studio.window(), "the lens");
  }
  CalibrateStudio rig(4);
  rig.open();
  rig.collection().set_radius(4);
  ASSERT_TRUE(rig.wait_until_looked_at(4));
  rig.run().start();
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  for (const char* step : {"1", "2", "3", "4", "5", "6"}) {
    rig.go_to_step(QLatin1String(step));
    expect_unique(rig.studio().window(), std::string("step ") + step);
  }
}

}  // namespace
}  // namespace alltact::test
