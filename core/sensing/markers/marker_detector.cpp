#include "core/sensing/markers/marker_detector.h"

#include "core/numerics/dispatch.h"
#include "core/sensing/markers/dot_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

// A spot of the reduced image.
struct Candidate {
  int height;    // above the morphological opening
  DotSeed seed;  // in pixels of the full image
};

// The reduced image and the extent of the two side faces in it.
struct Small {
  cv::Mat grey;
  int factor = 1;
  std::vector<int> upper_end;    // last row of the upper side face in each column; -1: none
  std::vector<int> lower_begin;  // first row of the lower side face; height: none
};

Small shrink(const cv::Mat& grey, const SideEdges& edges) {
  Small small;
  small.grey = reduced_for_dots(grey, &small.factor);
  const int f = small.factor;
  const int width = small.grey.cols, height = small.grey.rows;
  small.upper_end.resize(static_cast<std::size_t>(width));
  small.lower_begin.resize(static_cast<std::size_t>(width));
  for (int x = 0; x < width; ++x) {
    int last = grey.rows, first = 0;
    for (int u = x * f; u < (x + 1) * f; ++u) {
      last = std::min(last, edges.rows(u, true, kFaceMarginPx, grey.rows).last);
      first = std::max(first, edges.rows(u, false, kFaceMarginPx, grey.rows).first);
    }
    small.upper_end[static_cast<std::size_t>(x)] = std::clamp((last + 1) / f - 1, -1, height - 1);
    small.lower_begin[static_cast<std::size_t>(x)] = std::clamp((first + f - 1) / f, 0, height);
  }
  return small;
}

/// Raises the columns whose view face covers the row to full brightness.
ALLTACT_WIDE void brighten_face(int y, const int* upper_end, const int* lower_begin, int width,
                                std::uint8_t* row) {
  for (int x = 0; x < width; ++x)
    row[x] = static_cast<std::uint8_t>(row[x] | -((y > upper_end[x]) & (y < lower_begin[x])));
}

// Difference to the opening by a rectangle wider than any dot. Slow changes of brightness, steps
// and the view face itself vanish.
cv::Mat spots(const Small& small, bool bright) {
  cv::Mat turned;
  if (bright)
    turned = small.grey.clone();
  else
    cv::subtract(cv::Scalar(255), small.grey, turned);
  for (int y = 0; y < turned.rows; ++y)  // the view face at full brightness is never a spot
    brighten_face(y, small.upper_end.data(), small.lower_begin.data(), turned.cols,
                  turned.ptr<std::uint8_t>(y));
  constexpr int wide = 31;
  cv::Mat opened;
  const cv::Mat kernel = cv::getStructuringElement(cv::MORPH_RECT, cv::Size(wide, wide));
  cv::morphologyEx(turned, opened, cv::MORPH_OPEN, kernel);
  cv::subtract(turned, opened, turned);
  cv::blur(turned, turned, cv::Size(3, 3), cv::Point(-1, -1), cv::BORDER_REPLICATE);
  return turned;
}

// Number of pixels in one direction that the spot extends above half its height.
int walk(const cv::Mat& response, int x, int y, int dx, int dy, int half, int limit) {
  int steps = 0;
  while (steps < limit) {
    const int nx = x + dx * (steps + 1), ny = y + dy * (steps + 1);
    if (nx < 0 || ny < 0 || nx >= response.cols || ny >= response.rows) break;
    if (response.at<std::uint8_t>(ny, nx) <= half) break;
    ++steps;
  }
  return steps;
}

// Half the rows of a side face hold no dot. So the median of the response is that of bare skin, and
// the values below it give the noise.
int threshold_of(const cv::Mat& response, const Small& small) {
  std::array<int, 256> histogram{};
  int total = 0;
  for (int y = 0; y < response.rows; y += 3) {  // a sample is enough
    const std::uint8_t* row = response.ptr<std::uint8_t>(y);
    for (int x = 0; x < response.cols; x += 3)
      if (y <= small.upper_end[static_cast<std::size_t>(x)] ||
          y >= small.lower_begin[static_cast<std::size_t>(x)])
        ++histogram[row[x]], ++total;
  }
  const auto level_above = [&](double part) {
    int level = 0;
    for (int below = 0;
         level < 255 && (below += histogram[static_cast<std::size_t>(level)]) < part * total;)
      ++level;
    return level;
  };
  const int median = level_above(0.5);
  const double sd = (median - level_above(0.16)) + 0.5;  // 0.5: integer grey levels
  return median + std::max(4, static_cast<int>(4.0 * sd));
}

/// The spot with its summit at this pixel; nullopt: there is none on a side face, or it is a stripe
/// or a patch larger than any dot.
std::optional<Candidate> spot_at(const cv::Mat& response, const Small& small, int x, int y,
                                 bool bright) {
  const bool upper = y <= small.upper_end[static_cast<std::size_t>(x)];
  if (!upper && y < small.lower_begin[static_cast<std::size_t>(x)]) return std::nullopt;
  if (!is_peak<std::uint8_t>(response, x, y)) return std::nullopt;
  const int height = response.at<std::uint8_t>(y, x);
  const int half = height / 2, limit = 24;
  const int left = walk(response, x, y, -1, 0, half, limit);
  const int right = walk(response, x, y, 1, 0, half, limit);
  const int up = walk(response, x, y, 0, -1, half, limit);
  const int down = walk(response, x, y, 0, 1, half, limit);
  if (left + right >= 2 * limit || up + down >= 2 * limit) return std::nullopt;
  const double f = small.factor;
  DotSeed seed;
  seed.u = f * (x + 0.5 * (right - left)) + 0.5 * (f - 1);
  seed.v = f * (y + 0.5 * (down - up)) + 0.5 * (f - 1);
  seed.half_u = f * (0.5 * (left + right + 1));
  seed.half_v = f * (0.5 * (up + down + 1));
  seed.upper = upper;
  seed.sign = bright ? 1 : -1;
  return Candidate{height, seed};
}

std::vector<Candidate> candidates(const Small& small, bool bright, std::size_t max_count) {
  const cv::Mat response = spots(small, bright);
  const int threshold = threshold_of(response, small);
  std::vector<Candidate> found;
  for (int y = 0; y < response.rows; ++y) {
    const std::uint8_t* row = response.ptr<std::uint8_t>(y);
    const std::uint8_t* end = row + response.cols;
    const auto stands_out = [threshold](std::uint8_t level) { return level >= threshold; };
    for (const auto* p = std::find_if(row, end, stands_out); p != end;
         p = std::find_if(p + 1, end, stands_out)) {
      const auto spot = spot_at(response, small, static_cast<int>(p - row), y, bright);
      if (spot) found.push_back(*spot);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.height > b.height; });
  if (found.size() > max_count) found.resize(max_count);
  return found;
}

std::vector<Dot> detect(const cv::Mat& grey, const SideEdges& edges, const Small& small,
                        bool bright, int per_row) {
  const auto max_count = static_cast<std::size_t>(std::ptrdiff_t{16} * per_row + 32);
  std::vector<Dot> dots;
  for (const Candidate& candidate : candidates(small, bright, max_count)) {
    const auto dot = measure_dot(grey, edges, candidate.seed);
    if (dot && !is_among(dots, *dot)) dots.push_back(*dot);
  }
  // Dots far fainter than the expected rows are noise.
  std::vector<double> contrasts;
  for (const Dot& dot : dots) contrasts.push_back(std::abs(dot.contrast));
  std::sort(contrasts.begin(), contrasts.end(), std::greater<>());
  if (contrasts.empty()) return dots;
  const std::size_t typical = std::min(contrasts.size() - 1, static_cast<std::size_t>(per_row));
  std::erase_if(dots, [min_contrast = 0.06 * contrasts[typical]](const Dot& dot) {
    return std::abs(dot.contrast) < min_contrast;
  });
  return dots;
}

// Deviation of a set of dots from two even rows of exactly per_row. A missing row costs 1, and each
// surplus dot a little.
double unevenness(const std::vector<Dot>& dots, int per_row, bool base_at_low_u) {
  double total = 0;
  for (const bool upper : {true, false}) {
    const auto row = choose_row(dots, upper, per_row, base_at_low_u);
    const auto count =
        std::count_if(dots.begin(), dots.end(), [upper](const Dot& d) { return d.upper == upper; });
    const double missing = std::max(0.0, 1.0 - static_cast<double>(count) / per_row);
    total += row ? std::min(1.0, row->unevenness) : 1.0 + missing;
  }
  return total + 0.01 * static_cast<double>(dots.size());
}

}  // namespace

FoundDots MarkerDetector::operator()(const cv::Mat& grey, const FaceShape& shape) const {
  const SideEdges edges(shape);
  if (grey.type() != CV_8UC1 || grey.cols != shape.width_px() || rows_.per_row <= 0) return {};
  const Small small = shrink(grey, edges);
  const auto found = [&](Polarity polarity) {
    FoundDots result{
        detect(grey, edges, small, polarity == Polarity::kBright, rows_.per_row), polarity, {}};
    locate_on_finger(result.dots, shape, edges);
    return result;
  };
  if (rows_.polarity != Polarity::kAuto) return found(rows_.polarity);
  FoundDots bright = found(Polarity::kBright), dark = found(Polarity::kDark);
  const bool base = shape.base_at_low_u();
  return unevenness(dark.dots, rows_.per_row, base) < unevenness(bright.dots, rows_.per_row, base)
             ? dark
             : bright;
}

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// Neighbours in a row are similar after correction for perspective. Log ratios make growth and
// shrinkage cost the same. Light falls off along the row, so contrast has a low weight.
double dissimilarity(const Dot& a, const Dot& b) {
  const double size = std::log(b.radius_px * a.face_px / (a.radius_px * b.face_px));
  const double contrast = std::log(std::abs(b.contrast) / std::abs(a.contrast));
  const double off_face = b.off_face - a.off_face;
  return 0.5 * size * size + 0.15 * contrast * contrast + 20.0 * off_face * off_face;
}

// Cost of unequal neighbouring steps along the finger: (b - a)^2 / (a b), 1/2 where a dot is
// missing.
double bend(const Dot& p, const Dot& q, const Dot& r) {
  const double a = q.along_mm - p.along_mm, b = r.along_mm - q.along_mm;
  return a > 0 && b > 0 ? (b - a) * (b - a) / (a * b) : kNone;
}

}  // namespace

std::optional<DotRow> choose_row(const std::vector<Dot>& dots, bool upper, int per_row,
                                 bool base_at_low_u) {
  std::vector<int> side;
  for (std::size_t i = 0; i < dots.size(); ++i)
    if (dots[i].upper == upper) side.push_back(static_cast<int>(i));
  const int n = static_cast<int>(side.size());
  if (n < per_row) return std::nullopt;
  std::sort(side.begin(), side.end(), [&](int a, int b) {
    const double ua = dots[static_cast<std::size_t>(a)].u, ub = dots[static_cast<std::size_t>(b)].u;
    return base_at_low_u ? ua < ub : ua > ub;
  });
  const auto dot = [&](int i) -> const Dot& {
    return dots[static_cast<std::size_t>(side[static_cast<std::size_t>(i)])];
  };
  // cost(count, i, j): the cheapest row of `count` dots that ends with i, j.
  const auto at = [n](int count, int i, int j) {
    return (static_cast<std::size_t>(count) * static_cast<std::size_t>(n) +
            static_cast<std::size_t>(i)) *
               static_cast<std::size_t>(n) +
           static_cast<std::size_t>(j);
  };
  const std::size_t size = at(per_row, n - 1, n - 1) + 1;
  std::vector<double> cost(size, kNone);
  std::vector<int> before(size, -1);
  for (int j = 1; j < n; ++j)
    for (int i = 0; i < j; ++i) cost[at(2, i, j)] = dissimilarity(dot(i), dot(j));
  for (int count = 3; count <= per_row; ++count)
    for (int k = 2; k < n; ++k)
      for (int j = 1; j < k; ++j) {
        const double step = dissimilarity(dot(j), dot(k));
        for (int i = 0; i < j; ++i) {
          const double before_cost = cost[at(count - 1, i, j)];
          if (before_cost == kNone) continue;
          const double total = before_cost + step + bend(dot(i), dot(j), dot(k));
          if (total >= cost[at(count, j, k)]) continue;
          cost[at(count, j, k)] = total;
          before[at(count, j, k)] = i;
        }
      }
  double best = kNone;
  int i = -1, j = -1;
  for (int b = 1; b < n; ++b)
    for (int a = 0; a < b; ++a)
      if (cost[at(per_row, a, b)] < best) best = cost[at(per_row, a, b)], i = a, j = b;
  if (i < 0) return std::nullopt;
  DotRow row;
  row.unevenness = best / per_row;
  row.dots.push_back(side[static_cast<std::size_t>(j)]);
  for (int count = per_row; i >= 0; --count) {
    row.dots.push_back(side[static_cast<std::size_t>(i)]);
    const int previous = count > 2 ? before[at(count, i, j)] : -1;
    j = i;
    i = previous;
  }
  std::reverse(row.dots.begin(), row.dots.end());
  return row;
}

std::optional<std::vector<Dot>> two_rows(const std::vector<Dot>& dots, int per_row,
                                         bool base_at_low_u) {
  std::vector<Dot> markers;
  for (const bool is_upper : {true, false}) {
    const auto row = choose_row(dots, is_upper, per_row, base_at_low_u);
    if (!row || row->unevenness > kMaxUnevenness) return std::nullopt;
    for (const int d : row->dots) markers.push_back(dots[static_cast<std::size_t>(d)]);
  }
  return markers;
}

namespace {

constexpr int kColumnStride = 4;  // columns

/// Intersection of a ray with the plane y = edge_y; nullopt behind the camera or without one.
std::optional<Eigen::Vector3d> on_side_face(const Ray& ray, double edge_y_mm) {
  if (std::abs(ray.direction.y()) < 1e-6) return std::nullopt;
  const double z = (edge_y_mm - ray.origin_mm.y()) / ray.direction.y();
  if (!(z > 0.0 && z < 1e5)) return std::nullopt;
  return ray.point_at(z);
}

/// The face in side view: a polyline in x and z, with y of both edges.
class Profile {
 public:
  Profile(const FaceShape& shape, const SideEdges& edges) {
    for (int u = kColumnStride / 2; u < shape.width_px(); u += kColumnStride) {
      const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
      if (!column.valid) continue;
      const auto upper = shape.camera().unproject({u, edges.upper[static_cast<std::size_t>(u)]});
      const auto lower = shape.camera().unproject({u, edges.lower[static_cast<std::size_t>(u)]});
      if (!upper || !lower) continue;
      const Eigen::Vector3d a = upper->point_at(column.z_mm), b = lower->point_at(column.z_mm);
      points_.push_back({0.5 * (a.x() + b.x()), column.z_mm, a.y(), b.y(), shape.length_at(u)});
    }
  }
  [[nodiscard]] bool is_empty() const { return points_.size() < 2; }

  struct Foot {
    double along_mm = 0, off_mm = 0, z_mm = 0;
  };
  /// Foot of the ray's intersection with the side face: the point of the face whose normal passes
  /// through it. The profile continues straight beyond its ends. Of several feet the one nearest to
  /// the intersection is returned. off_mm > 0 towards the camera. nullopt: there is none.
  [[nodiscard]] std::optional<Foot> foot(const Ray& ray, bool upper) const {
    std::optional<Foot> best;
    std::optional<Intersection> before;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto intersection = intersect(ray, i, upper);
      const bool first = i == 1, last = i + 1 == points_.size();
      if (intersection && before && intersection->ahead_mm != before->ahead_mm) {
        const double t = before->ahead_mm / (before->ahead_mm - intersection->ahead_mm);
        // The offset along the tangent changes sign at the foot.
        const bool is_inside = t >= 0.0 && t <= 1.0;
        if (is_inside || (first && t < 0.0 && t > -kBeyond) || (last && t > 1.0 && t < kBeyond)) {
          const Foot foot = between(*before, *intersection, i, t);
          if (!best || std::abs(foot.off_mm) < std::abs(best->off_mm)) best = foot;
        }
      }
      before = intersection;
    }
    return best;
  }

 private:
  struct Point {
    double x, z, upper_y, lower_y, along_mm;
  };
  struct Intersection {
    double ahead_mm, off_mm, z_mm;
  };
  static constexpr double kBeyond = 60.0;  // steps of the profile beyond its ends

  /// Intersection of the ray with the plane y of the edge, relative to one point of the face.
  [[nodiscard]] std::optional<Intersection> intersect(const Ray& ray, std::size_t i,
                                                      bool upper) const {
    const Point& p = points_[i];
    const auto at = on_side_face(ray, upper ? p.upper_y : p.lower_y);
    if (!at) return std::nullopt;
    const Point &a = points_[i > 0 ? i - 1 : 0], &b = points_[std::min(i + 1, points_.size() - 1)];
    Eigen::Vector2d tangent(b.x - a.x, b.z - a.z);
    if (!(tangent.norm() > 0)) return std::nullopt;
    tangent.normalize();
    const Eigen::Vector2d away(at->x() - p.x, at->z() - p.z);
    const double across = tangent.x() * away.y() - tangent.y() * away.x();
    return Intersection{tangent.dot(away), tangent.x() > 0 ? -across : across, at->z()};
  }
  [[nodiscard]] Foot between(const Intersection& a, const Intersection& b, std::size_t i,
                             double t) const {
    const double inside = std::clamp(t, 0.0, 1.0);
    return {points_[i - 1].along_mm + t * (points_[i].along_mm - points_[i - 1].along_mm),
            a.off_mm + inside * (b.off_mm - a.off_mm), a.z_mm + inside * (b.z_mm - a.z_mm)};
  }

  std::vector<Point> points_;
};

/// Position on the finger from the dot's column alone.
void locate_by_column(Dot& dot, const FaceShape& shape, const SideEdges& edges) {
  const auto u = static_cast<std::size_t>(
      std::clamp(std::lround(dot.u), 0L, static_cast<long>(shape.width_px()) - 1));
  dot.along_mm = shape.length_at(dot.u);
  dot.face_px = std::max(1.0F, edges.lower[u] - edges.upper[u]);
  dot.off_face = (dot.upper ? edges.upper[u] - dot.v : dot.v - edges.lower[u]) / dot.face_px;
}

}  // namespace

void locate_on_finger(std::vector<Dot>& dots, const FaceShape& shape, const SideEdges& edges) {
  const Profile profile(shape, edges);
  const CameraParameters& camera = shape.camera().parameters();
  for (Dot& dot : dots) {
    locate_by_column(dot, shape, edges);
    const auto ray = shape.camera().unproject({dot.u, dot.v});
    if (profile.is_empty() || !ray) continue;
    const auto foot = profile.foot(*ray, dot.upper);
    if (!foot || !std::isfinite(foot->along_mm) || !std::isfinite(foot->off_mm)) continue;
    dot.along_mm = foot->along_mm;
    dot.off_face = foot->off_mm / shape.face().width_mm;
    dot.face_px = std::max(1.0, camera.fx_px * shape.face().width_mm / foot->z_mm);
  }
}

}  // namespace alltact
