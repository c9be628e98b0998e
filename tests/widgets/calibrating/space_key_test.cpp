// The space bar, wherever the focus is.
#include "widgets/calibrating/press_list.h"
#include "widgets/calibrating/step_page.h"

#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QStringListModel>
#include <QTest>
#include <QVBoxLayout>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// A page with everything that keys may be typed into.
struct Page {
  Page() {
    auto* column = new QVBoxLayout(&window);
    for (QWidget* widget : std::initializer_list<QWidget*>{&button, &number, &line})
      column->addWidget(widget);
    button.connect(&button, &QPushButton::clicked, [this] { ++clicks; });
    window.show();
    QApplication::setActiveWindow(&window);
    static_cast<void>(QTest::qWaitForWindowExposed(&window));
  }
  void press_space() { QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space); }
  QWidget window;
  QPushButton button{"Other"};
  QDoubleSpinBox number;
  QLineEdit line;
  int acts = 0, clicks = 0;
  SpaceKey key{window, [this] { ++acts; }};
};

TEST(SpaceKey, AButtonThatWasClickedHasBeenUsed) {
  Page page;
  QTest::mouseClick(&page.button, Qt::LeftButton);
  page.button.setFocus(Qt::MouseFocusReason);
  EXPECT_EQ(page.clicks, 1);
  page.press_space();
  EXPECT_EQ(page.acts, 1);
  EXPECT_EQ(page.clicks, 1);
  // Gone to by keys it is pressed by them, as everywhere.
  page.line.setFocus();
  page.button.setFocus(Qt::TabFocusReason);
  page.press_space();
  EXPECT_EQ(page.acts, 1);
  EXPECT_EQ(page.clicks, 2);
}

TEST(SpaceKey, TypesIntoNoNumberAndLeavesWordsAlone) {
  Page page;
  page.number.setValue(4);
  page.number.setFocus(Qt::MouseFocusReason);
  page.press_space();
  EXPECT_EQ(page.acts, 1);
  EXPECT_EQ(page.number.value(), 4);
  page.line.setFocus();
  QTest::keyClicks(&page.line, "Ada L");
  EXPECT_EQ(page.acts, 1);
  EXPECT_EQ(page.line.text(), "Ada L");
}

TEST(PressListView, ChoosesNoneBecauseTheFocusCameBy) {
  QStringListModel model({"press_01", "press_02"});
  PressListView list;
  list.setModel(&model);
  list.show();
  QApplication::setActiveWindow(&list);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&list));
  int chosen = 0;
  QObject::connect(list.selectionModel(), &QItemSelectionModel::currentChanged,
                   [&](const QModelIndex& now) { chosen += now.isValid() ? 1 : 0; });
  list.setFocus(Qt::TabFocusReason);
  EXPECT_EQ(chosen, 0);
  EXPECT_FALSE(list.currentIndex().isValid());
  QTest::keyClick(&list, Qt::Key_Down);
  EXPECT_EQ(chosen, 1) << "keys choose";
  EXPECT_EQ(list.palette().color(QPalette::Inactive, QPalette::Highlight),
            list.palette().color(QPalette::Active, QPalette::Highlight))
      << "marked without the focus, too";
}

}  // namespace
}  // namespace alltact
