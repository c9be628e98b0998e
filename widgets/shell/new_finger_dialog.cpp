#include "widgets/shell/new_finger_dialog.h"

#include "calibration/reference/reference_recording.h"
#include "core/base/atomic_file.h"
#include "widgets/widget_base.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace alltact {
namespace {

constexpr int kProblemsHeight_px = 76;  // two problems of two lines
constexpr double kMostMmPerPx = 10;

/// What the dialog makes in the folder.
struct Described {
  NewFinger finger;
  double mm_per_px = 0;         ///< of a flat sensor without a camera file
  std::filesystem::path image;  ///< untouched, of a flat sensor; empty: none yet
};

/// Looks straight at the face: every pixel shows the same size.
CameraParameters camera_of_pixel(double mm_per_px, const cv::Size& size) {
  CameraParameters camera;
  camera.model = CameraModel::kOrthographic;
  camera.width_px = size.width;
  camera.height_px = size.height;
  camera.cx_px = 0.5 * (size.width - 1);
  camera.cy_px = 0.5 * (size.height - 1);
  camera.mm_per_px = mm_per_px;
  return camera;
}

Status make_described(Described described) {
  NewFinger& finger = described.finger;
  std::optional<UntouchedImage> image;
  if (!described.image.empty()) {
    auto read = read_untouched_image(described.image);
    if (!read) return read.error();
    image = std::move(*read);
  }
  if (finger.camera.empty() && image) {
    if (const Status made = make_folder(finger.finger); !made) return made;
    finger.camera = finger.finger / "camera.yaml";
    const Status saved =
        save_camera(finger.camera, camera_of_pixel(described.mm_per_px, image->grey.size()));
    if (!saved) return saved;
  }
  if (const auto made = make_finger(finger); !made) return made.error();
  if (!image) return {};
  const auto installed = set_untouched_image(finger.finger, *image);
  return installed ? Status() : Status(installed.error());
}

}  // namespace

NewFingerDialog::NewFingerDialog(QWidget* parent)
    : FittedDialog(parent),
      form_(new QFormLayout),
      folder_(new QLineEdit),
      camera_(new QLineEdit),
      image_(new QLineEdit),
      choose_folder_(new QPushButton),
      choose_camera_(new QPushButton),
      choose_image_(new QPushButton),
      kind_(new QComboBox),
      polarity_(new QComboBox),
      width_(new NumberField),
      layer_(new NumberField),
      plane_(new NumberField),
      pixel_(new NumberField),
      per_row_(new IntegerField),
      folder_row_(with_button(folder_, choose_folder_)),
      camera_row_(with_button(camera_, choose_camera_)),
      image_row_(with_button(image_, choose_image_)),
      intro_(wrapped_label()),
      problems_(new ProblemList),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(intro_);
  layout->addLayout(form_);
  // Room for what is missing, in full, next to the button that finds it.
  problems_->show_in_full();
  problems_->setMinimumHeight(kProblemsHeight_px);
  layout->addWidget(problems_, 1, Qt::AlignTop);
  layout->addWidget(buttons_);
  for (int i = 0; i < 2; ++i) kind_->addItem({});
  for (int i = 0; i < 3; ++i) polarity_->addItem({});
  width_->set_quantity(kFaceWidth);
  width_->setValue(24);
  layer_->set_quantity(kLayerThickness);
  layer_->setValue(1.5);
  plane_->setRange(0, 10000);
  pixel_->setRange(0, kMostMmPerPx);
  pixel_->set_shown_decimals(4);
  pixel_->setSingleStep(0.001);
  per_row_->setRange(0, 64);
  per_row_->setValue(6);
  form_->addRow(new QLabel, folder_row_);
  form_->addRow(new QLabel, camera_row_);
  for (QWidget* field : std::initializer_list<QWidget*>{kind_, width_, layer_, plane_, pixel_,
                                                        image_row_, per_row_, polarity_})
    form_->addRow(new QLabel, field);
  for (QLineEdit* line : {folder_, camera_, image_}) show_text_as_tip(*line);
  for (QPushButton* button : {choose_folder_, choose_camera_, choose_image_})
    button->setAutoDefault(false);
  buttons_->button(QDialogButtonBox::Ok)->setDefault(true);
  connect(kind_, &QComboBox::currentIndexChanged, this, &NewFingerDialog::show_kind);
  connect(choose_folder_, &QPushButton::clicked, this, &NewFingerDialog::choose_folder);
  connect(choose_camera_, &QPushButton::clicked, this, [this] {
    ask_for_file(
        this, FilesOf::kCameras, tr("Camera file"),
        tr("Camera (*.yaml *.yml *.json *.xml *.cameramodel *.txt)"),
        [this](const QString& file) { camera_->setText(file); }, camera_->text());
  });
  connect(choose_image_, &QPushButton::clicked, this, [this] {
    ask_for_file(
        this, FilesOf::kImages, tr("Untouched image"), image_filter(),
        [this](const QString& file) { image_->setText(file); }, image_->text());
  });
  connect(buttons_, &QDialogButtonBox::accepted, this, &NewFingerDialog::make);
  connect(buttons_, &QDialogButtonBox::rejected, this, &NewFingerDialog::reject);
  say([this] {
    setWindowTitle(tr("New finger"));
    intro_->setText(
        tr("Measure width and layer with a caliper, and count the dots. The camera file comes from "
           "the lens calibration, the first step of the Calibrate page."));
    const auto name = [this](QWidget* field, QWidget* focus, const QString& text) {
      auto* label = qobject_cast<QLabel*>(form_->labelForField(field));
      label->setText(text);
      label->setBuddy(focus);
      focus->setAccessibleName(without_mnemonic(text));
    };
    name(folder_row_, folder_, tr("New &folder"));
    name(camera_row_, camera_, tr("&Camera file"));
    name(kind_, kind_, tr("&Kind"));
    name(width_, width_, tr("&Width of the face"));
    name(layer_, layer_, tr("Thickness of the &layer"));
    name(plane_, plane_, tr("Distance of the &plane"));
    name(pixel_, pixel_, tr("&Size of a pixel"));
    name(image_row_, image_, tr("&Untouched image"));
    name(per_row_, per_row_, tr("&Dots on each side"));
    name(polarity_, polarity_, tr("Dots &are"));
    kind_->setItemText(0, tr("Fin Ray finger: its shape is read from the face's edges"));
    kind_->setItemText(1, tr("Flat, rigid sensor"));
    kind_->setToolTip(tr("Whether the face bends"));
    polarity_->setItemText(0, tr("detected in the reference recording"));
    polarity_->setItemText(1, tr("brighter than surroundings"));
    polarity_->setItemText(2, tr("darker than surroundings"));
    polarity_->setToolTip(tr("How the dots differ from the skin around them"));
    for (NumberField* field : {width_, layer_, plane_}) field->setSuffix(tr(" mm"));
    pixel_->setSuffix(tr(" mm"));
    pixel_->setSpecialValueText(tr("from the camera file"));
    per_row_->setToolTip(tr("Counted on one side of the face; 0 for none"));
    plane_->setToolTip(tr("From the lens to the face"));
    layer_->setToolTip(tr("Of the translucent layer; no depth is larger"));
    width_->setToolTip(tr("From edge to edge, by caliper"));
    pixel_->setToolTip(tr("On the face, for a camera that looks straight at it"));
    choose_image_->setText(tr("Choose…"));
    choose_image_->setToolTip(tr("An image of the face without contact"));
    choose_image_->setAccessibleName(tr("Choose the untouched image"));
    choose_folder_->setText(tr("Choose…"));
    choose_folder_->setToolTip(tr("Chooses where the finger's folder is made"));
    choose_camera_->setText(tr("Choose…"));
    choose_camera_->setToolTip(tr("The file that the lens calibration wrote"));
    choose_folder_->setAccessibleName(tr("Choose the folder"));
    choose_camera_->setAccessibleName(tr("Choose the camera file"));
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("&Make the finger"));
    buttons_->button(QDialogButtonBox::Ok)
        ->setToolTip(tr("Writes the folder and opens the finger"));
    buttons_->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    buttons_->button(QDialogButtonBox::Cancel)
        ->setToolTip(tr("Closes this window without a change (Esc)"));
  });
  show_kind();
  known_ = entries();
}

QStringList NewFingerDialog::entries() const {
  QStringList entries;
  for (const auto* line : findChildren<QLineEdit*>()) entries << line->text();
  for (const QComboBox* choice : {kind_, polarity_})
    entries << QString::number(choice->currentIndex());
  return entries;
}

void NewFingerDialog::showEvent(QShowEvent* event) {
  FittedDialog::showEvent(event);
  QWidget* first = kind_;
  if (camera_->text().isEmpty()) first = camera_;
  if (folder_->text().isEmpty()) first = folder_;
  first->setFocus();
}

void NewFingerDialog::reject() {
  if (entries() == known_) return FittedDialog::reject();
  auto* box = new QMessageBox(QMessageBox::Question, tr("New finger"),
                              tr("The finger is not made yet. Discard what was entered?"),
                              QMessageBox::NoButton, this);
  auto* discard = box->addButton(tr("&Discard"), QMessageBox::DestructiveRole);
  auto* go_on = box->addButton(tr("&Go on"), QMessageBox::RejectRole);
  box->setDefaultButton(go_on);
  box->setEscapeButton(go_on);
  connect(discard, &QPushButton::clicked, this, [this] { FittedDialog::reject(); });
  show_dialog(*box);
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
  known_ = entries();
}

void NewFingerDialog::show_kind() {
  const bool is_flat = kind_->currentIndex() == 1;
  for (QWidget* field : std::initializer_list<QWidget*>{width_, per_row_, polarity_}) {
    field->setVisible(!is_flat);
    form_->labelForField(field)->setVisible(!is_flat);
  }
  for (QWidget* field : std::initializer_list<QWidget*>{plane_, pixel_, image_row_}) {
    field->setVisible(is_flat);
    form_->labelForField(field)->setVisible(is_flat);
  }
}

void NewFingerDialog::choose_folder() {
  auto* dialog = new QFileDialog(this, tr("New folder"), folder_->text());
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  if (folder_->text().isEmpty()) begin_in_last_folder(*dialog, FilesOf::kFingers);
  connect(dialog, &QFileDialog::fileSelected, folder_, &QLineEdit::setText);
  show_dialog(*dialog);
}

void NewFingerDialog::make() {
  for (NumberField* field : {width_, layer_, plane_, pixel_}) {
    if (!field->isVisible()) continue;
    if (!field->typed()) return field->setFocus();
    field->interpretText();
  }
  if (per_row_->isVisible() && !per_row_->typed()) return per_row_->setFocus();
  per_row_->interpretText();
  const auto found = missing();
  std::vector<Problem> problems;
  for (const auto& [problem, field] : found) problems.push_back(problem);
  problems_->set_problems(problems);
  if (!found.empty()) return found.front().second->setFocus();
  Described described;
  described.finger = description();
  if (described.finger.kind == FaceKind::kFlat) {
    described.mm_per_px = pixel_->value();
    described.image = image_->text().trimmed().toStdString();
  }
  buttons_->setEnabled(false);
  work_.start([this, described](const Job&) {
    const Status created = make_described(described);
    return std::function<void()>([this, described, created] {
      buttons_->setEnabled(true);
      folder_->setFocus();
      if (!created) return problems_->set_problems({Problem::of(created.error())});
      Q_EMIT made(QString::fromStdString(described.finger.finger.string()));
      accept();
    });
  });
}

std::vector<std::pair<Problem, QWidget*>> NewFingerDialog::missing() const {
  std::vector<std::pair<Problem, QWidget*>> missing;
  if (folder_->text().trimmed().isEmpty())
    missing.push_back({{Meaning::kBad, tr("No folder is chosen.")}, folder_});
  if (!camera_->text().trimmed().isEmpty()) return missing;
  if (kind_->currentIndex() == 0)
    missing.push_back({{Meaning::kBad, tr("No camera file is specified."),
                        tr("The first step of the Calibrate page creates it.")},
                       camera_});
  else if (!(pixel_->value() > 0) || image_->text().trimmed().isEmpty())
    missing.push_back({{Meaning::kBad, tr("The camera is not described."),
                        tr("Choose its file, or enter the size of a pixel and choose the untouched "
                           "image.")},
                       pixel_->value() > 0 ? static_cast<QWidget*>(image_) : pixel_});
  return missing;
}

}  // namespace alltact
