// The contacts and the force on the finger: as text, over time, and the zero of the force.
#pragma once

#include "widgets/live/live_session.h"
#include "widgets/live/touch_history.h"
#include "widgets/plots/plot.h"
#include "widgets/widget_base.h"

#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QUndoStack>
#include <functional>
#include <optional>
#include <utility>

namespace alltact {

// Contacts as text of constant height.

class ContactBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit ContactBox(QWidget* parent = nullptr);
  /// Null result: no image yet.
  void show_contact(const FrameResult* result, const TouchHistory& history);

 private:
  QLabel* text_;
};

// Forces of the last 30 s with their intervals, above the contacts in the same time.

class ForcePlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  void set_data(const TouchHistory& history, const std::optional<ForceZero>& zero);
  /// Newtons at the lower and the upper end of the drawn axis.
  [[nodiscard]] std::pair<double, double> span_N() const { return {low_N_, top_N_}; }

 protected:
  bool draw() override;
  [[nodiscard]] QString empty_text() const override { return {}; }

 private:
  void set_span();
  void draw_contacts();
  void draw_span(double from_s, double to_s, int alpha, Qt::BrushStyle style);
  void draw_axis(int axis);

  TouchHistory history_;
  std::optional<ForceZero> zero_;
  double low_N_ = 0, top_N_ = 0;
};

/// The data that the box shows.
struct ShownForce {
  std::optional<Force> now;               ///< as measured
  const TouchHistory* history = nullptr;  ///< null: none
  std::optional<SessionZero> zero;
  bool is_live = true;     ///< false: recorded data, for which no zero counts
  QString why_none;        ///< shown instead of the reading where there is no force at all
  bool has_model = false;  ///< forces may come: their room is reserved
  bool can_train = false;
};

class ForceBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  /// Minimum time between two drawings, however often updates come.
  static constexpr int kDrawInterval_ms = 200;

  /// `ask` returns the data to show; called while the box is visible, some time after
  /// schedule_update().
  explicit ForceBox(std::function<ShownForce()> ask, QWidget* parent = nullptr);
  void schedule_update();
  [[nodiscard]] ForcePlot& plot() const { return *plot_; }
  /// For a layout elsewhere, where there is more room.
  [[nodiscard]] ForcePlot* take_plot();
  /// Number of drawings so far.
  [[nodiscard]] int drawings() const { return drawings_; }

 Q_SIGNALS:
  /// Use this reading, which the button offered when it was last drawn, as zero.
  void zero_requested(const alltact::ForceZero& zero);
  /// Show forces as measured, without a zero.
  void no_zero_requested();
  void training_requested();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void draw();
  [[nodiscard]] QString reading_text(const ShownForce& shown) const;
  [[nodiscard]] QString zero_text(const ShownForce& shown) const;

  std::function<ShownForce()> ask_;
  QTimer timer_;
  int drawings_ = 0;
  QLabel *reading_, *zero_;
  ForcePlot* plot_;
  QPushButton *take_zero_, *no_zero_, *train_;
  std::optional<ForceZero> offered_zero_;  ///< by the button as it is drawn
};

// Re-zeroing the force, as undo steps.

/// Sets this reading of the live finger as zero force. `zero` is the reading that the user saw,
/// whatever was measured since. Does nothing without a finger. Session and stack outlive the steps.
void take_zero(LiveSession& session, QUndoStack& undo, const ForceZero& zero);
/// Shows forces as measured again.
void drop_zero(LiveSession& session, QUndoStack& undo);

}  // namespace alltact
