#include "core/sensing/markers/even_rows.h"

#include "core/sensing/markers/dot_measure.h"
#include "core/sensing/markers/marker_rows.h"

#include <cmath>

namespace alltact {
namespace {

// Fraction of the distance to the next marker, so that markers are not confused
constexpr double kSearch = 0.35;
constexpr int kRetryPeriod = 8;  // failures until the other polarity is tried again

double distance(const Dot& a, const Dot& b) {
  return std::hypot(a.u - b.u, a.v - b.v);
}

/// Distance to the nearer neighbour in its row.
double spacing(const std::vector<Dot>& markers, std::size_t m) {
  const std::size_t per_row = markers.size() / 2, index = m % per_row;
  double least = 1e9;
  if (index > 0) least = std::min(least, distance(markers[m], markers[m - 1]));
  if (index + 1 < per_row) least = std::min(least, distance(markers[m], markers[m + 1]));
  return least;
}

Markers as_markers(const std::vector<Dot>& dots) {
  Markers markers;
  for (const Dot& dot : dots) markers.push_back({dot.u, dot.v, true, dot.sd_px});
  return markers;
}

}  // namespace

std::optional<std::vector<Dot>> EvenRows::follow(const cv::Mat& grey,
                                                 const FaceShape& shape) const {
  if (last_.empty()) return std::nullopt;
  const SideEdges edges(shape);
  std::vector<Dot> dots;
  for (std::size_t m = 0; m < last_.size(); ++m) {
    const Dot& was = last_[m];
    const auto dot = near_dot(grey, edges, {was.u, was.v}, kSearch * spacing(last_, m), was);
    if (!dot || dot->upper != was.upper) return std::nullopt;
    for (const Dot& other : dots)
      // One of them jumped to the other's dot
      if (distance(*dot, other) < 1.0) return std::nullopt;
    dots.push_back(*dot);
  }
  locate_on_finger(dots, shape, edges);
  return two_rows(dots, rows_.per_row, shape.base_at_low_u());
}

Polarity EvenRows::polarity() {
  if (rows_.polarity != Polarity::kAuto || !known_polarity_) return rows_.polarity;
  // With one marker hidden the rows are not even, and a search in both polarities would find no
  // more.
  return failures_++ % kRetryPeriod == kRetryPeriod - 1 ? Polarity::kAuto : *known_polarity_;
}

EvenRows::Seen EvenRows::operator()(const cv::Mat& grey, const FaceShape& shape) {
  Seen seen;
  if (grey.cols != shape.width_px() || rows_.per_row < 1) return seen;
  auto markers = follow(grey, shape);
  if (!markers) {
    auto found = MarkerDetector({rows_.per_row, polarity()})(grey, shape);
    markers = two_rows(found.dots, rows_.per_row, shape.base_at_low_u());
    if (markers) known_polarity_ = found.polarity;
    if (!markers) seen.dots = std::move(found.dots);
  }
  if (!markers) {
    last_.clear();
    return seen;
  }
  failures_ = 0;
  last_ = std::move(*markers);
  seen.markers = as_markers(last_);
  return seen;
}

void EvenRows::forget() {
  last_.clear();
  known_polarity_.reset();
}

}  // namespace alltact
