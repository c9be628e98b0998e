// The column of groups next to a page's image.
#pragma once

#include <QScrollArea>
#include <QVBoxLayout>

namespace alltact {

/// `column` takes the groups, and scrolls in a low window; `foot` takes what stays below them. As
/// wide as `min_width_px`, or as its content needs in the window's language.
struct SidePanel {
  explicit SidePanel(int min_width_px);
  QWidget* root;
  QVBoxLayout *column, *foot;
};

}  // namespace alltact
