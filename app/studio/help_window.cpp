#include "app/studio/help_window.h"

#include "app/studio/help_pages.h"
#include "widgets/pages/page.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace alltact {
namespace {

constexpr int kListWidth = 150;
const QStringList kFurther{QStringLiteral("glossary"), QStringLiteral("effects")};

}  // namespace

HelpWindow::HelpWindow(const std::vector<Page*>& pages, QWidget* parent)
    : Translated(parent),
      pages_(pages),
      list_(new QListWidget),
      text_(new QTextBrowser),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  list_->setFixedWidth(kListWidth);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const auto add = [this](const QString& name) {
    auto* entry = new QListWidgetItem(list_);
    entry->setData(Qt::UserRole, name);
  };
  for (const Page* page : pages_) add(QString::fromStdString(page->name()));
  for (const QString& name : kFurther) add(name);
  text_->setOpenExternalLinks(true);
  text_->setSearchPaths({QStringLiteral(":/alltact/help")});  // of the pages' images
  auto* row = new QHBoxLayout;
  row->addWidget(list_);
  row->addWidget(text_, 1);
  auto* column = new QVBoxLayout(this);
  column->addLayout(row, 1);
  column->addWidget(buttons_);
  connect(list_, &QListWidget::currentRowChanged, this, &HelpWindow::load);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(980, 720);
  say([this] { name_pages(); });
}

void HelpWindow::name_pages() {
  setWindowTitle(tr("Help"));
  list_->setAccessibleName(tr("Pages"));
  text_->setAccessibleName(tr("Help"));
  int row = 0;
  for (const Page* page : pages_) list_->item(row++)->setText(page->title());
  for (const QString& words : {tr("Glossary"), tr("Effects of scenes")})
    list_->item(row++)->setText(words);
  buttons_->button(QDialogButtonBox::Close)->setText(tr("&Close"));
  load();
}

void HelpWindow::show_page(const QString& name) {
  for (int row = 0; row < list_->count(); ++row)
    if (list_->item(row)->data(Qt::UserRole).toString() == name) list_->setCurrentRow(row);
  show();
  raise();
  activateWindow();
  text_->setFocus();
}

void HelpWindow::load() {
  const QListWidgetItem* item = list_->currentItem();
  if (item == nullptr) return;
  text_->setMarkdown(help_text(item->data(Qt::UserRole).toString()));
}

}  // namespace alltact
