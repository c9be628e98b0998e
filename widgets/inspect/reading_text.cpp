#include "widgets/inspect/reading_text.h"

#include "core/sensing/depth/depth_limits.h"
#include "core/sensing/measures.h"
#include "widgets/inspect/face_positions.h"
#include "widgets/joined_words.h"
#include "widgets/number_text.h"

#include <QCoreApplication>
#include <cmath>

namespace alltact {
namespace {

struct ReadingWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::ReadingWords)
 public:
  static QString number(double value, int digits = 2) { return plain_number(value, digits); }

  /// Limits of the depth, appended to its number; bits of DepthLimit.
  static QString limits(std::uint8_t limits) {
    QStringList words;
    if ((limits & kLayerLimit) != 0) words << tr("at the layer's limit");
    if ((limits & kBulgeTop) != 0) words << tr("a bulge at the layer's limit");
    if ((limits & kOutOfRange) != 0) words << tr("beyond what was calibrated");
    if ((limits & kSteep) != 0) words << tr("steep: a pixel sideways changes it by more");
    if ((limits & kDoubtfulLight) != 0) words << tr("doubtful light");
    return words.isEmpty() ? QString() : tr(" (%1)").arg(joined(words));
  }

  static QString depth(const InspectedFrame& frame, const FaceSample& position) {
    if (!position.depth_mm) {
      if (position.flag == kTooDark) return tr("no depth: too dark");
      if (position.flag == kSaturated) return tr("no depth: too bright");
      return tr("no depth: near the face's edge");
    }
    const QString text = is_at_limit(position.flag)
                             ? limit_and_sd(*position.depth_mm, position.sd_mm, 2)
                             : number_and_sd(*position.depth_mm, position.sd_mm, 2);
    return tr("depth %1 mm").arg(text) + limits(limits_at(frame, position));
  }

  static std::uint8_t limits_at(const InspectedFrame& frame, const FaceSample& position) {
    const int u = static_cast<int>(std::lround(position.pixel.x));
    const int v = static_cast<int>(std::lround(position.pixel.y));
    const bool is_known = cv::Rect({}, frame.limits.size()).contains({u, v});
    return static_cast<std::uint8_t>(limit_of_flag(position.flag) |
                                     (is_known ? frame.limits.at<std::uint8_t>(v, u) : 0));
  }

  static QString position(const InspectedFrame& frame,
                          const QString& name,
                          const FacePosition& at_mm) {
    const auto pixel = pixel_of(frame, at_mm);
    const auto found =
        pixel ? sample_face(frame.result, frame.face, frame.sd_mm, *pixel) : std::nullopt;
    if (!found) return tr("<b>%1</b>: off the face").arg(name);
    const Eigen::Vector3d at = found->point_mm();
    return tr("<b>%1</b>: x %2, y %3, z %4 mm")
               .arg(name, number(at.x()), number(at.y()), number(at.z())) +
           QStringLiteral("<br>") + depth(frame, *found);
  }

  static QString apart(const InspectedFrame& frame,
                       const FacePosition& from,
                       const FacePosition& to) {
    const auto a = pixel_of(frame, from), b = pixel_of(frame, to);
    if (!a || !b) return {};
    const auto distance = distance_between(frame.result, frame.face, *a, *b);
    if (!distance) return {};
    const Eigen::Vector3d& by = distance->apart_mm;
    return tr("<b>A to B</b>: %1 mm straight, %2 mm over the face")
               .arg(number(distance->straight_mm), number(distance->along_face_mm)) +
           QStringLiteral("<br>") +
           tr("by x %1, y %2, z %3 mm").arg(number(by.x()), number(by.y()), number(by.z()));
  }

  static QString deepest(const ContactRegion& region) {
    const Eigen::Vector3d& at = region.position_mm;
    const QString deepest = (region.limits & kLayerLimit) != 0
                                ? limit_and_sd(region.deepest_mm, {}, 2)
                                : number(region.deepest_mm);
    return tr("Deepest %1 mm; contact at x %2, y %3, z %4 mm.")
        .arg(deepest, number(at.x(), 1), number(at.y(), 1), number(at.z(), 1));
  }

  static ProbeText probe(const InspectedFrame& frame, const FaceSample& position) {
    const Eigen::Vector2d on_face =
        frame.result.shape->position_mm(position.pixel.x, position.pixel.y);
    const Eigen::Vector3d at = position.point_mm();
    return {frame.result.depth ? depth(frame, position) : tr("not calibrated: no depth"),
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
                     const std::optional<FacePosition>& a,
                     const std::optional<FacePosition>& b) {
  QStringList parts;
  if (a) parts << ReadingWords::position(frame, QStringLiteral("A"), *a);
  if (b) parts << ReadingWords::position(frame, QStringLiteral("B"), *b);
  if (a && b) parts << ReadingWords::apart(frame, *a, *b);
  parts.removeAll(QString());
  return parts.isEmpty() ? ReadingWords::hint() : parts.join(QStringLiteral("<br>"));
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
  return ReadingWords::probe(frame, *position);
}

QString deepest_text(const InspectedFrame& frame) {
  if (!frame.result.depth) return {};
  if (frame.result.regions.empty()) return ReadingWords::nothing();
  return ReadingWords::deepest(frame.result.regions.front());
}

}  // namespace alltact
