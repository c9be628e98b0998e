#include "widgets/calibrating/press_guide.h"

#include "calibration/presses/press.h"
#include "core/geometry/ball.h"
#include "widgets/calibrating/press_list.h"
#include "widgets/image/overlays.h"
#include "widgets/language.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <cmath>

namespace alltact {
namespace {

const QColor kTargetColour(255, 255, 255);
const QColor kHeldColour(47, 199, 155);     // bluish green, as for a measured contact
const QColor kTooDeepColour(240, 145, 90);  // orange
constexpr double kHoldRing = 26;            // logical pixels
constexpr int kCapPoints = 60;

struct GuideWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::GuideWords)
};

QString press_here_text(double depth_mm) {
  return GuideWords::tr("Press here, %1 mm deep").arg(local_mm(depth_mm, 1));
}

/// nullopt where the depth or the target is unknown.
std::optional<PressProgress> so_far_of(const PressGuidance& frame) {
  constexpr double kNearTarget_mm = 8;  // within this distance of the target its depth counts
  if (!frame.depth_mm || !frame.target || frame.lateral_offset_mm > kNearTarget_mm)
    return std::nullopt;
  return press_progress(*frame.depth_mm, frame.target->depth_mm, frame.layer_mm);
}

QString depth_words(const PressGuidance& frame) {
  if (!frame.depth_mm || !frame.target) return {};
  const QString depth = local_mm(*frame.depth_mm, 1);
  const auto so_far = so_far_of(frame);
  if (!so_far)
    return GuideWords::tr("now %1 mm, %2 mm from the target")
        .arg(depth, local_mm(frame.lateral_offset_mm, 0));
  switch (*so_far) {
    case PressProgress::kDeeper:
      return GuideWords::tr("now %1 mm: deeper").arg(depth);
    case PressProgress::kEnough:
      return GuideWords::tr("now %1 mm: enough, hold still").arg(depth);
    case PressProgress::kTooDeep:
      break;
  }
  return GuideWords::tr("now %1 mm: too deep").arg(depth);
}

/// Approximate depth along the normal: measured for a calibrated finger, else from the radius of
/// the dark disc.
std::optional<double> depth_now(const FrameResult& result, const std::optional<DarkPatch>& contact,
                                double radius_mm) {
  if (!contact) return std::nullopt;
  if (result.depth) {
    const auto local = result.shape->at(contact->pixel.x(), contact->pixel.y());
    return local ? std::optional(contact->darkness * local->cos_incline) : std::nullopt;
  }
  if (!(radius_mm > 0) || !(contact->disc_radius_mm > 0)) return std::nullopt;
  return disc_depth_mm(contact->disc_radius_mm, radius_mm);
}

/// The rim of a ball pressed in there, as projected into the image.
std::vector<Eigen::Vector2d> cap_outline(const FaceShape& shape, const Eigen::Vector2d& target_px,
                                         double depth_mm, double radius_mm) {
  const auto local = shape.at(target_px.x(), target_px.y());
  if (!local || !(radius_mm > depth_mm)) return {};
  const Face& face = shape.face();
  const Eigen::Vector3d top = untouched_point_mm(*local, face.layer_mm, MappingAlong::kNormal);
  const auto contact =
      ball_on_face(shape, face, top + (radius_mm - depth_mm) * local->normal, radius_mm);
  return contact ? contact_rim_px(shape.camera(), *contact, kCapPoints)
                 : std::vector<Eigen::Vector2d>();
}

/// Positions of the usable presses along and across the face, mm.
std::vector<Eigen::Vector2d> positions_of(const PressCollection& collection) {
  std::vector<Eigen::Vector2d> positions;
  for (const CollectedPress& press : collection.presses()) {
    if (!press.analysis.shape || !collection.is_usable(press)) continue;
    const auto& by_hand = collection.press_set().of(press.name).ball_mm;
    const auto& centre = by_hand ? by_hand : press.analysis.found_mm;
    const auto pixel =
        centre ? press.analysis.shape->camera().project(*centre) : std::optional<Eigen::Vector2d>();
    if (pixel) positions.push_back(press.analysis.shape->position_mm(pixel->x(), pixel->y()));
  }
  return positions;
}

Overlay target_overlay(const PressGuidance& frame) {
  return [frame, words = press_here_text(frame.target->depth_mm)](QPainter& painter,
                                                                  const ImageTransform& transform) {
    QPolygonF rim;
    for (const auto& p : frame.outline_px) rim << transform.to_widget({p.x(), p.y()});
    const QPointF at = transform.to_widget({frame.target_px->x(), frame.target_px->y()});
    QPainterPath path;
    if (rim.isEmpty())
      path.addEllipse(at, kHoldRing, kHoldRing);
    else
      path.addPolygon(rim), path.closeSubpath();
    path.moveTo(at - QPointF(8, 0));
    path.lineTo(at + QPointF(8, 0));
    path.moveTo(at - QPointF(0, 8));
    path.lineTo(at + QPointF(0, 8));
    stroke_over(painter, path, kTargetColour, 1.8, Qt::DashLine);
    const QRectF box = path.boundingRect();
    write_next_to(painter, QPointF(box.left(), box.bottom() + 6), words, kTargetColour);
  };
}

/// A ring around the contact that fills clockwise from the top, and the depth as text.
Overlay hold_overlay(const PressGuidance& frame) {
  const auto so_far = so_far_of(frame);
  const QString words = depth_words(frame);
  return [frame, so_far, words](QPainter& painter, const ImageTransform& transform) {
    const QPointF at = transform.to_widget({frame.contact->pixel.x(), frame.contact->pixel.y()});
    const QRectF ring(at - QPointF(kHoldRing, kHoldRing), QSizeF(2 * kHoldRing, 2 * kHoldRing));
    QPainterPath circle;
    circle.addEllipse(ring);
    stroke_over(painter, circle, QColor(150, 150, 150), 2);
    const QColor colour = so_far == PressProgress::kTooDeep ? kTooDeepColour : kHeldColour;
    if (frame.hold_fraction > 0) {
      QPainterPath part;
      part.arcMoveTo(ring, 90);
      part.arcTo(ring, 90, -360 * frame.hold_fraction);
      stroke_over(painter, part, colour, 5);
    }
    if (!words.isEmpty())
      write_next_to(painter, QPointF(at.x() - kHoldRing, at.y() - kHoldRing - 32), words, colour);
  };
}

}  // namespace

std::optional<PressTarget> target_press(const PressCollection& collection,
                                        const PressForecast& forecast, const FaceShape& shape) {
  const auto first = next_press(first_presses(shape), positions_of(collection));
  const FingerCalibration* known = forecast.baseline();
  if (const auto& newest = forecast.result()) known = newest.get();
  const bool is_settled = known != nullptr && known->calibration.next_press &&
                          (!first || known->calibration.next_press->enough);
  if (!is_settled) return first;
  const PressAdvice& advice = *known->calibration.next_press;
  if (advice.enough) return std::nullopt;
  if (!(advice.depth_mm > 0)) return first;
  return PressTarget{{advice.along_mm, advice.across_mm}, advice.depth_mm};
}

PressGuidance guidance_of(const FrameResult& result, const PressCollection& collection,
                          const PressForecast& forecast, double hold_fraction) {
  PressGuidance frame;
  if (!result.shape) return frame;
  const double radius_mm = collection.press_set().ball_radius_mm;
  frame.layer_mm = result.shape->face().layer_mm;
  frame.hold_fraction = hold_fraction;
  frame.target = target_press(collection, forecast, *result.shape);
  if (frame.target) {
    frame.target_px = pixel_of_position(*result.shape, frame.target->position_mm);
    if (frame.target_px && radius_mm > 0)
      frame.outline_px =
          cap_outline(*result.shape, *frame.target_px, frame.target->depth_mm, radius_mm);
  }
  frame.contact = dark_patch(result);
  frame.depth_mm = depth_now(result, frame.contact, radius_mm);
  if (frame.contact && frame.target)
    frame.lateral_offset_mm = (frame.contact->position_mm - frame.target->position_mm).norm();
  return frame;
}

QString guide_words(const PressGuidance& frame) {
  if (!frame.target) return GuideWords::tr("Enough presses: another would hardly help.");
  return as_sentence(joined({press_here_text(frame.target->depth_mm), depth_words(frame)}));
}

QString waiting_words(PressTaker::State state) {
  if (state == PressTaker::State::kIdle) return {};
  return state == PressTaker::State::kWaits
             ? GuideWords::tr("The press is taken once ball and finger are held still.")
             : GuideWords::tr("Not taken: hold ball and finger still for half a second.");
}

std::vector<Overlay> guide_overlays(const PressGuidance& frame) {
  std::vector<Overlay> overlays;
  if (frame.target && frame.target_px) overlays.push_back(target_overlay(frame));
  if (frame.contact) overlays.push_back(hold_overlay(frame));
  return overlays;
}

}  // namespace alltact
