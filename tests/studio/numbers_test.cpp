// Numbers typed into every field of the window, in three languages: the value that a person means,
// or a refusal that stays in sight; never another value.
#include "app/studio/main_window.h"
#include "core/base/typed_number.h"
#include "tests/studio/studio_rig.h"
#include "tests/support/typed_numbers.h"
#include "widgets/controls/control_panel.h"
#include "widgets/controls/number_field.h"
#include "widgets/inspect/finger_pair.h"
#include "widgets/shell/new_finger_dialog.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QFormLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/videodev2.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

void key(QWidget& field, int code, const QString& text = {}) {
  QKeyEvent press(QEvent::KeyPress, code, Qt::NoModifier, text);
  QApplication::sendEvent(&field, &press);
  QKeyEvent release(QEvent::KeyRelease, code, Qt::NoModifier, text);
  QApplication::sendEvent(&field, &release);
}

/// Key by key in place of all that stands there.
void type(QAbstractSpinBox& field, const QString& text) {
  field.selectAll();
  key(field, Qt::Key_Backspace);
  for (const QChar letter : text) key(field, letter.unicode(), QString(letter));
}

/// The example in the unit of a field; nullopt where it is about a unit that the field has not.
std::optional<QString> in_unit_of(const QString& suffix, const TypedExample& example) {
  QString text = QString::fromStdString(example.text);
  const bool is_of_units = text.contains(QRegularExpression(QStringLiteral("[a-zµ%四\"]")));
  const QString unit = suffix.trimmed();
  if (!is_of_units || unit == QLatin1String("mm")) return text;
  if (!text.contains(QLatin1String("mm")) || unit.isEmpty() || !example.with_point)
    return std::nullopt;
  return text.replace(QLatin1String("mm"), unit);
}

/// Without what the field adds.
template <class Field>
QString typed_in(const Field& field, const QString& wanted) {
  QString text = field.text();
  if (text == wanted) return text;  // in place of words such as "not measured"
  if (text.startsWith(field.prefix())) text.remove(0, field.prefix().size());
  if (text.endsWith(field.suffix())) text.chop(field.suffix().size());
  return text;
}

template <class Field>
void expect_meanings(Field& field, const std::string& language, int& taken) {
  const QSignalBlocker quiet(field);  // nobody acts on a thousand numbers
  const DecimalMark mark = language == "de" ? DecimalMark::kComma : DecimalMark::kPoint;
  for (const TypedExample& example : typed_examples()) {
    const auto text = in_unit_of(field.suffix(), example);
    const bool is_nothing = text && text->trimmed().isEmpty();
    const bool is_typable = text && !text->contains(QRegularExpression(QStringLiteral("[\n\t]")));
    if (!is_typable || (is_nothing && !field.specialValueText().isEmpty())) continue;
    SCOPED_TRACE(fmt::format("{} in '{}' ({})", text->toStdString(),
                             field.accessibleName().toStdString(), language));
    key(field, Qt::Key_Escape);
    field.setValue(field.maximum());
    field.setValue(field.minimum());
    field.stepBy(1);
    const auto before = field.value();
    type(field, *text);
    ASSERT_EQ(typed_in(field, *text), *text) << "a key was dropped";
    key(field, Qt::Key_Return);
    const auto& meant = mark == DecimalMark::kPoint ? example.with_point : example.with_comma;
    if (field.typed()) {
      const auto shown = parse_typed_number(field.cleanText().toStdString(), {mark, {}});
      const bool is_special =
          !field.specialValueText().isEmpty() && field.value() == field.minimum();
      ASSERT_TRUE(meant.has_value());
      ASSERT_TRUE(is_special || shown.ok()) << field.cleanText().toStdString();
      ASSERT_EQ(is_special ? field.minimum() : *shown, *meant);
      ASSERT_TRUE(field.refusal().isEmpty());
      ++taken;
    } else {
      ASSERT_EQ(field.value(), before) << "what is refused changes nothing";
      ASSERT_FALSE(field.refusal().isEmpty());
      ASSERT_EQ(typed_in(field, *text), *text) << "what is refused stays";
      ASSERT_EQ(field.accessibleDescription(), field.refusal());
      if (std::is_same_v<Field, NumberField> && meant) {
        ASSERT_TRUE(*meant < static_cast<double>(field.minimum()) ||
                    *meant > static_cast<double>(field.maximum()) ||
                    field.refusal().contains(QLatin1String("mm")));
      }
    }
  }
}

CameraControl exposure() {
  CameraControl control;
  control.id = V4L2_CID_EXPOSURE_ABSOLUTE;
  control.name = "Exposure Time, Absolute";
  control.type = ControlType::kInteger;
  control.low = 3, control.high = 20470, control.step = 1, control.value = 200;
  CameraControl gain = control;
  gain.id = V4L2_CID_GAIN;
  gain.name = "Gain";
  return control;
}

class Numbers : public testing::TestWithParam<const char*> {
 protected:
  Numbers() { appearance_.apply({Theme::kLight, QLatin1String(GetParam())}); }
  ~Numbers() override { appearance_.apply({Theme::kLight, QStringLiteral("en")}); }
  ProgramAppearance appearance_;
};
INSTANTIATE_TEST_SUITE_P(Language, Numbers, testing::Values("en", "de", "zh_CN"));

TEST_P(Numbers, InEveryFieldMeanWhatAPersonMeansOrAreRefused) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  options.source = {MadeFingers::get().touched()};
  Studio studio(options);
  for (const char* language : {"en", GetParam()})  // anew, whatever the window has set
    appearance_.apply({Theme::kLight, QLatin1String(language)});
  ASSERT_TRUE(studio.wait_for_picture());
  for (const char* place : {"calibrate", "record", "inspect", "accuracy", "live"})
    studio.window().go_to(place);
  NewFingerDialog maker;
  GripperDialog gripper(QStringLiteral("left"), std::nullopt);
  ControlPanel controls;
  controls.set_controls({exposure()}, false);
  int fields = 0, taken = 0;
  for (QWidget* root :
       std::initializer_list<QWidget*>{&studio.window(), &maker, &gripper, &controls}) {
    for (QAbstractSpinBox* field : root->findChildren<QAbstractSpinBox*>()) {
      ++fields;
      for (QWidget* part = field; part != nullptr; part = part->parentWidget())
        part->setEnabled(true);
      if (auto* number = qobject_cast<NumberField*>(field))
        expect_meanings(*number, GetParam(), taken);
      else if (auto* whole = qobject_cast<IntegerField*>(field))
        expect_meanings(*whole, GetParam(), taken);
      else
        ADD_FAILURE() << field->accessibleName().toStdString() << " is no NumberField but "
                      << field->metaObject()->className();
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GE(fields, 30);
  EXPECT_GE(taken, 1000);
}

}  // namespace
}  // namespace alltact::test
