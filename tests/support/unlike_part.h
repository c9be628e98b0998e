// How unlike two pictures of a window are that was used for a while in between.
#pragma once

#include <QImage>
#include <algorithm>
#include <cmath>

namespace alltact::test {

/// Part of all pixels, of pictures reduced once more, that a person would call another colour.
/// Figures run and the finger moves while the picture is taken; panels and words stand still.
inline double unlike_part(const QImage& a, const QImage& b) {
  const QSize size(400, 250);
  const auto even = [&](const QImage& image) {
    return image.convertToFormat(QImage::Format_RGB888)
        .scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  };
  const QImage left = even(a), right = even(b);
  int unlike = 0;
  for (int y = 0; y < size.height(); ++y)
    for (int x = 0; x < size.width(); ++x) {
      const QRgb p = left.pixel(x, y), q = right.pixel(x, y);
      const int off = std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                                std::abs(qBlue(p) - qBlue(q))});
      unlike += off > 48;
    }
  return static_cast<double>(unlike) / (size.width() * size.height());
}
inline constexpr double kMostUnlike =
    0.045;  // a bent finger: up to 0.03; a line more above it: 0.08

}  // namespace alltact::test
