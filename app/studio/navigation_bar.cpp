#include "app/studio/navigation_bar.h"

#include "widgets/shell/icons.h"

#include <QRegularExpression>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace alltact {
namespace {

constexpr int kRailIcon = 28, kRailWidth = 76;

/// "&Live" and "实时(&L)" without the mnemonic.
QString without_letter(QString menu_text) {
  static const QRegularExpression behind(QStringLiteral("\\(&.\\)"));
  return menu_text.remove(behind).remove(QLatin1Char('&'));
}

}  // namespace

NavigationBar::NavigationBar(const std::vector<Page*>& pages, QWidget* parent)
    : Translated(parent), pages_(pages), buttons_(new QButtonGroup(this)) {
  setObjectName(QStringLiteral("rail"));
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::AlternateBase);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 8, 6, 8);
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    QAbstractButton* button = make_button();
    buttons_->addButton(button, static_cast<int>(i));
    column->addWidget(button);
  }
  column->addStretch();
  mark(0);
  connect(buttons_, &QButtonGroup::idClicked, this, [this](int id) {
    Q_EMIT chosen(pages_[static_cast<std::size_t>(id)]->name());
  });
  say([this] { name_buttons(); });
  set_icons();
}

QAbstractButton* NavigationBar::make_button() {
  auto* button = new QToolButton;
  button->setCheckable(true);
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setIconSize({kRailIcon, kRailIcon});
  button->setMinimumHeight(64);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  button->setFocusPolicy(Qt::TabFocus);
  button->setAutoRaise(true);
  return button;
}

void NavigationBar::name_buttons() {
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    QAbstractButton* button = buttons_->button(static_cast<int>(i));
    button->setText(pages_[i]->title());
    button->setMinimumWidth(std::max(kRailWidth, button->sizeHint().width()));
    button->setToolTip(tr("%1 (Ctrl+%2)").arg(without_letter(pages_[i]->menu_text())).arg(i + 1));
  }
}

void NavigationBar::set_icons() {
  for (QAbstractButton* button : buttons_->buttons()) {  // none before they are made
    const Page& page = *pages_[static_cast<std::size_t>(buttons_->id(button))];
    button->setIcon(icon(QString::fromStdString(page.name()), palette()));
  }
}

void NavigationBar::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) set_icons();
}

}  // namespace alltact
