// The column of groups beside a place's picture.
#pragma once

#include <QScrollArea>
#include <QVBoxLayout>

namespace alltact {

/// Scrolls where the window is low; `column` takes the groups.
struct SidePanel {
  explicit SidePanel(int width_px);
  QScrollArea* whole;
  QVBoxLayout* column;
};

}  // namespace alltact
