// The age of the picture is read at a glance: what is late has a sign and a colour of its own.
#include "widgets/theme.h"
#include "widgets/widget_base.h"

#include <QApplication>

#include <gtest/gtest.h>

namespace alltact {
namespace {

QColor colour_of(const AgeLabel& label) { return label.palette().color(QPalette::WindowText); }

TEST(AgeLabelTest, StandsOutAbove200Milliseconds) {
  AgeLabel label;
  const QColor usual = colour_of(label);
  const QString sign = QString(QChar(0x25b2)) + " ";
  for (const auto& [age_ms, text] :
       std::vector<std::pair<double, QString>>{{26, "image 26 ms old"},
                                               {200, "image 200 ms old"},
                                               {201, sign + "image 201 ms old"},
                                               {12345, sign + "image 12.3 s old"},
                                               {5, "image 5 ms old"}}) {
    label.show_age(age_ms);
    EXPECT_EQ(label.text().toStdString(), text.toStdString());
    EXPECT_EQ(label.toolTip().isEmpty(), !text.startsWith(sign)) << age_ms;
    EXPECT_EQ(colour_of(label), text.startsWith(sign)
                                    ? meaning_colour(Meaning::kBad, QApplication::palette())
                                    : usual)
        << age_ms;
  }
  label.show_age(std::nullopt);
  EXPECT_EQ(label.text().toStdString(), "images without timestamps");
}

TEST(AgeLabelTest, TakesTheColourOfANewTheme) {
  const QPalette before = QApplication::palette();
  AgeLabel label;
  label.show_age(500);
  for (const Theme theme : {Theme::kDark, Theme::kHighContrast, Theme::kLight}) {
    const QPalette palette = theme_palette(theme);
    QApplication::setPalette(palette);
    QApplication::processEvents();
    EXPECT_EQ(colour_of(label), meaning_colour(Meaning::kBad, palette)) << static_cast<int>(theme);
  }
  QApplication::setPalette(before);
}

}  // namespace
}  // namespace alltact
