#include "app/studio/onboarding.h"

#include "app/studio/help.h"
#include "core/base/atomic_file.h"
#include "core/finger/finger_store.h"
#include "widgets/theme.h"

#include <QHBoxLayout>
#include <QSettings>

#include <fmt/format.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr int kSteps = 4, kGoodPresses = 6;

/// A folder next to those of earlier tutorials.
fs::path free_folder(const fs::path& work_folder) {
  std::error_code failed;
  for (int i = 1;; ++i) {
    const fs::path folder = work_folder / fmt::format("tried-finger-{}", i);
    if (!fs::exists(folder, failed)) return folder;
  }
}

/// The values that a caliper would give for the simulated finger.
Result<fs::path> make_tried_finger(const Finger& simulated, const fs::path& work_folder) {
  if (const Status made = make_folder(work_folder); !made) return made.error();
  NewFinger requested;
  requested.finger = free_folder(work_folder);
  requested.camera = work_folder / "simulated_camera.yaml";
  if (const Status saved = save_camera(requested.camera, simulated.camera); !saved)
    return saved.error();
  requested.kind = simulated.face.kind;
  requested.width_mm = simulated.face.width_mm;
  requested.layer_mm = simulated.face.layer_mm;
  requested.plane_z_mm = simulated.face.plane_z_mm;
  requested.per_row = simulated.markers.per_row;
  const auto made = make_finger(requested);
  if (!made) return made.error();
  return requested.finger;
}

}  // namespace

Tutorial::Tutorial(LiveSession& session, Workspace& work, CalibratePage& calibrate,
                   fs::path work_folder)
    : session_(session),
      work_(work),
      calibrate_(calibrate),
      work_folder_(std::move(work_folder)),
      text_(new ElidedLabel),
      lead_(new QPushButton),
      end_(new QPushButton) {
  setFrameShape(QFrame::StyledPanel);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 3, 6, 3);
  row->addWidget(text_, 1);
  row->addWidget(lead_);
  row->addWidget(end_);
  reserve_room(*lead_);
  hide();
  connect(lead_, &QPushButton::clicked, this, &Tutorial::lead);
  connect(end_, &QPushButton::clicked, this, &Tutorial::end);
  connect(&session_, &LiveSession::status_ready, this, &Tutorial::follow);
  say([this] {
    setAccessibleName(tr("A day with a simulated finger"));
    end_->setText(tr("End the &guide"));
    end_->setToolTip(tr("Hides the guide for this finger"));
    follow();
  });
}

void Tutorial::begin() {
  is_on_ = true;
  has_finger_ = false;
  step_ = Step::kFinger;
  follow();
  Q_EMIT turned();
}

void Tutorial::end() {
  is_on_ = false;
  hide();
  Q_EMIT turned();
}

Tutorial::Step Tutorial::next_step() const {
  const FingerStatus& finger = session_.status().finger;
  // A finger that was just written is still loading: no step is done a second time.
  if (finger.state == FingerState::kLoading && has_finger_) return step_;
  if (!has_finger_ || finger.folder.empty()) return Step::kFinger;
  if (!finger.has_reference) return Step::kRecord;
  if (calibrate_.run().is_running() || calibrate_.has_unseen_verdict()) return Step::kCalibrate;
  if (calibrate_.run().state() != CalibrationState::kNone)
    return calibrate_.is_checked() ? Step::kDone : Step::kCheck;
  return calibrate_.collection().usable_count() < kGoodPresses ? Step::kPresses : Step::kCalibrate;
}

void Tutorial::make_finger_once() {
  const FingerStatus& finger = session_.status().finger;
  const bool is_simulated =
      finger.state == FingerState::kReady && finger.folder.empty() && finger.finger;
  if (has_finger_ || making_.is_running() || !is_simulated) return;
  making_.start([this, simulated = *finger.finger, folder = work_folder_](const Job&) {
    const auto made = make_tried_finger(simulated, folder);
    return std::function<void()>([this, made] {
      has_finger_ = true;
      if (!made) {
        end();
        return void(Q_EMIT failed(made.error()));
      }
      work_.open_finger(*made);
    });
  });
}

void Tutorial::follow() {
  if (!is_on_) return;
  make_finger_once();
  step_ = next_step();
  const Step now = step_;
  const QString head = now == Step::kFinger ? tr("Wait:")
                       : now == Step::kDone
                           ? tr("Done:")
                           : tr("%1 of %2:").arg(static_cast<int>(now)).arg(kSteps);
  text_->set_text(head + QLatin1Char(' ') + what_next(), static_cast<int>(head.size()));
  lead_->setText(now == Step::kRecord ? tr("Go to &Record")
                 : now == Step::kDone ? tr("Go to &Inspect")
                                      : tr("Go to &Calibrate"));
  lead_->setToolTip(tr("Opens the page of the next step"));
  const std::string there = page_of_step();
  const bool is_elsewhere = now != Step::kFinger && page_ != there && leads_to_ != there;
  lead_->setVisible(is_elsewhere);
  set_primary(*lead_, is_elsewhere);
  show();
}

void Tutorial::set_page(const std::string& page, const std::string& leads_to) {
  if (page == page_ && leads_to == leads_to_) return;
  page_ = page;
  leads_to_ = leads_to;
  follow();
}

std::string Tutorial::page_of_step() const {
  const Step now = step();
  return now == Step::kRecord ? "record" : now == Step::kDone ? "inspect" : "calibrate";
}

QString Tutorial::what_next() const {
  switch (step()) {
    case Step::kFinger:
      return tr("The simulated finger gets a folder of its own.");
    case Step::kRecord:
      return tr("Record it for half a minute while it bends, then install the recording.");
    case Step::kPresses:
      return tr(
          "Enter the ball's radius, 4 mm. Each press that is held still is taken, until there are "
          "six.");
    case Step::kCalibrate:
      return tr("Calibrate with these presses and read the verdict.");
    case Step::kCheck:
      return tr("Check it with three presses, as every week.");
    case Step::kDone:
      break;
  }
  return tr("That was a finger's full day. View its contacts in 3D.");
}

void Tutorial::lead() {
  const std::string page = page_of_step();
  Q_EMIT page_requested(page);
}

PageHint::PageHint(const Tutorial& guide, QWidget* parent)
    : Translated(parent),
      guide_(guide),
      text_(new ElidedLabel),
      more_(new QPushButton),
      seen_(new QPushButton) {
  setFrameShape(QFrame::StyledPanel);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 3, 6, 3);
  row->addWidget(text_, 1);
  row->addWidget(more_);
  row->addWidget(seen_);
  hide();
  connect(more_, &QPushButton::clicked, this, &PageHint::help_requested);
  connect(seen_, &QPushButton::clicked, this, [this] {
    QSettings().setValue(key(page_), true);
    follow();
  });
  connect(&guide_, &Tutorial::turned, this, &PageHint::follow);
  say([this] {
    setAccessibleName(tr("Purpose of this page"));
    more_->setText(tr("How it is &done (F1)"));
    more_->setToolTip(tr("Opens the help of this page"));
    seen_->setText(tr("&Understood"));
    seen_->setToolTip(tr("Hides this hint; the help (F1) has it"));
    follow();
  });
}

QString PageHint::key(const std::string& page) {
  return QStringLiteral("hints/%1").arg(QString::fromStdString(page));
}

void PageHint::show_for(const std::string& page) {
  page_ = page;
  follow();
}

void PageHint::make_room(bool is_needed) {
  is_room_needed_ = is_needed;
  follow();
}

void PageHint::follow() {
  const bool is_new = !page_.empty() && !QSettings().value(key(page_), false).toBool();
  const HelpLead lead = lead_of(help_text(QString::fromStdString(page_)));
  setVisible(is_new && !is_room_needed_ && !guide_.is_on() && !lead.lead.isEmpty());
  text_->set_text(without_marks(lead.lead));
}

}  // namespace alltact
