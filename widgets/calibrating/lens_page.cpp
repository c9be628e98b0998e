#include "widgets/calibrating/lens_page.h"

#include "core/io/atomic_file.h"
#include "core/io/message_json.h"
#include "widgets/calibrating/space_key.h"
#include "widgets/joined_words.h"
#include "widgets/language.h"
#include "widgets/panels/side_panel.h"
#include "widgets/tip_of_text.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLocale>
#include <QVBoxLayout>

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

constexpr int kLensSideWidth = 280, kGroupMargin = 0;
constexpr int kLongestLine = 28;  // letters; longer lines widen the column

/// Breaks a long text at the space nearest to its middle.
QString in_two_lines(QString text) {
  if (text.size() <= kLongestLine) return text;
  const auto middle = text.size() / 2;
  const auto before = text.lastIndexOf(QLatin1Char(' '), middle),
             after = text.indexOf(QLatin1Char(' '), middle);
  const bool is_later = before < 0 || (after >= 0 && after - middle < middle - before);
  const auto at = is_later ? after : before;
  if (at >= 0) text[at] = QLatin1Char('\n');
  return text;
}

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

/// As a translatable message where the writing program stored one.
Message verdict_in(const LensRecord& record) {
  if (const auto stored = record.find("verdict_message"); stored != record.end()) {
    const auto json = nlohmann::ordered_json::parse(stored->second, nullptr, false);
    if (json.is_object()) return message_of(json);
  }
  const auto verdict = record.find("verdict");
  return verdict == record.end() ? Message() : Message::typed(verdict->second);
}

QString camera_text(const CameraParameters& camera, const LensRecord& record) {
  const QLocale locale;
  QStringList parts{LensPage::tr("%1, %2 × %3 px")
                        .arg(model_text(camera.model))
                        .arg(camera.width_px)
                        .arg(camera.height_px)};
  if (camera.model == CameraModel::kOrthographic)
    parts << LensPage::tr("%1 mm a pixel").arg(locale.toString(camera.mm_per_px, 'g', 4));
  else
    parts << LensPage::tr("focal length %1 px").arg(locale.toString(camera.fx_px, 'f', 1));
  if (camera.port) parts << LensPage::tr("behind a window");
  QString text = as_sentence(joined(parts));
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
      live_(new ImagePanel(session)),
      summary_(wrapped_text()),
      problems_(new ProblemList),
      file_group_(new QGroupBox),
      board_group_(new QGroupBox),
      live_group_(new QGroupBox),
      file_(new QLineEdit),
      images_(new QLineEdit),
      choose_file_(new QPushButton),
      choose_images_(new QPushButton),
      simulated_(new QPushButton),
      measure_(new QPushButton),
      stop_(new QPushButton),
      form_(new LensForm),
      images_label_(new QLabel),
      outcome_(wrapped_text()),
      bar_(new QProgressBar),
      take_(new QPushButton),
      forget_(new QPushButton),
      automatic_(new QCheckBox),
      guide_(wrapped_text()),
      forecast_(wrapped_text()),
      views_(new QListWidget) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(problems_);
  auto* row = new QHBoxLayout;
  row->addWidget(live_, 1);
  row->addWidget(make_side());
  column->addLayout(row, 1);
  ViewOptions options;
  options.direction = options.depth = options.markers = options.edges = false;
  live_->set_options(options);
  live_->set_extra_overlays([this](const LiveView& view) { return overlays(view); });
  new SpaceKey(*this, [this] { press_pedal(); });
  connect_parts();
  say([this] { name_parts(); });
}

QWidget* LensPage::make_side() {
  const SidePanel side(kLensSideWidth);
  side.column->addWidget(summary_);
  auto* live = new QVBoxLayout(live_group_);
  live->addWidget(take_);
  live->addWidget(automatic_);
  live->addWidget(guide_);
  side.column->addWidget(live_group_);
  views_->setMinimumHeight(100);
  views_->setWordWrap(true);
  side.column->addWidget(forecast_);
  side.column->addWidget(views_, 1);
  side.column->addWidget(forget_);
  auto* file = new QVBoxLayout(file_group_);
  auto* file_row = new QHBoxLayout;
  file_row->addWidget(file_, 1);
  file_row->addWidget(choose_file_);
  file->addLayout(file_row);
  file->addWidget(simulated_);
  side.column->addWidget(file_group_);
  auto* board = new QVBoxLayout(board_group_);
  auto* run = new QHBoxLayout;
  run->addWidget(measure_);
  run->addWidget(bar_, 1);
  run->addWidget(stop_);
  board->addLayout(run);
  board->addWidget(outcome_);
  auto* images = new QHBoxLayout;
  images->addWidget(images_, 1);
  images->addWidget(choose_images_);
  board->addWidget(images_label_);
  board->addLayout(images);
  board->addWidget(form_);
  side.column->addWidget(board_group_);
  side.column->addStretch();
  for (QVBoxLayout* inside : {live, file, board}) {  // leaves more width to the image next to them
    const QMargins margins = inside->contentsMargins();
    inside->setContentsMargins(kGroupMargin, margins.top(), kGroupMargin, margins.bottom());
  }
  images_label_->setBuddy(images_);
  foot_ = side.foot;
  return side.root;
}

void LensPage::connect_parts() {
  connect(file_, &QLineEdit::editingFinished, this, [this] {
    if (!file_->text().trimmed().isEmpty()) take_file(file_->text().trimmed().toStdString());
  });
  for (QLineEdit* line : {file_, images_}) show_text_as_tip(*line);
  connect(choose_file_, &QPushButton::clicked, this, &LensPage::choose_file);
  connect(choose_images_, &QPushButton::clicked, this, &LensPage::choose_images);
  connect(simulated_, &QPushButton::clicked, this, &LensPage::use_simulated);
  connect(measure_, &QPushButton::clicked, this, &LensPage::measure);
  connect(stop_, &QPushButton::clicked, &work_, &BackgroundWork::stop);
  connect(take_, &QPushButton::clicked, this, &LensPage::request_board);
  connect(forget_, &QPushButton::clicked, this, &LensPage::remove_chosen_view);
  connect(automatic_, &QCheckBox::toggled, this, &LensPage::show_boards);
  connect(views_, &QListWidget::currentRowChanged, this, &LensPage::show_boards);
  connect(form_, &LensForm::board_changed, this, &LensPage::begin_boards);
  connect(&work_, &BackgroundWork::progressed, this, &LensPage::show_progress);
  connect(&work_, &BackgroundWork::finished, this, &LensPage::show_progress);
  connect(&analysing_, &BackgroundWork::finished, this, &LensPage::analyse_frame);
  connect(&fitting_, &BackgroundWork::finished, this, &LensPage::fit_boards);
  connect(&session_, &LiveSession::view_ready, this, &LensPage::analyse_frame);
}

void LensPage::name_parts() {
  file_group_->setTitle(tr("From a camera file"));
  board_group_->setTitle(tr("Or measured with pictures of a board"));
  live_group_->setTitle(tr("With a board before the camera"));
  file_->setAccessibleName(tr("Camera file"));
  file_->setPlaceholderText(tr("camera.yaml, as the lens calibration writes it"));
  file_->setToolTip(file_->text().isEmpty() ? file_->placeholderText() : file_->text());
  choose_file_->setText(tr("&Choose…"));
  choose_file_->setAccessibleName(tr("Choose a camera file"));
  simulated_->setText(in_two_lines(tr("&Use the simulated camera's lens")));
  images_label_->setText(tr("&Pictures"));
  images_->setAccessibleName(tr("Folder of board pictures, or a recording"));
  choose_images_->setText(tr("Choose…"));
  choose_images_->setAccessibleName(tr("Choose the folder of board pictures"));
  measure_->setText(tr("&Measure the lens"));
  stop_->setText(tr("Stop"));
  stop_->setAccessibleName(tr("Stop measuring the lens"));
  bar_->setAccessibleName(tr("Progress of the lens calibration"));
  outcome_->setAccessibleName(tr("Outcome of the lens calibration"));
  take_->setText(in_two_lines(tr("&Take this board (Space)")));
  automatic_->setText(tr("By &itself where it is new and still"));
  automatic_->setToolTip(
      tr("Takes the board whenever it is held still in a place, or tilted in a way, that was not "
         "taken yet"));
  guide_->setAccessibleName(tr("How to hold the board"));
  views_->setAccessibleName(tr("Views of the board, with their errors"));
  forget_->setText(tr("Leave the chosen view out"));
  show_status();
  show_progress();
  show_boards();
}

StepState LensPage::state() const {
  return missing().isEmpty() ? StepState::kDone : StepState::kToDo;
}

QString LensPage::missing() const {
  if (has_folder() || camera_ ||
      (session_.status().finger.state == FingerState::kLoading && had_folder_))
    return {};
  return tr("The lens has to be known first: choose a camera file, or measure one.");
}

QWidget* LensPage::main_control() const {
  return can_take() ? take_ : choose_file_;
}

void LensPage::show_status() {
  const FingerStatus& finger = session_.status().finger;
  const bool is_simulated =
      finger.state == FingerState::kReady && finger.folder.empty() && finger.finger;
  if (finger.state == FingerState::kLoading && had_folder_) return;
  had_folder_ = has_folder();
  file_group_->setVisible(!had_folder_);
  board_group_->setVisible(!had_folder_);
  simulated_->setVisible(is_simulated);
  show_summary(had_folder_);
  show_boards();
}

void LensPage::show_summary(bool has_folder) {
  const FingerStatus& finger = session_.status().finger;
  if (has_folder)
    summary_->setText(tr("This finger's camera has %1")
                          .arg(camera_text(finger.finger->camera, finger.finger->lens_record)) +
                      QLatin1Char('\n') +
                      tr("Blue: straight lines of the world, as this lens shows them."));
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

void LensPage::choose_images() {
  auto* dialog = new QFileDialog(this, tr("Folder of board pictures"), images_->text());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, images_, &QLineEdit::setText);
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
  LensRequest request;
  request.images = images_->text().trimmed().toStdString();
  request.board = form_->board();
  request.settings = form_->settings();
  request.port = form_->port();
  if (const QString refused = form_->refusal(); !refused.isEmpty())
    return problems_->set_problems({{Meaning::kBad, refused, {}, {}, {}}});
  if (request.images.empty())
    return problems_->set_problems(
        {{Meaning::kBad, tr("No folder of pictures is named."), {}, {}, {}}});
  std::error_code failed;
  const bool is_folder = std::filesystem::is_directory(request.images, failed);
  request.camera = (is_folder ? request.images : request.images.parent_path()) / "camera.yaml";
  problems_->set_problems({});
  outcome_->clear();
  work_.start([this, request, measurer = measurer_, disk = disk_](const Job& job) {
    disk->wait();
    const auto measured = measurer(request, job);
    return std::function<void()>([this, measured, file = request.camera] {
      if (!measured) return problems_->set_problems({Problem::of(measured.error())});
      outcome_->setText(tr("Written to %1.").arg(QString::fromStdString(file.string())));
      show_views(measured->views);
      forecast_->setText(
          measured->advice.empty()
              ? QString()
              : tr("Still better with: %1.").arg(in_window_language(measured->advice)));
      take_file(file);
    });
  });
  show_progress();
}

void LensPage::show_views(const std::vector<LensViewReport>& views) {
  const QLocale locale;
  const QString chosen = views_->currentItem() != nullptr
                             ? views_->currentItem()->data(Qt::UserRole).toString()
                             : QString();
  const QSignalBlocker quiet(views_);
  views_->clear();
  for (const LensViewReport& view : views) {
    const QString name = QString::fromStdString(view.name);
    auto* item = new QListWidgetItem(
        view.rejection.empty()
            ? tr("%1: error %2 px, tilted by %3°")
                  .arg(name,
                       locale.toString(view.error_px, 'f', 2),
                       locale.toString(view.tilt_deg, 'f', 0))
            : tr("%1: not used, %2").arg(name, in_window_language(view.rejection)));
    item->setData(Qt::UserRole, name);
    views_->addItem(item);
    if (name == chosen) views_->setCurrentItem(item);
  }
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
