#include "widgets/calibrating/finger_page.h"

#include "calibration/reference/new_reference.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QVBoxLayout>

namespace alltact {
namespace {

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

FingerPage::FingerPage(LiveSession& session, QWidget* parent)
    : StepPage(parent),
      session_(session),
      problems_(new ProblemList),
      geometry_group_(new QGroupBox),
      reference_group_(new QGroupBox),
      geometry_(wrapped_text()),
      reference_(wrapped_text()),
      make_(new QPushButton),
      open_(new QPushButton),
      record_(new QPushButton),
      untouched_(new QPushButton) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(problems_);
  const auto group =
      [column](QGroupBox* box, QLabel* text, std::initializer_list<QPushButton*> buttons) {
        auto* inside = new QVBoxLayout(box);
        inside->addWidget(text);
        auto* row = new QHBoxLayout;
        for (QPushButton* button : buttons) row->addWidget(button);
        row->addStretch();
        inside->addLayout(row);
        column->addWidget(box);
      };
  group(geometry_group_, geometry_, {make_, open_});
  group(reference_group_, reference_, {record_, untouched_});
  column->addStretch();
  connect(make_, &QPushButton::clicked, this, &FingerPage::make_finger);
  connect(open_, &QPushButton::clicked, this, &FingerPage::open_finger_wanted);
  connect(record_, &QPushButton::clicked, this, &FingerPage::record_wanted);
  connect(untouched_, &QPushButton::clicked, this, &FingerPage::take_untouched);
  say([this] {
    geometry_group_->setTitle(tr("Geometry"));
    reference_group_->setTitle(tr("What it looks like untouched"));
    make_->setText(tr("&Make the finger's folder…"));
    open_->setText(tr("&Open a finger…"));
    record_->setText(tr("&Go to Record"));
    untouched_->setText(tr("Take the &untouched picture now"));
    show_status();
  });
}

bool FingerPage::is_own() const {
  const FingerStatus& finger = session_.status().finger;
  return finger.state == FingerState::kReady && !finger.folder.empty() && finger.finger;
}

StepState FingerPage::state() const {
  return missing().isEmpty() ? StepState::kDone : StepState::kToDo;
}

QString FingerPage::missing() const {
  const FingerStatus& finger = session_.status().finger;
  if (finger.state == FingerState::kLoading)
    return was_complete_ ? QString() : tr("The finger is being loaded.");
  if (!is_own()) return tr("The finger needs a folder of its own: make one, or open one.");
  if (finger.has_reference) return {};
  return finger.finger->face.kind == FaceKind::kFlat
             ? tr("Its untouched picture is missing.")
             : tr("Its reference recording is missing: record it bending, untouched.");
}

void FingerPage::show_status() {
  const FingerStatus& finger = session_.status().finger;
  if (finger.state == FingerState::kLoading && was_complete_) return;  // again, after a change
  if (finger.state != FingerState::kLoading) was_complete_ = missing().isEmpty();
  make_->setVisible(!is_own());
  geometry_->setText(
      is_own() ? geometry_text(*finger.finger)
               : tr("Width and layer are measured with a caliper, dots are counted. All that is "
                    "known of one finger is kept in one folder."));
  reference_group_->setVisible(is_own());
  if (!is_own()) return;
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
