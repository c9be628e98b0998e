#include "widgets/accuracy/accuracy_plot.h"

#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"
#include "widgets/widget_base.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QTextLayout>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr double kTimeMargin = 1.6;      // times the slowest point on the front
constexpr double kMaxBudgetRatio = 2.5;  // times that: largest extension to the line
constexpr double kHeadroom = 1.12;       // axis height as a multiple of the largest whisker
constexpr double kClickRadiusPx = 12;    // from a dot
constexpr double kDotPx = 9;
constexpr int kFocusPx = 2;

}  // namespace

AccuracyPlot::AccuracyPlot(QWidget* parent) : Plot(parent) {
  layout()->setContentsMargins(kFocusPx, kFocusPx, kFocusPx, kFocusPx);
  setFocusPolicy(Qt::StrongFocus);
  chart().setMouseTracking(true);
  connect(&chart(), &QCustomPlot::afterLayout, this, &AccuracyPlot::layout_labels_now);
  connect(&chart(), &QCustomPlot::mouseMove, this, &AccuracyPlot::hover);
  connect(&chart(), &QCustomPlot::mousePress, this, &AccuracyPlot::press);
}

void AccuracyPlot::set_points(std::vector<AccuracyPoint> points) {
  points_ = std::move(points);
  if (picked_ && *picked_ >= points_.size()) picked_.reset();
  announce();
  rebuild();
}

void AccuracyPlot::set_budget(double frames_per_s) {
  frames_per_s_ = frames_per_s;
  rebuild();
}

void AccuracyPlot::pick(std::optional<std::size_t> point) {
  if (point && *point >= points_.size()) point.reset();
  if (point == picked_) return;
  picked_ = point;
  announce();
  rebuild();
}

void AccuracyPlot::announce() {
  if (picked_)
    set_accessible_value(*this,
                         points_[*picked_].words + QLatin1Char('\n') + points_[*picked_].hint);
  else
    set_accessible_value(*this, empty_text());
}

QString AccuracyPlot::title() const { return tr("Error versus time per image"); }

QString AccuracyPlot::empty_text() const {
  return points_.empty() ? tr("Nothing has been measured yet") : tr("No setting is chosen");
}

std::vector<std::size_t> AccuracyPlot::front() const {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (points_[i].is_on_front) front.push_back(i);
  std::sort(front.begin(), front.end(),
            [&](std::size_t a, std::size_t b) { return points_[a].time_ms < points_[b].time_ms; });
  return front;
}

void AccuracyPlot::set_ranges() {
  // Limits the axes: far slower or worse points would squeeze the front into a corner.
  double slowest_ms = 0, worst_mm = 0;
  for (const AccuracyPoint& point : points_) {
    const bool matters =
        point.is_on_front || point.is_in_use || (picked_ && &points_[*picked_] == &point);
    if (!matters) continue;
    slowest_ms = std::max(slowest_ms, point.time_ms);
    worst_mm = std::max(worst_mm, point.p95_mm);
  }
  max_ms_ = std::max(kTimeMargin * slowest_ms, 1e-3);
  const double budget_ms = 1000 / frames_per_s_;
  if (budget_ms < kMaxBudgetRatio * slowest_ms) max_ms_ = std::max(max_ms_, 1.05 * budget_ms);
  max_mm_ = std::max(kHeadroom * worst_mm, 1e-4);
  chart().xAxis->setRange(0, max_ms_);
  chart().yAxis->setRange(0, max_mm_);
  chart().xAxis->setLabel(tr("Time per image on this computer (ms)"));
  chart().yAxis->setLabel(tr("Depth error (mm)"));
}

bool AccuracyPlot::is_shown(const AccuracyPoint& point) const {
  return point.time_ms <= max_ms_ && point.median_mm <= max_mm_;
}

bool AccuracyPlot::draw() {
  labels_.clear();
  if (points_.empty()) return false;
  set_ranges();
  draw_others();
  draw_front();
  draw_marks();
  draw_budget();
  draw_labels();
  chart().legend->setIconSize(32, 20);
  show_legend();
  return true;
}

void AccuracyPlot::draw_others() {
  QColor grey = palette().color(QPalette::Text);
  grey.setAlpha(90);
  auto* others = chart().addGraph();
  others->setName(tr("slower or worse than another"));
  others->setLineStyle(QCPGraph::lsNone);
  others->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, grey, grey, kDotPx - 3));
  int beyond = 0;
  for (const AccuracyPoint& point : points_) {
    if (!is_shown(point))
      ++beyond;
    else if (!point.is_on_front)
      others->addData(point.time_ms, point.median_mm);
  }
  if (beyond > 0)
    add_note(max_ms_, 0, tr("%n slower or worse, outside this figure", "", beyond),
             Qt::AlignRight | Qt::AlignBottom);
}

void AccuracyPlot::draw_front() {
  const QColor colour = role_colour(ColourRole::kMeasured, palette());
  auto* stairs = chart().addGraph();
  auto* dots = chart().addGraph();
  stairs->setLineStyle(QCPGraph::lsStepLeft);
  stairs->setPen(QPen(colour, 1.5));
  stairs->removeFromLegend();
  dots->setName(tr("best for its time; whisker up to 95 %"));
  dots->setLineStyle(QCPGraph::lsNone);
  dots->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, kDotPx));
  const auto along = front();
  double min_mm = std::numeric_limits<double>::infinity();  // smallest so far, by time
  for (const std::size_t i : along) {
    const AccuracyPoint& point = points_[i];
    min_mm = std::min(min_mm, point.median_mm);
    stairs->addData(point.time_ms, min_mm);
    dots->addData(point.time_ms, point.median_mm);
    auto* whisker = new QCPItemLine(&chart());
    whisker->start->setCoords(point.time_ms, point.median_mm);
    whisker->end->setCoords(point.time_ms, point.p95_mm);
    whisker->setHead(QCPLineEnding(QCPLineEnding::esBar, 7, 0));
    whisker->setPen(QPen(colour, 1));
  }
  if (!along.empty()) stairs->addData(max_ms_, min_mm);
}

void AccuracyPlot::draw_marks() {
  const QColor text = palette().color(QPalette::Text);
  const auto mark = [&](const QString& name, const QCPScatterStyle& style,
                        const AccuracyPoint& point) {
    auto* graph = chart().addGraph();
    graph->setName(name);
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setScatterStyle(style);
    graph->addData(point.time_ms, point.median_mm);
  };
  if (picked_)
    mark(tr("chosen"),
         QCPScatterStyle(QCPScatterStyle::ssDiamond, text,
                         role_colour(ColourRole::kChosen, palette()), 15),
         points_[*picked_]);
  for (const AccuracyPoint& point : points_)
    if (point.is_in_use)
      mark(tr("in use now"),
           QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(text, 2), Qt::NoBrush, 13), point);
}

void AccuracyPlot::draw_budget() {
  const double budget_ms = 1000 / frames_per_s_;
  const QColor colour = meaning_colour(Meaning::kBad, palette());
  const QString words = tr("%1 images per second").arg(QLocale().toString(frames_per_s_));
  if (budget_ms > max_ms_) {
    add_note(max_ms_, max_mm_,
             tr("%1: at %2 ms, further right →").arg(words, QLocale().toString(budget_ms, 'f', 1)),
             Qt::AlignRight | Qt::AlignTop);
    return;
  }
  auto* line = new QCPItemLine(&chart());
  line->start->setCoords(budget_ms, 0);
  line->end->setCoords(budget_ms, max_mm_);
  line->setPen(QPen(colour, 2, Qt::DashLine));
  const bool is_left = budget_ms < 0.5 * max_ms_;
  add_note(budget_ms, max_mm_, words, (is_left ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignTop);
}

QPointF AccuracyPlot::pixel_of(const AccuracyPoint& point) const {
  return {chart().xAxis->coordToPixel(point.time_ms), chart().yAxis->coordToPixel(point.median_mm)};
}

QPoint AccuracyPlot::dot_pixel(std::size_t point) const {
  return chart().mapTo(this, pixel_of(points_[point]).toPoint());
}

std::vector<std::optional<QPointF>> AccuracyPlot::dots() const {
  std::vector<QPointF> drawn;
  for (int i = 0; i < chart().graphCount(); ++i)
    if (chart().graph(i)->lineStyle() == QCPGraph::lsNone)
      for (const QCPGraphData& data : *chart().graph(i)->data())
        drawn.emplace_back(data.key, data.value);
  std::vector<std::optional<QPointF>> dots;
  for (const AccuracyPoint& point : points_) {
    const auto found = std::find_if(drawn.begin(), drawn.end(), [&](const QPointF& dot) {
      return dot.x() == point.time_ms && dot.y() == point.median_mm;
    });
    dots.push_back(found == drawn.end() ? std::nullopt : std::optional(*found));
  }
  return dots;
}

std::optional<std::size_t> AccuracyPlot::at(const QPointF& pixel) const {
  std::optional<std::size_t> nearest;
  double least = kClickRadiusPx;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!is_shown(points_[i])) continue;
    const QPointF off = pixel - pixel_of(points_[i]);
    // Of overlapping dots the one on the front wins.
    const double far = std::hypot(off.x(), off.y()) - (points_[i].is_on_front ? 3 : 0);
    if (far < least) least = far, nearest = i;
  }
  return nearest;
}

void AccuracyPlot::hover(QMouseEvent* event) {
  const auto point = at(event->position());
  chart().setCursor(point ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (!point) return QToolTip::hideText();
  QToolTip::showText(event->globalPosition().toPoint(),
                     points_[*point].words + QLatin1Char('\n') + points_[*point].hint, &chart());
}

void AccuracyPlot::press(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  if (event->button() != Qt::LeftButton) return;
  const auto point = at(event->position());
  if (!point) return;
  pick(point);
  Q_EMIT point_picked(*point);
}

void AccuracyPlot::walk(int steps) {
  const auto along = front();
  if (along.empty()) return;
  auto now = static_cast<int>(along.size()) - 1;
  if (picked_) {
    const double here_ms = points_[*picked_].time_ms;
    const auto found = std::find(along.begin(), along.end(), *picked_);
    now = 0;  // from a point off the front: as if from the next faster one on it
    for (std::size_t i = 0; i < along.size(); ++i)
      if (points_[along[i]].time_ms <= here_ms) now = static_cast<int>(i);
    if (found == along.end() && steps < 0) ++now;
  }
  const int next = std::clamp(now + steps, 0, static_cast<int>(along.size()) - 1);
  const std::size_t point = along[static_cast<std::size_t>(next)];
  pick(point);
  Q_EMIT point_picked(point);
}

void AccuracyPlot::keyPressEvent(QKeyEvent* event) {
  constexpr int kToTheEnd = 1 << 16;
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Up:
      return walk(-1);
    case Qt::Key_Right:
    case Qt::Key_Down:
      return walk(1);
    case Qt::Key_Home:
      return walk(-kToTheEnd);
    case Qt::Key_End:
      return walk(kToTheEnd);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (picked_) Q_EMIT point_activated();
      return;
    case Qt::Key_Escape:
      return void(Q_EMIT pick_cleared());
    default:
      Plot::keyPressEvent(event);
  }
}

void AccuracyPlot::paintEvent(QPaintEvent* event) {
  Plot::paintEvent(event);
  if (!hasFocus()) return;
  QPainter painter(this);
  painter.setPen(QPen(palette().color(QPalette::Highlight), kFocusPx));
  painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

namespace {

constexpr double kApart = 3;                                          // px, of two labels
constexpr std::array kDistances{9.0, 22.0, 38.0, 58.0, 84.0, 116.0};  // px
/// Direction from the dot to the label's middle: upwards first, where only whiskers are.
constexpr std::array<std::array<double, 2>, 8> kDirections{
    {{1, 0}, {1, -0.7}, {-1, -0.7}, {0.4, -1}, {-0.4, -1}, {-1, 0}, {1, 0.7}, {-1, 0.7}}};

QRectF box_next_to(const LabelRequest& label, const std::array<double, 2>& direction,
                   double distance) {
  const QPointF middle(label.dot.x() + direction[0] * (distance + 0.5 * label.size.width()),
                       label.dot.y() + direction[1] * (distance + 0.5 * label.size.height()));
  return {middle - QPointF(0.5 * label.size.width(), 0.5 * label.size.height()), label.size};
}

}  // namespace

std::vector<std::optional<QRectF>> layout_labels(const QRectF& room,
                                                 const std::vector<LabelRequest>& labels,
                                                 const std::vector<QRectF>& taken) {
  std::vector<QRectF> occupied = taken;
  std::vector<std::optional<QRectF>> boxes;
  const auto is_free = [&](const QRectF& box) {
    const QRectF wide = box.adjusted(-kApart, -kApart, kApart, kApart);
    return room.contains(box) &&
           std::none_of(occupied.begin(), occupied.end(),
                        [&](const QRectF& other) { return wide.intersects(other); });
  };
  for (const LabelRequest& label : labels) {
    std::optional<QRectF> found;
    for (const double distance : kDistances)
      for (const auto& direction : kDirections) {
        const QRectF box = box_next_to(label, direction, distance);
        if (!found && is_free(box)) found = box;
      }
    if (found) occupied.push_back(*found);
    boxes.push_back(found);
  }
  return boxes;
}

void AccuracyModel::set_points(std::vector<AccuracyPoint> points) {
  beginResetModel();
  points_ = std::move(points);
  endResetModel();
}

int AccuracyModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(points_.size());
}

int AccuracyModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QString AccuracyModel::title(int column) {
  switch (column) {
    case kSetting:
      return tr("Settings");
    case kTime:
      return tr("Time per image (ms)");
    case kMedian:
      return tr("Median depth error (mm)");
    case kP95:
      return tr("Depth error, 95 % within (mm)");
    case kPosition:
      return tr("Median position error (mm)");
    default:
      return tr("Rating");
  }
}

QVariant AccuracyModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return title(section);
}

QVariant AccuracyModel::number(const AccuracyPoint& point, int column) const {
  switch (column) {
    case kTime:
      return point.time_ms;
    case kMedian:
      return point.median_mm;
    case kP95:
      return point.p95_mm;
    case kPosition:
      return point.position_mm ? QVariant(*point.position_mm) : QVariant();
    default:
      return {};
  }
}

QString AccuracyModel::standing(const AccuracyPoint& point) const {
  QString words;
  if (point.is_on_front)
    words = tr("best for its time");
  else if (!point.is_proven)
    words = tr("loss not visible in these images");
  else if (point.dominated_by)
    words = tr("worse than: %1").arg(points_[*point.dominated_by].words);
  else
    words = tr("misses some images");
  return point.is_in_use ? tr("in use now; %1").arg(words) : words;
}

QVariant AccuracyModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const AccuracyPoint& point = points_[static_cast<std::size_t>(index.row())];
  const int column = index.column();
  const bool is_number = column >= kTime && column <= kPosition;
  if (role == kSortRole) {
    if (is_number) return number(point, column);
    return column == kSetting ? point.words : standing(point);
  }
  if (role == Qt::TextAlignmentRole && is_number)
    return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
  if (role == Qt::ToolTipRole) return point.hint;
  if (role != Qt::DisplayRole) return {};
  if (column == kSetting) return point.words;
  if (column == kStanding) return standing(point);
  const QVariant value = number(point, column);
  if (!value.isValid()) return QStringLiteral("–");
  return QLocale().toString(value.toDouble(), 'f', column == kTime ? 2 : 4);
}

AccuracyTable::AccuracyTable(QWidget* parent)
    : Translated(parent),
      model_(new AccuracyModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      view_(new QTableView),
      sort_label_(new QLabel),
      sort_(new QComboBox) {
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(AccuracyModel::kSortRole);
  view_->setModel(sorted_);
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setSelectionMode(QAbstractItemView::SingleSelection);
  view_->setTabKeyNavigation(false);
  view_->setWordWrap(false);
  view_->setSortingEnabled(true);
  view_->verticalHeader()->hide();
  view_->horizontalHeader()->setStretchLastSection(true);
  view_->horizontalHeader()->setDefaultAlignment(Qt::Alignment(Qt::AlignLeft | Qt::AlignVCenter) |
                                                 Qt::Alignment(Qt::TextWordWrap));
  auto* column = new QVBoxLayout(this);
  auto* line = new QHBoxLayout;
  sort_label_->setBuddy(sort_);
  line->addWidget(sort_label_);
  line->addWidget(sort_);
  line->addStretch();
  column->addLayout(line);
  column->addWidget(view_, 1);
  say([this] { name_parts(); });
  sort_by(AccuracyModel::kTime);
  connect(sort_, &QComboBox::activated, this, &AccuracyTable::sort_by);
  connect(view_->horizontalHeader(), &QHeaderView::sortIndicatorChanged, this,
          [this](int at) { sort_->setCurrentIndex(at); });
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& now) {
            if (!is_picking_ && now.isValid())
              Q_EMIT point_picked(static_cast<std::size_t>(sorted_->mapToSource(now).row()));
          });
  connect(view_, &QTableView::activated, this, &AccuracyTable::point_activated);
}

void AccuracyTable::name_parts() {
  sort_label_->setText(tr("S&ort by"));
  sort_->setAccessibleName(tr("Sort by"));
  sort_->setToolTip(tr("Order of the rows below"));
  view_->setAccessibleName(tr("Error versus time per image, as a table"));
  const int now = std::max(0, sort_->currentIndex());
  sort_->clear();
  for (int i = 0; i < AccuracyModel::kColumns; ++i) sort_->addItem(AccuracyModel::title(i));
  sort_->setCurrentIndex(now);
  Q_EMIT model_->headerDataChanged(Qt::Horizontal, 0, AccuracyModel::kColumns - 1);
}

void AccuracyTable::sort_by(int column) {
  view_->sortByColumn(column, Qt::AscendingOrder);
  sort_->setCurrentIndex(column);
}

namespace {

/// Size of a column's head with its words wrapped: as wide as its longest word, and at least as
/// wide as most numbers.
QSize wrapped_head(const QHeaderView& head, const QString& title) {
  constexpr int kMinWidth_px = 110;
  const QFontMetrics metrics = head.fontMetrics();
  const int margins = 2 * (head.style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, &head) +
                           head.style()->pixelMetric(QStyle::PM_HeaderMarkSize, nullptr, &head));
  int width = kMinWidth_px - margins;
  for (const QString& word : title.split(QLatin1Char(' ')))
    width = std::max(width, metrics.horizontalAdvance(word));
  const QRect text = metrics.boundingRect(QRect(0, 0, width, 1000), Qt::TextWordWrap, title);
  return {width + margins, text.height() + metrics.height()};
}

}  // namespace

void AccuracyTable::set_points(const std::vector<AccuracyPoint>& points) {
  is_picking_ = true;
  model_->set_points(points);
  view_->resizeColumnsToContents();
  view_->setColumnWidth(AccuracyModel::kSetting,
                        std::min(360, view_->columnWidth(AccuracyModel::kSetting)));
  const int line = view_->fontMetrics().height();
  int head_px = 0;
  for (int i = AccuracyModel::kTime; i <= AccuracyModel::kPosition; ++i) {
    const QSize head = wrapped_head(*view_->horizontalHeader(), AccuracyModel::title(i));
    view_->setColumnWidth(i, head.width());
    head_px = std::max(head_px, head.height());
  }
  view_->horizontalHeader()->setFixedHeight(head_px);
  view_->verticalHeader()->setDefaultSectionSize(line + 8);
  is_picking_ = false;
}

void AccuracyTable::pick(std::optional<std::size_t> point) {
  is_picking_ = true;
  if (point)
    view_->setCurrentIndex(sorted_->mapFromSource(model_->index(static_cast<int>(*point), 0)));
  else
    view_->clearSelection();
  is_picking_ = false;
}

// The labels of AccuracyPlot.

namespace {

constexpr double kNamedApartPx = 12;  // nearer dots share the label of their neighbour
constexpr double kLabelWidthPx = 170;

QString in_lines(const QString& text, const QFont& font) {
  QTextLayout layout(text, font);
  layout.beginLayout();
  QStringList lines;
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(kLabelWidthPx);
    lines << text.mid(line.textStart(), line.textLength()).trimmed();
  }
  layout.endLayout();
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

// The picked one, the one in use, and the front from its accurate end on, without near neighbours.
std::vector<std::size_t> AccuracyPlot::named() const {
  std::vector<std::size_t> named;
  const auto add = [&](std::size_t point, bool must) {
    if (named.size() >= kMaxLabels || !is_shown(points_[point]) ||
        std::find(named.begin(), named.end(), point) != named.end())
      return;
    const QPointF here = pixel_of(points_[point]);
    const bool is_apart = std::all_of(named.begin(), named.end(), [&](std::size_t other) {
      const QPointF off = here - pixel_of(points_[other]);
      return std::hypot(off.x(), off.y()) > kNamedApartPx;
    });
    if (must || is_apart) named.push_back(point);
  };
  if (picked_) add(*picked_, true);
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (points_[i].is_in_use) add(i, true);
  const auto along = front();
  if (!along.empty()) add(along.front(), false);
  for (auto at = along.rbegin(); at != along.rend(); ++at) add(*at, false);
  return named;
}

void AccuracyPlot::draw_labels() {
  for (std::size_t i = 0; i < kMaxLabels; ++i) {
    Label label{0, new QCPItemText(&chart()), new QCPItemLine(&chart())};
    label.text->position->setType(QCPItemPosition::ptAbsolute);
    label.text->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    label.text->setTextAlignment(Qt::AlignLeft);
    label.text->setFont(font());
    label.text->setColor(palette().color(QPalette::Text));
    label.text->setPadding(QMargins(2, 1, 2, 1));
    QColor ground = palette().color(QPalette::Base);
    ground.setAlpha(200);
    label.text->setBrush(ground);
    label.line->start->setType(QCPItemPosition::ptAbsolute);
    label.line->end->setType(QCPItemPosition::ptAbsolute);
    QColor faint = palette().color(QPalette::Text);
    faint.setAlpha(120);
    label.line->setPen(QPen(faint, 1));
    label.text->setVisible(false);
    label.line->setVisible(false);
    labels_.push_back(label);
  }
}

// Called after the layout of the axes: pixel coordinates are valid only then.
void AccuracyPlot::layout_labels_now() {
  if (labels_.empty()) return;
  const std::vector<std::size_t> points = named();
  const QFontMetricsF metrics(font());
  std::vector<LabelRequest> requests;
  std::vector<QString> words;
  for (const std::size_t point : points) {
    words.push_back(in_lines(points_[point].words, font()));
    const QSizeF size = metrics.boundingRect(QRectF(0, 0, 1000, 1000), 0, words.back()).size();
    requests.push_back({pixel_of(points_[point]), size + QSizeF(6, 4)});
  }
  std::vector<QRectF> taken;
  for (const AccuracyPoint& point : points_) {
    if (!is_shown(point)) continue;
    const QPointF here = pixel_of(point);
    const double reach = point.is_on_front || point.is_in_use ? 6 : 2;
    taken.emplace_back(here - QPointF(reach, reach), QSizeF(2 * reach, 2 * reach));
    if (!point.is_on_front) continue;
    const double top = chart().yAxis->coordToPixel(point.p95_mm);
    taken.emplace_back(QPointF(here.x() - 1, top), QPointF(here.x() + 1, here.y()));
  }
  QRectF room = chart().axisRect()->rect();
  room.adjust(2, metrics.height() + 8, -2, -metrics.height() - 8);  // notes above and below
  const auto boxes = layout_labels(room, requests, taken);
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    Label& label = labels_[i];
    const bool is_there = i < boxes.size() && boxes[i];
    label.text->setVisible(is_there);
    label.line->setVisible(is_there);
    if (!is_there) continue;
    label.point = points[i];
    label.text->setText(words[i]);
    label.text->position->setCoords(boxes[i]->topLeft());
    const QPointF dot = requests[i].dot;
    label.line->start->setCoords(dot);
    label.line->end->setCoords(std::clamp(dot.x(), boxes[i]->left(), boxes[i]->right()),
                               std::clamp(dot.y(), boxes[i]->top(), boxes[i]->bottom()));
  }
}

std::vector<QRectF> AccuracyPlot::label_boxes() const {
  std::vector<QRectF> boxes;
  for (const Label& label : labels_)
    if (label.text->visible())
      boxes.emplace_back(label.text->topLeft->pixelPosition(),
                         label.text->bottomRight->pixelPosition());
  return boxes;
}

}  // namespace alltact
