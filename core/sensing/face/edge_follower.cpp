#include "core/sensing/face/edge_follower.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace alltact {
namespace {

constexpr int kSeedStep = 6;     // every sixth sample is a candidate to begin at
constexpr int kFollowReach = 7;  // rows searched on each side of the predicted edge
// Rate at which the expected edge adapts to the measured one, and the rate near a suspected dot.
constexpr float kUpdateRate = 0.3F, kDotUpdateRate = 0.1F;

/// Extrapolates the edge: a straight line through the last few samples.
class EdgePredictor {
 public:
  void add(double u, double v) {
    if (points_.size() == kMaxPoints) points_.erase(points_.begin());
    points_.emplace_back(u, v);
  }
  /// Row and slope at u; `slope` is returned until there are 4 points.
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
  static constexpr std::size_t kMaxPoints = 8;
  std::vector<std::pair<double, double>> points_;
};

/// A sample where following may begin.
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

/// The samples of a followed edge, and the levels on both sides of it.
struct Followed {
  Edge edge;
  std::vector<double> outside, contrast;  ///< grey levels, of valid samples
  std::vector<double> slope;              ///< of the predicted edge
  std::vector<float> rise;                ///< expected at the predicted edge
};

/// True when the brightness outside the face differs from its surroundings.
bool is_near_dot(double outside, double contrast, double around) {
  constexpr double kFraction = 0.08, kMinDifference = 2.0;  // fraction of the contrast; grey levels
  return !(std::abs(outside - around) <= std::max(kMinDifference, kFraction * contrast));
}

/// Brightness outside the face between dots, by sample. The lower or upper third of the
/// surroundings, whichever agrees better, since dots are all brighter or all darker. NaN without
/// surroundings.
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

/// Reads the edge near dots again, with the outside level of its surroundings. A dot near the edge
/// changes the brightness outside the face and thus the half level.
void reread_near_dots(const EdgeReader& reader,
                      const std::vector<double>& columns,
                      Followed& followed) {
  constexpr double kDotSdPx = 0.1;  // shift of the edge by the blur of a dot
  Edge& edge = followed.edge;
  const std::vector<double> level = between_dots(followed);
  for (std::size_t k = 0; k < level.size(); ++k) {
    if (edge.valid[k] && !is_near_dot(followed.outside[k], followed.contrast[k], level[k]))
      continue;
    edge.valid[k] = 0;
    if (!std::isfinite(level[k]) || !reader.reads_levels()) continue;
    const ExpectedEdge expected{static_cast<float>(level[k]), followed.rise[k]};
    const auto crossing =
        reader.at(columns[k], edge.v[k], followed.slope[k], kFollowReach, expected);
    if (!crossing) continue;
    edge.v[k] += crossing->offset;
    edge.sd[k] = std::hypot(crossing->sd, kDotSdPx);
    edge.valid[k] = 1;
  }
}

/// Invalidates a few samples beyond a gap: another structure in line with the edge.
void remove_strays(Edge& edge) {
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

/// Follows the edge from a seed to both sides, searching only around its prediction. Returns the
/// number of samples with an edge.
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
    EdgePredictor ahead;
    ahead.add(columns[static_cast<std::size_t>(seed.sample)], seed.v);
    ExpectedEdge expected{static_cast<float>(seed.outside), seed.rise};
    for (int i = direction < 0 ? seed.sample : seed.sample + 1; i >= 0 && i < count;
         i += direction) {
      const auto k = static_cast<std::size_t>(i);
      const auto [v, slope] = ahead.at(columns[k], seed.slope);
      edge.v[k] = v;
      followed.slope[k] = slope;
      followed.rise[k] = expected.rise;
      const auto crossing =
          reader.at(columns[k], v, slope, kFollowReach, {std::nullopt, expected.rise});
      const bool near_dot =
          crossing && is_near_dot(crossing->outside, crossing->contrast, *expected.outside);
      auto prediction = crossing;  // crossing that the prediction is updated with
      if (!crossing || near_dot)
        prediction = reader.at(columns[k], v, slope, kFollowReach, expected);
      if (prediction && i != seed.sample) ahead.add(columns[k], v + prediction->offset);
      if (!crossing) continue;
      edge.v[k] = v + crossing->offset;
      edge.sd[k] = crossing->sd;
      edge.valid[k] = 1;
      followed.outside[k] = crossing->outside, followed.contrast[k] = crossing->contrast;
      ++seen;
      *expected.outside += (near_dot ? kDotUpdateRate : kUpdateRate) *
                           (static_cast<float>(crossing->outside) - *expected.outside);
      if (!near_dot) expected.rise += kUpdateRate * (crossing->rise - expected.rise);
    }
  }
  reread_near_dots(reader, columns, followed);
  remove_strays(edge);
  found = std::move(edge);
  return seen;
}

/// True where more than a few samples between the first and the last valid one are invalid. Such an
/// edge was followed from the border of one dot to the next.
bool has_gaps(const Edge& edge) {
  constexpr std::ptrdiff_t kGapDivisor = 12;  // more than one sample in 12 is a gap
  const auto first = std::find(edge.valid.begin(), edge.valid.end(), 1);
  const auto last = std::find(edge.valid.rbegin(), edge.valid.rend(), 1).base();
  if (first >= last) return true;
  return kGapDivisor * std::count(first, last, 0) > last - first;
}

}  // namespace

Edge find_edge(const EdgeReader& reader,
               const RoughEdges& rough,
               const RoughEdges::Path& path,
               const std::vector<double>& columns) {
  constexpr int kMaxTries = 4;
  const auto count = static_cast<int>(columns.size());
  std::vector<Seed> seeds;
  for (int i = kSeedStep / 2; i < count; i += kSeedStep) {
    const double u = columns[static_cast<std::size_t>(i)];
    const auto small = static_cast<std::size_t>(u / rough.block);
    if (!rough.can_seed[std::min(small, rough.can_seed.size() - 1)]) continue;
    const auto [v, slope] = RoughEdges::position_at(path, rough.block, u);
    const auto crossing = reader.at(u, v, slope, EdgeReader::kMaxReach);
    if (crossing)
      seeds.push_back(
          {i, v + crossing->offset, slope, crossing->contrast, crossing->outside, crossing->rise});
  }
  std::stable_sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) {
    return a.contrast > b.contrast;
  });
  Edge edge = unseen(columns.size());
  int best_seen = -1;
  const auto is_done = [&] { return 2 * best_seen >= count && !has_gaps(edge); };
  for (int tries = 0; tries < kMaxTries && !seeds.empty() && !is_done(); ++tries) {
    const Seed seed = seeds.front();
    Edge tried;
    const int seen = follow(reader, seed, columns, tried);
    if (seen > best_seen) best_seen = seen, edge = std::move(tried);
    std::erase_if(seeds,
                  [&](const Seed& s) { return 8 * std::abs(s.sample - seed.sample) < count; });
  }
  return edge;
}

}  // namespace alltact
