#include "widgets/inspect/finger_pair.h"

#include "core/finger/finger_store.h"
#include "widgets/language.h"
#include "widgets/widget_base.h"

#include <QGridLayout>
#include <QLocale>
#include <QVBoxLayout>
#include <cmath>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// The contact face without vertical exaggeration.
cv::Mat contact_face(const FaceSurface& surface) {
  cv::Mat face = surface.untouched_mm.clone();
  for (int j = 0; j < face.rows; ++j)
    for (int i = 0; i < face.cols; ++i)
      if (const float depth = surface.depth_mm.at<float>(j, i); std::isfinite(depth))
        face.at<cv::Vec3f>(j, i)[2] -= depth;
  return face;
}

}  // namespace

FingerPair::FingerPair(const Inspection& first, QObject* parent) : QObject(parent), first_(first) {
  const auto update = [this] {
    measure();
    Q_EMIT changed();
  };
  connect(&inspection_, &Inspection::frame_ready, this, update);
  connect(&reading_, &BackgroundWork::finished, this, update);
  connect(&measuring_, &BackgroundWork::finished, this, update);
  connect(&inspection_, &Inspection::state_changed, this, [this] {
    follow();
    Q_EMIT changed();
  });
}

void FingerPair::set_first(const fs::path& finger) {
  if (folders_[0] == finger) return;
  folders_[0] = finger;
  if (is_open()) read_mounts();
}

void FingerPair::open(const std::optional<SecondFinger>& second) {
  if (second_ == second) return;
  second_ = second;
  folders_[1] = second ? second->finger : fs::path();
  partner_ = {};
  inspection_.set_finger(folders_[1]);
  inspection_.open(second ? second->recording : fs::path());
  if (second) read_mounts();
  follow();
  Q_EMIT changed();
}

void FingerPair::follow() {
  const auto &own = first_.recording(), &other = inspection_.recording();
  if (!is_open() || !own || !other || !first_.frame()) return;
  const MatchedFrame partner = matched_frame(first_.frame()->number, *own, *other);
  const bool is_new = partner.number != partner_.number;
  partner_ = partner;
  if (is_new) inspection_.show_frame(partner.number);
  measure();
}

void FingerPair::read_mounts() {
  reading_.restart([this, folders = folders_, disk = disk_](const Job&) {
    disk->wait();
    auto mounts = std::make_shared<std::map<fs::path, FingerMount>>();
    auto problem = std::make_shared<std::optional<Error>>();
    for (const fs::path& folder : folders) {
      if (folder.empty()) continue;
      const auto opened = open_finger(folder);
      if (opened)
        (*mounts)[folder] = {(*opened)->finger.name, (*opened)->finger.gripper_from_camera};
      else
        *problem = opened.error();
    }
    return std::function<void()>([this, mounts, problem] {
      mounts_ = *mounts;
      read_problem_ = *problem;
    });
  });
}

const FingerMount* FingerPair::mount(bool is_second) const {
  const auto found = mounts_.find(folder(is_second));
  return found == mounts_.end() ? nullptr : &found->second;
}

QString FingerPair::name(bool is_second) const {
  if (const FingerMount* known = mount(is_second)) return QString::fromStdString(known->name);
  return QString::fromStdString(folder(is_second).filename().string());
}

bool FingerPair::has_both_poses() const {
  const FingerMount *first = mount(false), *second = mount(true);
  return is_open() && first != nullptr && second != nullptr && first->gripper_from_camera &&
         second->gripper_from_camera;
}

std::optional<FramePair> FingerPair::frames() const {
  const auto &own = first_.frame(), &other = inspection_.frame();
  if (!is_open() || !own || !other || !own->surface || !other->surface) return std::nullopt;
  FramePair frames{own, other};
  if (has_both_poses())
    frames.poses = {*mount(false)->gripper_from_camera, *mount(true)->gripper_from_camera};
  if (is_measured(frames)) frames.gap = measured_.gap;
  return frames;
}

bool FingerPair::is_measured(const FramePair& frames) const {
  return frames.poses && measured_.first == frames.first && measured_.second == frames.second &&
         measured_.poses == frames.poses;
}

std::optional<NearestPoints> FingerPair::gap() const {
  const auto now = frames();
  return now ? now->gap : std::nullopt;
}

void FingerPair::measure() {
  const auto now = frames();
  if (!now || !now->poses || is_measured(*now) || measuring_.is_running()) return;
  measuring_.start([this, frames = *now](const Job&) mutable {
    frames.gap = nearest_points({contact_face(*frames.first->surface), (*frames.poses)[0]},
                                {contact_face(*frames.second->surface), (*frames.poses)[1]});
    return std::function<void()>([this, frames] { measured_ = frames; });
  });
}

std::optional<Error> FingerPair::problem() const {
  if (const auto written = disk_->problem()) return written;
  return is_open() ? read_problem_ : std::nullopt;
}

void FingerPair::set_pose(const fs::path& folder,
                          const std::optional<RigidTransform>& gripper_from_camera) {
  disk_->add(folder, [folder, gripper_from_camera]() -> Status {
    const auto changed = FingerStore::of(folder)->update([&](Finger& finger) {
      finger.gripper_from_camera = gripper_from_camera;
      return Status();
    });
    return changed ? Status() : changed.error();
  });
  read_mounts();
}

PairBox::PairBox(const FingerPair& pair, QWidget* parent)
    : Translated(parent),
      pair_(pair),
      open_(new QPushButton),
      close_(new QPushButton),
      pose_first_(new QPushButton),
      pose_second_(new QPushButton),
      names_(wrapped_label()),
      joined_(wrapped_label()),
      gap_(wrapped_text()) {
  auto* grid = new QGridLayout(this);
  grid->addWidget(names_, 0, 0, 2, 1);
  grid->addWidget(close_, 0, 1);
  grid->addWidget(pose_first_, 2, 0);
  grid->addWidget(pose_second_, 2, 1);
  grid->addWidget(gap_, 3, 0, 1, 2);
  grid->addWidget(joined_, 4, 0, 1, 2);
  connect(open_, &QPushButton::clicked, this, &PairBox::open_requested);
  connect(close_, &QPushButton::clicked, this, &PairBox::close_requested);
  connect(pose_first_, &QPushButton::clicked, this, [this] { Q_EMIT pose_requested(false); });
  connect(pose_second_, &QPushButton::clicked, this, [this] { Q_EMIT pose_requested(true); });
  say([this] {
    setTitle(tr("Second finger"));
    open_->setText(tr("Second fin&ger…"));
    close_->setText(tr("Close"));
    close_->setToolTip(tr("Shows the first finger alone again"));
    pose_first_->setText(tr("Pose of 1…"));
    pose_second_->setText(tr("Pose of 2…"));
    pose_first_->setAccessibleName(tr("Pose of the first finger in the gripper"));
    pose_second_->setAccessibleName(tr("Pose of the second finger in the gripper"));
    for (QPushButton* button : {pose_first_, pose_second_})
      button->setToolTip(tr("Pose of this finger's camera in the gripper."));
    gap_->setAccessibleName(tr("Distance between the faces"));
    joined_->setAccessibleName(tr("Matching of the two recordings"));
  });
}

void PairBox::show_pair(bool is_recording) {
  const bool is_open = pair_.is_open();
  open_->setEnabled(is_recording);
  open_->setToolTip(is_recording ? tr("Shows another finger of the same moment next to this one")
                                 : tr("Open a recording first; then you can add a second one."));
  setVisible(is_open);
  if (!is_open) return;
  pose_first_->setEnabled(!pair_.folder(false).empty());
  names_->setText(labelled(QStringLiteral("1"), pair_.name(false).toHtmlEscaped()) +
                  QStringLiteral("<br>") +
                  labelled(QStringLiteral("2"), pair_.name(true).toHtmlEscaped()));
  joined_->setText(joined_text());
  gap_->setText(gap_text());
}

QString PairBox::joined_text() const {
  const MatchedFrame& partner = pair_.partner();
  if (!pair_.frames()) return {};
  const QString later = QLocale().toString(std::round(10 * partner.later_ms) / 10 + 0.0, 'f', 1);
  switch (partner.by) {
    case MatchedBy::kTime:
      return tr("Matched by time stamps; 2 was captured %1 ms after 1.").arg(later);
    case MatchedBy::kBeginning:
      return tr("Recorded at different times, aligned at their starts; 2 was captured %1 ms after "
                "1.")
          .arg(later);
    case MatchedBy::kNumber:
      break;
  }
  return tr("No time stamps: matched by frame number.");
}

QString PairBox::gap_text() const {
  const auto frames = pair_.frames();
  if (!frames || !frames->poses) return {};
  const auto& gap = frames->gap;
  if (!gap) return tr("Measuring the distance…");
  const double apart_mm = gap->distance();
  if (apart_mm < 0.005) return tr("<b>The faces touch or intersect.</b>");
  const Eigen::Vector3d middle = 0.5 * (gap->first + gap->second);
  const auto number = [](double value, int digits) {
    const double unit = std::pow(10, digits);
    return QLocale().toString(std::round(value * unit) / unit + 0.0, 'f', digits);
  };
  return tr("<b>%1 mm</b> shortest distance between the faces, near X %2, Y %3, Z %4 mm")
      .arg(number(apart_mm, 2), number(middle.x(), 1), number(middle.y(), 1),
           number(middle.z(), 1));
}

SecondFingerDialog::SecondFingerDialog(const std::optional<SecondFinger>& now, QWidget* parent,
                                       Purpose purpose)
    : FittedDialog(parent),
      intro_(wrapped_label()),
      finger_label_(new QLabel),
      recording_label_(new QLabel),
      missing_(new QLabel),
      finger_(new QLineEdit),
      recording_(new QLineEdit),
      choose_finger_(new QPushButton),
      choose_video_(new QPushButton),
      choose_folder_(new QPushButton),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(intro_);
  auto* grid = new QGridLayout;
  grid->addWidget(finger_label_, 0, 0);
  grid->addWidget(finger_, 0, 1);
  grid->addWidget(choose_finger_, 0, 2, 1, 2);
  grid->addWidget(recording_label_, 1, 0);
  grid->addWidget(recording_, 1, 1);
  grid->addWidget(choose_video_, 1, 2);
  grid->addWidget(choose_folder_, 1, 3);
  finger_label_->setBuddy(finger_);
  recording_label_->setBuddy(recording_);
  for (QLineEdit* line : {finger_, recording_}) {
    line->setMinimumWidth(280);
    show_text_as_tip(*line);
  }
  column->addLayout(grid);
  column->addStretch();
  column->addWidget(missing_);
  column->addWidget(buttons_);
  if (now) {
    finger_->setText(QString::fromStdString(now->finger.string()));
    recording_->setText(QString::fromStdString(now->recording.string()));
  }
  for (QLineEdit* line : {finger_, recording_})
    connect(line, &QLineEdit::textChanged, this, &SecondFingerDialog::show_missing);
  connect(choose_finger_, &QPushButton::clicked, this, [this] {
    ask_for_folder(
        this, FilesOf::kFingers, tr("The second finger's folder"),
        [this](const QString& folder) { finger_->setText(folder); }, finger_->text());
  });
  const auto take_recording = [this](const QString& path) { recording_->setText(path); };
  connect(choose_video_, &QPushButton::clicked, this, [this, take_recording] {
    ask_for_file(this, FilesOf::kRecordings, tr("The second finger's video"), video_filter(),
                 take_recording, recording_->text());
  });
  connect(choose_folder_, &QPushButton::clicked, this, [this, take_recording] {
    ask_for_folder(this, FilesOf::kRecordings, tr("Image folder of the second finger"),
                   take_recording, recording_->text());
  });
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons_, &QDialogButtonBox::accepted, this, [this] {
    Q_EMIT chosen(
        {finger_->text().trimmed().toStdString(), recording_->text().trimmed().toStdString()});
    accept();
  });
  say([this, purpose] {
    const bool is_compared = purpose == Purpose::kComparison;
    setWindowTitle(is_compared ? tr("Finger to compare with") : tr("Second finger"));
    intro_->setText(is_compared ? tr("Another finger of the same shape, with its recording. Each "
                                     "is measured by its own "
                                     "calibration; the same positions on both faces are compared.")
                                : tr("Another finger of the same gripper, with its recording from "
                                     "the same time. Both are "
                                     "shown in the gripper's coordinate frame; their frames are "
                                     "matched by capture time."));
    finger_label_->setText(tr("&Finger's folder"));
    recording_label_->setText(tr("&Recording"));
    finger_->setAccessibleName(tr("Finger's folder"));
    recording_->setAccessibleName(tr("Recording"));
    choose_finger_->setText(tr("Choose…"));
    choose_finger_->setToolTip(tr("Chooses the folder of the second finger"));
    choose_finger_->setAccessibleName(tr("Choose the finger's folder"));
    choose_video_->setText(tr("Video…"));
    choose_video_->setToolTip(tr("A video that was recorded at the same time"));
    choose_folder_->setText(tr("Images…"));
    choose_folder_->setToolTip(tr("A folder of images that were recorded at the same time"));
    buttons_->button(QDialogButtonBox::Ok)->setText(is_compared ? tr("&Compare") : tr("&Show it"));
    buttons_->button(QDialogButtonBox::Ok)
        ->setToolTip(is_compared ? tr("Shows the difference in depth from this finger")
                                 : tr("Opens the second finger next to the first"));
    buttons_->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    buttons_->button(QDialogButtonBox::Cancel)
        ->setToolTip(tr("Closes this window without a change (Esc)"));
    show_missing();
  });
}

void SecondFingerDialog::show_missing() {
  const bool has_finger = !finger_->text().trimmed().isEmpty();
  const bool has_recording = !recording_->text().trimmed().isEmpty();
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(has_finger && has_recording);
  missing_->setText(!has_finger      ? tr("Choose the finger's folder.")
                    : !has_recording ? tr("Choose its recording.")
                                     : QString());
}

namespace {

NumberField* field(double limit, int decimals) {
  auto* box = new NumberField;
  box->setRange(-limit, limit);
  box->set_shown_decimals(decimals);
  return box;
}

Eigen::Vector3d values(const std::array<NumberField*, 3>& fields) {
  Eigen::Vector3d numbers;  // typed numbers, finished or not
  for (std::size_t i = 0; i < 3; ++i)
    numbers[static_cast<Eigen::Index>(i)] = fields[i]->typed().value_or(fields[i]->value());
  return numbers;
}

void fill(const std::array<NumberField*, 3>& fields, const Eigen::Vector3d& values) {
  for (std::size_t i = 0; i < 3; ++i) fields[i]->setValue(values[static_cast<Eigen::Index>(i)]);
}

}  // namespace

GripperDialog::GripperDialog(const QString& finger, const std::optional<RigidTransform>& now,
                             QWidget* parent)
    : FittedDialog(parent),
      finger_(finger),
      now_(now),
      intro_(wrapped_label()),
      at_label_(new QLabel),
      turn_label_(new QLabel),
      at_{field(10000, 2), field(10000, 2), field(10000, 2)},
      turn_{field(180, 2), field(180, 2), field(180, 2)},
      forget_(new QPushButton),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(intro_);
  auto* grid = new QGridLayout;
  int row = 0;
  for (const auto& [label, fields] : {std::pair{at_label_, &at_}, {turn_label_, &turn_}}) {
    grid->addWidget(label, row, 0);
    label->setBuddy((*fields)[0]);
    for (std::size_t i = 0; i < 3; ++i) grid->addWidget((*fields)[i], row, static_cast<int>(i) + 1);
    ++row;
  }
  column->addLayout(grid);
  column->addStretch();
  buttons_->addButton(forget_, QDialogButtonBox::ResetRole);
  forget_->setEnabled(now.has_value());
  column->addWidget(buttons_);
  if (now) {
    fill(at_, now->translation_mm);
    fill(turn_, rpy_deg(now->rotation));
  }
  connect(buttons_, &QDialogButtonBox::accepted, this, [this] {
    for (NumberField* field : {at_[0], at_[1], at_[2], turn_[0], turn_[1], turn_[2]}) {
      if (!field->typed()) return field->setFocus();
      field->interpretText();
    }
    Q_EMIT chosen(pose());
    accept();
  });
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(forget_, &QPushButton::clicked, this, [this] {
    Q_EMIT chosen(std::nullopt);
    accept();
  });
  say([this] {
    setWindowTitle(tr("%1 in the gripper").arg(finger_));
    intro_->setText(
        tr("Pose of the camera of %1 in the gripper's frame: its position and its rotation about "
           "the gripper's axes, first x, then y, then z. A camera without rotation looks along the "
           "gripper's z; x runs along its image, y across it.")
            .arg(finger_));
    at_label_->setText(tr("&Position"));
    turn_label_->setText(tr("Ro&tation about"));
    static const std::array axes{QStringLiteral("x "), QStringLiteral("y "), QStringLiteral("z ")};
    const std::array<QString, 3> position_names{tr("Position, x"), tr("Position, y"),
                                                tr("Position, z")};
    const std::array<QString, 3> turns{tr("Rotation about x"), tr("Rotation about y"),
                                       tr("Rotation about z")};
    for (std::size_t i = 0; i < 3; ++i) {
      at_[i]->setPrefix(axes[i]);
      at_[i]->setSuffix(tr(" mm"));
      at_[i]->setAccessibleName(position_names[i]);
      at_[i]->setToolTip(tr("Of the camera, in the gripper's frame"));
      turn_[i]->setToolTip(tr("Of the camera, about the gripper's axis; x first, then y, then z"));
      turn_[i]->setPrefix(axes[i]);
      turn_[i]->setSuffix(QStringLiteral("°"));
      turn_[i]->setAccessibleName(turns[i]);
    }
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("&Set"));
    buttons_->button(QDialogButtonBox::Ok)
        ->setToolTip(tr("Both fingers are shown in the gripper's frame"));
    buttons_->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    buttons_->button(QDialogButtonBox::Cancel)
        ->setToolTip(tr("Closes this window without a change (Esc)"));
    forget_->setText(tr("&Not known"));
    forget_->setToolTip(tr("Removes the pose from the finger's file."));
  });
}

RigidTransform GripperDialog::pose() const {
  if (!now_) return {rotation_from_rpy_deg(values(turn_)), values(at_)};
  // The fields round; unchanged values must stay exact.
  const auto unless_changed = [](const std::array<NumberField*, 3>& fields,
                                 const Eigen::Vector3d& was) {
    constexpr double kRounded = 0.0051;
    const Eigen::Vector3d now = values(fields);
    return Eigen::Vector3d(((now - was).array().abs() < kRounded).select(was, now));
  };
  const Eigen::Vector3d degrees = rpy_deg(now_->rotation),
                        view_settled = unless_changed(turn_, degrees);
  return {view_settled == degrees ? now_->rotation : rotation_from_rpy_deg(view_settled),
          unless_changed(at_, now_->translation_mm)};
}

}  // namespace alltact
