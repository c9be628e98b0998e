#include "widgets/places/inspect_place.h"

#include "core/io/picture.h"
#include "widgets/inspect/reading_text.h"
#include "widgets/inspect/save_inspected.h"
#include "widgets/places/side_panel.h"
#include "widgets/value_change.h"
#include "widgets/words/library_words.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <cmath>

namespace alltact {
namespace {

constexpr int kSideWidth = 320;

QString text_of(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}

}  // namespace

InspectPlace::InspectPlace(LiveSession& session, QUndoStack& undo, QWidget* parent)
    : Translated(parent),
      session_(session),
      undo_(undo),
      problems_(new ProblemList),
      live_(new QPushButton),
      video_(new QPushButton),
      folder_(new QPushButton),
      save_bar_(new SaveBar),
      shown_(new QLabel),
      summary_(new QLabel),
      saved_(new QLabel),
      first_(new InspectPane(PaneContent::kFirst)),
      second_(new InspectPane(PaneContent::kSecond)),
      time_line_(new TimeLine),
      side_(new InspectSide) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  auto* column = new QVBoxLayout;
  column->addWidget(make_header());
  column->addWidget(problems_);
  auto* panes = new QHBoxLayout;
  panes->addWidget(first_, 1);
  panes->addWidget(second_, 1);
  column->addLayout(panes, 1);
  auto* words = new QHBoxLayout;
  words->addWidget(summary_);
  words->addWidget(saved_, 1);
  column->addLayout(words);
  column->addWidget(time_line_);
  row->addLayout(column, 1);
  row->addWidget(make_side());
  second_->hide();
  time_line_->hide();
  connect_parts();
  if (!VtkView::is_supported()) options_.shown_as = ShownAs::kHeightMap;
  say([this] { name_parts(); });
  set_options(options_);
}

QWidget* InspectPlace::make_header() {
  auto* header = new QWidget;
  auto* row = new QHBoxLayout(header);
  row->setContentsMargins(0, 0, 0, 0);
  live_->setCheckable(true);
  live_->setChecked(true);
  for (QPushButton* button : {live_, video_, folder_}) row->addWidget(button);
  shown_->setMinimumWidth(1);
  row->addSpacing(8);
  row->addWidget(shown_, 1);
  row->addWidget(save_bar_);
  saved_->setMinimumWidth(1);
  saved_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  saved_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return header;
}

QWidget* InspectPlace::make_side() {
  const SidePanel panel(kSideWidth);
  panel.column->addWidget(side_);
  return panel.whole;
}

void InspectPlace::connect_parts() {
  connect(live_, &QPushButton::clicked, this, &InspectPlace::go_live);
  connect(video_, &QPushButton::clicked, this, &InspectPlace::choose_video);
  connect(folder_, &QPushButton::clicked, this, &InspectPlace::choose_folder);
  connect(&session_, &LiveSession::view_ready, this, &InspectPlace::follow_live);
  connect(&session_, &LiveSession::status_ready, this, &InspectPlace::follow_finger);
  connect(&inspection_, &Inspection::frame_ready, this, &InspectPlace::show_frame);
  connect(&inspection_, &Inspection::state_changed, this, &InspectPlace::show_state);
  connect(time_line_, &TimeLine::wanted, &inspection_, &Inspection::show_frame);
  connect(side_, &InspectSide::changed, this, &InspectPlace::change_options);
  connect(save_bar_, &SaveBar::wanted, this, &InspectPlace::choose_file);
  connect(save_bar_, &SaveBar::stop_wanted, &saving_, &BackgroundWork::stop);
  connect(&saving_, &BackgroundWork::progressed, this, &InspectPlace::show_saving);
  connect(&saving_, &BackgroundWork::finished, this, &InspectPlace::show_saving);
  for (InspectPane* pane : {first_, second_}) {
    InspectPane* other = pane == first_ ? second_ : first_;
    connect(pane, &InspectPane::clicked, this, &InspectPlace::set_point);
    connect(pane, &InspectPane::looked, other, [pane, other] { other->look_like(*pane); });
  }
}

void InspectPlace::name_parts() {
  live_->setText(tr("&Live finger"));
  video_->setText(tr("&Video…"));
  folder_->setText(tr("F&older of pictures…"));
  shown_->setAccessibleName(tr("What is shown"));
  summary_->setAccessibleName(tr("Deepest contact"));
  saved_->setAccessibleName(tr("What was saved"));
  show_frame();
}

void InspectPlace::change_options(const InspectOptions& options,
                                  const QString& what,
                                  int merge_id) {
  if (options == options_) return;
  undo_.push(new ValueChange<InspectOptions>(
      what,
      options_,
      options,
      [this](const InspectOptions& value) { set_options(value); },
      merge_id));
}

void InspectPlace::set_options(const InspectOptions& options) {
  options_ = options;
  inspection_.set_other(options.comparison == Comparison::kNone ? OtherMethod::kNone
                                                                : OtherMethod::kPaper);
  const bool is_beside = options.comparison == Comparison::kSideBySide;
  first_->set_content(options.comparison == Comparison::kDifference ? PaneContent::kDifference
                                                                    : PaneContent::kFirst);
  first_->set_title(is_beside ? tr("Ours")
                    : options.comparison == Comparison::kDifference
                        ? tr("Ours less the paper's method")
                        : QString());
  second_->set_title(tr("The paper's method"));
  second_->setVisible(is_beside);
  for (InspectPane* pane : {first_, second_}) pane->set_options(options);
  side_->set_options(options);
}

void InspectPlace::set_point(QPointF pixel, bool is_second) {
  InspectOptions next = options_;
  const cv::Point2d at(std::round(pixel.x()), std::round(pixel.y()));
  (is_second ? next.b : next.a) = at;
  change_options(next, is_second ? tr("put point B") : tr("put point A"), -1);
}

void InspectPlace::open(const std::filesystem::path& recording) {
  recording_ = recording;
  live_->setChecked(false);
  time_line_->play(false);
  follow_finger();
  inspection_.open(recording);
  show_frame();
}

void InspectPlace::go_live() {
  live_->setChecked(true);
  recording_.clear();
  time_line_->play(false);
  inspection_.open({});
  follow_live();
  show_frame();
}

void InspectPlace::follow_live() {
  const LiveStatus& status = session_.status();
  if (!recording_.empty() || !isVisible() || !session_.view() || !status.finger.finger) return;
  inspection_.show_live(session_.view(), *status.finger.finger);
}

void InspectPlace::follow_finger() {
  const FingerStatus& finger = session_.status().finger;
  if (finger.state != FingerState::kLoading) inspection_.set_finger(finger.folder);
  show_state();
}

void InspectPlace::show_frame() {
  const auto& frame = inspection_.frame();
  if (frame && frame->surface) {
    first_->show_frame(frame);
    second_->show_frame(frame);
  } else {
    for (InspectPane* pane : {first_, second_}) pane->show_message(why_nothing());
  }
  side_->show_frame(frame && frame->surface ? frame : nullptr);
  summary_->setText(frame && frame->surface ? deepest_text(*frame) : QString());
  show_state();
}

void InspectPlace::show_state() {
  const auto& recording = inspection_.recording();
  const bool is_recording = !recording_.empty();
  time_line_->setVisible(is_recording);
  if (recording) time_line_->set_recording(recording->count, recording->frames_per_s);
  if (const auto& frame = inspection_.frame(); frame && is_recording)
    time_line_->set_shown(frame->number, QString::fromStdString(frame->result.frame->name));
  const auto& shown = inspection_.frame();
  save_bar_->set_can_save(shown && shown->surface, is_recording && recording);
  shown_->setText(what_is_shown());
  std::vector<Problem> problems;
  const bool is_loading = session_.status().finger.state == FingerState::kLoading;
  if (inspection_.problem() && !is_loading) problems.push_back(Problem::of(*inspection_.problem()));
  problems_->set_problems(std::move(problems));
  if (!inspection_.frame())
    for (InspectPane* pane : {first_, second_}) pane->show_message(why_nothing());
}

QString InspectPlace::what_is_shown() const {
  return recording_.empty() ? tr("Shown: the live finger")
                            : tr("Shown: %1").arg(text_of(recording_.filename()));
}

QString InspectPlace::why_nothing() const {
  const auto& frame = inspection_.frame();
  if (frame && !frame->is_calibrated)
    return tr("The finger is not calibrated yet, so brightness cannot be told as depth.");
  if (frame && !frame->result.problems.empty())
    return window_sentence(frame->result.problems.front());
  if (frame) return tr("The face was not found in this picture.");
  if (session_.status().finger.state == FingerState::kLoading)
    return tr("The finger is being loaded.");
  if (inspection_.problem()) return tr("Nothing can be shown; above stands why.");
  if (!recording_.empty()) return tr("The recording is being opened.");
  const LiveStatus& status = session_.status();
  if (status.source.state == SourceState::kClosed)
    return tr("No source is open. Choose one above, or open a recording.");
  if (!status.finger.finger) return tr("No finger is open. Open the one that is seen, above.");
  return tr("Waiting for the first picture.");
}

void InspectPlace::choose_video() {
  auto* dialog =
      new QFileDialog(this, tr("Open a video"), QString(), tr("Videos (*.mkv *.avi *.mp4)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    open(file.toStdString());
  });
  dialog->show();
}

void InspectPlace::choose_folder() {
  auto* dialog = new QFileDialog(this, tr("Open a folder of pictures"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
    open(folder.toStdString());
  });
  dialog->show();
}

void InspectPlace::choose_file(const QString& ending) {
  auto* dialog = new QFileDialog(this, tr("Save what is shown"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(ending);
  dialog->setNameFilter(QStringLiteral("*.") + ending);
  if (const auto& frame = inspection_.frame())
    dialog->selectFile(QString::fromStdString(frame->result.frame->name) + QLatin1Char('.') +
                       ending);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    save(file.toStdString());
  });
  dialog->show();
}

void InspectPlace::save(const std::filesystem::path& file) {
  const auto frame = inspection_.frame();
  if (!frame || saving_.is_running()) return;
  saved_->clear();
  BackgroundWork::Work work;
  const auto ended = [this, file](const Status& status) {
    return [this, file, status] { end_saving(status, file); };
  };
  if (file.extension() == ".png") {
    const QImage picture = first_->picture().convertToFormat(QImage::Format_BGR888);
    work = [=](const Job&) {
      const cv::Mat pixels(picture.height(),
                           picture.width(),
                           CV_8UC3,
                           const_cast<uchar*>(picture.constBits()),
                           static_cast<std::size_t>(picture.bytesPerLine()));
      return ended(write_picture(file, pixels));
    };
  } else if (file.extension() == ".mkv") {
    FilmOptions film;
    film.finger = session_.status().finger.folder;
    film.input = recording_;
    film.view = options_;
    film.colours = scene_colours(palette());
    if (first_->face_view() != nullptr) film.look = first_->face_view()->scene().look();
    work = [=](const Job& job) { return ended(save_film(film, file, job)); };
  } else {
    work = [=](const Job&) { return ended(save_surface(*frame, file)); };
  }
  saving_.start(std::move(work));
  show_saving();
}

void InspectPlace::show_saving() {
  save_bar_->show_progress(saving_.is_running() ? std::optional(saving_.fraction()) : std::nullopt);
}

void InspectPlace::end_saving(const Status& status, const std::filesystem::path& file) {
  saved_->setText(status ? tr("Saved: %1").arg(text_of(file))
                         : window_sentence(status.error().sentence()));
  saved_->setToolTip(saved_->text());
}

void InspectPlace::showEvent(QShowEvent* event) {
  Translated::showEvent(event);
  follow_live();
}

}  // namespace alltact
