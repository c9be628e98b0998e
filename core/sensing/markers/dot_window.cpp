#include "core/sensing/markers/dot_window.h"

namespace alltact::dots {
namespace {

constexpr double kSpreadPx = 7.0;    // distance from the edge that its light reaches
constexpr double kOwnEdgePx = 0.25;  // pixels nearer to the edge are never usable
constexpr double kBinPx = 0.5;
constexpr int kBins = 1 + static_cast<int>(kSpreadPx / kBinPx);

/// Brightness of the side face as a function of the distance from the view face's edge.
class EdgeLight {
 public:
  void add(double off_px, float value) {
    const auto bin = static_cast<std::size_t>(off_px / kBinPx);
    off_[bin] += off_px;
    value_[bin] += static_cast<double>(value);
    ++count_[bin];
  }
  /// Returns false where a distance has too few samples.
  bool finish() {
    for (int bin = 0; bin < kBins; ++bin) {
      const auto i = static_cast<std::size_t>(bin);
      if (count_[i] < kMinCount) continue;
      off_[filled_] = off_[i] / count_[i];
      value_[filled_++] = value_[i] / count_[i];
    }
    return filled_ >= 4 && off_[0] < 1.0 && off_[filled_ - 1] > kSpreadPx - 1.0;
  }
  /// Brightness above the level beyond the edge's reach.
  [[nodiscard]] double at(double off_px) const {
    std::size_t k = 1;
    while (k + 1 < filled_ && off_[k] < off_px) ++k;
    const double t = std::clamp((off_px - off_[k - 1]) / (off_[k] - off_[k - 1]), -0.5, 1.0);
    return value_[k - 1] + t * (value_[k] - value_[k - 1]) - value_[filled_ - 1];
  }
  [[nodiscard]] double level() const { return value_[filled_ - 1]; }

 private:
  static constexpr int kMinCount = 3;
  std::array<double, kBins> off_{}, value_{};
  std::array<int, kBins> count_{};
  std::size_t filled_ = 0;
};

/// Estimated in the columns next to the seed, the same number on either side.
std::optional<EdgeLight> edge_light(const cv::Mat& grey,
                                    const SideEdges& edges,
                                    const DotSeed& seed) {
  const int from = static_cast<int>(std::ceil(1.35 * seed.half_u + 2.0));
  const int to = from + std::max(6, static_cast<int>(seed.half_u));
  const int middle = static_cast<int>(std::lround(seed.u));
  if (middle - from - 2 < 0 || middle + from + 2 >= grey.cols) return std::nullopt;
  EdgeLight light;
  for (int away = from; away <= to; ++away) {
    if (middle - away < 0 || middle + away >= grey.cols) break;
    for (const int u : {middle - away, middle + away}) {
      const auto rows = edges.rows(u, seed.upper, 0.0, grey.rows);
      for (int step = 0; step <= static_cast<int>(kSpreadPx); ++step) {
        const int v = seed.upper ? rows.last - step : rows.first + step;
        if (v < 0 || v >= grey.rows) break;
        const double off = edges.off_px(u, v, seed.upper);
        if (off < kSpreadPx)
          light.add(
              off, static_cast<float>(seed.sign) * static_cast<float>(grey.at<std::uint8_t>(v, u)));
      }
    }
  }
  if (!light.finish()) return std::nullopt;
  return light;
}

/// Subtracts the edge's light from the window. The values remain integer grey levels.
void subtract_light(const EdgeLight& light, const SideEdges& edges, bool upper, Window& w) {
  for (int x = 0; x < w.width; ++x)
    for (int y = 0; y < w.height; ++y) {
      const double off = edges.off_px(w.u0 + x, w.v0 + y, upper);
      if (off >= kSpreadPx) continue;
      float& value = w.value[w.index(x, y)];
      if (off < kOwnEdgePx)
        value = static_cast<float>(std::round(light.level()));
      else
        value = std::clamp(
            std::round(value - static_cast<float>(light.at(off))), -kMaxLevel, kMaxLevel);
    }
}

bool is_near_face(const SideEdges& edges, const DotSeed& seed, const cv::Mat& grey) {
  const int u = std::clamp(static_cast<int>(std::lround(seed.u)), 0, grey.cols - 1);
  return edges.off_px(u, seed.v, seed.upper) < seed.half_v + kSpreadPx;
}

}  // namespace

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
  double margin_px = kFaceMarginPx;
  if (is_near_face(edges, seed, grey))
    if (const auto light = edge_light(grey, edges, seed)) {
      subtract_light(*light, edges, seed.upper, w);
      margin_px = kOwnEdgePx;
    }
  std::array<int, kMaxSide> first, last;
  w.all_usable = true;
  for (int x = 0; x < w.width; ++x) {
    const auto rows = edges.rows(w.u0 + x, seed.upper, margin_px, grey.rows);
    first[static_cast<std::size_t>(x)] = rows.first - w.v0;
    last[static_cast<std::size_t>(x)] = rows.last - w.v0;
    w.all_usable = w.all_usable && rows.first <= w.v0 && rows.last >= w.v0 + w.height - 1;
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
