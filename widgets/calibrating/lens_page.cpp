#include "widgets/calibrating/lens_page.h"

#include "calibration/lens/board_views.h"
#include "core/base/atomic_file.h"
#include "core/base/message_json.h"
#include "core/camera/camera.h"
#include "core/image/image_file.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/image/image_view.h"
#include "widgets/image/overlays.h"
#include "widgets/language.h"
#include "widgets/shell/page.h"
#include "widgets/widget_base.h"

#include <QApplication>
#include <QDateTime>
#include <QHBoxLayout>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>
#include <array>

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

const QColor kCorner(255, 214, 64), kAccepted(47, 199, 155), kGrid(86, 180, 233);
constexpr double kCornerRing = 4;  // logical pixels
constexpr double kGridStep = 0.1;  // of a tangent
constexpr int kGridLines = 12;     // on each side
constexpr int kGridPoints = 96;

/// A world line at z = 1, interrupted where it is outside the image.
QPainterPath seen_line(const Camera& camera, double fixed, bool is_upright,
                       const ImageTransform& t) {
  QPainterPath path;
  bool is_drawing = false;
  constexpr double kReach = kGridLines * kGridStep;
  const cv::Size size = camera.size();
  for (int i = 0; i <= kGridPoints; ++i) {
    const double along = -kReach + 2 * kReach * i / kGridPoints;
    const Eigen::Vector3d point =
        is_upright ? Eigen::Vector3d(fixed, along, 1) : Eigen::Vector3d(along, fixed, 1);
    const auto pixel = camera.project(100 * point);
    const bool is_seen = pixel && pixel->x() > -20 && pixel->y() > -20 &&
                         pixel->x() < size.width + 20 && pixel->y() < size.height + 20;
    if (is_seen) {
      const QPointF at = t.to_widget({pixel->x(), pixel->y()});
      if (is_drawing)
        path.lineTo(at);
      else
        path.moveTo(at);
    }
    is_drawing = is_seen;
  }
  return path;
}

/// Detected corners as rings, filled where the view is worth adding.
Overlay corners_overlay(const BoardAnalysis& detection) {
  return [view = *detection.view, is_good = detection.is_useful()](
             QPainter& painter, const ImageTransform& transform) {
    QPainterPath path;
    for (const Eigen::Vector2d& pixel : view.pixels)
      path.addEllipse(transform.to_widget({pixel.x(), pixel.y()}), kCornerRing, kCornerRing);
    if (is_good) painter.fillPath(path, kAccepted);
    stroke_over(painter, path, is_good ? kAccepted : kCorner, 1.4);
  };
}

/// Image cells without a corner in any accepted view, hatched.
Overlay unseen_cells_overlay(const BoardCollector::Cells& cells, QSize image_size) {
  return [cells, image_size](QPainter& painter, const ImageTransform& transform) {
    const QRectF area = transform.covered(image_size);
    const double width = area.width() / BoardCollector::kColumns;
    const double height = area.height() / BoardCollector::kRows;
    for (int row = 0; row < BoardCollector::kRows; ++row)
      for (int column = 0; column < BoardCollector::kColumns; ++column)
        if (cells[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == 0)
          painter.fillRect(
              QRectF(area.left() + column * width, area.top() + row * height, width, height)
                  .adjusted(2, 2, -2, -2),
              QBrush(QColor(240, 145, 90, 130), Qt::BDiagPattern));
  };
}

/// Straight lines in the world, evenly spaced in tangents, as projected by this camera.
Overlay lens_grid_overlay(const Camera& camera) {
  return [camera](QPainter& painter, const ImageTransform& transform) {
    if (!camera.is_perspective()) return;
    const cv::Size size = camera.size();
    painter.setClipRect(transform.covered({size.width, size.height}));
    QPainterPath path;
    for (int line = -kGridLines; line <= kGridLines; ++line)
      for (const bool is_upright : {true, false})
        path.addPath(seen_line(camera, line * kGridStep, is_upright, transform));
    QColor colour = kGrid;
    colour.setAlpha(150);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, 1));
    painter.drawPath(path);
  };
}

constexpr int kLensSideWidth = 280, kGroupMargin = 0;
constexpr int kOutcomeLines = 2, kBoardGuideLines = 3, kLensForecastLines = 2;
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

/// What the calibration remarks on the board and the images, a line each.
QStringList remark_lines(const LensCalibration& calibration) {
  QStringList lines;
  for (const Message& remark : calibration.remarks) lines << window_sentence(remark);
  return lines;
}

QString camera_text(const CameraParameters& camera, const LensRecord& record) {
  const QLocale locale;
  QStringList parts{LensPage::tr("%1, %2 × %3 px")
                        .arg(model_text(camera.model))
                        .arg(camera.width_px)
                        .arg(camera.height_px)};
  if (camera.model == CameraModel::kOrthographic)
    parts << LensPage::tr("%1 mm per pixel").arg(locale.toString(camera.mm_per_px, 'g', 4));
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

LensPage::LensPage(LiveSession& session, std::filesystem::path work_folder, QWidget* parent)
    : StepPage(parent),
      session_(session),
      work_folder_(std::move(work_folder)),
      live_(new ImagePanel(session)),
      summary_(wrapped_text()),
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
      outcome_(new ReservedText(kOutcomeLines)),
      bar_(new QProgressBar),
      take_(new QPushButton),
      forget_(new QPushButton),
      automatic_(new QCheckBox),
      guide_(new ReservedText(kBoardGuideLines)),
      forecast_(new ReservedText(kLensForecastLines)),
      views_(new QListWidget) {
  auto* column = without_margins(new QVBoxLayout(this));
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
  add_widgets(*live, {take_, automatic_, guide_});
  side.column->addWidget(live_group_);
  views_->setFixedHeight(100);
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
  for (QWidget* shown : std::initializer_list<QWidget*>{bar_, stop_}) reserve_room(*shown);
  run->addWidget(bar_, 1);
  run->addWidget(stop_);
  board->addWidget(measure_);
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
  set_primary(*choose_file_, false);
  images_label_->setBuddy(images_);
  foot_ = side.foot;
  return side.root;
}

void LensPage::connect_parts() {
  connect(file_, &QLineEdit::editingFinished, this, [this] {
    if (!file_->text().trimmed().isEmpty()) take_file(file_->text().trimmed().toStdString());
  });
  for (QLineEdit* line : {file_, images_}) show_text_as_tip(*line);
  connect(choose_file_, &QPushButton::clicked, this, [this] {
    ask_for_file(
        this, FilesOf::kCameras, tr("Camera file"),
        tr("Camera (*.yaml *.yml *.json *.xml *.cameramodel *.txt)"),
        [this](const QString& file) { take_file(file.toStdString()); }, file_->text());
  });
  connect(choose_images_, &QPushButton::clicked, this, [this] {
    ask_for_folder(
        this, FilesOf::kImages, tr("Folder of board images"),
        [this](const QString& folder) { images_->setText(folder); }, images_->text());
  });
  connect(simulated_, &QPushButton::clicked, this, &LensPage::use_simulated);
  connect(measure_, &QPushButton::clicked, this, &LensPage::measure);
  connect(stop_, &QPushButton::clicked, &work_, &BackgroundWork::stop);
  connect(take_, &QPushButton::clicked, this, &LensPage::request_board);
  connect(forget_, &QPushButton::clicked, this, [this] {
    if (const QListWidgetItem* item = views_->currentItem())
      view_to_remove_ = item->data(Qt::UserRole).toString().toStdString();
    if (!analysing_.is_running()) remove_pending_view();
  });
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
  board_group_->setTitle(tr("Measured with images of a board"));
  live_group_->setTitle(tr("Live, with a board"));
  file_->setAccessibleName(tr("Camera file"));
  file_->setPlaceholderText(
      tr("camera.yaml, or a file of ROS, OpenCV, Kalibr, mrcal, PhotonVision or Matlab"));
  file_->setToolTip(file_->text().isEmpty() ? file_->placeholderText() : file_->text());
  choose_file_->setText(tr("&Choose…"));
  choose_file_->setAccessibleName(tr("Choose a camera file"));
  choose_file_->setToolTip(tr("Uses a lens that was measured before"));
  simulated_->setText(in_two_lines(tr("&Use the simulated camera's lens")));
  simulated_->setToolTip(tr("The lens of a simulated camera is known exactly"));
  images_label_->setText(tr("Ima&ges"));
  images_->setAccessibleName(tr("Folder of board images, or a recording"));
  images_->setToolTip(tr("Images or a video of the board, seen from many sides"));
  choose_images_->setText(tr("Choose…"));
  choose_images_->setAccessibleName(tr("Choose the folder of board images"));
  choose_images_->setToolTip(tr("Chooses stored images of the board"));
  measure_->setText(tr("&Measure the lens"));
  measure_->setToolTip(tr("Computes the camera file from the views of the board"));
  stop_->setText(tr("Stop"));
  stop_->setAccessibleName(tr("Stop measuring the lens"));
  stop_->setToolTip(tr("Ends the measurement without a result"));
  bar_->setAccessibleName(tr("Progress of the lens calibration"));
  outcome_->setAccessibleName(tr("Outcome of the lens calibration"));
  take_->setText(in_two_lines(tr("&Take this board (Space)")));
  take_->setToolTip(tr("Stores the present image as a view of the board"));
  automatic_->setText(tr("Automatically when ne&w and still"));
  automatic_->setToolTip(tr("Takes the board when it is held still at a new position or tilt"));
  guide_->setAccessibleName(tr("How to hold the board"));
  views_->setAccessibleName(tr("Views of the board, with their errors"));
  forget_->setText(in_two_lines(tr("Leave the chosen view out")));
  forget_->setToolTip(tr("The lens is measured without it"));
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
  return tr("The lens is not known yet: choose a camera file, or measure the lens.");
}

QWidget* LensPage::main_control() const { return can_take() ? take_ : choose_file_; }

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
                      QLatin1Char('\n') + tr("Blue: straight lines, as this lens shows them."));
  else if (camera_)
    summary_->setText(
        tr("The camera has %1").arg(camera_text(camera_->parameters, camera_->lens)) +
        QLatin1Char('\n') +
        as_sentence(tr("Camera file: %1").arg(in_window_language(camera_->understood))));
  else
    summary_->setText(
        tr("A finger measures through its camera's lens, so the lens comes first. Measure it once "
           "for each camera, with ten to twenty images of a flat board from all sides."));
}

void LensPage::take_file(const std::filesystem::path& file) {
  const auto camera = load_camera(file);
  std::vector<Problem> problems;
  if (!camera) {
    camera_.reset();
    camera_file_.clear();
    problems.push_back(Problem::of(camera.error()));
  } else {
    camera_ = *camera;
    camera_file_ = file;
    for (const Message& warning : camera->warnings)
      problems.push_back(Problem::of(Error{warning, "", ""}, Meaning::kDoubtful));
  }
  set_problems(std::move(problems));
  file_->setText(QString::fromStdString(file.string()));
  show_status();
  Q_EMIT changed();
}

bool LensPage::take_files(const DroppedFiles& dropped) {
  if (dropped.files.size() > 1) return false;
  switch (dropped.kind) {
    case FileKind::kFolder:
    case FileKind::kVideo:
      images_->setText(QString::fromStdString(dropped.files.front().string()));
      return true;
    case FileKind::kOther:
      take_file(dropped.files.front());
      return true;
    case FileKind::kFinger:
    case FileKind::kImages:
    case FileKind::kRecipe:
    case FileKind::kMesh:
      break;
  }
  return false;
}

void LensPage::use_simulated() {
  const FingerStatus& finger = session_.status().finger;
  if (!finger.finger) return;
  const auto file = work_folder_ / "simulated_camera.yaml";
  Status saved = make_folder(work_folder_);
  if (saved) saved = save_camera(file, finger.finger->camera);
  if (!saved) return set_problems({Problem::of(saved.error())});
  take_file(file);
}

void LensPage::measure() {
  const std::filesystem::path images = images_->text().trimmed().toStdString();
  if (const QString refused = form_->refusal(); !refused.isEmpty())
    return set_problems({{Meaning::kBad, refused}});
  if (images.empty())
    return set_problems({{Meaning::kBad, tr("No folder of images is specified.")}});
  std::error_code failed;
  const bool is_folder = std::filesystem::is_directory(images, failed);
  const auto file = (is_folder ? images : images.parent_path()) / "camera.yaml";
  set_problems({});
  outcome_->clear();
  work_.start([this, images, file, board = form_->board(), settings = form_->settings(),
               port = form_->port(), disk = disk_](const Job& job) {
    disk->wait();
    const auto measured = measure_lens({images}, board, settings, job);
    Status saved;
    if (measured) {
      CameraParameters camera = measured->fit.lens;
      camera.port = port;
      saved = save_camera(file, camera, lens_record(board, *measured));
    } else {
      saved = measured.error();
    }
    return std::function<void()>([this, measured, saved, file] {
      if (!saved) return set_problems({Problem::of(saved.error())});
      outcome_->setText(tr("Written to %1.").arg(QString::fromStdString(file.string())));
      show_views(measured->views);
      const Message& advice = measured->coverage.advice;
      QStringList lines = remark_lines(*measured);
      if (!advice.empty())
        lines.prepend(tr("Still better with: %1.").arg(in_window_language(advice)));
      forecast_->setText(lines.join(QLatin1Char('\n')));
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
                  .arg(name, locale.toString(view.error_px, 'f', 2),
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
  bar_->setVisible(is_running);
  stop_->setVisible(is_running);
  bar_->setValue(static_cast<int>(100 * work_.fraction()));
  bar_->setFormat(in_window_language(work_.what()));
}

namespace {

NumberField* number(double low, double high, int decimals, double value) {
  auto* box = new NumberField;
  box->setRange(low, high);
  box->set_shown_decimals(decimals);
  box->setValue(value);
  return box;
}

constexpr std::array kPatterns{BoardPattern::kChessboard, BoardPattern::kCharuco,
                               BoardPattern::kDots, BoardPattern::kAsymmetricDots,
                               BoardPattern::kAprilGrid};
constexpr int kPatternCount = static_cast<int>(kPatterns.size());

/// The typed number, also before editing is finished.
template <class Field>
auto now(const Field* field) {
  return field->typed().value_or(field->value());
}

}  // namespace

LensForm::LensForm(QWidget* parent)
    : Translated(parent),
      form_(new QFormLayout(this)),
      pattern_(new QComboBox),
      model_(new QComboBox),
      columns_(new IntegerField),
      rows_(new IntegerField),
      square_(number(0.01, 1000, 3, 5)),
      tag_gap_(number(0.05, 2, 3, LensSettings().tag_spacing)),
      distance_(number(1, 10000, 1, LensSettings().distance_mm)),
      gap_(number(0, 1000, 2, 0)),
      plate_(number(0, 1000, 2, 2)),
      plate_index_(number(1, 3, 3, FlatPort().plate_index)),
      medium_index_(number(1, 3, 3, FlatPort().medium_index)),
      has_port_(new QCheckBox),
      pattern_label_(new QLabel),
      size_label_(new QLabel),
      square_label_(new QLabel),
      tag_gap_label_(new QLabel),
      by_label_(new QLabel),
      model_label_(new QLabel),
      distance_label_(new QLabel),
      gap_label_(new QLabel),
      plate_label_(new QLabel),
      plate_index_label_(new QLabel),
      medium_index_label_(new QLabel) {
  square_->set_quantity(kBoardSquare);
  form_->setContentsMargins(0, 0, 0, 0);
  form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
  for (int i = 0; i < kPatternCount; ++i) pattern_->addItem({});
  for (int i = 0; i < 2; ++i) model_->addItem({});
  for (IntegerField* count : {columns_, rows_}) count->setRange(3, 100);
  columns_->setValue(9);
  rows_->setValue(6);
  auto* size = new QHBoxLayout;
  size->setSpacing(4);  // px: "9 by 6" stands in one line of the side
  add_widgets(*size, {columns_, by_label_, rows_});
  size->addStretch();
  form_->addRow(pattern_label_, pattern_);
  form_->addRow(size_label_, size);
  form_->addRow(square_label_, square_);
  form_->addRow(tag_gap_label_, tag_gap_);
  form_->addRow(model_label_, model_);
  form_->addRow(distance_label_, distance_);
  form_->addRow(has_port_);
  form_->addRow(gap_label_, gap_);
  form_->addRow(plate_label_, plate_);
  form_->addRow(plate_index_label_, plate_index_);
  form_->addRow(medium_index_label_, medium_index_);
  pattern_label_->setBuddy(pattern_);
  size_label_->setBuddy(columns_);
  square_label_->setBuddy(square_);
  tag_gap_label_->setBuddy(tag_gap_);
  connect(pattern_, &QComboBox::currentIndexChanged, this, &LensForm::show_tag_gap);
  connect(pattern_, &QComboBox::currentIndexChanged, this, &LensForm::board_changed);
  for (IntegerField* count : {columns_, rows_})
    connect(count, &IntegerField::valueChanged, this, &LensForm::board_changed);
  for (NumberField* length : {square_, tag_gap_})
    connect(length, &NumberField::valueChanged, this, &LensForm::board_changed);
  connect(has_port_, &QCheckBox::toggled, this, &LensForm::show_port);
  say([this] { name_parts(); });
}

void LensForm::name_parts() {
  pattern_label_->setText(tr("&Board"));
  pattern_->setAccessibleName(tr("Board"));
  pattern_->setToolTip(tr("What is printed on the board"));
  pattern_->setItemText(0, tr("Chessboard"));
  pattern_->setItemText(1, tr("ChArUco board"));
  pattern_->setItemText(2, tr("Grid of dots"));
  pattern_->setItemText(3, tr("Asymmetric grid of dots"));
  pattern_->setItemText(4, tr("AprilGrid"));
  size_label_->setText(tr("&Inner corners, dots or tags"));
  columns_->setAccessibleName(tr("Inner corners in a row"));
  columns_->setToolTip(tr("Counted on the board, along its long side"));
  rows_->setAccessibleName(tr("Inner corners in a column"));
  rows_->setToolTip(tr("Counted on the board, along its short side"));
  by_label_->setText(tr("by"));
  square_label_->setText(tr("&Side of a square"));
  square_->setAccessibleName(tr("Side of a square"));
  square_->setToolTip(tr("Measured on the printed board, by caliper over several squares"));
  tag_gap_label_->setText(tr("Ga&p / side of tags"));
  tag_gap_->setAccessibleName(tr("Gap of two tags as a fraction of their side"));
  tag_gap_->setToolTip(tr("The spacing printed on the board, such as 0.3"));
  model_label_->setText(tr("Lens"));
  model_->setAccessibleName(tr("Lens"));
  model_->setToolTip(tr("How the lens bends rays; fisheye for very wide angles"));
  model_->setItemText(0, tr("standard (Brown)"));
  model_->setItemText(1, tr("fisheye"));
  distance_label_->setText(tr("Finger distance"));
  distance_->setAccessibleName(tr("Distance from the lens to the finger's middle"));
  distance_->setToolTip(tr("The forecast of the depth's error is for this distance"));
  has_port_->setText(tr("The finger lies behind a window"));
  has_port_->setToolTip(tr(
      "Tick this if the finger is seen through a plate into silicone, but the board was in air"));
  gap_label_->setText(tr("Air gap"));
  gap_->setAccessibleName(tr("Air between lens and window"));
  plate_label_->setText(tr("Window thickness"));
  plate_->setAccessibleName(tr("Thickness of the window"));
  plate_index_label_->setText(tr("Window index"));
  plate_index_->setAccessibleName(tr("Refractive index of the window"));
  medium_index_label_->setText(tr("Index behind it"));
  medium_index_->setAccessibleName(tr("Refractive index behind the window"));
  for (NumberField* length : {square_, distance_, gap_, plate_}) length->setSuffix(tr(" mm"));
  show_port();
  show_tag_gap();
}

void LensForm::show_tag_gap() {
  const bool is_grid = board().pattern == BoardPattern::kAprilGrid;
  for (QWidget* part : std::initializer_list<QWidget*>{tag_gap_label_, tag_gap_})
    part->setVisible(is_grid);
}

void LensForm::show_port() {
  for (QWidget* part :
       std::initializer_list<QWidget*>{gap_label_, gap_, plate_label_, plate_, plate_index_label_,
                                       plate_index_, medium_index_label_, medium_index_})
    part->setVisible(has_port_->isChecked());
}

Board LensForm::board() const {
  Board board;
  board.pattern = kPatterns.at(static_cast<std::size_t>(pattern_->currentIndex()));
  board.columns = now(columns_);
  board.rows = now(rows_);
  board.square_mm = now(square_);
  board.tag_spacing = now(tag_gap_);
  return board;
}

LensSettings LensForm::settings() const {
  LensSettings settings;
  settings.pattern = board().pattern;
  settings.tag_spacing = now(tag_gap_);
  settings.model = model_->currentIndex() == 0 ? CameraModel::kBrown : CameraModel::kFisheye;
  settings.distance_mm = now(distance_);
  return settings;
}

std::optional<FlatPort> LensForm::port() const {
  if (!has_port_->isChecked()) return std::nullopt;
  return FlatPort{now(gap_), now(plate_), now(plate_index_), now(medium_index_)};
}

QString LensForm::refusal() const {
  for (const NumberField* field : findChildren<NumberField*>())
    if (field->isVisibleTo(this) && !field->typed()) return field->refusal();
  for (const IntegerField* field : findChildren<IntegerField*>())
    if (field->isVisibleTo(this) && !field->typed()) return field->refusal();
  return {};
}

// The step Lens with a board in front of the live camera: detects it, captures useful views, and
// calibrates the lens with them.

bool LensPage::has_folder() const {
  const FingerStatus& finger = session_.status().finger;
  return finger.state == FingerState::kReady && !finger.folder.empty();
}

bool LensPage::can_take() const {
  return !has_folder() && session_.view() && session_.status().source.is_live;
}

void LensPage::press_pedal() {
  if (take_->isEnabled() && take_->isVisible()) request_board();
}

void LensPage::request_board() {
  is_board_requested_ = true;
  analyse_frame();
}

void LensPage::begin_boards() {
  collector_.reset();
  detection_.reset();
  cells_ = {};
  fitted_.reset();
  boards_folder_.clear();
  is_board_requested_ = false;
  fitting_.stop();
  views_->clear();
  forecast_->clear();
  show_boards();
}

/// Analyses one frame at a time, always the newest.
void LensPage::analyse_frame() {
  if (!isVisible() || !can_take() || analysing_.is_running() || work_.is_running()) return;
  const FramePtr frame = session_.view()->result.frame;
  if (!frame || (detection_ && detection_->frame == frame)) return;
  if (!collector_) collector_ = std::make_shared<BoardCollector>(form_->board());
  analysing_.start([this, frame, collector = collector_](const Job&) {
    auto detection = std::make_shared<BoardAnalysis>(collector->analyse(frame));
    return std::function<void()>(
        [this, detection, collector] { take_detection(collector, *detection); });
  });
}

void LensPage::take_detection(const std::shared_ptr<BoardCollector>& by,
                              const BoardAnalysis& detection) {
  if (by != collector_) return;  // another board was chosen meanwhile
  detection_ = detection;
  remove_pending_view();
  if (is_fit_stale_) fit_boards();
  const bool is_by_hand = std::exchange(is_board_requested_, false);
  if (detection.view && (is_by_hand || (automatic_->isChecked() && detection.is_useful())))
    add_board(detection);
  show_boards();
}

void LensPage::add_board(const BoardAnalysis& detection) {
  collector_->add(detection);
  cells_ = collector_->cells();
  if (boards_folder_.empty()) {
    boards_folder_ =
        work_folder_ /
        ("boards_" +
         QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmmss")).toStdString());
    images_->setText(QString::fromStdString(boards_folder_.string()));
  }
  const FramePtr& frame = collector_->frames().back();
  const std::filesystem::path file = boards_folder_ / (frame->name + ".png");
  disk_->add(file, [file, frame]() -> Status {
    if (const Status made = make_folder(file.parent_path()); !made) return made;
    return write_image(file, frame->grey, frame->controls ? *frame->controls : std::string());
  });
  live_->freeze(false);
  live_->flash(tr("Board %1").arg(collector_->views().size()));
  QApplication::beep();
  is_fit_stale_ = true;
  fit_boards();
}

void LensPage::remove_pending_view() {
  const std::string name = std::exchange(view_to_remove_, {});
  if (name.empty() || !collector_) return;
  collector_->forget(name);
  cells_ = collector_->cells();
  const std::filesystem::path file = boards_folder_ / (name + ".png");
  disk_->add(file, [file]() -> Status {
    std::error_code failed;
    std::filesystem::remove(file, failed);
    return {};
  });
  is_fit_stale_ = true;
  fit_boards();
}

/// Calibrates the lens with the views captured so far.
void LensPage::fit_boards() {
  // While a frame is analysed its thread owns the collector; finishing calls this again.
  if (!is_fit_stale_ || fitting_.is_running() || analysing_.is_running() || !collector_)
    return show_boards();
  is_fit_stale_ = false;
  const auto& views = collector_->views();
  std::vector<LensViewReport> bare;
  for (const BoardView& view : views) {
    bare.emplace_back();
    bare.back().name = view.name;
    bare.back().rejection = en::say("its error is estimated from the third view on");
  }
  if (static_cast<int>(views.size()) < kFewestViews) {
    fitted_.reset();
    show_views(bare);
    return show_boards();
  }
  fitting_.start([this, views, size = collector_->frames().front()->grey.size(),
                  settings = form_->settings(), collector = collector_](const Job& job) {
    auto made =
        std::make_shared<Result<LensCalibration>>(calibrate_lens(views, size, settings, job));
    return std::function<void()>([this, made, collector] {
      if (collector != collector_) return;
      fitted_ = *made ? std::make_shared<const LensCalibration>(std::move(**made)) : nullptr;
      if (fitted_) show_views(fitted_->views);
      if (fitted_)
        forecast_->setText(
            (QStringList{window_sentence(fitted_->verdict.sentence)} + remark_lines(*fitted_))
                .join(QLatin1Char('\n')));
      else
        forecast_->setText(window_sentence(made->error().what));
      show_boards();
    });
  });
  show_boards();
}

QString LensPage::board_words() const {
  if (!can_take()) return tr("Open the camera as source to take boards live.");
  if (!detection_) return tr("Looking for the board.");
  if (!detection_->view) return window_sentence(detection_->no_board_reason);
  if (!detection_->is_sharp) return tr("The board is blurred: hold it still or further away.");
  if (!detection_->is_new) return tr("Position already captured: move or tilt the board.");
  if (!detection_->is_still) return tr("Hold it still.");
  return tr("Good: take it.");
}

void LensPage::show_boards() {
  const bool is_possible = can_take();
  live_group_->setVisible(!has_folder());
  take_->setEnabled(is_possible && detection_ && detection_->view);
  automatic_->setEnabled(is_possible);
  QString words = board_words();
  if (fitted_ && !fitted_->coverage.advice.empty())
    words += QLatin1Char('\n') +
             tr("Still missing: %1.").arg(in_window_language(fitted_->coverage.advice));
  guide_->setText(words);
  for (QWidget* widget : std::initializer_list<QWidget*>{views_, forecast_, forget_})
    widget->setVisible(!has_folder());
  forget_->setEnabled(views_->currentItem() != nullptr && !boards_folder_.empty());
}

std::vector<Overlay> LensPage::overlays(const LiveView& view) const {
  const FingerStatus& finger = session_.status().finger;
  if (has_folder() && finger.finger) {
    const auto camera = Camera::create(finger.finger->camera);
    const bool fits = camera && camera->size().width == view.result.grey.cols;
    return fits ? std::vector<Overlay>{lens_grid_overlay(*camera)} : std::vector<Overlay>();
  }
  std::vector<Overlay> overlays;
  if (!can_take()) return overlays;
  const QSize size(view.result.grey.cols, view.result.grey.rows);
  if (views_->count() > 0) overlays.push_back(unseen_cells_overlay(cells_, size));
  if (detection_ && detection_->view) overlays.push_back(corners_overlay(*detection_));
  return overlays;
}

}  // namespace alltact
