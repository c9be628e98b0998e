#include "core/sensing/face/outline_jump.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace alltact {
namespace {

constexpr std::size_t kSide = 4;     // samples that tell where an edge goes on one side...
constexpr std::size_t kFewest = 2;   // ...and so many where there are no more
constexpr double kLeastPart = 0.05;  // of the face's width: the two edges' jumps together
constexpr double kTimesBend = 3.0;   // an edge's jump, against what its slopes differ by
constexpr double kTimesSd = 8.0;     // and against what its samples scatter
constexpr double kMostGap = 0.1;     // of the outline: over a wider gap it may bend anyhow
constexpr double kUndone = 0.5;      // of a jump: one that goes back by more undoes it

/// Columns where both edges are trusted.
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
  double least = std::numeric_limits<double>::infinity(), greatest = -least;

  void add(const Outline& outline,
           const std::vector<double>& v,
           std::size_t first,
           std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const double slope = (v[i + 1] - v[i]) / (outline.u[i + 1] - outline.u[i]);
      least = std::min(least, slope), greatest = std::max(greatest, slope);
    }
  }
};

/// By how many rows an edge jumps from sample k to the next; 0 where its slopes or its scatter on
/// either side explain that.
double edge_jump(const Outline& outline, const std::vector<double>& v, std::size_t k) {
  Slopes slopes;
  slopes.add(outline, v, k + 1 - std::min(kSide, k + 1), k);
  slopes.add(outline, v, k + 1, std::min(k + kSide, v.size() - 1));
  const double columns = outline.u[k + 1] - outline.u[k];
  const double jump = v[k + 1] - v[k] - 0.5 * (slopes.least + slopes.greatest) * columns;
  const double explained = kTimesBend * (slopes.greatest - slopes.least) * columns +
                           kTimesSd * std::max(outline.sd[k], outline.sd[k + 1]);
  return std::abs(jump) > explained ? jump : 0.0;
}

/// By how many rows the face gets wider from sample k to the next by a jump of both edges; or 0.
double width_jump(const Outline& outline, std::size_t k) {
  const double gap = outline.u[k + 1] - outline.u[k];
  if (gap > kMostGap * (outline.u.back() - outline.u.front())) return 0.0;
  const double upper = edge_jump(outline, outline.upper_v, k),
               lower = edge_jump(outline, outline.lower_v, k);
  if (!(upper * lower < 0.0)) return 0.0;
  const double width = outline.lower_v[k] - outline.upper_v[k], wider = lower - upper;
  return std::abs(wider) > kLeastPart * width ? wider : 0.0;
}

}  // namespace

std::optional<OutlineJump> outline_jump(const FaceEdges& edges) {
  const Outline outline = outline_of(edges);
  const std::size_t count = outline.u.size();
  double most = 0, widest = 0, narrowest = 0;
  std::size_t at = 0;
  for (std::size_t k = kFewest - 1; k + kFewest < count; ++k) {
    const double wider = width_jump(outline, k);
    widest = std::max(widest, wider), narrowest = std::min(narrowest, wider);
    if (std::abs(wider) > std::abs(most)) most = wider, at = k;
  }
  const double back = most > 0.0 ? -narrowest : widest;
  if (most == 0.0 || back > kUndone * std::abs(most)) return std::nullopt;
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
