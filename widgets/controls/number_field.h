// The field for numbers: core/typed_number.h parses the text; a refused text shows a sentence next
// to the field.
#pragma once

#include "core/base/result.h"
#include "core/base/typed_number.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPointer>
#include <QSpinBox>
#include <optional>
#include <utility>

namespace alltact {

/// The shared part of both fields. No key is swallowed. Text is parsed when it is finished (Return,
/// Tab or a click elsewhere) and never changed into another number. Refused text stays, with the
/// value from before, until another text or value is set.
template <class Spin>
class TypedSpin : public Spin {
 public:
  using Value = decltype(std::declval<Spin>().value());

  explicit TypedSpin(QWidget* parent = nullptr);
  ~TypedSpin() override;

  /// Setting the current value does not change the typed text.
  void setValue(Value value);
  /// Takes its possible range as the field's, and warns of values that are not plausible.
  void set_quantity(const Quantity& quantity);
  /// The value of the text, also before it is finished; nullopt: it is refused.
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

  /// Converts between a value and a text without prefix and suffix; neither checks the range.
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
  /// While somebody types, a note is removed or follows the text, and none appears.
  void show_state(bool is_finished);
  void make_note();
  void position_note();

  const Quantity* quantity_ = nullptr;
  mutable std::optional<Value> typed_;  // from text: shown with all its decimals
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
  static constexpr int kMaxDecimals = 6;

  explicit NumberField(QWidget* parent = nullptr);
  /// Digits shown of numbers that nobody typed. Default 2.
  void set_shown_decimals(int decimals);

 Q_SIGNALS:
  /// At every key and every value: typed() may have changed.
  void text_changed();

 protected:
  [[nodiscard]] Result<double> parsed(const QString& text) const override;
  [[nodiscard]] QString written(double value, bool is_exact) const override;

 private:
  int shown_decimals_ = 2;
};

/// For integers.
class IntegerField : public TypedSpin<QSpinBox> {
  Q_OBJECT
 public:
  explicit IntegerField(QWidget* parent = nullptr);

 protected:
  [[nodiscard]] Result<int> parsed(const QString& text) const override;
  [[nodiscard]] QString written(int value, bool is_exact) const override;
};

/// The decimal mark of the window's language.
[[nodiscard]] DecimalMark window_decimal_mark();

}  // namespace alltact
