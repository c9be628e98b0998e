#include "widgets/calibrating/lens_page.h"

#include "core/io/atomic_file.h"
#include "core/io/message_json.h"
#include "widgets/language.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <QVBoxLayout>

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

QString model_text(CameraModel model) {
  switch (model) {
    case CameraModel::kPinhole:
      return LensPage::tr("a lens without distortion");
    case CameraModel::kBrown:
      return LensPage::tr("a lens with distortion (Brown)");
    case CameraModel::kFisheye:
      return LensPage::tr("a fisheye lens");
    case CameraModel::kOrthographic:
      break;
  }
  return LensPage::tr("a lens with parallel rays");
}

/// In words that can be translated, where the program that wrote it kept them.
Message verdict_in(const LensRecord& record) {
  if (const auto kept = record.find("verdict_message"); kept != record.end()) {
    const auto json = nlohmann::ordered_json::parse(kept->second, nullptr, false);
    if (json.is_object()) return message_of(json);
  }
  const auto verdict = record.find("verdict");
  return verdict == record.end() ? Message() : Message::typed(verdict->second);
}

QString camera_text(const CameraParameters& camera, const LensRecord& record) {
  const QLocale locale;
  QString text = LensPage::tr("%1, %2 × %3 px")
                     .arg(model_text(camera.model))
                     .arg(camera.width_px)
                     .arg(camera.height_px);
  if (camera.model == CameraModel::kOrthographic)
    text += LensPage::tr(", %1 mm a pixel").arg(locale.toString(camera.mm_per_px, 'g', 4));
  else
    text += LensPage::tr(", focal length %1 px").arg(locale.toString(camera.fx_px, 'f', 1));
  if (camera.port) text += LensPage::tr(", behind a window");
  text += QLatin1Char('.');
  if (const Message verdict = verdict_in(record); !verdict.empty())
    text +=
        QLatin1Char('\n') + LensPage::tr("Its calibration: %1.").arg(in_window_language(verdict));
  return text;
}

}  // namespace

LensPage::LensPage(LiveSession& session,
                   LensMeasurer measurer,
                   std::filesystem::path work_folder,
                   QWidget* parent)
    : StepPage(parent),
      session_(session),
      measurer_(std::move(measurer)),
      work_folder_(std::move(work_folder)),
      summary_(wrapped_text()),
      problems_(new ProblemList),
      file_group_(new QGroupBox),
      board_group_(new QGroupBox),
      file_(new QLineEdit),
      pictures_(new QLineEdit),
      choose_file_(new QPushButton),
      choose_pictures_(new QPushButton),
      simulated_(new QPushButton),
      measure_(new QPushButton),
      stop_(new QPushButton),
      pattern_(new QComboBox),
      columns_(new QSpinBox),
      rows_(new QSpinBox),
      square_(new QDoubleSpinBox),
      pictures_label_(new QLabel),
      pattern_label_(new QLabel),
      size_label_(new QLabel),
      square_label_(new QLabel),
      by_label_(new QLabel),
      outcome_(wrapped_text()),
      bar_(new QProgressBar) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(summary_);
  column->addWidget(problems_);
  auto* file_row = new QHBoxLayout(file_group_);
  file_row->addWidget(file_, 1);
  file_row->addWidget(choose_file_);
  file_row->addWidget(simulated_);
  column->addWidget(file_group_);
  column->addWidget(make_board_group());
  column->addStretch();
  connect(file_, &QLineEdit::editingFinished, this, [this] {
    if (!file_->text().trimmed().isEmpty()) take_file(file_->text().trimmed().toStdString());
  });
  connect(choose_file_, &QPushButton::clicked, this, &LensPage::choose_file);
  connect(choose_pictures_, &QPushButton::clicked, this, &LensPage::choose_pictures);
  connect(simulated_, &QPushButton::clicked, this, &LensPage::use_simulated);
  connect(measure_, &QPushButton::clicked, this, &LensPage::measure);
  connect(stop_, &QPushButton::clicked, &work_, &BackgroundWork::stop);
  connect(&work_, &BackgroundWork::progressed, this, &LensPage::show_progress);
  connect(&work_, &BackgroundWork::finished, this, &LensPage::show_progress);
  say([this] { name_parts(); });
}

QWidget* LensPage::make_board_group() {
  auto* form = new QFormLayout(board_group_);
  auto* pictures = new QHBoxLayout;
  pictures->addWidget(pictures_, 1);
  pictures->addWidget(choose_pictures_);
  for (int i = 0; i < 3; ++i) pattern_->addItem({});
  for (QSpinBox* count : {columns_, rows_}) count->setRange(3, 100);
  columns_->setValue(9);
  rows_->setValue(6);
  square_->setRange(0.01, 1000);
  square_->setDecimals(3);
  square_->setValue(5);
  auto* size = new QHBoxLayout;
  size->addWidget(columns_);
  size->addWidget(by_label_);
  size->addWidget(rows_);
  size->addStretch();
  auto* run = new QHBoxLayout;
  run->addWidget(measure_);
  run->addWidget(bar_, 1);
  run->addWidget(stop_);
  run->addStretch();
  form->addRow(pictures_label_, pictures);
  form->addRow(pattern_label_, pattern_);
  form->addRow(size_label_, size);
  form->addRow(square_label_, square_);
  form->addRow(run);
  form->addRow(outcome_);
  pictures_label_->setBuddy(pictures_);
  pattern_label_->setBuddy(pattern_);
  size_label_->setBuddy(columns_);
  square_label_->setBuddy(square_);
  return board_group_;
}

void LensPage::name_parts() {
  file_group_->setTitle(tr("From a camera file"));
  board_group_->setTitle(tr("Or measured with pictures of a board"));
  file_->setAccessibleName(tr("Camera file"));
  file_->setPlaceholderText(tr("camera.yaml, as the lens calibration writes it"));
  choose_file_->setText(tr("&Choose…"));
  choose_file_->setAccessibleName(tr("Choose a camera file"));
  simulated_->setText(tr("&Use the simulated camera's lens"));
  pictures_label_->setText(tr("&Pictures"));
  pictures_->setAccessibleName(tr("Folder of board pictures, or a recording"));
  choose_pictures_->setText(tr("Choose…"));
  choose_pictures_->setAccessibleName(tr("Choose the folder of board pictures"));
  pattern_label_->setText(tr("&Board"));
  pattern_->setAccessibleName(tr("Board"));
  pattern_->setItemText(0, tr("Chessboard"));
  pattern_->setItemText(1, tr("ChArUco board"));
  pattern_->setItemText(2, tr("Grid of dots"));
  size_label_->setText(tr("&Inner corners, or dots"));
  columns_->setAccessibleName(tr("Inner corners in a row"));
  rows_->setAccessibleName(tr("Inner corners in a column"));
  by_label_->setText(tr("by"));
  square_label_->setText(tr("&Side of a square"));
  square_->setAccessibleName(tr("Side of a square"));
  square_->setSuffix(tr(" mm"));
  measure_->setText(tr("&Measure the lens"));
  stop_->setText(tr("Stop"));
  stop_->setAccessibleName(tr("Stop measuring the lens"));
  bar_->setAccessibleName(tr("Progress of the lens calibration"));
  outcome_->setAccessibleName(tr("Outcome of the lens calibration"));
  show_status();
  show_progress();
}

StepState LensPage::state() const {
  return missing().isEmpty() ? StepState::kDone : StepState::kToDo;
}

QString LensPage::missing() const {
  const FingerStatus& finger = session_.status().finger;
  const bool is_own = finger.state == FingerState::kReady && !finger.folder.empty();
  if (is_own || camera_ || (finger.state == FingerState::kLoading && was_own_)) return {};
  return tr("The lens has to be known first: choose a camera file, or measure one.");
}

void LensPage::show_status() {
  const FingerStatus& finger = session_.status().finger;
  const bool is_own = finger.state == FingerState::kReady && !finger.folder.empty();
  const bool is_simulated =
      finger.state == FingerState::kReady && finger.folder.empty() && finger.finger;
  if (finger.state == FingerState::kLoading && was_own_) return;
  was_own_ = is_own;
  file_group_->setVisible(!is_own);
  board_group_->setVisible(!is_own);
  simulated_->setVisible(is_simulated);
  if (is_own)
    summary_->setText(tr("This finger's camera has %1")
                          .arg(camera_text(finger.finger->camera, finger.finger->lens_record)));
  else if (camera_)
    summary_->setText(tr("The camera has %1").arg(camera_text(*camera_, record_)));
  else
    summary_->setText(
        tr("A finger measures through its camera's lens, so the lens comes first. It is measured "
           "once for each camera, with ten to twenty pictures of a flat board from all sides."));
}

void LensPage::take_file(const std::filesystem::path& file) {
  LensRecord record;
  const auto camera = load_camera(file, &record);
  if (!camera) {
    camera_.reset();
    camera_file_.clear();
    problems_->set_problems({Problem::of(camera.error())});
  } else {
    camera_ = *camera;
    camera_file_ = file;
    record_ = record;
    problems_->set_problems({});
  }
  file_->setText(QString::fromStdString(file.string()));
  show_status();
  Q_EMIT changed();
}

void LensPage::choose_file() {
  auto* dialog =
      new QFileDialog(this, tr("Camera file"), file_->text(), tr("Camera (*.yaml *.yml)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    take_file(file.toStdString());
  });
  dialog->show();
}

void LensPage::choose_pictures() {
  auto* dialog = new QFileDialog(this, tr("Folder of board pictures"), pictures_->text());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, pictures_, &QLineEdit::setText);
  dialog->show();
}

void LensPage::use_simulated() {
  const FingerStatus& finger = session_.status().finger;
  if (!finger.finger) return;
  const auto file = work_folder_ / "simulated_camera.yaml";
  Status saved = make_folder(work_folder_);
  if (saved) saved = save_camera(file, finger.finger->camera);
  if (!saved) return problems_->set_problems({Problem::of(saved.error())});
  take_file(file);
}

void LensPage::measure() {
  LensWanted wanted;
  wanted.pictures = pictures_->text().trimmed().toStdString();
  constexpr BoardPattern kPatterns[] = {
      BoardPattern::kChessboard, BoardPattern::kCharuco, BoardPattern::kDots};
  wanted.settings.pattern = kPatterns[pattern_->currentIndex()];
  wanted.board.pattern = wanted.settings.pattern;
  wanted.board.columns = columns_->value();
  wanted.board.rows = rows_->value();
  wanted.board.square_mm = square_->value();
  if (wanted.pictures.empty())
    return problems_->set_problems(
        {{Meaning::kBad, tr("No folder of pictures is named."), {}, {}, {}}});
  std::error_code failed;
  const bool is_folder = std::filesystem::is_directory(wanted.pictures, failed);
  wanted.camera = (is_folder ? wanted.pictures : wanted.pictures.parent_path()) / "camera.yaml";
  problems_->set_problems({});
  outcome_->clear();
  work_.start([this, wanted, measurer = measurer_](const Job& job) {
    const auto verdict = measurer(wanted, job);
    return std::function<void()>([this, verdict, file = wanted.camera] {
      if (!verdict) return problems_->set_problems({Problem::of(verdict.error())});
      outcome_->setText(tr("Written to %1.").arg(QString::fromStdString(file.string())));
      take_file(file);
    });
  });
  show_progress();
}

void LensPage::show_progress() {
  const bool is_running = work_.is_running();
  measure_->setEnabled(!is_running);
  outcome_->setVisible(!outcome_->text().isEmpty());
  bar_->setVisible(is_running);
  stop_->setVisible(is_running);
  bar_->setValue(static_cast<int>(100 * work_.fraction()));
  bar_->setFormat(in_window_language(work_.what()));
}

}  // namespace alltact
