#include "core/sensing/depth/light_spread.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
  const double t = spread.scattering, longer = longer_path(cos_sight);
  return {std::exp(-t * (1.0 + 0.2 * longer)), 0.85, 0.48 - 0.04 * t * t - 0.08 * t * longer,
          1.0 + 1.1 * longer};
}

double b_at(const LightSpread& spread, double along_mm, double cos_sight) {
  const double unit = std::clamp((along_mm - spread.middle_mm) / spread.half_mm, -1.0, 1.0);
  return spread.b_straight * oblique_spread(spread, cos_sight).b_factor *
         std::exp(spread.log_b_along * unit);
}

double skirt_width_mm(const LightSpread& spread, double layer_mm) {
  constexpr double kMaxLayers = 3.0;
  return layer_mm * std::min(kMaxLayers, spread.width_factor * 0.6 /
                                             std::sqrt(std::max(spread.scattering, 1e-6)));
}

std::optional<SightInLayer> sight_in_layer(const FaceShape& shape, double u, double v) {
  const auto here = shape.at(u, v), neighbour = shape.at(u, v + 1.0);
  const auto ray = shape.camera().unproject({u, v});
  if (!here || !neighbour || !ray) return std::nullopt;
  const Eigen::Vector3d& normal = here->normal;
  const double depth = ray->direction.dot(normal);
  if (!(depth > 0.0)) return std::nullopt;
  Eigen::Vector3d across = neighbour->view_point_mm - here->view_point_mm;
  across = (across - across.dot(normal) * normal).normalized();
  Eigen::Vector3d along = across.cross(normal);  // towards large u or small u
  if ((along.x() > 0.0) != shape.base_at_low_u()) along = -along;
  const Eigen::Vector3d crossing = shape.face().layer_mm / depth * ray->direction;
  return SightInLayer{{crossing.dot(along), crossing.dot(across)}, depth / ray->direction.norm()};
}

double difference_on_curve(double x, double b_here, const MappingParameters& mapping) {
  constexpr double kLeast = 0.1;  // of denominators: the curves' poles are not reached
  const double thickness_mm = mapping.a_mm / (1.0 + mapping.b);
  const double depth_mm = thickness_mm * (1.0 + b_here) * x / std::max(kLeast, 1.0 + b_here * x);
  return depth_mm / std::max(kLeast * mapping.a_mm, mapping.a_mm - mapping.b * depth_mm);
}

namespace {

constexpr double kCellMm = 0.1;
// The rounds raise noise, which is smoothed before. A kernel without variance (twicing) retains
// detail down to about this size.
constexpr double kSmoothMm = 0.4;
constexpr int kRounds = 5;
constexpr int kMinCells = 8;

/// The face unrolled into a grid of cells, rows across and columns along, and where cells and
/// pixels see each other.
class UnrolledFace {
 public:
  UnrolledFace(const MappingParameters& mapping, const FaceShape& shape) : shape_(shape) {
    tabulate_columns();
    if (is_empty()) return;
    make_grid();
    look_along_sight(mapping.spread);
    const double width_mm = skirt_width_mm(mapping.spread, shape.face().layer_mm);
    transfer_ = transfer_of(width_mm);
  }

  [[nodiscard]] bool is_empty() const { return s_.size() < 2 || !(s_.back() > s_.front()); }

  /// y where the core of each cell is seen; undefined where the face is not measured at all.
  [[nodiscard]] cv::Mat moved_to_core(const cv::Mat& x) const {
    cv::Mat moved;
    cv::remap(x, moved, core_u_, core_v_, cv::INTER_LINEAR, cv::BORDER_CONSTANT,
              cv::Scalar(std::numeric_limits<double>::quiet_NaN()));
    fill_unmeasured(moved);
    cv::Mat once, twice;
    smooth(moved, &once);
    smooth(once, &twice);
    moved = 2 * once - twice;
    return moved;
  }
  [[nodiscard]] cv::Mat without_skirt(const cv::Mat& moved) const {
    cv::Mat y = moved.clone();
    for (int round = 0; round < kRounds; ++round) {
      const cv::Mat skirt = skirt_of(y);
      for (int row = 0; row < y.rows; ++row) {
        const float* before = moved.ptr<float>(row);
        const float* around = skirt.ptr<float>(row);
        float* here = y.ptr<float>(row);
        for (int i = 0; i < y.cols; ++i)
          here[i] = before[i] + skirt_part_[static_cast<std::size_t>(i)] * (here[i] - around[i]);
      }
    }
    return y;
  }
  /// Cells looked up at the pixels.
  [[nodiscard]] cv::Mat at_pixels(const cv::Mat& cells, const cv::Size& size) const {
    return looked_up(cells, size, 0.0);
  }
  /// What every pixel shows of a face with differences y, each on the mapping's curve.
  [[nodiscard]] cv::Mat seen_by_pixels(const cv::Mat& y, const MappingParameters& mapping) const;

  struct AtColumn {
    double noise_gain = 1, b = 0;
  };
  /// At an image column. The noise gain is that of the rounds alone: smoothing leaves less in a
  /// pixel, but neighbours share it, and means over some pixels retain as much.
  [[nodiscard]] AtColumn at_column(int u) const {
    const double core = at(core_by_column_, u);
    const double left = std::pow(1.0 - core, kRounds);
    return {(1.0 - left) / core, at(b_by_column_, u)};
  }

 private:
  void tabulate_columns();
  void make_grid();
  void look_along_sight(const LightSpread& spread);
  /// Cells at the pixels, displaced by a part of the displacement by sight.
  [[nodiscard]] cv::Mat looked_up(const cv::Mat& cells, const cv::Size& size, double part) const;
  [[nodiscard]] cv::Mat transfer_of(double width_mm) const;
  static void fill_unmeasured(cv::Mat& cells);

  void smooth(const cv::Mat& cells, cv::Mat* smoothed) const {
    cv::GaussianBlur(cells, *smoothed, {}, kSmoothMm / step_s_, kSmoothMm / step_w_,
                     cv::BORDER_REPLICATE);
  }
  /// k * y, displaced to where each cell's pixel sees the middle of its skirt.
  [[nodiscard]] cv::Mat skirt_of(const cv::Mat& y) const {
    cv::Mat coarse, skirt;
    cv::resize(y, coarse, coarse_size_, 0, 0, cv::INTER_AREA);
    cv::dct(coarse, coarse);
    cv::multiply(coarse, transfer_, coarse);
    cv::dct(coarse, coarse, cv::DCT_INVERSE);
    cv::remap(coarse, skirt, skirt_column_, skirt_row_, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    return skirt;
  }
  /// A table over the valid columns, at a position along the face.
  [[nodiscard]] double along(const std::vector<double>& table, double s_mm) const {
    const auto above = std::upper_bound(s_.begin() + 1, s_.end() - 1, s_mm) - s_.begin();
    const auto i = static_cast<std::size_t>(above);
    const double part =
        std::clamp((s_mm - s_[i - 1]) / std::max(s_[i] - s_[i - 1], 1e-9), 0.0, 1.0);
    return table[i - 1] + part * (table[i] - table[i - 1]);
  }
  [[nodiscard]] double at(const std::vector<double>& by_cell, int u) const {
    const double index = (shape_.length_at(u) - s_.front()) / step_s_ - 0.5;
    const auto i = static_cast<std::size_t>(
        std::clamp(std::lround(index), 0L, static_cast<long>(by_cell.size()) - 1));
    return by_cell[i];
  }

  const FaceShape& shape_;
  // By valid column, ascending along the face.
  std::vector<double> s_, u_, middle_v_, mm_per_px_;
  std::vector<double> shift_s_, shift_w_, shift_w_slope_, cos_;  // of the line of sight, in mm
  double half_w_ = 0, step_s_ = 1, step_w_ = 1;
  cv::Size size_, coarse_size_;
  cv::Mat core_u_, core_v_;           // pixel whose core a cell is
  cv::Mat skirt_column_, skirt_row_;  // coarse cell in the middle of that pixel's skirt
  std::vector<float> skirt_part_;     // by column of cells
  std::vector<double> core_by_column_, b_by_column_;
  cv::Mat transfer_;  // of k, by the coarse grid's frequencies
};

void UnrolledFace::tabulate_columns() {
  const auto count = shape_.columns().size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t u = shape_.base_at_low_u() ? k : count - 1 - k;
    const FaceColumn& column = shape_.columns()[u];
    if (!column.valid) continue;
    const auto at_u = static_cast<double>(u);
    const double s = shape_.length_at(at_u);
    if (!s_.empty() && !(s > s_.back())) continue;
    const double middle = 0.5 * (column.upper_v + column.lower_v);
    const double quarter = 0.25 * (column.lower_v - column.upper_v);
    const auto here = sight_in_layer(shape_, at_u, middle),
               above = sight_in_layer(shape_, at_u, middle - quarter),
               below = sight_in_layer(shape_, at_u, middle + quarter);
    if (!here || !above || !below) continue;
    const double mm_per_px = shape_.position_mm(at_u, middle + 1.0).y();
    if (!(mm_per_px > 0.0)) continue;
    s_.push_back(s);
    u_.push_back(at_u);
    middle_v_.push_back(middle);
    mm_per_px_.push_back(mm_per_px);
    shift_s_.push_back(here->displacement_mm.x());
    shift_w_.push_back(here->displacement_mm.y());
    shift_w_slope_.push_back((below->displacement_mm.y() - above->displacement_mm.y()) /
                             (2.0 * quarter * mm_per_px));
    cos_.push_back(here->cos_sight);
    half_w_ = std::max(half_w_, 2.0 * quarter * mm_per_px);
  }
}

void UnrolledFace::make_grid() {
  const auto coarse_cells = [](double length_mm) {
    const int requested = std::max(kMinCells, static_cast<int>(std::ceil(length_mm / kCellMm / 2)));
    return 2 * cv::getOptimalDFTSize((requested + 1) / 2);
  };
  coarse_size_ = {coarse_cells(s_.back() - s_.front()), coarse_cells(2.0 * half_w_)};
  size_ = coarse_size_ * 2;
  step_s_ = (s_.back() - s_.front()) / size_.width;
  step_w_ = 2.0 * half_w_ / size_.height;
}

void UnrolledFace::look_along_sight(const LightSpread& spread) {
  constexpr int kSightSteps = 4;
  for (cv::Mat* map : {&core_u_, &core_v_, &skirt_column_, &skirt_row_})
    map->create(size_, CV_32FC1);
  for (int i = 0; i < size_.width; ++i) {
    const double s = s_.front() + (i + 0.5) * step_s_;
    ObliqueSpread here;
    double from_s = s;  // of the pixel whose line of sight leads to s
    for (int step = 0; step < kSightSteps; ++step) {
      here = oblique_spread(spread, along(cos_, from_s));
      from_s = s - here.core_shift * along(shift_s_, from_s);
    }
    skirt_part_.push_back(static_cast<float>(1.0 - here.core));
    core_by_column_.push_back(here.core);
    b_by_column_.push_back(b_at(spread, s, along(cos_, from_s)));
    const double u = along(u_, from_s), middle_v = along(middle_v_, from_s),
                 mm_per_px = along(mm_per_px_, from_s), shift_w = along(shift_w_, from_s),
                 slope = along(shift_w_slope_, from_s);
    const double skirt_s = from_s + here.skirt_shift * along(shift_s_, from_s);
    const auto column = static_cast<float>((skirt_s - s_.front()) / (2.0 * step_s_) - 0.5);
    // Beyond both ends there is no column to see from.
    const bool is_seen = from_s >= s_.front() && from_s <= s_.back();
    for (int j = 0; j < size_.height; ++j) {
      const double w = -half_w_ + (j + 0.5) * step_w_;
      const double from_w = (w - here.core_shift * shift_w) / (1.0 + here.core_shift * slope);
      const double skirt_w = from_w + here.skirt_shift * (shift_w + slope * from_w);
      core_u_.at<float>(j, i) = is_seen ? static_cast<float>(u) : -9.0F;
      core_v_.at<float>(j, i) = static_cast<float>(middle_v + from_w / mm_per_px);
      skirt_column_.at<float>(j, i) = column;
      skirt_row_.at<float>(j, i) = static_cast<float>((skirt_w + half_w_) / (2.0 * step_w_) - 0.5);
    }
  }
}

cv::Mat UnrolledFace::transfer_of(double width_mm) const {
  cv::Mat transfer(coarse_size_, CV_32FC1);
  const double along_mm = s_.back() - s_.front(), across_mm = 2.0 * half_w_;
  for (int j = 0; j < transfer.rows; ++j)
    for (int i = 0; i < transfer.cols; ++i) {
      const double k = M_PI * width_mm * std::hypot(i / along_mm, j / across_mm);
      transfer.at<float>(j, i) = static_cast<float>(1.0 / (1.0 + k * k));
    }
  return transfer;
}

/// The nearest measured cell across the face, else along it; 0 where nothing is measured.
void UnrolledFace::fill_unmeasured(cv::Mat& cells) {
  const auto is_measured = [&](int j, int i) { return std::isfinite(cells.at<float>(j, i)); };
  std::vector<int> measured_columns;
  for (int i = 0; i < cells.cols; ++i) {
    int last = -1;
    for (int j = 0; j < cells.rows; ++j) {
      if (!is_measured(j, i)) continue;
      const int half = last < 0 ? 0 : (last + j + 1) / 2;
      for (int k = last + 1; k < j; ++k)
        cells.at<float>(k, i) = cells.at<float>(k < half ? last : j, i);
      last = j;
    }
    if (last < 0) continue;
    for (int k = last + 1; k < cells.rows; ++k) cells.at<float>(k, i) = cells.at<float>(last, i);
    measured_columns.push_back(i);
  }
  if (measured_columns.empty()) {
    cells.setTo(0.0F);
    return;
  }
  for (int i = 0; i < cells.cols; ++i) {
    const auto at = std::lower_bound(measured_columns.begin(), measured_columns.end(), i);
    if (at != measured_columns.end() && *at == i) continue;
    const int right = at == measured_columns.end() ? measured_columns.back() : *at;
    const int left = at == measured_columns.begin() ? right : *(at - 1);
    cells.col(i - left < right - i ? left : right).copyTo(cells.col(i));
  }
}

cv::Mat UnrolledFace::looked_up(const cv::Mat& cells, const cv::Size& size, double part) const {
  cv::Mat column(size, CV_32FC1), row(size, CV_32FC1), at_pixel;
  for (int u = 0; u < size.width; ++u) {
    const double s = shape_.length_at(u);
    const double middle_v = along(middle_v_, s), mm_per_px = along(mm_per_px_, s);
    const double to_s = s + part * along(shift_s_, s);
    const double shift_w = part * along(shift_w_, s), slope = part * along(shift_w_slope_, s);
    for (int v = 0; v < size.height; ++v) {
      const double w = (v - middle_v) * mm_per_px;
      column.at<float>(v, u) = static_cast<float>((to_s - s_.front()) / step_s_ - 0.5);
      row.at<float>(v, u) = static_cast<float>((w + shift_w + slope * w + half_w_) / step_w_ - 0.5);
    }
  }
  cv::remap(cells, at_pixel, column, row, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return at_pixel;
}

cv::Mat UnrolledFace::seen_by_pixels(const cv::Mat& y, const MappingParameters& mapping) const {
  cv::Mat at_u(size_, CV_32FC1), at_v(size_, CV_32FC1), cells;
  for (int i = 0; i < size_.width; ++i) {
    const double s = s_.front() + (i + 0.5) * step_s_;
    const double u = along(u_, s), middle_v = along(middle_v_, s), mm_per_px = along(mm_per_px_, s);
    for (int j = 0; j < size_.height; ++j) {
      at_u.at<float>(j, i) = static_cast<float>(u);
      at_v.at<float>(j, i) =
          static_cast<float>(middle_v + (-half_w_ + (j + 0.5) * step_w_) / mm_per_px);
    }
  }
  cv::remap(y, cells, at_u, at_v, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  for (int j = 0; j < size_.height; ++j)
    for (int i = 0; i < size_.width; ++i) {
      float& here = cells.at<float>(j, i);
      MappingParameters oblique = mapping;
      oblique.b = b_by_column_[static_cast<std::size_t>(i)];
      oblique.a_mm = mapping.a_mm / (1.0 + mapping.b) * (1.0 + oblique.b);
      here = static_cast<float>(difference_on_curve(static_cast<double>(here), mapping.b, oblique));
    }
  const cv::Mat skirt = skirt_of(cells);
  for (int j = 0; j < size_.height; ++j)
    for (int i = 0; i < size_.width; ++i)
      cells.at<float>(j, i) -= skirt_part_[static_cast<std::size_t>(i)] *
                               (cells.at<float>(j, i) - skirt.at<float>(j, i));
  return looked_up(cells, y.size(), oblique_spread(mapping.spread, 1.0).core_shift);
}

}  // namespace

void remove_light_spread(const MappingParameters& mapping, const FaceShape& shape,
                         Difference* difference) {
  if (mapping.spread.is_local() || !difference->spread_removed.is_none()) return;
  const UnrolledFace face(mapping, shape);
  if (face.is_empty()) return;
  cv::Mat x = difference->x.clone();  // others may hold the same differences
  const cv::Mat moved = face.moved_to_core(x);
  const cv::Mat y = face.at_pixels(face.without_skirt(moved), x.size());
  SpreadRemoved& removed = difference->spread_removed;
  removed.change = face.at_pixels(moved, x.size());
  std::vector<double> b;
  for (int u = 0; u < x.cols; ++u) {
    const auto at = face.at_column(u);
    // Of small differences.
    const double level_gain = (1.0 + at.b) / (1.0 + mapping.b);
    b.push_back(at.b);
    removed.noise_gain.push_back(static_cast<float>(at.noise_gain * level_gain));
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

cv::Mat with_light_spread(const cv::Mat& y, const MappingParameters& mapping,
                          const FaceShape& shape) {
  if (mapping.spread.is_local()) return y;
  const UnrolledFace face(mapping, shape);
  if (face.is_empty()) return y;
  cv::Mat single, seen;
  y.convertTo(single, CV_32F);
  face.seen_by_pixels(single, mapping).convertTo(seen, CV_64F);
  return seen;
}

}  // namespace alltact
