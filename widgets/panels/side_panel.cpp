#include "widgets/panels/side_panel.h"

#include <QEvent>
#include <QScrollBar>
#include <algorithm>

namespace alltact {
namespace {

class SideColumn : public QScrollArea {
 public:
  explicit SideColumn(int least_width_px) : least_width_px_(least_width_px) {
    setWidget(new QWidget);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFixedWidth(least_width_px);
    setFocusPolicy(Qt::NoFocus);
  }

 protected:
  bool eventFilter(QObject* object, QEvent* event) override {
    const bool is_handled = QScrollArea::eventFilter(object, event);
    // Always with room for the scroll bar: else it would come and go with what it makes narrower.
    // A page that was laid out unseen, in other fonts, asks for no new layout when it is shown.
    if (object == widget() &&
        (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show))
      setFixedWidth(
          std::max(least_width_px_,
                   widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width()));
    return is_handled;
  }

 private:
  int least_width_px_;
};

}  // namespace

SidePanel::SidePanel(int least_width_px) : whole(new QWidget) {
  auto* scrolled = new SideColumn(least_width_px);
  column = new QVBoxLayout(scrolled->widget());
  column->setContentsMargins(4, 0, 2, 0);
  auto* all = new QVBoxLayout(whole);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(scrolled, 1);
  foot = new QVBoxLayout;
  foot->setContentsMargins(4, 0, 2, 0);
  all->addLayout(foot);
}

}  // namespace alltact
