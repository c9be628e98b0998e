#include "widgets/accuracy/accuracy_table.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QVBoxLayout>

namespace alltact {

void AccuracyModel::set_points(std::vector<AccuracyPoint> points) {
  beginResetModel();
  points_ = std::move(points);
  endResetModel();
}

int AccuracyModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(points_.size());
}

int AccuracyModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QString AccuracyModel::title(int column) {
  switch (column) {
    case kSetting:
      return tr("Settings");
    case kTime:
      return tr("Time of a picture (ms)");
    case kMedian:
      return tr("Depth error, half within (mm)");
    case kP95:
      return tr("Depth error, 95 % within (mm)");
    case kPosition:
      return tr("Place error, half within (mm)");
    default:
      return tr("Standing");
  }
}

QVariant AccuracyModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return title(section);
}

QVariant AccuracyModel::number(const AccuracyPoint& point, int column) const {
  switch (column) {
    case kTime:
      return point.time_ms;
    case kMedian:
      return point.median_mm;
    case kP95:
      return point.p95_mm;
    case kPosition:
      return point.position_mm ? QVariant(*point.position_mm) : QVariant();
    default:
      return {};
  }
}

QString AccuracyModel::standing(const AccuracyPoint& point) const {
  QString words;
  if (point.is_on_front)
    words = tr("best for its time");
  else if (!point.is_proven)
    words = tr("what it loses is not in these pictures");
  else if (point.dominated_by)
    words = tr("worse than: %1").arg(points_[*point.dominated_by].words);
  else
    words = tr("not in every picture");
  return point.is_in_use ? tr("in use now; %1").arg(words) : words;
}

QVariant AccuracyModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const AccuracyPoint& point = points_[static_cast<std::size_t>(index.row())];
  const int column = index.column();
  const bool is_number = column >= kTime && column <= kPosition;
  if (role == kSortRole) {
    if (is_number) return number(point, column);
    return column == kSetting ? point.words : standing(point);
  }
  if (role == Qt::TextAlignmentRole && is_number)
    return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
  if (role == Qt::ToolTipRole) return point.hint;
  if (role != Qt::DisplayRole) return {};
  if (column == kSetting) return point.words;
  if (column == kStanding) return standing(point);
  const QVariant value = number(point, column);
  if (!value.isValid()) return QStringLiteral("–");
  return QLocale().toString(value.toDouble(), 'f', column == kTime ? 2 : 4);
}

AccuracyTable::AccuracyTable(QWidget* parent)
    : Translated(parent),
      model_(new AccuracyModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      view_(new QTableView),
      sort_label_(new QLabel),
      sort_(new QComboBox) {
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(AccuracyModel::kSortRole);
  view_->setModel(sorted_);
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setSelectionMode(QAbstractItemView::SingleSelection);
  view_->setTabKeyNavigation(false);
  view_->setWordWrap(false);
  view_->setSortingEnabled(true);
  view_->verticalHeader()->hide();
  view_->horizontalHeader()->setDefaultAlignment(Qt::Alignment(Qt::AlignLeft | Qt::AlignVCenter) |
                                                 Qt::Alignment(Qt::TextWordWrap));
  auto* column = new QVBoxLayout(this);
  auto* line = new QHBoxLayout;
  sort_label_->setBuddy(sort_);
  line->addWidget(sort_label_);
  line->addWidget(sort_);
  line->addStretch();
  column->addLayout(line);
  column->addWidget(view_, 1);
  say([this] { name_parts(); });
  sort_by(AccuracyModel::kTime);
  connect(sort_, &QComboBox::activated, this, &AccuracyTable::sort_by);
  connect(view_->horizontalHeader(), &QHeaderView::sortIndicatorChanged, this, [this](int at) {
    sort_->setCurrentIndex(at);
  });
  connect(view_->selectionModel(),
          &QItemSelectionModel::currentRowChanged,
          this,
          [this](const QModelIndex& now) {
            if (!is_picking_ && now.isValid())
              Q_EMIT point_picked(static_cast<std::size_t>(sorted_->mapToSource(now).row()));
          });
  connect(view_, &QTableView::activated, this, &AccuracyTable::point_activated);
}

void AccuracyTable::name_parts() {
  sort_label_->setText(tr("S&ort by"));
  sort_->setAccessibleName(tr("Sort by"));
  view_->setAccessibleName(tr("What accuracy costs in time, as a table"));
  const int now = std::max(0, sort_->currentIndex());
  sort_->clear();
  for (int i = 0; i < AccuracyModel::kColumns; ++i) sort_->addItem(AccuracyModel::title(i));
  sort_->setCurrentIndex(now);
  Q_EMIT model_->headerDataChanged(Qt::Horizontal, 0, AccuracyModel::kColumns - 1);
}

void AccuracyTable::sort_by(int column) {
  view_->sortByColumn(column, Qt::AscendingOrder);
  sort_->setCurrentIndex(column);
}

void AccuracyTable::set_points(const std::vector<AccuracyPoint>& points) {
  is_picking_ = true;
  model_->set_points(points);
  view_->resizeColumnsToContents();
  view_->setColumnWidth(AccuracyModel::kSetting,
                        std::min(360, view_->columnWidth(AccuracyModel::kSetting)));
  for (int i = AccuracyModel::kTime; i <= AccuracyModel::kPosition; ++i)
    view_->setColumnWidth(i, 110);
  const int line = view_->fontMetrics().height();
  view_->horizontalHeader()->setFixedHeight(3 * line);
  view_->verticalHeader()->setDefaultSectionSize(line + 8);
  is_picking_ = false;
}

void AccuracyTable::pick(std::optional<std::size_t> point) {
  is_picking_ = true;
  if (point)
    view_->setCurrentIndex(sorted_->mapFromSource(model_->index(static_cast<int>(*point), 0)));
  else
    view_->clearSelection();
  is_picking_ = false;
}

}  // namespace alltact
