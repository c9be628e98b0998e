#include "widgets/pages/record_page.h"

#include "widgets/calibrating/space_key.h"
#include "widgets/joined_words.h"
#include "widgets/panels/side_panel.h"
#include "widgets/tip_of_text.h"

#include <QCheckBox>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace alltact {
namespace {

constexpr int kRecordSideWidth = 306;
constexpr int kSpaceInterval_ms = 2000;

ViewOptions only_finger() {
  ViewOptions options;
  options.direction = options.depth = false;
  return options;
}

QLabel* wrapped_label() {
  auto* label = new QLabel;
  label->setWordWrap(true);
  return label;
}

QString enough_text(const BendState& covered) {
  const QString enough = RecordPage::tr("Enough: all directions are reached.");
  if (covered.is_required(BendDirection::kTwistLeft)) return enough;
  return enough + QLatin1Char(' ') +
         RecordPage::tr("It was not twisted; twist it, too, if it is in use.");
}

std::filesystem::path path_of(const QString& text) {
  return std::filesystem::path(text.trimmed().toStdString());
}

}  // namespace

RecordPage::RecordPage(LiveSession& session, ReferenceInstaller installer, QWidget* parent)
    : Page("record", parent),
      session_(session),
      installer_(std::move(installer)),
      panel_(new ImagePanel(session)),
      coverage_group_(new QGroupBox),
      recording_group_(new QGroupBox),
      result_group_(new QGroupBox),
      file_group_(new QGroupBox),
      coverage_view_(new CoverageView),
      missing_(wrapped_label()),
      rest_(new QPushButton),
      rest_note_(wrapped_label()),
      file_label_(new QLabel),
      file_(new QLineEdit),
      browse_(new QPushButton),
      record_(new QPushButton),
      reason_(wrapped_label()),
      progress_(wrapped_label()),
      space_(wrapped_label()),
      summary_(wrapped_label()),
      install_(new QPushButton),
      keep_(new QPushButton),
      again_(new QPushButton),
      onward_(new QPushButton),
      video_(new QPushButton),
      stop_install_(new QPushButton),
      bar_(new QProgressBar),
      install_reason_(wrapped_label()),
      judged_(wrapped_label()),
      outcome_(wrapped_label()),
      rejected_(new QListWidget),
      skin_changed_(new QCheckBox),
      rig_box_(new RigCheckBox),
      judge_(installer_) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(panel_, 1);
  layout->addWidget(make_side());
  panel_->set_options(only_finger());
  panel_->set_extra_overlays([this](const LiveView& view) { return ghost(view); });
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
  connect(install_, &QPushButton::clicked, this, &RecordPage::install);
  connect(keep_, &QPushButton::clicked, this, &RecordPage::defer_take);
  connect(again_, &QPushButton::clicked, this, &RecordPage::record_again);
  connect(onward_, &QPushButton::clicked, this, [this] { Q_EMIT lead_requested("calibrate"); });
  connect(video_, &QPushButton::clicked, this, &RecordPage::choose_video);
  connect(stop_install_, &QPushButton::clicked, this, &RecordPage::stop_installing);
  connect(rejected_, &QListWidget::itemChanged, this, &RecordPage::choose_frames);
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
  make_result_group(*side.column);
  side.column->addWidget(rig_box_);
  auto* coverage = new QVBoxLayout(coverage_group_);
  coverage->addWidget(coverage_view_);
  coverage->addWidget(missing_);
  coverage->addWidget(rest_);
  coverage->addWidget(rest_note_);
  side.column->addWidget(coverage_group_);
  make_file_group(*side.column);
  side.column->addStretch();
  return side.root;
}

void RecordPage::make_recording_group(QVBoxLayout& column) {
  auto* layout = new QVBoxLayout(recording_group_);
  record_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
  for (QWidget* widget : {static_cast<QWidget*>(record_),
                          static_cast<QWidget*>(reason_),
                          static_cast<QWidget*>(progress_),
                          static_cast<QWidget*>(space_)})
    layout->addWidget(widget);
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
  auto* other = new QHBoxLayout;
  other->addWidget(keep_);
  other->addWidget(again_);
  auto* line = new QHBoxLayout;
  line->addWidget(bar_, 1);
  line->addWidget(stop_install_);
  layout->addWidget(summary_);
  layout->addWidget(judged_);
  layout->addWidget(skin_changed_);
  layout->addWidget(install_);
  layout->addWidget(install_reason_);
  layout->addLayout(other);
  layout->addLayout(line);
  layout->addWidget(outcome_);
  layout->addWidget(onward_);
  layout->addWidget(rejected_);
  column.addWidget(result_group_);
}

void RecordPage::name_parts() {
  coverage_group_->setTitle(tr("Bend it in all directions"));
  rest_->setText(tr("Set res&t pose"));
  rest_->setToolTip(tr("The finger hangs free now: all bending is told from here."));
  rest_->setAccessibleDescription(rest_->toolTip());
  recording_group_->setTitle(tr("Recording"));
  file_group_->setTitle(tr("Files"));
  result_group_->setTitle(tr("What was recorded"));
  file_label_->setText(tr("&File"));
  file_->setAccessibleName(tr("File to record to"));
  browse_->setText(tr("&Choose…"));
  install_->setText(tr("&Install as this finger's reference"));
  keep_->setText(tr("&Keep for later"));
  keep_->setToolTip(tr("The video stays where it is, and the finger stays as it is."));
  again_->setText(tr("Record a&gain"));
  onward_->setText(tr("&Go to Calibrate"));
  again_->setToolTip(tr("Puts this video into the waste bin and records another one."));
  video_->setText(tr("Install a &video that is there…"));
  stop_install_->setText(tr("&Stop"));
  stop_install_->setAccessibleDescription(tr("Stops the installation; nothing is changed."));
  bar_->setAccessibleName(tr("Progress of the installation"));
  rejected_->setAccessibleName(tr("Frames that were left out, with the reason"));
  rejected_->setToolTip(tr("Tick frames that were untouched, and install again."));
  skin_changed_->setText(tr("The &skin was changed since the last reference"));
  skin_changed_->setToolTip(
      tr("It was cleaned, painted or replaced: the last reference then does not tell what pressed "
         "on it."));
  list_rejected();
  show_status();
  show_coverage();
}

bool RecordPage::is_busy() const {
  const RecordingState state = session_.status().recording.state;
  return state == RecordingState::kRunning || state == RecordingState::kFinishing ||
         is_installing();
}

void RecordPage::begin_coverage() {
  coverage_.begin();
  contact_frames_ = 0;
}

void RecordPage::set_rest() {
  if (coverage_.set_rest()) show_coverage();
}

void RecordPage::analyse_frame() {
  if (!isVisible()) return;
  const FrameResult& result = session_.view()->result;
  const bool bends_quickly = bending_.is_quick(result);
  touch_ = result.touch;
  // Motion blur, and poses between those of the reference, resemble a contact.
  is_in_contact_ = touch_ == FaceContact::kInContact && !bends_quickly;
  // The reference leaves out frames with contact, so they cover no pose.
  if (result.markers && result.shape && !is_in_contact_)
    coverage_.add(*result.markers, *result.shape);
  else
    coverage_.clear_pose();
  unknown_frames_ = touch_ == FaceContact::kUnknown ? unknown_frames_ + 1 : 0;
  const bool is_recording = session_.status().recording.state == RecordingState::kRunning;
  if (is_recording && is_in_contact_) ++contact_frames_;
  if (!is_recording) rig_.add(result, monotonic_s());
  show_coverage();
}

void RecordPage::show_coverage() {
  const BendState& covered = coverage_.state();
  coverage_view_->show_coverage(covered);
  QStringList missing;
  for (const BendDirection direction : covered.missing()) missing << bend_direction_text(direction);
  missing_->setText(covered.poses == 0  ? tr("The markers have to be seen to tell how it bends.")
                    : missing.isEmpty() ? enough_text(covered)
                                        : tr("Still missing: %1.").arg(listed(missing)));
  rest_->setEnabled(covered.now.has_value());
  rest_note_->setText(coverage_.rest_is_set()
                          ? tr("Bending is told from the rest pose that was set.")
                          : tr("Bending is told from the middle of all poses."));
}

void RecordPage::start_or_stop() {
  if (session_.status().recording.state == RecordingState::kRunning)
    session_.stop_recording();
  else
    begin_recording();
}

void RecordPage::begin_recording() {
  report_.reset();
  contact_free_.clear();
  problem_image_ = {};  // it belonged to the former recording
  installed_.clear();
  deferred_.clear();
  judge_.forget();
  begin_coverage();
  session_.start_recording(path_of(file_->text()));
}

void RecordPage::choose_file() {
  auto* dialog = new QFileDialog(this, tr("Record to"), file_->text(), tr("Video (*.mkv)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("mkv"));
  connect(dialog, &QFileDialog::fileSelected, file_, &QLineEdit::setText);
  dialog->show();
}

void RecordPage::propose_file() {
  const auto& folder = session_.status().finger.folder;
  const QDir where(folder.empty() ? QDir::homePath() : QString::fromStdString(folder.string()));
  file_->setText(where.filePath(
      QStringLiteral("bending_%1.mkv")
          .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmmss")))));
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
    if (status.recording.counts.recorded > 0) {
      offer(status.recording.file, coverage_.set_rest_pose());
      propose_file();
    }
  }
  was_recording_ = was_recording_ || is_recording;
  if (isVisible()) measure_space();
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
  record_->setFocus();  // so that keys are not typed into a field
  show_status();
}

}  // namespace alltact
