#include "widgets/calibrating/shown_press.h"

#include "calibration/presses/manual_ball.h"
#include "core/geometry/ball.h"
#include "widgets/calibrating/press_model.h"
#include "widgets/calibrating/verdict_words.h"
#include "widgets/grey_image.h"
#include "widgets/image/overlays.h"
#include "widgets/shell/icons.h"

#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace alltact {
namespace {

constexpr int kOutlinePoints = 120;
constexpr double kAroundBall = 1.5;  // height of the crop over that of the outline
constexpr double kMinCut_px = 24;
const QColor kBallOutline(255, 214, 64);

QPolygonF outline_polygon(const ShownBall& ball) {
  QPolygonF polygon;
  for (const auto& p : ball_outline_px(ball.camera, ball.centre_mm, ball.radius_mm, kOutlinePoints))
    polygon << QPointF(p.x() + 0.5, p.y() + 0.5);  // from pixel centres to pixel corners
  return polygon;
}

/// Drawn on an image, so the colours are those of the dark theme for every palette.
void paint_meaning(QPainter& painter, Meaning meaning, const QSize& size, double ratio) {
  constexpr int kBar = 5, kSymbol = 16;
  const QColor colour = meaning_colour(meaning, theme_palette(Theme::kDark));
  painter.fillRect(QRect(0, 0, kBar, size.height()), colour);
  const QRect plate(kBar + 2, 2, kSymbol + 4, kSymbol + 4);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 190));
  painter.drawRoundedRect(plate, 4, 4);
  painter.drawPixmap(plate.topLeft() + QPoint(2, 2),
                     symbol(meaning_symbol(meaning), colour, kSymbol, ratio));
}

/// Crop of the image around the outline, in the aspect ratio of `size`.
QRectF cut_around(const QPolygonF& outline, const cv::Mat& grey, const QSize& size) {
  const QRectF full(0, 0, grey.cols, grey.rows);
  const double shape = static_cast<double>(size.width()) / size.height();
  if (outline.isEmpty() || !full.intersects(outline.boundingRect())) return full;
  const QRectF box = outline.boundingRect();
  const double height = std::clamp(kAroundBall * std::max(box.height(), box.width() / shape),
                                   kMinCut_px,
                                   std::max(kMinCut_px, full.height()));
  QRectF cut(0, 0, shape * height, height);
  cut.moveCenter(box.center());
  return cut;
}

}  // namespace

std::optional<ShownBall> known_ball(const CollectedPress& press,
                                    const PressCollection& collection,
                                    const CalibrationRun& run) {
  const PressNote& note = collection.press_set().of(press.name);
  const double radius = collection.press_set().radius_of(press.name);
  if (collection.analyser() == nullptr || !(radius > 0) || note.step_mm) return std::nullopt;
  const auto shown = [&](const Eigen::Vector3d& centre, bool is_by_hand) {
    ShownBall ball{
        collection.analyser()->camera(), radius, centre, is_by_hand, Eigen::Vector3d::UnitZ()};
    const Face& face = collection.analyser()->finger().face;
    const auto contact = press.analysis.shape
                             ? ball_on_face(*press.analysis.shape, face, centre, radius)
                             : std::nullopt;
    if (contact) ball.normal = contact->normal;
    return ball;
  };
  if (note.ball_mm) return shown(*note.ball_mm, true);
  const bool is_current = run.state() == CalibrationState::kCurrent;
  if (const BallFit* fitted = is_current ? fitted_ball(run, press.name) : nullptr)
    return shown(fitted->centre_mm, false);
  if (press.analysis.found_mm) return shown(*press.analysis.found_mm, false);
  return std::nullopt;
}

QString refusal_word(const Error& problem) {
  const std::string& words = problem.what.words();
  const auto begins = [&words](const char* with) { return words.rfind(with, 0) == 0; };
  if (begins("hardly any pixel")) return PressModel::tr("not comparable");
  if (begins("nothing on the face is")) return PressModel::tr("nothing pressed in");
  if (begins("only specks")) return PressModel::tr("only specks");
  if (begins("two contacts")) return PressModel::tr("two contacts");
  if (begins("the dark part has a radius")) return PressModel::tr("larger than the ball");
  if (begins("only {:.0f} degrees") || begins("the middle of the dark disc"))
    return PressModel::tr("over the edge");
  if (begins("the border of the dark part") || begins("the dark part is no disc"))
    return PressModel::tr("no ball's disc");
  return PressModel::tr("not usable");
}

QImage press_thumbnail(const cv::Mat& grey,
                       const std::optional<ShownBall>& ball,
                       const QSize& size,
                       double ratio,
                       std::optional<Meaning> meaning) {
  QImage thumbnail(size * ratio, QImage::Format_RGB32);
  thumbnail.setDevicePixelRatio(ratio);
  thumbnail.fill(Qt::black);
  if (grey.empty()) return thumbnail;
  const QPolygonF outline = ball ? outline_polygon(*ball) : QPolygonF();
  const QRectF cut = cut_around(outline, grey, size);
  const double scale = std::min(size.width() / cut.width(), size.height() / cut.height());
  const QPointF corner(0.5 * (size.width() - scale * cut.width()),
                       0.5 * (size.height() - scale * cut.height()));
  const QRect inside = cut.toAlignedRect() & QRect(0, 0, grey.cols, grey.rows);
  QPainter painter(&thumbnail);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  QTransform to_thumbnail;
  to_thumbnail.translate(corner.x(), corner.y());
  to_thumbnail.scale(scale, scale);
  to_thumbnail.translate(-cut.x(), -cut.y());
  const QImage image = grey_image(grey);
  // Scaling by the painter would alias.
  const QRectF target = to_thumbnail.mapRect(QRectF(inside));
  painter.drawImage(
      target,
      image.copy(inside).scaled(
          (target.size() * ratio).toSize(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  if (!outline.isEmpty()) {
    QPainterPath path;
    path.addPolygon(to_thumbnail.map(outline));
    path.closeSubpath();
    stroke_over(painter, path, kBallOutline, 1.4, ball->is_by_hand ? Qt::SolidLine : Qt::DashLine);
  }
  if (meaning) paint_meaning(painter, *meaning, size, ratio);
  return thumbnail;
}

QPixmap PressThumbnails::of(const CollectedPress& press,
                            const std::optional<ShownBall>& ball,
                            std::optional<Meaning> meaning) {
  if (press.analysis.grey.empty()) return {};
  Drawn& drawn = drawn_[press.name];
  Eigen::Vector4d now = Eigen::Vector4d::Zero();
  if (ball) now << ball->centre_mm, ball->radius_mm;
  const bool is_by_hand = ball && ball->is_by_hand;
  if (drawn.grey.data != press.analysis.grey.data || drawn.ball != now ||
      drawn.is_by_hand != is_by_hand || drawn.meaning != meaning)
    drawn = {press.analysis.grey,
             now,
             is_by_hand,
             meaning,
             QPixmap::fromImage(press_thumbnail(
                 press.analysis.grey, ball, size(), qGuiApp->devicePixelRatio(), meaning))};
  return drawn.pixmap;
}

}  // namespace alltact
