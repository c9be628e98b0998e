#include "core/sensing/markers/dot_measure.h"
#include "core/sensing/markers/markers.h"

namespace alltact {
namespace {

constexpr double kMaxResidualPx = 3.0;  // above this the numbers are rejected

std::size_t count_of_seen(const Markers& markers) {
  return static_cast<std::size_t>(
      std::count_if(markers.begin(), markers.end(), [](const Marker& m) { return m.seen; }));
}

}  // namespace

MarkerTracker::MarkerTracker(MarkerRows rows, MarkerModel model)
    : detector_(rows), model_(std::move(model)), last_dots_(model_.typical_dots()) {}

std::optional<Markers> MarkerTracker::follow(const cv::Mat& grey, const FaceShape& shape) {
  const SideEdges edges(shape);
  Markers markers = *last_;
  // Less than half the distance to the next marker, so that neighbours are not confused.
  const double search = 0.35 * model_.spacing_px();
  for (std::size_t m = 0; m < markers.size(); ++m) {
    if (model_.is_missing(static_cast<int>(m))) continue;
    const auto dot = near_dot(grey, edges, {markers[m].u, markers[m].v}, search, last_dots_[m]);
    markers[m].seen = dot.has_value();
    if (!dot) continue;
    markers[m] = {dot->u, dot->v, true, dot->sd_px};
    last_dots_[m].half_u_px = dot->half_u_px;
    last_dots_[m].half_v_px = dot->half_v_px;
  }
  for (std::size_t a = 0; a < markers.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (markers[a].seen && markers[b].seen &&
          std::hypot(markers[a].u - markers[b].u, markers[a].v - markers[b].v) < 1.0)
        return std::nullopt;  // two markers on one dot: at least one of them jumped
  const std::size_t found = count_of_seen(markers);
  if (found + 1 < count_of_seen(*last_)) return std::nullopt;
  auto completed = model_.complete(std::move(markers));
  if (!completed || model_.residual_px(*completed) > kMaxResidualPx) return std::nullopt;
  if (count_of_seen(*completed) + 1 < found) return std::nullopt;  // several contradict the others
  return completed;
}

std::optional<Markers> MarkerTracker::operator()(const cv::Mat& grey,
                                                 const FaceShape& shape,
                                                 Message* problem) {
  if (last_) {
    last_ = follow(grey, shape);
    if (last_) return last_;
  }
  last_ = numbered(detector_(grey, shape), model_, problem);
  return last_;
}

std::optional<Markers> numbered(const FoundDots& found,
                                const MarkerModel& model,
                                Message* problem) {
  auto markers = model.number(found.dots);
  if (markers && model.residual_px(*markers) > kMaxResidualPx) markers.reset();
  if (!markers && problem)
    *problem = en::say(
        "{} dots were found beside the face, but no third of the {} markers among them fits a pose "
        "of the reference recording",
        found.dots.size(),
        model.present_count());
  return markers;
}

}  // namespace alltact
