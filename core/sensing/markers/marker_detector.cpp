#include "core/sensing/markers/dot_measure.h"
#include "core/sensing/markers/marker_rows.h"
#include "core/sensing/markers/markers.h"

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kSmallWidth = 960;  // px, of the image that candidates are searched in

// A spot of the reduced image, in its pixels.
struct Candidate {
  int x, y;
  int height;  // above the morphological opening
  double centre_x, centre_y, half_x, half_y;
  bool upper;
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
  small.factor =
      std::max(1, static_cast<int>(std::lround(static_cast<double>(grey.cols) / kSmallWidth)));
  const int f = small.factor;
  if (f == 1)
    small.grey = grey;
  else  // complete blocks only, so that a small pixel is exactly f x f large ones
    cv::resize(grey(cv::Rect(0, 0, grey.cols / f * f, grey.rows / f * f)),
               small.grey,
               cv::Size(grey.cols / f, grey.rows / f),
               0,
               0,
               cv::INTER_AREA);
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

// Difference to the opening by a rectangle wider than any dot. Slow changes of brightness, steps
// and the view face itself vanish.
cv::Mat spots(const Small& small, bool bright) {
  cv::Mat turned;
  if (bright)
    turned = small.grey.clone();
  else
    cv::subtract(cv::Scalar(255), small.grey, turned);
  for (int y = 0; y < turned.rows; ++y) {  // the view face at full brightness is never a spot
    std::uint8_t* row = turned.ptr<std::uint8_t>(y);
    const int *upper = small.upper_end.data(), *lower = small.lower_begin.data();
    for (int x = 0; x < turned.cols; ++x)
      row[x] = static_cast<std::uint8_t>(row[x] | -((y > upper[x]) & (y < lower[x])));
  }
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

bool is_summit(const cv::Mat& r, int x, int y) {
  const int value = r.at<std::uint8_t>(y, x);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      if (dx == 0 && dy == 0) continue;
      const int nx = x + dx, ny = y + dy;
      if (nx < 0 || ny < 0 || nx >= r.cols || ny >= r.rows) continue;
      const int other = r.at<std::uint8_t>(ny, nx);
      const bool earlier = dy < 0 || (dy == 0 && dx < 0);
      if (other > value || (earlier && other == value)) return false;
    }
  return true;
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

std::vector<Candidate> candidates(const cv::Mat& response,
                                  const Small& small,
                                  std::size_t max_count) {
  const int threshold = threshold_of(response, small);
  std::vector<Candidate> found;
  for (int y = 0; y < response.rows; ++y) {
    const std::uint8_t* row = response.ptr<std::uint8_t>(y);
    for (int x = 0; x < response.cols; ++x) {
      if (row[x] < threshold) continue;
      const bool upper = y <= small.upper_end[static_cast<std::size_t>(x)];
      if (!upper && y < small.lower_begin[static_cast<std::size_t>(x)]) continue;
      if (!is_summit(response, x, y)) continue;
      const int half = row[x] / 2, limit = 24;
      const int left = walk(response, x, y, -1, 0, half, limit);
      const int right = walk(response, x, y, 1, 0, half, limit);
      const int up = walk(response, x, y, 0, -1, half, limit);
      const int down = walk(response, x, y, 0, 1, half, limit);
      // A stripe or a patch larger than any dot.
      if (left + right >= 2 * limit || up + down >= 2 * limit) continue;
      found.push_back({x,
                       y,
                       row[x],
                       x + 0.5 * (right - left),
                       y + 0.5 * (down - up),
                       0.5 * (left + right + 1),
                       0.5 * (up + down + 1),
                       upper});
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return a.height > b.height;
  });
  if (found.size() > max_count) found.resize(max_count);
  return found;
}

bool is_known(const std::vector<Dot>& dots, const Dot& dot) {
  return std::any_of(dots.begin(), dots.end(), [&](const Dot& other) {
    return std::hypot(other.u - dot.u, other.v - dot.v) < std::max(1.5, 0.8 * other.radius_px);
  });
}

std::vector<Dot> detect(
    const cv::Mat& grey, const SideEdges& edges, const Small& small, bool bright, int per_row) {
  const cv::Mat response = spots(small, bright);
  const auto max_count = static_cast<std::size_t>(16 * per_row + 32);
  std::vector<Dot> dots;
  const double f = small.factor;
  for (const Candidate& candidate : candidates(response, small, max_count)) {
    DotSeed seed;
    seed.u = f * candidate.centre_x + 0.5 * (f - 1);
    seed.v = f * candidate.centre_y + 0.5 * (f - 1);
    seed.half_u = f * candidate.half_x;
    seed.half_v = f * candidate.half_y;
    seed.upper = candidate.upper;
    seed.sign = bright ? 1 : -1;
    const auto dot = measure_dot(grey, edges, seed);
    if (dot && !is_known(dots, *dot)) dots.push_back(*dot);
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

}  // namespace alltact
