// The frames of a recording in their order, in the colour of what becomes of each.
#pragma once

#include "calibration/reference/reference_recording.h"
#include "widgets/widget_base.h"

#include <QWidget>
#include <optional>
#include <vector>

namespace alltact {

class FrameStrip : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit FrameStrip(QWidget* parent = nullptr);
  /// Nothing is shown for a report without frames.
  void show_report(const ReferenceReport& report);
  [[nodiscard]] bool has_frames() const { return !uses_.empty(); }

  /// Tool tip of the frame at a position; empty off the frames.
  [[nodiscard]] QString words_at(int x) const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// Index of the clicked stretch in ReferenceReport::stretches.
  void stretch_clicked(int index);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] std::optional<std::size_t> frame_at(int x) const;
  [[nodiscard]] std::optional<std::size_t> stretch_of(std::size_t frame) const;
  [[nodiscard]] QColor colour_of(FrameUse use) const;
  [[nodiscard]] static QString name_of(FrameUse use);
  [[nodiscard]] int count_of(FrameUse use) const;
  void describe();
  void paint_frames(QPainter& painter, const QRect& bar) const;
  void paint_marks(QPainter& painter, const QRect& bar) const;
  void paint_legend(QPainter& painter, int top) const;
  [[nodiscard]] QRect bar() const;
  [[nodiscard]] std::vector<FrameUse> shown_uses() const;

  std::vector<FrameUse> uses_;
  std::vector<ReferenceStretch> stretches_;
  std::optional<std::size_t> rest_;
};

}  // namespace alltact
