// A label of one line: text that does not fit is cut with an ellipsis; the tool tip holds it in
// full.
#pragma once

#include <QLabel>

namespace alltact {

class ElidedLabel : public QLabel {
  Q_OBJECT
 public:
  /// `cut`: ElideLeft suits a path, ElideRight a sentence.
  explicit ElidedLabel(Qt::TextElideMode cut = Qt::ElideRight, QWidget* parent = nullptr);

  /// Plain text; the first `bold` letters are bold.
  void set_text(const QString& text, int bold = 0);
  [[nodiscard]] bool is_elided() const;
  [[nodiscard]] QSize minimumSizeHint() const override;
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QFont bold_font() const;
  [[nodiscard]] int full_width() const;
  Qt::TextElideMode elide_mode_;
  int bold_ = 0;
};

/// For a menu or a button: at most `room` px wide, with the complete end of the path.
[[nodiscard]] QString elided_path(const QString& path, const QFontMetrics& metrics, int room);

}  // namespace alltact
