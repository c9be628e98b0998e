#include "core/sensing/face/face_edges.h"

#include "core/numerics/picture_noise.h"
#include "core/sensing/face/rough_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace alltact {
namespace {

constexpr int kWide = 19;     // rows searched on each side of the rough path
constexpr int kSeedStep = 6;  // of the samples, these may be where following an edge begins
constexpr int kTight = 7;     // and of where the edge goes on
// At which what is expected follows what is found, and where a dot seems to be found.
constexpr float kRate = 0.3F, kDotRate = 0.1F;
// Rows of a transition on each side of its middle; the levels are read from there to the far ones.
constexpr int kNear = 3, kFar = 8;
constexpr int kNearBlurred = 6, kFarBlurred = 11;
constexpr double kBlurred = 3.2;  // contrast over slope, rows, of a transition that is wider
// Noise of the crossing's height, of one row's: that of two rows between which it lies, and of
// half the sum of two lines through kFar - kNear + 1 rows that are continued to the step.
constexpr double kCrossingNoise = 1.2;

constexpr int kBeside =
    kNearBlurred + kFarBlurred + 1;      // rows that a step found takes in on each side
constexpr int kReach = kWide + kBeside;  // rows of the band on each side of its middle

using Profile = std::array<float, 2 * kReach + 1>;

/// The part of a profile that a search within `reach` rows of its middle looks at.
struct Band {
  int first, last;
  explicit Band(int reach) : first(kReach - reach - kBeside), last(kReach + reach + kBeside) {}
};

/// Mean of `columns` columns along the edge's slope, bilinear across it, within the band; false off
/// the picture.
bool read_profile(const cv::Mat& grey,
                  double u,
                  double v,
                  double slope,
                  int columns,
                  const Band& band,
                  Profile& profile) {
  const int first = static_cast<int>(std::lround(u - 0.5 * (columns - 1)));
  if (first < 0 || first + columns > grey.cols) return false;
  float* const begin = profile.data() + band.first;
  const int count = band.last - band.first + 1;
  std::fill_n(begin, count, 0.0F);
  for (int k = 0; k < columns; ++k) {
    const int column = first + k;
    const double middle = v + slope * (column - u);
    const int row = static_cast<int>(std::floor(middle)) + band.first - kReach;
    const auto part = static_cast<float>(middle - std::floor(middle));
    if (middle < 0 || middle >= grey.rows) return false;
    if (row >= 0 && row + count < grey.rows) {
      const std::uint8_t* pixel = grey.ptr<std::uint8_t>(row) + column;
      auto here = static_cast<float>(*pixel);
      for (int i = 0; i < count; ++i) {
        pixel += grey.step[0];
        const auto next = static_cast<float>(*pixel);
        begin[i] += here + part * (next - here);
        here = next;
      }
      continue;
    }
    // Beyond the picture's border its last row goes on: no step is seen there.
    const auto clamped = [&](int r) {
      return static_cast<float>(grey.at<std::uint8_t>(std::clamp(r, 0, grey.rows - 1), column));
    };
    for (int i = 0; i < count; ++i)
      begin[i] += clamped(row + i) + part * (clamped(row + i + 1) - clamped(row + i));
  }
  for (int i = 0; i < count; ++i) begin[i] /= static_cast<float>(columns);
  return true;
}

struct Crossing {
  double offset;  // rows from the band's middle
  double sd;
  double contrast;     // grey levels
  double outside = 0;  // brightness beside the face, grey levels
  double slope = 0;    // grey levels a row
  float rise = 0;      // of the step, as innermost_step() reckons it
};

/// What surrounding samples tell of one.
struct Expected {
  std::optional<float> beside;                          // brightness beside the face, grey levels
  float rise = std::numeric_limits<float>::infinity();  // of the face's edge
};

/// Row before the step that is the face's edge: of all steps of the right sign that are steep
/// enough, the innermost. Beside a narrow side face its outer border and the dots on it are as
/// steep, but further out; dots on it may be steeper than the edge is expected to be.
std::optional<std::pair<int, float>> innermost_step(
    const Profile& profile, float sign, bool face_below, int reach, float expected_rise) {
  constexpr float kSteepEnough = 0.4F;  // of the steepest
  const int first = kReach - reach, last = kReach + reach - 1;
  const auto rise = [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    return sign * (profile[k + 2] + profile[k + 1] - profile[k] - profile[k - 1]);
  };
  float most = 0;
  for (int i = first; i <= last; ++i) most = std::max(most, rise(i));
  if (!(most > 0)) return std::nullopt;
  most = std::min(most, expected_rise);
  for (int n = 0; n <= last - first; ++n) {
    const int i = face_below ? last - n : first + n;
    if (rise(i) >= kSteepEnough * most && rise(i) >= rise(i - 1) && rise(i) >= rise(i + 1))
      return std::pair(i, rise(i));
  }
  return std::nullopt;
}

/// Brightness on one side of a step, a line.
struct Level {
  float mean, slope, middle;  // slope: of a row; middle: row of the mean
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

/// The crossing nearest to half of the row `twice_middle`, half-way between the levels on both
/// sides of that. Brightness changes along both sides of the step, so that the levels are lines,
/// continued to it: constants would draw the crossing towards the side that changes more. `beside`:
/// the level beside the face, where a dot hides it.
std::optional<Crossing> crossing_between_levels(const Profile& profile,
                                                float sign,
                                                bool face_below,
                                                int twice_middle,
                                                bool blurred,
                                                double noise,
                                                std::optional<float> beside) {
  const int near = blurred ? kNearBlurred : kNear, far = blurred ? kFarBlurred : kFar;
  const int inner = (twice_middle + 2 * near) / 2;  // first row of the far side
  const int outer = (twice_middle + 2 * far - 1) / 2;
  Level before = level_of(profile, twice_middle - outer, twice_middle - inner);
  Level after = level_of(profile, inner, outer);
  if (beside) (face_below ? before : after) = {*beside, 0.0F, 0.0F};
  const float contrast = sign * (after.mean - before.mean);
  if (contrast < std::max(3.0, 8.0 * noise)) return std::nullopt;
  const auto above = [&](int i) {
    return sign * (profile[static_cast<std::size_t>(i)] - 0.5F * (before.at(i) + after.at(i)));
  };
  const int middle = twice_middle / 2;
  for (int away = 0; away < near; ++away)
    for (const int i : {middle - away, middle + away}) {
      const float a = above(i), b = above(i + 1);
      if (a > 0.0F || b <= 0.0F) continue;
      const double slope = static_cast<double>(b - a);
      // A dot that touches the edge leaves no level beside it to cross from.
      constexpr int kGap = 2;
      constexpr float kPartOfContrast = 0.2F;
      const int gap = face_below ? i - kGap : i + 1 + kGap;
      if (beside &&
          std::abs(profile[static_cast<std::size_t>(gap)] - *beside) > kPartOfContrast * contrast)
        return std::nullopt;
      return Crossing{i + static_cast<double>(-a) / slope - kReach,
                      std::hypot(kCrossingNoise * noise / slope, 0.02),
                      static_cast<double>(contrast),
                      static_cast<double>(face_below ? before.mean : after.mean),
                      slope};
    }
  return std::nullopt;
}

/// sign: +1 when brightness rises with v; face_below: the face lies at larger v.
std::optional<Crossing> half_way_crossing(const Profile& profile,
                                          float sign,
                                          bool face_below,
                                          int reach,
                                          double noise_sd,
                                          int columns,
                                          const Expected& expected) {
  const auto step = innermost_step(profile, sign, face_below, reach, expected.rise);
  if (!step) return std::nullopt;
  const double noise = noise_sd / std::sqrt(static_cast<double>(columns));
  std::optional<Crossing> crossing;
  int twice_middle = 2 * step->first + 1;  // the step lies between this row and the next
  // Blur reaches to the rows that the levels are read from. It takes as much from one as it gives
  // the other only where both are as far from the crossing, so that is looked for again.
  bool blurred = false;
  for (int round = 0; round < 2; ++round) {
    crossing = crossing_between_levels(
        profile, sign, face_below, twice_middle, blurred, noise, expected.beside);
    if (!crossing) return std::nullopt;
    blurred = crossing->contrast > kBlurred * crossing->slope;
    twice_middle = static_cast<int>(std::lround(2.0 * (crossing->offset + kReach)));
  }
  crossing->rise = step->second;
  return crossing;
}

/// The steepest whole-pixel step of one column.
std::optional<Crossing> integer_step(
    const cv::Mat& grey, double u, double v, float sign, int reach) {
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
  return Crossing{best_row - v, 0.29, static_cast<double>(best)};
}

/// Reads one edge of one picture, sample by sample.
class EdgeReader {
 public:
  EdgeReader(const cv::Mat& grey,
             const FaceEdgeFinder::Options& options,
             double noise_sd,
             float sign,
             bool face_below)
      : grey_(grey), options_(options), noise_sd_(noise_sd), sign_(sign), face_below_(face_below) {}

  [[nodiscard]] std::optional<Crossing> at(
      double u, double v, double slope, int reach, const Expected& expected = {}) const {
    if (options_.method == EdgeMethod::kInteger) return integer_step(grey_, u, v, sign_, reach);
    Profile profile;
    if (!read_profile(grey_, u, v, slope, options_.columns, Band(reach), profile))
      return std::nullopt;
    return half_way_crossing(
        profile, sign_, face_below_, reach, noise_sd_, options_.columns, expected);
  }
  [[nodiscard]] bool reads_levels() const { return options_.method != EdgeMethod::kInteger; }

 private:
  const cv::Mat& grey_;
  const FaceEdgeFinder::Options& options_;
  double noise_sd_;
  float sign_;
  bool face_below_;
};

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
    const Expected expected{static_cast<float>(level[k]), followed.rise[k]};
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
    Expected expected{static_cast<float>(seed.outside), seed.rise};
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

/// Follows the edge from the sample of most contrast; from the next, some way off, where that leads
/// along only a part of the picture or leaves gaps, as dots' own borders do. The rough path alone
/// may leave the face for a side face's outer border where that has more contrast.
void find_edge(const EdgeReader& reader,
               const RoughEdges& rough,
               const RoughEdges::Path& path,
               const std::vector<double>& columns,
               Edge& edge) {
  constexpr int kMostTries = 4;
  const auto count = static_cast<int>(columns.size());
  std::vector<Seed> seeds;
  for (int i = kSeedStep / 2; i < count; i += kSeedStep) {
    const double u = columns[static_cast<std::size_t>(i)];
    const auto small = static_cast<std::size_t>(u / rough.block);
    if (!rough.sure[std::min(small, rough.sure.size() - 1)]) continue;
    const auto [v, slope] = RoughEdges::place(path, rough.block, u);
    const auto crossing = reader.at(u, v, slope, kWide);
    if (crossing)
      seeds.push_back(
          {i, v + crossing->offset, slope, crossing->contrast, crossing->outside, crossing->rise});
  }
  std::stable_sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) {
    return a.contrast > b.contrast;
  });
  edge = unseen(columns.size());
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
}

/// Takes back what was read where the face has ended.
void forget_beyond(const FaceEnds& ends, double half_step, FaceEdges& edges) {
  for (Edge* edge : {&edges.upper, &edges.lower})
    for (std::size_t i = 0; i < edges.u.size(); ++i) {
      const double v = edge->v[i];
      const bool before = ends.first && edges.u[i] - half_step < ends.first->at(v);
      const bool after = ends.last && edges.u[i] + half_step > ends.last->at(v);
      if (before || after) edge->valid[i] = 0;
    }
}

}  // namespace

Result<FaceEdges> FaceEdgeFinder::operator()(const cv::Mat& grey) const {
  CV_Assert(grey.type() == CV_8UC1);
  FaceEdges edges;
  edges.noise_sd = picture_noise_sd(grey);
  const Error lost{
      "the two long edges of the face were not found",
      "the picture",
      "light the finger as in its recording, and check that the picture shows the face "
      "from base to tip with the finger's length along the picture's width"};
  const auto rough = find_roughly(grey, edges.noise_sd);
  if (!rough) return lost;
  edges.bright_inside = rough->bright_inside;

  const int step = std::max(options_.columns, 1);
  for (int u = 0; u + step <= grey.cols; u += step) edges.u.push_back(u + 0.5 * (step - 1));
  const float sign = rough->bright_inside ? 1.0F : -1.0F;
  find_edge(EdgeReader(grey, options_, edges.noise_sd, sign, true),
            *rough,
            rough->upper,
            edges.u,
            edges.upper);
  find_edge(EdgeReader(grey, options_, edges.noise_sd, -sign, false),
            *rough,
            rough->lower,
            edges.u,
            edges.lower);
  edges.ends = find_face_ends(grey, edges, options_.view ? &*options_.view : nullptr);
  forget_beyond(edges.ends, 0.25 * step, edges);

  std::size_t both = 0;
  for (std::size_t i = 0; i < edges.u.size(); ++i)
    both += edges.upper.valid[i] && edges.lower.valid[i];
  if (5 * both < edges.u.size()) return lost;
  return edges;
}

}  // namespace alltact
