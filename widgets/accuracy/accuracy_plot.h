// Accuracy against time: depth error over the time per frame, with the Pareto front.
#pragma once

#include "widgets/plots/plot.h"
#include "widgets/widget_base.h"

#include <QAbstractTableModel>
#include <QComboBox>
#include <QLabel>
#include <QRectF>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <optional>
#include <vector>

class QCPItemLine;
class QCPItemText;

namespace alltact {

/// One setting: depth errors and position error in mm.
struct AccuracyPoint {
  QString words;  ///< name of the setting
  QString hint;   ///< more of it, for the tool tip
  double time_ms = 0, median_mm = 0, p95_mm = 0;
  std::optional<double> position_mm;
  bool is_on_front = false;  ///< Pareto optimal: nothing measured is both faster and more accurate
  bool is_in_use = false;
  bool is_proven = true;  ///< false: its loss does not show in the frames, so it is never chosen
  std::optional<std::size_t> dominated_by;  ///< index of a point that is better in both
};

/// The Pareto front as a staircase with whiskers up to the 95 % quantile, labelled as far as there
/// is room; all other points grey. A click picks a dot, arrow keys walk along the front, Enter
/// takes it.
class AccuracyPlot : public Plot {
  Q_OBJECT
 public:
  static constexpr std::size_t kMaxLabels = 7;

  explicit AccuracyPlot(QWidget* parent = nullptr);

  void set_points(std::vector<AccuracyPoint> points);
  /// Draws a line at the time that one frame may take.
  void set_budget(double frames_per_s);
  void pick(std::optional<std::size_t> point);
  [[nodiscard]] std::optional<std::size_t> picked() const { return picked_; }

  /// Time (ms) and median error (mm) of every drawn dot, by its point. nullopt: it lies beyond the
  /// axes, and a note counts it.
  [[nodiscard]] std::vector<std::optional<QPointF>> dots() const;
  /// Current pixel of a point's dot, px of this widget.
  [[nodiscard]] QPoint dot_pixel(std::size_t point) const;
  /// Current boxes of the labels, px.
  [[nodiscard]] std::vector<QRectF> label_boxes() const;

 Q_SIGNALS:
  void point_picked(std::size_t point);
  /// Enter on the picked point.
  void point_activated();
  /// Escape: no point is picked any more.
  void pick_cleared();

 protected:
  bool draw() override;
  [[nodiscard]] QString title() const override;
  [[nodiscard]] QString empty_text() const override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Label {
    std::size_t point;
    QCPItemText* text;
    QCPItemLine* line;
  };
  void set_ranges();
  void draw_front();
  void draw_others();
  void draw_marks();
  void draw_budget();
  void draw_labels();
  void layout_labels_now();
  [[nodiscard]] std::vector<std::size_t> front() const;
  [[nodiscard]] std::vector<std::size_t> named() const;
  [[nodiscard]] bool is_shown(const AccuracyPoint& point) const;
  [[nodiscard]] QPointF pixel_of(const AccuracyPoint& point) const;
  [[nodiscard]] std::optional<std::size_t> at(const QPointF& pixel) const;
  void hover(QMouseEvent* event);
  void press(QMouseEvent* event);
  void walk(int steps);
  void announce();

  std::vector<AccuracyPoint> points_;
  double frames_per_s_ = 30;
  std::optional<std::size_t> picked_;
  double max_ms_ = 1, max_mm_ = 1;
  std::vector<Label> labels_;
};

// Layout of labels next to their dots without overlaps.

struct LabelRequest {
  QPointF dot;
  QSizeF size;
};

/// Arranges one label after the other, the most important first, each as near to its dot as there
/// is room; all in px. nullopt: there is no room near enough.
///   room: where labels may stand; taken: boxes that they must not cover
[[nodiscard]] std::vector<std::optional<QRectF>> layout_labels(
    const QRectF& room, const std::vector<LabelRequest>& labels, const std::vector<QRectF>& taken);

// The settings of an AccuracyPlot as a table, sortable without a mouse.

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
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
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
