// The frames of a recording in their order, in the colour of what becomes of each; frames can be
// selected, shown, left out and taken in again.
#pragma once

#include "calibration/reference/reference_recording.h"
#include "widgets/image/image_view.h"
#include "widgets/widget_base.h"

#include <QPushButton>
#include <QUndoStack>
#include <QWidget>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace alltact {

/// The user's word on frames of a recording, by number: true where they count as untouched, false
/// where they are left out.
using FrameChoice = std::map<int, bool>;
/// Ascending; consecutive frames are one range.
[[nodiscard]] std::vector<FrameRange> frames_of(const FrameChoice& choice, bool is_used);

/// A click or the arrow keys select a frame; dragging, or Shift with either, selects several.
class FrameStrip : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit FrameStrip(QWidget* parent = nullptr);
  /// Nothing is shown for a report without frames.
  void show_report(const ReferenceReport& report);
  /// Shown over the report, which knows only the choice of before.
  void show_choice(const FrameChoice& choice);
  [[nodiscard]] bool has_frames() const { return !uses_.empty(); }
  [[nodiscard]] const std::vector<FrameUse>& uses() const { return uses_; }
  [[nodiscard]] const std::vector<ReferenceStretch>& stretches() const { return stretches_; }
  [[nodiscard]] std::optional<std::size_t> stretch_of(std::size_t frame) const;

  /// Selects frames, and `shown` among them.
  void select(const FrameRange& frames, int shown);
  void clear_selection();
  [[nodiscard]] const std::optional<FrameRange>& selection() const { return selected_; }

  /// Tool tip of the frame at a position; empty off the frames.
  [[nodiscard]] QString words_at(int x) const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// Index of the clicked stretch in ReferenceReport::stretches.
  void stretch_clicked(int index);
  void selection_changed();
  /// The user asks to see this frame.
  void frame_selected(int frame);
  /// By the key Delete.
  void change_requested();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] std::optional<std::size_t> frame_at(int x) const;
  [[nodiscard]] std::optional<int> darkest_at(QPointF position) const;
  [[nodiscard]] double x_of(int frame) const;
  void move_to(int frame, bool extends);
  [[nodiscard]] QString words_of(std::size_t frame) const;
  [[nodiscard]] QColor colour_of(FrameUse use) const;
  [[nodiscard]] static QString name_of(FrameUse use);
  [[nodiscard]] int count_of(FrameUse use) const;
  void describe();
  void paint_frames(QPainter& painter, const QRect& bar) const;
  void paint_marks(QPainter& painter, const QRect& bar) const;
  void paint_selection(QPainter& painter, const QRect& bar) const;
  void paint_legend(QPainter& painter, int top) const;
  [[nodiscard]] QRect bar() const;
  [[nodiscard]] std::vector<FrameUse> shown_uses() const;

  std::vector<FrameUse> reported_, uses_;
  std::vector<ReferenceStretch> stretches_;
  std::optional<std::size_t> rest_;
  std::optional<FrameRange> selected_;
  int anchor_ = -1, shown_ = -1;  // the end that stays, and the frame that is shown; -1: none
  bool is_dragging_ = false;
};

class ImagePanel;
class Inspection;
struct LiveView;

/// The strip with its buttons: leaves the selected frames out, or takes them in again, and shows a
/// selected frame in the image panel, with the darkest spot of its contact.
class FrameChooser : public Translated<QWidget> {
  Q_OBJECT
 public:
  FrameChooser(ImagePanel& panel, QUndoStack& undo, QWidget* parent = nullptr);
  ~FrameChooser() override;

  /// Of a recording of this finger; forgets the choice of the former one.
  void begin(const std::filesystem::path& finger, const std::filesystem::path& video);
  /// Nothing is shown for a report without frames.
  void show_report(const ReferenceReport& report);
  [[nodiscard]] const FrameChoice& choice() const { return choice_; }
  /// An undoable step. Of frames to be used, those with a contact count as untouched from now on,
  /// and those that were left out are judged again, or count as untouched, too.
  void choose(const FrameRange& frames, bool is_used, bool all_count_as_untouched = false);
  /// Selects a stretch of the report and shows its darkest frame.
  void show_stretch(int index);
  void show_live_image();
  /// Over a frame that it shows: its number and the darkest spot of its contact.
  [[nodiscard]] std::vector<Overlay> marks(const LiveView& view) const;
  [[nodiscard]] FrameStrip& strip() { return *strip_; }
  /// Why the selected frame cannot be shown.
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

 Q_SIGNALS:
  void choice_changed();
  void stretch_clicked(int index);

 private:
  void name_parts();
  void show_frame(int frame);
  void take_frame();
  void change_selected();
  void apply(const FrameChoice& choice);
  [[nodiscard]] bool are_used(const FrameRange& frames) const;

  ImagePanel& panel_;
  QUndoStack& undo_;
  FrameStrip* strip_;
  QPushButton *change_, *live_;
  FrameChoice choice_;
  std::filesystem::path finger_, video_;
  std::unique_ptr<Inspection> inspection_;  // made with the first frame that is shown
  std::shared_ptr<const LiveView> shown_;
  int shown_frame_ = -1, shown_number_ = -1;  // requested and shown; -1: none
  std::optional<Error> problem_;
};

}  // namespace alltact
