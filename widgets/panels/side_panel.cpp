#include "widgets/panels/side_panel.h"

namespace alltact {

SidePanel::SidePanel(int width_px) : whole(new QScrollArea) {
  auto* side = new QWidget;
  column = new QVBoxLayout(side);
  column->setContentsMargins(8, 0, 8, 0);
  whole->setWidget(side);
  whole->setWidgetResizable(true);
  whole->setFrameShape(QFrame::NoFrame);
  whole->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  whole->setFixedWidth(width_px);
  whole->setFocusPolicy(Qt::NoFocus);
}

}  // namespace alltact
