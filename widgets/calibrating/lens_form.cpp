#include "widgets/calibrating/lens_form.h"

#include <QHBoxLayout>

namespace alltact {
namespace {

NumberField* number(double low, double high, int decimals, double value) {
  auto* box = new NumberField;
  box->setRange(low, high);
  box->set_shown_decimals(decimals);
  box->setValue(value);
  return box;
}

/// The typed number, also before editing is finished.
template <class Field>
auto now(const Field* field) {
  return field->typed().value_or(field->value());
}

}  // namespace

LensForm::LensForm(QWidget* parent)
    : Translated(parent),
      form_(new QFormLayout(this)),
      pattern_(new QComboBox),
      model_(new QComboBox),
      columns_(new IntegerField),
      rows_(new IntegerField),
      square_(number(0.01, 1000, 3, 5)),
      distance_(number(1, 10000, 1, LensSettings().distance_mm)),
      gap_(number(0, 1000, 2, 0)),
      plate_(number(0, 1000, 2, 2)),
      plate_index_(number(1, 3, 3, FlatPort().plate_index)),
      medium_index_(number(1, 3, 3, FlatPort().medium_index)),
      has_port_(new QCheckBox),
      pattern_label_(new QLabel),
      size_label_(new QLabel),
      square_label_(new QLabel),
      by_label_(new QLabel),
      model_label_(new QLabel),
      distance_label_(new QLabel),
      gap_label_(new QLabel),
      plate_label_(new QLabel),
      plate_index_label_(new QLabel),
      medium_index_label_(new QLabel) {
  square_->set_quantity(kBoardSquare);
  form_->setContentsMargins(0, 0, 0, 0);
  form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
  for (int i = 0; i < 3; ++i) pattern_->addItem({});
  for (int i = 0; i < 2; ++i) model_->addItem({});
  for (IntegerField* count : {columns_, rows_}) count->setRange(3, 100);
  columns_->setValue(9);
  rows_->setValue(6);
  auto* size = new QHBoxLayout;
  size->setSpacing(4);  // px: "9 by 6" stands in one line of the side
  size->addWidget(columns_);
  size->addWidget(by_label_);
  size->addWidget(rows_);
  size->addStretch();
  form_->addRow(pattern_label_, pattern_);
  form_->addRow(size_label_, size);
  form_->addRow(square_label_, square_);
  form_->addRow(model_label_, model_);
  form_->addRow(distance_label_, distance_);
  form_->addRow(has_port_);
  form_->addRow(gap_label_, gap_);
  form_->addRow(plate_label_, plate_);
  form_->addRow(plate_index_label_, plate_index_);
  form_->addRow(medium_index_label_, medium_index_);
  pattern_label_->setBuddy(pattern_);
  size_label_->setBuddy(columns_);
  square_label_->setBuddy(square_);
  connect(pattern_, &QComboBox::currentIndexChanged, this, &LensForm::board_changed);
  for (IntegerField* count : {columns_, rows_})
    connect(count, &IntegerField::valueChanged, this, &LensForm::board_changed);
  connect(square_, &NumberField::valueChanged, this, &LensForm::board_changed);
  connect(has_port_, &QCheckBox::toggled, this, &LensForm::show_port);
  say([this] { name_parts(); });
}

void LensForm::name_parts() {
  pattern_label_->setText(tr("&Board"));
  pattern_->setAccessibleName(tr("Board"));
  pattern_->setItemText(0, tr("Chessboard"));
  pattern_->setItemText(1, tr("ChArUco board"));
  pattern_->setItemText(2, tr("Grid of dots"));
  size_label_->setText(tr("&Inner corners, or dots"));
  columns_->setAccessibleName(tr("Inner corners in a row"));
  rows_->setAccessibleName(tr("Inner corners in a column"));
  by_label_->setText(tr("by"));
  square_label_->setText(tr("&Side of a square"));
  square_->setAccessibleName(tr("Side of a square"));
  model_label_->setText(tr("Lens"));
  model_->setAccessibleName(tr("Lens"));
  model_->setItemText(0, tr("usual (Brown)"));
  model_->setItemText(1, tr("fisheye"));
  distance_label_->setText(tr("Finger's distance"));
  distance_->setAccessibleName(tr("Distance from the lens to the finger's middle"));
  has_port_->setText(tr("The finger lies behind a window"));
  has_port_->setToolTip(
      tr("Tick it where the finger is seen through a plate into silicone and the board was seen "
         "in air"));
  gap_label_->setText(tr("Air before it"));
  gap_->setAccessibleName(tr("Air between lens and window"));
  plate_label_->setText(tr("Its thickness"));
  plate_->setAccessibleName(tr("Thickness of the window"));
  plate_index_label_->setText(tr("Its index"));
  plate_index_->setAccessibleName(tr("Index of refraction of the window"));
  medium_index_label_->setText(tr("Index behind it"));
  medium_index_->setAccessibleName(tr("Index of refraction behind the window"));
  for (NumberField* length : {square_, distance_, gap_, plate_}) length->setSuffix(tr(" mm"));
  show_port();
}

void LensForm::show_port() {
  for (QWidget* part : {static_cast<QWidget*>(gap_label_),
                        static_cast<QWidget*>(gap_),
                        static_cast<QWidget*>(plate_label_),
                        static_cast<QWidget*>(plate_),
                        static_cast<QWidget*>(plate_index_label_),
                        static_cast<QWidget*>(plate_index_),
                        static_cast<QWidget*>(medium_index_label_),
                        static_cast<QWidget*>(medium_index_)})
    part->setVisible(has_port_->isChecked());
}

Board LensForm::board() const {
  constexpr BoardPattern kPatterns[] = {
      BoardPattern::kChessboard, BoardPattern::kCharuco, BoardPattern::kDots};
  Board board;
  board.pattern = kPatterns[pattern_->currentIndex()];
  board.columns = now(columns_);
  board.rows = now(rows_);
  board.square_mm = now(square_);
  return board;
}

LensSettings LensForm::settings() const {
  LensSettings settings;
  settings.pattern = board().pattern;
  settings.model = model_->currentIndex() == 0 ? CameraModel::kBrown : CameraModel::kFisheye;
  settings.distance_mm = now(distance_);
  return settings;
}

std::optional<FlatPort> LensForm::port() const {
  if (!has_port_->isChecked()) return std::nullopt;
  return FlatPort{now(gap_), now(plate_), now(plate_index_), now(medium_index_)};
}

QString LensForm::refusal() const {
  for (const NumberField* field : findChildren<NumberField*>())
    if (field->isVisibleTo(this) && !field->typed()) return field->refusal();
  for (const IntegerField* field : findChildren<IntegerField*>())
    if (field->isVisibleTo(this) && !field->typed()) return field->refusal();
  return {};
}

}  // namespace alltact
