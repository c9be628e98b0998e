// The one field for numbers: what is typed is a number as core/typed_number.h reads it, or it is
// refused with a sentence that stays beside the field.
#pragma once

#include "core/finger/quantity.h"
#include "core/result.h"
#include "core/typed_number.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPointer>
#include <QSpinBox>
#include <optional>
#include <utility>

namespace alltact {

/// What both fields share. No key is swallowed, text is taken when it is finished (Return, Tab or a
/// click elsewhere) and never changed into another number: refused text stays, with the value of
/// before, until something else is typed or set.
template <class Spin>
class TypedSpin : public Spin {
 public:
  using Value = decltype(std::declval<Spin>().value());

  explicit TypedSpin(QWidget* parent = nullptr);
  ~TypedSpin() override;

  /// The value that is there already leaves alone what is typed.
  void setValue(Value value);
  /// Its possible range is the field's, and a value that is not plausible is warned of.
  void set_quantity(const Quantity& quantity);
  /// What the text means, before it is taken too; nullopt: it is refused.
  [[nodiscard]] std::optional<Value> typed() const;
  /// Why the text is refused, in the window's language; empty: it is not.
  [[nodiscard]] QString refusal() const;
  /// Why the value is not plausible, likewise.
  [[nodiscard]] QString warning() const;
  void stepBy(int steps) override;

 protected:
  [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;
  [[nodiscard]] Value valueFromText(const QString& text) const override;
  [[nodiscard]] QString textFromValue(Value value) const override;
  void fixup(QString& text) const override;
  void focusOutEvent(QFocusEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

  /// A text without prefix and suffix as a value, and the value as such a text; the range is no
  /// matter of theirs.
  [[nodiscard]] virtual Result<Value> parsed(const QString& text) const = 0;
  [[nodiscard]] virtual QString written(Value value, bool is_exact) const = 0;
  /// Value of a number within the range, for the sentence.
  [[nodiscard]] virtual double shown_number(Value value) const {
    return static_cast<double>(value);
  }

 private:
  [[nodiscard]] std::optional<Message> problem_of(const QString& text) const;
  [[nodiscard]] QString bare(const QString& text) const;
  [[nodiscard]] bool is_written(const QString& text) const;
  [[nodiscard]] Result<Value> value_of(const QString& text) const;
  /// While somebody types, a note is taken away or follows the text, and none appears.
  void show_state(bool is_finished);
  void make_note();
  void place_note();

  const Quantity* quantity_ = nullptr;
  mutable std::optional<Value> typed_;  // taken from text: shown with all its decimals
  QString shown_text_;                  // that the note is about
  QString description_, tip_;           // without the note
  QString sentence_;                    // of the note
  bool is_refused_ = false;
  QPointer<QLabel> note_;
};

extern template class TypedSpin<QDoubleSpinBox>;
extern template class TypedSpin<QSpinBox>;

/// For numbers with decimals.
class NumberField : public TypedSpin<QDoubleSpinBox> {
  Q_OBJECT
 public:
  /// Digits behind the decimal mark that can be typed.
  static constexpr int kMostDecimals = 6;

  explicit NumberField(QWidget* parent = nullptr);
  /// Digits that are shown of numbers that nobody typed. 2 unless said.
  void set_shown_decimals(int decimals);

 Q_SIGNALS:
  /// With every key and every value: typed() may be another.
  void text_changed();

 protected:
  [[nodiscard]] Result<double> parsed(const QString& text) const override;
  [[nodiscard]] QString written(double value, bool is_exact) const override;

 private:
  int shown_decimals_ = 2;
};

/// For whole numbers.
class WholeNumberField : public TypedSpin<QSpinBox> {
  Q_OBJECT
 public:
  explicit WholeNumberField(QWidget* parent = nullptr);

 protected:
  [[nodiscard]] Result<int> parsed(const QString& text) const override;
  [[nodiscard]] QString written(int value, bool is_exact) const override;
};

/// The mark that the window's language writes before decimals.
[[nodiscard]] DecimalMark window_decimal_mark();

}  // namespace alltact
