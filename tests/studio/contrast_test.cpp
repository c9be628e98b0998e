// Contrast as WCAG 2.1 defines it, measured in what is painted: the step one is at among the
// others, what has the focus, the button that comes next.
#include "tests/studio/studio_rig.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/theme.h"

#include <QVBoxLayout>
#include <cmath>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

constexpr double kLeastOfShapes = 3, kLeastOfText = 4.5;

double luminance(QRgb colour) {
  const auto linear = [](int part) {
    const double of = part / 255.0;
    return of <= 0.04045 ? of / 12.92 : std::pow((of + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(qRed(colour)) + 0.7152 * linear(qGreen(colour)) +
         0.0722 * linear(qBlue(colour));
}

double contrast(QRgb a, QRgb b) {
  const double first = luminance(a), second = luminance(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

class Painted : public testing::TestWithParam<Theme> {
 protected:
  Painted() { appearance_.apply({GetParam(), QStringLiteral("en")}); }
  ~Painted() override { appearance_.apply({Theme::kLight, QStringLiteral("en")}); }
  static QImage picture_of(QWidget& widget) {
    widget.show();
    QTest::qWait(30);
    return widget.grab().toImage().convertToFormat(QImage::Format_RGB32);
  }
  /// The largest contrast of a pixel of one with the pixel at the same place of the other.
  static double most_unlike(const QImage& a, const QImage& b) {
    double most = 1;
    for (int y = 0; y < std::min(a.height(), b.height()); ++y)
      for (int x = 0; x < std::min(a.width(), b.width()); ++x)
        most = std::max(most, contrast(a.pixel(x, y), b.pixel(x, y)));
    return most;
  }
  ProgramAppearance appearance_;
};
INSTANTIATE_TEST_SUITE_P(Theme, Painted,
                         testing::Values(Theme::kLight, Theme::kDark, Theme::kHighContrast),
                         [](const auto& theme) {
                           return theme.param == Theme::kLight  ? "light"
                                  : theme.param == Theme::kDark ? "dark"
                                                                : "contrast";
                         });

TEST_P(Painted, TheStepOneIsAtStandsOut) {
  StepList steps;
  steps.resize(600, 40);
  const std::vector<Step> all{{"One", StepState::kToDo, true, {}},
                              {"Two", StepState::kToDo, true, {}}};
  steps.show_steps(all, 0);
  const QImage first = picture_of(steps);
  steps.show_steps(all, 1);
  const QImage second = picture_of(steps);
  EXPECT_GE(most_unlike(first, second), kLeastOfShapes);
}

TEST_P(Painted, WhatHasTheFocusStandsOut) {
  QWidget window;
  auto* column = new QVBoxLayout(&window);
  auto* other = new QPushButton(QStringLiteral("other"));
  auto* plain = new QPushButton(QStringLiteral("plain"));
  auto* next = new QPushButton(QStringLiteral("next"));
  auto* tool = new QToolButton;
  tool->setText(QStringLiteral("tool"));
  tool->setFocusPolicy(Qt::StrongFocus);
  auto* box = new QCheckBox(QStringLiteral("box"));
  set_primary(*next);
  for (QWidget* widget :
       {static_cast<QWidget*>(other), static_cast<QWidget*>(plain), static_cast<QWidget*>(next),
        static_cast<QWidget*>(tool), static_cast<QWidget*>(box)})
    column->addWidget(widget);
  window.resize(240, 240);
  window.show();
  QApplication::setActiveWindow(&window);
  for (QWidget* widget : {static_cast<QWidget*>(plain), static_cast<QWidget*>(next),
                          static_cast<QWidget*>(tool), static_cast<QWidget*>(box)}) {
    other->setFocus(Qt::TabFocusReason);
    const QImage without = picture_of(window).copy(widget->geometry());
    widget->setFocus(Qt::TabFocusReason);
    const QImage with = picture_of(window).copy(widget->geometry());
    EXPECT_GE(most_unlike(without, with), kLeastOfShapes)
        << widget->property("text").toString().toStdString();
  }
}

TEST_P(Painted, WhatComesNextCanBeReadAndIsNoOtherButton) {
  QPushButton next(QStringLiteral("Next")), plain(QStringLiteral("Next"));
  set_primary(next);
  for (QPushButton* button : {&next, &plain}) button->resize(160, 40);
  const QImage filled = picture_of(next);
  const QRgb ground = filled.pixel(8, 20);
  double most = 1;
  for (int y = 0; y < filled.height(); ++y)
    for (int x = 0; x < filled.width(); ++x)
      most = std::max(most, contrast(ground, filled.pixel(x, y)));
  EXPECT_GE(most, kLeastOfText);
  EXPECT_GE(contrast(ground, picture_of(plain).pixel(8, 20)), kLeastOfShapes);
  set_primary(next, false);
  EXPECT_FALSE(is_primary(next));
  EXPECT_EQ(picture_of(next).pixel(8, 20), picture_of(plain).pixel(8, 20));
}

}  // namespace
}  // namespace alltact::test
