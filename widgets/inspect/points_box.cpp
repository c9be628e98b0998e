#include "widgets/inspect/points_box.h"

#include "widgets/inspect/face_positions.h"
#include "widgets/inspect/reading_text.h"

#include <QGridLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

enum MergeId { kPointA = 2011 };  // ids of the four fields
// One digit more would widen the column.
constexpr double kNotChosen_mm = -999, kFurthest_mm = 999;

NumberField* position_box() {
  auto* box = new NumberField;
  box->setRange(kNotChosen_mm, kFurthest_mm);
  box->setSingleStep(0.1);
  box->set_shown_decimals(2);
  box->setSpecialValueText(QString(QChar(0x2013)));
  return box;
}

}  // namespace

PointsBox::PointsBox(QWidget* parent)
    : Translated(parent),
      points_{{{&InspectOptions::a, new QLabel, {position_box(), position_box()}},
               {&InspectOptions::b, new QLabel, {position_box(), position_box()}}}},
      deepest_(new QPushButton),
      across_(new QPushButton),
      along_(new QPushButton),
      clear_(new QPushButton),
      reading_(new QLabel) {
  deepest_->setObjectName(QStringLiteral("deepest"));
  across_->setObjectName(QStringLiteral("across"));
  auto* grid = new QGridLayout(this);
  int row = 0;
  for (const Point& point : points_) {
    grid->addWidget(point.label, row, 0);
    grid->addWidget(point.boxes[0], row, 1);
    grid->addWidget(point.boxes[1], row++, 2);
    point.label->setBuddy(point.boxes[0]);
  }
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  auto* buttons = new QGridLayout;
  buttons->addWidget(deepest_, 0, 0);
  buttons->addWidget(clear_, 0, 1);
  buttons->addWidget(across_, 1, 0);
  buttons->addWidget(along_, 1, 1);
  grid->addLayout(buttons, row++, 0, 1, 3);
  reading_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  reading_->setWordWrap(true);
  constexpr int kLines = 7;  // constant height while points come and go
  reading_->setMinimumHeight(kLines * reading_->fontMetrics().lineSpacing());
  reading_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  grid->addWidget(reading_, row, 0, 1, 3);
  connect_points();
  say([this] { name_parts(); });
  show_frame(nullptr);
}

void PointsBox::connect_points() {
  int id = kPointA;
  for (const Point& point : points_)
    for (const std::size_t part : {0U, 1U}) {
      connect(point.boxes[part], &NumberField::valueChanged, this, [this, point, part, id] {
        change_coordinate(point, part, id);
      });
      ++id;
    }
  connect(deepest_, &QPushButton::clicked, this, [this] {
    const auto at = deepest();
    if (!at) return;
    InspectOptions next = options_;
    next.a = position_of(*frame_, *at);
    Q_EMIT changed(
        next, [] { return tr("move point A"); }, -1);
  });
  connect(across_, &QPushButton::clicked, this, [this] { set_section_line(true); });
  connect(along_, &QPushButton::clicked, this, [this] { set_section_line(false); });
  connect(clear_, &QPushButton::clicked, this, [this] {
    InspectOptions next = options_;
    next.a.reset();
    next.b.reset();
    Q_EMIT changed(
        next, [] { return tr("take the points away"); }, -1);
  });
}

/// The other coordinate is unchanged; for a new point it is 0.
void PointsBox::change_coordinate(const Point& point, std::size_t part, int merge_id) {
  InspectOptions next = options_;
  auto& position = next.*point.member;
  if (!position) position = FacePosition();
  const double value = point.boxes[part]->value();
  constexpr double kBarelyAbove = kNotChosen_mm + 10;  // up to one step above "not chosen"
  (part == 0 ? position->along_mm : position->across_mm) = value < kBarelyAbove ? 0.0 : value;
  Q_EMIT changed(
      next,
      [is_first = point.member == &InspectOptions::a] {
        return is_first ? tr("move point A") : tr("move point B");
      },
      merge_id);
}

std::optional<cv::Point2d> PointsBox::deepest() const {
  if (!frame_ || !frame_->result.depth) return std::nullopt;
  cv::Mat depth = frame_->result.depth->depth_mm.clone();
  cv::patchNaNs(depth, -1);
  cv::Point at;
  double max_depth_mm = -1;
  cv::minMaxLoc(depth, nullptr, &max_depth_mm, nullptr, &at);
  if (max_depth_mm < 0) return std::nullopt;
  return cv::Point2d(at);
}

/// From edge to edge through point A, or through the deepest point.
void PointsBox::set_section_line(bool is_across) {
  if (!frame_ || !frame_->result.shape) return;
  auto through = pixel_of(*frame_, options_.a);
  if (!through) through = deepest();
  if (!through) return;
  const FaceShape& shape = *frame_->result.shape;
  const int u = static_cast<int>(std::lround(through->x));
  const int v = static_cast<int>(std::lround(through->y));
  const auto holds = [&](int column) {
    const auto rows = shape.rows(column, 0);
    return v >= rows.first && v <= rows.last;
  };
  if (u < 0 || u >= shape.width_px() || !holds(u)) return;
  InspectOptions next = options_;
  if (is_across) {
    const auto rows = shape.rows(u, 0);
    next.a = position_of(*frame_, cv::Point2d(u, rows.first));
    next.b = position_of(*frame_, cv::Point2d(u, rows.last));
  } else {
    int first = u, last = u;
    while (first > 0 && holds(first - 1)) --first;
    while (last + 1 < shape.width_px() && holds(last + 1)) ++last;
    next.a = position_of(*frame_, cv::Point2d(first, v));
    next.b = position_of(*frame_, cv::Point2d(last, v));
  }
  Q_EMIT changed(
      next, [is_across] { return is_across ? tr("cut across") : tr("cut along"); }, -1);
}

void PointsBox::name_parts() {
  setTitle(tr("Points"));
  const std::array<QString, 2> names{tr("Point &A"), tr("Point &B")};
  const std::array<std::array<QString, 2>, 2> spoken{
      {{tr("Point A, along the finger"), tr("Point A, across it")},
       {tr("Point B, along the finger"), tr("Point B, across it")}}};
  const std::array<QString, 2> help{
      tr("Along the face from its base. A point stays there on the finger while that moves."),
      tr("Across the face from its middle.")};
  for (std::size_t i = 0; i < points_.size(); ++i) {
    points_[i].label->setText(names[i]);
    for (std::size_t part = 0; part < 2; ++part) {
      NumberField* box = points_[i].boxes[part];
      box->setSuffix(tr(" mm"));
      box->setAccessibleName(spoken[i][part]);
      box->setToolTip(help[part]);
    }
  }
  deepest_->setText(tr("Deepest"));
  deepest_->setToolTip(tr("Puts A on the deepest point."));
  clear_->setText(tr("Clear"));
  clear_->setToolTip(tr("Takes both points away."));
  across_->setText(tr("Across"));
  across_->setToolTip(tr("From edge to edge of the finger, through A or the deepest point."));
  along_->setText(tr("Along"));
  along_->setToolTip(tr("From base to tip, through A or the deepest point."));
  reading_->setAccessibleName(tr("Measured at the points"));
  show_reading();
}

void PointsBox::set_options(const InspectOptions& options) {
  options_ = options;
  show_points();
  clear_->setEnabled(options.a || options.b);
  show_reading();
}

void PointsBox::show_points() {
  for (const Point& point : points_) {
    const auto& position = options_.*point.member;
    const std::array now{position ? position->along_mm : kNotChosen_mm,
                         position ? position->across_mm : kNotChosen_mm};
    for (std::size_t part = 0; part < 2; ++part) {
      const QSignalBlocker quiet(point.boxes[part]);
      point.boxes[part]->setValue(now[part]);
    }
  }
}

void PointsBox::show_frame(const std::shared_ptr<const InspectedFrame>& frame) {
  frame_ = frame;
  const bool has_depth = frame && frame->result.depth && frame->result.shape;
  for (QPushButton* button : {deepest_, across_, along_}) button->setEnabled(has_depth);
  show_reading();
}

void PointsBox::show_reading() {
  if (!frame_ || !frame_->result.depth) return reading_->setText(tr("Nothing to measure yet."));
  reading_->setText(reading_text(*frame_, options_.a, options_.b));
}

}  // namespace alltact
