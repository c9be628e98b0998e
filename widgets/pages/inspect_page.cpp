#include "widgets/pages/inspect_page.h"

#include "core/base/atomic_file.h"
#include "widgets/inspect/finger_pair.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/inspect/inspection_results.h"
#include "widgets/inspect/point_readings.h"
#include "widgets/inspect/recordings_dialog.h"
#include "widgets/language.h"
#include "widgets/live/touch_history.h"
#include "widgets/panels/force_box.h"
#include "widgets/shell/force_dialog.h"
#include "widgets/shell/page.h"
#include "widgets/theme.h"
#include "widgets/undo_step.h"
#include "widgets/widget_base.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <cmath>

namespace alltact {
namespace {

constexpr int kInspectSideWidth = 296;
constexpr int kHeaderSpacing_px = 5;              // five buttons and a text in a window of 1024 px
constexpr int kFirstTurn = 21000, kTurns = 1000;  // merge ids
// Steps of wheel and keys within this time are one undo step.
constexpr int kOneTurn_ms = 700;

}  // namespace

InspectPage::InspectPage(LiveSession& session, QUndoStack& undo, QWidget* parent)
    : Page("inspect", parent),
      session_(session),
      undo_(undo),
      pair_(inspection_),
      live_(new QPushButton),
      recordings_(new QPushButton),
      video_(new QPushButton),
      folder_(new QPushButton),
      save_bar_(new SaveBar),
      shown_(new ElidedLabel(Qt::ElideMiddle)),
      summary_(new QLabel),
      saved_(new ElidedLabel(Qt::ElideMiddle)),
      probe_(new ElidedLabel),
      first_(new InspectPane(PaneContent::kFirst)),
      second_(new InspectPane(PaneContent::kSecond)),
      time_line_(new TimeLine),
      side_(new InspectSide),
      pair_box_(new PairBox(pair_)),
      contact_(new ContactBox),
      force_(new ForceBox([this] { return shown_force(); })) {
  auto* image = new QWidget;
  auto* column = without_margins(new QVBoxLayout(image));
  column->setSpacing(3);
  column->addWidget(make_header());
  auto* panes = new QHBoxLayout;
  panes->addWidget(first_, 1);
  panes->addWidget(second_, 1);
  column->addLayout(panes, 1);
  auto* words = new QHBoxLayout;
  words->addWidget(summary_);
  words->addWidget(probe_, 1);
  column->addLayout(words);
  column->addWidget(time_line_);
  without_margins(new QHBoxLayout(this))
      ->addWidget(make_side().next_to(image, QStringLiteral("inspect")));
  second_->hide();
  time_line_->hide();
  connect_parts();
  connect_panes();
  connect_pair();
  if (!VtkView::is_supported()) options_.shown_as = ShownAs::kHeightMap;
  say([this] { name_parts(); });
  set_options(options_);
}

QWidget* InspectPage::make_header() {
  auto* header = new QWidget;
  auto* row = without_margins(new QHBoxLayout(header));
  row->setSpacing(kHeaderSpacing_px);
  live_->setCheckable(true);
  live_->setChecked(true);
  add_widgets(*row, {live_, recordings_, video_, folder_, pair_box_->open_button()});
  shown_->setMinimumWidth(1);
  row->addWidget(shown_, 1);
  saved_->setMinimumWidth(1);
  saved_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  saved_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return header;
}

SidePanel InspectPage::make_side() {
  const SidePanel panel(kInspectSideWidth);
  add_widgets(*panel.column, {pair_box_, contact_, force_, side_});
  panel.foot->addWidget(saved_);
  panel.foot->addWidget(save_bar_);
  return panel;
}

void InspectPage::connect_parts() {
  connect(live_, &QPushButton::clicked, this, &InspectPage::go_live);
  connect(recordings_, &QPushButton::clicked, this, &InspectPage::choose_recording);
  connect(video_, &QPushButton::clicked, this, [this] {
    ask_for_file(this, FilesOf::kRecordings, tr("Open a video"), video_filter(),
                 [this](const QString& file) { open(file.toStdString()); });
  });
  connect(folder_, &QPushButton::clicked, this, [this] {
    ask_for_folder(this, FilesOf::kRecordings, tr("Open a folder of images"),
                   [this](const QString& folder) { open(folder.toStdString()); });
  });
  connect(&session_, &LiveSession::view_ready, this, &InspectPage::follow_live);
  connect(&session_, &LiveSession::status_ready, this, &InspectPage::follow_finger);
  connect(&inspection_, &Inspection::frame_ready, this, &InspectPage::show_frame);
  connect(&inspection_, &Inspection::state_changed, this, &InspectPage::show_state);
  constexpr int kSummaryInterval_ms = 200;
  summaries_timer_.setSingleShot(true);
  summaries_timer_.setInterval(kSummaryInterval_ms);
  connect(&summaries_timer_, &QTimer::timeout, this, [this] {
    const auto& recording = inspection_.recording();
    if (recording) time_line_->set_recording(recording->count, recording->frames_per_s);
    time_line_->set_summaries(inspection_.summaries());
  });
  connect(&inspection_, &Inspection::summaries_changed, this, [this] {
    if (!summaries_timer_.isActive()) summaries_timer_.start();
  });
  connect(time_line_, &TimeLine::frame_requested, &inspection_, &Inspection::show_frame);
  connect(side_, &InspectSide::changed, this, &InspectPage::change_options);
  connect(side_, &InspectSide::run_requested, this, &InspectPage::inspect_all);
  connect(side_, &InspectSide::run_in_folder_requested, this, [this] {
    ask_for_folder(this, FilesOf::kRecordings, tr("Folder of recordings"),
                   [this](const QString& folder) { inspect_folder(folder.toStdString()); });
  });
  connect(force_, &ForceBox::zero_requested, this,
          [this](const ForceZero& zero) { take_zero(session_, undo_, zero); });
  connect(force_, &ForceBox::no_zero_requested, this, [this] { drop_zero(session_, undo_); });
  connect(force_, &ForceBox::training_requested, this,
          [this] { open_force_training(session_, undo_, *this); });
  connect(&session_, &LiveSession::status_ready, force_, &ForceBox::schedule_update);
  connect(save_bar_, &SaveBar::save_requested, this, &InspectPage::choose_file);
  connect(save_bar_, &SaveBar::stop_requested, &saving_, &BackgroundWork::stop);
  connect(&saving_, &BackgroundWork::progressed, this, &InspectPage::show_saving);
  connect(&saving_, &BackgroundWork::finished, this, &InspectPage::show_saving);
}

void InspectPage::connect_panes() {
  connect(first_, &InspectPane::clicked, this, &InspectPage::set_point);
  connect(second_, &InspectPane::clicked, this, [this](QPointF pixel, bool is_second) {
    if (!options_.second) set_point(pixel, is_second);  // points lie on the first finger
  });
  for (InspectPane* pane : {first_, second_}) {
    InspectPane* other = pane == first_ ? second_ : first_;
    connect(pane, &InspectPane::pointed_at, this, [this](const std::optional<QPointF>& pixel) {
      pointed_at_ = pixel;
      show_probe();
    });
    connect(pane, &InspectPane::view_changed, other, [pane, other] { other->copy_look(*pane); });
    connect(pane, &InspectPane::view_settled, this,
            [this, pane](bool is_drag) { store_look(*pane, is_drag); });
    connect(pane, &InspectPane::reset_requested, this, [this] {
      InspectOptions next = options_;
      next.view_pose.reset();
      change_options(
          next, [] { return tr("show all again"); }, -1);
    });
  }
}

void InspectPage::name_parts() {
  live_->setText(tr("&Live finger"));
  live_->setToolTip(tr("Shows the open source instead of a recording"));
  recordings_->setText(tr("Recordings…"));
  recordings_->setToolTip(tr("Lists the recordings in this finger's folder"));
  video_->setText(tr("Vide&o…"));
  video_->setToolTip(tr("Inspects a recorded video of this finger"));
  folder_->setText(tr("&Images…"));
  folder_->setToolTip(tr("Inspects a folder of images of this finger"));
  shown_->setAccessibleName(tr("What is shown"));
  summary_->setAccessibleName(tr("Deepest contact"));
  saved_->setAccessibleName(tr("What was saved"));
  probe_->setAccessibleName(tr("Under the pointer"));
  show_frame();
}

void InspectPage::change_options(const InspectOptions& options, const StepWords& what,
                                 int merge_id) {
  if (options == options_) return;
  undo_.push(new ValueChange<InspectOptions>(
      what, options_, options, [this](const InspectOptions& value) { set_options(value); },
      merge_id));
}

void InspectPage::set_options(const InspectOptions& options) {
  const InspectOptions before = std::exchange(options_, options);
  const Comparison comparison = options.shown_comparison();
  inspection_.set_other(options.comparand());
  first_->set_content(comparison == Comparison::kDifference ? PaneContent::kDifference
                                                            : PaneContent::kFirst);
  second_->set_content(options.second ? PaneContent::kFirst : PaneContent::kSecond);
  first_->set_options(options);
  InspectOptions others = options;
  if (options.second) others.a = others.b = std::nullopt;  // on the first finger only
  second_->set_options(others);
  side_->set_options(options);
  if (options.recording != before.recording) show_recording();
  pair_.open(options.second);
  show_frame();
  Q_EMIT changed();
}

/// Each drag is an undo step; quick steps of the wheel or of keys are merged into one.
void InspectPage::store_look(const InspectPane& pane, bool is_drag) {
  if (is_drag || !since_turn_.isValid() || since_turn_.elapsed() > kOneTurn_ms) ++turns_;
  if (is_drag)
    since_turn_.invalidate();
  else
    since_turn_.start();
  InspectOptions next = options_;
  next.view_pose = pane.face_pane()->scene().view_pose();
  change_options(
      next, [] { return tr("turn the 3D view"); }, is_drag ? -1 : kFirstTurn + turns_ % kTurns);
}

void InspectPage::set_point(QPointF pixel, bool is_second) {
  if (!inspection_.frame()) return;
  const auto position = position_of(*inspection_.frame(), nearest_pixel({pixel.x(), pixel.y()}));
  if (!position) return;
  InspectOptions next = options_;
  (is_second ? next.b : next.a) = position;
  change_options(
      next, [is_second] { return is_second ? tr("set point B") : tr("set point A"); }, -1);
}

/// The points do not apply to another finger.
void InspectPage::drop_points() {
  if (!options_.a && !options_.b) return;
  InspectOptions next = options_;
  next.a.reset();
  next.b.reset();
  set_options(next);
}

void InspectPage::open(const std::filesystem::path& recording) {
  if (recording == options_.recording) return show_recording();
  InspectOptions next = options_;
  next.recording = recording;
  change_options(
      next, [recording] { return tr("inspect %1").arg(text_of(recording.filename())); }, -1);
}

void InspectPage::choose_recording() {
  auto* dialog = new RecordingsDialog(session_.status().finger.folder, this);
  connect(dialog, &RecordingsDialog::chosen, this, &InspectPage::open);
  show_dialog(*dialog);
}

bool InspectPage::take_files(const DroppedFiles& dropped) {
  const auto& first = dropped.files.front();
  if (dropped.kind == FileKind::kRecipe) {
    side_->open_recipe(first);
    return true;
  }
  if (dropped.kind == FileKind::kMesh) {
    InspectOptions next = options_;
    next.with.method = OtherMethod::kBody;
    next.with.file = first;
    if (next.comparison == Comparison::kNone) next.comparison = Comparison::kDifference;
    change_options(
        next, [first] { return tr("compare with the body %1").arg(text_of(first.filename())); },
        -1);
    return true;
  }
  const bool is_recording = dropped.kind == FileKind::kFolder || dropped.kind == FileKind::kVideo;
  if (is_recording) open(first);
  return is_recording;
}

void InspectPage::restore(const InspectOptions& options, std::size_t frame) {
  last_frame_[options.recording] = frame;
  InspectOptions next = options;
  if (!VtkView::is_supported()) next.shown_as = ShownAs::kHeightMap;
  change_options(
      next, [] { return tr("continue the last inspection"); }, -1);
}

std::size_t InspectPage::frame_number() const {
  const auto at = last_frame_.find(options_.recording);
  return options_.recording.empty() || at == last_frame_.end() ? 0 : at->second;
}

void InspectPage::show_recording() {
  live_->setChecked(options_.recording.empty());
  opened_with_ = session_.status().finger.folder;
  time_line_->begin(frame_number());
  follow_finger();
  inspection_.open(options_.recording, frame_number());
  if (options_.recording.empty()) follow_live();
  show_frame();
}

void InspectPage::go_live() {
  live_->setChecked(true);
  if (options_.recording.empty()) return;
  InspectOptions next = options_;
  next.recording.clear();
  if (next.second) next.view_pose.reset();
  next.second.reset();
  change_options(
      next, [] { return tr("inspect the live finger"); }, -1);
}

void InspectPage::follow_live() {
  const LiveStatus& status = session_.status();
  if (!options_.recording.empty() || !isVisible() || !session_.view() || !status.finger.finger)
    return;
  inspection_.show_live(session_.view(), *status.finger.finger);
}

void InspectPage::follow_finger() {
  const FingerStatus& finger = session_.status().finger;
  if (!finger.folder.empty()) {
    if (!points_finger_.empty() && points_finger_ != finger.folder) drop_points();
    points_finger_ = finger.folder;
    if (opened_with_.empty()) opened_with_ = finger.folder;
  }
  if (finger.state != FingerState::kLoading) {
    inspection_.set_finger(finger.folder);
    pair_.set_first(finger.folder);
  }
  show_state();
}

void InspectPage::showEvent(QShowEvent* event) {
  Translated::showEvent(event);
  inspection_.set_scanning(true);
  follow_live();
}

void InspectPage::hideEvent(QHideEvent* event) {
  inspection_.set_scanning(false);
  Translated::hideEvent(event);
}

// Contact and force in the page Inspect.

namespace {

double recorded_s(const RecordingInfo& recording, std::size_t number) {
  if (recording.times_ns && number < recording.times_ns->size())
    return 1e-9 * static_cast<double>((*recording.times_ns)[number]);
  return static_cast<double>(number) / std::max(recording.frames_per_s, 1e-3);
}

}  // namespace

const TouchHistory& InspectPage::touch_history() const {
  return options_.recording.empty() ? session_.touch_history() : played_;
}

void InspectPage::follow_contact() {
  const auto& frame = inspection_.frame();
  const auto& recording = inspection_.recording();
  if (!frame || options_.recording.empty() || !recording) {
    played_.forget();
    last_played_.reset();
  } else if (frame != last_played_) {
    if (last_played_ && frame->number != last_played_->number + 1) played_.forget();
    played_.add(frame->result, recorded_s(*recording, frame->number));
    last_played_ = frame;
  }
  contact_->show_contact(frame ? &frame->result : nullptr, touch_history());
  force_->schedule_update();
}

ShownForce InspectPage::shown_force() const {
  ShownForce shown;
  shown.is_live = options_.recording.empty();
  if (const auto& frame = inspection_.frame()) shown.now = frame->result.force;
  shown.history = &touch_history();
  if (shown.is_live) shown.zero = session_.force_zero();
  shown.why_none = no_force_reason(session_.status().finger);
  shown.has_model = has_force_model(session_.status().finger);
  shown.can_train = can_train_force(session_.status().finger);
  return shown;
}

void InspectPage::inspect_all() {
  InspectionOrder order;
  order.finger = session_.status().finger.folder;
  order.inputs = {options_.recording};
  order.recipe = options_.recipe;
  auto* results = new InspectionResults(std::move(order), this);
  connect(results, &InspectionResults::frame_requested, this,
          [this, recording = options_.recording](std::size_t number) {
            if (options_.recording == recording) inspection_.show_frame(number);
          });
  show_dialog(*results);
}

void InspectPage::inspect_folder(const std::filesystem::path& folder) {
  InspectionOrder order;
  order.finger = session_.status().finger.folder;
  order.inputs = {folder};
  order.recipe = options_.recipe;
  show_dialog(*new RecordingsInspection(std::move(order), this));
}

// Opening and saving files in the page Inspect.

void InspectPage::choose_file(const QString& ending) {
  const auto& frame = inspection_.frame();
  const QString name =
      frame ? QString::fromStdString(frame->result.frame->name) + QLatin1Char('.') + ending
            : QString();
  ask_where_to_save(this, FilesOf::kExports, tr("Save what is shown"), ending, name,
                    [this](const QString& file) { save(file.toStdString()); });
}

void InspectPage::save(const std::filesystem::path& file) {
  if (!inspection_.frame() || saving_.is_running()) return;
  saved_->clear();
  const std::string ending = file.extension().string();
  if (ending == ".pdf" || ending == ".svg" || ending == ".csv")
    return end_saving(save_section(file), {file});
  saving_.start(saving_work(file));
  show_saving();
}

CanSave InspectPage::can_save() const {
  const auto& frame = inspection_.frame();
  CanSave can;
  can.surface = frame && frame->surface;
  can.image = frame && (frame->surface || frame->bare);
  can.section = !side_->section().is_empty();
  can.film = can.image && (options_.recording.empty() || inspection_.recording());
  return can;
}

/// The cross-section as shown, for a paper: on white, whatever the theme.
Status InspectPage::save_section(const std::filesystem::path& file) {
  SectionPlot& section = side_->section();
  if (section.is_empty())
    return Error{en::say("there is no cross-section"), file.string(),
                 en::say("two points, A and B")};
  if (file.extension() == ".csv") return write_file_atomically(file, section.csv().toStdString());
  const QPalette before = section.palette();
  section.setPalette(theme_palette(Theme::kLight));
  const QSize size(560, 320);
  const Status status =
      write_file_atomically(file, [&](const std::filesystem::path& temporary) -> Status {
        const QString name = text_of(temporary);
        if (file.extension() == ".pdf" ? section.save_pdf(name, size)
                                       : section.save_svg(name, size))
          return {};
        return Error{en::say("the figure cannot be written"), file.string(),
                     en::say("another folder, or freeing some space")};
      });
  section.setPalette(before);
  return status;
}

FilmView InspectPage::film_view() const {
  FilmView view;
  view.options = options_;
  view.colours = scene_colours(palette());
  if (first_->face_pane() != nullptr)
    view.options.view_pose = first_->face_pane()->scene().view_pose();
  return view;
}

FramePair InspectPage::film_moment() const {
  FramePair moment = pair_.frames().value_or(
      FramePair{inspection_.frame(), options_.second ? pair_.second().frame() : nullptr});
  if (first_->face_pane() != nullptr) moment.view_pose = first_->face_pane()->scene().view_pose();
  return moment;
}

BackgroundWork::Work InspectPage::image_work(const std::filesystem::path& file) {
  const auto ended = [this, file](const Status& status) {
    return [this, file, status] { end_saving(status, {file}); };
  };
  const QSize pane = first_->image_size();
  if (first_->is_3d()) {
    FilmView view = film_view();
    const int panes = second_->isVisible() ? 2 : 1;
    view.size_px = cv::Size(panes * pane.width(), pane.height());
    return [=, moment = film_moment()](const Job&) {
      return ended(save_paper_figure(moment, view, file));
    };
  }
  const QImage image = first_->map_image(kPaperWidth_px / std::max(1, pane.width()));
  return [=](const Job&) {
    const cv::Mat pixels(image.height(), image.width(), CV_8UC3,
                         const_cast<uchar*>(image.constBits()),
                         static_cast<std::size_t>(image.bytesPerLine()));
    return ended(write_paper_figure(file, pixels));
  };
}

BackgroundWork::Work InspectPage::film_work(const std::filesystem::path& file) {
  if (options_.recording.empty()) {
    live_film_ = std::make_shared<FilmQueue>();
    live_film_->add(film_moment());
    return [this, file, queue = live_film_, view = film_view()](const Job& job) {
      const Status status = save_live_film(*queue, view, file, job);
      return std::function<void()>([this, file, status] {
        live_film_.reset();
        end_saving(status, {file});
      });
    };
  }
  return [this, finger = session_.status().finger.folder, view = film_view(),
          poses = film_moment().poses, file](const Job& job) {
    const Status status = save_film(finger, view, poses, file, job);
    return std::function<void()>([this, file, status] { end_saving(status, {file}); });
  };
}

BackgroundWork::Work InspectPage::saving_work(const std::filesystem::path& file) {
  if (file.extension() == ".png") return image_work(file);
  if (file.extension() == ".mkv") return film_work(file);
  const auto ended = [this](const Status& status, const std::vector<std::filesystem::path>& files) {
    return [this, status, files] { end_saving(status, files); };
  };
  if (const auto frames = pair_.frames(); frames && frames->poses)
    return [=](const Job&) { return ended(save_both(*frames, file), files_of_both(file)); };
  const auto frame = inspection_.frame();
  return [=](const Job&) { return ended(save_surface(*frame, file), {file}); };
}

void InspectPage::show_saving() {
  const double fraction = live_film_ ? -1.0 : saving_.fraction();  // its length is unknown
  save_bar_->show_progress(saving_.is_running() ? std::optional(fraction) : std::nullopt);
}

void InspectPage::end_saving(const Status& status,
                             const std::vector<std::filesystem::path>& files) {
  QStringList names;
  for (const auto& file : files) names << text_of(file);
  saved_->setText(status ? tr("Saved: %1").arg(listed(names))
                         : window_sentence(status.error().message()));
  saved_->setToolTip(saved_->text());
}

// The second finger in the page Inspect.

void InspectPage::connect_pair() {
  connect(&pair_, &FingerPair::changed, this, [this] {
    if (options_.second) show_frame();
  });
  connect(pair_box_, &PairBox::open_requested, this, &InspectPage::choose_second);
  connect(pair_box_, &PairBox::close_requested, this, [this] { open_second(std::nullopt); });
  connect(pair_box_, &PairBox::pose_requested, this, &InspectPage::choose_pose);
}

void InspectPage::choose_second() {
  auto* dialog = new SecondFingerDialog(options_.second, this);
  connect(dialog, &SecondFingerDialog::chosen, this,
          [this](const SecondFinger& second) { open_second(second); });
  show_dialog(*dialog);
}

void InspectPage::choose_pose(bool is_second) {
  const FingerMount* known = pair_.mount(is_second);
  if (known == nullptr) return;
  const std::filesystem::path folder = pair_.folder(is_second);
  using Pose = std::optional<RigidTransform>;
  const Pose now = known->gripper_from_camera;
  auto* dialog = new GripperDialog(pair_.name(is_second), now, this);
  connect(dialog, &GripperDialog::chosen, this, [this, folder, now](const Pose& chosen) {
    if (chosen == now) return;
    undo_.push(new ValueChange<Pose>(
        [folder] { return tr("pose of %1 in the gripper").arg(text_of(folder.filename())); }, now,
        chosen, [this, folder](const Pose& requested) { pair_.set_pose(folder, requested); }));
  });
  show_dialog(*dialog);
}

/// Both fingers are drawn in one 3D view: their gripper poses are known.
bool InspectPage::is_joint_view() const {
  return pair_.has_both_poses() && options_.shown_as == ShownAs::k3d && VtkView::is_supported();
}

void InspectPage::show_second() {
  const auto& frame = pair_.second().frame();
  if (frame && frame->surface) return second_->show_frames({frame});
  second_->show_message(frame ? tr("The face was not found in this image.")
                        : pair_.second().problem()
                            ? tr("Nothing can be shown; the reason is above.")
                            : tr("The recording is being opened."));
}

void InspectPage::add_pair_problems(std::vector<Problem>& problems) {
  if (const auto problem = pair_.problem()) problems.push_back(Problem::of(*problem));
  if (!options_.second) return;
  if (pair_.second().problem()) problems.push_back(Problem::of(*pair_.second().problem()));
  for (const bool is_second : {false, true}) {
    const FingerMount* mount = pair_.mount(is_second);
    if (mount == nullptr || mount->gripper_from_camera) continue;
    problems.push_back({Meaning::kDoubtful,
                        tr("The camera pose of %1 in the gripper is not known, so each finger is "
                           "shown in its own camera's frame.")
                            .arg(pair_.name(is_second)),
                        tr("Enter its position and rotation."),
                        is_second ? tr("Pose of &2…") : tr("Pose of &1…"),
                        [this, is_second] { choose_pose(is_second); }});
  }
}

void InspectPage::open_second(const std::optional<SecondFinger>& second) {
  InspectOptions next = options_;
  next.second = second;
  next.view_pose.reset();  // the frame of reference changes
  change_options(
      next,
      [opens = second.has_value()] {
        return opens ? tr("show a second finger") : tr("close the second finger");
      },
      -1);
}

// Views and texts of the page Inspect for a frame, and without one.

void InspectPage::show_frame() {
  const auto& frame = inspection_.frame();
  if (frame && !options_.recording.empty()) {
    last_frame_[options_.recording] = frame->number;
    if (!time_line_->is_playing()) Q_EMIT changed();
  }
  pair_.follow();
  show_panes();
  side_->show_frame(frame && frame->surface ? frame : nullptr);
  follow_contact();
  summary_->setText(summary_text());
  show_probe();
  if (live_film_) live_film_->add(film_moment());
  show_state();
}

QString InspectPage::summary_text() const {
  const auto text = [](const std::shared_ptr<const InspectedFrame>& frame) {
    return frame && frame->surface ? deepest_text(*frame) : QString();
  };
  const QString first = text(inspection_.frame());
  if (!options_.second) return first;
  return QStringLiteral("1: ") + first + QStringLiteral("   2: ") + text(pair_.second().frame());
}

QString InspectPage::title_of(bool is_second) const {
  if (!options_.second) {
    QString other = comparand_text(options_.with);
    if (const auto& frame = inspection_.frame(); frame && frame->body_rms_mm)
      other = tr("%1, %2 mm rms off").arg(other, plain_number(*frame->body_rms_mm, 3));
    if (is_second) return tr("Compared with: %1").arg(other);
    const Comparison comparison = options_.shown_comparison();
    const bool is_distance =
        comparison == Comparison::kDifference && options_.with.method == OtherMethod::kBody;
    if (is_distance) return tr("Distance of the skin from: %1").arg(other);
    return comparison == Comparison::kSideBySide   ? tr("Shown")
           : comparison == Comparison::kDifference ? tr("Shown minus: %1").arg(other)
           : inspection_.frame() && inspection_.frame()->bare
               ? tr("Not calibrated yet: the shape of the entire finger, without depth")
               : QString();
  }
  if (is_joint_view())
    return tr("1: %1, 2: %2, in the gripper's frame X, Y, Z")
        .arg(pair_.name(false), pair_.name(true));
  return (is_second ? QStringLiteral("2: ") : QStringLiteral("1: ")) + pair_.name(is_second);
}

void InspectPage::show_panes() {
  const auto& frame = inspection_.frame();
  const bool has_face = frame && frame->surface;
  const auto both = is_joint_view() ? pair_.frames() : std::nullopt;
  first_->set_title(title_of(false));
  second_->set_title(title_of(true));
  if (both)
    first_->show_frames(*both);
  else if (has_face || (frame && frame->bare))
    first_->show_frames({frame});
  else
    first_->show_message(empty_reason());
  second_->setVisible(options_.second ? !both : options_.comparison == Comparison::kSideBySide);
  if (options_.second)
    show_second();
  else if (has_face)
    second_->show_frames({frame});
  else
    second_->show_message(empty_reason());
}

void InspectPage::show_state() {
  const auto& recording = inspection_.recording();
  const bool is_recording = !options_.recording.empty();
  time_line_->setVisible(is_recording);
  if (recording) time_line_->set_recording(recording->count, recording->frames_per_s);
  if (const auto& frame = inspection_.frame(); frame && is_recording)
    time_line_->set_shown(frame->number, QString::fromStdString(frame->result.frame->name));
  side_->set_frame_count(is_recording && recording ? recording->count : 0);
  recordings_->setEnabled(!session_.status().finger.folder.empty());
  save_bar_->set_can_save(can_save());
  shown_->setText(shown_text());
  Q_EMIT problems_changed();
  pair_box_->show_pair(is_recording);
  if (!inspection_.frame()) first_->show_message(empty_reason());
  if (!inspection_.frame() && !options_.second) second_->show_message(empty_reason());
}

/// A recording of one finger measured as another gives depths that are not those of its contacts.
void InspectPage::add_other_finger(std::vector<Problem>& problems) {
  const auto& folder = session_.status().finger.folder;
  if (options_.recording.empty() || folder.empty() || folder == opened_with_) return;
  problems.push_back({Meaning::kDoubtful,
                      tr("The recording was opened with the finger in %1. It is measured with the "
                         "finger in %2 now.")
                          .arg(text_of(opened_with_), text_of(folder)),
                      {},
                      tr("&Close the recording"),
                      [this] { go_live(); }});
}

void InspectPage::add_problems(std::vector<Problem>& problems) {
  if (!isVisible()) return;
  const bool is_loading = session_.status().finger.state == FingerState::kLoading;
  if (inspection_.problem() && !is_loading) problems.push_back(Problem::of(*inspection_.problem()));
  add_other_finger(problems);
  add_pair_problems(problems);
}

QString InspectPage::shown_text() const {
  return options_.recording.empty() ? tr("Shown: the live finger")
                                    : tr("Shown: %1").arg(text_of(options_.recording.filename()));
}

QString InspectPage::empty_reason() const {
  const auto& frame = inspection_.frame();
  if (frame && !frame->is_calibrated)
    return tr("The finger is not calibrated yet, so brightness gives no depth.");
  if (frame && !frame->result.problems.empty())
    return window_sentence(frame->result.problems.front());
  if (frame) return tr("The face was not found in this image.");
  if (session_.status().finger.state == FingerState::kLoading)
    return tr("The finger is being loaded.");
  if (inspection_.problem()) return tr("Nothing can be shown; the reason is above.");
  if (!options_.recording.empty()) return tr("The recording is being opened.");
  const LiveStatus& status = session_.status();
  if (status.source.state == SourceState::kClosed)
    return tr("No source is open. Choose one above, or open a recording.");
  if (!status.finger.finger) return tr("No finger is open. Open the visible finger above.");
  return tr("Waiting for the first image.");
}

void InspectPage::show_probe() {
  const auto& frame = inspection_.frame();
  const bool is_measured = pointed_at_ && frame && (frame->surface || frame->bare);
  const auto text = is_measured
                        ? probe_text(*frame, nearest_pixel({pointed_at_->x(), pointed_at_->y()}))
                        : std::nullopt;
  static_cast<ElidedLabel*>(probe_)->set_text(
      text ? joined_clauses({text->depth, text->position})
           : tr("Point at the face to see its values here."));
  for (InspectPane* pane : {first_, second_})
    pane->show_at_pointer(
        text && pane->underMouse() ? text->depth + QLatin1Char('\n') + text->position : QString());
}

}  // namespace alltact
