#include "app/studio/help_window.h"

#include "app/studio/help_pages.h"
#include "widgets/places/place.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace alltact {
namespace {

constexpr int kListWidth = 150;
const QStringList kFurther{QStringLiteral("glossary"), QStringLiteral("effects")};

}  // namespace

HelpWindow::HelpWindow(const std::vector<Place*>& places, QWidget* parent)
    : Translated(parent),
      places_(places),
      pages_(new QListWidget),
      text_(new QTextBrowser),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  pages_->setFixedWidth(kListWidth);
  pages_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const auto add = [this](const QString& name) {
    auto* entry = new QListWidgetItem(pages_);
    entry->setData(Qt::UserRole, name);
  };
  for (const Place* place : places_) add(QString::fromStdString(place->name()));
  for (const QString& name : kFurther) add(name);
  text_->setOpenExternalLinks(true);
  text_->setSearchPaths({QStringLiteral(":/alltact/help")});  // of the pages' pictures
  auto* row = new QHBoxLayout;
  row->addWidget(pages_);
  row->addWidget(text_, 1);
  auto* column = new QVBoxLayout(this);
  column->addLayout(row, 1);
  column->addWidget(buttons_);
  connect(pages_, &QListWidget::currentRowChanged, this, &HelpWindow::load);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(980, 720);
  say([this] { name_pages(); });
}

void HelpWindow::name_pages() {
  setWindowTitle(tr("Help"));
  pages_->setAccessibleName(tr("Pages"));
  text_->setAccessibleName(tr("Help"));
  int row = 0;
  for (const Place* place : places_) pages_->item(row++)->setText(place->title());
  for (const QString& words : {tr("Glossary"), tr("Effects of scenes")})
    pages_->item(row++)->setText(words);
  buttons_->button(QDialogButtonBox::Close)->setText(tr("&Close"));
  load();
}

void HelpWindow::show_page(const QString& name) {
  for (int row = 0; row < pages_->count(); ++row)
    if (pages_->item(row)->data(Qt::UserRole).toString() == name) pages_->setCurrentRow(row);
  show();
  raise();
  activateWindow();
  text_->setFocus();
}

void HelpWindow::load() {
  const QListWidgetItem* page = pages_->currentItem();
  if (page == nullptr) return;
  text_->setMarkdown(help_text(page->data(Qt::UserRole).toString()));
}

}  // namespace alltact
