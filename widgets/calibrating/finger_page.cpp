#include "widgets/calibrating/finger_page.h"

#include "calibration/reference/reference_recording.h"
#include "core/finger/finger_store.h"
#include "widgets/shell/page.h"
#include "widgets/undo_step.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace alltact {
namespace {

constexpr int kFingerSideWidth = 280;

QString geometry_text(const Finger& finger) {
  const QLocale locale;
  const auto mm = [&](double value) { return locale.toString(value, 'g', 4); };
  if (finger.face.kind == FaceKind::kFlat)
    return FingerPage::tr("A flat, rigid sensor with a layer of %1 mm, %2 mm from the camera.")
        .arg(mm(finger.face.layer_mm), mm(finger.face.plane_z_mm));
  return FingerPage::tr(
             "A Fin Ray finger whose face is %1 mm wide, with a layer of %2 mm and %3 dots on each "
             "side.")
      .arg(mm(finger.face.width_mm), mm(finger.face.layer_mm))
      .arg(finger.markers.per_row);
}

}  // namespace

FingerPage::FingerPage(LiveSession& session, QUndoStack& undo, QWidget* parent)
    : StepPage(parent),
      session_(session),
      undo_(undo),
      live_(new ImagePanel(session)),
      geometry_group_(new QGroupBox),
      reference_group_(new QGroupBox),
      geometry_(wrapped_text()),
      reference_(new ReservedText),
      make_(new QPushButton),
      open_(new QPushButton),
      record_(new QPushButton),
      reference_image_(new QPushButton),
      reference_file_(new QPushButton),
      width_label_(new QLabel),
      layer_label_(new QLabel),
      width_(new NumberField),
      layer_(new NumberField),
      sizes_(new QWidget),
      change_(new QPushButton) {
  auto* column = without_margins(new QVBoxLayout(this));
  auto* row = new QHBoxLayout;
  row->addWidget(live_, 1);
  row->addWidget(make_side());
  column->addLayout(row, 1);
  ViewOptions options;
  options.direction = options.depth = false;
  live_->set_options(options);
  connect_parts();
  say([this] { name_parts(); });
}

QWidget* FingerPage::make_side() {
  const SidePanel side(kFingerSideWidth);
  auto* geometry = new QVBoxLayout(geometry_group_);
  geometry->addWidget(geometry_);
  auto* form = without_margins(new QFormLayout(sizes_));
  for (NumberField* size : {width_, layer_}) {
    size->set_shown_decimals(2);
    size->setSingleStep(0.1);
  }
  width_->set_quantity(kFaceWidth);
  layer_->set_quantity(kLayerThickness);
  width_label_->setBuddy(width_);
  layer_label_->setBuddy(layer_);
  form->addRow(width_label_, width_);
  form->addRow(layer_label_, layer_);
  form->addRow(change_);
  geometry->addWidget(sizes_);
  add_widgets(*geometry, {make_, open_});
  side.column->addWidget(geometry_group_);
  auto* reference = new QVBoxLayout(reference_group_);
  reference->addWidget(reference_);
  add_widgets(*reference, {record_, reference_image_, reference_file_});
  side.column->addWidget(reference_group_);
  side.column->addStretch();
  foot_ = side.foot;
  return side.root;
}

void FingerPage::connect_parts() {
  connect(make_, &QPushButton::clicked, this, &FingerPage::make_finger);
  connect(open_, &QPushButton::clicked, this, &FingerPage::open_finger_requested);
  connect(record_, &QPushButton::clicked, this, &FingerPage::record_requested);
  connect(reference_image_, &QPushButton::clicked, this, &FingerPage::take_reference_image);
  connect(reference_file_, &QPushButton::clicked, this, &FingerPage::choose_reference_image);
  connect(change_, &QPushButton::clicked, this, &FingerPage::change_sizes);
  for (NumberField* size : {width_, layer_})
    connect(size, &NumberField::text_changed, this, &FingerPage::show_sizes);
}

void FingerPage::name_parts() {
  geometry_group_->setTitle(tr("Geometry"));
  reference_group_->setTitle(tr("Untouched finger"));
  make_->setText(tr("&Make the finger's folder…"));
  make_->setToolTip(tr("Stores this finger on disk, so that it can be calibrated"));
  open_->setText(tr("&Open a finger…"));
  open_->setToolTip(tr("Chooses the folder of a finger that exists"));
  record_->setText(tr("&Go to Record"));
  record_->setToolTip(tr("There the reference of the untouched finger is recorded"));
  reference_image_->setText(tr("Take the &untouched image now"));
  reference_image_->setToolTip(
      tr("The present image becomes the reference; nothing may touch the face"));
  reference_file_->setText(tr("Untouched image from a &file…"));
  reference_file_->setToolTip(tr("A stored image of the untouched face becomes the reference"));
  width_label_->setText(tr("&Width of the face"));
  width_->setAccessibleName(tr("Width of the face"));
  width_->setToolTip(tr("From edge to edge, by caliper"));
  layer_label_->setText(tr("&Layer thickness"));
  layer_->setAccessibleName(tr("Layer thickness"));
  layer_->setToolTip(tr("Of the translucent layer; no depth is larger"));
  for (NumberField* size : {width_, layer_}) size->setSuffix(tr(" mm"));
  change_->setText(tr("&Change"));
  change_->setToolTip(tr("A calibrated finger then needs a new calibration."));
  reference_->reserve_for({reference_text(false, false), reference_text(true, false)});
  show_status();
}

/// A typed value stays in its field until it is applied.
void FingerPage::show_sizes() {
  if (is_reloading()) return change_->setEnabled(false);  // saved, waiting to be loaded
  sizes_->setVisible(has_folder());
  if (!has_folder()) return;
  const Face& face = session_.status().finger.finger->face;
  width_->setVisible(face.kind == FaceKind::kFinRay);
  width_label_->setVisible(face.kind == FaceKind::kFinRay);
  const auto width = width_->typed(), layer = layer_->typed();
  const bool has_width = face.kind == FaceKind::kFinRay;
  change_->setEnabled(width && layer &&
                      ((has_width && *width != face.width_mm) || *layer != face.layer_mm));
}

void FingerPage::change_sizes() {
  if (!has_folder()) return;
  const FingerStatus& finger = session_.status().finger;
  const Face& face = finger.finger->face;
  const auto width = width_->typed(), layer = layer_->typed();
  if (!width || !layer) return;
  const Sizes requested(face.kind == FaceKind::kFinRay ? *width : face.width_mm, *layer);
  undo_.push(new ValueChange<Sizes>(
      [] { return tr("change the finger's sizes"); }, Sizes(face.width_mm, face.layer_mm),
      requested,
      [this, folder = finger.folder](const Sizes& sizes) { write_sizes(folder, sizes); }));
}

void FingerPage::write_sizes(const std::filesystem::path& folder, const Sizes& sizes) {
  disk_.add(folder, [folder, sizes]() -> Status {
    const auto changed = FingerStore::of(folder)->update([&](Finger& finger) -> Status {
      finger.face.width_mm = sizes.first;
      finger.face.layer_mm = sizes.second;
      return {};
    });
    return changed ? Status() : changed.error();
  });
}

bool FingerPage::has_folder() const {
  const FingerStatus& finger = session_.status().finger;
  return finger.state == FingerState::kReady && !finger.folder.empty() && finger.finger;
}

const QPushButton* FingerPage::action_button() const {
  const FingerStatus& finger = session_.status().finger;
  if (finger.state == FingerState::kLoading) return nullptr;
  if (!has_folder()) return make_;
  if (finger.has_reference) return nullptr;
  return finger.finger->face.kind == FaceKind::kFlat ? reference_image_ : record_;
}

bool FingerPage::is_reloading() const {
  return was_complete_ && session_.status().finger.state == FingerState::kLoading;
}

StepState FingerPage::state() const {
  return missing().isEmpty() ? StepState::kDone : StepState::kToDo;
}

QString FingerPage::missing() const {
  const FingerStatus& finger = session_.status().finger;
  if (is_reloading()) return {};
  if (finger.state == FingerState::kLoading) return tr("The finger is being loaded.");
  if (!has_folder()) return tr("The finger needs a folder of its own: make one, or open one.");
  if (finger.has_reference) return {};
  return finger.finger->face.kind == FaceKind::kFlat
             ? tr("The untouched image is missing: take it.")
             : tr("The reference recording is missing: record the finger bending, untouched.");
}

void FingerPage::show_status() {
  const FingerStatus& finger = session_.status().finger;
  if (is_reloading()) return show_sizes();
  if (finger.state != FingerState::kLoading) was_complete_ = missing().isEmpty();
  make_->setVisible(!has_folder());
  geometry_->setText(has_folder() ? geometry_text(*finger.finger)
                                  : tr("Measure width and layer with a caliper, and count the "
                                       "dots. One folder holds all data of one finger."));
  reference_group_->setVisible(has_folder());
  if (!has_folder()) return show_sizes();
  const Sizes sizes(finger.finger->face.width_mm, finger.finger->face.layer_mm);
  if (shown_folder_ != finger.folder || shown_sizes_ != sizes) {
    const QSignalBlocker quiet_width(width_), quiet_layer(layer_);
    width_->setValue(sizes.first);
    layer_->setValue(sizes.second);
    shown_folder_ = finger.folder;
    shown_sizes_ = sizes;
  }
  show_sizes();
  if (const auto write_problem = disk_.problem()) set_problems({Problem::of(*write_problem)});
  const bool is_flat = finger.finger->face.kind == FaceKind::kFlat;
  record_->setVisible(!is_flat);
  for (QPushButton* button : {reference_image_, reference_file_}) button->setVisible(is_flat);
  reference_image_->setEnabled(session_.view() != nullptr && !work_.is_running());
  reference_file_->setEnabled(!work_.is_running());
  reference_->setText(reference_text(is_flat, finger.has_reference));
}

QString FingerPage::reference_text(bool is_flat, bool has_reference) {
  if (has_reference)
    return is_flat ? tr("The untouched image is available.")
                   : tr("The reference recording is installed.");
  return is_flat ? tr("Every press is compared with one image of the untouched face.")
                 : tr("Every press is compared with an image of the finger in the same bend, "
                      "untouched. "
                      "Record the finger bending in all directions, then install the recording.");
}

void FingerPage::make_finger() {
  NewFinger known;
  known.camera = camera_file_;
  const FingerStatus& finger = session_.status().finger;
  if (finger.finger && finger.folder.empty()) {  // a simulated finger, described by its scene
    known.kind = finger.finger->face.kind;
    known.width_mm = finger.finger->face.width_mm;
    known.layer_mm = finger.finger->face.layer_mm;
    known.plane_z_mm = finger.finger->face.plane_z_mm;
    known.per_row = finger.finger->markers.per_row;
  }
  Q_EMIT new_finger_requested(known);
}

void FingerPage::take_reference_image() {
  if (!has_folder() || !session_.view()) return;
  const FramePtr frame = session_.view()->result.frame;
  if (!frame) return;
  install_reference_image([frame]() -> Result<UntouchedImage> {
    return UntouchedImage{frame->grey, frame->controls ? *frame->controls : std::string(),
                          en::say("the camera")};
  });
}

void FingerPage::choose_reference_image() {
  ask_for_file(
      this, FilesOf::kImages, tr("Untouched image"), image_filter(), [this](const QString& file) {
        install_reference_image([file = file.toStdString()] { return read_untouched_image(file); });
      });
}

void FingerPage::install_reference_image(std::function<Result<UntouchedImage>()> image) {
  if (!has_folder()) return;
  work_.start(
      [this, image = std::move(image), folder = session_.status().finger.folder](const Job&) {
        const auto read = image();
        Status status = read ? Status() : Status(read.error());
        if (read)
          if (const auto warnings = set_untouched_image(folder, *read); !warnings)
            status = warnings.error();
        return std::function<void()>([this, status] {
          set_problems(status ? std::vector<Problem>() : std::vector{Problem::of(status.error())});
        });
      });
  show_status();
}

}  // namespace alltact
