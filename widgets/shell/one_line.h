// A text that takes one line however little room there is: what does not fit is cut with an
// ellipsis and told by the tool tip.
#pragma once

#include <QLabel>

namespace alltact {

class OneLine : public QLabel {
  Q_OBJECT
 public:
  /// Of a path the end tells most, of a sentence its beginning.
  explicit OneLine(Qt::TextElideMode cut = Qt::ElideRight, QWidget* parent = nullptr);

  /// Plain text; in bold as far as `bold` letters.
  void set_text(const QString& text, int bold = 0);
  [[nodiscard]] bool is_cut() const;
  [[nodiscard]] QSize minimumSizeHint() const override;
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QFont bold_font() const;
  [[nodiscard]] int whole_width() const;
  Qt::TextElideMode cut_;
  int bold_ = 0;
};

/// For a menu or a button: at most `room` px wide, the end of the path whole.
[[nodiscard]] QString cut_path(const QString& path, const QFontMetrics& metrics, int room);

}  // namespace alltact
