#include "widgets/shell/finger_drawing.h"

#include "widgets/theme.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {
namespace {

// The finger in 640 x 320: its base at the left, its tip at the right, the sensing face above.
const QSizeF kDrawingRoom(640, 320);
const QPointF kBaseTop(130, 96), kTip(602, 188), kBaseBottom(130, 262);
constexpr double kLayer = 13, kDrawnBallRadius = 40, kBallAlong = 0.52, kPressed = 17;

const QColor kLampLight("#f2c14e");  // on light and on dark backgrounds

struct Inks {
  QColor line, body, layer, light, ball, mark, ground;
};

Inks inks_of(const QPalette& palette) {
  const QColor text = palette.color(QPalette::WindowText);
  const auto faint = [&](const QColor& colour, int alpha) {
    QColor ink = colour;
    ink.setAlpha(alpha);
    return ink;
  };
  return {text,
          faint(series_colour(0, palette), 46),
          faint(text, 150),
          faint(kLampLight, 90),
          faint(text, 70),
          series_colour(1, palette),
          palette.color(QPalette::Base)};
}

QPointF interpolated(const QPointF& a, const QPointF& b, double part) { return a + part * (b - a); }

/// Along the face from the base (0) to the tip (1), `below` px under its outer side.
QPointF on_face(double part, double below = 0) {
  const QPointF axis = kTip - kBaseTop;
  const double length = std::hypot(axis.x(), axis.y());
  const QPointF inward(-axis.y() / length, axis.x() / length);
  const double bow = -14 * std::sin(M_PI * part);  // the face arches a little
  return interpolated(kBaseTop, kTip, part) + (below + bow) * inward;
}

/// Indentation of the face by the ball there, px.
double indentation_px(double part) {
  const double away =
      (part - kBallAlong) * std::hypot(kTip.x() - kBaseTop.x(), kTip.y() - kBaseTop.y());
  const double reach =
      std::sqrt(kDrawnBallRadius * kDrawnBallRadius - std::pow(kDrawnBallRadius - kPressed, 2));
  if (std::abs(away) < reach)
    return kPressed - kDrawnBallRadius +
           std::sqrt(kDrawnBallRadius * kDrawnBallRadius - away * away);
  return 0;
}

QPainterPath face_line(double below, double follows) {
  QPainterPath path(on_face(0, below));
  constexpr int kPieces = 120;
  for (int i = 1; i <= kPieces; ++i) {
    const double part = static_cast<double>(i) / kPieces;
    path.lineTo(on_face(part, below * (1 - 0.5 * part) + follows * indentation_px(part)));
  }
  return path;
}

void draw_number(QPainter& painter, const Inks& inks, int number, const QPointF& at,
                 const QPointF& to) {
  constexpr double kDisc = 12;
  painter.setPen(QPen(inks.line, 1.2));
  painter.drawLine(at, to);
  painter.setBrush(inks.ground);
  painter.setPen(QPen(inks.line, 1.6));
  painter.drawEllipse(at, kDisc, kDisc);
  QFont font = painter.font();
  font.setPixelSize(15);
  font.setBold(true);
  painter.setFont(font);
  painter.drawText(QRectF(at.x() - kDisc, at.y() - kDisc, 2 * kDisc, 2 * kDisc), Qt::AlignCenter,
                   QString::number(number));
}

void draw_name(QPainter& painter, const Inks& inks, const QString& name, const QPointF& at) {
  QFont font = painter.font();
  font.setPixelSize(13);
  painter.setFont(font);
  QRectF box = QFontMetricsF(font).boundingRect(name).adjusted(-4, -2, 4, 2);
  box.moveCenter(at);
  // Inside the drawing, on a ground of its own.
  box.moveLeft(std::clamp(box.left(), 2.0, kDrawingRoom.width() - box.width() - 2));
  painter.setPen(Qt::NoPen);
  painter.setBrush(inks.ground);
  painter.drawRoundedRect(box, 3, 3);
  painter.setPen(inks.line);
  painter.drawText(box, Qt::AlignCenter, name);
}

void draw_light(QPainter& painter, const Inks& inks) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(inks.light);
  for (const double y : {138.0, 226.0}) {
    QPainterPath fan(QPointF(122, y));
    fan.lineTo(on_face(0.12, kLayer));
    for (int i = 0; i <= 20; ++i) fan.lineTo(on_face(0.12 + 0.04 * i, kLayer));
    fan.closeSubpath();
    painter.drawPath(fan);
  }
}

void draw_camera(QPainter& painter, const Inks& inks) {
  painter.setPen(QPen(inks.line, 2));
  painter.setBrush(inks.ball);
  painter.drawRoundedRect(QRectF(26, 112, 60, 136), 6, 6);
  painter.setBrush(inks.ground);
  painter.drawRect(QRectF(86, 164, 22, 36));
  painter.drawEllipse(QPointF(108, 182), 6, 18);
  for (const double y : {138.0, 226.0}) {
    painter.setBrush(kLampLight);
    painter.drawEllipse(QPointF(112, y), 9, 9);
  }
  painter.setPen(QPen(inks.line, 1, Qt::DashLine));
  painter.drawLine(QPointF(114, 182), on_face(0.06, kLayer));
  painter.drawLine(QPointF(114, 182), on_face(0.97, kLayer / 2));
}

void draw_body(QPainter& painter, const Inks& inks) {
  QPainterPath body = face_line(kLayer, 0.35);
  body.lineTo(kTip + QPointF(0, 18));
  body.lineTo(kBaseBottom);
  body.closeSubpath();
  painter.setPen(QPen(inks.line, 2));
  painter.setBrush(inks.body);
  painter.drawPath(body);
  // Ribs of the back, which let it bend around an object.
  painter.setPen(QPen(inks.line, 1));
  for (int i = 1; i <= 5; ++i)
    painter.drawLine(interpolated(kBaseBottom, kTip + QPointF(0, 18), 0.16 * i),
                     on_face(0.16 * i, 64 - 10 * i));
}

void draw_layer(QPainter& painter, const Inks& inks) {
  QPainterPath layer = face_line(0, 1);
  layer.connectPath(face_line(kLayer, 0.35).toReversed());
  layer.closeSubpath();
  painter.setPen(QPen(inks.line, 1.5));
  painter.setBrush(inks.layer);
  painter.drawPath(layer);
  painter.setBrush(inks.ground);
  for (int i = 0; i < 6; ++i)
    painter.drawEllipse(on_face(0.12 + 0.15 * i, kLayer + 12 - i), 5 - 0.4 * i, 5 - 0.4 * i);
}

QPointF ball_centre() { return on_face(kBallAlong, kPressed - kDrawnBallRadius); }

void draw_finger(QPainter& painter, const Inks& inks, bool has_numbers) {
  draw_light(painter, inks);
  draw_body(painter, inks);
  draw_layer(painter, inks);
  draw_camera(painter, inks);
  painter.setPen(QPen(inks.mark, 2.5));
  painter.setBrush(inks.ball);
  painter.drawEllipse(ball_centre(), kDrawnBallRadius, kDrawnBallRadius);
  if (!has_numbers) return;
  draw_number(painter, inks, 1, {56, 290}, {56, 248});
  draw_number(painter, inks, 2, {112, 84}, {112, 130});
  draw_number(painter, inks, 3, {216, 296}, {216, 220});
  draw_number(painter, inks, 4, {196, 60}, on_face(0.16, kLayer / 2));
  draw_number(painter, inks, 5, {290, 284}, on_face(0.30, kLayer));
  draw_number(painter, inks, 6, {266, 56}, on_face(0.30));
  draw_number(painter, inks, 7, {474, 264}, on_face(0.72, kLayer + 8));
  draw_number(painter, inks, 8, {150, 290}, {138, 258});
  draw_number(painter, inks, 9, {612, 140}, kTip);
  draw_number(painter, inks, 10, ball_centre() + QPointF(76, -26),
              ball_centre() + QPointF(30, -10));
}

/// The layer magnified: 640 x 320, the camera below.
void draw_press(QPainter& painter, const Inks& inks, bool has_numbers, const QStringList& names) {
  constexpr double kOuter = 128, kInner = 236, kRadius = 150, kDepth = 62, kMiddle = 320;
  const double reach = std::sqrt(kRadius * kRadius - std::pow(kRadius - kDepth, 2));
  const auto face = [&](double x) {
    const double away = std::abs(x - kMiddle);
    if (away < reach) return kOuter + kDepth - kRadius + std::sqrt(kRadius * kRadius - away * away);
    return kOuter - 9 * std::exp(-(away - reach) / 34);  // it bulges around the ball
  };
  QPainterPath layer(QPointF(10, kInner));
  for (int x = 10; x <= 630; x += 2) layer.lineTo(x, face(x));
  layer.lineTo(630, kInner);
  layer.closeSubpath();
  painter.setPen(Qt::NoPen);
  painter.setBrush(inks.body);
  painter.drawRect(QRectF(10, kInner, 620, 76));
  painter.setBrush(inks.layer);
  painter.setPen(QPen(inks.line, 2));
  painter.drawPath(layer);
  painter.setPen(QPen(inks.line, 1.6, Qt::DashLine));
  painter.drawLine(QPointF(10, kOuter), QPointF(630, kOuter));
  painter.setPen(QPen(inks.mark, 2.5));
  painter.setBrush(inks.ball);
  painter.setClipRect(QRectF(0, 0, kDrawingRoom.width(), kDrawingRoom.height()));
  painter.drawEllipse(QPointF(kMiddle, kOuter + kDepth - kRadius), kRadius, kRadius);
  const auto measure = [&](double x, double from, double to) {
    painter.setPen(QPen(inks.line, 2));
    painter.drawLine(QPointF(x, from), QPointF(x, to));
    for (const auto& [y, axis] : {std::pair{from, 1}, std::pair{to, -1}})
      for (const int side : {-5, 5})
        painter.drawLine(QPointF(x, y), QPointF(x + side, y + 9 * axis));
  };
  measure(kMiddle, kOuter, kOuter + kDepth);
  measure(96, kOuter, kInner);
  const std::array<std::pair<QPointF, QPointF>, 7> parts{
      {{{560, 284}, {530, kInner}},
       {{580, 84}, {560, kOuter}},
       {{408, 214}, {378, face(378)}},
       {{kMiddle + 34, kOuter + 24}, {kMiddle, kOuter + 24}},
       {{62, 182}, {96, 182}},
       {{kMiddle - 60, 44}, {kMiddle - 40, 60}},
       {{500, 74}, {kMiddle + reach + 12, face(kMiddle + reach + 12)}}}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& [at, to] = parts[i];
    const int number = static_cast<int>(i);
    if (has_numbers)
      draw_number(painter, inks, number + 1, at, to);
    else if (!names.value(number).isEmpty())
      draw_name(painter, inks, names[number], at);
  }
}

}  // namespace

FingerDrawing::FingerDrawing(DrawnThing what, QWidget* parent) : QWidget(parent), what_(what) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setProperty("alltact_drawing", true);
}

void FingerDrawing::show_numbers(bool are_shown) {
  has_numbers_ = are_shown;
  update();
}

void FingerDrawing::show_names(const QStringList& names) {
  names_ = names;
  update();
}

void FingerDrawing::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double scale = std::min(width() / kDrawingRoom.width(), height() / kDrawingRoom.height());
  painter.translate(0.5 * (width() - scale * kDrawingRoom.width()),
                    0.5 * (height() - scale * kDrawingRoom.height()));
  painter.scale(scale, scale);
  const Inks inks = inks_of(palette());
  if (what_ == DrawnThing::kFinger)
    draw_finger(painter, inks, has_numbers_);
  else
    draw_press(painter, inks, has_numbers_, names_);
}

}  // namespace alltact
