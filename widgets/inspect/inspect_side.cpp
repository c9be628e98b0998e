#include "widgets/inspect/inspect_side.h"

#include "widgets/inspect/reading_text.h"
#include "widgets/scene3d/vtk_view.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

enum MergeId { kTop = 2001, kTimes, kPointA, kPointB };

QDoubleSpinBox* spin(double low, double high, double step, int decimals) {
  auto* box = new QDoubleSpinBox;
  box->setRange(low, high);
  box->setSingleStep(step);
  box->setDecimals(decimals);
  box->setKeyboardTracking(false);
  return box;
}

void set_entry_enabled(QComboBox& box, int index, bool is_enabled) {
  auto* model = qobject_cast<QStandardItemModel*>(box.model());
  model->item(index)->setEnabled(is_enabled);
}

}  // namespace

InspectSide::InspectSide(QWidget* parent)
    : Translated(parent),
      shown_as_label_(new QLabel),
      standpoint_label_(new QLabel),
      comparison_label_(new QLabel),
      top_label_(new QLabel),
      times_label_(new QLabel),
      shown_as_(new QComboBox),
      standpoint_(new QComboBox),
      comparison_(new QComboBox),
      top_(spin(0.1, 10, 0.1, 1)),
      times_(spin(1, 20, 1, 0)),
      untouched_(new QCheckBox),
      camera_(new QCheckBox),
      points_{{{&InspectOptions::a, new QLabel, spin(-1, 16384, 1, 0), spin(-1, 16384, 1, 0)},
               {&InspectOptions::b, new QLabel, spin(-1, 16384, 1, 0), spin(-1, 16384, 1, 0)}}},
      deepest_(new QPushButton),
      across_(new QPushButton),
      along_(new QPushButton),
      clear_(new QPushButton),
      reading_(new QLabel),
      profile_(new SectionPlot),
      surface_(new SurfaceBox) {
  comparison_->setObjectName(QStringLiteral("comparison"));
  deepest_->setObjectName(QStringLiteral("deepest"));
  across_->setObjectName(QStringLiteral("across"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  for (QGroupBox* group : {make_view_group(), make_points_group(), make_profile_group()})
    column->addWidget(group);
  column->addWidget(surface_);
  column->addStretch();
  connect_view();
  connect_points();
  say([this] {
    name_parts();
    name_points();
  });
  show_frame(nullptr);
}

QGroupBox* InspectSide::make_view_group() {
  view_group_ = new QGroupBox;
  auto* grid = new QGridLayout(view_group_);
  shown_as_->addItems({{}, {}});
  standpoint_->addItems({{}, {}, {}, {}});
  comparison_->addItems({{}, {}, {}});
  int row = 0;
  for (const auto& [label, widget] :
       std::initializer_list<std::pair<QLabel*, QWidget*>>{{shown_as_label_, shown_as_},
                                                           {standpoint_label_, standpoint_},
                                                           {comparison_label_, comparison_},
                                                           {top_label_, top_},
                                                           {times_label_, times_}}) {
    label->setBuddy(widget);
    grid->addWidget(label, row, 0);
    grid->addWidget(widget, row++, 1);
  }
  grid->addWidget(untouched_, row++, 0, 1, 2);
  grid->addWidget(camera_, row, 0, 1, 2);
  grid->setColumnStretch(1, 1);
  if (!VtkView::is_supported()) {
    set_entry_enabled(*shown_as_, 0, false);
    options_.shown_as = ShownAs::kHeightMap;
  }
  return view_group_;
}

QGroupBox* InspectSide::make_points_group() {
  points_group_ = new QGroupBox;
  auto* grid = new QGridLayout(points_group_);
  int row = 0;
  for (const Point& point : points_) {
    grid->addWidget(point.label, row, 0);
    grid->addWidget(point.u, row, 1);
    grid->addWidget(point.v, row++, 2);
    point.label->setBuddy(point.u);
  }
  auto* buttons = new QGridLayout;
  buttons->addWidget(deepest_, 0, 0);
  buttons->addWidget(clear_, 0, 1);
  buttons->addWidget(across_, 1, 0);
  buttons->addWidget(along_, 1, 1);
  grid->addLayout(buttons, row++, 0, 1, 3);
  reading_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  reading_->setWordWrap(true);
  constexpr int kLines = 7;  // nothing jumps while points come and go
  reading_->setMinimumHeight(kLines * reading_->fontMetrics().lineSpacing());
  reading_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  grid->addWidget(reading_, row, 0, 1, 3);
  return points_group_;
}

QGroupBox* InspectSide::make_profile_group() {
  profile_group_ = new QGroupBox;
  auto* layout = new QVBoxLayout(profile_group_);
  profile_->setMinimumHeight(170);
  layout->addWidget(profile_);
  return profile_group_;
}

void InspectSide::connect_view() {
  connect(shown_as_, &QComboBox::activated, this, [this](int index) {
    InspectOptions next = options_;
    next.shown_as = static_cast<ShownAs>(index + 1);
    Q_EMIT changed(next, tr("show as %1").arg(shown_as_->itemText(index)), -1);
  });
  connect(standpoint_, &QComboBox::activated, this, [this](int index) {
    InspectOptions next = options_;
    next.standpoint = static_cast<Standpoint>(index + 1);
    next.look.reset();
    Q_EMIT changed(next, tr("look from: %1").arg(standpoint_->itemText(index)), -1);
  });
  connect(comparison_, &QComboBox::activated, this, [this](int index) {
    InspectOptions next = options_;
    next.comparison = static_cast<Comparison>(index + 1);
    Q_EMIT changed(next, tr("compare: %1").arg(comparison_->itemText(index)), -1);
  });
  connect(top_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    InspectOptions next = options_;
    next.scene.top_mm = value;
    Q_EMIT changed(next, tr("change the depth colours"), kTop);
  });
  connect(times_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    InspectOptions next = options_;
    next.scene.times = value;
    Q_EMIT changed(next, tr("draw depth larger"), kTimes);
  });
  for (const auto& [box, member] :
       {std::pair{untouched_, &SceneOptions::untouched}, {camera_, &SceneOptions::camera}})
    connect(box, &QCheckBox::clicked, this, [this, box = box, member = member](bool is_on) {
      InspectOptions next = options_;
      next.scene.*member = is_on;
      const QString name = box->text().remove(QLatin1Char('&'));
      Q_EMIT changed(next, is_on ? tr("show %1").arg(name) : tr("hide %1").arg(name), -1);
    });
}

void InspectSide::connect_points() {
  int id = kPointA;
  for (const Point& point : points_) {
    for (QDoubleSpinBox* box : {point.u, point.v})
      connect(box, &QDoubleSpinBox::valueChanged, this, [this, point, id] {
        change_point(
            point.member, {std::max(0.0, point.u->value()), std::max(0.0, point.v->value())}, id);
      });
    ++id;
  }
  connect(deepest_, &QPushButton::clicked, this, [this] {
    if (const auto at = deepest()) change_point(&InspectOptions::a, *at, -1);
  });
  connect(across_, &QPushButton::clicked, this, [this] { lay_line(true); });
  connect(along_, &QPushButton::clicked, this, [this] { lay_line(false); });
  connect(clear_, &QPushButton::clicked, this, [this] {
    InspectOptions next = options_;
    next.a.reset();
    next.b.reset();
    Q_EMIT changed(next, tr("take the points away"), -1);
  });
}

void InspectSide::change_point(std::optional<cv::Point2d> InspectOptions::*point,
                               cv::Point2d to,
                               int id) {
  InspectOptions next = options_;
  next.*point = to;
  Q_EMIT changed(next, point == &InspectOptions::a ? tr("move point A") : tr("move point B"), id);
}

std::optional<cv::Point2d> InspectSide::deepest() const {
  if (!frame_ || !frame_->result.depth) return std::nullopt;
  cv::Mat depth = frame_->result.depth->depth_mm.clone();
  cv::patchNaNs(depth, -1);
  cv::Point at;
  double most = -1;
  cv::minMaxLoc(depth, nullptr, &most, nullptr, &at);
  if (most < 0) return std::nullopt;
  return cv::Point2d(at);
}

/// From edge to edge through point A, or through the deepest point.
void InspectSide::lay_line(bool is_across) {
  const auto through = options_.a ? options_.a : deepest();
  if (!through || !frame_ || !frame_->result.shape) return;
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
    next.a = cv::Point2d(u, rows.first);
    next.b = cv::Point2d(u, rows.last);
  } else {
    int first = u, last = u;
    while (first > 0 && holds(first - 1)) --first;
    while (last + 1 < shape.width_px() && holds(last + 1)) ++last;
    next.a = cv::Point2d(first, v);
    next.b = cv::Point2d(last, v);
  }
  Q_EMIT changed(next, is_across ? tr("cut across") : tr("cut along"), -1);
}

void InspectSide::name_parts() {
  view_group_->setTitle(tr("View"));
  shown_as_label_->setText(tr("Sho&w"));
  shown_as_->setItemText(0, tr("in 3D"));
  shown_as_->setItemText(1, tr("as a height map"));
  shown_as_->setToolTip(VtkView::is_supported()
                            ? QString()
                            : tr("3D needs OpenGL 3.2, which this screen does not offer."));
  standpoint_label_->setText(tr("Look &from"));
  standpoint_->setItemText(0, tr("inside, tilted"));
  standpoint_->setItemText(1, tr("the camera"));
  standpoint_->setItemText(2, tr("outside, tilted"));
  standpoint_->setItemText(3, tr("the side"));
  comparison_label_->setText(tr("Com&pare"));
  comparison_->setItemText(0, tr("with nothing"));
  comparison_->setItemText(1, tr("side by side"));
  comparison_->setItemText(2, tr("difference"));
  comparison_->setToolTip(
      tr("With the source paper's own formulas, on the same frame and the same finger."));
  const auto name = [](QComboBox* box, const QLabel* label) {
    box->setAccessibleName(label->text().remove(QLatin1Char('&')));
  };
  name(shown_as_, shown_as_label_);
  name(standpoint_, standpoint_label_);
  name(comparison_, comparison_label_);
  top_label_->setText(tr("Colours &end at"));
  top_->setSuffix(tr(" mm"));
  top_->setAccessibleName(tr("Depth at which the colours end"));
  times_label_->setText(tr("&Draw depth"));
  times_->setSuffix(tr(" times"));
  times_->setAccessibleName(tr("Times that depth is drawn larger than it is"));
  untouched_->setText(tr("&Untouched face as lines"));
  camera_->setText(tr("C&amera and its axes"));
}

void InspectSide::name_points() {
  profile_group_->setTitle(tr("Cross-section"));
  points_group_->setTitle(tr("Points"));
  const std::array<QString, 2> names{tr("Point &A"), tr("Point &B")};
  const std::array<std::array<QString, 2>, 2> spoken{
      {{tr("Point A, u"), tr("Point A, v")}, {tr("Point B, u"), tr("Point B, v")}}};
  for (std::size_t i = 0; i < points_.size(); ++i) {
    points_[i].label->setText(names[i]);
    points_[i].u->setPrefix(tr("u "));
    points_[i].v->setPrefix(tr("v "));
    points_[i].u->setSpecialValueText(tr("u ") + QChar(0x2013));
    points_[i].v->setSpecialValueText(tr("v ") + QChar(0x2013));
    points_[i].u->setSuffix(tr(" px"));
    points_[i].v->setSuffix(tr(" px"));
    points_[i].u->setAccessibleName(spoken[i][0]);
    points_[i].v->setAccessibleName(spoken[i][1]);
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

void InspectSide::set_options(const InspectOptions& options) {
  options_ = options;
  const QSignalBlocker quiet[] = {QSignalBlocker(top_),
                                  QSignalBlocker(times_),
                                  QSignalBlocker(points_[0].u),
                                  QSignalBlocker(points_[0].v),
                                  QSignalBlocker(points_[1].u),
                                  QSignalBlocker(points_[1].v)};
  shown_as_->setCurrentIndex(VtkView::is_supported() ? static_cast<int>(options.shown_as) - 1 : 1);
  standpoint_->setCurrentIndex(static_cast<int>(options.standpoint) - 1);
  comparison_->setCurrentIndex(static_cast<int>(options.shown_comparison()) - 1);
  top_->setValue(options.scene.top_mm);
  times_->setValue(options.scene.times);
  untouched_->setChecked(options.scene.untouched);
  camera_->setChecked(options.scene.camera);
  for (const Point& point : points_) {
    const auto& at = options.*point.member;
    point.u->setValue(at ? at->x : -1);  // -1: not chosen
    point.v->setValue(at ? at->y : -1);
  }
  const bool is_3d = shown_as_->currentIndex() == 0;
  for (QWidget* widget : std::initializer_list<QWidget*>{standpoint_, times_, untouched_, camera_})
    widget->setEnabled(is_3d);
  comparison_->setEnabled(!options.second);
  clear_->setEnabled(options.a || options.b);
  show_reading();
}

void InspectSide::show_frame(const std::shared_ptr<const InspectedFrame>& frame) {
  frame_ = frame;
  const bool has_depth = frame && frame->result.depth && frame->result.shape;
  for (QPushButton* button : {deepest_, across_, along_}) button->setEnabled(has_depth);
  if (has_depth) {
    for (const Point& point : points_) {
      const QSignalBlocker still(point.u), quiet(point.v);
      point.u->setMaximum(frame->result.grey.cols - 1);
      point.v->setMaximum(frame->result.grey.rows - 1);
    }
  }
  show_reading();
}

void InspectSide::show_reading() {
  if (!frame_ || !frame_->result.depth) {
    reading_->setText(tr("Nothing to measure yet."));
    surface_->show_readings(nullptr, {}, {});
    return profile_->set_profiles({}, std::nullopt);
  }
  reading_->setText(reading_text(*frame_, options_.a, options_.b));
  surface_->show_readings(frame_, options_.a, options_.b);
  if (!options_.a || !options_.b) return profile_->set_profiles({}, std::nullopt);
  std::optional<Profile> other;
  if (options_.shown_comparison() != Comparison::kNone && frame_->other)
    other = profile_between(*frame_->other, frame_->face, {}, *options_.a, *options_.b);
  profile_->set_profiles(
      profile_between(frame_->result, frame_->face, frame_->sd_mm, *options_.a, *options_.b),
      std::move(other));
}

}  // namespace alltact
