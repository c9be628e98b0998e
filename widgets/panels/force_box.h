// The force on the finger: as numbers, over time, and its zero.
#pragma once

#include "widgets/plots/force_plot.h"
#include "widgets/touch/session_zero.h"
#include "widgets/translated.h"

#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <functional>
#include <optional>

namespace alltact {

/// The data that the box shows.
struct ShownForce {
  std::optional<Force> now;               ///< as measured
  const TouchHistory* history = nullptr;  ///< null: none
  std::optional<SessionZero> zero;
  bool is_live = true;  ///< false: recorded data, for which no zero counts
  QString why_none;     ///< shown instead of the plot where there is no force at all
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
  QPushButton *take_zero_, *no_zero_;
  std::optional<ForceZero> offered_zero_;  ///< by the button as it is drawn
};

}  // namespace alltact
