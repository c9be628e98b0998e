// The project's own symbols, in the palette's colours.
#pragma once

#include "widgets/theme.h"

#include <QIcon>
#include <QPalette>

namespace alltact {

/// `name`: a file of resources/icons without its ending. Sharp at any scale; make it again when the
/// palette changes.
[[nodiscard]] QIcon icon(const QString& name, const QPalette& palette);

/// The same in one given colour.
[[nodiscard]] QPixmap symbol(const QString& name, const QColor& colour, int size, double ratio);

/// The symbol of a meaning; symbols also differ in shape.
[[nodiscard]] QString meaning_symbol(Meaning meaning);

}  // namespace alltact
