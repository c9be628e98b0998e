// The settings of an AccuracyPlot as a table, sortable without a mouse.
#pragma once

#include "widgets/plots/accuracy_plot.h"
#include "widgets/translated.h"

#include <QAbstractTableModel>
#include <QComboBox>
#include <QLabel>
#include <QSortFilterProxyModel>
#include <QTableView>

namespace alltact {

/// One row for each point, in their order.
class AccuracyModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kSetting = 0, kTime, kMedian, kP95, kPosition, kStanding, kColumns };
  /// Numbers as such, for sorting.
  static constexpr int kSortRole = Qt::UserRole;

  using QAbstractTableModel::QAbstractTableModel;
  void set_points(std::vector<AccuracyPoint> points);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section,
                                    Qt::Orientation orientation,
                                    int role) const override;
  [[nodiscard]] static QString title(int column);

 private:
  [[nodiscard]] QVariant number(const AccuracyPoint& point, int column) const;
  [[nodiscard]] QString standing(const AccuracyPoint& point) const;
  std::vector<AccuracyPoint> points_;
};

class AccuracyTable : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit AccuracyTable(QWidget* parent = nullptr);

  void set_points(const std::vector<AccuracyPoint>& points);
  void pick(std::optional<std::size_t> point);

 Q_SIGNALS:
  void point_picked(std::size_t point);
  void point_activated();

 private:
  void name_parts();
  void sort_by(int column);

  AccuracyModel* model_;
  QSortFilterProxyModel* sorted_;
  QTableView* view_;
  QLabel* sort_label_;
  QComboBox* sort_;
  bool is_picking_ = false;  // by the program, not by the user
};

}  // namespace alltact
