#include "widgets/shell/page.h"

#include "widgets/theme.h"

#include <QCoreApplication>
#include <QEvent>
#include <QPushButton>
#include <QScrollBar>
#include <QSettings>
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
    setMinimumWidth(min_width_px);
    setFocusPolicy(Qt::NoFocus);
  }
  [[nodiscard]] QSize sizeHint() const override {
    return {minimumWidth(), QScrollArea::sizeHint().height()};
  }

 protected:
  bool eventFilter(QObject* object, QEvent* event) override {
    const bool is_handled = QScrollArea::eventFilter(object, event);
    // Always with room for the scroll bar, which otherwise would toggle, as it makes the content
    // narrower. A page whose layout was made hidden, in other fonts, requests no new layout when it
    // is shown.
    if (object == widget() &&
        (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show))
      setMinimumWidth(std::max(least_width_px_, widget()->minimumSizeHint().width() +
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

namespace {

/// A panel at the right of a page's image, at least as wide as its content needs.
class SideSplitter : public Translated<QSplitter> {
  Q_DECLARE_TR_FUNCTIONS(alltact::SidePanel)
 public:
  SideSplitter(QWidget* image, QWidget* side, const QString& key)
      : side_(side), key_(key), chosen_px_(QSettings().value(key_).toInt()) {
    addWidget(image);
    addWidget(side);
    side->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    setStretchFactor(0, 1);
    setStretchFactor(1, 0);
    setChildrenCollapsible(false);
    setHandleWidth(kSpacing);
    handle(1)->installEventFilter(this);
    connect(this, &QSplitter::splitterMoved, this, [this] {
      chosen_px_ = sizes().at(1);
      QSettings().setValue(key_, chosen_px_);
    });
    say([this] {
      handle(1)->setToolTip(tr("Drag: width of the panel. Double click: as at first."));
    });
  }

 protected:
  bool event(QEvent* event) override {
    const bool is_handled = Translated::event(event);
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show) apply();
    return is_handled;
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::MouseButtonDblClick) {
      chosen_px_ = 0;
      QSettings().remove(key_);
      apply();
    }
    return Translated::eventFilter(watched, event);
  }

 private:
  void apply() {
    const int width_px = std::max(chosen_px_, side_->sizeHint().width());
    if (sizes().at(1) != width_px) setSizes({1, width_px});
  }

  QWidget* side_;
  QString key_;
  int chosen_px_;  // 0: none
};

}  // namespace

QSplitter* SidePanel::next_to(QWidget* image, const QString& key) const {
  return new SideSplitter(image, root, QStringLiteral("panels/") + key);
}

SidePanel::SidePanel(int min_width_px) : root(new QWidget) {
  root->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
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
