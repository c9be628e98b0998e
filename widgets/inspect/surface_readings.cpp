#include "widgets/inspect/surface_readings.h"

#include "core/numerics/sd_text.h"
#include "core/sensing/surface/point_distance.h"
#include "core/sensing/surface/read_patch.h"
#include "widgets/joined_words.h"
#include "widgets/number_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kPressedMm = 0.05;  // smaller depths may be noise
constexpr int kAroundPx = 6;
constexpr std::size_t kVolume = 3, kMean = 4;  // indices of the readings

struct SurfaceWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::SurfaceWords)
 public:
  static QString distance() { return tr("Distance A to B"); }
  static QString radius() { return tr("Ball's radius"); }
  static QString area() { return tr("Pressed area"); }
  static QString volume() { return tr("Volume"); }
  static QString mean() { return tr("Mean depth"); }
  static QString rough() { return tr("Roughness Sq"); }
  static QString step() { return tr("Step from A to B"); }
  static QString angle() { return tr("Angle of A to B"); }
  static QString none() { return tr("–"); }
};

template <class T>
SurfaceReading reading(QString name,
                       const char* unit,
                       int decimals,
                       const Result<T>& found,
                       const MeasuredValue T::*member) {
  SurfaceReading reading{std::move(name), QString::fromUtf8(unit), {}, decimals, {}};
  if (found)
    reading.measured = (*found).*member;
  else
    reading.reason = found.error().what;
  return reading;
}

cv::Rect box_of(cv::Point2d a, cv::Point2d b) {
  const cv::Point first(static_cast<int>(std::lround(std::min(a.x, b.x))),
                        static_cast<int>(std::lround(std::min(a.y, b.y))));
  const cv::Point last(static_cast<int>(std::lround(std::max(a.x, b.x))),
                       static_cast<int>(std::lround(std::max(a.y, b.y))));
  return {first, last + cv::Point(1, 1)};
}

cv::Rect around(cv::Point2d at) {
  return box_of(at - cv::Point2d(kAroundPx, kAroundPx), at + cv::Point2d(kAroundPx, kAroundPx));
}

}  // namespace

std::vector<SurfaceReading> surface_readings(const InspectedFrame& frame,
                                             cv::Point2d a,
                                             cv::Point2d b) {
  if (!frame.result.depth || !frame.mapping) return {};
  const auto patch = [&](const cv::Rect& box) {
    return patch_in(frame.result, frame.face, *frame.mapping, frame.smoothing_px, box);
  };
  const SurfacePatch box_patch = patch(box_of(a, b));
  const auto ball = fit_ball(box_patch);
  const auto part = pressed_part(box_patch, kPressedMm);
  const auto rough = roughness(box_patch);
  const SurfaceLine line =
      line_between(frame.result, frame.face, *frame.mapping, frame.smoothing_px, a, b);
  const auto step = step_height(line.patch, line.along_mm);
  using W = SurfaceWords;
  SurfaceReading distance{W::distance(), QStringLiteral("mm"), {}, 3, {}};
  if (const auto apart = straight_distance(frame.result, frame.face, frame.sd_mm, a, b))
    distance.measured = *apart;
  else
    distance.reason = apart.error().what;
  std::vector<SurfaceReading> all = {
      distance,
      reading(W::radius(), "mm", 3, ball, &FittedBall::radius_mm),
      reading(W::area(), "mm²", 2, part, &PressedSurface::area_mm2),
      reading(W::volume(), "mm³", 3, part, &PressedSurface::volume_mm3),
      reading(W::mean(), "mm", 3, part, &PressedSurface::mean_mm),
      reading(W::rough(), "mm", 4, rough, &Roughness::sq_mm),
      reading(W::step(), "mm", 3, step, &StepHeight::height_mm)};
  if (part && part->is_lower_bound)
    for (const std::size_t i : {kVolume, kMean}) all[i].is_lower_bound = true;
  const auto at_a = fit_plane(patch(around(a))), at_b = fit_plane(patch(around(b)));
  SurfaceReading angle{W::angle(), QStringLiteral("°"), {}, 2, {}};
  if (at_a && at_b)
    angle.measured = angle_deg(*at_a, *at_b);
  else
    angle.reason = (at_a ? at_b : at_a).error().what;
  all.push_back(angle);
  return all;
}

QString value_text(const SurfaceReading& reading) {
  if (!reading.measured) return SurfaceWords::none();
  const auto& [value, sd] = *reading.measured;
  return QStringLiteral("%1 %2").arg(reading.is_lower_bound
                                         ? limit_and_sd(value, sd, reading.decimals)
                                         : number_and_sd(value, sd, reading.decimals),
                                     reading.unit);
}

QString text_of(const std::vector<SurfaceReading>& readings) {
  QString text;
  for (const SurfaceReading& reading : readings)
    if (reading.measured) text += labelled(reading.name, value_text(reading)) + QLatin1Char('\n');
  return text;
}

QString csv_of(const std::vector<SurfaceReading>& readings) {
  QStringList lines{QStringLiteral("name,value,sd,unit,limits")};
  for (const SurfaceReading& reading : readings) {
    if (!reading.measured) continue;
    const double sd = reading.measured->sd;
    lines << QStringLiteral("\"%1\",%2,%3,%4,%5")
                 .arg(reading.name)
                 .arg(reading.measured->value, 0, 'g', 8)
                 .arg(sd_kind(sd, 0) == SdKind::kUnknown ? QString() : QString::number(sd, 'g', 4))
                 .arg(reading.unit)
                 .arg(reading.is_lower_bound ? QStringLiteral("layer_limit") : QString());
  }
  return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

}  // namespace alltact
