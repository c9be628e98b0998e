#include "core/sensing/face/outline_jump.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace alltact {
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

  void add(const Outline& outline,
           const std::vector<double>& v,
           std::size_t first,
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
