#include "core/sensing/reference/reference_image.h"

#include "core/image/grey_range.h"
#include "core/numerics/dispatch.h"
#include "core/numerics/median.h"
#include "core/numerics/parallel.h"
#include "core/numerics/vector_loops.h"
#include "core/sensing/reference/image_warp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kWeightBits = 14;  // weights reach 2
constexpr double kMaxWeight = 3.0;
constexpr int kMarginColumns = 3;  // columns by which a run is extended
constexpr int kAhead = 512;  // bytes: several recorded faces are streamed from memory at a time

// (grey 2^7) (weight 2^14) / 2^15 = grey weight 2^6. Intermediate sums may wrap around; the final
// sum fits.
ALLTACT_WIDE void mix_rows(const std::uint8_t* const* rows, const std::int16_t* weights, int count,
                           int n, std::int16_t* __restrict out) {
  constexpr int kFactor = 1 << 7;
  static_assert(kGreySteps << (15 - kWeightBits) == kFactor);
  in_blocks(
      n, [=](int first, auto size) __attribute__((always_inline)) {
        // Widened in a loop of its own: inside the sum the compiler would use 32-bit numbers.
        std::array<std::int16_t, kBlock> sum, wide;
        const auto widen = [&](int k) __attribute__((always_inline)) {
          const std::uint8_t* grey = rows[k] + first;
          __builtin_prefetch(grey + kAhead);
          for (int i = 0; i < size; ++i)
            wide[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(grey[i] * kFactor);
        };
        widen(0);
        for (int i = 0; i < size; ++i)
          sum[static_cast<std::size_t>(i)] =
              multiply_q15(wide[static_cast<std::size_t>(i)], weights[0]);
        for (int k = 1; k < count; ++k) {
          const std::int16_t weight = weights[k];
          widen(k);
          for (int i = 0; i < size; ++i) {
            std::int16_t& here = sum[static_cast<std::size_t>(i)];
            here = static_cast<std::int16_t>(
                here + multiply_q15(wide[static_cast<std::size_t>(i)], weight));
          }
        }
        for (int i = 0; i < size; ++i) out[first + i] = sum[static_cast<std::size_t>(i)];
      });
}

// Rounded so that they still sum to `gain`: the remainder goes to the largest.
std::vector<std::int16_t> fixed_weights(const std::vector<float>& weights, double gain) {
  constexpr double kOne = 1 << kWeightBits;
  std::vector<std::int16_t> rounded(weights.size());
  double left = gain * kOne, magnitude = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double weight = gain * static_cast<double>(weights[i]);
    rounded[i] =
        static_cast<std::int16_t>(std::clamp(std::round(kOne * weight), -32767.0, 32767.0));
    left -= rounded[i];
    magnitude += std::abs(weight);
  }
  CV_Assert(magnitude <= gain * kMaxWeight && std::abs(left) < 0.01 * kOne);
  std::int16_t& largest = *std::max_element(rounded.begin(), rounded.end());
  largest = static_cast<std::int16_t>(std::min(largest + left, 32767.0));
  return rounded;
}

}  // namespace

ReferenceImage::ReferenceImage(const cv::Mat& grey)
    : single_(grey.size(), CV_16SC1), size_(grey.size()) {
  CV_Assert(grey.type() == CV_32FC1);
  for (int v = 0; v < grey.rows; ++v)
    std::transform(grey.ptr<float>(v), grey.ptr<float>(v) + grey.cols, single_.ptr<std::int16_t>(v),
                   to_steps);
}

std::pair<int, int> FaceMix::shown(const FaceGrid& grid) const {
  int first = 0, end = grid.size.width;
  for (const FaceImage* face : faces)
    first = std::max(first, face->first), end = std::min(end, face->end);
  return {first, std::max(first, end)};
}

namespace {

constexpr int kSeamColumns = 24;  // of the grid, next to the columns that another mix fills
constexpr double kMaxSeamGain = 1.5;

/// Factor of a mix by the row of the grid.
struct RowGain {
  double constant = 1, per_row = 0;
  double most = kMaxSeamGain;  ///< at least 1

  [[nodiscard]] double at(int row) const {
    return std::clamp(constant + per_row * row, 1.0 / kMaxSeamGain, most);
  }
};

/// The largest factor with which each weight still fits into 16 bits.
double most_gain(const std::vector<float>& weights) {
  constexpr double kMostWeight = 1.999;
  double largest = 0;
  for (const float weight : weights)
    largest = std::max(largest, static_cast<double>(std::abs(weight)));
  return std::clamp(kMostWeight / largest, 1.0, kMaxSeamGain);
}

/// Sum of a mix over n pixels of a run, `offset` from its beginning.
double sum_over(const FaceMix& mix, std::size_t offset, int n) {
  double sum = 0;
  for (std::size_t k = 0; k < mix.faces.size(); ++k) {
    const std::uint8_t* grey = mix.faces[k]->grey.data() + offset;
    sum += static_cast<double>(mix.weights[k]) * std::accumulate(grey, grey + n, 0);
  }
  return sum;
}

/// Factor by which the further mix continues the nearer one without a step: least squares over
/// these columns. Frames of further poses are lit otherwise, which would read as depth over the
/// entire end of the face.
RowGain seam_gain(const FaceMix& near, const FaceMix& further, const FaceGrid& grid, int first,
                  int end) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const FaceRun& run : grid.runs.runs) {
    const int from = std::max(run.first, first), n = std::min(run.end, end) - from;
    if (n <= 0) continue;
    const auto offset = run.before + static_cast<std::size_t>(from - run.first);
    const double have = sum_over(further, offset, n);
    const Eigen::Vector2d row(have, have * run.row);
    normal += row * row.transpose();
    right += row * sum_over(near, offset, n);
  }
  const Eigen::LDLT<Eigen::Matrix2d> solver(normal);
  if (!(normal(0, 0) > 0)) return {};
  const Eigen::Vector2d gain = solver.rcond() > 1e-9 ? Eigen::Vector2d(solver.solve(right))
                                                     : Eigen::Vector2d(right[0] / normal(0, 0), 0);
  return {gain[0], gain[1], most_gain(further.weights)};
}

}  // namespace

/// Columns of the grid for which one mix is used.
struct ReferenceImage::MixedColumns {
  const FaceMix& mix;
  int first, end;
  std::vector<std::int16_t> weights;
  std::vector<const std::uint8_t*> rows;  // of the faces, where a run begins

  RowGain gain;
  double gain_of_weights = 0;

  MixedColumns(const FaceMix& of, const RowGain& by_row, int from, int to)
      : mix(of), first(from), end(to), rows(of.faces.size()), gain(by_row) {
    CV_Assert(!mix.faces.empty() && mix.faces.size() == mix.weights.size());
  }

  /// Mixes the part of a run within these columns into a row of the grid.
  void mix_run(const FaceRun& run, std::int16_t* mixed) {
    const int from = std::max(run.first, first), to = std::min(run.end, end);
    if (from >= to) return;
    if (const double factor = gain.at(run.row); factor != gain_of_weights)
      weights = fixed_weights(mix.weights, gain_of_weights = factor);
    // A full block also for few columns, because partial vectors are slow.
    std::array<std::int16_t, kBlock> block;
    const bool is_narrow = to - from < kBlock && run.size() >= kBlock;
    const int begin = is_narrow ? std::min(from, run.end - kBlock) : from;
    for (std::size_t k = 0; k < rows.size(); ++k)
      rows[k] = mix.faces[k]->grey.data() + run.before + (begin - run.first);
    mix_rows(rows.data(), weights.data(), static_cast<int>(rows.size()),
             is_narrow ? kBlock : to - from, is_narrow ? block.data() : mixed + from);
    if (is_narrow) std::copy_n(block.data() + (from - begin), to - from, mixed + from);
    // Where the face's edge is steep, sampled positions may lie slightly outside of the run.
    if (from == run.first) std::fill(mixed + from - kMarginColumns, mixed + from, mixed[from]);
    if (to == run.end) std::fill(mixed + to, mixed + to + kMarginColumns, mixed[to - 1]);
  }
};

ReferenceImage::ReferenceImage(const FaceGrid& grid, const std::vector<FaceMix>& mixes,
                               ChartWarp warp, const cv::Size& size)
    : origin_(grid.origin), warp_(std::move(warp)), size_(size) {
  CV_Assert(!mixes.empty());
  const std::pair<int, int> inner = mixes.front().shown(grid);
  std::pair<int, int> done = inner;
  std::vector<MixedColumns> parts;
  if (done.first < done.second)
    parts.emplace_back(mixes.front(), RowGain(), done.first, done.second);
  std::tie(inner_first_, inner_end_) = columns_within(done.first, done.second);
  for (std::size_t k = 1; k < mixes.size(); ++k) {
    const auto [first, end] = mixes[k].shown(grid);
    const auto take = [&](int from, int to, int seam) {
      if (from >= to) return;
      const RowGain gain =
          seam_gain(mixes.front(), mixes[k], grid, std::max({first, inner.first, seam}),
                    std::min({end, inner.second, seam + kSeamColumns}));
      parts.emplace_back(mixes[k], gain, from, to);
    };
    take(first, std::min(end, done.first), inner.first);
    take(std::max(first, done.second), end, inner.second - kSeamColumns);
    if (end >= done.first) done.first = std::min(done.first, first);
    if (first <= done.second) done.second = std::max(done.second, end);
  }
  std::tie(full_first_, full_end_) = columns_within(done.first, done.second);
  std::tie(first_, end_) = columns_overlapping(done.first, done.second);
  min_u_ = static_cast<float>(done.first + origin_.x);
  max_u_ = static_cast<float>(done.second - 1 + origin_.x);
  mix_and_warp(grid, parts);
}

namespace {

/// Trims the columns at both ends to those that fulfil the condition.
template <class IsInside>
std::pair<int, int> between(int low, int high, IsInside is_inside) {
  while (low < high && !is_inside(low)) ++low;
  while (low < high && !is_inside(high - 1)) --high;
  return {low, high};
}

}  // namespace

/// The part of the warp that stays within columns of the grid.
std::pair<int, int> ReferenceImage::columns_within(int first, int end) const {
  return between(std::max(0, warp_.inner_first()), std::min(size_.width, warp_.inner_end()),
                 [&](int u) {
                   const auto [low, high] = warp_.reach(u);
                   return low >= static_cast<float>(first + origin_.x) &&
                          high <= static_cast<float>(end - 1 + origin_.x);
                 });
}

/// The part of the warp that overlaps columns of the grid.
std::pair<int, int> ReferenceImage::columns_overlapping(int first, int end) const {
  return between(std::max(0, warp_.first()), std::min(size_.width, warp_.end()), [&](int u) {
    const auto [low, high] = warp_.reach(u);
    return high >= static_cast<float>(first + origin_.x) &&
           low <= static_cast<float>(end - 1 + origin_.x);
  });
}

/// Mixes each row of the grid and warps it along the frame's columns at once.
void ReferenceImage::mix_and_warp(const FaceGrid& grid, std::vector<MixedColumns>& parts) {
  warped_ = pooled_image({size_.width + kWarpChunk, grid.size.height + 1}, CV_16SC1);
  warped_rows_ = grid.size.height;
  std::vector<std::int16_t> row(
      static_cast<std::size_t>(std::ptrdiff_t{2} * kWarpChunk + grid.size.width));
  std::int16_t* mixed = row.data() + kWarpChunk;
  for (const FaceRun& run : grid.runs.runs) {
    for (MixedColumns& part : parts) part.mix_run(run, mixed);
    const auto [first, end] =
        warp_.columns_reaching(static_cast<float>(run.first - kMarginColumns + origin_.x),
                               static_cast<float>(run.end + kMarginColumns + origin_.x));
    const int from = std::max(first, 0), to = std::min(end, size_.width);
    if (from >= to) continue;
    warp_along(mixed,
               {warp_.columns(), from - warp_.origin(), static_cast<float>(run.row + origin_.y),
                static_cast<float>(origin_.x), grid.size.width},
               to - from, warped_.ptr<std::int16_t>(run.row) + from);
  }
}

cv::Mat ReferenceImage::grey() const {
  if (size_.empty()) return {};
  cv::Mat grey = pooled_image(size_, CV_32FC1);
  fill_nan(grey.ptr<float>(0), static_cast<int>(grey.total()));
  Reader reader(*this);
  const auto level = [](std::int16_t steps) {
    return steps == kNoGrey ? std::numeric_limits<float>::quiet_NaN()
                            : static_cast<float>(steps) / static_cast<float>(kGreySteps);
  };
  for (int v = 0; v < size_.height; ++v) {
    std::vector<FaceRun> runs;
    if (is_single()) runs.push_back({v, 0, size_.width, 0});
    for (int u = first_; u < end_ && !is_single(); ++u)
      if (const double t = warp_.across(u, v); t >= 0.0 && t <= 1.0) {
        if (runs.empty() || runs.back().end != u) runs.push_back({v, u, u, 0});
        ++runs.back().end;
      }
    const std::int16_t* row = reader.row(v, runs);
    for (const FaceRun& run : runs)
      std::transform(row + run.first, row + run.end, grey.ptr<float>(v) + run.first, level);
  }
  return grey;
}

ReferenceImage::Reader::Reader(const ReferenceImage& image)
    : image_(image),
      u_(static_cast<std::size_t>(image.size_.width)),
      v_(u_.size()),
      buffer_(u_.size() + kWarpChunk, kNoGrey) {}

const std::int16_t* ReferenceImage::Reader::row(int v, std::span<const FaceRun> runs) {
  if (image_.is_single()) return image_.single_.ptr<std::int16_t>(v);
  for (const FaceRun& run : runs) {
    const int first = std::clamp(image_.first_, run.first, run.end);
    const int end = std::clamp(image_.end_, first, run.end);
    if (first == end) {
      std::fill(buffer_.data() + run.first, buffer_.data() + run.end, kNoGrey);
      continue;
    }
    warp_across(image_.warped_.ptr<std::int16_t>(0) + first, image_.warped_.cols,
                {image_.warp_.rows(), first - image_.warp_.origin(), static_cast<float>(v),
                 static_cast<float>(image_.origin_.y), image_.warped_rows_},
                end - first, buffer_.data() + first);
    const int full = std::clamp(image_.full_first_, first, end);
    clear_hidden(v, first, full);
    clear_hidden(v, std::clamp(image_.full_end_, full, end), end);
    std::fill(buffer_.data() + run.first, buffer_.data() + first, kNoGrey);
    // and the excess of warp_across()
    std::fill(buffer_.data() + end, buffer_.data() + run.end, kNoGrey);
  }
  return buffer_.data();
}

void ReferenceImage::Reader::clear_hidden(int v, int first, int end) {
  if (first == end) return;
  image_.warp_.positions(v, first, end - first, u_.data(), v_.data());
  for (int u = first; u < end; ++u) {
    const float at_u = u_[static_cast<std::size_t>(u - first)];
    if (!(at_u >= image_.min_u_ && at_u <= image_.max_u_))
      buffer_[static_cast<std::size_t>(u)] = kNoGrey;
  }
}

namespace {

constexpr double kGridMarginPx =
    2.0;  // around the face, because sampled positions lie between pixels

/// Columns of one row that lie between the edges of the grid's chart.
std::vector<FaceRun> runs_of(const FaceGrid& grid, int row) {
  std::vector<FaceRun> runs;
  bool is_open = false;
  for (int u = 0; u < grid.size.width; ++u) {
    const auto i = static_cast<std::size_t>(u);
    const double v = row + grid.origin.y;
    const bool is_face =
        v >= grid.chart.upper_v[i] - kGridMarginPx && v <= grid.chart.lower_v[i] + kGridMarginPx;
    if (is_face && !is_open) runs.push_back({row, u, u, 0});
    if (is_face) runs.back().end = u + 1;
    is_open = is_face;
  }
  return runs;
}

}  // namespace

FaceGrid face_grid(const FaceChart& rest, double part) {
  FaceGrid grid;
  grid.chart = widened(rest, part);
  const double top = *std::min_element(grid.chart.upper_v.begin(), grid.chart.upper_v.end());
  const double bottom = *std::max_element(grid.chart.lower_v.begin(), grid.chart.lower_v.end());
  grid.origin = {grid.chart.first, static_cast<int>(std::floor(top - kGridMarginPx)) - 1};
  grid.size = {static_cast<int>(grid.chart.along_mm.size()),
               static_cast<int>(std::ceil(bottom + kGridMarginPx)) + 2 - grid.origin.y};
  std::uint32_t pixels = 0;
  grid.runs.row_begin.push_back(0);
  for (int row = 0; row < grid.size.height; ++row) {
    for (FaceRun run : runs_of(grid, row)) {
      run.before = pixels;
      pixels += static_cast<std::uint32_t>(run.size());
      grid.runs.runs.push_back(run);
    }
    grid.runs.row_begin.push_back(static_cast<std::uint32_t>(grid.runs.runs.size()));
  }
  return grid;
}

FaceImage warp_face(const cv::Mat& grey, const FaceChart& chart, const FaceGrid& grid) {
  const ChartWarp warp(grid.chart, chart);
  FaceImage image;
  image.first = warp.inner_first() - grid.origin.x;
  image.end = warp.inner_end() - grid.origin.x;
  image.grey.assign(grid.runs.pixels(), 0);
  const CubicSampler seen(grey);
  std::vector<float> u(static_cast<std::size_t>(grid.size.width)), v(u.size());
  for (const FaceRun& run : grid.runs.runs) {
    const int first = std::max(run.first, image.first), end = std::min(run.end, image.end);
    if (first >= end) continue;
    warp.positions(run.row + grid.origin.y, first + grid.origin.x, end - first, u.data(), v.data());
    seen.sample(u.data(), v.data(), end - first,
                image.grey.data() + run.before + (first - run.first));
  }
  return image;
}

namespace {

constexpr int kCell = kErrorCellPx;
constexpr int kTerms = 6;
constexpr int kEvery = 2;  // cells are enough for the light
constexpr float kMinLevel = kTooDarkBelow;
constexpr int kMinFrames = 12;              // to separate drift from pose
constexpr int kMaxStudied = 48;             // frames computed from their neighbours
constexpr double kMedianOfSquare = 0.4549;  // of a normal distribution
constexpr double kConstantPart = 0.5;  // part of the variance that does not fall with the reach

/// Processes faces in parallel; runs while a recording is read, before any live measurement.
template <class Work>
void for_all(int count, const Work& work) {
  parallel_for(count, default_threads(), [&](int from, int to) {
    for (int i = from; i < to; ++i) work(static_cast<std::size_t>(i));
  });
}

using Terms = Eigen::Matrix<double, kTerms, 1>;
using Square = Eigen::Matrix<double, kTerms, kTerms>;

Terms basis_at(const cv::Size& size, double u, double v) {
  const double s = 2.0 * u / size.width - 1.0, t = 2.0 * v / size.height - 1.0;
  return (Terms() << 1.0, s, t, s * s, s * t, t * t).finished();
}

/// Means over cells of the grid, 0 where a cell shows the face in part only.
cv::Mat cells_of(const FaceGrid& grid, const FaceImage& face) {
  const cv::Size size(grid.size.width / kCell, grid.size.height / kCell);
  cv::Mat sum(size, CV_32SC1, cv::Scalar(0)), count = sum.clone();
  for (const FaceRun& run : grid.runs.runs) {
    const int row = run.row / kCell;
    if (row >= size.height) continue;
    const std::uint8_t* grey = face.grey.data() + run.before;
    const int end = std::min({run.end, face.end, size.width * kCell});
    for (int u = std::max(run.first, face.first), next = 0; u < end; u = next) {
      const int cell = u / kCell;
      next = std::min(end, (cell + 1) * kCell);
      sum.at<int>(row, cell) = std::accumulate(grey + (u - run.first), grey + (next - run.first),
                                               sum.at<int>(row, cell));
      count.at<int>(row, cell) += next - u;
    }
  }
  constexpr int kPixels = kCell * kCell;
  cv::Mat mean(size, CV_32FC1, cv::Scalar(0));
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const auto level = static_cast<float>(sum.at<int>(y, x));
      if (count.at<int>(y, x) == kPixels && level > kMinLevel * kPixels)
        mean.at<float>(y, x) = level / kPixels;
    }
  return mean;
}

std::vector<cv::Mat> cells_of(const FaceGrid& grid, const std::vector<FaceImage>& faces) {
  std::vector<cv::Mat> cells(faces.size());
  for_all(static_cast<int>(faces.size()),
          [&](std::size_t i) { cells[i] = cells_of(grid, faces[i]); });
  return cells;
}

/// c so that (1 + basis c) own approximates `other`, over cells that both have; robust.
Terms light_between(const cv::Mat& own, const cv::Mat& other) {
  Terms terms = Terms::Zero();
  for (int round = 0; round < 3; ++round) {
    Square normal = 1e-6 * Square::Identity();
    Terms pull = Terms::Zero();
    for (int y = 0; y < own.rows; y += kEvery)
      for (int x = 0; x < own.cols; x += kEvery) {
        const auto a = static_cast<double>(own.at<float>(y, x)),
                   b = static_cast<double>(other.at<float>(y, x));
        if (!(a > 0.0) || !(b > 0.0)) continue;
        const Terms row = basis_at(own.size(), x + 0.5, y + 0.5);
        const double off = b / a - 1.0 - row.dot(terms);
        constexpr double kFar = 0.05;
        const double z = round == 0 ? 0.0 : off / kFar;
        if (std::abs(z) >= 1.0) continue;
        const double weight = (1.0 - z * z) * (1.0 - z * z);
        normal.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
        pull += weight * (b / a - 1.0) * row;
      }
    terms = normal.selfadjointView<Eigen::Lower>().ldlt().solve(pull);
  }
  return terms.allFinite() ? terms : Terms::Zero();
}

cv::Mat mean_cells(const std::vector<cv::Mat>& cells) {
  cv::Mat sum(cells.front().size(), CV_32FC1, cv::Scalar(0)), count = sum.clone();
  for (const cv::Mat& one : cells) {
    sum += one;
    cv::Mat shown;
    cv::Mat(one > 0.0F).convertTo(shown, CV_32F, 1.0 / 255);
    count += shown;
  }
  cv::Mat mean = sum / cv::max(count, 1.0);
  mean.setTo(0, count < 0.5 * static_cast<double>(cells.size()));
  return mean;
}

/// Constant, linear and square terms of the leading modes, as many as the number of frames
/// supports.
Eigen::MatrixXd pose_terms(const Eigen::MatrixXd& modes) {
  const Eigen::Index frames = modes.rows();
  Eigen::Index used = std::min<Eigen::Index>(modes.cols(), 4);
  const auto count = [](Eigen::Index n) { return 1 + n + n * (n + 1) / 2; };
  while (used > 0 && 4 * count(used) > frames) --used;
  Eigen::MatrixXd terms(frames, count(used));
  const double scale = std::max(1e-9, modes.leftCols(std::max<Eigen::Index>(used, 1)).norm() /
                                          std::sqrt(static_cast<double>(frames)));
  terms.col(0).setOnes();
  Eigen::Index next = 1;
  for (Eigen::Index a = 0; a < used; ++a) terms.col(next++) = modes.col(a) / scale;
  for (Eigen::Index a = 0; a < used; ++a)
    for (Eigen::Index b = a; b < used; ++b)
      terms.col(next++) = modes.col(a).cwiseProduct(modes.col(b)) / (scale * scale);
  return terms;
}

/// Multiplies one row's pixels by a + b u + c u^2; clipped ones stay clipped.
ALLTACT_WIDE void multiply_row(std::uint8_t* grey, int count, int first, float a, float b,
                               float c) {
  for (int i = 0; i < count; ++i) {
    const auto u = static_cast<float>(first + i);
    const auto level = static_cast<float>(grey[i]);
    const float bright = (a + u * (b + u * c)) * level + 0.5F;
    const float limit = kClippedFrom - 1;
    const float within = bright < 0.0F ? 0.0F : bright < limit ? bright : limit;
    grey[i] = static_cast<std::uint8_t>(
        static_cast<std::int32_t>(level >= static_cast<float>(kClippedFrom) ? level : within));
  }
}

void multiply(const FaceGrid& grid, const Terms& light, FaceImage& face) {
  for (const FaceRun& run : grid.runs.runs) {
    // basis_at() of the row, in powers of the column.
    const double per_px = 2.0 / grid.size.width, from = per_px * 0.5 - 1.0,
                 t = 2.0 * (run.row + 0.5) / grid.size.height - 1.0;
    const double constant = 1.0 + light[0] + t * (light[2] + t * light[5]),
                 slope = light[1] + t * light[4];
    multiply_row(face.grey.data() + run.before, run.size(), run.first,
                 static_cast<float>(constant + from * (slope + from * light[3])),
                 static_cast<float>(per_px * (slope + 2.0 * from * light[3])),
                 static_cast<float>(per_px * per_px * light[3]));
  }
}

/// Relative difference between a frame and its prediction from neighbours, without a change of
/// light; NaN where either has no value.
cv::Mat residual_of(const cv::Mat& own, const cv::Mat& computed) {
  const Terms light = light_between(own, computed);
  cv::Mat residual(own.size(), CV_32FC1, cv::Scalar(NAN));
  for (int y = 0; y < own.rows; ++y)
    for (int x = 0; x < own.cols; ++x) {
      const float a = own.at<float>(y, x), b = computed.at<float>(y, x);
      if (!(a > 0.0F) || !(b > 0.0F)) continue;
      const double q = 1.0 + basis_at(own.size(), x + 0.5, y + 0.5).dot(light);
      residual.at<float>(y, x) = static_cast<float>(q * static_cast<double>(a / b) - 1.0);
    }
  return residual;
}

/// Noise of cells' means in grey levels, squared: from differences of adjacent cells, most of which
/// show even skin.
double noise_square(const cv::Mat& residual, const cv::Mat& level) {
  std::vector<double> squares;
  for (int y = 0; y < residual.rows; ++y)
    for (int x = 0; x + 1 < residual.cols; ++x) {
      const double step = static_cast<double>(residual.at<float>(y, x + 1)) -
                          static_cast<double>(residual.at<float>(y, x));
      const double off = step * static_cast<double>(level.at<float>(y, x));
      if (std::isfinite(off)) squares.push_back(0.5 * off * off);
    }
  return squares.empty() ? 0.0 : upper_median(squares) / kMedianOfSquare;
}

cv::Mat computed_from(const std::vector<cv::Mat>& cells, const PoseNeighbours& neighbours) {
  cv::Mat sum(cells.front().size(), CV_32FC1, cv::Scalar(0)), shown = sum == 0.0F;
  for (std::size_t k = 0; k < neighbours.rows.size(); ++k) {
    const cv::Mat& one = cells[static_cast<std::size_t>(neighbours.rows[k])];
    sum += neighbours.weights[static_cast<Eigen::Index>(k)] * one;
    shown &= one > 0.0F;
  }
  sum.setTo(0, ~shown);
  return sum;
}

/// Adds up the squared errors of each cell over the studied frames, less their noise, and counts
/// them. They are NaN where a frame did not show a cell. Frames with an unnoticed contact at a cell
/// are outliers there and excluded.
void add_inliers(const std::vector<cv::Mat>& squares, const std::vector<cv::Mat>& noise,
                 cv::Mat& sum, cv::Mat& count) {
  constexpr double kFar = 4.0;  // standard deviations
  std::vector<float> shown;
  for (int y = 0; y < sum.rows; ++y)
    for (int x = 0; x < sum.cols; ++x) {
      shown.clear();
      for (const cv::Mat& one : squares)
        if (const float off2 = one.at<float>(y, x); std::isfinite(off2)) shown.push_back(off2);
      const auto limit = kFar * kFar / kMedianOfSquare * static_cast<double>(upper_median(shown));
      for (std::size_t k = 0; k < squares.size(); ++k) {
        const float off2 = squares[k].at<float>(y, x);
        if (!(static_cast<double>(off2) <= limit)) continue;
        sum.at<float>(y, x) += off2 - noise[k].at<float>(y, x);
        count.at<float>(y, x) += 1.0F;
      }
    }
}

}  // namespace

double ReferenceError::factor(double reach) const {
  if (!(typical_reach_px2 > 0.0)) return 1.0;
  const double further = reach / typical_reach_px2;
  return std::sqrt(kConstantPart + (1.0 - kConstantPart) * further * further);
}

void remove_drift(const FaceGrid& grid, const Eigen::MatrixXd& modes,
                  std::vector<FaceImage>& faces) {
  if (static_cast<int>(faces.size()) < kMinFrames) return;
  const auto count = static_cast<int>(faces.size());
  const std::vector<cv::Mat> cells = cells_of(grid, faces);
  const cv::Mat mean = mean_cells(cells);
  Eigen::MatrixXd light(count, kTerms);
  for_all(count, [&](std::size_t i) {
    light.row(static_cast<Eigen::Index>(i)) = light_between(cells[i], mean).transpose();
  });
  const Eigen::MatrixXd terms = pose_terms(modes);
  const Eigen::MatrixXd by_pose = terms * terms.colPivHouseholderQr().solve(light);
  const Eigen::MatrixXd drift = light - by_pose;
  constexpr double kNegligible = 5e-4;
  for_all(count, [&](std::size_t i) {
    const Terms off = drift.row(static_cast<Eigen::Index>(i)).transpose();
    if (off.cwiseAbs().maxCoeff() > kNegligible) multiply(grid, off, faces[i]);
  });
}

ReferenceError reference_error(const FaceGrid& grid, const std::vector<FaceImage>& faces,
                               const std::function<PoseNeighbours(int)>& neighbours_of) {
  const std::vector<cv::Mat> cells = cells_of(grid, faces);
  const std::size_t studied = std::min(faces.size(), std::size_t{kMaxStudied});
  std::vector<cv::Mat> squares(studied), noise(studied);
  std::vector<double> reaches(studied);
  for_all(static_cast<int>(studied), [&](std::size_t k) {
    const std::size_t i = k * faces.size() / studied;
    const PoseNeighbours neighbours = neighbours_of(static_cast<int>(i));
    const cv::Mat computed = computed_from(cells, neighbours);
    const cv::Mat residual = residual_of(cells[i], computed);
    squares[k] = residual.mul(residual);
    noise[k] = noise_square(residual, computed) / computed.mul(computed);
    reaches[k] = neighbours.reach_px2;
  });
  ReferenceError error;
  error.typical_reach_px2 = upper_median(reaches);
  // Averaged over a cell and its neighbours, because each has few frames.
  cv::Mat sum(cells.front().size(), CV_32FC1, cv::Scalar(0)), count = sum.clone();
  add_inliers(squares, noise, sum, count);
  cv::Mat square, number;
  cv::boxFilter(sum, square, CV_32F, {3, 3}, {-1, -1}, false, cv::BORDER_ISOLATED);
  cv::boxFilter(count, number, CV_32F, {3, 3}, {-1, -1}, false, cv::BORDER_ISOLATED);
  cv::sqrt(cv::max(square / cv::max(number, 1.0), 0.0), error.relative_sd);
  // Cells without a studied frame take the greatest error.
  double worst = 0;
  cv::minMaxLoc(error.relative_sd, nullptr, &worst);
  error.relative_sd.setTo(worst, number < 1.0);
  return error;
}

}  // namespace alltact
