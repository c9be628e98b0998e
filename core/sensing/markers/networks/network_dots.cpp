#include "core/sensing/markers/networks/network_dots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kWorkingWidth = 960;  // px, that the network for dots was trained with
constexpr int kStride = 4;          // of its output, px
constexpr float kMinLogit = -2.0F;  // probability 0.12: measuring rejects false ones
constexpr double kMinBoxScore = 0.25;
constexpr double kMaxIou = 0.45;  // intersection over union of two boxes
constexpr float kPadding = 114.0F / 255.0F;
constexpr double kLargestHalfPx = 64;

double probability(float logit) {
  return 1.0 / (1.0 + std::exp(-static_cast<double>(logit)));
}

/// Vertex of a parabola through three neighbours, in units of their distance.
double vertex(float before, float here, float after) {
  const float bend = before - 2 * here + after;
  if (!(bend < 0)) return 0;
  return std::clamp(0.5 * static_cast<double>((before - after) / bend), -0.5, 0.5);
}

bool is_peak(const cv::Mat& plane, int x, int y) {
  const float here = plane.at<float>(y, x);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const int nx = x + dx, ny = y + dy;
      if ((dx == 0 && dy == 0) || nx < 0 || ny < 0 || nx >= plane.cols || ny >= plane.rows)
        continue;
      const bool is_earlier = dy < 0 || (dy == 0 && dx < 0);
      const float other = plane.at<float>(ny, nx);
      if (other > here || (is_earlier && other == here)) return false;
    }
  return true;
}

void sort_by_score(std::vector<NetworkDot>& dots) {
  std::stable_sort(dots.begin(), dots.end(), [](const NetworkDot& a, const NetworkDot& b) {
    return a.score > b.score;
  });
}

/// Retains the first of those that are the same by `is_same`.
template <class Same>
std::vector<NetworkDot> without_duplicates(const std::vector<NetworkDot>& dots, Same is_same) {
  std::vector<NetworkDot> retained;
  for (const NetworkDot& dot : dots)
    if (std::none_of(
            retained.begin(), retained.end(), [&](const NetworkDot& k) { return is_same(k, dot); }))
      retained.push_back(dot);
  return retained;
}

/// Intersection over union of two boxes.
double iou(const NetworkDot& a, const NetworkDot& b) {
  const double width =
      std::min(a.u + a.half_u, b.u + b.half_u) - std::max(a.u - a.half_u, b.u - b.half_u);
  const double height =
      std::min(a.v + a.half_v, b.v + b.half_v) - std::max(a.v - a.half_v, b.v - b.half_v);
  if (!(width > 0 && height > 0)) return 0;
  const double both = width * height;
  return both / (4 * a.half_u * a.half_v + 4 * b.half_u * b.half_v - both);
}

}  // namespace

cv::Mat dots_input(const cv::Mat& grey, InputMap* input_map) {
  const int f =
      std::max(1, static_cast<int>(std::lround(static_cast<double>(grey.cols) / kWorkingWidth)));
  cv::Mat small = grey;
  if (f > 1)
    cv::resize(grey(cv::Rect(0, 0, grey.cols / f * f, grey.rows / f * f)),
               small,
               cv::Size(grey.cols / f, grey.rows / f),
               0,
               0,
               cv::INTER_AREA);
  *input_map = {1.0 / f, -0.5 * (f - 1) / f, -0.5 * (f - 1) / f};
  std::array<float, 256> root;
  for (std::size_t g = 0; g < 256; ++g) root[g] = std::sqrt(static_cast<float>(g) / 255.0F);
  const std::array<int, 4> shape{1, 1, small.rows, small.cols};
  cv::Mat input(4, shape.data(), CV_32F);
  auto* to = input.ptr<float>();
  for (int y = 0; y < small.rows; ++y) {
    const std::uint8_t* from = small.ptr<std::uint8_t>(y);
    for (int x = 0; x < small.cols; ++x) *to++ = root[from[x]];
  }
  return input;
}

cv::Mat boxes_input(const cv::Mat& grey, const cv::Size& size, int channels, InputMap* input_map) {
  const double scale = std::min(static_cast<double>(size.width) / grey.cols,
                                static_cast<double>(size.height) / grey.rows);
  const int width = std::clamp(static_cast<int>(std::lround(grey.cols * scale)), 1, size.width);
  const int height = std::clamp(static_cast<int>(std::lround(grey.rows * scale)), 1, size.height);
  const int left = (size.width - width) / 2, top = (size.height - height) / 2;
  cv::Mat small;
  cv::resize(
      grey, small, cv::Size(width, height), 0, 0, scale < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
  // Box coordinates count from the corner of the first pixel, image coordinates from its centre.
  *input_map = {scale, left + 0.5 * scale, top + 0.5 * scale};
  const std::array<int, 4> shape{1, channels, size.height, size.width};
  cv::Mat input(4, shape.data(), CV_32F, cv::Scalar(kPadding));
  for (int c = 0; c < channels; ++c) {
    cv::Mat plane(size, CV_32F, input.ptr<float>(0, c));
    small.convertTo(plane(cv::Rect(left, top, width, height)), CV_32F, 1.0 / 255.0);
  }
  return input;
}

std::vector<NetworkDot> dots_of(const cv::Mat& output, const InputMap& input_map) {
  const int height = output.size[2], width = output.size[3];
  const auto plane = [&](int channel) {
    return cv::Mat(height, width, CV_32F, const_cast<float*>(output.ptr<float>(0, channel)));
  };
  const cv::Mat logits = plane(0), wide = plane(1), high = plane(2);
  const auto extent = [&](float logarithm) {
    return std::clamp(std::exp(static_cast<double>(logarithm)), 0.5, kLargestHalfPx) /
           input_map.scale;
  };
  std::vector<NetworkDot> dots;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float here = logits.at<float>(y, x);
      if (here < kMinLogit || !is_peak(logits, x, y)) continue;
      double cell_x = x, cell_y = y;
      if (x > 0 && x + 1 < width)
        cell_x += vertex(logits.at<float>(y, x - 1), here, logits.at<float>(y, x + 1));
      if (y > 0 && y + 1 < height)
        cell_y += vertex(logits.at<float>(y - 1, x), here, logits.at<float>(y + 1, x));
      dots.push_back({input_map.u(kStride * cell_x),
                      input_map.v(kStride * cell_y),
                      extent(wide.at<float>(y, x)),
                      extent(high.at<float>(y, x)),
                      probability(here)});
    }
  sort_by_score(dots);
  const double cell_px = kStride / input_map.scale;
  return without_duplicates(dots, [cell_px](const NetworkDot& a, const NetworkDot& b) {
    return std::abs(a.u - b.u) < std::max(1.5 * cell_px, a.half_u) &&
           std::abs(a.v - b.v) < std::max(1.5 * cell_px, a.half_v);
  });
}

std::vector<NetworkDot> boxes_of(const cv::Mat& output, const InputMap& input_map) {
  // The longer dimension is that of the boxes.
  const bool is_transposed = output.size[2] < output.size[1];
  const int boxes = is_transposed ? output.size[1] : output.size[2];
  const int numbers = is_transposed ? output.size[2] : output.size[1];
  const auto* values = output.ptr<float>();
  const auto at = [&](int box, int number) {
    const std::size_t row = static_cast<std::size_t>(is_transposed ? box : number);
    const std::size_t column = static_cast<std::size_t>(is_transposed ? number : box);
    return static_cast<double>(
        values[row * static_cast<std::size_t>(is_transposed ? numbers : boxes) + column]);
  };
  std::vector<NetworkDot> dots;
  for (int box = 0; box < boxes; ++box) {
    double score = 0;
    for (int number = 4; number < numbers; ++number) score = std::max(score, at(box, number));
    const double width = at(box, 2), height = at(box, 3);
    if (score < kMinBoxScore || !(width > 0 && height > 0)) continue;
    dots.push_back({input_map.u(at(box, 0)),
                    input_map.v(at(box, 1)),
                    0.5 * width / input_map.scale,
                    0.5 * height / input_map.scale,
                    std::min(score, 1.0)});
  }
  sort_by_score(dots);
  return without_duplicates(
      dots, [](const NetworkDot& a, const NetworkDot& b) { return iou(a, b) > kMaxIou; });
}

}  // namespace alltact
