#include "widgets/inspect/point_readings.h"

#include "core/numerics/readable_numbers.h"
#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/surface_measurement.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/language.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr int kPointA = 2011;  // merge ids of the four fields follow
constexpr int kLambda = 2021;
constexpr double kNoLambda_mm = 0, kLongestLambda_mm = 100;
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
      reading_(wrapped_text()) {
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
      connect(point.boxes[part], &NumberField::valueChanged, this,
              [this, point, part, id] { change_coordinate(point, part, id); });
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
        next, [] { return tr("remove the points"); }, -1);
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
  const std::array<QString, 2> help{tr("Along the face from its base. The point stays there on the "
                                       "finger when the finger moves."),
                                    tr("Across the face from its centre line.")};
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
  clear_->setToolTip(tr("Removes both points."));
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

namespace {

QString hundredths(double value) { return plain_number(value, 2); }

/// Limits of the depth, appended to its number; bits of DepthLimit.
QString limits_text(std::uint8_t limits) {
  QStringList words;
  if ((limits & kLayerLimit) != 0) words << PointsBox::tr("at the layer's limit");
  if ((limits & kBulgeTop) != 0) words << PointsBox::tr("a bulge at the layer's limit");
  if ((limits & kOutOfRange) != 0) words << PointsBox::tr("beyond the calibrated range");
  if ((limits & kSteep) != 0) words << PointsBox::tr("steep: one pixel further changes it by more");
  if ((limits & kDoubtfulLight) != 0) words << PointsBox::tr("doubtful light");
  return words.isEmpty() ? QString() : PointsBox::tr(" (%1)").arg(joined(words));
}

std::uint8_t limits_at(const InspectedFrame& frame, const FaceSample& position) {
  const int u = static_cast<int>(std::lround(position.pixel.x));
  const int v = static_cast<int>(std::lround(position.pixel.y));
  const bool is_known = cv::Rect({}, frame.limits.size()).contains({u, v});
  return static_cast<std::uint8_t>(limit_of_flag(position.flag) |
                                   (is_known ? frame.limits.at<std::uint8_t>(v, u) : 0));
}

QString depth_text(const InspectedFrame& frame, const FaceSample& position) {
  if (!position.depth_mm) {
    if (position.flag == kTooDark) return PointsBox::tr("no depth: too dark");
    if (position.flag == kSaturated) return PointsBox::tr("no depth: too bright");
    return PointsBox::tr("no depth: near the face's edge");
  }
  const QString text = is_at_limit(position.flag)
                           ? limit_and_sd(*position.depth_mm, position.sd_mm, 2)
                           : number_and_sd(*position.depth_mm, position.sd_mm, 2);
  return PointsBox::tr("depth %1 mm").arg(text) + limits_text(limits_at(frame, position));
}

QString position_text(const InspectedFrame& frame, const QString& name, const FacePosition& at_mm) {
  const auto pixel = pixel_of(frame, at_mm);
  const auto found =
      pixel ? sample_face(frame.result, frame.face, frame.sd_mm, *pixel) : std::nullopt;
  if (!found) return PointsBox::tr("<b>%1</b>: off the face").arg(name);
  const Eigen::Vector3d at = found->point_mm();
  return PointsBox::tr("<b>%1</b>: x %2, y %3, z %4 mm")
             .arg(name, hundredths(at.x()), hundredths(at.y()), hundredths(at.z())) +
         QStringLiteral("<br>") + depth_text(frame, *found);
}

QString apart_text(const InspectedFrame& frame, const FacePosition& from, const FacePosition& to) {
  const auto a = pixel_of(frame, from), b = pixel_of(frame, to);
  if (!a || !b) return {};
  const auto distance = distance_between(frame.result, frame.face, *a, *b);
  if (!distance) return {};
  const Eigen::Vector3d& by = distance->apart_mm;
  return PointsBox::tr("<b>A to B</b>: %1 mm straight, %2 mm along the face")
             .arg(hundredths(distance->straight_mm), hundredths(distance->along_face_mm)) +
         QStringLiteral("<br>") +
         PointsBox::tr("offset x %1, y %2, z %3 mm")
             .arg(hundredths(by.x()), hundredths(by.y()), hundredths(by.z()));
}

}  // namespace

QString reading_text(const InspectedFrame& frame, const std::optional<FacePosition>& a,
                     const std::optional<FacePosition>& b) {
  QStringList parts;
  if (a) parts << position_text(frame, QStringLiteral("A"), *a);
  if (b) parts << position_text(frame, QStringLiteral("B"), *b);
  if (a && b) parts << apart_text(frame, *a, *b);
  parts.removeAll(QString());
  return parts.isEmpty()
             ? PointsBox::tr("Click on the face for point A, with the right button for point B.")
             : parts.join(QStringLiteral("<br>"));
}

namespace {

/// For a finger without calibration.
std::optional<FaceSample> contact_free_reading(const InspectedFrame& frame, cv::Point2d pixel) {
  if (!frame.result.shape) return std::nullopt;
  const FaceShape& shape = *frame.result.shape;
  const int u = static_cast<int>(std::lround(pixel.x)), v = static_cast<int>(std::lround(pixel.y));
  if (u < 0 || u >= shape.width_px()) return std::nullopt;
  const auto rows = shape.rows(u, 0);
  const auto local = shape.at(pixel.x, pixel.y);
  if (v < rows.first || v > rows.last || !local) return std::nullopt;
  FaceSample position;
  position.pixel = pixel;
  position.untouched_mm = untouched_point_mm(*local, frame.face.layer_mm, MappingAlong::kZ);
  return position;
}

}  // namespace

std::optional<ProbeText> probe_text(const InspectedFrame& frame, cv::Point2d pixel) {
  auto position = sample_face(frame.result, frame.face, frame.sd_mm, pixel);
  if (!position && !frame.result.depth) position = contact_free_reading(frame, pixel);
  if (!position) return std::nullopt;
  const Eigen::Vector2d on_face =
      frame.result.shape->position_mm(position->pixel.x, position->pixel.y);
  const Eigen::Vector3d at = position->point_mm();
  return ProbeText{
      frame.result.depth ? depth_text(frame, *position) : PointsBox::tr("not calibrated: no depth"),
      PointsBox::tr("%1 mm along, %2 mm across; x %3, y %4, z %5 mm")
          .arg(plain_number(on_face.x(), 1), plain_number(on_face.y(), 1))
          .arg(hundredths(at.x()), hundredths(at.y()), hundredths(at.z()))};
}

QString deepest_text(const InspectedFrame& frame) {
  if (!frame.result.depth) return {};
  if (frame.result.regions.empty()) return PointsBox::tr("Nothing presses on the face.");
  const ContactRegion& region = frame.result.regions.front();
  const Eigen::Vector3d& at = region.position_mm;
  const QString deepest = (region.limits & kLayerLimit) != 0
                              ? limit_and_sd(region.deepest_mm, {}, 2)
                              : hundredths(region.deepest_mm);
  return PointsBox::tr("Deepest %1 mm; contact at x %2, y %3, z %4 mm.")
      .arg(deepest, plain_number(at.x(), 1), plain_number(at.y(), 1), plain_number(at.z(), 1));
}

SurfaceBox::SurfaceBox(QWidget* parent)
    : Translated(parent),
      hint_(wrapped_label()),
      form_label_(new QLabel),
      lambda_label_(new QLabel),
      form_(new QComboBox),
      lambda_(new NumberField),
      table_(new QTableWidget(0, 2)),
      add_(new QPushButton),
      copy_text_(new QPushButton),
      copy_(new QPushButton) {
  table_->horizontalHeader()->hide();
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setTabKeyNavigation(false);
  table_->setShowGrid(false);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  form_->setObjectName(QStringLiteral("roughness_form"));
  lambda_->setObjectName(QStringLiteral("lambda_c"));
  for (int degree = 1; degree <= kMaxFormDegree; ++degree) form_->addItem({});
  lambda_->setRange(kNoLambda_mm, kLongestLambda_mm);
  lambda_->setSingleStep(0.1);
  lambda_->set_shown_decimals(2);
  auto* column = new QVBoxLayout(this);
  column->addWidget(hint_);
  column->addWidget(table_);
  auto* filter = new QGridLayout;
  filter->addWidget(form_label_, 0, 0);
  filter->addWidget(form_, 0, 1);
  filter->addWidget(lambda_label_, 1, 0);
  filter->addWidget(lambda_, 1, 1);
  filter->setColumnStretch(1, 1);
  form_label_->setBuddy(form_);
  lambda_label_->setBuddy(lambda_);
  column->addLayout(filter);
  auto* buttons = new QGridLayout;
  buttons->addWidget(add_, 0, 0, 1, 2);
  buttons->addWidget(copy_text_, 1, 0);
  buttons->addWidget(copy_, 1, 1);
  column->addLayout(buttons);
  for (QWidget* widget : std::initializer_list<QWidget*>{form_label_, form_, lambda_label_, lambda_,
                                                         add_, copy_text_, copy_})
    reserve_room(*widget);  // its width is the panel's before there are readings
  connect_parts();
  say([this] { name_parts(); });
}

void SurfaceBox::connect_parts() {
  connect(table_, &QTableWidget::itemSelectionChanged, this, &SurfaceBox::follow_selection);
  connect(form_, &QComboBox::activated, this, [this](int index) {
    InspectOptions next = options_;
    next.filter.form_degree = index + 1;
    Q_EMIT changed(
        next, [] { return tr("change the form that is no roughness"); }, -1);
  });
  connect(lambda_, &NumberField::valueChanged, this, [this](double value) {
    InspectOptions next = options_;
    next.filter.lambda_c_mm = value > kNoLambda_mm ? std::optional(value) : std::nullopt;
    Q_EMIT changed(
        next, [] { return tr("change the roughness' longest wavelength"); }, kLambda);
  });
  connect(add_, &QPushButton::clicked, this, [this] {
    Q_EMIT add_requested(readings_[static_cast<std::size_t>(table_->currentRow())].what);
  });
  connect(copy_text_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(text_of(readings_)); });
  connect(copy_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(csv_of(readings_)); });
}

void SurfaceBox::name_parts() {
  setTitle(tr("Between A and B"));
  hint_->setText(
      tr("Two points span a box: a ball's radius, area, volume and roughness inside; distance, "
         "step and angle from A to B."));
  form_label_->setText(tr("Roughness without"));
  const QStringList forms{tr("a plane"), tr("a form of degree 2"), tr("a form of degree 3"),
                          tr("a form of degree 4")};
  for (int i = 0; i < form_->count(); ++i) form_->setItemText(i, forms[i]);
  form_->setAccessibleName(tr("Form that is no roughness"));
  form_->setToolTip(
      tr("Bends of the finger and of the pressing object do not count as roughness."));
  lambda_label_->setText(tr("Wavelengths up to"));
  lambda_->setSuffix(tr(" mm"));
  lambda_->setSpecialValueText(tr("all"));
  lambda_->setAccessibleName(tr("Longest wavelength of roughness"));
  lambda_->setToolTip(
      tr("Lambda c: longer waves do not count as roughness (Gaussian filter, ISO 16610-61). Usual: "
         "0.25, 0.8, 2.5 mm."));
  add_->setText(tr("Add to recipe"));
  add_->setToolTip(tr("The selected reading, at these positions, becomes part of the recipe"));
  copy_text_->setText(tr("Copy as text"));
  copy_text_->setToolTip(tr("Puts the readings with their units on the clipboard"));
  copy_->setText(tr("Copy as CSV"));
  copy_->setToolTip(tr("Puts the readings on the clipboard for a spreadsheet"));
  table_->setAccessibleName(tr("Measured between the points"));
  fill();
}

void SurfaceBox::set_options(const InspectOptions& options) {
  options_ = options;
  const QSignalBlocker quiet(lambda_);
  form_->setCurrentIndex(options.filter.form_degree - 1);
  lambda_->setValue(options.filter.lambda_c_mm.value_or(kNoLambda_mm));
}

void SurfaceBox::show_readings(const std::shared_ptr<const InspectedFrame>& frame,
                               const std::optional<cv::Point2d>& a,
                               const std::optional<cv::Point2d>& b) {
  readings_ = frame && a && b ? surface_readings(*frame, *a, *b, options_.filter)
                              : std::vector<SurfaceReading>{};
  fill();
}

void SurfaceBox::fill() {
  hint_->setVisible(readings_.empty());
  table_->setVisible(!readings_.empty());
  for (QWidget* widget : std::initializer_list<QWidget*>{form_label_, form_, lambda_label_, lambda_,
                                                         add_, copy_text_, copy_})
    widget->setVisible(!readings_.empty());
  table_->setRowCount(static_cast<int>(readings_.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const auto& [what, reading] = readings_[static_cast<std::size_t>(row)];
    auto* name = new QTableWidgetItem(name_of(what));
    if (what == Measurand::kRoughness) name->setToolTip(filter_text(options_.filter));
    if (what == Measurand::kSectionWidth) name->setToolTip(tr("At half of its depth"));
    auto* value = new QTableWidgetItem(value_text(what, reading));
    if (!reading.measured) value->setToolTip(window_sentence(reading.reason));
    table_->setItem(row, 0, name);
    table_->setItem(row, 1, value);
  }
  table_->resizeRowsToContents();
  int height = 2 * table_->frameWidth();
  for (int row = 0; row < table_->rowCount(); ++row) height += table_->rowHeight(row);
  table_->setFixedHeight(height);
  follow_selection();
}

void SurfaceBox::follow_selection() {
  add_->setEnabled(table_->currentRow() >= 0 && !table_->selectedItems().isEmpty());
}

std::vector<SurfaceReading> surface_readings(const InspectedFrame& frame, cv::Point2d a,
                                             cv::Point2d b, const RoughnessFilter& filter) {
  if (!frame.result.depth || !frame.mapping) return {};
  FaceReader read(face_of(frame), a, b, filter);
  std::vector<SurfaceReading> all;
  for (const Measurand what : all_measurands()) all.push_back({what, read(what)});
  return all;
}

QString name_of(Measurand what) {
  switch (what) {
    case Measurand::kDistance:
      return SurfaceBox::tr("Distance A to B");
    case Measurand::kRadius:
      return SurfaceBox::tr("Ball's radius");
    case Measurand::kArea:
      return SurfaceBox::tr("Pressed area");
    case Measurand::kVolume:
      return SurfaceBox::tr("Volume");
    case Measurand::kMeanDepth:
      return SurfaceBox::tr("Mean depth");
    case Measurand::kRoughness:
      return SurfaceBox::tr("Roughness Sq");
    case Measurand::kStep:
      return SurfaceBox::tr("Step from A to B");
    case Measurand::kSectionDepth:
      return SurfaceBox::tr("Section's depth");
    case Measurand::kSectionWidth:
      return SurfaceBox::tr("Section's width");
    case Measurand::kSectionArea:
      return SurfaceBox::tr("Section's area");
    case Measurand::kAngle:
      break;
  }
  return SurfaceBox::tr("Angle from A to B");
}

QString filter_text(const RoughnessFilter& filter) {
  QStringList words;
  if (filter.form_degree != RoughnessFilter().form_degree)
    words << SurfaceBox::tr("without a form of degree %1").arg(filter.form_degree);
  if (filter.lambda_c_mm)
    words << SurfaceBox::tr("wavelengths up to %1 mm").arg(plain_number(*filter.lambda_c_mm, 2));
  return listed(words);
}

QString unit_text(Measurand what) {
  switch (what) {
    case Measurand::kArea:
    case Measurand::kSectionArea:
      return QStringLiteral("mm²");
    case Measurand::kVolume:
      return QStringLiteral("mm³");
    case Measurand::kAngle:
      return QStringLiteral("°");
    default:
      return QStringLiteral("mm");
  }
}

int decimals_of(Measurand what) {
  if (what == Measurand::kRoughness) return 4;
  return what == Measurand::kArea || what == Measurand::kAngle ? 2 : 3;
}

QString value_text(Measurand what, const FaceReading& reading) {
  if (!reading.measured) return SurfaceBox::tr("–");
  const auto& [value, sd] = *reading.measured;
  const int decimals = decimals_of(what);
  return QStringLiteral("%1 %2").arg(reading.is_lower_bound ? limit_and_sd(value, sd, decimals)
                                                            : number_and_sd(value, sd, decimals),
                                     unit_text(what));
}

QString text_of(const std::vector<SurfaceReading>& readings) {
  QString text;
  for (const SurfaceReading& reading : readings)
    if (reading.reading.measured)
      text += labelled(name_of(reading.what), value_text(reading.what, reading.reading)) +
              QLatin1Char('\n');
  return text;
}

QString csv_of(const std::vector<SurfaceReading>& readings) {
  QStringList lines{QStringLiteral("name,value,sd,unit,limits")};
  for (const auto& [what, reading] : readings) {
    if (!reading.measured) continue;
    const double sd = reading.measured->sd;
    lines << QStringLiteral("\"%1\",%2,%3,%4,%5")
                 .arg(name_of(what))
                 .arg(reading.measured->value, 0, 'g', 8)
                 .arg(sd_kind(sd, 0) == SdKind::kUnknown ? QString() : QString::number(sd, 'g', 4))
                 .arg(unit_text(what))
                 .arg(reading.is_lower_bound ? QStringLiteral("layer_limit") : QString());
  }
  return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void SectionPlot::set_profiles(Profile profile, std::optional<Profile> other) {
  profile_ = std::move(profile);
  other_ = std::move(other);
  rebuild();
}

QString SectionPlot::csv() const {
  const auto number = [](double value) {
    return std::isfinite(value) ? QString::number(value, 'g', 8) : QString();
  };
  /// Depth of `other`, linearly interpolated between its own positions.
  const auto other_at = [&](double along_mm) {
    if (!other_) return std::numeric_limits<double>::quiet_NaN();
    const auto& all = other_->along_mm;
    const auto next = std::lower_bound(all.begin(), all.end(), along_mm);
    if (next == all.end()) return std::numeric_limits<double>::quiet_NaN();
    const auto i = static_cast<std::size_t>(next - all.begin());
    if (i == 0 || all[i] == along_mm) return other_->depth_mm[i];
    const double part = (along_mm - all[i - 1]) / (all[i] - all[i - 1]);
    return (1 - part) * other_->depth_mm[i - 1] + part * other_->depth_mm[i];
  };
  QString text = QStringLiteral("along_mm,depth_mm,sd_mm") +
                 (other_ ? QStringLiteral(",other_depth_mm\n") : QStringLiteral("\n"));
  for (std::size_t i = 0; i < profile_.along_mm.size(); ++i) {
    text += number(profile_.along_mm[i]) + QLatin1Char(',') + number(profile_.depth_mm[i]) +
            QLatin1Char(',') + number(profile_.sd_mm[i]);
    if (other_) text += QLatin1Char(',') + number(other_at(profile_.along_mm[i]));
    text += QLatin1Char('\n');
  }
  return text;
}

QString SectionPlot::title() const { return tr("Depth from A to B"); }

QString SectionPlot::empty_text() const { return tr("Choose two points, A and B"); }

bool SectionPlot::draw() {
  if (profile_.along_mm.size() < 2) return false;
  const auto vector_of = [](const std::vector<double>& values) {
    return QVector<double>(values.begin(), values.end());
  };
  double top = 0.1, low = 0;
  const auto widen = [&](const std::vector<double>& depths) {
    for (const double depth : depths) {
      if (!std::isfinite(depth)) continue;
      top = std::max(top, 1.15 * depth);
      low = std::min(low, 1.15 * depth);
    }
  };
  widen(profile_.depth_mm);
  // One standard deviation on each side.
  auto* upper = chart().addGraph();
  auto* lower = chart().addGraph();
  for (std::size_t i = 0; i < profile_.along_mm.size(); ++i) {
    upper->addData(profile_.along_mm[i], profile_.depth_mm[i] + profile_.sd_mm[i]);
    lower->addData(profile_.along_mm[i], profile_.depth_mm[i] - profile_.sd_mm[i]);
  }
  QColor band = role_colour(ColourRole::kMeasured, palette());
  band.setAlpha(60);
  upper->setPen(Qt::NoPen);
  lower->setPen(Qt::NoPen);
  upper->setBrush(band);
  upper->setChannelFillGraph(lower);
  auto* line = chart().addGraph();
  line->setData(vector_of(profile_.along_mm), vector_of(profile_.depth_mm), true);
  line->setPen(QPen(role_colour(ColourRole::kMeasured, palette()), 2));
  if (other_) {
    auto* second = chart().addGraph();
    second->setData(vector_of(other_->along_mm), vector_of(other_->depth_mm), true);
    second->setPen(QPen(role_colour(ColourRole::kExpected, palette()), 2, Qt::DashLine));
    widen(other_->depth_mm);
    for (auto* hidden : {upper, lower}) hidden->removeFromLegend();
    line->setName(tr("shown"));
    second->setName(other_name_);
    show_legend();
  }
  chart().xAxis->setRange(0, profile_.along_mm.back());
  chart().yAxis->setRange(low, top);
  chart().xAxis->setLabel(tr("From A along the face (mm)"));
  chart().yAxis->setLabel(tr("Depth (mm)"));
  return true;
}

}  // namespace alltact
