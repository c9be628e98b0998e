// Words of a plot by geometry: none is cut, and none lies over the data.
#include "widgets/plots/calibration_plots.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/plots/press_plots.h"

#include <QTest>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// Width and height that a plot of the mapping page has in windows of 1024 x 700 and larger.
class PlotWords : public testing::TestWithParam<QSize> {
 protected:
  static void style(Plot& plot) {
    plot.resize({2000, 1400});
    plot.show();
    QTest::qWait(30);
    plot.resize(GetParam());  // as a window is made smaller
    QTest::qWait(60);
    auto& chart = *plot.findChild<QCustomPlot*>();
    const QRect data = chart.axisRect()->rect();
    EXPECT_GT(data.width() * data.height(), 0.3 * plot.width() * plot.height()) << "left for data";
    if (chart.legend->visible()) {
      EXPECT_FALSE(chart.legend->outerRect().intersects(data)) << "legend over the data";
      EXPECT_TRUE(plot.rect().contains(chart.legend->outerRect()));
      for (int i = 0; i < chart.legend->itemCount(); ++i) {
        auto* item = qobject_cast<QCPPlottableLegendItem*>(chart.legend->item(i));
        ASSERT_NE(item, nullptr);
        const int words =
            QFontMetrics(chart.legend->font()).horizontalAdvance(item->plottable()->name());
        EXPECT_GE(item->rect().width(), chart.legend->iconSize().width() + words)
            << item->plottable()->name().toStdString() << " is cut";
      }
    }
    const QFontMetrics metrics(chart.xAxis->labelFont());
    for (const QString& line : chart.xAxis->label().split('\n'))
      EXPECT_LE(metrics.horizontalAdvance(line), data.width() + 60) << line.toStdString();
    for (const QString& line : chart.yAxis->label().split('\n'))
      EXPECT_LE(metrics.horizontalAdvance(line), data.height() + 40) << line.toStdString();
  }
};
INSTANTIATE_TEST_SUITE_P(Sizes, PlotWords,
                         testing::Values(QSize(440, 225), QSize(480, 240), QSize(900, 380)),
                         [](const auto& size) { return std::to_string(size.param.width()); });

TEST_P(PlotWords, OfTheMapping) {
  MappingPlotData data;
  data.x_max = 0.5;
  for (int i = 0; i <= 50; ++i) {
    const double x = 0.01 * i;
    data.curve.push_back({x, 3.4 * x / (1 + x), 0.02});
    data.points.push_back({x, 3.4 * x / (1 + x), i % 4 != 0});
  }
  MappingPlot plot;
  plot.set_data(data);
  style(plot);
}

TEST_P(PlotWords, OfTheErrors) {
  std::vector<PressError> errors;
  for (int i = 0; i < 6; ++i) {
    PressError error;
    error.press = "press_0" + std::to_string(i);
    error.residual_mm = 0.001 * (i + 1);
    error.held_out_mm = 0.002 * (i + 1);
    errors.push_back(error);
  }
  PressErrorPlot plot;
  plot.set_data(errors);
  style(plot);
}

}  // namespace
}  // namespace alltact
