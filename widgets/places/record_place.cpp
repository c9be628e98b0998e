#include "widgets/places/record_place.h"

#include "widgets/accessible.h"
#include "widgets/shell/icons.h"

#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>

namespace alltact {
namespace {

constexpr int kSideWidth = 330;
constexpr double kGigabyte = 1e9;
constexpr double kLittleSpace_gb = 2;
constexpr int kBetweenSpace_ms = 2000;

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

QString time_text(double seconds) {
  const int whole = static_cast<int>(seconds);
  return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

std::filesystem::path path_of(const QString& text) {
  return std::filesystem::path(text.trimmed().toStdString());
}

}  // namespace

RecordPlace::RecordPlace(LiveSession& session, ReferenceInstaller installer, QWidget* parent)
    : Translated(parent),
      session_(session),
      installer_(std::move(installer)),
      panel_(new PicturePanel(session)),
      problems_(new ProblemList),
      coverage_group_(new QGroupBox),
      recording_group_(new QGroupBox),
      result_group_(new QGroupBox),
      coverage_view_(new CoverageView),
      missing_(wrapped_label()),
      file_label_(new QLabel),
      file_(new QLineEdit),
      browse_(new QPushButton),
      record_(new QPushButton),
      reason_(wrapped_label()),
      progress_(wrapped_label()),
      space_(wrapped_label()),
      summary_(wrapped_label()),
      install_(new QPushButton),
      stop_install_(new QPushButton),
      bar_(new QProgressBar),
      install_reason_(wrapped_label()),
      outcome_(wrapped_label()),
      rejected_(new QListWidget) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* left = new QVBoxLayout;
  left->addWidget(problems_);
  left->addWidget(panel_, 1);
  layout->addLayout(left, 1);
  layout->addWidget(make_side());
  panel_->set_options(only_finger());
  connect(record_, &QPushButton::clicked, this, &RecordPlace::start_or_stop);
  connect(browse_, &QPushButton::clicked, this, &RecordPlace::choose_file);
  connect(install_, &QPushButton::clicked, this, &RecordPlace::install);
  connect(stop_install_, &QPushButton::clicked, this, [this] { install_work_.stop(); });
  connect(&install_work_, &BackgroundWork::progressed, this, &RecordPlace::show_installing);
  connect(&install_work_, &BackgroundWork::finished, this, &RecordPlace::show_status);
  connect(&session_, &LiveSession::view_ready, this, &RecordPlace::look_at_frame);
  connect(&session_, &LiveSession::status_ready, this, &RecordPlace::show_status);
  say([this] { name_parts(); });
}

QWidget* RecordPlace::make_side() {
  auto* side = new QWidget;
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(8, 0, 8, 0);
  auto* coverage = new QVBoxLayout(coverage_group_);
  coverage->addWidget(coverage_view_);
  coverage->addWidget(missing_);
  column->addWidget(coverage_group_);
  make_recording_group(*column);
  make_result_group(*column);
  column->addStretch();
  auto* scroll = new QScrollArea;
  scroll->setWidget(side);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(kSideWidth);
  scroll->setFocusPolicy(Qt::NoFocus);
  return scroll;
}

void RecordPlace::make_recording_group(QVBoxLayout& column) {
  auto* layout = new QVBoxLayout(recording_group_);
  auto* line = new QHBoxLayout;
  file_label_->setBuddy(file_);
  line->addWidget(file_label_, 1);
  line->addWidget(browse_);
  layout->addLayout(line);
  layout->addWidget(file_);
  record_->setMinimumHeight(36);
  record_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
  for (QWidget* widget : {static_cast<QWidget*>(record_),
                          static_cast<QWidget*>(reason_),
                          static_cast<QWidget*>(progress_),
                          static_cast<QWidget*>(space_)})
    layout->addWidget(widget);
  column.addWidget(recording_group_);
}

void RecordPlace::make_result_group(QVBoxLayout& column) {
  auto* layout = new QVBoxLayout(result_group_);
  rejected_->setMaximumHeight(140);
  rejected_->setWordWrap(true);
  auto* line = new QHBoxLayout;
  line->addWidget(bar_, 1);
  line->addWidget(stop_install_);
  layout->addWidget(summary_);
  layout->addWidget(install_);
  layout->addWidget(install_reason_);
  layout->addLayout(line);
  layout->addWidget(outcome_);
  layout->addWidget(rejected_);
  column.addWidget(result_group_);
}

void RecordPlace::name_parts() {
  coverage_group_->setTitle(tr("Bend it in all directions"));
  recording_group_->setTitle(tr("Recording"));
  result_group_->setTitle(tr("What was recorded"));
  file_label_->setText(tr("&File"));
  file_->setAccessibleName(tr("File to record to"));
  browse_->setText(tr("&Choose…"));
  install_->setText(tr("&Install as this finger's reference"));
  stop_install_->setText(tr("&Stop"));
  stop_install_->setAccessibleDescription(tr("Stops the installation; nothing is changed."));
  bar_->setAccessibleName(tr("Progress of the installation"));
  rejected_->setAccessibleName(tr("Frames that were left out, with the reason"));
  show_status();
  show_coverage();
}

bool RecordPlace::is_busy() const {
  const RecordingState state = session_.status().recording.state;
  return state == RecordingState::kRunning || state == RecordingState::kFinishing ||
         install_work_.is_running();
}

void RecordPlace::begin_coverage() {
  coverage_.begin();
  touched_frames_ = 0;
}

void RecordPlace::look_at_frame() {
  if (!isVisible()) return;
  const FrameResult& result = session_.view()->watched.result;
  if (result.markers && result.shape)
    coverage_.add(*result.markers, *result.shape);
  else
    coverage_.add_nothing();
  touch_ = face_touch(result);
  const bool is_recording = session_.status().recording.state == RecordingState::kRunning;
  if (is_recording && touch_ == FaceTouch::kTouched) ++touched_frames_;
  show_coverage();
}

void RecordPlace::show_coverage() {
  const BendPicture& picture = coverage_.picture();
  coverage_view_->show_coverage(picture);
  QStringList missing;
  for (const BendDirection direction : picture.missing()) missing << bend_direction_text(direction);
  missing_->setText(picture.poses == 0  ? tr("The markers have to be seen to tell how it bends.")
                    : missing.isEmpty() ? tr("All directions are reached.")
                                        : tr("Still missing: %1.").arg(missing.join(", ")));
}

void RecordPlace::start_or_stop() {
  if (session_.status().recording.state == RecordingState::kRunning)
    session_.stop_recording();
  else
    begin_recording();
}

void RecordPlace::begin_recording() {
  report_.reset();
  installed_.clear();
  begin_coverage();
  session_.start_recording(path_of(file_->text()));
}

void RecordPlace::choose_file() {
  auto* dialog = new QFileDialog(this, tr("Record to"), file_->text(), tr("Video (*.mkv)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("mkv"));
  connect(dialog, &QFileDialog::fileSelected, file_, &QLineEdit::setText);
  dialog->show();
}

void RecordPlace::propose_file() {
  const auto& folder = session_.status().finger.folder;
  const QDir where(folder.empty() ? QDir::homePath() : QString::fromStdString(folder.string()));
  file_->setText(where.filePath(
      QStringLiteral("bending_%1.mkv")
          .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmmss")))));
}

void RecordPlace::measure_space() {
  if (since_space_.isValid() && since_space_.elapsed() < kBetweenSpace_ms) return;
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

void RecordPlace::install() {
  const auto folder = session_.status().finger.folder;
  const auto video = recorded_;
  report_.reset();
  install_work_.start([this, folder, video, installer = installer_](const Job& job) {
    auto report = std::make_shared<Result<ReferenceReport>>(installer(folder, video, job));
    return std::function<void()>([this, report, video] {
      installed_ = video;
      report_ = *report;
      show_installed(*report);
    });
  });
  show_status();
}

void RecordPlace::show_installed(const Result<ReferenceReport>& report) {
  rejected_->clear();
  if (!report) return;
  for (const std::string& reason : report->rejected)
    rejected_->addItem(QString::fromStdString(reason));
  Q_EMIT installed();
}

void RecordPlace::show_status() {
  const LiveStatus& status = session_.status();
  const RecordingState state = status.recording.state;
  if (status.finger.folder != shown_finger_ || file_->text().isEmpty()) {
    if (status.finger.folder != shown_finger_ && !was_recording_) report_.reset();
    shown_finger_ = status.finger.folder;
    if (state != RecordingState::kRunning) propose_file();
    coverage_ = BendCoverage();
  }
  const bool is_recording = state == RecordingState::kRunning;
  if (was_recording_ && state == RecordingState::kDone) {
    if (status.recording.counts.recorded > 0) {
      recorded_ = status.recording.file;
      propose_file();
    }
    was_recording_ = false;
  }
  was_recording_ = was_recording_ || is_recording;
  if (isVisible()) measure_space();
  show_button(status);
  show_progress(status.recording);
  show_recorded(status);
  show_problems(status);
}

QString RecordPlace::why_not(const LiveStatus& status) const {
  if (install_work_.is_running()) return tr("The recording is being installed.");
  if (status.recording.state == RecordingState::kFinishing)
    return tr("The last frames are being written.");
  if (status.source.state != SourceState::kRunning)
    return tr("Open a source first: a camera, or the simulated finger.");
  return {};
}

void RecordPlace::show_button(const LiveStatus& status) {
  const bool is_recording = status.recording.state == RecordingState::kRunning;
  const QString why = is_recording ? QString() : why_not(status);
  record_->setText(is_recording ? tr("Stop &recording") : tr("Start &recording"));
  // A new text takes the shortcut away.
  record_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
  record_->setToolTip(tr("Ctrl+R"));
  record_->setIcon(
      icon(is_recording ? QStringLiteral("stop") : QStringLiteral("record"), palette()));
  record_->setEnabled(why.isEmpty());
  reason_->setText(why);
  reason_->setVisible(!why.isEmpty());
  for (QWidget* widget : {static_cast<QWidget*>(file_), static_cast<QWidget*>(browse_)})
    widget->setEnabled(!is_recording);
}

void RecordPlace::show_progress(const RecordingStatus& recording) {
  const QLocale locale;
  const bool is_recording = recording.state == RecordingState::kRunning;
  progress_->setVisible(is_recording);
  const std::uint64_t lost = recording.counts.dropped + recording.counts.missing;
  if (is_recording)
    progress_->setText(
        tr("<b>Recording</b> %1 min<br>%2, %3, %4 GB")
            .arg(time_text(recording.seconds),
                 tr("%n frame(s)", nullptr, static_cast<int>(recording.counts.recorded)),
                 tr("%n lost", nullptr, static_cast<int>(lost)),
                 locale.toString(static_cast<double>(recording.counts.bytes) / kGigabyte, 'f', 2)));
  std::optional<double> free_gb = free_gb_;
  if (is_recording && recording.counts.free_bytes > 0)
    free_gb = static_cast<double>(recording.counts.free_bytes) / kGigabyte;
  QString text;
  if (free_gb) text = tr("Space left: %1 GB").arg(locale.toString(*free_gb, 'f', 1));
  if (free_gb && is_recording && recording.seconds > 2 && recording.counts.bytes > 0) {
    const double gb_per_s =
        static_cast<double>(recording.counts.bytes) / kGigabyte / recording.seconds;
    text += tr(", room for about %n minute(s)",
               nullptr,
               static_cast<int>(std::min(*free_gb / gb_per_s / 60, 99999.0)));
  }
  space_->setText(text);
  space_->setVisible(!text.isEmpty());
}

QString RecordPlace::why_not_install(const LiveStatus& status) const {
  if (status.finger.folder.empty()) return tr("Open the finger that was recorded first.");
  if (status.finger.finger && status.finger.finger->face.kind == FaceKind::kFlat)
    return tr("A flat sensor has one untouched picture instead of a recording.");
  if (is_busy()) return install_work_.is_running() ? QString() : tr("A recording is under way.");
  return {};
}

void RecordPlace::show_recorded(const LiveStatus& status) {
  const RecordingStatus& recording = status.recording;
  const bool has_recorded = !recorded_.empty();
  result_group_->setVisible(has_recorded);
  if (!has_recorded) return;
  const QLocale locale;
  if (recording.file == recorded_) {
    QStringList lines{
        tr("%1: %2, %3 min")
            .arg(QString::fromStdString(recorded_.filename().string()),
                 tr("%n frame(s)", nullptr, static_cast<int>(recording.counts.recorded)),
                 time_text(recording.seconds))};
    if (const auto dropped = recording.counts.dropped; dropped > 0)
      lines << tr("%n frame(s) were lost because this computer or its disk was too slow.",
                  nullptr,
                  static_cast<int>(dropped));
    if (const auto missing = recording.counts.missing; missing > 0)
      lines << tr("%n frame(s) never came from the source.", nullptr, static_cast<int>(missing));
    if (recording.counts.dropped + recording.counts.missing == 0) lines << tr("No frame was lost.");
    if (touched_frames_ > 0)
      lines << tr("The contact face was touched in %n frame(s).",
                  nullptr,
                  static_cast<int>(touched_frames_));
    summary_->setText(lines.join(QLatin1Char('\n')));
  }
  const QString why = why_not_install(status);
  const bool is_installing = install_work_.is_running();
  install_->setEnabled(why.isEmpty() && !is_installing);
  install_->setVisible(!is_installing);
  install_reason_->setText(why);
  install_reason_->setVisible(!why.isEmpty());
  bar_->setVisible(is_installing);
  stop_install_->setVisible(is_installing);
  outcome_->setText(outcome_text());
  outcome_->setVisible(!outcome_->text().isEmpty());
  rejected_->setVisible(report_ && report_->ok() && rejected_->count() > 0 && !is_installing);
}

QString RecordPlace::outcome_text() const {
  if (install_work_.is_running()) {
    const auto left = install_work_.seconds_left();
    if (!left) return tr("Reading the recording…");
    return tr("About %n second(s) left.", nullptr, static_cast<int>(*left) + 1);
  }
  if (!report_ || !report_->ok()) return {};
  const ReferenceReport& report = report_->value();
  QStringList lines{
      tr("Installed: %1 of %n frame(s) are in the reference.", nullptr, report.frames_read)
          .arg(report.frames_kept),
      tr("What it leaves open: half of the references made from it are off by less than %1 mm, 95 "
         "% "
         "by less than %2 mm.")
          .arg(QLocale().toString(report.error_median_mm, 'f', 3),
               QLocale().toString(report.error_p95_mm, 'f', 3))};
  if (report.repeated > 0)
    lines << tr("%n frame(s) showed a pose that others show as well.", nullptr, report.repeated);
  if (!report.rejected.empty()) lines << tr("Left out, with the reason:");
  return lines.join(QLatin1Char('\n'));
}

void RecordPlace::show_installing() {
  bar_->setValue(static_cast<int>(100 * install_work_.fraction()));
  outcome_->setText(outcome_text());
  outcome_->setVisible(true);
}

void RecordPlace::show_problems(const LiveStatus& status) {
  std::vector<Problem> problems;
  if (status.recording.problem) problems.push_back(Problem::of(*status.recording.problem));
  if (report_ && !report_->ok()) problems.push_back(Problem::of(report_->error()));
  const auto note = [&](Meaning meaning, const QString& what, const QString& advice) {
    problems.push_back({meaning, what, advice, {}, {}});
  };
  const bool is_recording = status.recording.state == RecordingState::kRunning;
  const std::uint64_t lost =
      is_recording ? status.recording.counts.dropped + status.recording.counts.missing : 0;
  if (lost > 0)
    note(Meaning::kBad,
         tr("%n frame(s) of this recording are lost.", nullptr, static_cast<int>(lost)),
         tr("Try another disk, or a smaller picture."));
  if (session_.view() && touch_ == FaceTouch::kTouched)
    note(Meaning::kBad,
         tr("The contact face is touched."),
         tr("Keep it free: bend the finger at its tip, its sides or its back."));
  if (free_gb_ && *free_gb_ < kLittleSpace_gb)
    note(Meaning::kDoubtful,
         tr("Little space is left on the disk."),
         tr("Choose a file on another disk, or make room."));
  if (report_ && report_->ok())
    for (const std::string& warning : report_->value().warnings)
      note(Meaning::kDoubtful, QString::fromStdString(warning), {});
  problems_->set_problems(std::move(problems));
}

void RecordPlace::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_status();
}

void RecordPlace::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  show_status();
}

}  // namespace alltact
