// Chooses a frame of a recording by play, slider, number or next event, and plots the recording
// over time.
#pragma once

#include "widgets/controls/number_field.h"
#include "widgets/inspect/event_strip.h"
#include "widgets/translated.h"

#include <QLabel>
#include <QSlider>
#include <QTimer>
#include <QToolButton>

namespace alltact {

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
