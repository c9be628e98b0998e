// Bases of all widgets, whose texts follow the language, and helpers that build their content.
#pragma once

#include <QAccessible>
#include <QBoxLayout>
#include <QDialog>
#include <QEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QWidget>
#include <functional>
#include <initializer_list>
#include <optional>
#include <vector>

namespace alltact {

/// A widget class Base whose texts are set by say(): once at the call, and again for each new
/// language.
template <class Base>
class Translated : public Base {
 public:
  using Base::Base;

 protected:
  void say(std::function<void()> texts) {
    texts();
    texts_.push_back(std::move(texts));
  }
  void changeEvent(QEvent* event) override {
    if (event->type() == QEvent::LanguageChange)
      for (const auto& texts : texts_) texts();
    Base::changeEvent(event);
  }

 private:
  std::vector<std::function<void()>> texts_;
};

// Base of all dialogs: texts follow the language, and no line of them is cut off.

/// Never lower than its wrapped texts need at its width; layouts guarantee that only for
/// themselves.
class FittedDialog : public Translated<QDialog> {
 public:
  using Translated::Translated;

 protected:
  bool event(QEvent* event) override {
    const bool is_handled = Translated::event(event);
    const bool may_differ = event->type() == QEvent::LayoutRequest ||
                            event->type() == QEvent::Resize || event->type() == QEvent::Show;
    if (may_differ && layout() != nullptr && layout()->hasHeightForWidth())
      setMinimumHeight(layout()->totalHeightForWidth(width()));
    return is_handled;
  }
};

// Accessibility of widgets that paint themselves.

/// Assistive programs see `widget` in this role from now on; its name and description are the
/// widget's accessibleName() and accessibleDescription().
void set_accessible_role(QWidget& widget, QAccessible::Role role);

/// Sets the value that a widget with such a role shows now, as text; announces a change.
void set_accessible_value(QWidget& widget, const QString& text);

/// Sets the description; announces a change.
void set_accessible_description(QWidget& widget, const QString& text);

// A label of one line: text that does not fit is cut with an ellipsis; the tool tip holds it in
// full.

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

/// A label of several lines.
[[nodiscard]] QLabel* wrapped_label();
/// The same for sentences: they can be selected.
[[nodiscard]] QLabel* wrapped_text();

/// The same for messages that come and go: never lower than so many lines, nor than its longest
/// text, so that nothing around it moves. It is emptied, not hidden.
class ReservedText : public QLabel {
  Q_OBJECT
 public:
  explicit ReservedText(int lines = 1);
  /// All texts that it may show.
  void reserve_for(const QStringList& texts);
  [[nodiscard]] int heightForWidth(int width_px) const override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 private:
  [[nodiscard]] int reserved_height(int width_px) const;
  int lines_;
  QStringList texts_;
};
/// A widget that comes and goes takes its room also while it is hidden.
void reserve_room(QWidget& widget);

/// "Live" of "&Live" and of the Chinese "实时(&L)"; "R&R" of "R&&R".
[[nodiscard]] QString without_mnemonic(QString text);

/// For a menu or a button: at most `room` px wide, with the complete end of the path.
[[nodiscard]] QString elided_path(const QString& path, const QFontMetrics& metrics, int room);

// Tool tips for fields whose path or command may be longer than the field.

/// The field's tool tip is its full text from now on.
inline void show_text_as_tip(QLineEdit& field) {
  QObject::connect(&field, &QLineEdit::textChanged, &field, &QWidget::setToolTip);
}

/// The same layout.
template <class Layout>
Layout* without_margins(Layout* layout) {
  layout->setContentsMargins(0, 0, 0, 0);
  return layout;
}

/// Adds them in this order, without stretch.
inline void add_widgets(QBoxLayout& layout, std::initializer_list<QWidget*> widgets) {
  for (QWidget* widget : widgets) layout.addWidget(widget);
}

// Dialogs that do not block the window.

/// It is deleted when it is closed.
void show_dialog(QDialog& dialog);

using UsePath = std::function<void(const QString& path)>;
/// Filter of a file dialog: videos by their names, then all files, because names show little.
/// `more`: patterns that are offered together with videos.
[[nodiscard]] QString video_filter(const QString& more = {});
[[nodiscard]] QString all_files_filter();
[[nodiscard]] QString image_filter();
/// What a file dialog is for. Each begins in the folder that was used last for it.
enum class FilesOf {
  kFingers = 1,
  kRecordings,
  kImages,
  kCameras,
  kMeshes,
  kGrippers,
  kExports,
  kRecipes
};
/// The dialog begins in the folder that was used last for such files or, the first time, in
/// `otherwise` or the user's documents, and remembers what it chooses.
void begin_in_last_folder(QFileDialog& dialog, FilesOf what, const QString& otherwise = {});
/// Asks for an existing file: from `start` on, where it is not empty.
void ask_for_file(QWidget* parent, FilesOf what, const QString& title, const QString& filter,
                  const UsePath& use, const QString& start = {});
void ask_for_folder(QWidget* parent, FilesOf what, const QString& title, const UsePath& use,
                    const QString& start = {});
/// Asks for a file to write. `ending`: without the dot. `name`: that is proposed; may be empty.
void ask_where_to_save(QWidget* parent, FilesOf what, const QString& title, const QString& ending,
                       const QString& name, const UsePath& use);

// Age of the shown frame; an old one is highlighted.

class AgeLabel : public Translated<QLabel> {
  Q_OBJECT
 public:
  explicit AgeLabel(QWidget* parent = nullptr);
  /// From capture to display; nullopt: the source gives no capture time.
  void show_age(std::optional<double> age_ms);
  /// Above it a hand and its image move visibly apart.
  static constexpr double kLate_ms = 200;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void show_now();
  void colour();
  std::optional<double> age_ms_;
  bool is_late_ = false;
};

}  // namespace alltact
