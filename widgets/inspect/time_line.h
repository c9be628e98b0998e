// Chooses a frame of a recording by play, slider, number or next event, and plots the recording
// over time.
#pragma once

#include "widgets/controls/number_field.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/widget_base.h"

#include <QLabel>
#include <QSlider>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <vector>

namespace alltact {

// Plots over a recording: depth, contact area and force, with marks at contacts and at frames with
// problems.

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
  void paint_lane(QPainter& painter, const Lane& lane, const QRect& room) const;

  std::vector<std::optional<FrameSummary>> frames_;
  std::size_t known_ = 0, shown_ = 0;
  std::vector<std::size_t> events_;
};

class TimeLine : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit TimeLine(QWidget* parent = nullptr);

  void set_recording(std::size_t count, double frames_per_s);
  /// Another recording, from this frame on.
  void begin(std::size_t number);
  /// The frame shown now; while playing, the next one is requested when it is due.
  void set_shown(std::size_t number, const QString& name);
  [[nodiscard]] bool is_playing() const { return timer_.isActive(); }
  void play(bool is_on);
  /// Summaries of the frames measured so far.
  void set_summaries(const std::vector<FrameSummary>& summaries);
  [[nodiscard]] const EventStrip& strip() const { return *strip_; }

 Q_SIGNALS:
  void frame_requested(std::size_t number);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void go_on();
  void show_button();
  void go_to_event(bool is_next);
  void request(int number);

  QToolButton *play_, *earlier_, *later_;
  QSlider* slider_;
  IntegerField* number_;
  QLabel *of_, *name_;
  EventStrip* strip_;
  QTimer timer_;
  std::size_t count_ = 0, requested_ = 0, shown_ = 0;
};

}  // namespace alltact
