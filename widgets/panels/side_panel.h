// The column of groups beside a place's picture.
#pragma once

#include <QScrollArea>
#include <QVBoxLayout>

namespace alltact {

/// `column` takes the groups, and scrolls where the window is low; `foot` what stays below them.
/// As wide as told, or as its content needs in the window's language.
struct SidePanel {
  explicit SidePanel(int least_width_px);
  QWidget* whole;
  QVBoxLayout *column, *foot;
};

}  // namespace alltact
