#include "widgets/shell/page.h"

#include "widgets/theme.h"

#include <QEvent>
#include <QPushButton>
#include <QScrollBar>
#include <algorithm>

namespace alltact {
namespace {

class SideColumn : public QScrollArea {
 public:
  explicit SideColumn(int min_width_px) : least_width_px_(min_width_px) {
    setWidget(new QWidget);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFixedWidth(min_width_px);
    setFocusPolicy(Qt::NoFocus);
  }

 protected:
  bool eventFilter(QObject* object, QEvent* event) override {
    const bool is_handled = QScrollArea::eventFilter(object, event);
    // Always with room for the scroll bar, which otherwise would toggle, as it makes the content
    // narrower. A page whose layout was made hidden, in other fonts, requests no new layout when it
    // is shown.
    if (object == widget() &&
        (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show))
      setFixedWidth(std::max(least_width_px_, widget()->minimumSizeHint().width() +
                                                  verticalScrollBar()->sizeHint().width()));
    return is_handled;
  }

 private:
  int least_width_px_;
};

}  // namespace

void Page::focus_next() {
  for (auto* button : findChildren<QPushButton*>())
    if (is_primary(*button) && button->isVisible() && button->isEnabled())
      return button->setFocus();
  setFocus();
}

void Page::follow_focus() {
  if (hasFocus()) focus_next();
}

SidePanel::SidePanel(int min_width_px) : root(new QWidget) {
  auto* scrolled = new SideColumn(min_width_px);
  column = new QVBoxLayout(scrolled->widget());
  column->setContentsMargins(4, 0, 2, 0);
  auto* all = without_margins(new QVBoxLayout(root));
  all->addWidget(scrolled, 1);
  foot = new QVBoxLayout;
  foot->setContentsMargins(4, 0, 2, 0);
  all->addLayout(foot);
}

}  // namespace alltact
