#include "core/sensing/face/face_edges.h"

#include "core/numerics/dispatch.h"
#include "core/numerics/image_noise.h"
#include "core/sensing/face/darkened_edge.h"
#include "core/sensing/face/edge_tracing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace alltact {
namespace {

/// Invalidates samples beyond the ends of the face.
void invalidate_beyond(const FaceEnds& ends, double half_step, FaceEdges& edges) {
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
  edges.noise_sd = image_noise_sd(grey);
  const Error lost{en::say("the two long edges of the face were not found"), en::say("the image"),
                   en::say("light the finger as in its recording; check that the image shows the "
                           "face from base to tip, with the finger along the image's width")};
  const auto rough = find_rough_edges(grey, edges.noise_sd);
  if (!rough) return lost;
  edges.bright_inside = rough->bright_inside;

  const int step = std::max(options_.columns, 1);
  for (int u = 0; u + step <= grey.cols; u += step) edges.u.push_back(u + 0.5 * (step - 1));
  const float sign = rough->bright_inside ? 1.0F : -1.0F;
  const EdgeReader upper(grey, options_, edges.noise_sd, sign, true);
  const EdgeReader lower(grey, options_, edges.noise_sd, -sign, false);
  edges.upper = find_edge(upper, *rough, rough->upper, edges.u);
  edges.lower = find_edge(lower, *rough, rough->lower, edges.u);
  if (options_.method == EdgeMethod::kCrossing) {
    move_to_darkened_edge(grey, edges.u, true, &edges.upper);
    move_to_darkened_edge(grey, edges.u, false, &edges.lower);
  }
  edges.ends = find_face_ends(grey, edges, options_.view ? &*options_.view : nullptr);
  invalidate_beyond(edges.ends, 0.25 * step, edges);

  std::size_t both = 0;
  for (std::size_t i = 0; i < edges.u.size(); ++i)
    both += edges.upper.valid[i] && edges.lower.valid[i];
  if (5 * both < edges.u.size()) return lost;
  return edges;
}

namespace {

constexpr int kStrips = 9;
constexpr int kMaxSteps = 3;  // of one strip, those of highest contrast
// The levels are measured from kEndNear to kEndFar columns away. In a small image the base is near
// the border. There the level beyond it is constant, over at least kMinBeyond columns of which
// the first may belong to the step.
constexpr int kEndNear = 3, kEndFar = 9, kMinBeyond = 3;
constexpr int kInside = 20;   // columns searched inwards of the last sample of the edges
constexpr int kBeyond = 120;  // and outwards
constexpr double kMaxSlope = 0.7;
constexpr double kOnLinePx = 1.2;
constexpr std::size_t kMinStrips = 4;  // on a line within the image; for one that leaves it...
constexpr std::size_t kMinStripsAtBorder = 3;

double square(double x) { return x * x; }

/// Straight line through the outermost_samples samples of an edge: v = v0 + slope (u - u0).
struct EdgeLine {
  double u0 = 0, v0 = 0, slope = 0;
  [[nodiscard]] double at(double u) const { return v0 + slope * (u - u0); }
};

EdgeLine line_through(const std::vector<double>& u, const std::vector<double>& v,
                      const std::vector<std::size_t>& samples) {
  const auto n = static_cast<double>(samples.size());
  double su = 0, sv = 0, suu = 0, suv = 0;
  for (const std::size_t i : samples) su += u[i], sv += v[i];
  const double mean_u = su / n, mean_v = sv / n;
  for (const std::size_t i : samples) {
    suu += (u[i] - mean_u) * (u[i] - mean_u);
    suv += (u[i] - mean_u) * (v[i] - mean_v);
  }
  return {mean_u, mean_v, suu > 0.0 ? suv / suu : 0.0};
}

/// The outermost_samples samples with both edges valid, outermost_samples first. Empty without a
/// stretch of them.
std::vector<std::size_t> outermost_samples(const FaceEdges& edges, bool at_last) {
  constexpr std::size_t kSamples = 8, kStretch = 12, kMinSamples = 5;
  const std::size_t count = edges.u.size();
  const auto sample = [&](std::size_t n) { return at_last ? count - 1 - n : n; };
  for (std::size_t first = 0; first + kMinSamples <= count; ++first) {
    std::vector<std::size_t> seen;
    const std::size_t end = std::min(first + kStretch, count);
    for (std::size_t n = first; n < end && seen.size() < kSamples; ++n)
      if (edges.upper.valid[sample(n)] && edges.lower.valid[sample(n)]) seen.push_back(sample(n));
    if (seen.size() >= kMinSamples && seen.front() == sample(first)) return seen;
  }
  return {};
}

/// Bow of FaceEnd, about the middle of both edges, of a straight line across the face that meets
/// both edges in column u. 0 for a line that the camera cannot image.
double bow_per_px(const FaceView& view, double u, double upper_v, double lower_v) {
  const double half = 0.5 * (lower_v - upper_v);
  const auto upper = view.camera.unproject({u, upper_v}),
             lower = view.camera.unproject({u, lower_v});
  if (!(half >= 1.0) || !upper || !lower) return 0.0;
  // Both corners have the same z: where the rays are as far apart as the face is wide.
  const Eigen::Vector3d begin_mm = lower->origin_mm - upper->origin_mm;
  const Eigen::Vector3d apart = lower->direction - upper->direction;
  const double z_mm = (view.width_mm - begin_mm.y()) / apart.y();
  if (!(z_mm > 0.0) || !std::isfinite(z_mm)) return 0.0;
  const auto middle = view.camera.project(upper->origin_mm + z_mm * upper->direction +
                                          0.5 * (begin_mm + z_mm * apart));
  return middle ? (u - middle->x()) / (half * half) : 0.0;
}

/// A step of brightness along a strip.
struct Step {
  double u = 0, v = 0;  // u of the straight line before the view bends it
  double contrast = 0;  // grey levels, > 0
};

/// Value at x = 0 and slope of a regression line through values at x = first, first + 1, ..
struct EndLevel {
  double value = 0, slope = 0;
};
EndLevel end_level(const std::vector<float>& values, int centre, int first, int last) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (int x = first; x <= last; ++x) {
    const auto y =
        static_cast<double>(values[static_cast<std::size_t>(std::ptrdiff_t{centre} + x)]);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  return {(sy - slope * sx) / n, slope};
}

/// Adds a pixel row to the sums of the columns whose rows [first, last] contain row v.
ALLTACT_WIDE void add_between(const std::uint8_t* __restrict row, int v,
                              const std::int32_t* __restrict first,
                              const std::int32_t* __restrict last, int count,
                              std::int32_t* __restrict sums) {
  for (int k = 0; k < count; ++k)
    sums[k] += row[k] & -static_cast<std::int32_t>((v >= first[k]) & (v <= last[k]));
}

/// Finds one end of the face.
class EndReader {
 public:
  EndReader(const cv::Mat& grey, const FaceEdges& edges, const FaceView* view, bool at_last)
      : grey_(grey), edges_(edges), view_(view), outwards_(at_last ? 1 : -1) {}

  [[nodiscard]] std::optional<FaceEnd> operator()() {
    const std::vector<std::size_t> samples = outermost_samples(edges_, outwards_ > 0);
    if (samples.empty()) return std::nullopt;
    upper_ = line_through(edges_.u, edges_.upper.v, samples);
    lower_ = line_through(edges_.u, edges_.lower.v, samples);
    const int from = static_cast<int>(std::lround(edges_.u[samples.front()]));
    const double half = 0.5 * (lower_.at(from) - upper_.at(from));
    const int bow = static_cast<int>(std::abs(bow_at(from)) * square(half));
    start_ = from - outwards_ * (kInside + kEndFar + bow);
    const int border = outwards_ > 0 ? grey_.cols - 1 - start_ : start_;
    count_ = std::min(kInside + kEndFar + bow + kBeyond + kEndFar, border + 1);
    if (start_ < 0 || start_ >= grey_.cols || count_ < kInside + kEndFar) return std::nullopt;
    for (int strip = 0; strip < kStrips; ++strip) read_steps(strip);
    return best_line();
  }

 private:
  [[nodiscard]] int column(int i) const { return start_ + outwards_ * i; }

  /// As a fraction from the upper to the lower edge.
  [[nodiscard]] static double centre_of(int strip) { return (strip + 1.0) / (kStrips + 1.0); }
  [[nodiscard]] double row_of(int strip, double u) const {
    return std::lerp(upper_.at(u), lower_.at(u), centre_of(strip));
  }

  void read_steps(int strip) {
    // Off the edges, where blur mixes in the surroundings of the face.
    const double centre = centre_of(strip), half = 0.4 / (kStrips + 1.0);
    const auto n = static_cast<std::size_t>(count_);
    std::vector<std::int32_t> first(n), last(n), sums(n, 0);
    const int from = std::min(column(0), column(count_ - 1));
    int top_row = grey_.rows, bottom_row = -1;
    for (std::size_t k = 0; k < n; ++k) {
      const int u = from + static_cast<int>(k);
      const double top = upper_.at(u), height = lower_.at(u) - top;
      first[k] = std::clamp(static_cast<int>(std::lround(top + (centre - half) * height)), 0,
                            grey_.rows - 1);
      last[k] = std::clamp(static_cast<int>(std::lround(top + (centre + half) * height)), first[k],
                           grey_.rows - 1);
      top_row = std::min(top_row, first[k]), bottom_row = std::max(bottom_row, last[k]);
    }
    for (int v = top_row; v <= bottom_row; ++v)
      add_between(grey_.ptr<std::uint8_t>(v) + from, v, first.data(), last.data(), count_,
                  sums.data());
    std::vector<float> brightness(n);
    double rows = 1;
    for (int i = 0; i < count_; ++i) {
      const auto k = static_cast<std::size_t>(column(i) - from);
      rows = last[k] - first[k] + 1;
      brightness[static_cast<std::size_t>(i)] = static_cast<float>(sums[k] / rows);
    }
    if (!edges_.bright_inside)
      for (float& value : brightness) value = -value;
    const double min_step = std::max(4.0, 8.0 * edges_.noise_sd / std::sqrt(rows));
    std::vector<Step>& found = steps_[static_cast<std::size_t>(strip)];
    const auto fall = [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      return brightness[k - 1] + brightness[k] - brightness[k + 1] - brightness[k + 2];
    };
    for (int i = kEndFar; i + kMinBeyond < count_; ++i) {
      if (!(fall(i) > 0.0F) || fall(i) < fall(i - 1) || fall(i) <= fall(i + 1)) continue;
      const auto step = step_at(brightness, i);
      if (!step || step->contrast < min_step) continue;
      found.push_back(*step);
      found.back().v = row_of(strip, step->u);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Step& a, const Step& b) { return a.contrast > b.contrast; });
    if (found.size() > kMaxSteps) found.resize(kMaxSteps);
    for (Step& step : found) step.u -= bow_at(step.u) * square(step.v - middle_at(step.u));
  }

  [[nodiscard]] double middle_at(double u) const { return 0.5 * (upper_.at(u) + lower_.at(u)); }
  [[nodiscard]] double bow_at(double u) const {
    return view_ != nullptr ? bow_per_px(*view_, u, upper_.at(u), lower_.at(u)) : 0.0;
  }

  [[nodiscard]] EndLevel level_beyond(const std::vector<float>& brightness, int i) const {
    const int far = std::min(kEndFar, count_ - 1 - i);
    if (far >= kEndNear + 2) return end_level(brightness, i, kEndNear, far);
    double sum = 0;
    for (int x = 2; x <= far; ++x)
      sum += static_cast<double>(brightness[static_cast<std::size_t>(std::ptrdiff_t{i} + x)]);
    return {sum / (far - 1), 0};
  }

  /// Crossing of the mean of both sides' levels, each a line: the face darkens towards its end.
  [[nodiscard]] std::optional<Step> step_at(const std::vector<float>& brightness, int i) const {
    const EndLevel inside = end_level(brightness, i, -kEndFar, -kEndNear + 1);
    const EndLevel outside = level_beyond(brightness, i);
    const auto above = [&](int x) {
      const double half = 0.5 * (inside.value + outside.value + x * (inside.slope + outside.slope));
      return static_cast<double>(brightness[static_cast<std::size_t>(std::ptrdiff_t{i} + x)]) -
             half;
    };
    const double contrast = inside.value + 0.5 * inside.slope - outside.value - 0.5 * outside.slope;
    if (!(contrast > 0.0)) return std::nullopt;
    for (int x = -kEndNear + 1; x < std::min(kEndNear, count_ - 1 - i); ++x) {
      const double a = above(x), b = above(x + 1);
      if (a >= 0.0 && b < 0.0) return Step{start_ + outwards_ * (i + x + a / (a - b)), 0, contrast};
    }
    return std::nullopt;
  }

  /// The nearest step of a strip on the line; nullptr where there is none.
  [[nodiscard]] const Step* on_line(const std::vector<Step>& steps, double u0, double v0,
                                    double slope) const {
    const Step* nearest = nullptr;
    double nearest_px = kOnLinePx;
    for (const Step& step : steps) {
      const double off = std::abs(step.u - u0 - slope * (step.v - v0));
      if (off < nearest_px) nearest_px = off, nearest = &step;
    }
    return nearest;
  }

  /// A leaning end near the border of the image is seen in a few strips only.
  [[nodiscard]] std::size_t min_strips(const Step& on_it, double slope) const {
    std::size_t inside = 0;
    for (int strip = 0; strip < kStrips; ++strip) {
      const double v = row_of(strip, on_it.u);
      const double i = outwards_ * (on_it.u + slope * (v - on_it.v) - start_);
      inside += i + kMinBeyond + 1 < count_;
    }
    return inside < kStrips ? kMinStripsAtBorder : kMinStrips;
  }

  [[nodiscard]] std::optional<FaceEnd> best_line() const {
    double best_score = 0;
    std::vector<const Step*> best;
    for (std::size_t a = 0; a < kStrips; ++a)
      for (std::size_t b = a + 2; b < kStrips; ++b)
        for (const Step& from : steps_[a])
          for (const Step& to : steps_[b]) {
            const double slope = (to.u - from.u) / (to.v - from.v);
            if (!(std::abs(slope) <= kMaxSlope)) continue;
            double score = 0;
            std::vector<const Step*> line;
            for (const auto& steps : steps_)
              if (const Step* step = on_line(steps, from.u, from.v, slope))
                line.push_back(step), score += step->contrast;
            if (score > best_score && line.size() >= min_strips(from, slope))
              best_score = score, best = std::move(line);
          }
    if (best.empty()) return std::nullopt;
    return line_of(best);
  }

  [[nodiscard]] FaceEnd line_of(const std::vector<const Step*>& steps) const {
    const auto n = static_cast<double>(steps.size());
    double su = 0, sv = 0, svv = 0, suv = 0;
    for (const Step* step : steps) su += step->u, sv += step->v;
    const double mean_u = su / n, mean_v = sv / n;
    for (const Step* step : steps) {
      svv += (step->v - mean_v) * (step->v - mean_v);
      suv += (step->u - mean_u) * (step->v - mean_v);
    }
    const double slope = svv > 0.0 ? suv / svv : 0.0;
    double sum = 0;
    for (const Step* step : steps) sum += square(step->u - mean_u - slope * (step->v - mean_v));
    const double sd_px = std::hypot(0.02, std::sqrt(sum / (n - 2.0) / n));
    if (view_ == nullptr) return {mean_u, mean_v, slope, 0.0, sd_px};
    const double middle = middle_at(mean_u);
    return {mean_u + slope * (middle - mean_v), middle, slope, bow_at(mean_u), sd_px};
  }

  const cv::Mat& grey_;
  const FaceEdges& edges_;
  const FaceView* view_;
  int outwards_;
  EdgeLine upper_, lower_;
  int start_ = 0, count_ = 0;  // columns read, from the inside outwards
  std::array<std::vector<Step>, kStrips> steps_;
};

}  // namespace

FaceEnds find_face_ends(const cv::Mat& grey, const FaceEdges& edges, const FaceView* view) {
  if (view != nullptr && (view->camera.is_linear() || !view->camera.is_perspective()))
    view = nullptr;  // such a camera images straight lines as straight
  return {EndReader(grey, edges, view, false)(), EndReader(grey, edges, view, true)()};
}

namespace {

constexpr std::size_t kSideSamples =
    4;                                  // samples that give the direction of an edge on one side...
constexpr std::size_t kMinSamples = 2;  // ...and their minimum number
constexpr double kMinFraction =
    0.05;                           // fraction of the face's width: the two edges' jumps together
constexpr double kTimesBend = 3.0;  // an edge's jump, relative to the range of its slopes
constexpr double kTimesSd = 8.0;    // and relative to the scatter of its samples
constexpr double kMaxGap = 0.1;     // fraction of the outline: over a wider gap it may bend
constexpr double kMaxReturn = 0.5;  // fraction of a jump: a larger return cancels it

/// Columns with both edges valid.
struct Outline {
  std::vector<double> u, upper_v, lower_v, sd;
};

Outline outline_of(const FaceEdges& edges) {
  Outline outline;
  for (std::size_t i = 0; i < edges.u.size(); ++i) {
    if (!edges.upper.valid[i] || !edges.lower.valid[i]) continue;
    outline.u.push_back(edges.u[i]);
    outline.upper_v.push_back(edges.upper.v[i]);
    outline.lower_v.push_back(edges.lower.v[i]);
    outline.sd.push_back(std::max(edges.upper.sd[i], edges.lower.sd[i]));
  }
  return outline;
}

/// Slopes of an edge (rows per column) between neighbours on either side of a gap.
struct Slopes {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;

  void add(const Outline& outline, const std::vector<double>& v, std::size_t first,
           std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const double slope = (v[i + 1] - v[i]) / (outline.u[i + 1] - outline.u[i]);
      lowest = std::min(lowest, slope), highest = std::max(highest, slope);
    }
  }
};

/// Rows that an edge jumps by from sample k to the next; 0 where slopes or scatter on either side
/// explain it.
double edge_jump(const Outline& outline, const std::vector<double>& v, std::size_t k) {
  Slopes slopes;
  slopes.add(outline, v, k + 1 - std::min(kSideSamples, k + 1), k);
  slopes.add(outline, v, k + 1, std::min(k + kSideSamples, v.size() - 1));
  const double columns = outline.u[k + 1] - outline.u[k];
  const double jump = v[k + 1] - v[k] - 0.5 * (slopes.lowest + slopes.highest) * columns;
  const double explained = kTimesBend * (slopes.highest - slopes.lowest) * columns +
                           kTimesSd * std::max(outline.sd[k], outline.sd[k + 1]);
  return std::abs(jump) > explained ? jump : 0.0;
}

/// Rows that the face widens by from sample k to the next through a jump of both edges; else 0.
double width_jump(const Outline& outline, std::size_t k) {
  const double gap = outline.u[k + 1] - outline.u[k];
  if (gap > kMaxGap * (outline.u.back() - outline.u.front())) return 0.0;
  const double upper = edge_jump(outline, outline.upper_v, k),
               lower = edge_jump(outline, outline.lower_v, k);
  if (!(upper * lower < 0.0)) return 0.0;
  const double width = outline.lower_v[k] - outline.upper_v[k], wider = lower - upper;
  return std::abs(wider) > kMinFraction * width ? wider : 0.0;
}

}  // namespace

std::optional<OutlineJump> outline_jump(const FaceEdges& edges) {
  const Outline outline = outline_of(edges);
  const std::size_t count = outline.u.size();
  double largest = 0, widest = 0, narrowest = 0;
  std::size_t at = 0;
  for (std::size_t k = kMinSamples - 1; k + kMinSamples < count; ++k) {
    const double wider = width_jump(outline, k);
    widest = std::max(widest, wider), narrowest = std::min(narrowest, wider);
    if (std::abs(wider) > std::abs(largest)) largest = wider, at = k;
  }
  const double back = largest > 0.0 ? -narrowest : widest;
  if (largest == 0.0 || back > kMaxReturn * std::abs(largest)) return std::nullopt;
  const std::size_t before = at + 1, behind = count - before;
  return OutlineJump{0.5 * (outline.u[at] + outline.u[at + 1]),
                     static_cast<double>(std::min(before, behind)) / static_cast<double>(count),
                     behind < before};
}

FaceEdges longer_side(FaceEdges edges, const OutlineJump& jump) {
  for (std::size_t i = 0; i < edges.u.size(); ++i)
    if (jump.shorter_at_high_u == (edges.u[i] > jump.u_px))
      edges.upper.valid[i] = edges.lower.valid[i] = 0;
  (jump.shorter_at_high_u ? edges.ends.last : edges.ends.first).reset();
  return edges;
}

}  // namespace alltact
