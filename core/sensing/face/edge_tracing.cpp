#include "core/sensing/face/edge_tracing.h"

#include "core/numerics/dispatch.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
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
  static constexpr std::size_t kMaxPoints = 8;

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
  std::vector<std::pair<double, double>> points_;
};

/// A sample where following may begin.
struct Seed {
  int sample = 0;
  double v = 0, slope = 0, contrast = 0, outside = 0;
  float steepness = 0;
};

Edge unseen(std::size_t samples) {
  return {std::vector<double>(samples, 0.0), std::vector<double>(samples, 1.0),
          std::vector<char>(samples, 0)};
}

/// The samples of a followed edge, and the levels on both sides of it.
struct Followed {
  Edge edge;
  std::vector<double> outside, contrast;  ///< grey levels, of valid samples
  std::vector<double> slope;              ///< of the predicted edge
  std::vector<float> steepness;           ///< expected at the predicted edge
};

/// True when the brightness outside the face differs from its surroundings.
bool is_near_dot(double outside, double contrast, double around) {
  constexpr double kFraction = 0.08, kMinDifference = 2.0;  // fraction of the contrast; grey levels
  return !(std::abs(outside - around) <= std::max(kMinDifference, kFraction * contrast));
}

/// Change of the outside level from one valid sample to the next, by the median of their
/// differences over [first, last]. Those between a dot and a gap cancel: they occur with both
/// signs.
double median_trend(const Followed& followed, int first, int last, std::vector<double>& steps) {
  constexpr int kApart = 3;
  steps.clear();
  const auto valid = [&](int i) { return followed.edge.valid[static_cast<std::size_t>(i)] != 0; };
  const auto level = [&](int i) { return followed.outside[static_cast<std::size_t>(i)]; };
  for (int i = first; i + kApart <= last; ++i)
    if (valid(i) && valid(i + kApart)) steps.push_back((level(i + kApart) - level(i)) / kApart);
  return upper_median(steps);
}

/// Brightness outside the face between dots, by sample: the surroundings with their trend along the
/// finger removed, of which the lower or upper third counts, whichever agrees better, since dots
/// are all brighter or all darker. NaN without surroundings.
std::vector<double> between_dots(const Followed& followed) {
  constexpr int kReachSamples = 5;
  const auto count = static_cast<int>(followed.outside.size());
  std::vector<double> dark(followed.outside.size(), NAN), bright = dark, around, steps;
  double spread_dark = 0, spread_bright = 0;
  for (int i = 0; i < count; ++i) {
    around.clear();
    const int first = std::max(0, i - kReachSamples), last = std::min(count - 1, i + kReachSamples);
    const double trend = median_trend(followed, first, last, steps);
    for (int j = first; j <= last; ++j)
      if (followed.edge.valid[static_cast<std::size_t>(j)])
        around.push_back(followed.outside[static_cast<std::size_t>(j)] + trend * (i - j));
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
void reread_near_dots(const EdgeReader& reader, const std::vector<double>& columns,
                      Followed& followed) {
  constexpr double kDotSdPx = 0.1;  // shift of the edge by the blur of a dot
  Edge& edge = followed.edge;
  const std::vector<double> level = between_dots(followed);
  for (std::size_t k = 0; k < level.size(); ++k) {
    if (edge.valid[k] && !is_near_dot(followed.outside[k], followed.contrast[k], level[k]))
      continue;
    edge.valid[k] = 0;
    if (!std::isfinite(level[k]) || !reader.reads_levels()) continue;
    const ExpectedEdge expected{static_cast<float>(level[k]), followed.steepness[k]};
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
int follow(const EdgeReader& reader, const Seed& seed, const std::vector<double>& columns,
           Edge& found) {
  const auto count = static_cast<int>(columns.size());
  const std::vector<double> none(columns.size());
  Followed followed{unseen(columns.size()), none, none, none,
                    std::vector<float>(columns.size(), 0.0F)};
  Edge& edge = followed.edge;
  int seen = 0;
  // The seed's slope is rough. What is found on one side of it predicts the other side.
  std::vector<std::pair<double, double>> passed;  // the nearest first
  for (const int direction : {-1, 1}) {
    EdgePredictor ahead;
    for (std::size_t n = passed.size(); n-- > 0;) ahead.add(passed[n].first, passed[n].second);
    ahead.add(columns[static_cast<std::size_t>(seed.sample)], seed.v);
    ExpectedEdge expected{static_cast<float>(seed.outside), seed.steepness};
    for (int i = direction < 0 ? seed.sample : seed.sample + 1; i >= 0 && i < count;
         i += direction) {
      const auto k = static_cast<std::size_t>(i);
      const auto [v, slope] = ahead.at(columns[k], seed.slope);
      edge.v[k] = v;
      followed.slope[k] = slope;
      followed.steepness[k] = expected.steepness;
      const auto crossing =
          reader.at(columns[k], v, slope, kFollowReach, {std::nullopt, expected.steepness});
      const bool near_dot =
          crossing && is_near_dot(crossing->outside, crossing->contrast, *expected.outside);
      auto prediction = crossing;  // crossing that the prediction is updated with
      if (!crossing || near_dot)
        prediction = reader.at(columns[k], v, slope, kFollowReach, expected);
      if (prediction && i != seed.sample) {
        ahead.add(columns[k], v + prediction->offset);
        if (direction < 0 && passed.size() + 1 < EdgePredictor::kMaxPoints)
          passed.emplace_back(columns[k], v + prediction->offset);
      }
      if (!crossing) continue;
      edge.v[k] = v + crossing->offset;
      edge.sd[k] = crossing->sd;
      edge.valid[k] = 1;
      followed.outside[k] = crossing->outside, followed.contrast[k] = crossing->contrast;
      ++seen;
      *expected.outside += (near_dot ? kDotUpdateRate : kUpdateRate) *
                           (static_cast<float>(crossing->outside) - *expected.outside);
      if (!near_dot) expected.steepness += kUpdateRate * (crossing->steepness - expected.steepness);
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

Edge find_edge(const EdgeReader& reader, const RoughEdges& rough, const RoughEdges::Path& path,
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
      seeds.push_back({i, v + crossing->offset, slope, crossing->contrast, crossing->outside,
                       crossing->steepness});
  }
  std::stable_sort(seeds.begin(), seeds.end(),
                   [](const Seed& a, const Seed& b) { return a.contrast > b.contrast; });
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

namespace {

using Path = RoughEdges::Path;

constexpr int kSmallWidth = 120;  // approximate columns of the reduced image
constexpr int kLargestJump = 3;   // rows from one small column to the next
constexpr float kJumpPenalty = 0.03F;

/// Packs eight pixels into one number.
std::uint64_t eight_pixels(const std::uint8_t* pixels) {
  std::uint64_t word = 0;
  std::memcpy(&word, pixels, sizeof word);
  return word;
}

/// Adds a row to sums of pairs of neighbouring pixels, four sums of 16 bits in each word.
ALLTACT_WIDE void add_pairs(const std::uint8_t* __restrict row, int words,
                            std::uint64_t* __restrict sums) {
  constexpr std::uint64_t kEvery2nd = 0x00FF00FF00FF00FF;
  for (int i = 0; i < words; ++i) {
    const std::uint64_t word = eight_pixels(row + 8 * static_cast<std::ptrdiff_t>(i));
    sums[i] += (word & kEvery2nd) + ((word >> 8U) & kEvery2nd);
  }
}

/// Sums over blocks of `block` columns, a multiple of eight.
class SumsOfEights {
 public:
  SumsOfEights(int width, int block)
      : words_of_block_(block / 8),
        sums_(static_cast<std::size_t>(std::ptrdiff_t{width} * words_of_block_)) {}
  /// Beyond this block the four sums of a word together exceed 16 bits.
  static bool can_sum(int block) { return block % 8 == 0 && block <= 32; }

  void clear() { std::fill(sums_.begin(), sums_.end(), 0U); }
  void add(const std::uint8_t* row) {
    add_pairs(row, static_cast<int>(sums_.size()), sums_.data());
  }
  [[nodiscard]] std::uint32_t of(int column) const {
    constexpr std::uint64_t kAllFour = 0x0001000100010001;
    std::uint32_t sum = 0;
    for (int k = 0; k < words_of_block_; ++k)
      sum += static_cast<std::uint32_t>(
          (sums_[static_cast<std::size_t>(std::ptrdiff_t{column} * words_of_block_ + k)] *
           kAllFour) >>
          48U);
    return sum;
  }

 private:
  int words_of_block_;
  std::vector<std::uint64_t> sums_;
};

/// Adds a row to the sums.
ALLTACT_WIDE void add_grey_row(const std::uint8_t* __restrict row, int width,
                               std::uint32_t* __restrict sums) {
  for (int u = 0; u < width; ++u) sums[u] += row[u];
}

/// Sums over blocks of any number of columns.
class SumsOfAny {
 public:
  SumsOfAny(int width, int block)
      : block_(block), sums_(static_cast<std::size_t>(std::ptrdiff_t{width} * block)) {}
  void clear() { std::fill(sums_.begin(), sums_.end(), 0U); }
  void add(const std::uint8_t* row) {
    add_grey_row(row, static_cast<int>(sums_.size()), sums_.data());
  }
  [[nodiscard]] std::uint32_t of(int column) const {
    const auto first = sums_.begin() + static_cast<std::ptrdiff_t>(column) * block_;
    return std::accumulate(first, first + block_, 0U);
  }

 private:
  int block_;
  std::vector<std::uint32_t> sums_;
};

template <class Sums>
cv::Mat means_of_blocks(const cv::Mat& grey, int block) {
  const int width = grey.cols / block, height = grey.rows / block;
  cv::Mat small(width, height, CV_32FC1);
  Sums sums(width, block);
  for (int r = 0; r < height; ++r) {
    sums.clear();
    for (int k = 0; k < block; ++k) sums.add(grey.ptr<std::uint8_t>(r * block + k));
    for (int c = 0; c < width; ++c)
      small.at<float>(c, r) = static_cast<float>(sums.of(c)) / static_cast<float>(block * block);
  }
  return small;
}

/// Means of complete blocks. Row c of the result is column c of blocks; incomplete blocks at the
/// right and bottom are omitted.
cv::Mat block_columns(const cv::Mat& grey, int block) {
  return SumsOfEights::can_sum(block) ? means_of_blocks<SumsOfEights>(grey, block)
                                      : means_of_blocks<SumsOfAny>(grey, block);
}

/// Brightness change downwards across the border below each row, relative to the column's range:
/// the face is darker at its tip, where its edges count as much. A column with a range far below
/// that of the others shows no face. Columns are rows of both images.
cv::Mat downward_contrast(const cv::Mat& small, double noise_sd) {
  constexpr float kMinRange = 0.1F;  // of the largest range
  const int rows = small.cols;
  std::vector<float> ranges;
  for (int c = 0; c < small.rows; ++c) {
    const float* column = small.ptr<float>(c);
    const auto [low, high] = std::minmax_element(column, column + rows);
    ranges.push_back(*high - *low);
  }
  const float min_range = std::max(static_cast<float>(4.0 * noise_sd),
                                   kMinRange * *std::max_element(ranges.begin(), ranges.end()));
  cv::Mat contrast(small.rows, rows - 1, CV_32FC1);
  for (int c = 0; c < small.rows; ++c) {
    const float* column = small.ptr<float>(c);
    float* out = contrast.ptr<float>(c);
    const float range = std::max(ranges[static_cast<std::size_t>(c)], min_range);
    for (int r = 0; r + 1 < rows; ++r) {
      const float above = column[r] + column[std::max(r - 1, 0)];
      const float below = column[r + 1] + column[std::min(r + 2, rows - 1)];
      out[r] = (below - above) / (2.0F * range);
    }
  }
  return contrast;
}

/// Best predecessor of every row of a column. `before` holds the scores of the previous column,
/// padded by kLargestJump values at both ends.
ALLTACT_WIDE void best_jumps(const float* __restrict before, const float* __restrict contrast,
                             float sign, int rows, float* __restrict score,
                             float* __restrict jump) {
  for (int r = 0; r < rows; ++r) {
    float best = before[r], best_jump = 0.0F;
    for (int j = 1; j <= kLargestJump; ++j) {
      const auto step = static_cast<float>(j);
      const float cost = kJumpPenalty * step * step;
      const float up = before[r - j] - cost, down = before[r + j] - cost;
      best_jump = up > best ? -step : best_jump;
      best = up > best ? up : best;
      best_jump = down > best ? step : best_jump;
      best = down > best ? down : best;
    }
    const float gain = sign * contrast[r];
    score[r] = best + (gain > 0.0F ? gain : 0.0F);
    jump[r] = best_jump;
  }
}

/// The path from the first to the last column with the highest sum of sign * contrast, less the
/// cost of jumps.
Path best_path(const cv::Mat& contrast, float sign) {
  const int rows = contrast.cols, cols = contrast.rows;
  constexpr float kUnreachable = -1e9F;
  const auto padded = static_cast<std::size_t>(std::ptrdiff_t{2} * kLargestJump + rows);
  std::vector<float> before(padded, kUnreachable), score(padded, kUnreachable);
  cv::Mat jumps(cols, rows, CV_32FC1);
  std::fill_n(before.begin() + kLargestJump, rows, 0.0F);
  for (int c = 0; c < cols; ++c) {
    best_jumps(before.data() + kLargestJump, contrast.ptr<float>(c), sign, rows,
               score.data() + kLargestJump, jumps.ptr<float>(c));
    std::swap(before, score);
  }
  Path path;
  path.row.resize(static_cast<std::size_t>(cols));
  auto r = static_cast<int>(std::max_element(before.begin(), before.end()) - before.begin()) -
           kLargestJump;
  for (int c = cols - 1; c >= 0; --c) {
    path.row[static_cast<std::size_t>(c)] = static_cast<float>(r) + 0.5F;
    r += static_cast<int>(jumps.at<float>(c, r));
  }
  return path;
}

/// `contrast` between two paths, the upper first, and zero elsewhere.
cv::Mat between(const cv::Mat& contrast, const Path& upper, const Path& lower) {
  constexpr int kGap = 2;  // rows that an edge extends over
  cv::Mat inner = cv::Mat::zeros(contrast.size(), CV_32FC1);
  for (int c = 0; c < contrast.rows; ++c) {
    const auto k = static_cast<std::size_t>(c);
    const int first = static_cast<int>(upper.row[k]) + 1 + kGap;
    const int last = static_cast<int>(lower.row[k]) - 1 - kGap;
    for (int r = first; r <= last; ++r) inner.at<float>(c, r) = contrast.at<float>(c, r);
  }
  return inner;
}

/// Columns where the path follows a step of its sign.
std::vector<char> steps_along(const cv::Mat& contrast, const Path& path, float sign) {
  constexpr float kStep = 0.1F;  // fraction of the column's range
  std::vector<char> steps(path.row.size());
  for (std::size_t c = 0; c < steps.size(); ++c)
    steps[c] = static_cast<char>(
        sign * contrast.at<float>(static_cast<int>(c), static_cast<int>(path.row[c])) > kStep);
  return steps;
}

/// The longest stretch [first, end) of true values; small gaps are allowed.
std::pair<std::size_t, std::size_t> longest_stretch(const std::vector<char>& values) {
  constexpr std::size_t kGap = 4;
  std::pair<std::size_t, std::size_t> longest{0, 0};
  std::size_t first = 0, last = 0;
  bool open = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) continue;
    if (!open || i - last > kGap) first = i;
    open = true;
    last = i;
    if (last + 1 - first > longest.second - longest.first) longest = {first, last + 1};
  }
  return longest;
}

/// True when `path` passes, for a few columns in the direction, where the end of `inner` at `at`
/// points to. These need not be the next columns: it may have left for the border, or for dots on
/// the side face, some columns before.
bool continues_inner(const Path& path, const Path& inner, std::size_t at, int direction) {
  constexpr float kNear = 1.6F;  // rows
  constexpr int kBase = 10, kSearch = 30, kMinNear = 5;
  const auto count = static_cast<int>(path.row.size());
  const auto end = static_cast<int>(at);
  const int base = std::clamp(end - direction * kBase, 0, count - 1);
  if (base == end) return false;
  const float slope =
      (inner.row[at] - inner.row[static_cast<std::size_t>(base)]) / static_cast<float>(end - base);
  int near = 0;
  for (int c = end + direction; c >= 0 && c < count && std::abs(c - end) <= kSearch;
       c += direction) {
    const float ahead = inner.row[at] + slope * static_cast<float>(c - end);
    near += std::abs(path.row[static_cast<std::size_t>(c)] - ahead) < kNear;
  }
  return near >= kMinNear;
}

/// Replaces a first pair of edges on lit side faces by the face's own edges. Outer borders of lit
/// side faces may have more contrast, along all or part of the finger. A second pair of edges of
/// the same signs between the first is the face. An object on the face shows steps of the opposite
/// sign. Between two contacts the signs agree, but only in few columns away from both ends.
void select_inner_edges(const cv::Mat& contrast, float sign, RoughEdges& rough) {
  constexpr double kFractionToEnd = 0.15, kFractionBetween = 0.4;  // of the columns
  const cv::Mat inner = between(contrast, rough.upper, rough.lower);
  const Path upper = best_path(inner, sign), lower = best_path(inner, -sign);
  const auto upper_steps = steps_along(inner, upper, sign);
  const auto lower_steps = steps_along(inner, lower, -sign);
  std::vector<char> both(upper_steps.size());
  for (std::size_t c = 0; c < both.size(); ++c)
    both[c] = static_cast<char>(upper_steps[c] && lower_steps[c] && upper.row[c] < lower.row[c]);
  const auto [first, end] = longest_stretch(both);
  constexpr std::size_t kNearEnd = 3;
  const bool to_an_end = first <= kNearEnd || end + kNearEnd >= both.size();
  const double part = static_cast<double>(end - first) / static_cast<double>(both.size());
  if (part < (to_an_end ? kFractionToEnd : kFractionBetween)) return;
  // Beyond the stretch the first pair may already be the face's own edges, where the path left them
  // for the border. Then they continue where the inner ones end.
  const bool before = first > 0 && continues_inner(rough.upper, upper, first, -1) &&
                      continues_inner(rough.lower, lower, first, -1);
  const bool after = end < both.size() && continues_inner(rough.upper, upper, end - 1, 1) &&
                     continues_inner(rough.lower, lower, end - 1, 1);
  for (std::size_t c = 0; c < both.size(); ++c) {
    const bool inside = c >= first && c < end;
    const bool joined = (before && c < first) || (after && c >= end);
    rough.can_seed[c] = static_cast<char>((inside && both[c]) || joined);
    if (joined) continue;
    rough.upper.row[c] = upper.row[c];
    rough.lower.row[c] = lower.row[c];
  }
}

}  // namespace

std::pair<double, double> RoughEdges::position_at(const Path& path, int block, double u) {
  const double column = (u + 0.5) / block - 0.5;
  const int centre = static_cast<int>(std::lround(column));
  const int count = static_cast<int>(path.row.size());
  // Regression line through the neighbours.
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (int c = std::max(0, centre - 3); c <= std::min(count - 1, centre + 3); ++c) {
    const double x = c - column;
    const double y = static_cast<double>(path.row[static_cast<std::size_t>(c)]);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double determinant = n * sxx - sx * sx;
  const double slope = determinant > 0.0 ? (n * sxy - sx * sy) / determinant : 0.0;
  const double row = (sy - slope * sx) / n;
  return {(row + 0.5) * block - 0.5, slope};
}

std::optional<RoughEdges> find_rough_edges(const cv::Mat& grey, double noise_sd) {
  RoughEdges rough;
  rough.block = std::max(1, grey.cols / kSmallWidth);
  if (grey.cols / rough.block < 8 || grey.rows / rough.block < 8) return std::nullopt;
  const cv::Mat contrast = downward_contrast(block_columns(grey, rough.block), noise_sd);
  const Path rising = best_path(contrast, 1.0F), falling = best_path(contrast, -1.0F);
  std::size_t above = 0;  // columns where brightness rises before it falls
  for (std::size_t c = 0; c < rising.row.size(); ++c) above += rising.row[c] < falling.row[c];
  if (10 * above >= 9 * rising.row.size()) {
    rough.upper = rising, rough.lower = falling;
  } else if (10 * above <= rising.row.size()) {
    rough.upper = falling, rough.lower = rising;
    rough.bright_inside = false;
  } else {
    return std::nullopt;
  }
  rough.can_seed.assign(rising.row.size(), 1);
  select_inner_edges(contrast, rough.bright_inside ? 1.0F : -1.0F, rough);
  return rough;
}

namespace {

// Rows of a transition on each side of its middle; the levels are measured between the near and the
// far row.
constexpr int kNear = 3, kFar = 8;
constexpr int kNearBlurred = 6, kFarBlurred = 11;
constexpr double kBlurred = 3.2;  // contrast over slope, rows: a wider transition is blurred
// Noise of the crossing's level, relative to the noise of one row. It combines the two rows around
// the crossing and half the sum of two lines through kFar - kNear + 1 rows, extrapolated to the
// step.
constexpr double kCrossingNoise = 1.2;
/// Smallest contrast of an edge, and relative to the noise of one row. The difference between two
/// means of kFar - kNear + 1 rows has 0.6 of that noise. At the tip, where little light arrives,
/// contrast is low. Near a dot a step of low contrast may be the dot's own.
struct LeastContrast {
  double grey_levels, times_noise;
};
constexpr LeastContrast kLeastContrast{2.0, 5.0}, kLeastNearDot{3.0, 8.0};

constexpr int kStepMargin =
    // Rows beyond a step that it reads on each side
    kNearBlurred + kFarBlurred + 1;
constexpr int kReach =
    EdgeReader::kMaxReach + kStepMargin;  // rows of the band on each side of its middle

/// Adds to `sums` the interpolation between two neighbouring rows at each of `count` positions.
/// `part`: where the edge's own row lies between them. `column` has one value more than `count`.
ALLTACT_WIDE void add_column(const std::uint8_t* __restrict column, float part, int count,
                             float* __restrict sums) {
  for (int i = 0; i < count; ++i) {
    const auto here = static_cast<float>(column[i]), next = static_cast<float>(column[i + 1]);
    sums[i] += here + part * (next - here);
  }
}

/// Brightness across the edge: the mean of several columns along its slope, bilinear across it. Row
/// kReach is the middle. Rows are read on demand.
class Profile {
 public:
  Profile(const cv::Mat& grey, double u, double v, double slope, int columns)
      : grey_(grey),
        u_(u),
        v_(v),
        slope_(slope),
        columns_(columns),
        first_column_(static_cast<int>(std::lround(u - 0.5 * (columns - 1)))) {}

  [[nodiscard]] bool is_in_image() const {
    if (first_column_ < 0 || first_column_ + columns_ > grey_.cols) return false;
    for (int k = 0; k < columns_; ++k)
      if (const double middle = middle_of(k); middle < 0 || middle >= grey_.rows) return false;
    return true;
  }
  /// Reads the rows [first, last], unless they are available; within [0, 2 kReach].
  void ensure_rows(int first, int last) {
    if (last_ < first_) {
      read(first, last);
      first_ = first, last_ = last;
      return;
    }
    if (first < first_) read(first, first_ - 1);
    if (last > last_) read(last_ + 1, last);
    first_ = std::min(first, first_), last_ = std::max(last, last_);
  }
  [[nodiscard]] float operator[](std::size_t i) const { return values_[i]; }

 private:
  /// Predicted row of the edge in a column.
  [[nodiscard]] double middle_of(int k) const { return v_ + slope_ * (first_column_ + k - u_); }

  void read(int first, int last) {
    float* const begin = values_.data() + first;
    const int count = last - first + 1;
    std::fill_n(begin, count, 0.0F);
    std::array<std::uint8_t, 2 * kReach + 2> column;
    for (int k = 0; k < columns_; ++k) {
      const double middle = middle_of(k), floor = std::floor(middle);
      const int row = static_cast<int>(floor) + first - kReach;
      copy_column(first_column_ + k, row, count + 1, column.data());
      add_column(column.data(), static_cast<float>(middle - floor), count, begin);
    }
    for (int i = 0; i < count; ++i) begin[i] /= static_cast<float>(columns_);
  }

  void copy_column(int u, int row, int count, std::uint8_t* column) const {
    if (row >= 0 && row + count <= grey_.rows) {
      const std::uint8_t* pixel = grey_.ptr<std::uint8_t>(row) + u;
      for (int i = 0; i < count; ++i, pixel += grey_.step[0]) column[i] = *pixel;
      return;
    }
    // Beyond the border of the image its last row is repeated, so that no step appears.
    for (int i = 0; i < count; ++i)
      column[i] = grey_.at<std::uint8_t>(std::clamp(row + i, 0, grey_.rows - 1), u);
  }

  const cv::Mat& grey_;
  double u_, v_, slope_;
  int columns_, first_column_;
  int first_ = 0, last_ = -1;  // rows in values_
  std::array<float, 2 * kReach + 1> values_;
};

/// Row before the step that is the face's edge, and how much steeper it is there than around: the
/// innermost of all steps of the right sign that are steep enough. The outer border of a narrow
/// side face and the dots on it are as steep, but further out. Dots may even be steeper than the
/// expected edge. A face that darkens towards its edge rises over many rows behind the step,
/// nowhere steeper than around.
std::optional<std::pair<int, float>> innermost_step(Profile& profile, float sign, bool face_below,
                                                    int reach, float expected_steepness) {
  constexpr float kMinSteepness = 0.4F;           // fraction of the steepest
  constexpr int kAroundNear = 4, kAroundFar = 7;  // rows on each side that count as around
  const int first = kReach - reach, last = kReach + reach - 1;
  profile.ensure_rows(first - 2 - kAroundFar, last + 3 + kAroundFar);
  std::array<float, 2 * kReach + 1> rises, steepness;
  for (int i = first - 1 - kAroundFar; i <= last + 1 + kAroundFar; ++i) {
    const auto k = static_cast<std::size_t>(i);
    rises[k] = sign * (profile[k + 2] + profile[k + 1] - profile[k] - profile[k - 1]);
  }
  const auto rise = [&](int i) { return rises[static_cast<std::size_t>(i)]; };
  const auto mean_rise = [&](int from) {
    float sum = 0;
    for (int i = from; i <= from + kAroundFar - kAroundNear; ++i) sum += rise(i);
    return std::max(sum, 0.0F) / (kAroundFar - kAroundNear + 1);
  };
  for (int i = first - 1; i <= last + 1; ++i)
    steepness[static_cast<std::size_t>(i)] =
        rise(i) - 0.5F * (mean_rise(i - kAroundFar) + mean_rise(i + kAroundNear));
  const auto steep = [&](int i) { return steepness[static_cast<std::size_t>(i)]; };
  float steepest = 0;
  for (int i = first; i <= last; ++i) steepest = std::max(steepest, steep(i));
  if (!(steepest > 0)) return std::nullopt;
  steepest = std::min(steepest, expected_steepness);
  for (int n = 0; n <= last - first; ++n) {
    const int i = face_below ? last - n : first + n;
    if (steep(i) >= kMinSteepness * steepest && steep(i) >= steep(i - 1) &&
        steep(i) >= steep(i + 1))
      return std::pair(i, steep(i));
  }
  return std::nullopt;
}

/// Brightness on one side of a step, as a line.
struct Level {
  float mean, slope, middle;  // slope: per row; middle: row of the mean
  [[nodiscard]] float at(int i) const { return mean + slope * (static_cast<float>(i) - middle); }
};

Level level_of(const Profile& profile, int from, int to) {
  float sum = 0, moment = 0, square = 0;
  const float middle = 0.5F * static_cast<float>(from + to);
  for (int i = from; i <= to; ++i) {
    const float x = static_cast<float>(i) - middle, y = profile[static_cast<std::size_t>(i)];
    sum += y, moment += x * y, square += x * x;
  }
  return {sum / static_cast<float>(to - from + 1), moment / square, middle};
}

/// The crossing nearest to row `twice_middle` / 2 of the mean of both sides' levels. Brightness
/// changes along both sides, so that the levels are lines extrapolated to the step. Constants would
/// bias the crossing towards the side that changes more. `outside`: the level outside the face,
/// where a dot hides it.
std::optional<EdgeCrossing> crossing_between_levels(Profile& profile, float sign, bool face_below,
                                                    int twice_middle, bool blurred, double noise,
                                                    std::optional<float> outside) {
  const int near = blurred ? kNearBlurred : kNear, far = blurred ? kFarBlurred : kFar;
  const int inner = (twice_middle + 2 * near) / 2;  // first row of the far side
  const int outer = (twice_middle + 2 * far - 1) / 2;
  profile.ensure_rows(twice_middle - outer, outer);
  Level before = level_of(profile, twice_middle - outer, twice_middle - inner);
  Level after = level_of(profile, inner, outer);
  if (outside) (face_below ? before : after) = {*outside, 0.0F, 0.0F};
  const float contrast = sign * (after.mean - before.mean);
  const auto& least = outside ? kLeastNearDot : kLeastContrast;
  if (contrast < std::max(least.grey_levels, least.times_noise * noise)) return std::nullopt;
  const auto above = [&](int i) {
    return sign * (profile[static_cast<std::size_t>(i)] - 0.5F * (before.at(i) + after.at(i)));
  };
  const int middle = twice_middle / 2;
  for (int away = 0; away < near; ++away)
    for (const int i : {middle - away, middle + away}) {
      const float a = above(i), b = above(i + 1);
      if (a > 0.0F || b <= 0.0F) continue;
      const double slope = static_cast<double>(b - a);
      // A dot in contact with the edge hides the level outside it.
      constexpr int kGap = 2;
      constexpr float kContrastFraction = 0.2F;
      const int gap = face_below ? i - kGap : i + 1 + kGap;
      if (outside && std::abs(profile[static_cast<std::size_t>(gap)] - *outside) >
                         kContrastFraction * contrast)
        return std::nullopt;
      return EdgeCrossing{i + static_cast<double>(-a) / slope - kReach,
                          std::hypot(kCrossingNoise * noise / slope, 0.02),
                          static_cast<double>(contrast),
                          static_cast<double>(face_below ? before.mean : after.mean), slope};
    }
  return std::nullopt;
}

/// sign: +1 when brightness rises with v; face_below: the face is at larger v.
std::optional<EdgeCrossing> mid_level_crossing(Profile& profile, float sign, bool face_below,
                                               int reach, double noise_sd, int columns,
                                               const ExpectedEdge& expected) {
  const auto step = innermost_step(profile, sign, face_below, reach, expected.steepness);
  if (!step) return std::nullopt;
  const double noise = noise_sd / std::sqrt(static_cast<double>(columns));
  std::optional<EdgeCrossing> crossing;
  int twice_middle = 2 * step->first + 1;  // the step is between this row and the next
  // Blur reaches the rows that the levels are measured in. It cancels only where both sides are
  // equally far from the crossing, so the crossing is searched again.
  bool blurred = false;
  for (int round = 0; round < 2; ++round) {
    crossing = crossing_between_levels(profile, sign, face_below, twice_middle, blurred, noise,
                                       expected.outside);
    if (!crossing) return std::nullopt;
    blurred = crossing->contrast > kBlurred * crossing->slope;
    twice_middle = static_cast<int>(std::lround(2.0 * (crossing->offset + kReach)));
  }
  crossing->steepness = step->second;
  return crossing;
}

/// The steepest step between two pixels of one column.
std::optional<EdgeCrossing> integer_step(const cv::Mat& grey, double u, double v, float sign,
                                         int reach) {
  const int column = static_cast<int>(std::lround(u));
  const int centre = static_cast<int>(std::lround(v));
  int best_row = -1, best = 0;
  for (int row = std::max(centre - reach, 1); row <= std::min(centre + reach, grey.rows - 1);
       ++row) {
    const int step = static_cast<int>(sign) *
                     (grey.at<std::uint8_t>(row, column) - grey.at<std::uint8_t>(row - 1, column));
    if (step > best) best = step, best_row = row;
  }
  if (best_row < 0 || best < 3) return std::nullopt;
  return EdgeCrossing{best_row - v, 0.29, static_cast<double>(best)};
}

}  // namespace

std::optional<EdgeCrossing> EdgeReader::at(double u, double v, double slope, int reach,
                                           const ExpectedEdge& expected) const {
  if (options_.method == EdgeMethod::kInteger) return integer_step(grey_, u, v, sign_, reach);
  Profile profile(grey_, u, v, slope, options_.columns);
  if (!profile.is_in_image()) return std::nullopt;
  return mid_level_crossing(profile, sign_, face_below_, reach, noise_sd_, options_.columns,
                            expected);
}

}  // namespace alltact
