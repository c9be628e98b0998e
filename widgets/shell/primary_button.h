// The one thing to do next: the largest button of a page, in the colour of what is chosen.
#pragma once

#include <QPushButton>

namespace alltact {

/// From now on it is, or is not any more. Of a page at most one is at a time.
void set_primary(QPushButton& button, bool is_primary = true);
[[nodiscard]] bool is_primary(const QWidget& widget);

}  // namespace alltact
