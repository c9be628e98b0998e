// Every control has a short tool tip, on every page and in every dialog, in every language; and no
// standard button brings a black symbol of Qt's.
#include "tests/studio/calibrate_rig.h"
#include "tests/studio/measured_finger.h"
#include "widgets/inspect/finger_pair.h"
#include "widgets/inspect/recipe_box.h"
#include "widgets/live/live_pair.h"
#include "widgets/pages/accuracy_page.h"
#include "widgets/shell/export_dialog.h"
#include "widgets/shell/finger_card.h"
#include "widgets/shell/force_dialog.h"
#include "widgets/shell/gage_dialog.h"
#include "widgets/shell/new_finger_dialog.h"
#include "widgets/shell/settings_dialog.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QProxyStyle>
#include <QScrollBar>
#include <QTabBar>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

constexpr int kLongestTip = 330;  // with an explanation

/// Parts of Qt's own widgets, which belong to the whole around them.
bool is_part(const QWidget& widget) {
  const QWidget* parent = widget.parentWidget();
  return widget.objectName().startsWith(QLatin1String("qt_")) ||
         qobject_cast<const QAbstractSpinBox*>(parent) != nullptr ||
         qobject_cast<const QComboBox*>(parent) != nullptr ||
         qobject_cast<const QLineEdit*>(parent) != nullptr ||
         qobject_cast<const QTabBar*>(parent) != nullptr || widget.inherits("QTableCornerButton");
}

bool is_control(const QWidget& widget) {
  return widget.isVisible() && !is_part(widget) &&
         qobject_cast<const QScrollBar*>(&widget) == nullptr &&
         (qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
          qobject_cast<const QComboBox*>(&widget) != nullptr ||
          qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
          qobject_cast<const QLineEdit*>(&widget) != nullptr ||
          qobject_cast<const QAbstractSlider*>(&widget) != nullptr);
}

/// A path or a camera's name is as long as it is.
bool may_be_long(const QWidget& widget) {
  return widget.toolTip().contains(QLatin1Char('/')) ||
         qobject_cast<const QLineEdit*>(&widget) != nullptr;
}

int expect_tips(const QWidget& root, const std::string& page) {
  int controls = 0;
  for (const QWidget* widget : root.findChildren<QWidget*>()) {
    if (!is_control(*widget) || widget->window() != root.window()) continue;
    ++controls;
    const QString tip = widget->toolTip();
    const std::string what = page + ": " + widget->metaObject()->className() + " '" +
                             widget->property("text").toString().toStdString() + "' '" +
                             widget->accessibleName().toStdString() + "'";
    // The field of a path has the path as its tip.
    const auto* line = qobject_cast<const QLineEdit*>(widget);
    if (line != nullptr && line->text().isEmpty()) continue;
    EXPECT_FALSE(tip.trimmed().isEmpty()) << what << " has no tool tip";
    if (!may_be_long(*widget)) {
      EXPECT_LE(tip.size(), kLongestTip) << what << ": " << tip.toStdString();
    }
  }
  return controls;
}

class Tips : public testing::Test {
 protected:
  ~Tips() override { ProgramAppearance().apply({Theme::kLight, QStringLiteral("en")}); }
  static void expect_everywhere(const QWidget& root, const std::string& page, int at_least = 4) {
    ProgramAppearance appearance;
    for (const char* language : {"en", "de", "zh_CN"}) {
      appearance.apply({Theme::kLight, QLatin1String(language)});
      QTest::qWait(60);
      EXPECT_GE(expect_tips(root, page + ", " + language), at_least) << page;
    }
    appearance.apply({Theme::kLight, QStringLiteral("en")});
    QTest::qWait(30);
  }
  static void expect_of(QWidget& dialog, int at_least = 1) {
    dialog.show();
    expect_everywhere(dialog, dialog.metaObject()->className(), at_least);
  }
};

TEST_F(Tips, StandOnTheFirstPage) {
  Studio studio;
  expect_everywhere(studio.window(), "start");
}

TEST_F(Tips, StandOnThePages) {
  StudioOptions options = simulated();
  options.finger = MeasuredFinger::get().folder();
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  expect_everywhere(studio.window(), "live");
  studio.window().go_to("record");
  expect_everywhere(studio.window(), "record");
  studio.window().go_to("inspect");
  auto& inspect = *studio.window().findChild<InspectPage*>();
  inspect.open(MadeFingers::get().touched_pictures());
  ASSERT_TRUE(wait_until([&] { return inspect.inspection().frame() != nullptr; }));
  expect_everywhere(studio.window(), "inspect");
  studio.window().go_to("accuracy");
  auto& accuracy = *studio.window().findChild<AccuracyPage*>();
  ASSERT_TRUE(wait_until([&] { return accuracy.run().study() != nullptr; }));
  expect_everywhere(studio.window(), "accuracy");
}

TEST_F(Tips, StandOnEveryStepOfCalibrate) {
  {
    Studio studio;
    studio.click("Simulated finger");
    ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.finger.has_value(); }));
    studio.window().go_to("calibrate");
    expect_everywhere(studio.window(), "the lens");
  }
  CalibrateStudio rig(4);
  rig.open();
  rig.collection().set_radius(4);
  ASSERT_TRUE(rig.wait_until_looked_at(4));
  rig.run().start();
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  for (const char* step : {"1", "2", "3", "4", "5", "6"}) {
    rig.go_to_step(QLatin1String(step));
    expect_everywhere(rig.studio().window(), std::string("step ") + step);
  }
}

/// `use` gets every dialog of the program that can stand alone.
void for_all_dialogs(const std::function<void(QWidget& dialog)>& use) {
  const auto finger = MadeFingers::get().calibrated();
  QUndoStack undo;
  NewFingerDialog made;
  use(made);
  SettingsDialog settings({}, nullptr);
  use(settings);
  ExportDialog exported(finger);
  use(exported);
  FingerListDialog list({finger});
  use(list);
  GageDialog gage({finger});
  use(gage);
  ForceDialog force(finger, undo);
  use(force);
  SecondFingerDialog second(std::nullopt);
  use(second);
  GripperDialog gripper("finger", std::nullopt);
  use(gripper);
  SecondCameraDialog camera(std::nullopt, {});
  use(camera);
  RecipeReading reading;
  reading.name = "depth";
  InspectionRecipe recipe;
  recipe.readings = {reading};
  ReadingDialog tolerance(reading, recipe);
  use(tolerance);
}

TEST_F(Tips, StandInTheDialogs) {
  for_all_dialogs([](QWidget& dialog) { expect_of(dialog); });
}

TEST_F(Tips, OfAControlWithoutOneAreMissed) {
  QWidget window;
  auto* button = new QPushButton("Do", &window);
  window.show();
  QTest::qWait(20);
  EXPECT_TRUE(is_control(*button));
  EXPECT_TRUE(button->toolTip().isEmpty());
}

/// As a desktop's own style may have it.
class WithIcons : public QProxyStyle {
 public:
  WithIcons() : QProxyStyle("Fusion") {}
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* more) const override {
    return hint == SH_DialogButtonBox_ButtonsHaveIcons
               ? 1
               : QProxyStyle::styleHint(hint, option, widget, more);
  }
};

int buttons_with_icons(const QWidget& dialog, int& buttons) {
  int icons = 0;
  for (const auto* box : dialog.findChildren<QDialogButtonBox*>())
    for (const QAbstractButton* button : box->buttons()) {
      ++buttons;
      if (!button->icon().isNull()) ++icons;
    }
  return icons;
}

TEST(DialogButtons, HaveNoSymbolsOfQt) {
  int buttons = 0;
  QApplication::setStyle(new WithIcons);
  {
    SettingsDialog plain({}, nullptr);
    EXPECT_GE(buttons_with_icons(plain, buttons), 1) << "the test sees such symbols";
  }
  auto* style = new StudioStyle;
  style->setBaseStyle(new WithIcons);
  QApplication::setStyle(style);
  buttons = 0;
  for_all_dialogs([&](QWidget& dialog) {
    EXPECT_EQ(buttons_with_icons(dialog, buttons), 0) << dialog.metaObject()->className();
  });
  EXPECT_GE(buttons, 10);
  QApplication::setStyle(new StudioStyle);
}

}  // namespace
}  // namespace alltact::test
