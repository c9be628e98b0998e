// How everything looks: light, dark, high contrast, the colours that mean something, the sizes of
// letters and the one spacing.
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>

namespace alltact {

/// Between two things that stand beside each other, in px at scale 1: half of it within a thing,
/// twice as much between groups.
inline constexpr int kSpacing = 8;

/// The typographic scale: 0.9, 1, 1.25 and 1.6 times the size of the body.
enum class TextSize { kSmall = 1, kBody, kHeading, kTitle };
/// `body` in that size, headings and titles in bold.
[[nodiscard]] QFont text_font(const QFont& body, TextSize size);

enum class Theme { kSystem = 1, kLight, kDark, kHighContrast };

/// The palette for Qt's Fusion style. kSystem: what the desktop says, as Qt read it at the start.
[[nodiscard]] QPalette theme_palette(Theme theme);

/// Qt 6.4 has no word for it: dark is where text is lighter than what it stands on.
[[nodiscard]] bool is_dark(const QPalette& palette);

/// Colours that can be told apart by everyone (Okabe and Ito 2008), the lighter ones on dark
/// ground; meaning never rests on them alone. index >= 0; they come round again after six.
[[nodiscard]] QColor series_colour(int index, const QPalette& palette);

enum class Meaning { kGood = 1, kDoubtful, kBad };
/// For borders and symbols beside a word; at least 3:1 against the palette's window.
[[nodiscard]] QColor meaning_colour(Meaning meaning, const QPalette& palette);

}  // namespace alltact
