// Everything that is shown can be heard by a screen reader and reached with the keyboard: the tree
// that assistive programs walk, the Tab key, and the letters that choose what they stand in.
#include "tests/studio/calibrate_rig.h"
#include "tests/studio/measured_finger.h"
#include "widgets/pages/accuracy_page.h"
#include "widgets/shell/finger_card.h"
#include "widgets/shell/problem_list.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QMenuBar>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

/// Parts of Qt's own widgets, which speak through the whole that they belong to.
bool is_part_of_whole(const QWidget& widget) {
  const QWidget* parent = widget.parentWidget();
  return widget.objectName().startsWith(QLatin1String("qt_")) ||
         qobject_cast<const QAbstractSpinBox*>(parent) != nullptr ||
         qobject_cast<const QComboBox*>(parent) != nullptr || parent == nullptr ||
         parent->inherits("QTabBar") || parent->inherits("QHeaderView");
}

/// What somebody does something with, or looks at. Whoever hands the focus on, as pages with tabs
/// do to the tabs, is met there.
bool is_met(const QWidget& widget) {
  return widget.isVisible() && widget.focusProxy() == nullptr && !is_part_of_whole(widget) &&
         !widget.inherits("QMenuBar") &&
         ((widget.focusPolicy() & Qt::TabFocus) != 0 || qobject_cast<const ImageView*>(&widget) ||
          qobject_cast<const QAbstractButton*>(&widget));
}

std::string described(const QWidget& widget) {
  return fmt::format("{} '{}' \"{}\"", widget.metaObject()->className(),
                     widget.objectName().toStdString(),
                     widget.property("text").toString().toStdString());
}

/// All that hangs together below an interface, as AT-SPI walks it.
void walk(QAccessibleInterface* seen, std::set<const QObject*>& found, int depth = 0) {
  ASSERT_LT(depth, 60) << "the tree leads back to itself";
  if (seen == nullptr || !seen->isValid()) return;
  if (const QObject* object = seen->object()) found.insert(object);
  if (qobject_cast<const QAbstractItemView*>(seen->object())) return;  // its cells are no widgets
  for (int i = 0; i < seen->childCount(); ++i) walk(seen->child(i), found, depth + 1);
}

void expect_heard(QWidget& root, const std::string& page, int at_least = 8) {
  std::set<const QObject*> tree;
  walk(QAccessible::queryAccessibleInterface(&root), tree);
  int count = 0;
  for (QWidget* widget : root.findChildren<QWidget*>()) {
    if (!is_met(*widget) || widget->window() != &root) continue;
    ++count;
    const std::string what = page + ": " + described(*widget);
    EXPECT_EQ(tree.count(widget), 1U) << what << " hangs on no tree";
    QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(widget);
    ASSERT_NE(seen, nullptr) << what;
    EXPECT_FALSE(seen->text(QAccessible::Name).trimmed().isEmpty()) << what << " has no name";
    EXPECT_NE(seen->role(), QAccessible::NoRole) << what << " has no role";
    EXPECT_NE(seen->role(), QAccessible::Client) << what << " has no role";
    if (qobject_cast<QAbstractButton*>(widget) != nullptr) {
      EXPECT_NE(seen->actionInterface(), nullptr) << what << " cannot be pressed";
    }
    if (qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QAbstractSlider*>(widget)) {
      EXPECT_NE(seen->valueInterface(), nullptr) << what << " tells no value";
    }
  }
  EXPECT_GE(count, at_least) << page;
}

/// Of buttons that exclude each other Tab goes to the chosen one, arrow keys to the others.
bool is_tab_stop(const QWidget& widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  const bool is_one_of_several = button != nullptr && button->group() != nullptr &&
                                 button->group()->exclusive() && !button->isChecked();
  return (widget.focusPolicy() & Qt::TabFocus) != 0 && !is_one_of_several && widget.isEnabled();
}

void expect_reached(QWidget& root, const std::string& page) {
  std::set<const QWidget*> wanted;
  for (const QWidget* widget : root.findChildren<QWidget*>())
    if (is_met(*widget) && widget->window() == &root && is_tab_stop(*widget)) wanted.insert(widget);
  const std::size_t steps = 2 * wanted.size() + 40;
  QApplication::setActiveWindow(&root);  // a menu that was open a moment ago may still be that
  root.setFocus();
  for (std::size_t i = 0; i < steps && !wanted.empty(); ++i) {
    QWidget* focused = QApplication::focusWidget();
    QTest::keyClick(focused != nullptr ? focused : &root, Qt::Key_Tab);
    wanted.erase(QApplication::focusWidget());
  }
  for (const QWidget* widget : wanted)
    ADD_FAILURE() << page << ": Tab does not reach " << described(*widget);
}

/// Alt and a menu's letter, as the window's language has it.
void expect_menus_open(MainWindow& window, const std::string& page) {
  for (QAction* menu : window.menuBar()->actions()) {
    const QKeySequence letter = QKeySequence::mnemonic(menu->text());
    ASSERT_FALSE(letter.isEmpty()) << menu->text().toStdString();
    const auto key = static_cast<Qt::Key>(letter[0].key());
    QWidget* focused = window.focusWidget() != nullptr ? window.focusWidget() : &window;
    QTest::keyClick(focused, key, Qt::AltModifier);
    EXPECT_TRUE(menu->menu()->isVisible()) << page << ": " << letter.toString().toStdString();
    menu->menu()->close();
    QApplication::setActiveWindow(&window);
  }
}

class Everyone : public testing::Test {
 protected:
  ~Everyone() override { ProgramAppearance().apply({Theme::kLight, QStringLiteral("en")}); }
  static void expect_for_everyone(Studio& studio, const std::string& page) {
    QTest::qWait(200);
    expect_heard(studio.window(), page);
    expect_reached(studio.window(), page);
    ProgramAppearance appearance;
    for (const char* language : {"de", "zh_CN", "en"}) {
      appearance.apply({Theme::kLight, QLatin1String(language)});
      QTest::qWait(30);
      expect_menus_open(studio.window(), page + ", " + language);
    }
  }
};

TEST_F(Everyone, CanUseTheFirstPage) {
  Studio studio;
  expect_for_everyone(studio, "start");
}

TEST_F(Everyone, HearsWhatIsWrong) {
  QWidget window;
  auto* list = new ProblemList(&window);
  auto* column = new QVBoxLayout(&window);
  column->addWidget(list);
  list->set_problems({{Meaning::kBad, "The camera was unplugged.", "Plug it in again.", {}, {}},
                      {Meaning::kDoubtful, "The disk is nearly full.", "", "Make room", {}}});
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  expect_heard(window, "what is wrong", 2);
  expect_reached(window, "what is wrong");
}

TEST_F(Everyone, CanUseThePlaces) {
  StudioOptions options = simulated();
  options.finger = MeasuredFinger::get().folder();
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  expect_for_everyone(studio, "live");
  studio.window().go_to("record");
  expect_for_everyone(studio, "record");
  studio.window().go_to("inspect");
  auto& inspect = *studio.window().findChild<InspectPage*>();
  inspect.open(MadeFingers::get().touched_pictures());
  ASSERT_TRUE(wait_until([&] { return inspect.inspection().frame() != nullptr; }));
  expect_for_everyone(studio, "inspect");
  studio.window().go_to("accuracy");
  auto& accuracy = *studio.window().findChild<AccuracyPage*>();
  ASSERT_TRUE(wait_until([&] { return accuracy.run().study() != nullptr; }));
  expect_for_everyone(studio, "accuracy");
}

TEST_F(Everyone, CanUseEveryStepOfCalibrate) {
  CalibrateStudio rig(4);
  rig.open();
  rig.collection().set_radius(4);
  ASSERT_TRUE(rig.wait_until_looked_at(4));
  rig.run().start();
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  for (const char* step : {"1", "2", "3", "4", "5", "6"}) {
    rig.go_to_step(QLatin1String(step));
    expect_for_everyone(rig.studio(), std::string("step ") + step);
  }
}

TEST_F(Everyone, CanUseTheListOfAllFingers) {
  FingerListDialog dialog({MadeFingers::get().calibrated()});
  dialog.show();
  ASSERT_TRUE(wait_until([&] { return dialog.cards().size() >= 2; }));
  expect_reached(dialog, "all fingers");
  std::set<const QObject*> tree;
  walk(QAccessible::queryAccessibleInterface(&dialog), tree);
  EXPECT_GE(tree.size(), 4U);
}

/// That such a fault would be found.
TEST_F(Everyone, WouldMissWhatHasNoName) {
  QWidget window;
  auto* button = new QPushButton(&window);
  button->resize(40, 40);
  window.resize(100, 100);
  window.show();
  QTest::qWait(20);
  EXPECT_TRUE(is_met(*button));
  QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(button);
  ASSERT_NE(seen, nullptr);
  EXPECT_TRUE(seen->text(QAccessible::Name).isEmpty());
}

}  // namespace
}  // namespace alltact::test
