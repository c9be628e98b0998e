#include "core/sensing/face/side_edges.h"

namespace alltact {
namespace {

// Straight line through two trusted columns at a distance, evaluated at u.
struct Continuation {
  int from = 0, inner = 0;  // outermost trusted column and one further in

  float at(const std::vector<float>& v, int u) const {
    const float a = v[static_cast<std::size_t>(from)];
    if (inner == from) return a;
    const float slope = (a - v[static_cast<std::size_t>(inner)]) / static_cast<float>(from - inner);
    return a + slope * static_cast<float>(u - from);
  }
};

void continue_edge(std::vector<float>& v, const std::vector<int>& trusted, int reach) {
  const int width = static_cast<int>(v.size());
  const Continuation left{trusted.front(), std::min(trusted.front() + reach, trusted.back())};
  const Continuation right{trusted.back(), std::max(trusted.back() - reach, trusted.front())};
  for (int u = 0; u < left.from; ++u) v[static_cast<std::size_t>(u)] = left.at(v, u);
  for (int u = right.from + 1; u < width; ++u) v[static_cast<std::size_t>(u)] = right.at(v, u);
  for (std::size_t i = 1; i < trusted.size(); ++i)
    for (int u = trusted[i - 1] + 1; u < trusted[i]; ++u) {
      const float t =
          static_cast<float>(u - trusted[i - 1]) / static_cast<float>(trusted[i] - trusted[i - 1]);
      v[static_cast<std::size_t>(u)] = (1 - t) * v[static_cast<std::size_t>(trusted[i - 1])] +
                                       t * v[static_cast<std::size_t>(trusted[i])];
    }
}

}  // namespace

SideEdges::SideEdges(const FaceShape& shape) {
  const auto& columns = shape.columns();
  const std::size_t width = columns.size();
  upper.assign(width, 0.0F);
  lower.assign(width, 0.0F);
  std::vector<int> trusted;
  trusted.reserve(width);
  for (std::size_t u = 0; u < width; ++u) {
    if (!columns[u].valid) continue;
    trusted.push_back(static_cast<int>(u));
    upper[u] = static_cast<float>(columns[u].upper_v);
    lower[u] = static_cast<float>(columns[u].lower_v);
  }
  if (trusted.empty() || trusted.size() == width) return;
  // The end columns of the fit are its least certain; a twentieth of the width stabilises the
  // slope.
  const int reach = std::max(1, static_cast<int>(width) / 20);
  continue_edge(upper, trusted, reach);
  continue_edge(lower, trusted, reach);
  for (std::size_t u = 0; u < width; ++u)
    if (upper[u] > lower[u]) upper[u] = lower[u] = 0.5F * (upper[u] + lower[u]);
}

}  // namespace alltact
