#include "core/sensing/face/face_levels.h"

#include "core/image/grey_range.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace alltact {
namespace {

/// Rows of the face in the columns between two samples of its edges.
template <class Visit>
void visit_face(const cv::Mat& grey, const FaceEdges& edges, const Visit& visit) {
  for (std::size_t i = 0; i + 1 < edges.u.size(); ++i) {
    if (!edges.upper.valid[i] || !edges.lower.valid[i]) continue;
    const int first_u = std::max(0, static_cast<int>(std::lround(edges.u[i])));
    const int end_u = std::min(grey.cols, static_cast<int>(std::lround(edges.u[i + 1])));
    const int first_v = std::max(0, static_cast<int>(std::ceil(edges.upper.v[i])) + 1);
    const int end_v = std::min(grey.rows, static_cast<int>(std::floor(edges.lower.v[i])));
    for (int v = first_v; v < end_v; ++v)
      for (int u = first_u; u < end_u; ++u) visit(grey.at<std::uint8_t>(v, u));
  }
}

}  // namespace

FaceLevels face_levels(const cv::Mat& grey, const FaceEdges* edges) {
  CV_Assert(grey.type() == CV_8UC1);
  FaceLevels levels;
  std::array<int, 256> counts{};
  const auto add = [&](std::uint8_t level) { ++counts[level]; };
  if (edges != nullptr) visit_face(grey, *edges, add);
  levels.is_of_face = std::any_of(counts.begin(), counts.end(), [](int n) { return n > 0; });
  if (!levels.is_of_face)
    for (int v = 0; v < grey.rows; ++v)
      std::for_each(grey.ptr<std::uint8_t>(v), grey.ptr<std::uint8_t>(v) + grey.cols, add);
  const double dark_below = edges != nullptr ? too_dark_below(edges->noise_sd) : kTooDarkBelow;
  double all = 0;
  for (std::size_t level = 0; level < counts.size(); ++level) {
    const int n = counts[level];
    levels.counts[level / FaceLevels::kLevelsPerBin] += n;
    all += n;
    if (level >= kClippedFrom) levels.too_bright += n;
    if (static_cast<double>(level) < dark_below) levels.too_dark += n;
  }
  if (all > 0) levels.too_bright /= all, levels.too_dark /= all;
  return levels;
}

}  // namespace alltact
