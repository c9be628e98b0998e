#include "widgets/theme.h"

#include <QGuiApplication>
#include <array>

namespace alltact {
namespace {

struct Colours {
  QColor window, base, alternate, text, disabled, button, highlight, highlighted_text, link;
};

QPalette made_of(const Colours& colours) {
  QPalette palette;
  palette.setColor(QPalette::Window, colours.window);
  palette.setColor(QPalette::WindowText, colours.text);
  palette.setColor(QPalette::Base, colours.base);
  palette.setColor(QPalette::AlternateBase, colours.alternate);
  palette.setColor(QPalette::ToolTipBase, colours.base);
  palette.setColor(QPalette::ToolTipText, colours.text);
  palette.setColor(QPalette::PlaceholderText, colours.disabled);
  palette.setColor(QPalette::Text, colours.text);
  palette.setColor(QPalette::Button, colours.button);
  palette.setColor(QPalette::ButtonText, colours.text);
  palette.setColor(QPalette::BrightText, colours.highlighted_text);
  palette.setColor(QPalette::Light, colours.button.lighter(130));
  palette.setColor(QPalette::Midlight, colours.button.lighter(115));
  palette.setColor(QPalette::Mid, colours.button.darker(130));
  palette.setColor(QPalette::Dark, colours.button.darker(160));
  palette.setColor(QPalette::Shadow, colours.button.darker(300));
  palette.setColor(QPalette::Highlight, colours.highlight);
  palette.setColor(QPalette::HighlightedText, colours.highlighted_text);
  palette.setColor(QPalette::Link, colours.link);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, colours.disabled);
  return palette;
}

const Colours kLight{"#f4f5f6",
                     "#ffffff",
                     "#eef0f2",
                     "#16191d",
                     "#72787f",
                     "#e6e8eb",
                     "#0b5fa5",
                     "#ffffff",
                     "#0b5fa5"};
const Colours kDark{"#202327",
                    "#17191c",
                    "#1d2024",
                    "#e8eaed",
                    "#8b929a",
                    "#2c3036",
                    "#4294de",
                    "#0b0d0f",
                    "#7fbdf2"};
const Colours kContrast{"#000000",
                        "#000000",
                        "#000000",
                        "#ffffff",
                        "#b0b0b0",
                        "#000000",
                        "#ffe600",
                        "#000000",
                        "#7fd4ff"};

}  // namespace

QFont text_font(const QFont& body, TextSize size) {
  QFont font = body;
  const double larger = size == TextSize::kSmall     ? 0.9
                        : size == TextSize::kBody    ? 1.0
                        : size == TextSize::kHeading ? 1.25
                                                     : 1.6;
  font.setPointSizeF(larger * body.pointSizeF());
  font.setBold(size == TextSize::kHeading || size == TextSize::kTitle);
  return font;
}

QPalette theme_palette(Theme theme) {
  switch (theme) {
    case Theme::kLight:
      return made_of(kLight);
    case Theme::kDark:
      return made_of(kDark);
    case Theme::kHighContrast:
      return made_of(kContrast);
    case Theme::kSystem:
      break;
  }
  static const QPalette as_started = QGuiApplication::palette();
  return as_started;
}

bool is_dark(const QPalette& palette) {
  return palette.color(QPalette::WindowText).lightness() >
         palette.color(QPalette::Window).lightness();
}

QColor series_colour(int index, const QPalette& palette) {
  static const std::array<QColor, 6> on_light{
      "#0072b2", "#d55e00", "#007a5a", "#a8528a", "#8a6500", "#4c5158"};
  static const std::array<QColor, 6> on_dark{
      "#56b4e9", "#f0915a", "#2fc79b", "#e09ac6", "#e6b93c", "#b4bac2"};
  const auto& colours = is_dark(palette) ? on_dark : on_light;
  return colours[static_cast<std::size_t>(index) % colours.size()];
}

QColor meaning_colour(Meaning meaning, const QPalette& palette) {
  const bool dark = is_dark(palette);
  switch (meaning) {
    case Meaning::kGood:
      return dark ? "#2fc79b" : "#007a5a";
    case Meaning::kDoubtful:
      return dark ? "#e6b93c" : "#8a6500";
    case Meaning::kBad:
      break;
  }
  return dark ? "#ff8a7a" : "#b3261e";
}

}  // namespace alltact
