#include "widgets/shell/new_finger_dialog.h"

#include "widgets/widget_base.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace alltact {

NewFingerDialog::NewFingerDialog(QWidget* parent)
    : FittedDialog(parent),
      form_(new QFormLayout),
      folder_(new QLineEdit),
      camera_(new QLineEdit),
      choose_folder_(new QPushButton),
      choose_camera_(new QPushButton),
      kind_(new QComboBox),
      polarity_(new QComboBox),
      width_(new NumberField),
      layer_(new NumberField),
      plane_(new NumberField),
      per_row_(new IntegerField),
      folder_row_(with_button(folder_, choose_folder_)),
      camera_row_(with_button(camera_, choose_camera_)),
      intro_(wrapped_label()),
      problems_(new ProblemList),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(intro_);
  layout->addWidget(problems_);
  layout->addLayout(form_);
  layout->addStretch(1);
  layout->addWidget(buttons_);
  for (int i = 0; i < 2; ++i) kind_->addItem({});
  for (int i = 0; i < 3; ++i) polarity_->addItem({});
  width_->set_quantity(kFaceWidth);
  width_->setValue(24);
  layer_->set_quantity(kLayerThickness);
  layer_->setValue(1.5);
  plane_->setRange(0, 10000);
  per_row_->setRange(0, 64);
  per_row_->setValue(6);
  form_->addRow(new QLabel, folder_row_);
  form_->addRow(new QLabel, camera_row_);
  for (QWidget* field :
       std::initializer_list<QWidget*>{kind_, width_, layer_, plane_, per_row_, polarity_})
    form_->addRow(new QLabel, field);
  for (QLineEdit* line : {folder_, camera_}) show_text_as_tip(*line);
  connect(kind_, &QComboBox::currentIndexChanged, this, &NewFingerDialog::show_kind);
  connect(choose_folder_, &QPushButton::clicked, this, &NewFingerDialog::choose_folder);
  connect(choose_camera_, &QPushButton::clicked, this, [this] {
    ask_for_file(
        this, tr("Camera file"), tr("Camera (*.yaml *.yml *.json *.xml *.cameramodel *.txt)"),
        [this](const QString& file) { camera_->setText(file); }, camera_->text());
  });
  connect(buttons_, &QDialogButtonBox::accepted, this, &NewFingerDialog::make);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  say([this] {
    setWindowTitle(tr("New finger"));
    intro_->setText(
        tr("Measure width and layer with a caliper, and count the dots. The camera file comes from "
           "the lens calibration, the first step of the Calibrate page."));
    const auto name = [this](QWidget* field, QWidget* focus, const QString& text) {
      auto* label = qobject_cast<QLabel*>(form_->labelForField(field));
      label->setText(text);
      label->setBuddy(focus);
      focus->setAccessibleName(QString(text).remove(QLatin1Char('&')));
    };
    name(folder_row_, folder_, tr("New &folder"));
    name(camera_row_, camera_, tr("&Camera file"));
    name(kind_, kind_, tr("&Kind"));
    name(width_, width_, tr("&Width of the face"));
    name(layer_, layer_, tr("Thickness of the &layer"));
    name(plane_, plane_, tr("Distance of the &plane"));
    name(per_row_, per_row_, tr("&Dots on each side"));
    name(polarity_, polarity_, tr("Dots &are"));
    kind_->setItemText(0, tr("Fin Ray finger: its shape is read from the face's edges"));
    kind_->setItemText(1, tr("Flat, rigid sensor"));
    polarity_->setItemText(0, tr("detected in the reference recording"));
    polarity_->setItemText(1, tr("brighter than surroundings"));
    polarity_->setItemText(2, tr("darker than surroundings"));
    for (NumberField* field : {width_, layer_, plane_}) field->setSuffix(tr(" mm"));
    choose_folder_->setText(tr("Choose…"));
    choose_camera_->setText(tr("Choose…"));
    choose_folder_->setAccessibleName(tr("Choose the folder"));
    choose_camera_->setAccessibleName(tr("Choose the camera file"));
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("&Make the finger"));
    buttons_->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
  });
  show_kind();
}

QWidget* NewFingerDialog::with_button(QLineEdit* line, QPushButton* button) {
  auto* row = new QWidget;
  auto* layout = without_margins(new QHBoxLayout(row));
  layout->addWidget(line, 1);
  layout->addWidget(button);
  line->setMinimumWidth(260);
  return row;
}

NewFinger NewFingerDialog::description() const {
  NewFinger finger;
  finger.finger = folder_->text().trimmed().toStdString();
  finger.camera = camera_->text().trimmed().toStdString();
  finger.kind = kind_->currentIndex() == 1 ? FaceKind::kFlat : FaceKind::kFinRay;
  finger.layer_mm = layer_->value();
  if (finger.kind == FaceKind::kFlat) {
    finger.plane_z_mm = plane_->value();
    return finger;
  }
  finger.width_mm = width_->value();
  finger.per_row = per_row_->value();
  constexpr Polarity kPolarities[] = {Polarity::kAuto, Polarity::kBright, Polarity::kDark};
  finger.polarity = kPolarities[polarity_->currentIndex()];
  return finger;
}

void NewFingerDialog::set_description(const NewFinger& known) {
  kind_->setCurrentIndex(known.kind == FaceKind::kFlat ? 1 : 0);
  if (!known.finger.empty()) folder_->setText(QString::fromStdString(known.finger.string()));
  if (!known.camera.empty()) camera_->setText(QString::fromStdString(known.camera.string()));
  for (const auto& [field, value] :
       {std::pair{width_, known.width_mm}, {layer_, known.layer_mm}, {plane_, known.plane_z_mm}})
    if (value > 0) field->setValue(value);
  if (known.per_row > 0) per_row_->setValue(known.per_row);
}

void NewFingerDialog::show_kind() {
  const bool is_flat = kind_->currentIndex() == 1;
  for (QWidget* field : std::initializer_list<QWidget*>{width_, per_row_, polarity_}) {
    field->setVisible(!is_flat);
    form_->labelForField(field)->setVisible(!is_flat);
  }
  plane_->setVisible(is_flat);
  form_->labelForField(plane_)->setVisible(is_flat);
}

void NewFingerDialog::choose_folder() {
  auto* dialog = new QFileDialog(this, tr("New folder"), folder_->text());
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  connect(dialog, &QFileDialog::fileSelected, folder_, &QLineEdit::setText);
  show_dialog(*dialog);
}

void NewFingerDialog::make() {
  for (NumberField* field : {width_, layer_, plane_}) {
    if (!field->isVisible()) continue;
    if (!field->typed()) return field->setFocus();
    field->interpretText();
  }
  if (per_row_->isVisible() && !per_row_->typed()) return per_row_->setFocus();
  per_row_->interpretText();
  const NewFinger finger = description();
  std::vector<Problem> problems;
  if (finger.finger.empty()) problems.push_back({Meaning::kBad, tr("No folder is chosen.")});
  if (finger.camera.empty())
    problems.push_back({Meaning::kBad, tr("No camera file is specified."),
                        tr("The first step of the Calibrate page creates it.")});
  problems_->set_problems(problems);
  if (!problems.empty()) return;
  buttons_->setEnabled(false);
  work_.start([this, finger](const Job&) {
    const auto created = make_finger(finger);
    return std::function<void()>([this, finger, created] {
      buttons_->setEnabled(true);
      if (!created) return problems_->set_problems({Problem::of(created.error())});
      Q_EMIT made(QString::fromStdString(finger.finger.string()));
      accept();
    });
  });
}

}  // namespace alltact
