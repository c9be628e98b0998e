#include "core/sensing/face/edge_follower.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace alltact {
namespace {

constexpr int kSeedStep = 6;  // of the samples, these may be where following an edge begins
constexpr int kTight = 7;     // rows searched on each side of where the edge goes on
// At which what is expected follows what is found, and where a dot seems to be found.
constexpr float kRate = 0.3F, kDotRate = 0.1F;

/// The straight line through the last few samples of an edge that is being followed.
class Ahead {
 public:
  void add(double u, double v) {
    if (points_.size() == kMost) points_.erase(points_.begin());
    points_.emplace_back(u, v);
  }
  /// Place and slope at u; `slope` until there are enough points for one.
  [[nodiscard]] std::pair<double, double> at(double u, double slope) const {
    double n = 0, su = 0, sv = 0, suu = 0, suv = 0;
    for (const auto& [pu, pv] : points_) {
      const double x = pu - u;
      n += 1, su += x, sv += pv, suu += x * x, suv += x * pv;
    }
    const double determinant = n * suu - su * su;
    if (points_.size() >= 4) slope = (n * suv - su * sv) / determinant;
    return {(sv - slope * su) / n, slope};
  }

 private:
  static constexpr std::size_t kMost = 8;
  std::vector<std::pair<double, double>> points_;
};

/// A sample where following an edge may begin.
struct Seed {
  int sample = 0;
  double v = 0, slope = 0, contrast = 0, outside = 0;
  float rise = 0;
};

Edge unseen(std::size_t samples) {
  return {std::vector<double>(samples, 0.0),
          std::vector<double>(samples, 1.0),
          std::vector<char>(samples, 0)};
}

/// Where an edge was read, sample by sample, with what lies on both sides of it.
struct Followed {
  Edge edge;
  std::vector<double> outside, contrast;  ///< grey levels, of samples that were seen
  std::vector<double> slope;              ///< of the edge, where it was looked for
  std::vector<float> rise;                ///< expected there
};

/// True when the brightness beside the face is not what it is around.
bool is_by_dot(double outside, double contrast, double around) {
  constexpr double kPart = 0.08, kLeast = 2.0;  // of the contrast; grey levels
  return !(std::abs(outside - around) <= std::max(kLeast, kPart * contrast));
}

/// Brightness beside the face between dots, by sample: what surrounding samples have that lie on
/// the side where most agree, since dots are all brighter or all darker; NaN without surroundings.
std::vector<double> between_dots(const Followed& followed) {
  constexpr int kReachSamples = 5;
  const auto count = static_cast<int>(followed.outside.size());
  std::vector<double> dark(followed.outside.size(), NAN), bright = dark, around;
  double spread_dark = 0, spread_bright = 0;
  for (int i = 0; i < count; ++i) {
    around.clear();
    const int first = std::max(0, i - kReachSamples), last = std::min(count - 1, i + kReachSamples);
    for (int j = first; j <= last; ++j)
      if (followed.edge.valid[static_cast<std::size_t>(j)])
        around.push_back(followed.outside[static_cast<std::size_t>(j)]);
    if (around.empty()) continue;
    std::sort(around.begin(), around.end());
    const auto at = [&](double part) {
      return around[static_cast<std::size_t>(
          std::lround(part * (static_cast<double>(around.size()) - 1.0)))];
    };
    constexpr double kThird = 1.0 / 3.0, kMiddle = 0.5 * kThird;
    dark[static_cast<std::size_t>(i)] = at(kMiddle);
    bright[static_cast<std::size_t>(i)] = at(1.0 - kMiddle);
    spread_dark += at(kThird) - around.front();
    spread_bright += around.back() - at(1.0 - kThird);
  }
  return spread_dark <= spread_bright ? dark : bright;
}

/// A dot near the edge changes the brightness beside the face and with it half of the height: there
/// the edge is read again with the brightness that its surroundings have beside it.
void read_beside_dots(const EdgeReader& reader,
                      const std::vector<double>& columns,
                      Followed& followed) {
  constexpr double kDotSdPx = 0.1;  // what a dot's own blur moves
  Edge& edge = followed.edge;
  const std::vector<double> level = between_dots(followed);
  for (std::size_t k = 0; k < level.size(); ++k) {
    if (edge.valid[k] && !is_by_dot(followed.outside[k], followed.contrast[k], level[k])) continue;
    edge.valid[k] = 0;
    if (!std::isfinite(level[k]) || !reader.reads_levels()) continue;
    const ExpectedEdge expected{static_cast<float>(level[k]), followed.rise[k]};
    const auto crossing = reader.at(columns[k], edge.v[k], followed.slope[k], kTight, expected);
    if (!crossing) continue;
    edge.v[k] += crossing->offset;
    edge.sd[k] = std::hypot(crossing->sd, kDotSdPx);
    edge.valid[k] = 1;
  }
}

/// A few samples beyond a gap are something else that lies where the edge would go on.
void leave_strays_out(Edge& edge) {
  constexpr std::size_t kGap = 4, kFew = 3;
  const std::size_t count = edge.valid.size();
  for (const bool from_end : {false, true}) {
    const auto valid = [&](std::size_t n) -> char& {
      return edge.valid[from_end ? count - 1 - n : n];
    };
    std::size_t seen = 0, gap = 0;
    for (std::size_t n = 0; n < count && seen <= kFew; ++n) {
      gap = valid(n) ? 0 : gap + 1;
      seen += valid(n) != 0;
      if (seen == 0 || gap < kGap) continue;
      for (std::size_t stray = 0; stray < n; ++stray) valid(stray) = 0;
      seen = 0;
    }
  }
}

/// Follows the edge from a seed to both sides, each time looking only where it goes on. The number
/// of samples where it was seen.
int follow(const EdgeReader& reader,
           const Seed& seed,
           const std::vector<double>& columns,
           Edge& found) {
  const auto count = static_cast<int>(columns.size());
  const std::vector<double> none(columns.size());
  Followed followed{
      unseen(columns.size()), none, none, none, std::vector<float>(columns.size(), 0.0F)};
  Edge& edge = followed.edge;
  int seen = 0;
  for (const int direction : {-1, 1}) {
    Ahead ahead;
    ahead.add(columns[static_cast<std::size_t>(seed.sample)], seed.v);
    ExpectedEdge expected{static_cast<float>(seed.outside), seed.rise};
    for (int i = direction < 0 ? seed.sample : seed.sample + 1; i >= 0 && i < count;
         i += direction) {
      const auto k = static_cast<std::size_t>(i);
      const auto [v, slope] = ahead.at(columns[k], seed.slope);
      edge.v[k] = v;
      followed.slope[k] = slope;
      followed.rise[k] = expected.rise;
      const auto crossing = reader.at(columns[k], v, slope, kTight, {std::nullopt, expected.rise});
      const bool by_dot =
          crossing && is_by_dot(crossing->outside, crossing->contrast, *expected.beside);
      auto ahead_of = crossing;  // what tells where the edge goes on
      if (!crossing || by_dot) ahead_of = reader.at(columns[k], v, slope, kTight, expected);
      if (ahead_of && i != seed.sample) ahead.add(columns[k], v + ahead_of->offset);
      if (!crossing) continue;
      edge.v[k] = v + crossing->offset;
      edge.sd[k] = crossing->sd;
      edge.valid[k] = 1;
      followed.outside[k] = crossing->outside, followed.contrast[k] = crossing->contrast;
      ++seen;
      *expected.beside +=
          (by_dot ? kDotRate : kRate) * (static_cast<float>(crossing->outside) - *expected.beside);
      if (!by_dot) expected.rise += kRate * (crossing->rise - expected.rise);
    }
  }
  read_beside_dots(reader, columns, followed);
  leave_strays_out(edge);
  found = std::move(edge);
  return seen;
}

/// True where more than a few samples between the first and the last one were not seen: an edge
/// that was followed from one dot's border to the next.
bool has_gaps(const Edge& edge) {
  constexpr std::ptrdiff_t kPart = 12;  // one in so many
  const auto first = std::find(edge.valid.begin(), edge.valid.end(), 1);
  const auto last = std::find(edge.valid.rbegin(), edge.valid.rend(), 1).base();
  if (first >= last) return true;
  return kPart * std::count(first, last, 0) > last - first;
}

}  // namespace

Edge find_edge(const EdgeReader& reader,
               const RoughEdges& rough,
               const RoughEdges::Path& path,
               const std::vector<double>& columns) {
  constexpr int kMostTries = 4;
  const auto count = static_cast<int>(columns.size());
  std::vector<Seed> seeds;
  for (int i = kSeedStep / 2; i < count; i += kSeedStep) {
    const double u = columns[static_cast<std::size_t>(i)];
    const auto small = static_cast<std::size_t>(u / rough.block);
    if (!rough.sure[std::min(small, rough.sure.size() - 1)]) continue;
    const auto [v, slope] = RoughEdges::place(path, rough.block, u);
    const auto crossing = reader.at(u, v, slope, EdgeReader::kWide);
    if (crossing)
      seeds.push_back(
          {i, v + crossing->offset, slope, crossing->contrast, crossing->outside, crossing->rise});
  }
  std::stable_sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) {
    return a.contrast > b.contrast;
  });
  Edge edge = unseen(columns.size());
  int most = -1;
  const auto is_done = [&] { return 2 * most >= count && !has_gaps(edge); };
  for (int tries = 0; tries < kMostTries && !seeds.empty() && !is_done(); ++tries) {
    const Seed seed = seeds.front();
    Edge tried;
    const int seen = follow(reader, seed, columns, tried);
    if (seen > most) most = seen, edge = std::move(tried);
    std::erase_if(seeds,
                  [&](const Seed& s) { return 8 * std::abs(s.sample - seed.sample) < count; });
  }
  return edge;
}

}  // namespace alltact
