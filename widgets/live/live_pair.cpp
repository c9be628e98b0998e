#include "widgets/live/live_pair.h"

#include "widgets/language.h"
#include "widgets/live/touch_history.h"
#include "widgets/widget_base.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace alltact {

LivePair::LivePair(LiveSession& first, QObject* parent) : QObject(parent), first_(first) {
  connect(&first_, &LiveSession::view_ready, this, [this] { add(0); });
  for (BackgroundWork* work : {&loading_, &measuring_})
    connect(work, &BackgroundWork::finished, this, [this] {
      measure();
      Q_EMIT changed();
    });
}

void LivePair::open(const std::optional<SecondCamera>& second) {
  if (opened_ == second) return;
  const std::optional<SecondCamera> before = std::exchange(opened_, second);
  reading_.reset();
  reading_problem_.reset();
  request_.reset();
  const bool is_other =
      !before || !second || before->finger != second->finger || before->source != second->source;
  if (is_other) {
    pairing_.forget();
    pair_.reset();
  }
  if (!second_ && second) {
    second_ = std::make_unique<LiveSession>(first_.opener());
    connect(second_.get(), &LiveSession::view_ready, this, [this] { add(1); });
    connect(second_.get(), &LiveSession::status_ready, this, &LivePair::changed);
  }
  if (is_other && second_) {
    second_->set_lock(true);  // brightness is the measured quantity
    second_->open_finger(second ? second->finger : std::filesystem::path());
    if (second)
      second_->open_source(second->source);
    else
      second_->close_source();
  }
  load_gripper();
  measure();
  Q_EMIT changed();
}

void LivePair::add(std::size_t which) {
  if (!opened_ || !second_) return;
  const LiveSession& session = which == 0 ? first_ : *second_;
  auto shown = pairing_.add(which, session.view(), session.view_ns());
  if (!shown) return;
  pair_ = std::move(*shown);
  Q_EMIT pair_ready();
  measure();
}

void LivePair::load_gripper() {
  const std::filesystem::path requested = opened_ ? opened_->gripper : std::filesystem::path();
  if (requested == gripper_of_) return;
  gripper_.reset();
  gripper_problem_.reset();
  gripper_of_ = requested;
  if (requested.empty()) return loading_.stop();
  loading_.restart([this, requested](const Job&) {
    auto loaded = OpenGripper::load(requested);
    return std::function<void()>([this, requested, loaded = std::move(loaded)] {
      if (requested != gripper_of_) return;
      if (loaded)
        gripper_ = std::make_shared<const OpenGripper>(*loaded);
      else
        gripper_problem_ = loaded.error();
    });
  });
}

std::optional<double> LivePair::motor_turns() const {
  if (!gripper_ || !opened_) return std::nullopt;
  const GripperMotor& motor = gripper_->gripper.motor;
  return opened_->motor_turns.value_or(0.5 * (motor.first_turns + motor.last_turns));
}

void LivePair::measure() {
  const auto turns = motor_turns();
  if (!turns || !pair_ || !pair_->is_in_time || measuring_.is_running()) return;
  const Request request{pair_->views, *turns};
  if (request_ == request) return;
  const auto &own = first_.status().finger, &other = second_->status().finger;
  if (!own.finger || !other.finger) return;
  const std::array<PairedFinger, 2> fingers{
      {{own.folder, own.finger->face}, {other.folder, other.finger->face}}};
  request_ = request;
  measuring_.start([this, gripper = gripper_, turns = *turns, pair = *pair_, fingers](const Job&) {
    auto reading = read_pair(*gripper, turns, pair, fingers);
    return std::function<void()>([this, reading = std::move(reading)] { take(reading); });
  });
}

/// A reading requested before another finger was opened is dropped.
void LivePair::take(const Result<PairReading>& reading) {
  reading_problem_.reset();
  if (!reading) {
    reading_.reset();
    reading_problem_ = reading.error();
  } else if (motor_turns() == reading->motor_turns && pair_) {
    reading_ = *reading;
  }
}

std::optional<Error> LivePair::problem() const {
  if (!opened_ || !second_) return std::nullopt;
  const LiveStatus& status = second_->status();
  if (status.source.problem) return status.source.problem;
  if (status.finger.problem) return status.finger.problem;
  if (gripper_problem_) return gripper_problem_;
  return reading_problem_;
}

namespace fs = std::filesystem;

namespace {

fs::path canonical_folder(const fs::path& folder) {
  std::error_code ignored;
  const fs::path canonical = fs::weakly_canonical(folder, ignored);
  return canonical.has_filename() ? canonical : canonical.parent_path();  // "left/" is "left"
}

GapFace gap_face(const FrameResult& result, const Face& face) {
  GapFace gap;
  gap.points_mm = contact_face_points_mm(result, face);
  gap.z_sd_mm = [shape = *result.shape](double u) -> std::optional<double> {
    const int column = static_cast<int>(std::lround(u));
    if (column < 0 || column >= shape.width_px()) return std::nullopt;
    const FaceColumn& at = shape.columns()[static_cast<std::size_t>(column)];
    return at.valid ? std::optional(at.z_sd_mm) : std::nullopt;
  };
  return gap;
}

}  // namespace

Result<OpenGripper> OpenGripper::load(const fs::path& path) {
  auto gripper = Gripper::load(path);
  if (!gripper) return gripper.error();
  std::error_code ignored;
  const fs::path folder = fs::is_directory(path, ignored) ? path : path.parent_path();
  OpenGripper open{std::move(*gripper), {}};
  for (std::size_t i = 0; i < 2; ++i)
    open.folders[i] =
        canonical_folder(fs::absolute(folder, ignored) / open.gripper.fingers[i].folder);
  return open;
}

std::optional<std::array<std::size_t, 2>> OpenGripper::order_of(
    const std::array<fs::path, 2>& fingers) const {
  const std::array canonical{canonical_folder(fingers[0]), canonical_folder(fingers[1])};
  if (canonical[0] == folders[0] && canonical[1] == folders[1])
    return std::array<std::size_t, 2>{0, 1};
  if (canonical[0] == folders[1] && canonical[1] == folders[0])
    return std::array<std::size_t, 2>{1, 0};
  return std::nullopt;
}

Result<PairReading> read_pair(const OpenGripper& gripper, double motor_turns, const ViewPair& pair,
                              const std::array<PairedFinger, 2>& fingers) {
  const auto order = gripper.order_of({fingers[0].folder, fingers[1].folder});
  if (!order)
    return Error{en::say("the gripper's fingers are {} and {}, and others are open",
                         gripper.folders[0].string(), gripper.folders[1].string()),
                 "", en::say("opening these two fingers")};
  const auto pose = gripper.gripper.pose_at(motor_turns);
  if (!pose) return pose.error();
  PairReading reading{pair, motor_turns, {}, {}};
  std::array<const FrameResult*, 2> results{};  // in the gripper's order
  std::array<const Face*, 2> faces{};
  for (std::size_t i = 0; i < 2; ++i) {
    results[(*order)[i]] = &pair.views[i]->result;
    faces[(*order)[i]] = &fingers[i].face;
  }
  if (results[0]->depth && results[0]->shape && results[1]->depth && results[1]->shape)
    reading.gap =
        face_gap(*pose, {gap_face(*results[0], *faces[0]), gap_face(*results[1], *faces[1])});
  if (!results[0]->regions.empty() && !results[1]->regions.empty())
    reading.width = held_width(*pose, {observed_contact(results[0]->regions.front()),
                                       observed_contact(results[1]->regions.front())});
  return reading;
}

std::optional<ViewPair> ViewPairing::add(std::size_t which, std::shared_ptr<const LiveView> view,
                                         std::optional<std::int64_t> time_ns) {
  auto &own = views_[which], &other = views_[1 - which];
  if (!own.empty() && time_ns && own.back().time_ns && *time_ns < *own.back().time_ns)
    forget();  // another source, or a restarted one
  Timed now{std::move(view), time_ns};
  measure_period(which, now);
  own.push_back(std::move(now));
  if (own.size() > kMaxViews) own.pop_front();
  if (!waiting_since_ns_) waiting_since_ns_ = time_ns;
  if (other.empty()) return std::nullopt;
  const auto pair_with = [&](const Timed& partner) {
    ViewPair pair;
    pair.views[which] = own.back().view;
    pair.views[1 - which] = partner.view;
    return pair;
  };
  if (!time_ns || !other.back().time_ns) return pair_with(other.back());

  const Timed* nearest = nullptr;
  const auto offset_ns = [&](const Timed& timed) { return std::abs(*timed.time_ns - *time_ns); };
  for (const Timed& timed : other)
    if (timed.time_ns && (nearest == nullptr || offset_ns(timed) < offset_ns(*nearest)))
      nearest = &timed;
  ViewPair pair = pair_with(*nearest);
  std::array<std::int64_t, 2> times_ns{};
  times_ns[which] = *time_ns;
  times_ns[1 - which] = *nearest->time_ns;
  pair.later_ms = 1e-6 * static_cast<double>(times_ns[1] - times_ns[0]);
  pair.is_in_time = static_cast<double>(offset_ns(*nearest)) <=
                    0.5e6 * std::max(period_ms_[0].value_or(0.0), period_ms_[1].value_or(0.0));
  if (!pair.is_in_time) {
    const bool is_waiting = static_cast<double>(*time_ns - *waiting_since_ns_) < 1e9 * kTimeout_s;
    return is_waiting ? std::nullopt : std::optional(pair);
  }
  if (shown_ns_ && (times_ns[0] < (*shown_ns_)[0] || times_ns[1] < (*shown_ns_)[1]))
    return std::nullopt;
  shown_ns_ = times_ns;
  waiting_since_ns_ = std::max(times_ns[0], times_ns[1]);
  return pair;
}

/// Divides by frame numbers, so that frames that were not measured are counted.
void ViewPairing::measure_period(std::size_t which, const Timed& now) {
  if (views_[which].empty()) return;
  const Timed& before = views_[which].back();
  const FramePtr &frame = now.view->result.frame, &last = before.view->result.frame;
  if (!frame || !last || !now.time_ns || !before.time_ns || frame->sequence <= last->sequence)
    return;
  const auto frames = static_cast<double>(frame->sequence - last->sequence);
  period_ms_[which] = 1e-6 * static_cast<double>(*now.time_ns - *before.time_ns) / frames;
}

std::optional<double> ViewPairing::period_ms(std::size_t which) const { return period_ms_[which]; }

QString finger_name(const FingerStatus& finger) {
  return QString::fromStdString(finger.finger ? finger.finger->name
                                              : finger.folder.filename().string());
}

LivePairBox::LivePairBox(const LivePair& pair, const LiveSession& first, QWidget* parent)
    : Translated(parent),
      pair_(pair),
      first_(first),
      open_(new QPushButton),
      close_(new QPushButton),
      names_(wrapped_label()),
      moment_(wrapped_label()),
      reading_(wrapped_text()),
      motor_label_(new QLabel),
      motor_(new NumberField) {
  auto* grid = new QGridLayout(this);
  grid->addWidget(names_, 0, 0, 1, 2);
  grid->addWidget(reading_, 1, 0, 1, 2);
  grid->addWidget(motor_label_, 2, 0);
  grid->addWidget(motor_, 2, 1);
  grid->addWidget(moment_, 3, 0, 1, 2);
  grid->addWidget(open_, 4, 0);
  grid->addWidget(close_, 4, 1);
  for (QLabel* label : {names_, moment_, reading_}) label->setTextFormat(Qt::RichText);
  motor_label_->setBuddy(motor_);
  motor_->set_shown_decimals(3);
  motor_->setSingleStep(0.1);
  connect(open_, &QPushButton::clicked, this, &LivePairBox::open_requested);
  connect(close_, &QPushButton::clicked, this, &LivePairBox::close_requested);
  connect(motor_, &NumberField::valueChanged, this, &LivePairBox::motor_requested);
  say([this] { name_parts(); });
}

void LivePairBox::name_parts() {
  setTitle(tr("Second finger"));
  open_->setText(tr("&Second finger…"));
  open_->setToolTip(tr("Shows another finger with its own camera at the same moment"));
  close_->setText(tr("Close"));
  close_->setToolTip(tr("Shows the first finger alone again"));
  motor_label_->setText(tr("Mo&tor at"));
  motor_->setSuffix(tr(" turns"));
  motor_->setAccessibleName(tr("Motor position in turns"));
  motor_->setToolTip(tr("Position of the gripper's motor; the figures apply to this position."));
  reading_->setAccessibleName(tr("Gap and width"));
  moment_->setAccessibleName(tr("Synchronization of both images"));
  show_pair();
}

void LivePairBox::show_pair() {
  const bool is_open = pair_.opened().has_value() && pair_.second() != nullptr;
  for (QWidget* widget : std::initializer_list<QWidget*>{close_, names_, moment_, reading_})
    widget->setVisible(is_open);
  const auto turns = pair_.motor_turns();
  motor_label_->setVisible(turns.has_value());
  motor_->setVisible(turns.has_value());
  if (!is_open) return;
  if (turns) {
    const QSignalBlocker blocker(motor_);
    const GripperMotor& motor = pair_.gripper()->gripper.motor;
    motor_->setRange(motor.first_turns, motor.last_turns);
    motor_->setValue(*turns);
  }
  names_->setText(names_text());
  moment_->setText(moment_text());
  reading_->setText(reading_text());
}

QString LivePairBox::names_text() const {
  const auto& pair = pair_.pair();
  QStringList lines;
  for (const std::size_t i : {0U, 1U}) {
    const LiveSession& session = i == 0 ? first_ : *pair_.second();
    QString line =
        labelled(QString::number(i + 1), finger_name(session.status().finger).toHtmlEscaped());
    const QString felt = pair ? brief_contact_words(pair->views[i]->result) : QString();
    if (!felt.isEmpty()) line += QStringLiteral("<br>&nbsp;&nbsp;&nbsp;") + felt;
    lines << line;
  }
  return lines.join(QStringLiteral("<br>"));
}

QString LivePairBox::moment_text() const {
  if (const auto problem = pair_.problem())
    return window_sentence(problem->message()).toHtmlEscaped();
  const auto& pair = pair_.pair();
  if (!pair) return tr("Waiting for the second image.");
  if (!pair->later_ms) return tr("No capture times: the newest image of each camera.");
  const QString later = plain_number(*pair->later_ms, 1);
  if (pair->is_in_time) return tr("In sync: 2 was captured %1 ms after 1.").arg(later);
  return QStringLiteral("<b>%1 %2</b>")
      .arg(QString(QChar(0x25b2)),
           tr("Not in sync: 2 was captured %1 ms after 1, more than half a frame.").arg(later));
}

QString LivePairBox::reading_text() const {
  if (pair_.opened()->gripper.empty())
    return tr(
        "With a gripper.yaml, the gap between the faces and the width of the held object appear "
        "here.");
  if (!pair_.gripper() || pair_.problem()) return {};
  const auto& reading = pair_.reading();
  if (!reading) return tr("Measuring…");
  QString rows;
  const auto add = [&](const QString& name, double mm, const std::optional<double>& sd) {
    rows += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td><b>%2</b></td></tr>")
                .arg(name, tr("%1 mm").arg(number_and_sd(mm, sd, 2)));
  };
  if (reading->gap) add(tr("Gap"), reading->gap->mm, reading->gap->sd_mm);
  if (reading->width) add(tr("Object width"), reading->width->mm, reading->width->sd_mm);
  QString text = QStringLiteral("<table>%1</table>").arg(rows);
  if (!reading->gap) text += tr("Gap unknown: both faces need depth.");
  if (!reading->width) text += QStringLiteral(" ") + tr("No jointly held object.");
  return text;
}

namespace {

QString path_text(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}

}  // namespace

SecondCameraDialog::SecondCameraDialog(const std::optional<SecondCamera>& now,
                                       const QStringList& cameras, QWidget* parent)
    : FittedDialog(parent),
      now_(now),
      intro_(wrapped_label()),
      finger_label_(new QLabel),
      source_label_(new QLabel),
      gripper_label_(new QLabel),
      missing_(new QLabel),
      finger_(new QLineEdit),
      gripper_(new QLineEdit),
      source_(new QComboBox),
      choose_finger_(new QPushButton),
      choose_source_(new QPushButton),
      choose_gripper_(new QPushButton),
      show_(new QPushButton),
      cancel_(new QPushButton) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(intro_);
  auto* grid = new QGridLayout;
  int row = 0;
  for (const auto& [label, line, button] :
       std::initializer_list<std::tuple<QLabel*, QWidget*, QPushButton*>>{
           {finger_label_, finger_, choose_finger_},
           {source_label_, source_, choose_source_},
           {gripper_label_, gripper_, choose_gripper_}}) {
    label->setBuddy(line);
    line->setMinimumWidth(300);
    grid->addWidget(label, row, 0);
    grid->addWidget(line, row, 1);
    grid->addWidget(button, row++, 2);
  }
  grid->setColumnStretch(1, 1);
  column->addLayout(grid);
  column->addStretch();
  column->addWidget(missing_);
  auto* buttons = new QDialogButtonBox;
  buttons->addButton(show_, QDialogButtonBox::AcceptRole);
  buttons->addButton(cancel_, QDialogButtonBox::RejectRole);
  show_->setDefault(true);
  column->addWidget(buttons);
  source_->setEditable(true);
  source_->addItems(cameras);
  source_->setCurrentText(now && !now->source.empty() ? path_text(now->source.front()) : QString());
  for (QLineEdit* line : {finger_, gripper_}) show_text_as_tip(*line);
  if (now) {
    finger_->setText(path_text(now->finger));
    gripper_->setText(path_text(now->gripper));
  }
  connect(finger_, &QLineEdit::textChanged, this, &SecondCameraDialog::show_missing);
  connect(source_, &QComboBox::editTextChanged, this, &SecondCameraDialog::show_missing);
  connect(choose_finger_, &QPushButton::clicked, this, [this] {
    ask_for_folder(this, FilesOf::kFingers, tr("The second finger's folder"),
                   [this](const QString& folder) { finger_->setText(folder); });
  });
  connect(choose_source_, &QPushButton::clicked, this, [this] {
    ask_for_file(this, FilesOf::kRecordings, tr("Source of the second finger"),
                 video_filter(QStringLiteral("*.yaml *.yml")),
                 [this](const QString& file) { source_->setEditText(file); });
  });
  connect(choose_gripper_, &QPushButton::clicked, this, [this] {
    ask_for_file(this, FilesOf::kGrippers, tr("The gripper's file"), tr("Grippers (*.yaml)"),
                 [this](const QString& file) { gripper_->setText(file); });
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    Q_EMIT chosen(entered());
    accept();
  });
  say([this] { name_parts(); });
}

void SecondCameraDialog::name_parts() {
  setWindowTitle(tr("Second finger"));
  intro_->setText(
      tr("Another finger of the same gripper with its own camera. Both images are shown for the "
         "same moment. With a gripper.yaml, the gap between the faces and the width of the held "
         "object are shown, too."));
  finger_label_->setText(tr("&Finger's folder"));
  source_label_->setText(tr("&Camera"));
  gripper_label_->setText(tr("&Gripper"));
  finger_->setAccessibleName(tr("Finger's folder"));
  source_->setAccessibleName(tr("Camera, video or scene"));
  source_->setToolTip(tr("Source of the second finger's images"));
  gripper_->setAccessibleName(tr("Gripper's file"));
  gripper_->setPlaceholderText(tr("gripper.yaml; may be left empty"));
  choose_finger_->setText(tr("Choose…"));
  choose_finger_->setToolTip(tr("Chooses the folder of the second finger"));
  choose_source_->setText(tr("File…"));
  choose_source_->setToolTip(tr("Chooses a video or a scene instead of a camera"));
  choose_gripper_->setText(tr("Choose…"));
  choose_gripper_->setToolTip(tr("Chooses the file that describes the gripper"));
  choose_finger_->setAccessibleName(tr("Choose the finger's folder"));
  choose_source_->setAccessibleName(tr("Choose a video or a scene"));
  choose_gripper_->setAccessibleName(tr("Choose the gripper's file"));
  show_->setText(tr("&Show it"));
  show_->setToolTip(tr("Opens the second finger next to the first"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Closes this window without a change (Esc)"));
  show_missing();
}

SecondCamera SecondCameraDialog::entered() const {
  SecondCamera second;
  second.finger = finger_->text().trimmed().toStdString();
  second.source = {source_->currentText().trimmed().toStdString()};
  second.gripper = gripper_->text().trimmed().toStdString();
  if (now_ && now_->gripper == second.gripper) second.motor_turns = now_->motor_turns;
  return second;
}

void SecondCameraDialog::show_missing() {
  const bool has_finger = !finger_->text().trimmed().isEmpty();
  const bool has_source = !source_->currentText().trimmed().isEmpty();
  show_->setEnabled(has_finger && has_source);
  missing_->setText(!has_finger   ? tr("Choose the finger's folder.")
                    : !has_source ? tr("Choose its camera.")
                                  : QString());
}

}  // namespace alltact
