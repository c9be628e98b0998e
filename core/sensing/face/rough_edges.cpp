#include "core/sensing/face/rough_edges.h"

#include "core/numerics/dispatch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace alltact {
namespace {

using Path = RoughEdges::Path;

constexpr int kSmallWidth = 120;  // approximate columns of the reduced image
constexpr int kLargestJump = 3;   // rows from one small column to the next
constexpr float kJumpPenalty = 0.03F;

/// Packs eight pixels into one number.
std::uint64_t eight_pixels(const std::uint8_t* pixels) {
  std::uint64_t word = 0;
  std::memcpy(&word, pixels, sizeof word);
  return word;
}

/// Adds a row to sums of pairs of neighbouring pixels, four sums of 16 bits in each word.
ALLTACT_WIDE void add_pairs(const std::uint8_t* __restrict row,
                            int words,
                            std::uint64_t* __restrict sums) {
  constexpr std::uint64_t kEvery2nd = 0x00FF00FF00FF00FF;
  for (int i = 0; i < words; ++i) {
    const std::uint64_t word = eight_pixels(row + 8 * static_cast<std::ptrdiff_t>(i));
    sums[i] += (word & kEvery2nd) + ((word >> 8U) & kEvery2nd);
  }
}

/// Sums over blocks of `block` columns, a multiple of eight.
class SumsOfEights {
 public:
  SumsOfEights(int width, int block)
      : words_of_block_(block / 8), sums_(static_cast<std::size_t>(width * words_of_block_)) {}
  /// Beyond this block the four sums of a word together exceed 16 bits.
  static bool can_sum(int block) { return block % 8 == 0 && block <= 32; }

  void clear() { std::fill(sums_.begin(), sums_.end(), 0U); }
  void add(const std::uint8_t* row) {
    add_pairs(row, static_cast<int>(sums_.size()), sums_.data());
  }
  [[nodiscard]] std::uint32_t of(int column) const {
    constexpr std::uint64_t kAllFour = 0x0001000100010001;
    std::uint32_t sum = 0;
    for (int k = 0; k < words_of_block_; ++k)
      sum += static_cast<std::uint32_t>(
          (sums_[static_cast<std::size_t>(column * words_of_block_ + k)] * kAllFour) >> 48U);
    return sum;
  }

 private:
  int words_of_block_;
  std::vector<std::uint64_t> sums_;
};

/// Adds a row to the sums.
ALLTACT_WIDE void add_grey_row(const std::uint8_t* __restrict row,
                               int width,
                               std::uint32_t* __restrict sums) {
  for (int u = 0; u < width; ++u) sums[u] += row[u];
}

/// Sums over blocks of any number of columns.
class SumsOfAny {
 public:
  SumsOfAny(int width, int block) : block_(block), sums_(static_cast<std::size_t>(width * block)) {}
  void clear() { std::fill(sums_.begin(), sums_.end(), 0U); }
  void add(const std::uint8_t* row) {
    add_grey_row(row, static_cast<int>(sums_.size()), sums_.data());
  }
  [[nodiscard]] std::uint32_t of(int column) const {
    const auto first = sums_.begin() + static_cast<std::ptrdiff_t>(column) * block_;
    return std::accumulate(first, first + block_, 0U);
  }

 private:
  int block_;
  std::vector<std::uint32_t> sums_;
};

template <class Sums>
cv::Mat means_of_blocks(const cv::Mat& grey, int block) {
  const int width = grey.cols / block, height = grey.rows / block;
  cv::Mat small(width, height, CV_32FC1);
  Sums sums(width, block);
  for (int r = 0; r < height; ++r) {
    sums.clear();
    for (int k = 0; k < block; ++k) sums.add(grey.ptr<std::uint8_t>(r * block + k));
    for (int c = 0; c < width; ++c)
      small.at<float>(c, r) = static_cast<float>(sums.of(c)) / static_cast<float>(block * block);
  }
  return small;
}

/// Means of complete blocks. Row c of the result is column c of blocks; incomplete blocks at the
/// right and bottom are omitted.
cv::Mat block_columns(const cv::Mat& grey, int block) {
  return SumsOfEights::can_sum(block) ? means_of_blocks<SumsOfEights>(grey, block)
                                      : means_of_blocks<SumsOfAny>(grey, block);
}

/// Brightness change downwards across the border below each row, relative to the column's range:
/// the face is darker at its tip, where its edges count as much. A column with a range far below
/// that of the others shows no face. Columns are rows of both images.
cv::Mat downward_contrast(const cv::Mat& small, double noise_sd) {
  constexpr float kMinRange = 0.1F;  // of the largest range
  const int rows = small.cols;
  std::vector<float> ranges;
  for (int c = 0; c < small.rows; ++c) {
    const float* column = small.ptr<float>(c);
    const auto [low, high] = std::minmax_element(column, column + rows);
    ranges.push_back(*high - *low);
  }
  const float min_range = std::max(static_cast<float>(4.0 * noise_sd),
                                   kMinRange * *std::max_element(ranges.begin(), ranges.end()));
  cv::Mat contrast(small.rows, rows - 1, CV_32FC1);
  for (int c = 0; c < small.rows; ++c) {
    const float* column = small.ptr<float>(c);
    float* out = contrast.ptr<float>(c);
    const float range = std::max(ranges[static_cast<std::size_t>(c)], min_range);
    for (int r = 0; r + 1 < rows; ++r) {
      const float above = column[r] + column[std::max(r - 1, 0)];
      const float below = column[r + 1] + column[std::min(r + 2, rows - 1)];
      out[r] = (below - above) / (2.0F * range);
    }
  }
  return contrast;
}

/// Best predecessor of every row of a column. `before` holds the scores of the previous column,
/// padded by kLargestJump values at both ends.
ALLTACT_WIDE void best_jumps(const float* __restrict before,
                             const float* __restrict contrast,
                             float sign,
                             int rows,
                             float* __restrict score,
                             float* __restrict jump) {
  for (int r = 0; r < rows; ++r) {
    float best = before[r], best_jump = 0.0F;
    for (int j = 1; j <= kLargestJump; ++j) {
      const auto step = static_cast<float>(j);
      const float cost = kJumpPenalty * step * step;
      const float up = before[r - j] - cost, down = before[r + j] - cost;
      best_jump = up > best ? -step : best_jump;
      best = up > best ? up : best;
      best_jump = down > best ? step : best_jump;
      best = down > best ? down : best;
    }
    const float gain = sign * contrast[r];
    score[r] = best + (gain > 0.0F ? gain : 0.0F);
    jump[r] = best_jump;
  }
}

/// The path from the first to the last column with the highest sum of sign * contrast, less the
/// cost of jumps.
Path best_path(const cv::Mat& contrast, float sign) {
  const int rows = contrast.cols, cols = contrast.rows;
  constexpr float kUnreachable = -1e9F;
  const auto padded = static_cast<std::size_t>(rows + 2 * kLargestJump);
  std::vector<float> before(padded, kUnreachable), score(padded, kUnreachable);
  cv::Mat jumps(cols, rows, CV_32FC1);
  std::fill_n(before.begin() + kLargestJump, rows, 0.0F);
  for (int c = 0; c < cols; ++c) {
    best_jumps(before.data() + kLargestJump,
               contrast.ptr<float>(c),
               sign,
               rows,
               score.data() + kLargestJump,
               jumps.ptr<float>(c));
    std::swap(before, score);
  }
  Path path;
  path.row.resize(static_cast<std::size_t>(cols));
  auto r = static_cast<int>(std::max_element(before.begin(), before.end()) - before.begin()) -
           kLargestJump;
  for (int c = cols - 1; c >= 0; --c) {
    path.row[static_cast<std::size_t>(c)] = static_cast<float>(r) + 0.5F;
    r += static_cast<int>(jumps.at<float>(c, r));
  }
  return path;
}

/// `contrast` between two paths, the upper first, and zero elsewhere.
cv::Mat between(const cv::Mat& contrast, const Path& upper, const Path& lower) {
  constexpr int kGap = 2;  // rows that an edge extends over
  cv::Mat inner = cv::Mat::zeros(contrast.size(), CV_32FC1);
  for (int c = 0; c < contrast.rows; ++c) {
    const auto k = static_cast<std::size_t>(c);
    const int first = static_cast<int>(upper.row[k]) + 1 + kGap;
    const int last = static_cast<int>(lower.row[k]) - 1 - kGap;
    for (int r = first; r <= last; ++r) inner.at<float>(c, r) = contrast.at<float>(c, r);
  }
  return inner;
}

/// Columns where the path follows a step of its sign.
std::vector<char> steps_along(const cv::Mat& contrast, const Path& path, float sign) {
  constexpr float kStep = 0.1F;  // fraction of the column's range
  std::vector<char> steps(path.row.size());
  for (std::size_t c = 0; c < steps.size(); ++c)
    steps[c] =
        sign * contrast.at<float>(static_cast<int>(c), static_cast<int>(path.row[c])) > kStep;
  return steps;
}

/// The longest stretch [first, end) of true values; small gaps are allowed.
std::pair<std::size_t, std::size_t> longest_stretch(const std::vector<char>& values) {
  constexpr std::size_t kGap = 4;
  std::pair<std::size_t, std::size_t> longest{0, 0};
  std::size_t first = 0, last = 0;
  bool open = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) continue;
    if (!open || i - last > kGap) first = i;
    open = true;
    last = i;
    if (last + 1 - first > longest.second - longest.first) longest = {first, last + 1};
  }
  return longest;
}

/// True when `path` passes, for a few columns in the direction, where the end of `inner` at `at`
/// points to. These need not be the next columns: it may have left for the border, or for dots on
/// the side face, some columns before.
bool continues_inner(const Path& path, const Path& inner, std::size_t at, int direction) {
  constexpr float kNear = 1.6F;  // rows
  constexpr int kBase = 10, kSearch = 30, kMinNear = 5;
  const auto count = static_cast<int>(path.row.size());
  const auto end = static_cast<int>(at);
  const int base = std::clamp(end - direction * kBase, 0, count - 1);
  if (base == end) return false;
  const float slope =
      (inner.row[at] - inner.row[static_cast<std::size_t>(base)]) / static_cast<float>(end - base);
  int near = 0;
  for (int c = end + direction; c >= 0 && c < count && std::abs(c - end) <= kSearch;
       c += direction) {
    const float ahead = inner.row[at] + slope * static_cast<float>(c - end);
    near += std::abs(path.row[static_cast<std::size_t>(c)] - ahead) < kNear;
  }
  return near >= kMinNear;
}

/// Replaces a first pair of edges on lit side faces by the face's own edges. Outer borders of lit
/// side faces may have more contrast, along all or part of the finger. A second pair of edges of
/// the same signs between the first is the face. An object on the face shows steps of the opposite
/// sign. Between two contacts the signs agree, but only in few columns away from both ends.
void select_inner_edges(const cv::Mat& contrast, float sign, RoughEdges& rough) {
  constexpr double kFractionToEnd = 0.15, kFractionBetween = 0.4;  // of the columns
  const cv::Mat inner = between(contrast, rough.upper, rough.lower);
  const Path upper = best_path(inner, sign), lower = best_path(inner, -sign);
  const auto upper_steps = steps_along(inner, upper, sign);
  const auto lower_steps = steps_along(inner, lower, -sign);
  std::vector<char> both(upper_steps.size());
  for (std::size_t c = 0; c < both.size(); ++c)
    both[c] = upper_steps[c] && lower_steps[c] && upper.row[c] < lower.row[c];
  const auto [first, end] = longest_stretch(both);
  constexpr std::size_t kNearEnd = 3;
  const bool to_an_end = first <= kNearEnd || end + kNearEnd >= both.size();
  const double part = static_cast<double>(end - first) / static_cast<double>(both.size());
  if (part < (to_an_end ? kFractionToEnd : kFractionBetween)) return;
  // Beyond the stretch the first pair may already be the face's own edges, where the path left them
  // for the border. Then they continue where the inner ones end.
  const bool before = first > 0 && continues_inner(rough.upper, upper, first, -1) &&
                      continues_inner(rough.lower, lower, first, -1);
  const bool after = end < both.size() && continues_inner(rough.upper, upper, end - 1, 1) &&
                     continues_inner(rough.lower, lower, end - 1, 1);
  for (std::size_t c = 0; c < both.size(); ++c) {
    const bool inside = c >= first && c < end;
    const bool joined = (before && c < first) || (after && c >= end);
    rough.can_seed[c] = (inside && both[c]) || joined;
    if (joined) continue;
    rough.upper.row[c] = upper.row[c];
    rough.lower.row[c] = lower.row[c];
  }
}

}  // namespace

std::pair<double, double> RoughEdges::position_at(const Path& path, int block, double u) {
  const double column = (u + 0.5) / block - 0.5;
  const int centre = static_cast<int>(std::lround(column));
  const int count = static_cast<int>(path.row.size());
  // Regression line through the neighbours.
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (int c = std::max(0, centre - 3); c <= std::min(count - 1, centre + 3); ++c) {
    const double x = c - column;
    const double y = static_cast<double>(path.row[static_cast<std::size_t>(c)]);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double determinant = n * sxx - sx * sx;
  const double slope = determinant > 0.0 ? (n * sxy - sx * sy) / determinant : 0.0;
  const double row = (sy - slope * sx) / n;
  return {(row + 0.5) * block - 0.5, slope};
}

std::optional<RoughEdges> find_rough_edges(const cv::Mat& grey, double noise_sd) {
  RoughEdges rough;
  rough.block = std::max(1, grey.cols / kSmallWidth);
  if (grey.cols / rough.block < 8 || grey.rows / rough.block < 8) return std::nullopt;
  const cv::Mat contrast = downward_contrast(block_columns(grey, rough.block), noise_sd);
  const Path rising = best_path(contrast, 1.0F), falling = best_path(contrast, -1.0F);
  std::size_t above = 0;  // columns where brightness rises before it falls
  for (std::size_t c = 0; c < rising.row.size(); ++c) above += rising.row[c] < falling.row[c];
  if (10 * above >= 9 * rising.row.size()) {
    rough.upper = rising, rough.lower = falling;
  } else if (10 * above <= rising.row.size()) {
    rough.upper = falling, rough.lower = rising;
    rough.bright_inside = false;
  } else {
    return std::nullopt;
  }
  rough.can_seed.assign(rising.row.size(), 1);
  select_inner_edges(contrast, rough.bright_inside ? 1.0F : -1.0F, rough);
  return rough;
}

}  // namespace alltact
