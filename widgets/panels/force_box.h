// The force on the finger: in figures, over time, and from which zero it counts.
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

/// What the box shows.
struct ShownForce {
  std::optional<Force> now;               ///< as measured
  const TouchHistory* history = nullptr;  ///< null: none
  std::optional<SessionZero> zero;
  bool is_live = true;  ///< else what is shown was recorded, and counts from no zero
  QString why_none;     ///< in place of the plot, where no force was told at all
};

class ForceBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  /// At most so often, however often there is news.
  static constexpr int kBetweenDrawings_ms = 200;

  /// `ask` tells what there is to show; called while the box is visible, some time after news().
  explicit ForceBox(std::function<ShownForce()> ask, QWidget* parent = nullptr);
  void news();
  [[nodiscard]] ForcePlot& plot() const { return *plot_; }
  /// For a layout elsewhere, where there is more room.
  [[nodiscard]] ForcePlot* take_plot();
  /// How often it was drawn.
  [[nodiscard]] int drawings() const { return drawings_; }

 Q_SIGNALS:
  /// This reading, which the button offered as it was last drawn, is to count as none.
  void zero_wanted(const alltact::ForceZero& zero);
  /// Forces are to count as measured.
  void no_zero_wanted();

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
