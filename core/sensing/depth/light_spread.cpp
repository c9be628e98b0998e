#include "core/sensing/depth/light_spread.h"

#include "core/numerics/image_noise.h"
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

double seen_difference(double y, double q, double core) {
  constexpr double kMost = 0.95;  // the core's pole is not reached
  const double limited = std::min(y, kMost);
  return 1.0 - (1.0 - limited) / (1.0 - (1.0 - core) * limited) * (1.0 - q);
}

double skirt_narrowing(double lost_even) {
  constexpr double kLeast = 0.2;
  return std::max(kLeast, 1.0 - 2.3 * lost_even);
}

namespace {

constexpr double kLeastDenominator = 0.1;  // the curves' poles are not reached

/// Depth of an even layer on the curve of thickness rho T, mm.
double depth_on_curve(double y, double b, double thickness_mm) {
  return thickness_mm * (1.0 + b) * y / std::max(kLeastDenominator, 1.0 + b * y);
}

double difference_at_depth(double depth_mm, double b, double thickness_mm) {
  const double full = thickness_mm * (1.0 + b);
  return depth_mm / std::max(kLeastDenominator * full, full - b * depth_mm);
}

/// rho T of a mapping.
double thickness_of(const MappingParameters& mapping) { return mapping.a_mm / (1.0 + mapping.b); }

}  // namespace

double difference_on_curve(double x, double b_here, const MappingParameters& mapping) {
  const double thickness_mm = thickness_of(mapping);
  return difference_at_depth(depth_on_curve(x, b_here, thickness_mm), mapping.b, thickness_mm);
}

namespace {

constexpr double kCellMm = 0.16;
// The rounds raise noise, which is smoothed before. A kernel without variance (twicing) retains
// detail down to about this size.
constexpr double kSmoothMm = 0.4;
constexpr int kRounds = 6;  // twice as many recover no more than they raise of the noise
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
        here[i] = static_cast<float>(1.0 / skirt_narrowing(static_cast<double>(e[i])));
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
  [[nodiscard]] double core(int column) const {
    return static_cast<double>(columns_[index(column)].core);
  }

  /// y of each cell, and the x at the pixel whose core it is; from x by cells.
  struct Undone {
    cv::Mat y, seen_x;
  };
  [[nodiscard]] Undone undo(const cv::Mat& x) {
    Undone undone{x.clone(), cv::Mat(x.size(), CV_32FC1)};
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
    const float b = columns_[index(column)].b;
    return static_cast<float>(depth_on_curve(static_cast<double>(y), static_cast<double>(b),
                                             static_cast<double>(thickness_mm_)) /
                              static_cast<double>(layer_mm_));
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
    return static_cast<float>(seen_difference(static_cast<double>(y), static_cast<double>(q),
                                              static_cast<double>(sight.core)));
  }

  float middle_row_, layer_mm_, thickness_mm_;
  std::vector<Column> columns_;
  SkirtLight skirt_;
  std::vector<float> seeing_;  // column of the pixel that sees a column, by column and part
};

void smooth(const UnrolledFace& face, cv::Mat* cells) {
  cv::Mat once, twice;
  const auto blur = [&](const cv::Mat& from, cv::Mat* to) {
    cv::GaussianBlur(from, *to, {}, kSmoothMm / face.step_along_mm(),
                     kSmoothMm / face.step_across_mm(), cv::BORDER_REPLICATE);
  };
  blur(*cells, &once);
  blur(once, &twice);
  *cells = 2 * once - twice;
}

}  // namespace

void remove_light_spread(const MappingParameters& mapping, const FaceShape& shape,
                         Difference* difference) {
  if (mapping.spread.is_local() || !difference->spread_removed.is_none()) return;
  const UnrolledFace face(shape, kCellMm);
  if (face.is_empty()) return;
  SpreadOnFace spread(face, mapping, shape.face().layer_mm);
  cv::Mat x = difference->x.clone();  // others may hold the same differences
  cv::Mat cells = face.from_pixels(x);
  smooth(face, &cells);
  const auto undone = spread.undo(cells);
  const cv::Mat y = face.to_pixels(undone.y, x.size());
  SpreadRemoved& removed = difference->spread_removed;
  removed.change = face.to_pixels(undone.seen_x, x.size());
  std::vector<double> b;
  for (int u = 0; u < x.cols; ++u) {
    const int column = face.column_of(u);
    b.push_back(spread.b(column));
    // That of the rounds alone: smoothing leaves less in a pixel, but neighbours share it, and
    // means over some pixels retain as much.
    const double core = spread.core(column), left = std::pow(1.0 - core, kRounds);
    const double level_gain = (1.0 + b.back()) / (1.0 + mapping.b);  // of small differences
    removed.noise_gain.push_back(static_cast<float>((1.0 - left) / core * level_gain));
    removed.level_gain.push_back(static_cast<float>(level_gain));
  }
  for (int v = 0; v < x.rows; ++v)
    for (int u = 0; u < x.cols; ++u) {
      float& here = x.at<float>(v, u);
      float& change = removed.change.at<float>(v, u);
      const double after = difference_on_curve(static_cast<double>(y.at<float>(v, u)),
                                               b[static_cast<std::size_t>(u)], mapping);
      change = static_cast<float>(after) - change;
      if (std::isfinite(here)) here = static_cast<float>(after);
    }
  difference->x = x;
}

std::complex<double> wave_after_removal(const LightSpread& spread, double layer_mm,
                                        const Eigen::Vector2d& displacement_mm, double cos_sight,
                                        const Eigen::Vector2d& wave_per_mm) {
  if (spread.is_local()) return 1.0;
  const auto [core, shift, b_factor] = oblique_spread(spread, cos_sight);
  const double wave2 = wave_per_mm.squaredNorm(), width_mm = skirt_width_mm(spread, layer_mm);
  const double path = wave_per_mm.dot(displacement_mm);  // phase from a pixel to the skin it shows
  // Of a cell, at the pixel that sees it.
  const auto shown_with = [&, shift = shift](double core_part) {
    const double skirt = (1.0 - core_part) / (1.0 + wave2 * width_mm * width_mm);
    return core_part + skirt * std::polar(1.0, (shift - 1.0) * path);
  };
  // The formula's core is that of deep indentations; shallow ones have less.
  const double shallow =
      std::exp(-0.8 * spread.optical_thickness * (1.0 + 0.28 * longer_path(cos_sight)));
  const std::complex<double> removed = shown_with(core), shown = shown_with(shallow);
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
