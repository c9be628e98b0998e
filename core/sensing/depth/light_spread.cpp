#include "core/sensing/depth/light_spread.h"

#include "core/numerics/image_noise.h"
#include "core/numerics/median.h"
#include "core/sensing/depth/unrolled_face.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace alltact {

namespace {

/// 1 / cos - 1 of the angle of sight.
double longer_path(double cos_sight) {
  constexpr double kMinCos = 0.3;
  return 1.0 / std::clamp(cos_sight, kMinCos, 1.0) - 1.0;
}

}  // namespace

ObliqueSpread oblique_spread(const LightSpread& spread, double cos_sight) {
  const double t = spread.optical_thickness, longer = longer_path(cos_sight);
  return {std::exp(-0.74 * std::pow(t, 0.78) * (1.0 + 0.28 * longer)), 0.43 - 0.066 * t,
          std::exp(0.8 * t * std::exp(-0.35 * t) * longer)};
}

double b_at(const LightSpread& spread, double along_mm, double cos_sight) {
  const double unit = std::clamp((along_mm - spread.middle_mm) / spread.half_mm, -1.0, 1.0);
  const double b = (1.0 + spread.b_straight) * oblique_spread(spread, cos_sight).b_factor - 1.0;
  return b * std::exp(spread.log_b_along * unit);
}

double skirt_width_mm(const LightSpread& spread, double layer_mm) {
  constexpr double kMaxLayers = 3.0;
  return layer_mm *
         std::min(kMaxLayers, spread.width_factor * 0.8 /
                                  std::pow(std::max(spread.optical_thickness, 1e-6), 0.4));
}

namespace {

// In single precision for every frame's cells, in double precision for fits.

template <class Real>
Real seen(Real y, Real q, Real core) {
  const Real limited = std::min(y, Real(0.95));  // the core's pole is not reached
  return 1 - (1 - limited) / (1 - (1 - core) * limited) * (1 - q);
}

constexpr double kLeastDenominator = 0.1;  // the curves' poles are not reached

/// Depth of an even layer on the curve of thickness rho T, mm.
template <class Real>
Real depth_on_curve(Real y, Real b, Real thickness_mm) {
  return thickness_mm * (1 + b) * y / std::max(Real(kLeastDenominator), 1 + b * y);
}

/// Its slope.
template <class Real>
Real depth_per_difference(Real y, Real b, Real thickness_mm) {
  const Real denominator = std::max(Real(kLeastDenominator), 1 + b * y);
  return thickness_mm * (1 + b) / (denominator * denominator);
}

template <class Real>
Real difference_at_depth(Real depth_mm, Real b, Real thickness_mm) {
  const Real full = thickness_mm * (1 + b);
  return depth_mm / std::max(Real(kLeastDenominator) * full, full - b * depth_mm);
}

/// rho T of a mapping.
double thickness_of(const MappingParameters& mapping) { return mapping.a_mm / (1.0 + mapping.b); }

}  // namespace

double seen_difference(double y, double q, double core) { return seen(y, q, core); }

double skirt_narrowing(double lost_even) {
  constexpr double kLeast = 0.2;
  return std::max(kLeast, 1.0 - 2.3 * lost_even);
}

double difference_on_curve(double x, double b_here, const MappingParameters& mapping) {
  const double thickness_mm = thickness_of(mapping);
  return difference_at_depth(depth_on_curve(x, b_here, thickness_mm), mapping.b, thickness_mm);
}

namespace {

constexpr double kCellMm = 0.16;
// The rounds raise noise, which is smoothed before. A kernel without variance (twicing) retains
// detail down to about this size.
constexpr double kSmoothMm = 0.25;
constexpr int kRounds = 8;  // more recover no more than they raise of the noise
constexpr int kRoundsFromNothing = 40;

/// The skirt's light on a face: q, on a grid of half as many rows and columns.
class SkirtLight {
 public:
  /// `core`: of the columns of the face's grid.
  SkirtLight(const UnrolledFace& face, double width_mm, const std::vector<float>& core)
      : size_(face.size() / 2), q_(size_, CV_32FC1, cv::Scalar(0.0)) {
    const double along_mm = face.size().width * face.step_along_mm(),
                 across_mm = face.size().height * face.step_across_mm();
    bending_.create(size_, CV_32FC1);
    for (int j = 0; j < size_.height; ++j)
      for (int i = 0; i < size_.width; ++i) {
        const double k = M_PI * width_mm * std::hypot(i / along_mm, j / across_mm);
        bending_.at<float>(j, i) = static_cast<float>(k * k);
      }
    for (int i = 0; i < size_.width; ++i)
      around_.push_back(1.0F - core[2 * static_cast<std::size_t>(i)]);
  }

  /// Steps towards the q of cells that would show y on even layers: r q - width^2 laplace q = r e.
  /// The middle of all r is solved for at once, so that it converges.
  void approach(const cv::Mat& y, int steps) {
    cv::Mat even, r(size_, CV_32FC1);
    cv::resize(y, even, size_, 0, 0, cv::INTER_AREA);
    for (int j = 0; j < size_.height; ++j) {
      float *e = even.ptr<float>(j), *here = r.ptr<float>(j);
      for (int i = 0; i < size_.width; ++i) {
        e[i] = around_[static_cast<std::size_t>(i)] * std::clamp(e[i], kLeast, kMost);
        here[i] = 1.0F / static_cast<float>(skirt_narrowing(static_cast<double>(e[i])));
      }
    }
    double least = 0, most = 0;
    cv::minMaxLoc(r, &least, &most);
    const double middle = 0.5 * (least + most);
    const cv::Mat sources = r.mul(even), rest = r - middle;
    for (int step = 0; step < steps; ++step) {
      q_ = sources - rest.mul(q_);
      cv::dct(q_, q_);
      cv::divide(q_, bending_ + middle, q_);
      cv::dct(q_, q_, cv::DCT_INVERSE);
    }
  }
  /// At a position on the face's grid.
  [[nodiscard]] float at(float column, float row) const {
    return bilinear_within(q_, 0.5F * column - 0.25F, 0.5F * row - 0.25F);
  }

 private:
  static constexpr float kLeast = -0.5F, kMost = 0.95F;  // of y

  cv::Size size_;
  cv::Mat q_, bending_;  // width^2 times the square of a wave's number, by the transform's waves
  std::vector<float> around_;  // 1 - core, by columns
};

/// y of each cell, and the x at the pixel whose core it is.
struct Cells {
  cv::Mat y, seen_x;
};

/// What spread light makes of a face, and back. In single precision, as it is done for every frame.
class SpreadOnFace {
 public:
  SpreadOnFace(const UnrolledFace& face, const MappingParameters& mapping, double layer_mm)
      : middle_row_(static_cast<float>(face.middle_row())),
        layer_mm_(static_cast<float>(layer_mm)),
        thickness_mm_(static_cast<float>(thickness_of(mapping))),
        columns_(columns_of(face, mapping)),
        skirt_(face, skirt_width_mm(mapping.spread, layer_mm), cores_of(columns_)) {
    tabulate_seeing();
  }

  [[nodiscard]] double b(int column) const {
    return static_cast<double>(columns_[index(column)].b);
  }

  /// From x by cells.
  [[nodiscard]] Cells undo(const cv::Mat& x) {
    Cells undone{x.clone(), cv::Mat(x.size(), CV_32FC1)};
    cv::Mat next(x.size(), CV_32FC1);
    skirt_.approach(x, 3);
    for (int round = 0; round < kRounds; ++round) {
      if (round > 0) skirt_.approach(undone.y, 1);
      for (int row = 0; row < x.rows; ++row) {
        const float* y = undone.y.ptr<float>(row);
        float *seen_x = undone.seen_x.ptr<float>(row), *y_next = next.ptr<float>(row);
        for (int column = 0; column < x.cols; ++column) {
          const Pixel pixel = pixel_that_sees(column, row, 1.0F - depth_part(y[column], column));
          seen_x[column] = bilinear_within(x, pixel.column, pixel.row);
          y_next[column] = y[column] + seen_x[column] - seen(y[column], pixel);
        }
      }
      cv::swap(undone.y, next);
    }
    return undone;
  }

  /// x by cells, of y by cells.
  [[nodiscard]] cv::Mat seen(const cv::Mat& y) {
    cv::Mat x(y.size(), CV_32FC1), depths(y.size(), CV_32FC1);
    for (int row = 0; row < y.rows; ++row)
      for (int column = 0; column < y.cols; ++column)
        depths.at<float>(row, column) = depth_part(y.at<float>(row, column), column);
    double deepest = 0;
    cv::minMaxLoc(depths, nullptr, &deepest);
    skirt_.approach(y, kRoundsFromNothing);
    for (int row = 0; row < y.rows; ++row)
      for (int column = 0; column < y.cols; ++column) {
        const Column& here = columns_[index(column)];
        const float across = across_of(here, static_cast<float>(row));
        const double met = meeting_part(
            [&](double part) {
              const auto along = static_cast<float>(part);
              return static_cast<double>(
                  bilinear_within(depths, static_cast<float>(column) + along * here.along,
                                  static_cast<float>(row) + along * across));
            },
            deepest);
        const double y_met = difference_at_depth((1.0 - met) * static_cast<double>(layer_mm_),
                                                 b(column), static_cast<double>(thickness_mm_));
        x.at<float>(row, column) =
            seen(static_cast<float>(y_met),
                 {static_cast<float>(column), static_cast<float>(row), &here});
      }
    return x;
  }

 private:
  static constexpr int kParts = 24;  // of the table of pixels that see
  static constexpr float kLeastPart = 0.2F, kPartStep = 0.04F;

  /// A column of cells: displacement of its lines of sight through the layer, in cells
  /// (UnrolledFace::Sight), and their spread.
  struct Column {
    float along, across, across_slope;
    float core, skirt_shift;
    float b;
  };
  /// A pixel by its position on the grid, with the nearest column.
  struct Pixel {
    float column, row;
    const Column* at;
  };

  static std::vector<Column> columns_of(const UnrolledFace& face,
                                        const MappingParameters& mapping) {
    std::vector<Column> columns;
    for (int i = 0; i < face.size().width; ++i) {
      const UnrolledFace::Sight& sight = face.sight(i);
      const ObliqueSpread oblique = oblique_spread(mapping.spread, sight.cos_sight);
      columns.push_back(
          {static_cast<float>(sight.along), static_cast<float>(sight.across),
           static_cast<float>(sight.across_slope), static_cast<float>(oblique.core),
           static_cast<float>(oblique.skirt_shift),
           static_cast<float>(b_at(mapping.spread, face.along_mm(i), sight.cos_sight))});
    }
    return columns;
  }
  static std::vector<float> cores_of(const std::vector<Column>& columns) {
    std::vector<float> cores;
    for (const Column& column : columns) cores.push_back(column.core);
    return cores;
  }

  static std::size_t index(int column) { return static_cast<std::size_t>(column); }
  [[nodiscard]] float across_of(const Column& column, float row) const {
    return column.across + column.across_slope * (row - middle_row_);
  }
  /// Depth as a part of the layer.
  [[nodiscard]] float depth_part(float y, int column) const {
    return depth_on_curve(y, columns_[index(column)].b, thickness_mm_) / layer_mm_;
  }
  [[nodiscard]] const Column& nearest(float column) const {
    const float last = static_cast<float>(columns_.size()) - 1.0F;
    return columns_[static_cast<std::size_t>(std::min(std::max(column, 0.0F), last) + 0.5F)];
  }

  void tabulate_seeing() {
    constexpr int kFixedSteps = 6;
    const int columns = static_cast<int>(columns_.size());
    for (int column = 0; column < columns; ++column)
      for (int k = 0; k < kParts; ++k) {
        const float part = kLeastPart + static_cast<float>(k) * kPartStep;
        auto from = static_cast<float>(column);
        for (int step = 0; step < kFixedSteps; ++step)
          from = static_cast<float>(column) - part * nearest(from).along;
        seeing_.push_back(from);
      }
  }

  /// The pixel whose line of sight is above a cell after this part of its path through the layer.
  [[nodiscard]] Pixel pixel_that_sees(int column, int row, float part) const {
    constexpr float kLast = kLeastPart + (static_cast<float>(kParts) - 1.001F) * kPartStep;
    const float limited = std::min(std::max(part, kLeastPart), kLast);
    const float at = (limited - kLeastPart) / kPartStep;
    const int k = static_cast<int>(at);
    const float* table = &seeing_[index(column) * kParts + index(k)];
    const float seen_from = table[0] + (at - static_cast<float>(k)) * (table[1] - table[0]);
    const Column& sight = nearest(seen_from);
    return {seen_from,
            middle_row_ + (static_cast<float>(row) - middle_row_ - limited * sight.across) /
                              (1.0F + limited * sight.across_slope),
            &sight};
  }
  /// x of a pixel whose core shows y.
  [[nodiscard]] float seen(float y, const Pixel& pixel) const {
    const Column& sight = *pixel.at;
    const float q = skirt_.at(pixel.column + sight.skirt_shift * sight.along,
                              pixel.row + sight.skirt_shift * across_of(sight, pixel.row));
    return alltact::seen(y, q, sight.core);
  }

  float middle_row_, layer_mm_, thickness_mm_;
  std::vector<Column> columns_;
  SkirtLight skirt_;
  std::vector<float> seeing_;  // column of the pixel that sees a column, by column and part
};

/// Mean of squares that are noise but for a small part.
double square_of_noise(const cv::Mat& squares) {
  constexpr double kMeanOfMedian = 2.198;  // of squares of a normal distribution
  std::vector<float> values;
  for (int j = 0; j < squares.rows; j += 2)
    for (int i = 0; i < squares.cols; i += 4) values.push_back(squares.at<float>(j, i));
  return values.empty() ? 0.0 : kMeanOfMedian * static_cast<double>(upper_median(values));
}

/// Smooths the cells; returns the sd of what is too fine for that, 0 within noise. The next order
/// of the kernel, once - 2 twice + thrice, shows how much detail there is at its size. Pins of 1
/// mm, threads and sharp edges lose about kLost times as much.
cv::Mat smooth(const UnrolledFace& face, cv::Mat* cells) {
  constexpr double kLost = 4.5;
  cv::Mat once, twice, thrice;
  const auto blur = [&](const cv::Mat& from, cv::Mat* to) {
    cv::GaussianBlur(from, *to, {}, kSmoothMm / face.step_along_mm(),
                     kSmoothMm / face.step_across_mm(), cv::BORDER_REPLICATE);
  };
  blur(*cells, &once);
  blur(once, &twice);
  blur(twice, &thrice);
  *cells = 2 * once - twice;
  cv::Mat detail = once - 2 * twice + thrice;
  cv::multiply(detail, detail, detail);
  const double noise_square = square_of_noise(detail);
  blur(detail, &detail);
  cv::max(detail - noise_square, 0.0, detail);
  cv::sqrt(detail, detail);
  return kLost * detail;
}

// Where nothing has changed, there is no spread light to remove. Searched for in blocks of cells.

constexpr int kSearchBlock = 8;

/// Noise of smoothed cells from column `first` on: second differences over more than the smoothing,
/// without the few that contacts enlarge.
float noise_of(const cv::Mat& cells, int first, int columns) {
  constexpr int kApart = 8;
  std::vector<float> bends;
  for (int j = 2 * kApart; j < cells.rows; j += 2)
    for (int i = first; i < std::min(first + columns, cells.cols); i += 4)
      bends.push_back(std::abs(cells.at<float>(j, i) - 2 * cells.at<float>(j - kApart, i) +
                               cells.at<float>(j - 2 * kApart, i)));
  constexpr float kMedianToSd = 1.4826F;
  return bends.empty() ? 0.0F : kMedianToSd * upper_median(bends) / std::sqrt(6.0F);
}

/// 255 for blocks in which smoothed differences exceed noise. `measured`: as
/// UnrolledFace::from_pixels; next to other cells noise is larger.
cv::Mat changed_blocks(const cv::Mat& cells, const cv::Mat& measured) {
  // Below the least nothing shows that removal could sharpen; above the most no noise is.
  constexpr float kLeast = 0.004F, kMost = 0.02F, kNoises = 5.0F;
  constexpr int kColumns = 4 * kSearchBlock;
  cv::Mat inside;
  cv::erode(measured, inside, cv::Mat::ones(7, 7, CV_8UC1), {-1, -1}, 1, cv::BORDER_CONSTANT,
            cv::Scalar(0));
  cv::Mat blocks = cv::Mat::zeros((cells.rows + kSearchBlock - 1) / kSearchBlock,
                                  (cells.cols + kSearchBlock - 1) / kSearchBlock, CV_8UC1);
  for (int first = 0; first < cells.cols; first += kColumns) {
    const float limit = std::clamp(kNoises * noise_of(cells, first, kColumns), kLeast, kMost);
    for (int j = 0; j < cells.rows; ++j) {
      const auto* is_inside = inside.ptr<std::uint8_t>(j);
      const float* row = cells.ptr<float>(j);
      auto* of_blocks = blocks.ptr<std::uint8_t>(j / kSearchBlock);
      for (int i = first; i < std::min(first + kColumns, cells.cols); ++i)
        if (std::abs(row[i]) > limit && is_inside[i] != 0) of_blocks[i / kSearchBlock] = 255;
    }
  }
  return blocks;
}

/// Cells `first` to `end` and more around them, of `all`: an even number that transforms quickly.
cv::Range quick_range(int first, int end, int all) {
  const int size = std::min(all, 4 * cv::getOptimalDFTSize((end - first + 3) / 4));
  const int from = std::clamp(first - (size - (end - first)) / 2, 0, all - size);
  return {from - from % 2, from - from % 2 + size};
}

/// Disjoint parts of the face with everything that changed and this many cells around it.
std::vector<cv::Rect> changed_parts(const cv::Mat& cells, const cv::Mat& measured,
                                    const cv::Size& margin) {
  cv::Mat around, labels, boxes, middles;
  const cv::Size reach(margin.width / kSearchBlock + 1, margin.height / kSearchBlock + 1);
  cv::dilate(changed_blocks(cells, measured), around,
             cv::Mat::ones(2 * reach.height + 1, 2 * reach.width + 1, CV_8UC1));
  const int count = cv::connectedComponentsWithStats(around, labels, boxes, middles);
  std::vector<cv::Rect> parts;
  for (int i = 1; i < count; ++i) {
    const auto* box = boxes.ptr<int>(i);
    const int left = kSearchBlock * box[cv::CC_STAT_LEFT],
              top = kSearchBlock * box[cv::CC_STAT_TOP];
    const cv::Range columns = quick_range(
        left, std::min(cells.cols, left + kSearchBlock * box[cv::CC_STAT_WIDTH]), cells.cols);
    const cv::Range rows = quick_range(
        top, std::min(cells.rows, top + kSearchBlock * box[cv::CC_STAT_HEIGHT]), cells.rows);
    cv::Rect part(columns.start, rows.start, columns.size(), rows.size());
    for (std::size_t k = 0; k < parts.size();) {
      if ((parts[k] & part).empty()) {
        ++k;
        continue;
      }
      const cv::Rect both = parts[k] | part;
      const cv::Range wide = quick_range(both.x, both.x + both.width, cells.cols),
                      high = quick_range(both.y, both.y + both.height, cells.rows);
      part = {wide.start, high.start, wide.size(), high.size()};
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
      k = 0;  // it has grown
    }
    parts.push_back(part);
  }
  return parts;
}

/// From 0 at a border between cells to 1 at `over` cells within it.
float weight_within(int cell, const cv::Range& part, int all, int over) {
  const int from_first = part.start == 0 ? over : cell - part.start,
            from_last = part.end == all ? over : part.end - 1 - cell;
  const float unit = std::min(
      1.0F, static_cast<float>(std::min(from_first, from_last)) / static_cast<float>(over));
  return unit * unit * (3 - 2 * unit);
}

/// Removes spread light from `part` and blends the result into `all`.
void remove_within(const cv::Rect& part, const UnrolledFace& face, const MappingParameters& mapping,
                   double layer_mm, const cv::Size& margin, Cells* all) {
  const UnrolledFace of_part = face.part(part);
  const auto undone = SpreadOnFace(of_part, mapping, layer_mm).undo(all->y(part).clone());
  const cv::Range columns(part.x, part.x + part.width), rows(part.y, part.y + part.height);
  std::vector<float> along;
  for (int i = columns.start; i < columns.end; ++i)
    along.push_back(weight_within(i, columns, face.size().width, margin.width / 3 + 1));
  for (int j = 0; j < part.height; ++j) {
    const float across = weight_within(part.y + j, rows, face.size().height, margin.height / 3 + 1);
    float *y = all->y.ptr<float>(part.y + j) + part.x,
          *seen_x = all->seen_x.ptr<float>(part.y + j) + part.x;
    const float *y_undone = undone.y.ptr<float>(j), *seen_undone = undone.seen_x.ptr<float>(j);
    for (int i = 0; i < part.width; ++i) {
      const float weight = across * along[static_cast<std::size_t>(i)];
      y[i] += weight * (y_undone[i] - y[i]);
      seen_x[i] += weight * (seen_undone[i] - seen_x[i]);
    }
  }
}

/// Cells around what changed beyond which spread light is nothing.
cv::Size margin_of(const UnrolledFace& face, double skirt_mm) {
  constexpr double kSkirts = 3.0;
  double along = 0, across = 0;
  for (int i = 0; i < face.size().width; ++i) {
    const UnrolledFace::Sight& sight = face.sight(i);
    along = std::max(along, std::abs(sight.along));
    across = std::max(
        across, std::abs(sight.across) + std::abs(sight.across_slope) * 0.5 * face.size().height);
  }
  return {static_cast<int>(std::ceil(kSkirts * skirt_mm / face.step_along_mm() + along)),
          static_cast<int>(std::ceil(kSkirts * skirt_mm / face.step_across_mm() + across))};
}

/// The change by the removal of spread light grows as 1 / core - 1: its relative growth per optical
/// thickness.
double growth(const LightSpread& spread) {
  constexpr double kPart = 0.01;
  LightSpread more = spread;
  more.optical_thickness *= 1.0 + kPart;
  const double here = 1.0 / oblique_spread(spread, 1.0).core - 1.0,
               there = 1.0 / oblique_spread(more, 1.0).core - 1.0;
  return (there - here) / (here * kPart * spread.optical_thickness);
}

}  // namespace

void remove_light_spread(const MappingParameters& mapping, const FaceShape& shape,
                         Difference* difference) {
  if (mapping.spread.is_local() || !difference->spread_removed.is_none()) return;
  const UnrolledFace face(shape, kCellMm);
  if (face.is_empty()) return;
  const double layer_mm = shape.face().layer_mm;
  cv::Mat measured;
  Cells cells{face.from_pixels(difference->x, &measured), {}};
  cv::Mat too_fine = smooth(face, &cells.y);
  cells.seen_x = cells.y.clone();
  const cv::Size margin = margin_of(face, skirt_width_mm(mapping.spread, layer_mm));
  for (const cv::Rect& part : changed_parts(cells.y, measured, margin))
    remove_within(part, face, mapping, layer_mm, margin, &cells);

  std::vector<float> b, noise_gain, level_gain, per_core;  // by column of cells
  for (int i = 0; i < face.size().width; ++i) {
    const double cos_sight = face.sight(i).cos_sight,
                 core = oblique_spread(mapping.spread, cos_sight).core;
    const double b_here = b_at(mapping.spread, face.along_mm(i), cos_sight);
    // That of the rounds alone: smoothing leaves less in a pixel, but neighbours share it, and
    // means over some pixels retain as much.
    const double left = std::pow(1.0 - core, kRounds);
    const double level = (1.0 + b_here) / (1.0 + mapping.b);  // of small differences
    b.push_back(static_cast<float>(b_here));
    noise_gain.push_back(static_cast<float>((1.0 - left) / core * level));
    level_gain.push_back(static_cast<float>(level));
    per_core.push_back(static_cast<float>(1.0 / core));
  }
  const auto b_of_curve = static_cast<float>(mapping.b),
             thickness_mm = static_cast<float>(thickness_of(mapping));
  const double per_change = growth(mapping.spread) * mapping.spread.optical_thickness_sd;
  for (int j = 0; j < cells.y.rows; ++j) {
    float *y = cells.y.ptr<float>(j), *seen_x = cells.seen_x.ptr<float>(j);
    auto* fine = too_fine.ptr<float>(j);
    for (std::size_t i = 0; i < b.size(); ++i) {
      fine[i] *= per_core[i] * depth_per_difference(y[i], b[i], thickness_mm);  // now mm
      y[i] =
          difference_at_depth(depth_on_curve(y[i], b[i], thickness_mm), b_of_curve, thickness_mm);
      seen_x[i] = static_cast<float>(per_change) * std::abs(y[i] - seen_x[i]);  // now its sd
    }
  }
  SpreadRemoved& removed = difference->spread_removed;
  for (int u = 0; u < difference->x.cols; ++u) {
    const auto column = static_cast<std::size_t>(face.column_of(u));
    removed.noise_gain.push_back(noise_gain[column]);
    removed.level_gain.push_back(level_gain[column]);
  }
  removed.sd = face.to_pixels(cells.seen_x, difference->x.size());
  removed.lost_mm = face.to_pixels(too_fine, difference->x.size());
  const cv::Mat before = difference->x;  // others may hold the same differences
  difference->x = face.to_pixels(cells.y, before.size());
  for (int v = 0; v < before.rows; ++v) {
    const float* x = before.ptr<float>(v);
    float* after = difference->x.ptr<float>(v);
    for (int u = 0; u < before.cols; ++u)
      if (!std::isfinite(x[u])) after[u] = x[u];
  }
}

std::complex<double> wave_after_removal(const LightSpread& spread, double layer_mm,
                                        const Eigen::Vector2d& displacement_mm, double cos_sight,
                                        const Eigen::Vector2d& wave_per_mm) {
  if (spread.is_local()) return 1.0;
  const auto [core, shift, b_factor] = oblique_spread(spread, cos_sight);
  const double wave2 = wave_per_mm.squaredNorm(), width_mm = skirt_width_mm(spread, layer_mm);
  const double path = wave_per_mm.dot(displacement_mm);  // phase from a pixel to the skin it shows
  // Of a cell, at the pixel that sees it.
  const auto shown_with = [&, shift = shift](double core_part, double core_gain) {
    const double skirt = (1.0 - core_part) / (1.0 + wave2 * width_mm * width_mm);
    return core_part * core_gain + skirt * std::polar(1.0, (shift - 1.0) * path);
  };
  // The formula's core is that of deep indentations; shallow ones have less. And it is no point:
  // some of its light was scattered twice near the skin.
  constexpr double kCoreSd = 0.06;  // layers, from walks through layers
  const double shallow =
      std::exp(-0.8 * spread.optical_thickness * (1.0 + 0.28 * longer_path(cos_sight)));
  const double core_gain = std::exp(-0.5 * wave2 * kCoreSd * kCoreSd * layer_mm * layer_mm);
  const std::complex<double> removed = shown_with(core, 1.0),
                             shown = shown_with(shallow, core_gain);
  const double once = std::exp(-0.5 * wave2 * kSmoothMm * kSmoothMm),
               smoothed = once * (2.0 - once);
  // The first guess is what is seen; each round leaves 1 - removed of what is missing.
  std::complex<double> left = 1.0;
  for (int round = 0; round < kRounds; ++round) left *= 1.0 - removed;
  const std::complex<double> start = std::polar(1.0, path);
  return smoothed * shown * ((1.0 - left) / removed + left * start);
}

cv::Mat with_light_spread(const cv::Mat& y, const MappingParameters& mapping,
                          const FaceShape& shape) {
  if (mapping.spread.is_local()) return y;
  const UnrolledFace face(shape, kCellMm);
  if (face.is_empty()) return y;
  SpreadOnFace spread(face, mapping, shape.face().layer_mm);
  cv::Mat single, seen;
  y.convertTo(single, CV_32F);
  cv::Mat cells = face.from_pixels(single);
  for (int row = 0; row < cells.rows; ++row)
    for (int column = 0; column < cells.cols; ++column) {
      float& here = cells.at<float>(row, column);
      const double depth_mm =
          depth_on_curve(static_cast<double>(here), mapping.b, thickness_of(mapping));
      here = static_cast<float>(
          difference_at_depth(depth_mm, spread.b(column), thickness_of(mapping)));
    }
  face.to_pixels(spread.seen(cells), y.size()).convertTo(seen, CV_64F);
  return seen;
}

}  // namespace alltact
