#include "widgets/controls/wheel_rule.h"

#include "widgets/controls/number_field.h"

#include <QApplication>
#include <QComboBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <QtTest/qtestspontaneevent.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

/// A page higher than its window, with a number and a choice at its top.
class WheelOverAPage : public testing::Test {
 protected:
  WheelOverAPage() {
    let_wheel_scroll(*qApp);
    let_wheel_scroll(*qApp);
    auto* column = new QVBoxLayout(page_);
    number_->setRange(0, 100);
    number_->setValue(5);
    choice_->addItems({"one", "two", "three"});
    column->addWidget(number_);
    column->addWidget(choice_);
    column->addSpacing(2000);
    area_.setWidget(page_);
    area_.resize(200, 200);
    area_.show();
    QApplication::setActiveWindow(&area_);
    QApplication::processEvents();
  }
  /// One notch down.
  void turn_wheel_over(QWidget& widget) {
    const QPointF middle = widget.rect().center();
    QWheelEvent event(middle, widget.mapToGlobal(middle), {}, {0, -120}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);  // others stay where they are sent
    qApp->notify(&widget, &event);
  }
  [[nodiscard]] int scrolled() const { return area_.verticalScrollBar()->value(); }

  QScrollArea area_;
  QWidget* page_ = new QWidget;
  NumberField* number_ = new NumberField;
  QComboBox* choice_ = new QComboBox;
};

TEST_F(WheelOverAPage, ScrollsItAndChangesNothing) {
  EXPECT_TRUE(number_->hasFocus()) << "as a page opens";
  int last = 0;
  for (QWidget* field : std::initializer_list<QWidget*>{number_, choice_, number_}) {
    turn_wheel_over(*field);
    EXPECT_GT(scrolled(), last);
    last = scrolled();
  }
  EXPECT_EQ(number_->value(), 5);
  EXPECT_EQ(choice_->currentIndex(), 0);
}

TEST_F(WheelOverAPage, ChangesTheFieldThatSomebodyWentTo) {
  choice_->setFocus();
  number_->setFocus(Qt::MouseFocusReason);
  turn_wheel_over(*number_);
  EXPECT_EQ(number_->value(), 4);
  choice_->setFocus(Qt::TabFocusReason);
  turn_wheel_over(*choice_);
  EXPECT_EQ(choice_->currentIndex(), 1);
  EXPECT_EQ(scrolled(), 0);
}

}  // namespace
}  // namespace alltact::test
