#include "widgets/pages/record_page.h"

#include "calibration/reference/motion_coverage.h"
#include "core/sources/file_source.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/image/image_view.h"
#include "widgets/image/overlays.h"
#include "widgets/inspect/recordings_dialog.h"
#include "widgets/language.h"
#include "widgets/shell/page.h"
#include "widgets/theme.h"
#include "widgets/widget_base.h"

#include <QCheckBox>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>
#include <QPoint>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>
#include <set>

namespace alltact {
namespace {

constexpr int kRecordSideWidth = 306;
constexpr int kSpaceInterval_ms = 2000;
constexpr int kSign_px = 14;
constexpr int kLongest_s = 24 * 3600;
constexpr int kProgressLines = 2, kSpaceLines = 1, kDirectionsLines = 3, kOutcomeLines = 5,
              kReasonLines = 2;

ViewOptions only_finger() {
  ViewOptions options;
  options.direction = options.depth = false;
  return options;
}

QString enough_text(const BendState& covered) {
  const QString enough = RecordPage::tr("Enough: all directions reached.");
  if (covered.is_required(BendDirection::kTwistLeft)) return enough;
  return enough + QLatin1Char(' ') +
         RecordPage::tr("It was not twisted; twist it, too, if it twists in use.");
}

std::filesystem::path path_of(const QString& text) {
  return std::filesystem::path(text.trimmed().toStdString());
}

}  // namespace

RecordPage::RecordPage(LiveSession& session, QUndoStack& undo, QWidget* parent)
    : Page("record", parent),
      session_(session),
      panel_(new ImagePanel(session)),
      coverage_group_(new QGroupBox),
      recording_group_(new QGroupBox),
      result_group_(new QGroupBox),
      file_group_(new QGroupBox),
      coverage_view_(new CoverageView),
      missing_(new ReservedText(kDirectionsLines)),
      rest_(new QPushButton),
      rest_note_(wrapped_label()),
      file_label_(new QLabel),
      file_(new QLineEdit),
      browse_(new QPushButton),
      record_(new QPushButton),
      purpose_(new QComboBox),
      length_s_(new IntegerField),
      sign_(new QLabel),
      progress_(new ReservedText(kProgressLines)),
      space_(new ReservedText(kSpaceLines)),
      work_(new QStackedWidget),
      measurement_note_(wrapped_label()),
      summary_(wrapped_label()),
      install_(new QPushButton),
      keep_(new QPushButton),
      again_(new QPushButton),
      inspect_(new QPushButton),
      onward_(new QPushButton),
      video_(new QPushButton),
      stop_install_(new QPushButton),
      bar_(new QProgressBar),
      step_(new QStackedWidget),
      install_reason_(new ReservedText(kReasonLines)),
      outcome_(new ReservedText(kOutcomeLines)),
      chooser_(new FrameChooser(*panel_, undo)),
      rejected_(new QListWidget),
      skin_changed_(new QCheckBox),
      rig_box_(new RigCheckBox) {
  auto* layout = without_margins(new QHBoxLayout(this));
  layout->addWidget(panel_, 1);
  layout->addWidget(make_side());
  panel_->set_options(only_finger());
  panel_->set_extra_overlays([this](const LiveView& view) {
    std::vector<Overlay> marks = chooser_->marks(view);
    return marks.empty() ? ghost(view) : marks;
  });
  ghost_clock_.start();
  new SpaceKey(*this, [this] {
    if (record_->isEnabled()) start_or_stop();
  });
  connect_parts();
  say([this] { name_parts(); });
}

void RecordPage::connect_parts() {
  show_text_as_tip(*file_);
  connect(rest_, &QPushButton::clicked, this, &RecordPage::set_rest);
  connect(record_, &QPushButton::clicked, this, &RecordPage::start_or_stop);
  connect(browse_, &QPushButton::clicked, this, &RecordPage::choose_file);
  connect(purpose_, &QComboBox::currentIndexChanged, this, &RecordPage::follow_purpose);
  connect(install_, &QPushButton::clicked, this, &RecordPage::install);
  connect(keep_, &QPushButton::clicked, this, [this] {
    deferred_ = std::exchange(recorded_, {});
    chooser_->show_live_image();
    judge_.forget();
    report_.reset();
    show_status();
  });
  connect(again_, &QPushButton::clicked, this, &RecordPage::record_again);
  connect(inspect_, &QPushButton::clicked, this, [this] { Q_EMIT inspect_requested(recorded_); });
  connect(onward_, &QPushButton::clicked, this, [this] { Q_EMIT lead_requested("calibrate"); });
  connect(video_, &QPushButton::clicked, this, [this] {
    ask_for_file(this, FilesOf::kRecordings, tr("Video of the bending finger"), video_filter(),
                 [this](const QString& file) {
                   report_.reset();
                   problem_image_ = {};
                   is_measurement_ = false;
                   offer(file.toStdString(), std::nullopt);
                   show_status();
                 });
  });
  connect(stop_install_, &QPushButton::clicked, this, [this] {
    install_after_judging_ = false;
    install_work_.stop();
    show_status();
  });
  connect(rejected_, &QListWidget::itemChanged, this,
          [this](QListWidgetItem* item) { choose_stretch(rejected_->row(item)); });
  connect(rejected_, &QListWidget::currentRowChanged, chooser_, &FrameChooser::show_stretch);
  connect(chooser_, &FrameChooser::stretch_clicked, this, [this](int index) {
    const QSignalBlocker shown_already(rejected_);
    rejected_->setCurrentRow(index);
  });
  connect(chooser_, &FrameChooser::choice_changed, this, &RecordPage::follow_choice);
  connect(skin_changed_, &QCheckBox::toggled, this, &RecordPage::judge_take);
  connect(&judge_, &TakeJudge::changed, this, &RecordPage::follow_judge);
  connect(&install_work_, &BackgroundWork::progressed, this, &RecordPage::show_installing);
  connect(&install_work_, &BackgroundWork::finished, this, &RecordPage::show_status);
  connect(&session_, &LiveSession::view_ready, this, &RecordPage::analyse_frame);
  connect(&session_, &LiveSession::status_ready, this, &RecordPage::show_status);
}

QWidget* RecordPage::make_side() {
  const SidePanel side(kRecordSideWidth);
  make_recording_group(*side.column);
  auto *bending = new QWidget, *recorded = new QWidget, *measuring = new QWidget;
  auto* column = without_margins(new QVBoxLayout(bending));
  auto* coverage = new QVBoxLayout(coverage_group_);
  add_widgets(*coverage, {coverage_view_, missing_, rest_, rest_note_});
  for (QWidget* shown : std::initializer_list<QWidget*>{rig_box_, skin_changed_})
    reserve_room(*shown);
  add_widgets(*column, {rig_box_, coverage_group_});
  column->addStretch();
  make_result_group(*without_margins(new QVBoxLayout(recorded)));
  auto* note = without_margins(new QVBoxLayout(measuring));
  note->addWidget(measurement_note_);
  note->addStretch();
  for (QWidget* page : {bending, recorded, measuring}) work_->addWidget(page);
  side.column->addWidget(work_);
  make_file_group(*side.column);
  // Last: their heights depend on the recording, and nothing may move.
  add_widgets(*side.column, {chooser_, rejected_});
  side.column->addStretch();
  return side.root;
}

void RecordPage::make_recording_group(QVBoxLayout& column) {
  auto* layout = new QVBoxLayout(recording_group_);
  record_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
  auto* kind = new QHBoxLayout;
  purpose_->addItems({{}, {}});
  length_s_->setRange(0, kLongest_s);
  add_widgets(*kind, {purpose_, length_s_});
  layout->addLayout(kind);
  layout->addWidget(record_);
  auto* line = new QHBoxLayout;
  line->addWidget(sign_, 0, Qt::AlignTop);
  line->addWidget(progress_, 1);
  layout->addLayout(line);
  layout->addWidget(space_);
  column.addWidget(recording_group_);
}

void RecordPage::make_file_group(QVBoxLayout& column) {
  auto* layout = new QVBoxLayout(file_group_);
  auto* line = new QHBoxLayout;
  file_label_->setBuddy(file_);
  line->addWidget(file_label_, 1);
  line->addWidget(browse_);
  layout->addLayout(line);
  layout->addWidget(file_);
  layout->addWidget(video_);
  column.addWidget(file_group_);
}

void RecordPage::make_result_group(QVBoxLayout& column) {
  auto* layout = new QVBoxLayout(result_group_);
  rejected_->setMaximumHeight(140);
  rejected_->setWordWrap(true);
  auto *offered = new QWidget, *working = new QWidget, *installed = new QWidget,
       *measured = new QWidget;
  auto* choice = without_margins(new QVBoxLayout(offered));
  auto* other = new QHBoxLayout;
  other->addWidget(keep_);
  other->addWidget(again_);
  add_widgets(*choice, {install_, install_reason_});
  choice->addLayout(other);
  auto* line = without_margins(new QHBoxLayout(working));
  bar_->setObjectName("progress_of_installation");
  line->addWidget(bar_, 1);
  line->addWidget(stop_install_);
  without_margins(new QVBoxLayout(installed))->addWidget(onward_);
  for (QWidget* step : {offered, working, installed, measured}) step_->addWidget(step);
  step_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  add_widgets(*layout, {summary_, outcome_, inspect_, skin_changed_, step_});
  column.addWidget(result_group_);
  column.addStretch();
}

void RecordPage::name_parts() {
  coverage_group_->setTitle(tr("Bend it in all directions"));
  rest_->setText(tr("Set res&t pose"));
  rest_->setToolTip(tr("Click when the finger hangs free; bending is measured from here."));
  rest_->setAccessibleDescription(rest_->toolTip());
  recording_group_->setTitle(tr("Recording"));
  file_group_->setTitle(tr("Files"));
  purpose_->setItemText(0, tr("Reference"));
  purpose_->setItemText(1, tr("Measurement"));
  purpose_->setAccessibleName(tr("What the recording is for"));
  purpose_->setToolTip(
      tr("A reference shows the bending finger with nothing on its face; a measurement shows what "
         "is to be measured."));
  length_s_->setAccessibleName(tr("Length of the recording"));
  length_s_->setSpecialValueText(tr("until stopped"));
  length_s_->setPrefix(tr("for ", "before a number of seconds"));
  length_s_->setSuffix(tr(" s"));
  length_s_->setToolTip(
      tr("The recording stops by itself after so many seconds; 0: only when it is stopped."));
  measurement_note_->setText(
      tr("The video goes into the finger's folder. It is neither judged nor installed, so the "
         "finger may touch anything."));
  result_group_->setTitle(tr("Recorded video"));
  file_label_->setText(tr("Fi&le"));
  file_->setAccessibleName(tr("Recording file"));
  browse_->setText(tr("&Choose…"));
  browse_->setToolTip(tr("Chooses the file to record to"));
  install_->setText(tr("&Install as this finger's reference"));
  install_->setToolTip(
      tr("Depth is measured against it from now on; undo restores the one before"));
  keep_->setText(tr("&Keep for later"));
  keep_->setToolTip(tr("The video stays where it is, and the finger stays as it is."));
  again_->setText(tr("Record a&gain"));
  inspect_->setText(tr("Inspect t&his recording"));
  inspect_->setToolTip(tr("Opens it on the page Inspect"));
  onward_->setText(tr("&Go to Calibrate"));
  onward_->setToolTip(tr("There presses of a ball give the depth"));
  again_->setToolTip(tr("Moves this video to the trash and records a new one."));
  video_->setText(tr("Install an e&xisting video…"));
  video_->setToolTip(tr("Examines a stored recording as if it had just been made"));
  stop_install_->setText(tr("&Stop"));
  stop_install_->setToolTip(tr("The finger keeps its present reference"));
  stop_install_->setAccessibleDescription(tr("Stops the installation; nothing is changed."));
  bar_->setAccessibleName(tr("Progress of the installation"));
  rejected_->setAccessibleName(tr("Frames that were left out, with the reason"));
  rejected_->setToolTip(tr("Tick frames that are untouched, and install."));
  skin_changed_->setText(tr("The &skin was changed since the last reference"));
  skin_changed_->setToolTip(
      tr("If it was cleaned, painted or replaced, the last reference cannot show what pressed on "
         "it."));
  list_rejected();
  show_status();
  show_coverage();
}

bool RecordPage::is_busy() const {
  const RecordingState state = session_.status().recording.state;
  return state == RecordingState::kRunning || state == RecordingState::kFinishing ||
         is_installing();
}

void RecordPage::set_rest() {
  if (coverage_.set_rest()) show_coverage();
}

void RecordPage::analyse_frame() {
  if (!isVisible()) return;
  const FrameResult& result = session_.view()->result;
  const bool bends_quickly = bending_.is_quick(result);
  is_face_pressed_ = is_face_pressed(result);
  // Motion blur, and poses between those of the reference, resemble a contact.
  is_in_contact_ = is_face_pressed_ == true && !bends_quickly;
  // The reference leaves out frames with contact, so they cover no pose.
  if (result.markers && result.shape && !is_in_contact_)
    coverage_.add(*result.markers, *result.shape);
  else
    coverage_.clear_pose();
  unknown_frames_ = !is_face_pressed_ ? unknown_frames_ + 1 : 0;
  const bool is_recording = session_.status().recording.state == RecordingState::kRunning;
  if (is_recording && is_in_contact_ && !is_measurement_) ++contact_frames_;
  if (!is_recording) rig_.add(result, monotonic_s());
  show_coverage();
}

void RecordPage::show_coverage() {
  const BendState& covered = coverage_.state();
  coverage_view_->show_coverage(covered);
  QStringList missing;
  for (const BendDirection direction : covered.missing()) missing << bend_direction_text(direction);
  missing_->setText(covered.poses == 0  ? tr("The markers must be visible to measure its bending.")
                    : missing.isEmpty() ? enough_text(covered)
                                        : tr("Still missing: %1.").arg(listed(missing)));
  rest_->setEnabled(covered.now.has_value());
  rest_note_->setText(coverage_.rest_is_set()
                          ? tr("Bending is measured from the rest pose that was set.")
                          : tr("Bending is measured from the middle of all poses."));
}

void RecordPage::start_or_stop() {
  if (session_.status().recording.state == RecordingState::kRunning)
    session_.stop_recording();
  else
    begin_recording();
}

void RecordPage::begin_recording() {
  report_.reset();
  stretches_.clear();
  chooser_->show_live_image();
  problem_image_ = {};  // it belonged to the former recording
  installed_.clear();
  deferred_.clear();
  judge_.forget();
  coverage_.begin();
  contact_frames_ = 0;
  if (is_measurement_ || is_for_measurement()) recorded_.clear();
  is_measurement_ = is_for_measurement();
  const LiveStatus& status = session_.status();
  std::shared_ptr<RecordingFeed> feed;
  if (!is_measurement_ && install_obstacle(status).isEmpty()) {
    feed = std::make_shared<RecordingFeed>(path_of(file_->text()));
    judge_.follow(status.finger.folder, feed);
  }
  session_.start_recording(path_of(file_->text()), {}, std::move(feed));
}

void RecordPage::choose_file() {
  auto* dialog = new QFileDialog(this, tr("Record to"), file_->text(), tr("Video (*.mkv)"));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("mkv"));
  connect(dialog, &QFileDialog::fileSelected, file_, &QLineEdit::setText);
  show_dialog(*dialog);
}

void RecordPage::propose_file() {
  const auto& folder = session_.status().finger.folder;
  const QDir where(folder.empty() ? QDir::homePath() : QString::fromStdString(folder.string()));
  proposed_file_ = where.filePath(
      (is_for_measurement() ? QStringLiteral("measurement_%1.mkv")
                            : QStringLiteral("bending_%1.mkv"))
          .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmmss"))));
  file_->setText(proposed_file_);
}

void RecordPage::follow_purpose() {
  if (file_->text() == proposed_file_) propose_file();
  if (is_measurement_) recorded_.clear();  // the page shows what is to be recorded next
  show_status();
}

void RecordPage::stop_in_time(const RecordingStatus& recording) {
  const int length_s = length_s_->value();
  if (recording.state == RecordingState::kRunning && length_s > 0 && recording.seconds >= length_s)
    session_.stop_recording();
}

void RecordPage::measure_space() {
  if (since_space_.isValid() && since_space_.elapsed() < kSpaceInterval_ms) return;
  since_space_.start();
  space_work_.start([this, file = path_of(file_->text())](const Job&) -> std::function<void()> {
    std::error_code failed;
    const auto space =
        std::filesystem::space(std::filesystem::absolute(file).parent_path(), failed);
    const auto free_bytes = failed ? std::optional<double>() : static_cast<double>(space.available);
    return [this, free_bytes] {
      free_gb_ = free_bytes ? std::optional(*free_bytes / kGigabyte) : std::nullopt;
    };
  });
}

void RecordPage::show_status() {
  const LiveStatus& status = session_.status();
  const RecordingState state = status.recording.state;
  if (status.finger.folder != shown_finger_ || status.source.inputs != shown_source_) {
    coverage_ = BendCoverage();
    rig_.begin();
    show_coverage();
  }
  shown_source_ = status.source.inputs;
  if (status.finger.folder != shown_finger_ || file_->text().isEmpty()) {
    if (status.finger.folder != shown_finger_ && !was_recording_) {
      judge_.forget();
      report_.reset();
      problem_image_ = {};
    }
    shown_finger_ = status.finger.folder;
    if (state != RecordingState::kRunning) propose_file();
  }
  const bool is_recording = state == RecordingState::kRunning;
  if (was_recording_ && state == RecordingState::kDone) {
    was_recording_ = false;  // before offer(), which calls this again
    if (status.recording.counts.recorded > 0 && is_measurement_) {
      recorded_ = status.recording.file;
      propose_file();
    } else if (status.recording.counts.recorded > 0) {
      offer(status.recording.file, coverage_.set_rest_pose());
      propose_file();
    } else {
      judge_.forget();
    }
  }
  was_recording_ = was_recording_ || is_recording;
  stop_in_time(status.recording);
  if (isVisible()) measure_space();
  const auto& finger = status.finger.finger;
  coverage_group_->setVisible(!finger || finger->face.kind == FaceKind::kFinRay);  // flat: rigid
  show_button(status);
  show_progress(status.recording);
  show_recorded(status);
  show_rig();
  mark_primary();
}

void RecordPage::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_status();
}

void RecordPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  show_status();
}

// Installation of a recording in the page Record, and its outcome.

namespace {

/// Reuses the judged result of the same recording.
Result<ReferenceReport> install_take(const std::shared_ptr<const JudgedTake>& judged,
                                     const std::filesystem::path& folder,
                                     const std::filesystem::path& video,
                                     const ReferenceChoices& choices, const Job& job) {
  if (judged && judged->finger == folder && judged->video == video) {
    const auto is_done = judged->install();
    if (!is_done) return is_done.error();
    if (*is_done) return judged->report;
  }
  return set_reference(folder, {video}, job, choices);
}

}  // namespace

bool RecordPage::is_installing() const {
  return install_work_.is_running() || install_after_judging_;
}

void RecordPage::install() {
  report_.reset();
  problem_image_ = {};
  bar_->setValue(0);
  install_after_judging_ = judge_.is_working();
  if (!install_after_judging_) install_now();
  show_status();
}

void RecordPage::follow_judge() {
  if (install_after_judging_ && !judge_.is_working()) {
    install_after_judging_ = false;
    // An error is shown already by the judging.
    if (judge_.judged() && judge_.judged()->report.ok()) install_now();
  }
  if (install_after_judging_) show_installing();
  if (judge_.judged() && judge_.judged() != listed_.lock() && !report_) {
    listed_ = judge_.judged();
    list_rejected();
  }
  show_status();
}

ReferenceChoices RecordPage::choices() const {
  ReferenceChoices choices;
  choices.rest_pose = rest_pose_;
  choices.keep = frames_of(chooser_->choice(), true);
  choices.leave_out = frames_of(chooser_->choice(), false);
  choices.skin_was_changed = skin_changed_->isChecked();
  return choices;
}

void RecordPage::install_now() {
  const auto folder = session_.status().finger.folder;
  const auto video = recorded_;
  const auto judged = judge_.judged();
  install_work_.start([this, folder, video, choices = choices(), judged](const Job& job) {
    auto report = std::make_shared<Result<ReferenceReport>>(
        install_take(judged, folder, video, choices, job));
    const QImage image(QString::fromStdString((folder / kReferenceProblem).string()));
    // A stop by the user needs no error message.
    const bool is_stopped = job.stop_requested() && !report->ok();
    return std::function<void()>([this, report, video, image, is_stopped] {
      if (is_stopped) return;
      installed_ = video;
      report_ = *report;
      problem_image_ = image;
      if (report->ok()) judge_.forget();
      list_rejected();
    });
  });
}

void RecordPage::show_installing() {
  // Judging and copying are one piece of work to the user.
  bar_->setValue(std::max(bar_->value(), static_cast<int>(100 * installing_work().fraction())));
  outcome_->setText(outcome_text());
}

const BackgroundWork& RecordPage::installing_work() const {
  return install_after_judging_ ? judge_.work() : install_work_;
}

void RecordPage::show_problem_image() {
  auto* dialog = new ImageDialog(problem_image_, this);
  dialog->setWindowTitle(tr("What was found in the recording"));
  show_dialog(*dialog);
}

const ReferenceReport* RecordPage::shown_report() const {
  if (report_) return report_->ok() ? &report_->value() : nullptr;
  const auto& judged = judge_.judged();
  return judged && judged->report.ok() ? &judged->report.value() : nullptr;
}

void RecordPage::list_rejected() {
  const QSignalBlocker no_choice(rejected_);
  const ReferenceReport* report = shown_report();
  // What was chosen stays in view, so that it can be changed, where nothing can be made of it.
  if (report == nullptr && !chooser_->choice().empty() && !recorded_.empty()) return;
  rejected_->clear();
  chooser_->show_report(report != nullptr ? *report : ReferenceReport{});
  if (report == nullptr) return;
  // The report does not name the stretches that were left out by choice.
  std::vector<ReferenceStretch> stretches = report->stretches;
  for (ReferenceStretch& former : stretches_) {
    const bool is_named =
        std::any_of(stretches.begin(), stretches.end(), [&](const ReferenceStretch& stretch) {
          return stretch.first == former.first && stretch.last == former.last;
        });
    const auto chosen = chooser_->choice().find(former.first);
    if (is_named || chosen == chooser_->choice().end() || chosen->second) continue;
    former.is_retained = false;
    stretches.push_back(former);
  }
  stretches_ = std::move(stretches);
  std::set<std::string> listed;
  for (const ReferenceStretch& stretch : stretches_) {
    auto* item = new QListWidgetItem(in_window_language(stretch.sentence), rejected_);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(stretch.is_retained ? Qt::Checked : Qt::Unchecked);
    listed.insert(stretch.sentence.english());
  }
  for (const Message& reason : report->rejected)
    if (!listed.contains(reason.english())) rejected_->addItem(in_window_language(reason));
}

void RecordPage::choose_stretch(int row) {
  if (row < 0 || static_cast<std::size_t>(row) >= stretches_.size()) return;
  const ReferenceStretch& stretch = stretches_[static_cast<std::size_t>(row)];
  chooser_->choose({stretch.first, stretch.last}, rejected_->item(row)->checkState() == Qt::Checked,
                   true);
}

void RecordPage::follow_choice() {
  const auto& choice = chooser_->choice();
  const QSignalBlocker no_choice(rejected_);
  for (std::size_t row = 0; row < stretches_.size(); ++row) {
    const auto chosen = choice.find(stretches_[row].first);
    const bool is_used = chosen != choice.end() ? chosen->second : stretches_[row].is_retained;
    rejected_->item(static_cast<int>(row))->setCheckState(is_used ? Qt::Checked : Qt::Unchecked);
  }
  installed_.clear();  // the choice differs from what is installed
  if (!report_) judge_take();
  show_status();
}

// The page Record after a recording: installation, and the ghost outline that shows how to bend the
// finger.

namespace {

constexpr int kGhostPeriod_ms = 2200;    // one period: motion, a rest, and a restart
constexpr double kMotionFraction = 0.7;  // fraction of the period
constexpr int kRigInterval_ms = 300;
const QColor kGhost(255, 255, 255);

/// Smoothstep from 0 to 1.
double ease(double part) {
  const double t = std::clamp(part, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

TipMotion part_of(const TipMotion& motion, double part) {
  return {part * motion.bend_mm, part * motion.sway_mm, part * motion.twist_deg};
}

Overlay ghost_overlay(const BentOutline& outline, const QString& words) {
  return [outline, words](QPainter& painter, const ImageTransform& transform) {
    QPolygonF polygon;
    for (const auto& p : outline.upper) polygon << transform.to_widget({p.x(), p.y()});
    for (auto p = outline.lower.rbegin(); p != outline.lower.rend(); ++p)
      polygon << transform.to_widget({p->x(), p->y()});
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    QColor inside = kGhost;
    inside.setAlpha(45);
    painter.fillPath(path, inside);
    stroke_over(painter, path, kGhost, 2, Qt::DashLine);
    const QRectF box = path.boundingRect();
    write_next_to(painter, QPointF(box.center().x() - 80, box.center().y() - 12), words, kGhost);
  };
}

}  // namespace

/// Ghost of the first missing direction; none where there is nothing to follow.
std::vector<Overlay> RecordPage::ghost(const LiveView& view) const {
  const BendState& covered = coverage_.state();
  const auto missing = covered.missing();
  const bool is_recording = session_.status().recording.state == RecordingState::kRunning;
  const bool is_offered = !recorded_.empty() && !is_recording;
  if (is_for_measurement() || missing.empty() || !covered.now || !view.result.shape || is_offered)
    return {};
  const double phase = static_cast<double>(ghost_clock_.elapsed() % kGhostPeriod_ms) /
                       kGhostPeriod_ms / kMotionFraction;
  const auto outline =
      bent_outline(*view.result.shape, part_of(motion_left(covered, missing.front()), ease(phase)));
  if (!outline) return {};
  return {ghost_overlay(*outline,
                        tr("Follow the outline: %1").arg(bend_direction_text(missing.front())))};
}

void RecordPage::offer(const std::filesystem::path& video, std::optional<RestPose> rest_pose) {
  recorded_ = video;
  rest_pose_ = std::move(rest_pose);
  stretches_.clear();
  chooser_->begin(session_.status().finger.folder, video);
  deferred_.clear();
  {
    const QSignalBlocker no_judging(skin_changed_);
    skin_changed_->setChecked(false);
  }
  if (!judge_.conclude(session_.status().finger.folder, video, choices())) {
    judge_.forget();
    judge_take();
  }
  list_rejected();
}

void RecordPage::judge_take() {
  const LiveStatus& status = session_.status();
  if (!recorded_.empty() && install_obstacle(status).isEmpty())
    judge_.judge(status.finger.folder, recorded_, choices());
}

void RecordPage::record_again() {
  const auto video = std::exchange(recorded_, {});
  judge_.forget();
  // Only the last recording is removed; an installed video has been copied.
  if (video == session_.status().recording.file) move_recording_to_trash(video);
  begin_recording();
}

QString RecordPage::take_words(const RecordingStatus& recording) const {
  const QString name = QString::fromStdString(recorded_.filename().string());
  if (recording.file != recorded_) return name;
  QStringList lines{
      tr("%1: %2, %3 min")
          .arg(name, tr("%n frame(s)", nullptr, static_cast<int>(recording.counts.recorded)),
               minutes_text(recording.seconds))};
  if (const auto dropped = recording.counts.dropped; dropped > 0)
    lines << tr("%n frame(s) were lost because this computer or its disk was too slow.", nullptr,
                static_cast<int>(dropped));
  if (const auto missing = recording.counts.missing; missing > 0)
    lines << tr("%n frame(s) did not arrive from the source.", nullptr, static_cast<int>(missing));
  if (recording.counts.dropped + recording.counts.missing == 0) lines << tr("No frame was lost.");
  if (contact_frames_ > 0)
    lines << tr("%n frame(s) with contact are left out.", nullptr,
                static_cast<int>(contact_frames_));
  return lines.join(QLatin1Char('\n'));
}

QString RecordPage::outcome_text() const {
  if (is_measurement_) return tr("Saved. A measurement is neither judged nor installed.");
  if (is_installing()) {
    const auto left = installing_work().seconds_left();
    if (!left) return tr("Reading the recording…");
    return tr("About %n second(s) left.", nullptr, static_cast<int>(*left) + 1);
  }
  if (judge_.is_working()) {
    const auto left = judge_.work().seconds_left();
    return left ? tr("The expected error is being computed, about %n second(s).", nullptr,
                     static_cast<int>(*left) + 1)
                : tr("The expected error is being computed.");
  }
  if (!report_ && judge_.judged() && !judge_.judged()->report.ok())
    return tr("It cannot be installed: %1")
        .arg(window_sentence(judge_.judged()->report.error().what));
  const ReferenceReport* report = shown_report();
  if (report == nullptr) return {};
  const QString error =
      tr("Expected error: half of the references off by less than %1 mm, 95 % by less than %2 "
         "mm, from %n frame(s).",
         nullptr, report->frames_retained)
          .arg(QLocale().toString(report->error_median_mm, 'f', 3),
               QLocale().toString(report->error_p95_mm, 'f', 3));
  if (!report_) return error;
  const QString installed = session_.status().finger.has_reference
                                ? tr("Installed.")
                                : tr("Installed; the finger is being loaded with it.");
  return QStringList{installed, error}.join(QLatin1Char('\n'));
}

void RecordPage::show_offer(const LiveStatus& status) {
  const QString why = install_obstacle(status);
  const bool is_installed = report_ && report_->ok() && installed_ == recorded_;
  install_->setEnabled(why.isEmpty() && !is_installing());
  for (QPushButton* other : {keep_, again_})
    other->setEnabled(!is_installing() && status.recording.state != RecordingState::kFinishing);
  again_->setEnabled(again_->isEnabled() && record_->isEnabled());
  inspect_->setEnabled(status.recording.state != RecordingState::kFinishing);
  step_->setCurrentIndex(is_measurement_ ? 3 : is_installing() ? 1 : is_installed ? 2 : 0);
  onward_->setEnabled(status.finger.has_reference);
  install_reason_->setText(why);
  skin_changed_->setVisible(!is_measurement_ && status.finger.has_reference && !is_installing() &&
                            !is_installed);
  outcome_->setText(outcome_text());
}

void RecordPage::show_recorded(const LiveStatus& status) {
  work_->setCurrentIndex(!recorded_.empty() ? 1 : is_for_measurement() ? 2 : 0);
  // They stay while a changed choice is judged.
  const bool has_frames =
      !recorded_.empty() && !is_measurement_ && chooser_->strip().has_frames() && !is_installing();
  chooser_->setVisible(has_frames);
  rejected_->setVisible(has_frames && rejected_->count() > 0);
  if (recorded_.empty()) return;
  summary_->setText(take_words(status.recording));
  summary_->setToolTip(QString::fromStdString(recorded_.string()));
  show_offer(status);
}

/// The checklist before the first recording.
void RecordPage::show_rig() {
  if (!recorded_.empty()) return;  // hidden: another height would move what is shown
  const LiveStatus& status = session_.status();
  const bool is_recording = status.recording.state == RecordingState::kRunning;
  const auto& finger = status.finger.finger;
  const bool has_folder = finger && status.finger.state == FingerState::kReady;
  rig_box_->setVisible(has_folder && session_.view() && !is_recording &&
                       finger->face.kind == FaceKind::kFinRay);
  rig_box_->set_needed(has_folder && !status.finger.has_reference);
  if (!has_folder || !isVisible()) return;
  if (since_rig_.isValid() && since_rig_.elapsed() < kRigInterval_ms) return;
  since_rig_.start();
  rig_box_->show_findings(rig_.findings(2 * finger->markers.per_row), status.controller.controls);
}

// Status texts of the page Record: what is needed, progress and outcome.

namespace {

constexpr double kLittleSpace_gb = 2;
// Consecutive frames; the first ones of a source are always unknown.
constexpr int kMaxUnknownFrames = 15;

}  // namespace

QString RecordPage::record_obstacle(const LiveStatus& status) const {
  if (is_installing()) return tr("The recording is being installed.");
  if (status.recording.state == RecordingState::kFinishing)
    return tr("The last frames are being written.");
  if (status.source.state != SourceState::kRunning)
    return tr("Open a source first: a camera, or the simulated finger.");
  return {};
}

void RecordPage::show_button(const LiveStatus& status) {
  const bool is_recording = status.recording.state == RecordingState::kRunning;
  const QString why = is_recording ? QString() : record_obstacle(status);
  record_->setText(is_recording ? tr("Stop &recording") : tr("Start &recording"));
  // setText() removes the shortcut.
  record_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
  record_->setToolTip(tr("Ctrl+R, or Space"));
  record_->setIcon(
      icon(is_recording ? QStringLiteral("stop") : QStringLiteral("record"), palette()));
  record_->setEnabled(why.isEmpty());
  progress_->setText(
      !why.isEmpty() ? why
      : deferred_.empty()
          ? QString()
          : tr("Saved: %1").arg(QString::fromStdString(deferred_.filename().string())));
  progress_->setToolTip(QString::fromStdString(deferred_.string()));
  for (QWidget* widget : std::initializer_list<QWidget*>{file_, browse_, purpose_, length_s_})
    widget->setEnabled(!is_recording && status.recording.state != RecordingState::kFinishing);
}

void RecordPage::show_progress(const RecordingStatus& recording) {
  const QLocale locale;
  const bool is_recording = recording.state == RecordingState::kRunning;
  const std::uint64_t lost = recording.counts.dropped + recording.counts.missing;
  sign_->setPixmap(symbol(QStringLiteral("record"),
                          is_recording ? meaning_colour(Meaning::kBad, palette())
                                       : palette().color(QPalette::Disabled, QPalette::WindowText),
                          kSign_px, devicePixelRatioF()));
  sign_->setAccessibleName(is_recording ? tr("It records") : tr("It does not record"));
  sign_->setToolTip(sign_->accessibleName());
  QString clock = minutes_text(recording.seconds);
  if (length_s_->value() > 0) clock += QLatin1String(" / ") + minutes_text(length_s_->value());
  if (is_recording)
    progress_->setText(
        tr("<b>Recording</b> %1 min<br>%2, %3, %4 GB")
            .arg(clock, tr("%n frame(s)", nullptr, static_cast<int>(recording.counts.recorded)),
                 tr("%n lost", nullptr, static_cast<int>(lost)),
                 locale.toString(static_cast<double>(recording.counts.bytes) / kGigabyte, 'f', 2)));
  std::optional<double> free_gb = free_gb_;
  if (is_recording && recording.counts.free_bytes > 0)
    free_gb = static_cast<double>(recording.counts.free_bytes) / kGigabyte;
  QStringList parts;
  if (free_gb) parts << tr("Space left: %1 GB").arg(locale.toString(*free_gb, 'f', 1));
  if (free_gb && is_recording && recording.seconds > 2 && recording.counts.bytes > 0) {
    const double gb_per_s =
        static_cast<double>(recording.counts.bytes) / kGigabyte / recording.seconds;
    parts << tr("room for about %n minute(s)", nullptr,
                static_cast<int>(std::min(*free_gb / gb_per_s / 60, 99999.0)));
  }
  space_->setText(joined(parts));
}

QString RecordPage::install_obstacle(const LiveStatus& status) const {
  if (status.finger.folder.empty()) return tr("Open the finger that was recorded first.");
  if (status.finger.finger && status.finger.finger->face.kind == FaceKind::kFlat)
    return tr("A flat sensor has one untouched image instead of a recording.");
  if (is_busy()) return is_installing() ? QString() : tr("A recording is running.");
  return {};
}

void RecordPage::mark_primary() {
  const bool is_offered = !recorded_.empty() && installed_ != recorded_ && !is_measurement_;
  const bool is_measured = !recorded_.empty() && is_measurement_;
  const bool is_refused = judge_.judged() && !judge_.judged()->report.ok();
  const bool installs = is_offered && install_->isEnabled() && !is_refused;
  const bool is_installed = !recorded_.empty() && report_ && report_->ok();
  set_primary(*install_, installs);
  set_primary(*again_, is_offered && is_refused && again_->isEnabled());
  set_primary(*onward_, is_installed && onward_->isEnabled());
  set_primary(*inspect_, is_measured && inspect_->isEnabled());
  set_primary(*record_, !is_offered && !is_measured && !is_installed && !is_installing());
  follow_focus();
}

std::string RecordPage::leads_to() const {
  return onward_->isVisible() ? "calibrate" : std::string();
}

void RecordPage::add_problems(std::vector<Problem>& problems) {
  const LiveStatus& status = session_.status();
  const FingerStatus& finger = status.finger;
  if (isVisible()) add_recording_problems(status, problems);
  if (finger.state != FingerState::kReady || finger.folder.empty()) return;
  if (finger.finger->face.kind == FaceKind::kFinRay && !finger.has_reference)
    problems.push_back({Meaning::kDoubtful, tr("This finger has no reference recording yet."),
                        tr("Record it bending, with nothing on its contact face.")});
}

void RecordPage::add_recording_problems(const LiveStatus& status, std::vector<Problem>& problems) {
  if (status.recording.problem) problems.push_back(Problem::of(*status.recording.problem));
  if (report_ && !report_->ok()) problems.push_back(Problem::of(report_->error()));
  if (chooser_->problem()) problems.push_back(Problem::of(*chooser_->problem()));
  const auto note = [&](Meaning meaning, const QString& what, const QString& advice) {
    problems.push_back({meaning, what, advice});
  };
  const bool is_recording = status.recording.state == RecordingState::kRunning;
  const std::uint64_t lost =
      is_recording ? status.recording.counts.dropped + status.recording.counts.missing : 0;
  if (lost > 0)
    note(Meaning::kBad,
         tr("%n frame(s) of this recording are lost.", nullptr, static_cast<int>(lost)),
         tr("Try another disk, or a smaller image."));
  add_contact_notes(status, problems);
  if (free_gb_ && *free_gb_ < kLittleSpace_gb)
    note(Meaning::kDoubtful, tr("Little space is left on the disk."),
         tr("Choose a file on another disk, or make room."));
  if (report_ && report_->ok())
    for (const Message& warning : report_->value().warnings)
      problems.push_back(Problem::of(Error{warning, "", ""}, Meaning::kDoubtful));
  if (!problem_image_.isNull())
    problems.push_back({Meaning::kDoubtful,
                        tr("An image shows what was found in the recording, and what was not."),
                        {},
                        tr("Show the image"),
                        [this] { show_problem_image(); }});
}

void RecordPage::add_contact_notes(const LiveStatus& status, std::vector<Problem>& problems) const {
  if (!session_.view() || is_for_measurement()) return;
  if (is_in_contact_)
    problems.push_back({Meaning::kDoubtful,
                        tr("Something touches the contact face; such frames are left out."),
                        tr("Keep it free: bend the finger at its tip, its sides or its back.")});
  if (unknown_frames_ >= kMaxUnknownFrames)
    problems.push_back({Meaning::kDoubtful,
                        tr("It is unknown whether something touches the contact face."),
                        tr("Open the finger that belongs to this source, and keep both edges of "
                           "its face in the image.")});
  else if (!status.finger.has_reference && is_face_pressed_)
    problems.push_back({Meaning::kDoubtful,
                        tr("Without a reference, contact is detected from the preceding frames."),
                        tr("Begin with nothing on the contact face.")});
}

}  // namespace alltact
