#include "widgets/panels/recording_checks.h"

#include "calibration/reference/make_reference.h"
#include "calibration/reference/reference_recording.h"
#include "core/base/atomic_file.h"
#include "core/finger/finger.h"
#include "core/live/source_runner.h"
#include "widgets/controls/control_panel.h"
#include "widgets/language.h"
#include "widgets/theme.h"
#include "widgets/widget_base.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <optional>

namespace alltact {
namespace {

constexpr int kFindingLines = 2;
constexpr int kRigSymbol = 16;

QString item_name(RigItem item) {
  switch (item) {
    case RigItem::kFocusBase:
      return RigCheckBox::tr("Focus at the base");
    case RigItem::kFocusTip:
      return RigCheckBox::tr("Focus at the tip");
    case RigItem::kBrightness:
      return RigCheckBox::tr("Brightness");
    case RigItem::kLamp:
      return RigCheckBox::tr("Lamp");
    case RigItem::kDots:
      break;
  }
  return RigCheckBox::tr("Dots");
}

}  // namespace

RigCheckBox::RigCheckBox(QWidget* parent)
    : Translated(parent),
      fold_(new QToolButton),
      rows_(new QWidget),
      column_(new QVBoxLayout(rows_)) {
  auto* column = without_margins(new QVBoxLayout(this));
  fold_->setCheckable(true);
  fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  column->addWidget(fold_);
  column_->setContentsMargins(4, 0, 0, 0);
  column->addWidget(rows_);
  connect(fold_, &QToolButton::toggled, this, &RigCheckBox::show_fold);
  say([this] {
    rows_->setAccessibleName(tr("Before the first recording"));
    fold_->setToolTip(tr("What is checked before the first recording; a click shows or hides it"));
    show_findings(findings_, controls_);
  });
}

void RigCheckBox::set_needed(bool is_needed) {
  if (is_needed == is_needed_) return;
  is_needed_ = is_needed;
  fold_->setChecked(is_needed);
}

RigCheckBox::Line RigCheckBox::line_of(const RigFinding& finding) {
  Line line;
  line.is_known = finding.state != RigState::kWaiting;
  line.meaning = finding.state == RigState::kFine  ? Meaning::kGood
                 : finding.state == RigState::kBad ? Meaning::kBad
                                                   : Meaning::kDoubtful;
  line.text = tr("%1: %2.").arg(item_name(finding.item), in_window_language(finding.sentence));
  if (!finding.advice.empty()) line.text += QLatin1Char(' ') + window_sentence(finding.advice);
  return line;
}

void RigCheckBox::show_findings(const std::vector<RigFinding>& findings,
                                const std::vector<CameraControl>& controls) {
  findings_ = findings;
  controls_ = controls;
  std::vector<Line> lines;
  for (const RigFinding& finding : findings) lines.push_back(line_of(finding));
  if (!controls.empty()) {
    QStringList names;
    for (const CameraControl& control : automatic_modes_on(controls))
      names << control_name(control);
    lines.push_back({names.isEmpty() ? Meaning::kGood : Meaning::kBad, true,
                     names.isEmpty()
                         ? tr("Camera: all modes are manual.")
                         : tr("Camera: %1 is on and changes the measured brightness. Lock "
                              "brightness on the Live page, or switch it off there.")
                               .arg(listed(names))});
  }
  const bool is_other_count = lines.size() != shown_.size();
  if (lines == lines_ && !is_other_count) return show_fold();
  lines_ = std::move(lines);
  show_lines(is_other_count);
  show_fold();
}

void RigCheckBox::show_lines(bool anew) {
  if (anew) {
    while (QLayoutItem* item = column_->takeAt(0)) {
      delete item->widget();
      delete item;
    }
    shown_.clear();
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      auto* line_widget = new QWidget;
      auto* row = without_margins(new QHBoxLayout(line_widget));
      Row made{new QLabel, new ReservedText(kFindingLines)};
      made.symbol->setFixedWidth(kRigSymbol);
      row->addWidget(made.symbol, 0, Qt::AlignTop);
      row->addWidget(made.text, 1);
      column_->addWidget(line_widget);
      shown_.push_back(made);
    }
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Line& line = lines_[i];
    shown_[i].symbol->setPixmap(line.is_known ? symbol(meaning_symbol(line.meaning),
                                                       meaning_colour(line.meaning, palette()),
                                                       kRigSymbol, devicePixelRatioF())
                                              : QPixmap());
    shown_[i].text->setText(line.text);
  }
}

void RigCheckBox::show_fold() {
  const auto count = std::count_if(lines_.begin(), lines_.end(), [](const Line& line) {
    return line.is_known && line.meaning != Meaning::kGood;
  });
  fold_->setText(count > 0
                     ? tr("Before the first recording: %n to fix", nullptr, static_cast<int>(count))
                     : tr("Before the first recording"));
  fold_->setArrowType(fold_->isChecked() ? Qt::DownArrow : Qt::RightArrow);
  rows_->setVisible(fold_->isChecked());
}

void RigCheckBox::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_lines(false);
}

namespace {

constexpr double kShown = BendState::kShown;
constexpr double kSign = 12;

double part_of(double value, double need) {
  return need > 0 ? std::clamp(value / need, -kShown, kShown) : 0;
}

}  // namespace

QString bend_direction_text(BendDirection direction) {
  switch (direction) {
    case BendDirection::kAway:
      return CoverageView::tr("bend away");
    case BendDirection::kTowards:
      return CoverageView::tr("bend back");
    case BendDirection::kUp:
      return CoverageView::tr("sway up");
    case BendDirection::kDown:
      return CoverageView::tr("sway down");
    case BendDirection::kTwistRight:
      return CoverageView::tr("twist right");
    case BendDirection::kTwistLeft:
      break;
  }
  return CoverageView::tr("twist left");
}

CoverageView::CoverageView(QWidget* parent) : Translated(parent) {
  set_accessible_role(*this, QAccessible::Chart);
  say([this] {
    setAccessibleName(tr("Coverage of bending"));
    describe();
  });
}

void CoverageView::show_coverage(const BendState& coverage) {
  coverage_ = coverage;
  describe();
  update();
}

void CoverageView::describe() {
  QStringList missing;
  for (const BendDirection direction : coverage_.missing())
    missing << bend_direction_text(direction);
  set_accessible_description(*this, coverage_.poses == 0 ? tr("No pose seen yet.")
                                    : missing.isEmpty()  ? tr("Enough: all directions reached.")
                                                         : tr("Missing: %1.").arg(listed(missing)));
}

void CoverageView::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update();
}

void CoverageView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double line = fontMetrics().height() + 4.0;
  const double twist = 2 * line + 10;
  const double side = std::min(width() - 2.0, height() - 2 * line - twist - 8);
  const QRectF field(0.5 * (width() - side), line, side, side);
  paint_field(painter, field);
  paint_label(painter, {field.left(), 0, side, line}, Qt::AlignCenter, BendDirection::kUp);
  paint_label(painter, {field.left(), field.bottom(), side, line}, Qt::AlignCenter,
              BendDirection::kDown);
  // One above the axis and one below it, so that long words fit.
  const QRectF above(field.left() + 6, field.center().y() - line - 2, side - 12, line);
  const QRectF under(field.left() + 6, field.center().y() + 2, side - 12, line);
  paint_label(painter, above, Qt::AlignLeft | Qt::AlignVCenter, BendDirection::kTowards);
  paint_label(painter, under, Qt::AlignRight | Qt::AlignVCenter, BendDirection::kAway);
  const QRectF below(field.left(), field.bottom() + line + 6, side, line);
  paint_label(painter, below, Qt::AlignLeft | Qt::AlignVCenter, BendDirection::kTwistLeft);
  paint_label(painter, below, Qt::AlignRight | Qt::AlignVCenter, BendDirection::kTwistRight);
  paint_twist(painter, {field.left(), below.bottom() + 2, side, line - 4});
}

void CoverageView::paint_field(QPainter& painter, const QRectF& field) const {
  const QColor line = palette().color(QPalette::Disabled, QPalette::Text);
  painter.fillRect(field, palette().color(QPalette::Base));
  constexpr int n = BendState::kCells;
  const double step = field.width() / n;
  const QColor visited = role_colour(ColourRole::kMeasured, palette());
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) {
      const auto visits =
          coverage_.visits[static_cast<std::size_t>(std::ptrdiff_t{row} * n + column)];
      if (visits == 0) continue;
      QColor colour = visited;
      colour.setAlphaF(static_cast<float>(std::min(1.0, 0.35 + 0.1 * std::log2(visits))));
      painter.fillRect(QRectF(field.left() + column * step, field.top() + row * step, step, step),
                       colour);
    }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(line, 1));
  painter.drawRect(field);
  const double reach = 0.5 * field.width() / kShown;
  painter.setPen(QPen(line, 1, Qt::DashLine));
  painter.drawRect(QRectF(field.center() - QPointF(reach, reach), QSizeF(2 * reach, 2 * reach)));
  painter.drawLine(QPointF(field.left(), field.center().y()),
                   QPointF(field.right(), field.center().y()));
  painter.drawLine(QPointF(field.center().x(), field.top()),
                   QPointF(field.center().x(), field.bottom()));
  if (!coverage_.now) return;
  const QPointF at =
      field.center() + QPointF(part_of(coverage_.now->bend_mm, coverage_.need.bend_mm) * reach,
                               part_of(coverage_.now->sway_mm, coverage_.need.sway_mm) * reach);
  painter.setPen(QPen(palette().color(QPalette::Base), 2));
  painter.setBrush(palette().color(QPalette::Text));
  painter.drawEllipse(at, 6, 6);
}

void CoverageView::paint_twist(QPainter& painter, const QRectF& bar) const {
  painter.fillRect(bar, palette().color(QPalette::Base));
  const auto reached = [&](BendDirection direction) {
    return std::min(coverage_.reached[static_cast<std::size_t>(direction)], kShown);
  };
  const double half = 0.5 * bar.width() / kShown;
  const double left = std::max(0.0, reached(BendDirection::kTwistLeft)) * half;
  const double right = std::max(0.0, reached(BendDirection::kTwistRight)) * half;
  painter.fillRect(QRectF(bar.center().x() - left, bar.top(), left + right, bar.height()),
                   role_colour(ColourRole::kMeasured, palette()));
  const QColor line = palette().color(QPalette::Disabled, QPalette::Text);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(line, 1));
  painter.drawRect(bar);
  painter.setPen(QPen(line, 1, Qt::DashLine));
  for (const double x : {bar.center().x() - half, bar.center().x(), bar.center().x() + half})
    painter.drawLine(QPointF(x, bar.top()), QPointF(x, bar.bottom()));
  if (!coverage_.now) return;
  const double x =
      bar.center().x() + part_of(coverage_.now->twist_deg, coverage_.need.twist_deg) * half;
  painter.setPen(QPen(palette().color(QPalette::Base), 2));
  painter.setBrush(palette().color(QPalette::Text));
  painter.drawEllipse(QPointF(x, bar.center().y()), 6, 6);
}

void CoverageView::paint_label(QPainter& painter, const QRectF& room, int flags,
                               BendDirection direction) const {
  const QString text = bend_direction_text(direction);
  const bool is_reached = coverage_.reached[static_cast<std::size_t>(direction)] >= 1;
  const bool is_inside = direction == BendDirection::kAway || direction == BendDirection::kTowards;
  const double text_width = fontMetrics().horizontalAdvance(text), gap = 5;
  const double total_width = kSign + gap + text_width;
  double left = room.left();
  if ((flags & Qt::AlignHCenter) != 0) left = room.center().x() - 0.5 * total_width;
  if ((flags & Qt::AlignRight) != 0) left = room.right() - total_width;
  if (is_inside) {  // so that no line crosses the text
    QColor ground = palette().color(QPalette::Base);
    ground.setAlphaF(0.85F);
    painter.fillRect(QRectF(left - 3, room.top() + 1, total_width + 6, room.height() - 2), ground);
  }
  paint_sign(painter, {left + 0.5 * kSign, room.center().y()}, is_reached);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(QRectF(left + kSign + gap, room.top(), text_width + 2, room.height()),
                   Qt::AlignVCenter | Qt::AlignLeft, text);
}

void CoverageView::paint_sign(QPainter& painter, QPointF centre, bool is_reached) const {
  const double r = 0.4 * kSign;
  QPainterPath path;
  if (is_reached) {
    path.moveTo(centre + QPointF(-r, 0));
    path.lineTo(centre + QPointF(-0.2 * r, 0.8 * r));
    path.lineTo(centre + QPointF(r, -0.8 * r));
  } else {
    path.addEllipse(centre, r, r);
  }
  const QColor colour = meaning_colour(is_reached ? Meaning::kGood : Meaning::kDoubtful, palette());
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colour, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
}

namespace {

/// Of the markers seen in both frames; nullopt: none.
std::optional<double> median_displacement_px(const Markers& a, const Markers& b) {
  std::vector<double> displacements_px;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    if (a[i].seen && b[i].seen)
      displacements_px.push_back(std::hypot(a[i].u - b[i].u, a[i].v - b[i].v));
  if (displacements_px.empty()) return std::nullopt;
  const auto middle =
      displacements_px.begin() + static_cast<std::ptrdiff_t>(displacements_px.size() / 2);
  std::nth_element(displacements_px.begin(), middle, displacements_px.end());
  return *middle;
}

}  // namespace

bool QuickBending::is_quick(const FrameResult& result) {
  if (!result.frame || !result.markers) return false;
  const double now_s = time_s(*result.frame).value_or(1e-9 * static_cast<double>(monotonic_ns()));
  const bool goes_on = result.frame->origin == source_ && now_s > before_s_;
  const auto displacement_px =
      goes_on ? median_displacement_px(before_, *result.markers) : std::nullopt;
  if (!goes_on) quick_until_s_ = -1;
  if (displacement_px && result.grey.cols > 0 &&
      *displacement_px > kQuick_per_s * result.grey.cols * (now_s - before_s_))
    quick_until_s_ = now_s + kSettles_s;
  before_ = *result.markers;
  before_s_ = now_s;
  source_ = result.frame->origin;
  return now_s <= quick_until_s_;
}

namespace {

namespace fs = std::filesystem;

fs::path path_of(const QTemporaryDir& folder) { return folder.path().toStdString(); }

JudgedTake judge_take(
    const fs::path& finger, const fs::path& video,
    const std::function<Result<ReferenceReport>(const fs::path& copy, const Job& job)>& judging,
    const Job& job) {
  const auto copy = std::make_shared<const QTemporaryDir>();
  const auto judged = [&](Result<ReferenceReport> report, std::string finger_yaml = {}) {
    return JudgedTake{std::move(report), copy, std::move(finger_yaml), finger, video};
  };
  std::error_code failed;
  if (!copy->isValid())
    return judged(Error{en::say("there is no space to try the recording"),
                        fs::temp_directory_path(failed).string(),
                        en::say("freeing some space on the disk")});
  auto finger_yaml = read_file(finger / Finger::kFileName);
  if (!finger_yaml) return judged(finger_yaml.error());
  const Status copied = write_file_atomically(path_of(*copy) / Finger::kFileName, *finger_yaml);
  if (!copied) return judged(copied.error());
  // The earlier reference helps to judge the recording; without it the recording is judged alone.
  for (const char* name : {kReferenceVideo, kReferenceTable})
    fs::create_symlink(finger / name, path_of(*copy) / name, failed);
  return judged(judging(path_of(*copy), job), std::move(*finger_yaml));
}

}  // namespace

Result<bool> JudgedTake::install() const {
  const auto now = read_file(finger / Finger::kFileName);
  if (!now) return now.error();
  std::error_code absent;
  const bool is_all = report.ok() && !fs::exists(path_of(*copy) / kReferenceProblem, absent);
  if (!is_all || *now != finger_yaml) return false;
  if (const Status given = copy_reference(path_of(*copy), finger); !given) return given.error();
  fs::remove(finger / kReferenceProblem, absent);  // of an earlier recording
  return true;
}

TakeJudge::TakeJudge(QObject* parent) : QObject(parent) {
  connect(&work_, &BackgroundWork::progressed, this, &TakeJudge::changed);
  connect(&work_, &BackgroundWork::finished, this, &TakeJudge::changed);
}

void PendingChoices::put(ReferenceChoices choices) {
  const std::lock_guard lock(mutex_);
  choices_ = std::move(choices);
  is_put_.notify_all();
}

ReferenceChoices PendingChoices::wait(const Job& job) const {
  constexpr std::chrono::milliseconds kBetweenLooks{50};  // at the job, which wakes nobody
  std::unique_lock lock(mutex_);
  while (!choices_ && !job.stop_requested()) is_put_.wait_for(lock, kBetweenLooks);
  return choices_.value_or(ReferenceChoices{});
}

void TakeJudge::judge(const fs::path& finger, const fs::path& video,
                      const ReferenceChoices& choices) {
  run(finger, video, [video, choices](const fs::path& copy, const Job& job) {
    return set_reference(copy, {video}, job, choices);
  });
}

void TakeJudge::follow(const fs::path& finger, std::shared_ptr<RecordingFeed> feed) {
  const auto pending = std::make_shared<PendingChoices>();
  run(finger, feed->file(), [feed, pending](const fs::path& copy, const Job& job) {
    FollowedRecording recording(feed, job);
    return set_reference(copy, recording, job, [&] { return pending->wait(job); });
  });
  followed_finger_ = finger;
  feed_ = std::move(feed);
  pending_ = pending;
}

bool TakeJudge::conclude(const fs::path& finger, const fs::path& video, ReferenceChoices choices) {
  const auto feed = std::exchange(feed_, nullptr);
  const auto pending = std::exchange(pending_, nullptr);
  if (!feed || feed->file() != video || followed_finger_ != finger || !feed->extent().is_complete)
    return false;
  pending->put(std::move(choices));
  return true;
}

void TakeJudge::run(const fs::path& finger, const fs::path& video, Judging judging) {
  forget();
  work_.restart([this, finger, video, judging = std::move(judging),
                 number = number_](const Job& job) {
    const auto judged = std::make_shared<const JudgedTake>(judge_take(finger, video, judging, job));
    return std::function<void()>([this, judged, number, is_stopped = job.stop_requested()] {
      if (number == number_ && !is_stopped) judged_ = judged;
    });
  });
  Q_EMIT changed();
}

void TakeJudge::stop() { work_.stop(); }

void TakeJudge::forget() {
  stop();
  ++number_;
  feed_.reset();
  pending_.reset();
  if (!judged_) return;
  // The copy may be large, so it is removed on a background thread.
  clearing_.start([judged = std::exchange(judged_, nullptr)](const Job&) mutable {
    judged.reset();
    return std::function<void()>([] {});
  });
}

}  // namespace alltact
