#include "widgets/inspect/surface_box.h"

#include "widgets/language.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

namespace alltact {

SurfaceBox::SurfaceBox(QWidget* parent)
    : Translated(parent),
      hint_(new QLabel),
      table_(new QTableWidget(0, 2)),
      copy_text_(new QPushButton),
      copy_(new QPushButton) {
  hint_->setWordWrap(true);
  table_->horizontalHeader()->hide();
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  table_->setShowGrid(false);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* column = new QVBoxLayout(this);
  column->addWidget(hint_);
  column->addWidget(table_);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(copy_text_);
  buttons->addWidget(copy_);
  column->addLayout(buttons);
  connect(copy_text_, &QPushButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(text_of(readings_));
  });
  connect(copy_, &QPushButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(csv_of(readings_));
  });
  say([this] {
    setTitle(tr("Between A and B"));
    hint_->setText(
        tr("Two points make a box: a ball's radius, area, volume, roughness; the distance, the "
           "step and the angle from A to B."));
    copy_text_->setText(tr("Copy as text"));
    copy_->setText(tr("Copy as CSV"));
    table_->setAccessibleName(tr("Measured between the points"));
    fill();
  });
}

void SurfaceBox::show_readings(const std::shared_ptr<const InspectedFrame>& frame,
                               const std::optional<cv::Point2d>& a,
                               const std::optional<cv::Point2d>& b) {
  readings_ = frame && a && b ? surface_readings(*frame, *a, *b) : std::vector<SurfaceReading>{};
  fill();
}

void SurfaceBox::fill() {
  hint_->setVisible(readings_.empty());
  table_->setVisible(!readings_.empty());
  for (QPushButton* button : {copy_text_, copy_}) button->setVisible(!readings_.empty());
  table_->setRowCount(static_cast<int>(readings_.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const SurfaceReading& reading = readings_[static_cast<std::size_t>(row)];
    auto* name = new QTableWidgetItem(reading.name);
    auto* value = new QTableWidgetItem(value_text(reading));
    if (!reading.measured) value->setToolTip(window_sentence(reading.reason));
    table_->setItem(row, 0, name);
    table_->setItem(row, 1, value);
  }
  table_->resizeRowsToContents();
  int height = 2 * table_->frameWidth();
  for (int row = 0; row < table_->rowCount(); ++row) height += table_->rowHeight(row);
  table_->setFixedHeight(height);
}

}  // namespace alltact
