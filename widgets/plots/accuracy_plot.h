// What accuracy costs in time: error over the time of a picture, with what is worth taking.
#pragma once

#include "widgets/plots/plot.h"

#include <optional>
#include <vector>

class QCPItemLine;
class QCPItemText;

namespace alltact {

/// One setting: depth errors and place in mm.
struct AccuracyPoint {
  QString words;  ///< what the setting is
  QString hint;   ///< more of it, for who points at it
  double time_ms = 0, median_mm = 0, p95_mm = 0;
  std::optional<double> place_mm;
  bool is_on_front = false;  ///< nothing measured is both faster and more accurate
  bool is_in_use = false;
  bool is_proven = true;  ///< false: what it loses is not in the pictures, and it is never chosen
  std::optional<std::size_t> worse_than;  ///< a point that is better in both
};

/// The front as a staircase with whiskers up to what 95 % lie within, in words as far as they have
/// room; the others grey. A click picks a dot, arrow keys walk along the front, Enter takes it.
class AccuracyPlot : public Plot {
  Q_OBJECT
 public:
  static constexpr std::size_t kMostLabels = 7;

  explicit AccuracyPlot(QWidget* parent = nullptr);

  void set_points(std::vector<AccuracyPoint> points);
  /// Time that one picture may take; a line stands there.
  void set_budget(double pictures_per_s);
  void pick(std::optional<std::size_t> point);
  [[nodiscard]] std::optional<std::size_t> picked() const { return picked_; }

  /// Time (ms) and median error (mm) of every dot that is drawn, by its point; nullopt: it lies
  /// beyond the axes, and a note counts it.
  [[nodiscard]] std::vector<std::optional<QPointF>> dots() const;
  /// Where a point's dot is now, px of this widget.
  [[nodiscard]] QPoint place_of(std::size_t point) const;
  /// Labels as they lie now, px.
  [[nodiscard]] std::vector<QRectF> label_places() const;

 Q_SIGNALS:
  void point_picked(std::size_t point);
  /// The picked one, by Enter.
  void point_taken();
  /// Escape: none of them.
  void point_dropped();

 protected:
  bool draw() override;
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
  void place_labels_now();
  [[nodiscard]] std::vector<std::size_t> front() const;
  [[nodiscard]] std::vector<std::size_t> named() const;
  [[nodiscard]] bool is_shown(const AccuracyPoint& point) const;
  [[nodiscard]] QPointF pixel_of(const AccuracyPoint& point) const;
  [[nodiscard]] std::optional<std::size_t> at(const QPointF& place) const;
  void hover(QMouseEvent* event);
  void press(QMouseEvent* event);
  void walk(int steps);
  void tell();

  std::vector<AccuracyPoint> points_;
  double pictures_per_s_ = 30;
  std::optional<std::size_t> picked_;
  double most_ms_ = 1, most_mm_ = 1;
  std::vector<Label> labels_;
};

}  // namespace alltact
