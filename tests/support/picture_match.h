// Whether two pictures of a window look the same to a person.
#pragma once

#include <QImage>
#include <algorithm>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

namespace alltact::test {

/// Empty where they do, else what differs. Letters may be smoothed a little differently: a pixel
/// counts when a channel is off by more than 64 of 255, and the pictures differ when 0.5 % of all
/// pixels count, or an eighth of any square of 16 x 16: a word, a symbol, a border.
inline std::string what_differs(const QImage& seen, const QImage& expected) {
  constexpr int kOff = 64, kTile = 16, kMostOfTile = kTile * kTile / 8;
  constexpr double kMostOfAll = 0.005;
  if (seen.size() != expected.size())
    return fmt::format("{} x {} px instead of {} x {}", seen.width(), seen.height(),
                       expected.width(), expected.height());
  const auto is_off = [&](int x, int y) {
    const QRgb a = seen.pixel(x, y), b = expected.pixel(x, y);
    return std::abs(qRed(a) - qRed(b)) > kOff || std::abs(qGreen(a) - qGreen(b)) > kOff ||
           std::abs(qBlue(a) - qBlue(b)) > kOff;
  };
  int all = 0;
  for (int top = 0; top < seen.height(); top += kTile)
    for (int left = 0; left < seen.width(); left += kTile) {
      int here = 0;
      for (int y = top; y < std::min(top + kTile, seen.height()); ++y)
        for (int x = left; x < std::min(left + kTile, seen.width()); ++x) here += is_off(x, y);
      if (here > kMostOfTile)
        return fmt::format("{} pixels differ around ({}, {})", here, left + 8, top + 8);
      all += here;
    }
  if (all > kMostOfAll * seen.width() * seen.height())
    return fmt::format("{} pixels differ all over", all);
  return {};
}

}  // namespace alltact::test
