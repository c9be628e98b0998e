// The program's appearance: themes (light, dark, high contrast), colours with a meaning, text
// sizes, spacing.
#pragma once

#include <QColor>
#include <QFont>
#include <QIcon>
#include <QPalette>
#include <QProxyStyle>
#include <QPushButton>

namespace alltact {

/// Between two adjacent items, px at scale 1: half of it within an item, twice as much between
/// groups.
inline constexpr int kSpacing = 8;

/// The typographic scale: 0.9, 1, 1.25 and 1.6 times the size of the body.
enum class TextSize { kSmall = 1, kBody, kHeading, kTitle };
/// `body` in that size; headings and titles in bold.
[[nodiscard]] QFont text_font(const QFont& body, TextSize size);

enum class Theme { kSystem = 1, kLight, kDark, kHighContrast };

/// The palette for Qt's Fusion style. kSystem: the desktop's palette, as Qt read it at the start.
[[nodiscard]] QPalette theme_palette(Theme theme);

/// Dark: text is lighter than its background. Qt 6.4 has no function for it.
[[nodiscard]] bool is_dark(const QPalette& palette);

/// Colours that colour-blind people distinguish (Okabe and Ito 2008), the lighter ones on dark
/// backgrounds; meaning never rests on them alone. index >= 0; they repeat after six.
[[nodiscard]] QColor series_colour(int index, const QPalette& palette);

/// What a colour stands for in every plot and drawing. Series without such a role are numbered.
enum class ColourRole {
  kMeasured = 1,  ///< measured, recorded or covered
  kExpected,      ///< what a model, a forecast, a request or an earlier value promises
  kLeftOut,       ///< does not count
  kContact,       ///< something presses
  kChosen         ///< selected by the user
};
[[nodiscard]] QColor role_colour(ColourRole role, const QPalette& palette);

enum class Meaning { kGood = 1, kDoubtful, kBad };
/// For borders and symbols next to text; contrast of at least 3:1 against the palette's window.
[[nodiscard]] QColor meaning_colour(Meaning meaning, const QPalette& palette);

// The project's own symbols, in the palette's colours.

/// `name`: a file of resources/icons without its ending. Sharp at any scale; make it again when the
/// palette changes.
[[nodiscard]] QIcon icon(const QString& name, const QPalette& palette);

/// The same in one given colour.
[[nodiscard]] QPixmap symbol(const QString& name, const QColor& colour, int size, double ratio);

/// The symbol of a meaning; symbols also differ in shape.
[[nodiscard]] QString meaning_symbol(Meaning meaning);

// Qt's Fusion style with visible outlines on dark backgrounds, a visible focus, a primary button,
// and uniform spacing. A group is a title and a line instead of nested boxes.

class StudioStyle : public QProxyStyle {
 public:
  StudioStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget = nullptr) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget = nullptr) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                          QPainter* painter, const QWidget* widget = nullptr) const override;
  [[nodiscard]] QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option,
                                     SubControl part,
                                     const QWidget* widget = nullptr) const override;
  [[nodiscard]] QSize sizeFromContents(ContentsType type, const QStyleOption* option,
                                       const QSize& contents,
                                       const QWidget* widget = nullptr) const override;
  [[nodiscard]] int styleHint(StyleHint hint, const QStyleOption* option = nullptr,
                              const QWidget* widget = nullptr,
                              QStyleHintReturn* more = nullptr) const override;
  [[nodiscard]] int pixelMetric(PixelMetric metric, const QStyleOption* option = nullptr,
                                const QWidget* widget = nullptr) const override;
};

// The primary action of a page: in the colour of the selection, and bold.

/// Sets or clears the mark. At most one button of a page has it at a time. A button that ever gets
/// it has the same size with and without it.
void set_primary(QPushButton& button, bool is_primary = true);
[[nodiscard]] bool is_primary(const QWidget& widget);

}  // namespace alltact
