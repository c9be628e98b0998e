#include "core/sensing/dot_window.h"

namespace alltact::dots {

void load(
    const cv::Mat& grey, const SideEdges& edges, const DotSeed& seed, double scale, Window& w) {
  const int half_u =
      std::min(kMaxSide / 2 - 1, static_cast<int>(std::ceil(scale * seed.half_u + 3)));
  const int half_v =
      std::min(kMaxSide / 2 - 1, static_cast<int>(std::ceil(scale * seed.half_v + 3)));
  const int cu = static_cast<int>(std::lround(seed.u)), cv = static_cast<int>(std::lround(seed.v));
  w.u0 = std::max(0, cu - half_u);
  w.v0 = std::max(0, cv - half_v);
  w.width = std::min(grey.cols - 1, cu + half_u) - w.u0 + 1;
  w.height = std::min(grey.rows - 1, cv + half_v) - w.v0 + 1;
  if (w.width <= 0 || w.height <= 0) {
    w.width = w.height = 0;
    return;
  }
  const auto sign = static_cast<float>(seed.sign);
  for (int y = 0; y < w.height; ++y) {
    const std::uint8_t* row = grey.ptr<std::uint8_t>(w.v0 + y) + w.u0;
    float* out = &w.value[w.index(0, y)];
    for (int x = 0; x < w.width; ++x) out[x] = sign * static_cast<float>(row[x]);
  }
  std::array<int, kMaxSide> first, last;
  w.whole = true;
  for (int x = 0; x < w.width; ++x) {
    const auto rows = edges.rows(w.u0 + x, seed.upper, kFaceMarginPx, grey.rows);
    first[static_cast<std::size_t>(x)] = rows.first - w.v0;
    last[static_cast<std::size_t>(x)] = rows.last - w.v0;
    w.whole = w.whole && rows.first <= w.v0 && rows.last >= w.v0 + w.height - 1;
  }
  for (int y = 0; y < w.height; ++y) {
    std::uint8_t* usable = &w.usable[w.index(0, y)];
    for (int x = 0; x < w.width; ++x) {
      const auto column = static_cast<std::size_t>(x);
      usable[x] = static_cast<std::uint8_t>((y >= first[column]) & (y <= last[column]));
    }
  }
}
}  // namespace alltact::dots
