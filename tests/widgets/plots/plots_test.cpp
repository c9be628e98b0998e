// Plots are looked at as pictures: what is given must be seen, in every theme, and nothing else.
#include "core/image/colour_map.h"
#include "tests/support/program.h"
#include "widgets/plots/calibration_plots.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/plots/face_map_plot.h"
#include "widgets/plots/press_plots.h"
#include "widgets/theme.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Pixels of about this colour.
int count_of(const QImage& image, const QColor& colour, int tolerance = 40) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor here = image.pixelColor(x, y);
      count += std::abs(here.red() - colour.red()) < tolerance &&
               std::abs(here.green() - colour.green()) < tolerance &&
               std::abs(here.blue() - colour.blue()) < tolerance;
    }
  return count;
}

/// Part of the picture that is not ground: 0 for an empty one.
double inked(const QImage& image) {
  const QColor ground = image.pixelColor(0, 0);
  return 1.0 - static_cast<double>(count_of(image, ground, 2)) / (image.width() * image.height());
}

/// Kept for looking at where ALLTACT_KEEP_PICTURES names a folder.
QImage shown(Plot& plot, const QSize& size, const QString& name) {
  QImage image = plot.image(size, 1.0);
  const QByteArray folder = qgetenv("ALLTACT_KEEP_PICTURES");
  if (!folder.isEmpty()) image.save(QString::fromUtf8(folder) + "/" + name + ".png");
  return image;
}

MappingPlotData some_mapping() {
  MappingPlotData data;
  data.x_max = 0.5;
  for (int i = 0; i <= 50; ++i) {
    const double x = 0.01 * i;
    data.curve.push_back({x, 3.4 * x / (1 + x), 0.02 + 0.04 * x});
    data.points.push_back({x, 3.4 * x / (1 + x) + 0.03 * std::sin(9.0 * i), i % 4 != 0});
  }
  return data;
}

std::vector<PressError> some_errors(int count) {
  std::vector<PressError> errors;
  for (int i = 0; i < count; ++i)
    errors.push_back(
        {"press_" + std::to_string(i), 0.01 + 0.002 * (i * 7 % count), 0.012 + 0.001 * i});
  return errors;
}

FaceMapData some_face() {
  FaceCells cells(115, 24, 1.0);
  for (int u = 10; u < 40; ++u)
    for (int v = -6; v < 4; ++v) cells.add(u + 0.5, v + 0.5, 0.001 * u);
  FaceMapData data = cells.map();
  data.quantity = "Residual (mm)";
  data.contacts = {{25, -1, 8, "press_0"}, {80, 5, 3, "press_1"}};
  return data;
}

HistoryData some_history() {
  HistoryData data;
  data.drifting_above_mm = 0.02;
  data.recalibrate_above_mm = 0.06;
  for (int day = 0; day < 20; ++day)
    data.points.push_back({1.8e9 + 86400.0 * day, 0.005 + 0.0003 * day * day});
  return data;
}

std::vector<double> some_residuals() {
  std::vector<double> errors;
  for (int i = -500; i <= 500; ++i) errors.push_back(1e-8 * i * i * i / 100.0 + 1e-5 * i);
  return errors;
}

class PlotsInThemes : public testing::TestWithParam<Theme> {
 protected:
  void expect_drawn(Plot& plot, const QSize& size, const char* name) {
    plot.setPalette(theme_palette(GetParam()));
    const QString file = QString("%1_%2").arg(name).arg(static_cast<int>(GetParam()));
    const QImage image = shown(plot, size, file);
    EXPECT_EQ(image.size(), size);
    EXPECT_EQ(image.pixelColor(0, 0), plot.palette().color(QPalette::Base)) << name;
    EXPECT_GT(inked(image), 0.03) << name;
    // Axis and letters.
    EXPECT_GT(count_of(image, plot.palette().color(QPalette::Text)), 300) << name;
    EXPECT_EQ(shown(plot, size, file), image) << name << ": the same data, another picture";
    EXPECT_EQ(plot.image(size, 2.0).size(), 2 * size) << name;
  }
};
INSTANTIATE_TEST_SUITE_P(Theme, PlotsInThemes,
                         testing::Values(Theme::kLight, Theme::kDark, Theme::kHighContrast));

double luminance(const QColor& colour) {
  const auto linear = [](double part) {
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
         0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const double first = luminance(a), second = luminance(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

/// Names and circles over a map can be seen on each of its colours, from purple to yellow.
TEST_P(PlotsInThemes, NotesAndCirclesStandOutOnEveryColourOfTheMap) {
  FaceMapPlot plot;
  plot.setPalette(theme_palette(GetParam()));
  FaceMapData data = some_face();
  data.contacts.push_back({60, 0, 4, "press_2", true});
  plot.set_data(data);
  ASSERT_FALSE(plot.image({600, 300}).isNull());
  const auto* chart = plot.findChild<QCustomPlot*>();
  int notes = 0;
  std::map<std::pair<double, double>, std::vector<QColor>> circles;
  for (int i = 0; i < chart->itemCount(); ++i) {
    if (auto* circle = qobject_cast<QCPItemEllipse*>(chart->item(i)))
      circles[{circle->topLeft->coords().x(), circle->topLeft->coords().y()}].push_back(
          circle->pen().color());
    const auto* note = qobject_cast<QCPItemText*>(chart->item(i));
    if (note == nullptr) continue;
    ++notes;
    const QColor ground = note->brush().color();
    ASSERT_NE(note->brush().style(), Qt::NoBrush);
    for (int step = 0; step <= 10; ++step) {
      const MapColour map = viridis(step / 10.0);
      const auto mixed = [&](int over, int under) {
        return static_cast<int>(ground.alphaF() * over + (1 - ground.alphaF()) * under);
      };
      const QColor behind(mixed(ground.red(), map.red), mixed(ground.green(), map.green),
                          mixed(ground.blue(), map.blue));
      EXPECT_GE(contrast(note->color(), behind), 4.5) << note->text().toStdString();
    }
  }
  EXPECT_EQ(notes, 3);
  ASSERT_EQ(circles.size(), 3U);
  for (const auto& [where, lines] : circles) {
    ASSERT_GE(lines.size(), 2U) << "a line and its edge";
    EXPECT_GE(contrast(lines[0], lines[1]), 3);
    for (int step = 0; step <= 10; ++step) {
      const MapColour map = viridis(step / 10.0);
      const QColor behind(map.red, map.green, map.blue);
      EXPECT_GE(std::max(contrast(lines[0], behind), contrast(lines[1], behind)), 3);
    }
  }
}

/// Measured values and what is expected of them have the same two colours in every plot.
TEST_P(PlotsInThemes, HaveTheColoursOfTheirRoles) {
  const QPalette palette = theme_palette(GetParam());
  const QColor measured = role_colour(ColourRole::kMeasured, palette),
               expected = role_colour(ColourRole::kExpected, palette);
  MappingPlot mapping;
  mapping.set_data(some_mapping());
  PressErrorPlot errors;
  errors.set_data(some_errors(6));
  HistoryPlot history;
  history.set_data(some_history());
  for (Plot* plot : std::initializer_list<Plot*>{&mapping, &errors, &history}) {
    plot->setPalette(palette);
    const QImage image = plot->image({600, 400});
    const std::string name = plot->accessibleName().toStdString();
    // The points of the mapping are translucent.
    if (plot != &mapping) {
      EXPECT_GT(count_of(image, measured, 12), 100) << name;
    }
    if (plot != &history) {
      EXPECT_GT(count_of(image, expected, 12), 100) << name;
    }
  }
}

/// Shown it has its title above the axes; an image for a document has none.
TEST(Plots, HaveTheirTitleWhereTheyAreShown) {
  MappingPlot mapping;
  mapping.set_data(some_mapping());
  PressErrorPlot errors;
  errors.set_data(some_errors(6));
  PressLightPlot light;
  light.set_data({{"press_0", 1.5}, {"press_1", -0.5}}, 2);
  FaceMapPlot face;
  face.set_data(some_face());
  HistogramPlot histogram;
  histogram.set_data(some_residuals(), "Residual (mm)");
  HistoryPlot history;
  history.set_data(some_history());
  for (Plot* plot :
       std::initializer_list<Plot*>{&mapping, &errors, &light, &face, &histogram, &history}) {
    plot->resize(500, 360);
    plot->show();
    QTest::qWait(60);
    const auto* chart = plot->findChild<QCustomPlot*>();
    const auto title = [&]() -> QCPTextElement* {
      for (int i = 0; i < chart->plotLayout()->elementCount(); ++i)
        if (auto* text = qobject_cast<QCPTextElement*>(chart->plotLayout()->elementAt(i)))
          return text;
      return nullptr;
    };
    ASSERT_NE(title(), nullptr) << plot->accessibleName().toStdString();
    EXPECT_FALSE(title()->text().isEmpty());
    EXPECT_EQ(title()->text(), plot->accessibleName());
    EXPECT_LE(title()->outerRect().bottom(), chart->axisRect()->rect().top());
    plot->resize(500, 170);
    QTest::qWait(60);
    if (chart->legend->visible()) {
      EXPECT_EQ(title(), nullptr) << "the axes need the room";
    }
    plot->resize(500, 360);
    QTest::qWait(60);
    ASSERT_NE(title(), nullptr);
    const int top = chart->axisRect()->rect().top();
    const QImage image = plot->image({500, 360});
    EXPECT_NE(title(), nullptr) << "it is shown as before";
    plot->hide();
    EXPECT_EQ(plot->image({500, 360}), image) << "without the title, shown or not";
    EXPECT_EQ(title(), nullptr);
    EXPECT_LT(chart->axisRect()->rect().top(), top + 1);
  }
}

TEST_P(PlotsInThemes, AreDrawn) {
  MappingPlot mapping;
  mapping.set_data(some_mapping());
  expect_drawn(mapping, {600, 340}, "mapping");
  PressErrorPlot errors;
  errors.set_data(some_errors(6));
  expect_drawn(errors, {600, errors.comfortable_height()}, "errors");
  FaceMapPlot face;
  face.set_data(some_face());
  expect_drawn(face, {600, 180}, "face");
  HistoryPlot history;
  history.set_data(some_history());
  expect_drawn(history, {600, 300}, "history");
  PressLightPlot light;
  light.set_data({{"a", 1.5}, {"b", -4}, {"c", 0.2}}, 2);
  expect_drawn(light, {600, 190}, "light");
  HistogramPlot histogram;
  histogram.set_data(some_residuals(), "Mapping minus ball (mm)");
  expect_drawn(histogram, {600, 260}, "histogram");
}

TEST(Plots, SayInWordsThatThereIsNothing) {
  MappingPlot mapping;
  PressErrorPlot errors;
  FaceMapPlot face;
  HistoryPlot history;
  HistogramPlot histogram;
  mapping.set_data({});
  errors.set_data({});
  face.set_data({});
  history.set_data({});
  histogram.set_data({kNaN}, "mm");
  int i = 0;
  for (Plot* plot : std::initializer_list<Plot*>{&mapping, &errors, &face, &history, &histogram}) {
    plot->setPalette(theme_palette(Theme::kLight));
    const QImage image = shown(*plot, {400, 200}, QString("empty_%1").arg(i++));
    EXPECT_GT(inked(image), 0.002);
    EXPECT_LT(inked(image), 0.05);  // a sentence, no axes
  }
}

TEST(MappingPlot, DrawsCurveAndPointsWhereTheyAre) {
  MappingPlot plot;
  plot.setPalette(theme_palette(Theme::kLight));
  MappingPlotData data = some_mapping();
  plot.set_data(data);
  const QColor curve = series_colour(1, plot.palette());
  const QImage with = plot.image({600, 340});
  data.points.clear();
  plot.set_data(data);
  const QImage without = plot.image({600, 340});
  int changed = 0;
  for (int y = 150; y < 280; ++y)  // below the legend, above the axis
    for (int x = 60; x < 590; ++x) changed += with.pixel(x, y) != without.pixel(x, y);
  EXPECT_GT(changed, 100);
  EXPECT_GT(count_of(without, curve), 200);
}

TEST(PressErrorPlot, CutsOffTheGoodEndAndKeepsAllThatIsAskedFor) {
  PressErrorPlot few, many;
  few.set_data(some_errors(3));
  many.set_data(some_errors(200));
  EXPECT_LT(few.comfortable_height(), many.comfortable_height());
  EXPECT_LT(many.comfortable_height(), 1200);
  EXPECT_EQ(few.accessibleDescription().toStdString(),
            "The worst of 3 press(es) is press_2 with 0.014 mm.");
}

/// The rows of three presses, from the top: press_2, press_1, press_0.
TEST(PressErrorPlot, ChoosesByKeysAsAListDoes) {
  PressErrorPlot plot;
  plot.enable_choice();
  plot.set_data(some_errors(3));
  std::vector<std::string> chosen, opened;
  QObject::connect(&plot, &PressErrorPlot::press_chosen,
                   [&](const auto& press) { chosen.push_back(press); });
  QObject::connect(&plot, &PressErrorPlot::press_opened,
                   [&](const auto& press) { opened.push_back(press); });
  for (const auto key : {Qt::Key_Return, Qt::Key_Down, Qt::Key_Down, Qt::Key_Up, Qt::Key_Up,
                         Qt::Key_End, Qt::Key_Down, Qt::Key_Return, Qt::Key_Escape})
    QTest::keyClick(&plot, key);
  EXPECT_THAT(chosen,
              testing::ElementsAre("press_2", "press_1", "press_2", "press_0", std::string()));
  EXPECT_THAT(opened, testing::ElementsAre("press_0"));
  plot.choose("press_1");
  EXPECT_EQ(chosen.size(), 5U) << "only a hand is told of";
  plot.set_data(some_errors(5));
  EXPECT_EQ(plot.chosen(), "press_1");
  plot.set_data(some_errors(1));
  EXPECT_EQ(plot.chosen(), "");
}

TEST(PressErrorPlot, TheRowUnderThePointerIsChosenAndFramed) {
  PressErrorPlot plot;
  plot.setPalette(theme_palette(Theme::kLight));
  plot.enable_choice();
  plot.set_data(some_errors(3));
  plot.resize(600, 300);
  plot.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&plot));
  QTest::qWait(100);
  const QImage before = plot.grab().toImage();
  auto* chart = plot.findChild<QCustomPlot*>();
  const auto rows = [&](double row) {
    return QPoint(chart->axisRect()->left() + 5,
                  static_cast<int>(std::lround(chart->yAxis->coordToPixel(row))));
  };
  for (const auto& [row, press] : std::map<double, std::string>{
           {0, "press_0"}, {0.4, "press_0"}, {0.6, "press_1"}, {2.3, "press_2"}}) {
    QTest::mouseClick(chart, Qt::LeftButton, Qt::NoModifier, rows(row));
    EXPECT_EQ(plot.chosen(), press) << row;
  }
  QTest::qWait(100);
  const QImage after = plot.grab().toImage();
  const QColor frame = plot.palette().color(QPalette::Highlight);
  EXPECT_GT(count_of(after, frame, 20), count_of(before, frame, 20) + 500);
  QTest::mouseClick(chart, Qt::LeftButton, Qt::NoModifier, QPoint(300, 295));
  EXPECT_EQ(plot.chosen(), "") << "below the rows";
}

TEST(FaceMapPlot, AClickTellsOfTheSmallestContactThere) {
  FaceMapPlot plot;
  plot.enable_choice();
  FaceMapData data = some_face();
  data.contacts = {{20, 0, 6, ""}, {23, 0, 2, ""}, {60, 4, 3, ""}};
  plot.set_data(data);
  plot.resize(700, 260);
  plot.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&plot));
  QTest::qWait(100);
  std::vector<std::size_t> chosen;
  QObject::connect(&plot, &FaceMapPlot::contact_chosen,
                   [&](std::size_t contact) { chosen.push_back(contact); });
  auto* chart = plot.findChild<QCustomPlot*>();
  const auto click = [&](double along_mm, double across_mm) {
    QTest::mouseClick(chart, Qt::LeftButton, Qt::NoModifier,
                      QPoint(static_cast<int>(std::lround(chart->xAxis->coordToPixel(along_mm))),
                             static_cast<int>(std::lround(chart->yAxis->coordToPixel(across_mm)))));
  };
  click(16, 0);
  click(23, 1);
  click(60, 2);
  click(60, -2);
  click(45, 0);
  EXPECT_THAT(chosen, testing::ElementsAre(0, 1, 2));
}

TEST(FaceMapPlot, ShowsWhatIsKnownAndOnlyThat) {
  FaceMapPlot plot;
  plot.setPalette(theme_palette(Theme::kLight));
  FaceMapData data = some_face();
  data.contacts.clear();
  plot.set_data(data);
  const QImage image = plot.image({700, 220});
  // The largest value has the brightest colour of the map, and the colour bar beside it.
  EXPECT_GT(count_of(image, QColor("#fde725"), 25), 100);
  data.cells.assign(data.cells.size(), kNaN);
  plot.set_data(data);
  EXPECT_LT(count_of(plot.image({700, 220}), QColor("#31688e"), 25),
            count_of(image, QColor("#31688e"), 25) / 2);
}

TEST(FaceMapPlot, CanBeGivenDataAgainAndAgain) {
  FaceMapPlot plot;
  plot.setPalette(theme_palette(Theme::kLight));
  plot.set_data(some_face());
  const QImage first = plot.image({600, 180});
  for (int i = 0; i < 5; ++i) plot.set_data(i % 2 == 0 ? FaceMapData{} : some_face());
  plot.set_data(some_face());
  EXPECT_EQ(plot.image({600, 180}), first);
}

TEST(FaceCells, AreMeansOfWhatLiesInThem) {
  FaceCells cells(10, 4, 1.0);
  cells.add(0.5, -1.5, 2);
  cells.add(0.7, -1.2, 4);
  cells.add(9.9, 1.9, 7);
  for (const double off : {-0.1, 10.1}) cells.add(off, 0, 1000);
  for (const double off : {-2.1, 2.1}) cells.add(5, off, 1000);
  const FaceMapData map = cells.map();
  ASSERT_EQ(map.columns, 10);
  ASSERT_EQ(map.rows, 4);
  EXPECT_EQ(map.cells[0], 3);
  EXPECT_EQ(map.cells[39], 7);
  EXPECT_EQ(std::count_if(map.cells.begin(), map.cells.end(), [](double v) { return v == v; }), 2);
}

TEST(HistogramPlot, KnowsWhatMostErrorsStayBelow) {
  std::vector<double> errors;
  for (int i = 1; i <= 1000; ++i) errors.push_back(i % 2 == 0 ? 0.001 * i : -0.001 * i);
  errors.push_back(kNaN);
  HistogramPlot plot;
  plot.set_data(errors, "mm");
  EXPECT_NEAR(plot.error_95_mm(), 0.95, 0.001);
}

TEST(HistoryPlot, BandsAreSeenAndOneCheckIsEnough) {
  HistoryPlot plot;
  plot.setPalette(theme_palette(Theme::kLight));
  HistoryData data = some_history();
  data.points.resize(1);
  plot.set_data(data);
  const QImage image = shown(plot, {600, 300}, "history_one");
  std::set<QRgb> grounds;
  for (int y = 10; y < 240; ++y) grounds.insert(image.pixel(300, y));
  EXPECT_GE(grounds.size(), 3U);
}

TEST(HistoryPlot, DatesNeverRunIntoEachOther) {
  constexpr double kHour_s = 3600, kDay_s = 24 * kHour_s, kStart_s = 1795000000;  // in 2026
  for (const double span_s :
       {kHour_s, kDay_s, 3 * kDay_s, 10 * kDay_s, 100 * kDay_s, 1100 * kDay_s})
    for (const int width_px : {260, 330, 600}) {
      HistoryPlot plot;
      HistoryData data = some_history();
      data.points.resize(2);
      data.points[0].time_s = kStart_s;
      data.points[1].time_s = kStart_s + span_s;
      plot.set_data(data);
      shown(plot, {width_px, 240}, "history_dates");
      const QCPAxis* axis = plot.findChild<QCustomPlot*>()->xAxis;
      QVector<double> ticks;
      QVector<QString> labels;
      axis->ticker()->generate(axis->range(), QLocale::c(), 'g', 6, ticks, nullptr, &labels);
      const QFontMetrics metrics(axis->tickLabelFont());
      double end_px = -1e9;
      for (int i = 0; i < ticks.size(); ++i) {
        if (!axis->range().contains(ticks[i])) continue;
        const double half_px = 0.5 * metrics.size(0, labels[i]).width();
        const double at_px = axis->coordToPixel(ticks[i]);
        EXPECT_GE(at_px - half_px, end_px + 3) << labels[i].toStdString() << ", " << span_s / kDay_s
                                               << " days in " << width_px << " px";
        end_px = at_px + half_px;
      }
    }
}

TEST(Plots, ArePrintedAsPdf) {
  const test::TemporaryFolder folder;
  MappingPlot plot;
  plot.set_data(some_mapping());
  const std::string file = folder / "plot.pdf";
  EXPECT_TRUE(plot.save_pdf(QString::fromStdString(file), {600, 340}));
  EXPECT_THAT(test::text_of(file), testing::StartsWith("%PDF"));
  EXPECT_FALSE(plot.save_pdf(QString::fromStdString(folder / "none/plot.pdf"), {600, 340}));
}

TEST(ConvergencePlot, ShowsBothFiguresOfEveryRoundAndGrows) {
  ConvergencePlot plot;
  const QSize size(420, 240);
  EXPECT_LT(inked(shown(plot, size, "convergence_empty")), 0.06);
  std::vector<Round> rounds;
  int before = 0;
  for (int i = 0; i < 6; ++i) {
    rounds.push_back({i + 1, 0.05 / (i + 1), std::pow(10, -i)});
    plot.set_rounds(rounds);
    const QImage image = shown(plot, size, "convergence");
    const int residual = count_of(image, series_colour(0, plot.palette()));
    EXPECT_GT(count_of(image, series_colour(2, plot.palette())), 20);
    if (i == 5) {
      EXPECT_GT(residual, before) << "a line where there was a dot";
    }
    if (i == 0) before = residual;
  }
  EXPECT_TRUE(plot.accessibleDescription().startsWith(
      QStringLiteral("Residual after 6 round(s): 0.0083 mm")));
}

}  // namespace
}  // namespace alltact
