#include "core/sensing/depth/light_spread.h"

#include "core/numerics/median.h"
#include "core/sensing/depth/spread_on_face.h"
#include "core/sensing/depth/unrolled_face.h"

#include <algorithm>
#include <array>
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
  const double limited = std::min(y, 0.95);  // the core's pole is not reached
  return 1.0 - (1.0 - limited) / (1.0 - (1.0 - core) * limited) * (1.0 - q);
}

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
// Removal raises noise, which is smoothed before. A kernel without variance (twicing) retains
// detail down to about this size.
constexpr double kSmoothMm = 0.25;

/// Mean of squares that are noise but for a small part.
double square_of_noise(const cv::Mat& squares) {
  constexpr double kMeanOfMedian = 2.198;  // of squares of a normal distribution
  std::vector<float> values;
  for (int j = 0; j < squares.rows; j += 4)
    for (int i = 0; i < squares.cols; i += 8) values.push_back(squares.at<float>(j, i));
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
  for (int j = 2 * kApart; j < cells.rows; j += 4)
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
                   double layer_mm, const cv::Size& margin, SpreadOnFace::Cells* all) {
  const UnrolledFace of_part = face.part(part);
  const auto undone = SpreadOnFace(of_part, mapping, layer_mm, SpreadOnFace::Core::kForRemoval)
                          .undo(all->y(part).clone());
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
  SpreadOnFace::Cells cells{face.from_pixels(difference->x, &measured), {}};
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
    // That of the core alone: smoothing leaves less in a pixel, but neighbours share it, and
    // means over some pixels retain as much.
    const double level = (1.0 + b_here) / (1.0 + mapping.b);  // of small differences
    b.push_back(static_cast<float>(b_here));
    noise_gain.push_back(static_cast<float>(level / core_for_removal(core)));
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
  const cv::Mat before = difference->x;  // others may hold the same differences
  const std::vector<cv::Mat> pixels =
      face.to_pixels(std::array{cells.y, cells.seen_x, too_fine}, before.size());
  difference->x = pixels[0], removed.sd = pixels[1], removed.lost_mm = pixels[2];
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
  const std::complex<double> removed = shown_with(core_for_removal(core), 1.0),
                             shown = shown_with(shallow, core_gain);
  const double once = std::exp(-0.5 * wave2 * kSmoothMm * kSmoothMm),
               smoothed = once * (2.0 - once);
  return smoothed * shown / removed;
}

cv::Mat with_light_spread(const cv::Mat& y, const MappingParameters& mapping,
                          const FaceShape& shape) {
  if (mapping.spread.is_local()) return y;
  const UnrolledFace face(shape, kCellMm);
  if (face.is_empty()) return y;
  SpreadOnFace spread(face, mapping, shape.face().layer_mm, SpreadOnFace::Core::kOfLight);
  cv::Mat single, seen;
  y.convertTo(single, CV_32F);
  cv::Mat cells = face.from_pixels(single);
  for (int row = 0; row < cells.rows; ++row)
    for (int column = 0; column < cells.cols; ++column) {
      float& here = cells.at<float>(row, column);
      const double depth_mm =
          depth_on_curve(static_cast<double>(here), mapping.b, thickness_of(mapping));
      here = static_cast<float>(difference_at_depth(depth_mm, static_cast<double>(spread.b(column)),
                                                    thickness_of(mapping)));
    }
  face.to_pixels(std::array{spread.seen(cells)}, y.size()).front().convertTo(seen, CV_64F);
  return seen;
}

}  // namespace alltact
