// A table of text rows without a tree: the first column is a name, the others as wide as their
// text.
#pragma once

#include <QHeaderView>
#include <QStringList>
#include <QTreeWidget>
#include <algorithm>

namespace alltact {

class RowList : public QTreeWidget {
 public:
  explicit RowList(QWidget* parent = nullptr) : QTreeWidget(parent) {
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    header()->setStretchLastSection(false);
  }
  /// The first cell is a name, the others are numbers, at the right of their columns.
  QTreeWidgetItem* add_numbers(const QStringList& cells) {
    auto* row = new QTreeWidgetItem(this, cells);
    for (int i = 1; i < static_cast<int>(cells.size()); ++i)
      row->setTextAlignment(i, Qt::AlignRight | Qt::AlignVCenter);
    return row;
  }
  /// The name takes the width that the other columns leave.
  void fit_columns() {
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(0, QHeaderView::Stretch);
  }
  /// As high as its rows, of which at least and at most so many are in view.
  void fit_height(int least, int most) {
    const int row_px = topLevelItemCount() > 0 ? sizeHintForRow(0) : fontMetrics().height();
    setFixedHeight(header()->sizeHint().height() + 2 * frameWidth() + kSpare_px +
                   row_px * std::clamp(topLevelItemCount(), least, most));
  }

 private:
  static constexpr int kSpare_px = 4;
};

}  // namespace alltact
