#include "core/sensing/depth/spread_on_face.h"

#include "core/numerics/dispatch.h"
#include "core/numerics/image_noise.h"
#include "core/sensing/depth/light_spread.h"

#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

namespace alltact {

double core_for_removal(double core) {
  constexpr int kMostOrders = 9;
  return core / std::max(1e-9, 1.0 - std::pow(1.0 - core, kMostOrders));
}

namespace {

constexpr float kLeastSpread = -0.5F, kMostSpread = 0.95F;  // of the y whose skirt is computed
constexpr float kMostOfSkirt = 0.9F;                        // q

float narrowed(float even) {
  return 1.0F / static_cast<float>(skirt_narrowing(static_cast<double>(even)));
}

}  // namespace

SkirtLight::SkirtLight(const UnrolledFace& face, double width_mm, std::vector<float> core)
    : size_(face.size() / 2), q_(size_, CV_32FC1, cv::Scalar(0.0)), core_(std::move(core)) {
  const double along_mm = face.size().width * face.step_along_mm(),
               across_mm = face.size().height * face.step_across_mm();
  bending_.create(size_, CV_32FC1);
  std::vector<float> by_column;
  for (int i = 0; i < size_.width; ++i) {
    const double k = M_PI * width_mm * i / along_mm;
    by_column.push_back(static_cast<float>(k * k));
  }
  for (int j = 0; j < size_.height; ++j) {
    const double k = M_PI * width_mm * j / across_mm;
    const auto by_row = static_cast<float>(k * k);
    float* bending = bending_.ptr<float>(j);
    for (std::size_t i = 0; i < by_column.size(); ++i) bending[i] = by_row + by_column[i];
  }
}

void SkirtLight::solve(double middle, const cv::Mat& sources) {
  cv::dct(sources, q_);
  cv::divide(q_, bending_ + middle, q_);
  cv::dct(q_, q_, cv::DCT_INVERSE);
}

void SkirtLight::set(const cv::Mat& y) {
  constexpr int kSteps = 40;
  cv::Mat even, r(size_, CV_32FC1);
  cv::resize(y, even, size_, 0, 0, cv::INTER_AREA);
  for (int j = 0; j < size_.height; ++j) {
    float *e = even.ptr<float>(j), *here = r.ptr<float>(j);
    for (int i = 0; i < size_.width; ++i) {
      e[i] =
          (1.0F - core_[static_cast<std::size_t>(i)]) * std::clamp(e[i], kLeastSpread, kMostSpread);
      here[i] = narrowed(e[i]);
    }
  }
  double least = 0, most = 0;
  cv::minMaxLoc(r, &least, &most);
  const double middle = 0.5 * (least + most);  // of all r, so that it converges
  const cv::Mat sources = r.mul(even), rest = r - middle;
  for (int step = 0; step < kSteps; ++step) solve(middle, sources - rest.mul(q_));
}

// With F = r q - width^2 laplace q - r e(y(q)), Newton's method needs F' = J - width^2 laplace. One
// middle J for all cells makes that a division of waves.
void SkirtLight::approach(const cv::Mat& seen_x, const cv::Mat& y) {
  cv::Mat sources(size_, CV_32FC1);
  float least = std::numeric_limits<float>::infinity(), most = 0;
  for (int j = 0; j < size_.height; ++j) {
    const float *x = seen_x.ptr<float>(j), *here = y.ptr<float>(j), *q = q_.ptr<float>(j);
    float* source = sources.ptr<float>(j);
    for (int i = 0; i < size_.width; ++i) {
      const float core = core_[static_cast<std::size_t>(i)];
      const float limited = std::min(std::max(here[i], kLeastSpread), kMostSpread);
      const float even = (1.0F - core) * limited;
      const float r = narrowed(even), passed = 1.0F - std::min(q[i], kMostOfSkirt);
      // With k the core's part of x: dk/dq = -(1 - x) / (1 - q)^2, dy/dk = (1 - e)^2 / core
      const float dy_dq = (1.0F - even) * (1.0F - even) / core *
                          (1.0F - std::min(x[i], kMostSpread)) / (passed * passed);
      const float slope = r * (1.0F + (1.0F - core) * dy_dq);
      least = std::min(least, slope), most = std::max(most, slope);
      source[i] = r * (even - q[i]);
    }
  }
  const double middle = 0.5 * static_cast<double>(least + most);
  solve(middle, sources + middle * q_);
}

namespace {

SpreadOnFace::Columns columns_of(const UnrolledFace& face, const MappingParameters& mapping,
                                 SpreadOnFace::Core core) {
  SpreadOnFace::Columns columns;
  for (int i = 0; i < face.size().width; ++i) {
    const UnrolledFace::Sight& sight = face.sight(i);
    const ObliqueSpread oblique = oblique_spread(mapping.spread, sight.cos_sight);
    columns.along.push_back(static_cast<float>(sight.along));
    columns.across.push_back(static_cast<float>(sight.across));
    columns.across_slope.push_back(static_cast<float>(sight.across_slope));
    columns.core.push_back(static_cast<float>(
        core == SpreadOnFace::Core::kOfLight ? oblique.core : core_for_removal(oblique.core)));
    columns.skirt_shift.push_back(static_cast<float>(oblique.skirt_shift));
    columns.b.push_back(
        static_cast<float>(b_at(mapping.spread, face.along_mm(i), sight.cos_sight)));
  }
  return columns;
}

/// The mean of every two columns.
std::vector<float> halved(const std::vector<float>& all) {
  std::vector<float> half;
  for (std::size_t i = 0; i + 1 < all.size(); i += 2) half.push_back(0.5F * (all[i] + all[i + 1]));
  return half;
}

constexpr int kParts = 24;  // of the table of pixels that see
constexpr float kLeastPart = 0.2F, kPartStep = 0.04F;

constexpr int kRounds = 8;        // on the grid of half as many
constexpr int kRoundsOfPath = 3;  // of all cells, from there
// A cell's depth decides from where it is seen. At steep edges full steps swing.
constexpr float kDamping = 0.5F;

struct UndoneRow {
  int cells;
  float cells_per_step;  // 1, or 2 on the grid of half as many
  int table_step;        // from cell to cell
  float row;             // on the face's grid
  float middle_row, layer_mm, thickness_mm, last_column;
};

ALLTACT_WIDE void undo_row(const UndoneRow& of, const float* __restrict along,
                           const float* __restrict across, const float* __restrict across_slope,
                           const float* __restrict core, const float* __restrict skirt_shift,
                           const float* __restrict b, const float* __restrict seeing,
                           const float* __restrict seeing_next, const BilinearSamples& x_at,
                           const BilinearSamples& q_at, float* __restrict y,
                           float* __restrict seen_x) {
  constexpr float kLast = kLeastPart + (static_cast<float>(kParts) - 1.001F) * kPartStep;
  const BilinearSamples x = x_at, q = q_at;
  const UndoneRow here = of;
  const float offset = 0.5F * (here.cells_per_step - 1.0F), steps = 1.0F / here.cells_per_step;
  for (int i = 0; i < here.cells; ++i) {
    const float depth_mm = depth_on_curve(y[i], b[i], here.thickness_mm);
    const float part = std::min(std::max(1.0F - depth_mm / here.layer_mm, kLeastPart), kLast);
    const float at = (part - kLeastPart) / kPartStep;
    const int k = static_cast<int>(at);
    const int entry = i * here.table_step + k;
    // The pixel whose line of sight is above the cell after this part of its path.
    const float from = offset + seeing[entry] +
                       (at - static_cast<float>(k)) * (seeing_next[entry] - seeing[entry]);
    const int sight = static_cast<int>(std::min(std::max(from, 0.0F), here.last_column) + 0.5F);
    const float from_row = here.middle_row + (here.row - here.middle_row - part * across[sight]) /
                                                 (1.0F + part * across_slope[sight]);
    const float shift = skirt_shift[sight];
    const float q_column = from + shift * along[sight];
    const float q_row =
        from_row + shift * (across[sight] + across_slope[sight] * (from_row - here.middle_row));
    const float shown = x.at((from - offset) * steps, (from_row - offset) * steps);
    const float lost = std::min(q.at(0.5F * q_column - 0.25F, 0.5F * q_row - 0.25F), kMostOfSkirt);
    const float c = core[sight];
    // From y = -1 to the pole at 1.
    const float by_core =
        std::min(std::max(1.0F - (1.0F - shown) / (1.0F - lost), -c / (2.0F - c)), 1.0F);
    y[i] += kDamping * (by_core / (c + (1.0F - c) * by_core) - y[i]);
    seen_x[i] = shown;
  }
}

}  // namespace

SpreadOnFace::SpreadOnFace(const UnrolledFace& face, const MappingParameters& mapping,
                           double layer_mm, Core core)
    : middle_row_(static_cast<float>(face.middle_row())),
      layer_mm_(static_cast<float>(layer_mm)),
      thickness_mm_(static_cast<float>(thickness_of(mapping))),
      columns_(columns_of(face, mapping, core)),
      half_b_(halved(columns_.b)),
      skirt_(face, skirt_width_mm(mapping.spread, layer_mm), halved(columns_.core)) {
  tabulate_seeing();
}

float SpreadOnFace::across_of(std::size_t column, float row) const {
  return columns_.across[column] + columns_.across_slope[column] * (row - middle_row_);
}

std::size_t SpreadOnFace::nearest(float column) const {
  const float last = static_cast<float>(columns_.b.size()) - 1.0F;
  return static_cast<std::size_t>(std::min(std::max(column, 0.0F), last) + 0.5F);
}

void SpreadOnFace::tabulate_seeing() {
  constexpr int kFixedSteps = 6;
  for (std::size_t column = 0; column < columns_.b.size(); ++column)
    for (int k = 0; k < kParts; ++k) {
      const float part = kLeastPart + static_cast<float>(k) * kPartStep;
      auto from = static_cast<float>(column);
      for (int step = 0; step < kFixedSteps; ++step)
        from = static_cast<float>(column) - part * columns_.along[nearest(from)];
      seeing_.push_back(from);
    }
}

void SpreadOnFace::undo_rows(const cv::Mat& x, bool is_half, Cells* cells) const {
  const BilinearSamples x_at(x), q_at(skirt_.q());
  const float per_step = is_half ? 2.0F : 1.0F;
  for (int row = 0; row < x.rows; ++row) {
    const float on_face = static_cast<float>(row) * per_step + 0.5F * (per_step - 1.0F);
    undo_row({x.cols, per_step, is_half ? 2 * kParts : kParts, on_face, middle_row_, layer_mm_,
              thickness_mm_, static_cast<float>(columns_.b.size()) - 1.0F},
             columns_.along.data(), columns_.across.data(), columns_.across_slope.data(),
             columns_.core.data(), columns_.skirt_shift.data(),
             (is_half ? half_b_ : columns_.b).data(), seeing_.data(), seeing_.data() + 1, x_at,
             q_at, cells->y.ptr<float>(row), cells->seen_x.ptr<float>(row));
  }
}

SpreadOnFace::Cells SpreadOnFace::undo(const cv::Mat& x) {
  cv::Mat half_x;
  cv::resize(x, half_x, skirt_.size(), 0, 0, cv::INTER_AREA);
  Cells half{half_x.clone(), cv::Mat(half_x.size(), CV_32FC1)};
  for (int round = 0; round < kRounds; ++round) {
    undo_rows(half_x, true, &half);
    skirt_.approach(half.seen_x, half.y);
  }
  Cells undone{{}, cv::Mat(x.size(), CV_32FC1)};
  cv::resize(half.y, undone.y, x.size(), 0, 0, cv::INTER_LINEAR);
  for (int round = 0; round < kRoundsOfPath; ++round) undo_rows(x, false, &undone);
  return undone;
}

cv::Mat SpreadOnFace::seen(const cv::Mat& y) {
  cv::Mat x(y.size(), CV_32FC1), depths(y.size(), CV_32FC1);
  for (int row = 0; row < y.rows; ++row)
    for (int column = 0; column < y.cols; ++column)
      depths.at<float>(row, column) =
          depth_on_curve(y.at<float>(row, column), b(column), thickness_mm_) / layer_mm_;
  double deepest = 0;
  cv::minMaxLoc(depths, nullptr, &deepest);
  skirt_.set(y);
  for (int row = 0; row < y.rows; ++row)
    for (int column = 0; column < y.cols; ++column) {
      const auto at = static_cast<std::size_t>(column);
      const auto from_column = static_cast<float>(column), from_row = static_cast<float>(row);
      const float across = across_of(at, from_row);
      const double met = meeting_part(
          [&](double part) {
            const auto along = static_cast<float>(part);
            return static_cast<double>(bilinear_within(
                depths, from_column + along * columns_.along[at], from_row + along * across));
          },
          deepest);
      const double y_met =
          difference_at_depth((1.0 - met) * static_cast<double>(layer_mm_),
                              static_cast<double>(b(column)), static_cast<double>(thickness_mm_));
      const float shift = columns_.skirt_shift[at];
      const float q =
          bilinear_within(skirt_.q(), 0.5F * (from_column + shift * columns_.along[at]) - 0.25F,
                          0.5F * (from_row + shift * across) - 0.25F);
      x.at<float>(row, column) = static_cast<float>(
          seen_difference(y_met, static_cast<double>(q), static_cast<double>(columns_.core[at])));
    }
  return x;
}

}  // namespace alltact
