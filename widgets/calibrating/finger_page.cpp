#include "widgets/calibrating/finger_page.h"

#include "calibration/reference/new_reference.h"
#include "core/finger/finger_store.h"
#include "widgets/panels/side_panel.h"
#include "widgets/value_change.h"

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
    return FingerPage::tr("A flat, rigid sensor with a layer of %1 mm, %2 mm before the camera.")
        .arg(mm(finger.face.layer_mm), mm(finger.face.plane_z_mm));
  return FingerPage::tr(
             "A Fin Ray finger whose face is %1 mm wide, with a layer of %2 mm and %3 dots on each "
             "side.")
      .arg(mm(finger.face.width_mm), mm(finger.face.layer_mm))
      .arg(finger.markers.per_row);
}

/// The frame becomes the sensor's untouched picture.
Status install_untouched(const std::filesystem::path& folder, const Frame& frame) {
  const auto warnings = give_untouched_picture(
      folder,
      {frame.grey, frame.controls ? *frame.controls : std::string(), en::say("the camera")});
  return warnings ? Status() : warnings.error();
}

}  // namespace

FingerPage::FingerPage(LiveSession& session, QUndoStack& undo, QWidget* parent)
    : StepPage(parent),
      session_(session),
      undo_(undo),
      live_(new PicturePanel(session)),
      problems_(new ProblemList),
      geometry_group_(new QGroupBox),
      reference_group_(new QGroupBox),
      geometry_(wrapped_text()),
      reference_(wrapped_text()),
      make_(new QPushButton),
      open_(new QPushButton),
      record_(new QPushButton),
      untouched_(new QPushButton),
      width_label_(new QLabel),
      layer_label_(new QLabel),
      width_(new NumberField),
      layer_(new NumberField),
      sizes_(new QWidget),
      change_(new QPushButton) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(problems_);
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
  auto* form = new QFormLayout(sizes_);
  form->setContentsMargins(0, 0, 0, 0);
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
  for (QPushButton* button : {make_, open_}) geometry->addWidget(button);
  side.column->addWidget(geometry_group_);
  auto* reference = new QVBoxLayout(reference_group_);
  reference->addWidget(reference_);
  for (QPushButton* button : {record_, untouched_}) reference->addWidget(button);
  side.column->addWidget(reference_group_);
  side.column->addStretch();
  foot_ = side.foot;
  return side.whole;
}

void FingerPage::connect_parts() {
  connect(make_, &QPushButton::clicked, this, &FingerPage::make_finger);
  connect(open_, &QPushButton::clicked, this, &FingerPage::open_finger_wanted);
  connect(record_, &QPushButton::clicked, this, &FingerPage::record_wanted);
  connect(untouched_, &QPushButton::clicked, this, &FingerPage::take_untouched);
  connect(change_, &QPushButton::clicked, this, &FingerPage::change_sizes);
  for (NumberField* size : {width_, layer_})
    connect(size, &NumberField::text_changed, this, &FingerPage::show_sizes);
}

void FingerPage::name_parts() {
  geometry_group_->setTitle(tr("Geometry"));
  reference_group_->setTitle(tr("What it looks like untouched"));
  make_->setText(tr("&Make the finger's folder…"));
  open_->setText(tr("&Open a finger…"));
  record_->setText(tr("&Go to Record"));
  untouched_->setText(tr("Take the &untouched picture now"));
  width_label_->setText(tr("&Width of the face"));
  width_->setAccessibleName(tr("Width of the face"));
  layer_label_->setText(tr("&Layer's thickness"));
  layer_->setAccessibleName(tr("Thickness of the layer"));
  for (NumberField* size : {width_, layer_}) size->setSuffix(tr(" mm"));
  change_->setText(tr("&Change"));
  change_->setToolTip(tr("A calibrated finger has to be calibrated again then."));
  show_status();
}

/// What somebody typed stays until it is taken.
void FingerPage::show_sizes() {
  if (is_read_again()) return change_->setEnabled(false);  // there, and waits
  sizes_->setVisible(is_own());
  if (!is_own()) return;
  const Face& face = session_.status().finger.finger->face;
  width_->setVisible(face.kind == FaceKind::kFinRay);
  width_label_->setVisible(face.kind == FaceKind::kFinRay);
  const auto width = width_->typed(), layer = layer_->typed();
  const bool has_width = face.kind == FaceKind::kFinRay;
  change_->setEnabled(width && layer &&
                      ((has_width && *width != face.width_mm) || *layer != face.layer_mm));
}

void FingerPage::change_sizes() {
  if (!is_own()) return;
  const FingerStatus& finger = session_.status().finger;
  const Face& face = finger.finger->face;
  const auto width = width_->typed(), layer = layer_->typed();
  if (!width || !layer) return;
  const Sizes wanted(face.kind == FaceKind::kFinRay ? *width : face.width_mm, *layer);
  undo_.push(new ValueChange<Sizes>(
      [] { return tr("change the finger's sizes"); },
      Sizes(face.width_mm, face.layer_mm),
      wanted,
      [this, folder = finger.folder](const Sizes& sizes) { write_sizes(folder, sizes); }));
}

void FingerPage::write_sizes(const std::filesystem::path& folder, const Sizes& sizes) {
  disk_.add([folder, sizes]() -> Status {
    const auto changed = FingerStore::of(folder)->update([&](Finger& finger) -> Status {
      finger.face.width_mm = sizes.first;
      finger.face.layer_mm = sizes.second;
      return {};
    });
    return changed ? Status() : changed.error();
  });
}

bool FingerPage::is_own() const {
  const FingerStatus& finger = session_.status().finger;
  return finger.state == FingerState::kReady && !finger.folder.empty() && finger.finger;
}

const QPushButton* FingerPage::to_do() const {
  const FingerStatus& finger = session_.status().finger;
  if (finger.state == FingerState::kLoading) return nullptr;
  if (!is_own()) return make_;
  if (finger.has_reference) return nullptr;
  return finger.finger->face.kind == FaceKind::kFlat ? untouched_ : record_;
}

bool FingerPage::is_read_again() const {
  return was_complete_ && session_.status().finger.state == FingerState::kLoading;
}

StepState FingerPage::state() const {
  return missing().isEmpty() ? StepState::kDone : StepState::kToDo;
}

QString FingerPage::missing() const {
  const FingerStatus& finger = session_.status().finger;
  if (is_read_again()) return {};
  if (finger.state == FingerState::kLoading) return tr("The finger is being loaded.");
  if (!is_own()) return tr("The finger needs a folder of its own: make one, or open one.");
  if (finger.has_reference) return {};
  return finger.finger->face.kind == FaceKind::kFlat
             ? tr("Its untouched picture is missing.")
             : tr("Its reference recording is missing: record it bending, untouched.");
}

void FingerPage::show_status() {
  const FingerStatus& finger = session_.status().finger;
  if (is_read_again()) return show_sizes();
  if (finger.state != FingerState::kLoading) was_complete_ = missing().isEmpty();
  make_->setVisible(!is_own());
  geometry_->setText(
      is_own() ? geometry_text(*finger.finger)
               : tr("Width and layer are measured with a caliper, dots are counted. All that is "
                    "known of one finger is kept in one folder."));
  reference_group_->setVisible(is_own());
  if (!is_own()) return show_sizes();
  const Sizes sizes(finger.finger->face.width_mm, finger.finger->face.layer_mm);
  if (shown_folder_ != finger.folder || shown_sizes_ != sizes) {
    const QSignalBlocker quiet_width(width_), quiet_layer(layer_);
    width_->setValue(sizes.first);
    layer_->setValue(sizes.second);
    shown_folder_ = finger.folder;
    shown_sizes_ = sizes;
  }
  show_sizes();
  if (const auto unkept = disk_.problem()) problems_->set_problems({Problem::of(*unkept)});
  const bool is_flat = finger.finger->face.kind == FaceKind::kFlat;
  record_->setVisible(!is_flat);
  untouched_->setVisible(is_flat);
  untouched_->setEnabled(session_.view() != nullptr && !work_.is_running());
  if (finger.has_reference)
    reference_->setText(is_flat ? tr("Its untouched picture is there.")
                                : tr("Its reference recording is installed."));
  else
    reference_->setText(
        is_flat ? tr("Every press is compared with one picture of the untouched face.")
                : tr("Every press is compared with a picture of the finger bent alike and not "
                     "touched. Record it bending in all directions, then install the recording."));
}

void FingerPage::make_finger() {
  NewFinger known;
  known.camera = camera_file_;
  const FingerStatus& finger = session_.status().finger;
  if (finger.finger && finger.folder.empty()) {  // a simulated one: a scene says what it is like
    known.kind = finger.finger->face.kind;
    known.width_mm = finger.finger->face.width_mm;
    known.layer_mm = finger.finger->face.layer_mm;
    known.plane_z_mm = finger.finger->face.plane_z_mm;
    known.per_row = finger.finger->markers.per_row;
  }
  Q_EMIT new_finger_wanted(known);
}

void FingerPage::take_untouched() {
  if (!is_own() || !session_.view()) return;
  const FramePtr frame = session_.view()->result.frame;
  if (!frame) return;
  work_.start([this, frame, folder = session_.status().finger.folder](const Job&) {
    const Status status = install_untouched(folder, *frame);
    return std::function<void()>([this, status] {
      problems_->set_problems(status ? std::vector<Problem>()
                                     : std::vector{Problem::of(status.error())});
    });
  });
  show_status();
}

}  // namespace alltact
