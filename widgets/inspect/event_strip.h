// Plots over a recording: depth, contact area and force, with marks at contacts and at frames with
// problems.
#pragma once

#include "widgets/inspect/frame_summary.h"
#include "widgets/translated.h"

#include <QWidget>
#include <vector>

namespace alltact {

/// A click or a drag requests the frame there. Keys: Left and Right one frame, Page up and Page
/// down the next contact or problem, Home and End. Frames not measured yet are empty.
class EventStrip : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit EventStrip(QWidget* parent = nullptr);

  /// count: frames of the recording.
  void set_summaries(const std::vector<FrameSummary>& summaries, std::size_t count);
  void set_shown(std::size_t number);

  /// Frames in which a contact begins, or a problem that the frame before does not have; ascending.
  [[nodiscard]] const std::vector<std::size_t>& events() const { return events_; }
  /// As a sentence, for screen readers.
  [[nodiscard]] QString description() const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {200, sizeHint().height()}; }

 Q_SIGNALS:
  void frame_requested(std::size_t number);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  /// One of the plots.
  struct Lane {
    QString (*name)();
    std::optional<double> FrameSummary::*member;
    double top = 0;  ///< end of its scale; 0: no frame has a value
  };
  void find_events();
  void describe();
  [[nodiscard]] std::vector<Lane> lanes() const;
  [[nodiscard]] QRect plots() const;
  [[nodiscard]] double x_of(double number) const;
  [[nodiscard]] std::size_t number_at(double x) const;
  void paint_events(QPainter& painter) const;
  void paint_lane(QPainter& painter, const Lane& lane, const QRect& room, int colour) const;

  std::vector<std::optional<FrameSummary>> frames_;
  std::size_t known_ = 0, shown_ = 0;
  std::vector<std::size_t> events_;
};

}  // namespace alltact
