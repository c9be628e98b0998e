// The figure of accuracy over time: its dots are the table's rows, its words keep apart, and keys
// do what the mouse does.
#include "widgets/accuracy/accuracy_plot.h"

#include <QAbstractItemModelTester>
#include <QAccessible>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// A front of `front` points, and twice as many that are worse; the last is far slower.
std::vector<AccuracyPoint> some_points(std::mt19937& random, int front) {
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<AccuracyPoint> points;
  for (int i = 0; i < 3 * front; ++i) {
    AccuracyPoint point;
    const bool is_on_front = i < front;
    const double step = (i % front + 0.3 * uniform(random)) / front;
    point.time_ms = 1 + 3 * step + (is_on_front ? 0 : uniform(random));
    point.median_mm = 0.02 - 0.015 * step + (is_on_front ? 0 : 0.01 * uniform(random));
    point.p95_mm = 3 * point.median_mm;
    if (i % 4 != 0) point.position_mm = 0.1 * uniform(random);
    point.is_on_front = is_on_front;
    point.is_in_use = i == front;
    point.words = QStringLiteral("edges from %1 columns, smoothing of %2 px").arg(i + 1).arg(i % 4);
    point.hint = QStringLiteral("hint %1").arg(i);
    if (!is_on_front) point.dominated_by = static_cast<std::size_t>(i % front);
    points.push_back(point);
  }
  points.back().time_ms = 400;
  return points;
}

class AccuracyFigure : public testing::Test {
 protected:
  void show(AccuracyPlot& plot, int front = 6) {
    points_ = some_points(random_, front);
    plot.set_points(points_);
    plot.resize(900, 420);
    plot.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&plot));
    QTest::qWait(30);
  }
  std::mt19937 random_{3};
  std::vector<AccuracyPoint> points_;
};

TEST_F(AccuracyFigure, HasADotForEveryRowOfTheTable) {
  AccuracyPlot plot;
  show(plot);
  AccuracyTable table;
  table.set_points(points_);
  const auto* view = table.findChild<QTableView*>();
  const auto dots = plot.dots();
  ASSERT_EQ(view->model()->rowCount(), static_cast<int>(points_.size()));
  ASSERT_EQ(dots.size(), points_.size());
  auto* model = table.findChild<AccuracyModel*>();
  const QAbstractItemModelTester tester(model);
  int beyond = 0;
  for (int row = 0; row < model->rowCount(); ++row) {
    const auto& dot = dots[static_cast<std::size_t>(row)];
    const double time_ms =
        model->index(row, AccuracyModel::kTime).data(AccuracyModel::kSortRole).toDouble();
    if (!dot) {
      ++beyond;
      EXPECT_EQ(time_ms, 400) << "only what is far slower lies beyond";
      continue;
    }
    EXPECT_EQ(dot->x(), time_ms);
    EXPECT_EQ(dot->y(),
              model->index(row, AccuracyModel::kMedian).data(AccuracyModel::kSortRole).toDouble());
    EXPECT_EQ(model->index(row, AccuracyModel::kTime).data().toString(),
              QLocale().toString(dot->x(), 'f', 2));
  }
  EXPECT_EQ(beyond, 1);
}

TEST_F(AccuracyFigure, NamesAtMostSevenWithoutOverlap) {
  for (const int front : {2, 5, 9, 14}) {
    AccuracyPlot plot;
    show(plot, front);
    for (const QSize size : {QSize(560, 330), QSize(900, 420), QSize(1250, 620)}) {
      plot.resize(size);
      QTest::qWait(30);
      const auto labels = plot.label_boxes();
      EXPECT_LE(labels.size(), AccuracyPlot::kMaxLabels);
      EXPECT_GE(labels.size(), 2U) << front;
      for (std::size_t i = 0; i < labels.size(); ++i) {
        EXPECT_TRUE(QRectF(plot.rect()).contains(labels[i]));
        for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(labels[i].intersects(labels[k]));
      }
    }
  }
}

TEST(LabelPlaces, OverlapNothingAndAreGivenUpWhereThereIsNoRoom) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(0, 600), y(0, 300), width(40, 170);
  int placed = 0, given_up = 0;
  for (int run = 0; run < 100; ++run) {
    std::vector<LabelRequest> labels;
    std::vector<QRectF> taken;
    for (int i = 0; i < 12; ++i) {
      labels.push_back({{x(random), y(random)}, {width(random), 30}});
      taken.emplace_back(labels.back().dot - QPointF(5, 5), QSizeF(10, 10));
    }
    const QRectF room(0, 0, 600, 300);
    const auto places = layout_labels(room, labels, taken);
    ASSERT_EQ(places.size(), labels.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!places[i]) {
        ++given_up;
        continue;
      }
      ++placed;
      EXPECT_EQ(places[i]->size(), labels[i].size);
      EXPECT_TRUE(room.contains(*places[i]));
      for (const QRectF& other : taken) EXPECT_FALSE(places[i]->intersects(other));
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_FALSE(places[k] && places[i]->intersects(*places[k]));
    }
  }
  EXPECT_GT(placed, 20 * given_up);
  EXPECT_EQ(layout_labels({0, 0, 50, 20}, {{{25, 10}, {100, 30}}}, {}).front(), std::nullopt);
}

TEST_F(AccuracyFigure, IsPickedByMouseAndKeysAlike) {
  AccuracyPlot plot;
  show(plot, 6);
  QSignalSpy picked(&plot, &AccuracyPlot::point_picked),
      taken(&plot, &AccuracyPlot::point_activated), dropped(&plot, &AccuracyPlot::pick_cleared);
  for (const std::size_t point : {std::size_t{2}, std::size_t{4}}) {
    const QPoint place = plot.dot_pixel(point);
    QWidget* chart = plot.childAt(place);
    ASSERT_NE(chart, nullptr);
    QTest::mouseClick(chart, Qt::LeftButton, {}, chart->mapFrom(&plot, place));
    EXPECT_EQ(plot.picked(), point);
  }
  EXPECT_EQ(picked.size(), 2);
  QTest::keyClick(&plot, Qt::Key_Home);
  EXPECT_EQ(plot.picked(), 0U);
  for (std::size_t next = 1; next < 6; ++next) {
    QTest::keyClick(&plot, Qt::Key_Right);
    EXPECT_EQ(plot.picked(), next) << "along the front";
  }
  QTest::keyClick(&plot, Qt::Key_Right);
  EXPECT_EQ(plot.picked(), 5U) << "which ends there";
  QTest::keyClick(&plot, Qt::Key_Left);
  EXPECT_EQ(plot.picked(), 4U);
  EXPECT_EQ(taken.size(), 0);
  QTest::keyClick(&plot, Qt::Key_Return);
  EXPECT_EQ(taken.size(), 1);
  QTest::keyClick(&plot, Qt::Key_Escape);
  EXPECT_EQ(dropped.size(), 1);
}

TEST_F(AccuracyFigure, IsToldInWords) {
  AccuracyPlot plot;
  show(plot, 6);
  plot.pick(3);
  QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(&plot);
  ASSERT_NE(seen, nullptr);
  EXPECT_EQ(seen->text(QAccessible::Name), "Error versus time per image");
  EXPECT_EQ(seen->role(), QAccessible::Chart);
  EXPECT_TRUE(seen->text(QAccessible::Value).contains(points_[3].words));
}

TEST_F(AccuracyFigure, TheTableIsSortedByKeysAlone) {
  points_ = some_points(random_, 5);
  AccuracyTable table;
  table.set_points(points_);
  table.resize(900, 400);
  table.show();
  auto* sort = table.findChild<QComboBox*>();
  auto* view = table.findChild<QTableView*>();
  sort->setFocus();
  const auto column = [&](int number) {
    std::vector<double> values;
    for (int row = 0; row < view->model()->rowCount(); ++row)
      values.push_back(view->model()->index(row, number).data(AccuracyModel::kSortRole).toDouble());
    return values;
  };
  const auto times = column(AccuracyModel::kTime);
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  QTest::keyClick(sort, Qt::Key_Down);  // the next column
  const auto errors = column(AccuracyModel::kMedian);
  EXPECT_TRUE(std::is_sorted(errors.begin(), errors.end()));
  QSignalSpy picked(&table, &AccuracyTable::point_picked);
  view->setFocus();
  view->setCurrentIndex(view->model()->index(0, 0));
  ASSERT_EQ(picked.size(), 1);
  const auto point = picked.front().front().value<std::size_t>();
  EXPECT_EQ(points_[point].median_mm, errors.front()) << "the row of the point, however sorted";
}

}  // namespace
}  // namespace alltact
