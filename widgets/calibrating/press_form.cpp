#include "widgets/calibrating/press_form.h"

#include <QFormLayout>
#include <QSignalBlocker>

namespace alltact {
namespace {

constexpr double kMinSdMm = 0.001;  // smallest value that the field shows

/// Sets the value without a change signal.
void show_value(NumberField* field, double value) {
  const QSignalBlocker quiet(field);
  field->setValue(value);
}

}  // namespace

PressForm::PressForm(PressCollection& collection, QWidget* parent)
    : Translated(parent),
      collection_(collection),
      radius_label_(new QLabel),
      depth_label_(new QLabel),
      depth_sd_label_(new QLabel),
      step_label_(new QLabel),
      radius_(new NumberField),
      depth_(new NumberField),
      depth_sd_(new NumberField),
      step_(new NumberField) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  const auto add = [form](QLabel* label, NumberField* field, const Quantity& is, double step) {
    field->set_quantity(is);
    field->setMinimum(0);  // 0: unknown
    field->set_shown_decimals(3);
    field->setSingleStep(step);
    label->setBuddy(field);
    form->addRow(label, field);
  };
  add(radius_label_, radius_, kBallRadius, 0.1);
  add(depth_label_, depth_, kPressDepth, 0.1);
  add(depth_sd_label_, depth_sd_, kDepthSd, 0.005);
  depth_sd_->setMinimum(kMinSdMm);
  add(step_label_, step_, kStepHeight, 0.1);
  connect(radius_, &NumberField::valueChanged, this, [this](double value) {
    collection_.set_radius_of(shown_, value);
  });
  connect(depth_, &NumberField::valueChanged, this, [this](double value) {
    const auto before = collection_.press_set().of(shown_).depth;
    collection_.set_depth_of(shown_, {value, before ? before->sd_mm : kTypicalDepthSdMm});
  });
  connect(depth_sd_, &NumberField::valueChanged, this, [this](double value) {
    if (const auto before = collection_.press_set().of(shown_).depth)
      collection_.set_depth_of(shown_, {before->mm, value});
  });
  connect(step_, &NumberField::valueChanged, this, [this](double value) {
    collection_.set_step_of(shown_, value);
  });
  say([this] { name_parts(); });
}

void PressForm::name_parts() {
  for (NumberField* field : {radius_, depth_, depth_sd_, step_}) field->setSuffix(tr(" mm"));
  radius_label_->setText(tr("&Its ball"));
  radius_->setAccessibleName(tr("Radius of this press' ball"));
  radius_->setToolTip(tr("Where this press was made with a ball of another radius"));
  depth_label_->setText(tr("Measured &depth"));
  depth_->setAccessibleName(tr("Measured depth of this press"));
  depth_->setSpecialValueText(tr("not measured"));
  depth_->setToolTip(
      tr("How deep the ball was pressed in, normal to the face, from where it first "
         "touches, as a stage or a feeler gauge tells it"));
  depth_sd_label_->setText(tr("&Give or take"));
  depth_sd_->setAccessibleName(tr("Standard deviation of the measured depth"));
  depth_sd_->setToolTip(tr("How well the depth is known: the standard deviation of measuring it"));
  step_label_->setText(tr("&Step of a punch"));
  step_->setAccessibleName(tr("Step of a punch"));
  step_->setSpecialValueText(tr("a ball"));
  step_->setToolTip(
      tr("Height of the step of a flat punch that was pressed in instead of a ball; no ball is "
         "looked for then"));
}

void PressForm::show_press(const std::string& name) {
  shown_ = name;
  const PressNote& note = collection_.press_set().of(name);
  const bool is_ball = !note.step_mm;
  show_value(radius_, collection_.press_set().radius_of(name));
  show_value(depth_, note.depth ? note.depth->mm : 0.0);
  show_value(depth_sd_, note.depth ? note.depth->sd_mm : kTypicalDepthSdMm);
  show_value(step_, note.step_mm.value_or(0.0));
  const auto enable = [](QLabel* label, NumberField* field, bool is_enabled) {
    label->setEnabled(is_enabled);
    field->setEnabled(is_enabled);
  };
  enable(radius_label_, radius_, is_ball);
  enable(depth_label_, depth_, is_ball);
  enable(depth_sd_label_, depth_sd_, is_ball && note.depth);
  enable(step_label_, step_, !is_ball || !note.depth);
}

}  // namespace alltact
