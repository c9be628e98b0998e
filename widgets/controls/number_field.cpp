#include "widgets/controls/number_field.h"

#include "widgets/language.h"
#include "widgets/theme.h"

#include <QFormLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QPainter>
#include <QTimer>
#include <algorithm>
#include <charconv>
#include <cmath>

namespace alltact {
namespace {

QLocale ungrouped_locale() {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale;
}

/// The form among a layout's parts that holds a field.
QFormLayout* form_of(QLayout* layout, QWidget* field) {
  if (layout == nullptr) return nullptr;
  if (auto* form = qobject_cast<QFormLayout*>(layout); form && form->indexOf(field) >= 0)
    return form;
  for (int i = 0; i < layout->count(); ++i)
    if (QFormLayout* form = form_of(layout->itemAt(i)->layout(), field)) return form;
  return nullptr;
}

}  // namespace

DecimalMark window_decimal_mark() {
  return QLocale().decimalPoint() == QLatin1String(",") ? DecimalMark::kComma : DecimalMark::kPoint;
}

template <class Spin>
TypedSpin<Spin>::TypedSpin(QWidget* parent) : Spin(parent) {
  this->setKeyboardTracking(false);
  QObject::connect(this->lineEdit(), &QLineEdit::textEdited, this, [this] { show_state(false); });
}

template <class Spin>
TypedSpin<Spin>::~TypedSpin() {
  delete note_;
}

template <class Spin>
void TypedSpin<Spin>::set_quantity(const Quantity& quantity) {
  quantity_ = &quantity;
  this->setRange(static_cast<Value>(quantity.possible.low),
                 static_cast<Value>(quantity.possible.high));
}

template <class Spin>
void TypedSpin<Spin>::setValue(Value value) {
  if (value != this->value()) Spin::setValue(value);
}

template <class Spin>
QString TypedSpin<Spin>::bare(const QString& text) const {
  QString number = text;
  if (number.startsWith(this->prefix())) number.remove(0, this->prefix().size());
  if (number.endsWith(this->suffix())) number.chop(this->suffix().size());
  return number.trimmed();  // a unit that was typed before the field's own is left
}

/// Rounded for display: text that nobody changed stands for the exact value.
template <class Spin>
bool TypedSpin<Spin>::is_written(const QString& text) const {
  return !this->lineEdit()->isModified() &&
         text == this->prefix() + textFromValue(this->value()) + this->suffix();
}

template <class Spin>
Result<typename TypedSpin<Spin>::Value> TypedSpin<Spin>::value_of(const QString& text) const {
  if (is_written(text)) return this->value();
  const QString number = bare(text), special = this->specialValueText();
  if (!special.isEmpty() && (number.isEmpty() || text.trimmed() == special.trimmed()))
    return this->minimum();
  return parsed(number);
}

template <class Spin>
std::optional<Message> TypedSpin<Spin>::problem_of(const QString& text) const {
  if (is_written(text)) return std::nullopt;  // set by the program, where 0 has a meaning
  const auto value = value_of(text);
  if (!value) return value.error().what;
  const bool is_special = !this->specialValueText().isEmpty() && *value == this->minimum();
  if (quantity_ != nullptr && !is_special)
    if (auto refused = quantity_->refusal(static_cast<double>(*value))) return refused;
  if (*value >= this->minimum() && *value <= this->maximum()) return std::nullopt;
  return en::say("must be a number from {:g} to {:g}{}", shown_number(this->minimum()),
                 shown_number(this->maximum()), this->suffix().toStdString());
}

template <class Spin>
std::optional<typename TypedSpin<Spin>::Value> TypedSpin<Spin>::typed() const {
  const QString text = this->lineEdit()->text();
  if (problem_of(text)) return std::nullopt;
  return *value_of(text);
}

template <class Spin>
QString TypedSpin<Spin>::refusal() const {
  const auto problem = problem_of(this->lineEdit()->text());
  return problem ? window_sentence(*problem) : QString();
}

template <class Spin>
QString TypedSpin<Spin>::warning() const {
  const auto value = static_cast<double>(this->value());
  if (quantity_ == nullptr || !quantity_->possible.holds(value)) return {};  // 0: not known
  const auto warned = quantity_->warning(value);
  return warned ? window_sentence(*warned) : QString();
}

template <class Spin>
QValidator::State TypedSpin<Spin>::validate(QString& text, int& /*position*/) const {
  return problem_of(text) ? QValidator::Intermediate : QValidator::Acceptable;
}

template <class Spin>
typename TypedSpin<Spin>::Value TypedSpin<Spin>::valueFromText(const QString& text) const {
  const auto value = value_of(text);
  if (!value) return this->value();
  if (*value != this->value()) typed_ = *value;
  return *value;
}

template <class Spin>
QString TypedSpin<Spin>::textFromValue(Value value) const {
  return written(value, typed_ && *typed_ == value);
}

template <class Spin>
void TypedSpin<Spin>::fixup(QString& /*text*/) const {}

template <class Spin>
void TypedSpin<Spin>::stepBy(int steps) {
  if (!typed()) return show_state(true);
  this->interpretText();
  Spin::stepBy(steps);
  show_state(true);
}

template <class Spin>
void TypedSpin<Spin>::focusOutEvent(QFocusEvent* event) {
  if (typed()) {
    Spin::focusOutEvent(event);
  } else {  // Spin would restore the value silently
    this->lineEdit()->event(event);
    QWidget::focusOutEvent(event);
  }
  show_state(true);
}

template <class Spin>
void TypedSpin<Spin>::keyPressEvent(QKeyEvent* event) {
  const bool is_finished = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if ((is_finished || event->key() == Qt::Key_Escape) && !typed()) {
    if (event->key() == Qt::Key_Escape) Spin::setValue(this->value());
    show_state(true);
    return event->accept();  // a button must not take a refused value
  }
  Spin::keyPressEvent(event);
  if (is_finished) show_state(true);
}

template <class Spin>
void TypedSpin<Spin>::hideEvent(QHideEvent* event) {
  if (note_) note_->hide();
  shown_text_.clear();  // shown again with the field
  typed() ? Spin::hideEvent(event) : QWidget::hideEvent(event);
}

template <class Spin>
void TypedSpin<Spin>::closeEvent(QCloseEvent* event) {
  typed() ? Spin::closeEvent(event) : QWidget::closeEvent(event);
}

template <class Spin>
void TypedSpin<Spin>::changeEvent(QEvent* event) {
  Spin::changeEvent(event);
  if (event->type() != QEvent::LanguageChange && event->type() != QEvent::LocaleChange) return;
  // Writes the value again with the new decimal mark; refused text stays.
  if (typed()) this->setSuffix(this->suffix());
  if (!sentence_.isEmpty()) show_state(true);
}

template <class Spin>
void TypedSpin<Spin>::paintEvent(QPaintEvent* event) {
  Spin::paintEvent(event);
  if (this->lineEdit()->text() != shown_text_)
    QTimer::singleShot(0, this, [this] { show_state(!this->hasFocus()); });
  if (sentence_.isEmpty()) return;
  QPainter painter(this);
  constexpr int kPen = 2;  // px
  painter.setPen(QPen(
      meaning_colour(is_refused_ ? Meaning::kBad : Meaning::kDoubtful, this->palette()), kPen));
  painter.drawRect(this->rect().adjusted(1, 1, -1, -1));
}

template <class Spin>
void TypedSpin<Spin>::show_state(bool is_finished) {
  shown_text_ = this->lineEdit()->text();
  const QString refused = refusal();
  QString sentence = refused.isEmpty() ? warning() : refused;
  // Incomplete numbers are refused too; no note interrupts somebody who still types.
  if (!is_finished && sentence_.isEmpty()) return;
  if (!this->isEnabled() && refused.isEmpty()) sentence.clear();
  is_refused_ = !refused.isEmpty();
  if (sentence != sentence_) {
    if (sentence_.isEmpty()) {
      description_ = this->accessibleDescription();
      tip_ = this->toolTip();
    } else {  // a change in the meantime is newer
      if (this->accessibleDescription() != sentence_) description_ = this->accessibleDescription();
      if (this->toolTip() != sentence_) tip_ = this->toolTip();
    }
    this->setAccessibleDescription(sentence.isEmpty() ? description_ : sentence);
    this->setToolTip(sentence.isEmpty() ? tip_ : sentence);
    sentence_ = sentence;
  }
  if (!sentence.isEmpty() && note_ == nullptr) make_note();
  if (note_) {
    constexpr QChar kMark(0x25b2);
    note_->setText(QString(kMark) + QLatin1Char(' ') + sentence);
    note_->setVisible(!sentence.isEmpty() && this->isVisible());
    position_note();
  }
  this->update();
}

/// A row of its own below the field in a form; elsewhere it lies over what is below.
template <class Spin>
void TypedSpin<Spin>::make_note() {
  note_ = new QLabel;
  note_->setObjectName(QStringLiteral("number_note"));
  note_->setWordWrap(true);
  QWidget* const parent = this->parentWidget();
  if (QFormLayout* form = parent ? form_of(parent->layout(), this) : nullptr) {
    int row = 0;
    QFormLayout::ItemRole role = QFormLayout::FieldRole;
    form->getWidgetPosition(this, &row, &role);
    return form->insertRow(row + 1, note_);
  }
  note_->setParent(this->window() == this ? nullptr : this->window());
  note_->setAutoFillBackground(true);
  note_->setFrameShape(QFrame::Box);
  note_->setMargin(kSpacing / 2);
  note_->setAttribute(Qt::WA_TransparentForMouseEvents);
}

template <class Spin>
void TypedSpin<Spin>::position_note() {
  if (note_->frameShape() != QFrame::Box || note_->parentWidget() == nullptr) return;
  constexpr int kMinWidth = 240;  // px: a sentence in three lines
  const QWidget* window = note_->parentWidget();
  const int width = std::min(std::max(this->width(), kMinWidth), window->width());
  note_->setFixedWidth(width);
  note_->setFixedHeight(note_->heightForWidth(width));
  const QPoint below = this->mapTo(window, QPoint(0, this->height()));
  const int x = std::clamp(below.x(), 0, std::max(0, window->width() - width));
  const bool fits = below.y() + note_->height() <= window->height();
  note_->move(x, fits ? below.y() : below.y() - this->height() - note_->height());
  note_->raise();
}

template class TypedSpin<QDoubleSpinBox>;
template class TypedSpin<QSpinBox>;

NumberField::NumberField(QWidget* parent) : TypedSpin(parent) {
  setDecimals(kMaxDecimals);
  connect(lineEdit(), &QLineEdit::textChanged, this, &NumberField::text_changed);
  connect(this, &QDoubleSpinBox::valueChanged, this, &NumberField::text_changed);
}

void NumberField::set_shown_decimals(int decimals) {
  shown_decimals_ = decimals;
  setSuffix(suffix());  // writes the value again
}

Result<double> NumberField::parsed(const QString& text) const {
  const auto value = parse_typed_number(text.toStdString(),
                                        {window_decimal_mark(), suffix().trimmed().toStdString()});
  if (!value || QString::number(*value, 'f', kMaxDecimals).toDouble() == *value) return value;
  return Error{en::say("'{}' has too many digits after the decimal mark (at most {})",
                       text.toStdString(), kMaxDecimals),
               "", ""};
}

QString NumberField::written(double value, bool is_exact) const {
  int decimals = shown_decimals_;
  while (is_exact && decimals < kMaxDecimals &&
         QString::number(value, 'f', decimals).toDouble() != value)
    ++decimals;
  return ungrouped_locale().toString(value, 'f', decimals);
}

IntegerField::IntegerField(QWidget* parent) : TypedSpin(parent) {}

Result<int> IntegerField::parsed(const QString& text) const {
  const auto plain =
      plain_integer(text.toStdString(), {window_decimal_mark(), suffix().trimmed().toStdString()});
  if (!plain) return plain.error();
  int value = 0;
  const auto [end, status] = std::from_chars(plain->data(), plain->data() + plain->size(), value);
  if (status == std::errc{} && end == plain->data() + plain->size()) return value;
  return Error{en::say("'{}' is too large or too small a number", text.toStdString()), "", ""};
}

QString IntegerField::written(int value, bool /*is_exact*/) const {
  return ungrouped_locale().toString(value);
}

}  // namespace alltact
