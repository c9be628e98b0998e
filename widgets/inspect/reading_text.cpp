#include "widgets/inspect/reading_text.h"

#include "core/sensing/measures.h"
#include "widgets/inspect/face_places.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

namespace alltact {
namespace {

struct ReadingWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::ReadingWords)
 public:
  static QString number(double value, int digits = 2) {
    const double unit = std::pow(10, digits);
    // No "-0.0".
    return QLocale().toString(std::round(value * unit) / unit + 0.0, 'f', digits);
  }

  static QString depth(const PlaceReading& place) {
    if (!place.depth_mm) {
      if (place.flag == kTooDark) return tr("no depth: too dark");
      if (place.flag == kSaturated) return tr("no depth: too bright");
      return tr("no depth: near the face's edge");
    }
    QString text = place.sd_mm
                       ? tr("depth %1 ± %2 mm").arg(number(*place.depth_mm), number(*place.sd_mm))
                       : tr("depth %1 mm").arg(number(*place.depth_mm));
    if (place.flag == kExtrapolated) text += tr(" (beyond what was calibrated)");
    return text;
  }

  static QString place(const InspectedFrame& frame, const QString& name, const FacePlace& at_mm) {
    const auto pixel = pixel_of(frame, at_mm);
    const auto found =
        pixel ? read_place(frame.result, frame.face, frame.sd_mm, *pixel) : std::nullopt;
    if (!found) return tr("<b>%1</b>: off the face").arg(name);
    const Eigen::Vector3d at = found->point_mm();
    return tr("<b>%1</b>: x %2, y %3, z %4 mm")
               .arg(name, number(at.x()), number(at.y()), number(at.z())) +
           QStringLiteral("<br>") + depth(*found);
  }

  static QString apart(const InspectedFrame& frame, const FacePlace& from, const FacePlace& to) {
    const auto a = pixel_of(frame, from), b = pixel_of(frame, to);
    if (!a || !b) return {};
    const auto distance = distance_between(frame.result, frame.face, *a, *b);
    if (!distance) return {};
    const Eigen::Vector3d& by = distance->apart_mm;
    return tr("<b>A to B</b>: %1 mm straight, %2 mm over the face")
               .arg(number(distance->straight_mm), number(distance->over_face_mm)) +
           QStringLiteral("<br>") +
           tr("by x %1, y %2, z %3 mm").arg(number(by.x()), number(by.y()), number(by.z()));
  }

  static QString deepest(const ContactRegion& region) {
    const Eigen::Vector3d& at = region.place_mm;
    return tr("Deepest %1 mm; contact at x %2, y %3, z %4 mm.")
        .arg(number(region.deepest_mm), number(at.x(), 1), number(at.y(), 1), number(at.z(), 1));
  }

  static ProbeText probe(const InspectedFrame& frame, const PlaceReading& place) {
    const Eigen::Vector2d on_face = frame.result.shape->place_mm(place.pixel.x, place.pixel.y);
    const Eigen::Vector3d at = place.point_mm();
    return {frame.result.depth ? depth(place) : tr("not calibrated: no depth"),
            tr("%1 mm along, %2 mm across; x %3, y %4, z %5 mm")
                .arg(number(on_face.x(), 1), number(on_face.y(), 1))
                .arg(number(at.x()), number(at.y()), number(at.z()))};
  }

  static QString nothing() { return tr("Nothing presses on the face."); }
  static QString hint() {
    return tr("Click on the face for point A, with the right button for point B.");
  }
};

}  // namespace

QString reading_text(const InspectedFrame& frame,
                     const std::optional<FacePlace>& a,
                     const std::optional<FacePlace>& b) {
  QStringList parts;
  if (a) parts << ReadingWords::place(frame, QStringLiteral("A"), *a);
  if (b) parts << ReadingWords::place(frame, QStringLiteral("B"), *b);
  if (a && b) parts << ReadingWords::apart(frame, *a, *b);
  parts.removeAll(QString());
  return parts.isEmpty() ? ReadingWords::hint() : parts.join(QStringLiteral("<br>"));
}

namespace {

/// Of a finger without calibration.
std::optional<PlaceReading> untouched_place(const InspectedFrame& frame, cv::Point2d pixel) {
  if (!frame.result.shape) return std::nullopt;
  const FaceShape& shape = *frame.result.shape;
  const int u = static_cast<int>(std::lround(pixel.x)), v = static_cast<int>(std::lround(pixel.y));
  if (u < 0 || u >= shape.width_px()) return std::nullopt;
  const auto rows = shape.rows(u, 0);
  const auto local = shape.at(pixel.x, pixel.y);
  if (v < rows.first || v > rows.last || !local) return std::nullopt;
  PlaceReading place;
  place.pixel = pixel;
  place.untouched_mm = untouched_point_mm(*local, frame.face.layer_mm, MappingAlong::kZ);
  return place;
}

}  // namespace

std::optional<ProbeText> probe_text(const InspectedFrame& frame, cv::Point2d pixel) {
  auto place = read_place(frame.result, frame.face, frame.sd_mm, pixel);
  if (!place && !frame.result.depth) place = untouched_place(frame, pixel);
  if (!place) return std::nullopt;
  return ReadingWords::probe(frame, *place);
}

QString deepest_text(const InspectedFrame& frame) {
  if (!frame.result.depth) return {};
  if (frame.result.regions.empty()) return ReadingWords::nothing();
  return ReadingWords::deepest(frame.result.regions.front());
}

}  // namespace alltact
