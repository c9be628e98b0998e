// The primary action of a page: its largest button, in the colour of the selection.
#pragma once

#include <QPushButton>

namespace alltact {

/// Sets or clears the mark. At most one button of a page has it at a time.
void set_primary(QPushButton& button, bool is_primary = true);
[[nodiscard]] bool is_primary(const QWidget& widget);

}  // namespace alltact
