#include "widgets/plots/face_map_plot.h"

#include "core/image/colour_map.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

QCPColorGradient viridis_gradient() {
  constexpr int kSteps = 32;
  QCPColorGradient gradient;
  gradient.clearColorStops();
  for (int i = 0; i <= kSteps; ++i) {
    const double part = static_cast<double>(i) / kSteps;
    const MapColour colour = viridis(part);
    gradient.setColorStopAt(part, QColor(colour.red, colour.green, colour.blue));
  }
  gradient.setNanHandling(QCPColorGradient::nhTransparent);
  return gradient;
}

}  // namespace

FaceMapPlot::~FaceMapPlot() = default;

void FaceMapPlot::set_data(FaceMapData data) {
  data_ = std::move(data);
  rebuild();
}

void FaceMapPlot::enable_choice() {
  chart().setMouseTracking(true);
  connect(&chart(), &QCustomPlot::mouseMove, this, [this](QMouseEvent* event) {
    chart().setCursor(contact_at(event->position()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
  });
  connect(&chart(), &QCustomPlot::mousePress, this, [this](QMouseEvent* event) {
    const auto contact = contact_at(event->position());
    if (event->button() == Qt::LeftButton && contact) Q_EMIT contact_chosen(*contact);
  });
}

std::optional<std::size_t> FaceMapPlot::contact_at(const QPointF& pixel) const {
  const double along_mm = chart().xAxis->pixelToCoord(pixel.x());
  const double across_mm = chart().yAxis->pixelToCoord(pixel.y());
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < data_.contacts.size(); ++i) {
    const FaceMapData::Contact& contact = data_.contacts[i];
    const bool is_inside =
        std::hypot(along_mm - contact.along_mm, across_mm - contact.across_mm) <= contact.radius_mm;
    if (is_inside && (!found || contact.radius_mm < data_.contacts[*found].radius_mm)) found = i;
  }
  return found;
}

QString FaceMapPlot::title() const { return tr("%1 over the face").arg(data_.quantity); }

QString FaceMapPlot::empty_text() const { return tr("No data for the face yet"); }

void FaceMapPlot::draw_cells() {
  auto* map = new QCPColorMap(chart().xAxis, chart().yAxis);
  map->data()->setSize(data_.columns, data_.rows);
  const double cell_u = data_.length_mm / data_.columns, cell_v = data_.width_mm / data_.rows;
  map->data()->setRange(
      QCPRange(0.5 * cell_u, data_.length_mm - 0.5 * cell_u),
      QCPRange(-0.5 * data_.width_mm + 0.5 * cell_v, 0.5 * data_.width_mm - 0.5 * cell_v));
  double largest = 0;
  for (int row = 0; row < data_.rows; ++row)
    for (int column = 0; column < data_.columns; ++column) {
      const double value =
          data_.cells[static_cast<std::size_t>(std::ptrdiff_t{row} * data_.columns + column)];
      map->data()->setCell(column, row, value);
      if (std::isfinite(value)) largest = std::max(largest, value);
    }
  map->setInterpolate(false);
  map->setTightBoundary(false);
  auto* scale = new QCPColorScale(&chart());
  const int row = chart().plotLayout()->rowCount() - 1;  // that of the axes
  chart().plotLayout()->addElement(row, 1, scale);
  scale_ = scale;
  scale->setBarWidth(12);
  map->setColorScale(scale);
  map->setGradient(viridis_gradient());
  map->setDataRange(QCPRange(0, largest > 0 ? largest : 1));
  scale->axis()->setLabel(data_.quantity);
  add_axis(scale->axis());
  auto* group = new QCPMarginGroup(&chart());
  chart().axisRect()->setMarginGroup(QCP::msTop | QCP::msBottom, group);
  scale->setMarginGroup(QCP::msTop | QCP::msBottom, group);
}

void FaceMapPlot::add_circle(const FaceMapData::Contact& contact, const QPen& pen) {
  auto* circle = new QCPItemEllipse(&chart());
  circle->topLeft->setCoords(contact.along_mm - contact.radius_mm,
                             contact.across_mm - contact.radius_mm);
  circle->bottomRight->setCoords(contact.along_mm + contact.radius_mm,
                                 contact.across_mm + contact.radius_mm);
  circle->setPen(pen);
}

void FaceMapPlot::draw_contacts() {
  for (const FaceMapData::Contact& contact : data_.contacts) {
    const int width = contact.is_chosen || contact.is_target ? 3 : 1;
    // A light line below a dark one, or vice versa, shows on every colour of the map.
    add_circle(contact, QPen(palette().color(QPalette::Base), width + 2));
    add_circle(contact, QPen(palette().color(QPalette::Text), width));
    if (contact.is_target)
      add_circle(contact, QPen(role_colour(ColourRole::kExpected, palette()), width, Qt::DashLine));
    if (!contact.name.empty())
      add_note(contact.along_mm, contact.across_mm - contact.radius_mm,
               QString::fromStdString(contact.name), Qt::AlignHCenter | Qt::AlignBottom);
  }
}

/// Hatched where the value is unknown.
void FaceMapPlot::draw_face() {
  QColor nothing = palette().color(QPalette::Text);
  nothing.setAlpha(70);
  auto* face = new QCPItemRect(&chart());
  face->topLeft->setCoords(0, -0.5 * data_.width_mm);
  face->bottomRight->setCoords(data_.length_mm, 0.5 * data_.width_mm);
  face->setPen(QPen(palette().color(QPalette::Text), 1));
  face->setBrush(QBrush(nothing, Qt::BDiagPattern));
  face->setLayer(QStringLiteral("background"));
}

/// One mm is as long along the face as across it, so that contacts are circles. The room between
/// the axes depends on their numbers, and these on the room: two passes from the same start.
void FaceMapPlot::fit(const QSize& size) {
  if (scale_ == nullptr) return;
  chart().xAxis->setRange(0, data_.length_mm);
  chart().yAxis->setRange(-0.5 * data_.width_mm, 0.5 * data_.width_mm);
  QCPLayoutGrid* layout = chart().plotLayout();
  layout->setOuterRect(QRect(QPoint(), size));
  for (int pass = 0; pass < 2; ++pass) {
    for (const auto phase :
         {QCPLayoutElement::upPreparation, QCPLayoutElement::upMargins, QCPLayoutElement::upLayout})
      layout->update(phase);
    const QSize room = chart().axisRect()->size();
    if (room.isEmpty()) return;
    constexpr double kAround = 1.02;
    const double mm_per_px =
        kAround * std::max(data_.length_mm / room.width(), data_.width_mm / room.height());
    const double along = mm_per_px * room.width(), across = mm_per_px * room.height();
    chart().xAxis->setRange(0.5 * (data_.length_mm - along), 0.5 * (data_.length_mm + along));
    chart().yAxis->setRange(-0.5 * across, 0.5 * across);
  }
}

bool FaceMapPlot::draw() {
  if (scale_ != nullptr) {
    chart().plotLayout()->remove(static_cast<QCPColorScale*>(scale_));
    chart().plotLayout()->simplify();
    scale_ = nullptr;
  }
  const auto expected =
      static_cast<std::size_t>(data_.columns) * static_cast<std::size_t>(std::max(0, data_.rows));
  if (data_.columns < 1 || data_.rows < 1 || data_.cells.size() != expected ||
      !(data_.length_mm > 0) || !(data_.width_mm > 0))
    return false;
  draw_face();
  draw_cells();
  draw_contacts();
  chart().xAxis->setLabel(data_.has_base ? tr("Along the finger, from the base (mm)")
                                         : tr("Along the image, from the left (mm)"));
  chart().yAxis->setLabel(tr("Across (mm)"));
  chart().yAxis->setRangeReversed(true);  // as in the image, v grows downwards
  chart().xAxis->grid()->setVisible(false);
  chart().yAxis->grid()->setVisible(false);
  return true;
}

FaceCells::FaceCells(double length_mm, double width_mm, double cell_mm) {
  map_.length_mm = length_mm;
  map_.width_mm = width_mm;
  map_.columns = std::max(1, static_cast<int>(std::lround(length_mm / cell_mm)));
  map_.rows = std::max(1, static_cast<int>(std::lround(width_mm / cell_mm)));
  sums_.assign(static_cast<std::size_t>(map_.columns) * static_cast<std::size_t>(map_.rows), 0.0);
  counts_.assign(sums_.size(), 0);
}

void FaceCells::add(double along_mm, double across_mm, double value) {
  const double column = std::floor(along_mm / map_.length_mm * map_.columns);
  const double row = std::floor((across_mm / map_.width_mm + 0.5) * map_.rows);
  if (!(column >= 0 && column < map_.columns && row >= 0 && row < map_.rows)) return;
  const auto cell = static_cast<std::size_t>(row * map_.columns + column);
  sums_[cell] += value;
  ++counts_[cell];
}

FaceMapData FaceCells::map() const {
  FaceMapData map = map_;
  for (std::size_t i = 0; i < sums_.size(); ++i)
    map.cells.push_back(counts_[i] > 0 ? sums_[i] / counts_[i]
                                       : std::numeric_limits<double>::quiet_NaN());
  return map;
}

}  // namespace alltact
