// How everything looks: light, dark, high contrast, and the colours that mean something.
#pragma once

#include <QColor>
#include <QPalette>

namespace alltact {

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
