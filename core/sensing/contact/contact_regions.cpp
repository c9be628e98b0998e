#include "core/sensing/contact/contact_regions.h"

#include "core/sensing/depth/depth_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

/// Volume that some adjacent pixels displace. Positions in mm, camera frame, from one origin.
struct ContactColumn {
  Eigen::Vector3d middle_mm;   ///< of the volume between the threshold and the depth
  Eigen::Vector3d pressed_mm;  ///< the pressed point
  double volume_mm3 = 0;       ///< above the threshold
  double height_mm = 0;        ///< the same by the area
  double skin_sd_mm = 0;       ///< of a depth there before contact; 0: unknown
  double noise_mm6 = 0;        ///< variance of the volume, for independent pixels
};

struct PrincipalAxis {
  double angle_rad = 0;  ///< in (-pi/2, pi/2], in the plane from its first axis to its second
  double sd_rad = 0;     ///< from noise, including its correlation
  double greater_mm2 = 0, smaller_mm2 = 0;  ///< variances along and across
};

constexpr double kMaxLogWeight = 0.6931471805599453;  // ln 2, from end to end

struct Flat {
  Eigen::Vector2d mean;
  Eigen::Matrix2d covariance;
  double weight = 0;
};

/// Two passes about the mean, to avoid cancellation.
Flat moments_of(const std::vector<ContactColumn>& columns, const ContactPlane& plane,
                const std::vector<double>& certainty) {
  Flat flat{Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero()};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double weight = certainty[i] * columns[i].volume_mm3;
    flat.weight += weight;
    flat.mean += weight * (plane.transpose() * columns[i].middle_mm);
  }
  if (!(flat.weight > 0)) return flat;
  flat.mean /= flat.weight;
  const Eigen::Vector2d upright = plane.row(2).transpose();  // projection of a column of volume
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const ContactColumn& column = columns[i];
    const Eigen::Vector2d off = plane.transpose() * column.middle_mm - flat.mean;
    flat.covariance += certainty[i] * column.volume_mm3 / flat.weight *
                       (off * off.transpose() +
                        column.height_mm * column.height_mm / 12.0 * upright * upright.transpose());
  }
  return flat;
}

/// The slope of log(1 / variance) over the contact, by least squares.
Eigen::Vector2d log_slope(const std::vector<ContactColumn>& columns, const ContactPlane& plane,
                          const Flat& flat) {
  double mean_log = 0, weights = 0;
  for (const ContactColumn& column : columns)
    if (column.skin_sd_mm > 0) {
      mean_log -= 2.0 * column.volume_mm3 * std::log(column.skin_sd_mm);
      weights += column.volume_mm3;
    }
  if (!(weights > 0)) return Eigen::Vector2d::Zero();
  mean_log /= weights;
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const ContactColumn& column : columns) {
    if (!(column.skin_sd_mm > 0)) continue;
    const Eigen::Vector2d off = plane.transpose() * column.middle_mm - flat.mean;
    normal += column.volume_mm3 * off * off.transpose();
    right += column.volume_mm3 * off * (-2.0 * std::log(column.skin_sd_mm) - mean_log);
  }
  if (!(normal.determinant() > 1e-9 * normal.trace() * normal.trace()))
    return Eigen::Vector2d::Zero();
  return normal.inverse() * right;
}

std::vector<double> certainty_of(const std::vector<ContactColumn>& columns,
                                 const ContactPlane& plane, const Flat& flat) {
  const Eigen::Vector2d slope = log_slope(columns, plane, flat);
  std::vector<double> logs;
  for (const ContactColumn& column : columns)
    logs.push_back(slope.dot(plane.transpose() * column.middle_mm - flat.mean));
  const auto [lowest, highest] = std::minmax_element(logs.begin(), logs.end());
  const double part = std::min(1.0, kMaxLogWeight / std::max(*highest - *lowest, kMaxLogWeight));
  for (double& value : logs) value = std::exp(part * value);
  return logs;
}

/// correlated_px2: area of pixels with common noise. nullopt: exactly round, or no volume.
std::optional<PrincipalAxis> principal_axis(const std::vector<ContactColumn>& columns,
                                            const ContactPlane& plane, double correlated_px2) {
  const Flat alike = moments_of(columns, plane, std::vector<double>(columns.size(), 1.0));
  if (!(alike.weight > 0)) return std::nullopt;
  const std::vector<double> certainty = certainty_of(columns, plane, alike);
  const Flat flat = moments_of(columns, plane, certainty);
  const double xx = flat.covariance(0, 0), xy = flat.covariance(0, 1), yy = flat.covariance(1, 1);
  const double difference = std::hypot(xx - yy, 2.0 * xy);
  if (!(difference > 0.0)) return std::nullopt;
  PrincipalAxis axis;
  axis.angle_rad = 0.5 * std::atan2(2.0 * xy, xx - yy);
  if (axis.angle_rad <= -M_PI / 2) axis.angle_rad += M_PI;
  axis.greater_mm2 = 0.5 * (xx + yy + difference);
  axis.smaller_mm2 = std::max(0.0, xx * yy - xy * xy) / axis.greater_mm2;
  const double c = std::cos(axis.angle_rad), s = std::sin(axis.angle_rad);
  double squares = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Eigen::Vector2d off = plane.transpose() * columns[i].pressed_mm - flat.mean;
    const double x = c * off.x() + s * off.y(), y = c * off.y() - s * off.x();
    squares += columns[i].noise_mm6 * std::pow(certainty[i] * x * y, 2);
  }
  axis.sd_rad = std::sqrt(correlated_px2 * squares) / (flat.weight * difference);
  return axis;
}

/// Errors of the depth in the middles of a box of cells without contact. Each is computed once, on
/// request.
class UntouchedCells {
 public:
  UntouchedCells(const RegionOptions& options, const cv::Size& image_size, const cv::Rect& box)
      : options_(options),
        image_size_(image_size),
        box_(box),
        sd_(static_cast<std::size_t>(box.area())) {}

  [[nodiscard]] const UntouchedSd& at(const cv::Point& cell) {
    std::optional<UntouchedSd>& sd =
        sd_[static_cast<std::size_t>((cell.y - box_.y) * box_.width + cell.x - box_.x)];
    if (!sd) sd = estimate(cell);
    return *sd;
  }

 private:
  [[nodiscard]] UntouchedSd estimate(const cv::Point& cell) const {
    if (!options_.untouched) return {options_.noise_mm, 0.0};
    return options_.untouched(
        std::min(image_size_.width - 1, cell.x * kDepthCellPx + kDepthCellPx / 2),
        std::min(image_size_.height - 1, cell.y * kDepthCellPx + kDepthCellPx / 2));
  }

  const RegionOptions& options_;
  cv::Size image_size_;
  cv::Rect box_;
  std::vector<std::optional<UntouchedSd>> sd_;
};

constexpr int kCell = kDepthCellPx;  // regions are connected in cells
constexpr double kLargestAngleSdDeg = 15.0;
constexpr double kMinSds = 4.0;  // minimum distance from contact-free skin

double sd_of_mean(const UntouchedSd& sd, double pixels, const RegionOptions& options) {
  const double independent = std::max(1.0, pixels / options.correlated_px2);
  return std::hypot(sd.noise / std::sqrt(independent), sd.systematic);
}

DepthErrorTerms pressed_at(const RegionOptions& options, const Eigen::Vector2d& pixel,
                           double depth_mm) {
  DepthErrorTerms causes;
  causes.noise = options.noise_mm;
  if (!options.pressed) return causes;
  return options.pressed(static_cast<int>(std::lround(pixel.x())),
                         static_cast<int>(std::lround(pixel.y())), depth_mm);
}

/// The deepest pixel of a contact is a maximum over noisy pixels. Its additional error is a
/// fraction of the noise's sd, from simulated balls.
double sd_of_deepest(const DepthErrorTerms& causes) {
  constexpr double kChosen = 0.5;
  return std::hypot(causes.total(), kChosen * causes.noise);
}

/// Clears cells that contact-free skin could explain. in_contact: mask of the box.
void drop_insignificant(const cv::Mat& cells_mm, const cv::Rect& box, const RegionOptions& options,
                        UntouchedCells& untouched, cv::Mat& in_contact) {
  if (!options.untouched) return;
  for (int y = 0; y < box.height; ++y)
    for (int x = 0; x < box.width; ++x) {
      std::uint8_t& is_cell_in_contact = in_contact.at<std::uint8_t>(y, x);
      if (is_cell_in_contact == 0) continue;
      const cv::Point cell = box.tl() + cv::Point(x, y);
      const double sd = sd_of_mean(untouched.at(cell), kCell * kCell, options);
      if (cells_mm.at<float>(cell) < kMinSds * sd) is_cell_in_contact = 0;
    }
}

/// Pressed pixels of one cell, all assigned to their depth-weighted centre.
struct CellSums {
  int pixels = 0;
  double depth = 0, depth_square = 0, depth_u = 0, depth_v = 0;  // sums over the pixels
  std::uint8_t limits = 0;
};

/// Centre on the face of the volume above the threshold. The weight starts at 0, so that pixels of
/// the rim, which noise adds or removes, do not move it.
class SkinCentre {
 public:
  void add(const CellSums& cell, const Eigen::Vector2d& position_mm, double pixel_mm2,
           double threshold_mm, double noise_mm) {
    if (weight_ == 0) origin_mm_ = position_mm;
    const Eigen::Vector2d off = position_mm - origin_mm_;
    const double above = cell.depth - threshold_mm * cell.pixels;
    weight_ += pixel_mm2 * above;
    first_ += pixel_mm2 * above * off;
    square_ += pixel_mm2 * (cell.depth_square - threshold_mm * (cell.depth + above));
    const double variance = cell.pixels * std::pow(pixel_mm2 * noise_mm, 2);
    noise_ += variance;
    noise_first_ += variance * off;
    noise_second_ += variance * off * off.transpose();
  }
  [[nodiscard]] Eigen::Vector2d mean_mm() const { return origin_mm_ + first_ / weight_; }
  /// Mean depth above the threshold, weighted with itself.
  [[nodiscard]] double mean_above_mm() const { return square_ / weight_; }
  /// Of the mean, for independent pixels: an error e moves it by (position - mean) e / weights.
  [[nodiscard]] Eigen::Matrix2d covariance_mm2() const {
    const Eigen::Vector2d mean = first_ / weight_;
    const Eigen::Matrix2d mixed = noise_first_ * mean.transpose();
    return (noise_second_ - mixed - mixed.transpose() + noise_ * mean * mean.transpose()) /
           (weight_ * weight_);
  }

 private:
  Eigen::Vector2d origin_mm_{0, 0}, first_{0, 0}, noise_first_{0, 0};
  Eigen::Matrix2d noise_second_ = Eigen::Matrix2d::Zero();
  double weight_ = 0, square_ = 0, noise_ = 0;
};

/// Mean depth of a region in standard deviations of contact-free skin. Cells are weighted by their
/// certainty: a few at the face's end, where there is hardly a reference, hide no contact.
class Significance {
 public:
  void add(const CellSums& cell, const UntouchedSd& sd) {
    const double variance = sd.noise * sd.noise + sd.systematic * sd.systematic;
    const double each = 1.0 / std::max(variance, 1e-12), weight = each * cell.pixels;
    weight_ += weight;
    square_ += each * weight;
    depth_ += each * cell.depth;
    noise_ += weight * sd.noise;
    systematic_ += weight * sd.systematic;
  }
  [[nodiscard]] double sds(const RegionOptions& options) const {
    const double pixels = weight_ * weight_ / square_;  // as many of the same weight
    const double sd = sd_of_mean({noise_ / weight_, systematic_ / weight_}, pixels, options);
    return depth_ / weight_ / std::max(sd, 1e-9);
  }

 private:
  double weight_ = 0, square_ = 0, depth_ = 0, noise_ = 0, systematic_ = 0;
};

/// Sums of a region, accumulated cell by cell. Within a cell of 4 px the face is even. Its own
/// spread of (4^2 - 1) / 12 px^2 is isotropic and omitted.
class RegionSums {
 public:
  /// For pixels of rows [first_row, first_row + rows).
  RegionSums(const FaceShape& shape, const Face& face, double threshold_mm, int first_row, int rows)
      : shape_(shape),
        face_(face),
        threshold_mm_(threshold_mm),
        first_row_(first_row),
        ends_(static_cast<std::size_t>(rows), {std::numeric_limits<int>::max(), -1}) {
    region_.position_mm.setZero();
    region_.position_px.setZero();
  }

  /// sd: of the cell without contact
  void add(const CellSums& cell, const UntouchedSd& sd, const RegionOptions& options) {
    const Eigen::Vector2d middle(cell.depth_u / cell.depth, cell.depth_v / cell.depth);
    region_.limits |= cell.limits;
    significance_.add(cell, sd);
    const auto local = shape_.at(middle.x(), middle.y());
    const auto area = shape_.pixel_area(middle.x(), middle.y());
    if (!local || !area) return;
    const double weighted_depth = cell.depth_square / cell.depth;
    const Eigen::Vector3d pressed_mm =
        untouched_point_mm(*local, face_.layer_mm, MappingAlong::kZ) -
        Eigen::Vector3d(0.0, 0.0, weighted_depth);
    const double volume = cell.depth * area->projected_mm2;
    // Moments about a point of the region itself, to avoid cancellation.
    if (region_.pixels == 0) origin_mm_ = pressed_mm;
    region_.pixels += cell.pixels;
    region_.volume_mm3 += volume;
    region_.position_mm += volume * pressed_mm;
    region_.position_px += volume * middle;
    const Eigen::Vector2d on_face_mm = shape_.position_mm(middle.x(), middle.y());
    region_.position_on_face_mm += volume * on_face_mm;
    region_.area_mm2 += cell.pixels * area->on_face_mm2;
    const DepthErrorTerms causes = pressed_at(options, middle, cell.depth / cell.pixels);
    errors_.add(causes, volume, cell.pixels);
    centre_.add(cell, on_face_mm, area->projected_mm2, threshold_mm_, causes.noise);
    // The axis is that of the volume between the threshold and the depth. The weight starts at 0,
    // so that pixels of the rim, which noise adds or removes, do not move it.
    const double above = cell.depth - threshold_mm_ * cell.pixels;
    const double middle_depth =
        0.5 * (cell.depth_square - threshold_mm_ * threshold_mm_ * cell.pixels) / above;
    const Eigen::Vector3d off = pressed_mm - origin_mm_;
    columns_.push_back({off + Eigen::Vector3d(0.0, 0.0, weighted_depth - middle_depth), off,
                        above * area->on_face_mm2, above / cell.pixels, sd.noise,
                        cell.pixels * std::pow(area->on_face_mm2 * causes.noise, 2)});
  }

  /// The first and the last pressed pixel of a row of a cell.
  void widen(int row, int first, int last) {
    auto& [row_first, row_last] = ends_[static_cast<std::size_t>(row - first_row_)];
    row_first = std::min(row_first, first), row_last = std::max(row_last, last);
  }

  /// A candidate for the deepest pixel.
  void update_deepest(int u, int row, double depth_mm) {
    if (!(depth_mm > region_.deepest_mm)) return;
    const auto local = shape_.at(u, row);
    if (!local) return;
    region_.deepest_mm = depth_mm;
    deepest_px_ = {u, row};
    region_.deepest_point_mm = untouched_point_mm(*local, face_.layer_mm, MappingAlong::kZ) -
                               Eigen::Vector3d(0.0, 0.0, depth_mm);
  }

  [[nodiscard]] bool empty() const { return region_.pixels == 0; }
  /// Whether contact-free skin would hardly ever have these depths.
  [[nodiscard]] bool is_significant(const RegionOptions& options) const {
    return significance_.sds(options) >= kMinSds;
  }
  /// Greatest depth in standard deviations; infinite without `pressed`.
  [[nodiscard]] double sds_deep(const RegionOptions& options) const {
    if (!options.pressed) return std::numeric_limits<double>::infinity();
    DepthErrorTerms causes = pressed_at(options, deepest_px_, region_.deepest_mm);
    causes.lateral = 0;
    return region_.deepest_mm / std::max(sd_of_deepest(causes), 1e-9);
  }
  [[nodiscard]] ContactRegion region(const RegionOptions& options) const {
    ContactRegion region = region_;
    region.position_mm /= region.volume_mm3;
    region.position_px /= region.volume_mm3;
    region.position_on_face_mm /= region.volume_mm3;
    find_deepest_position(region);
    if (options.pressed) {
      const DepthErrorTerms causes = pressed_at(options, deepest_px_, region.deepest_mm);
      region.deepest_sd_mm = sd_of_deepest(causes);
      if ((limits_of(causes, options.is_light_doubtful) & kDoubtfulLight) != 0)
        region.limits |= kDoubtfulLight;
    }
    if (options.pressed) {
      Eigen::Matrix2d centre_mm2 = options.correlated_px2 * centre_.covariance_mm2();
      centre_mm2(0, 0) += options.along_sd_mm * options.along_sd_mm;
      const auto covariance =
          contact_covariance_mm2(shape_, region.position_px,
                                 errors_.mean_sd_mm(region, options.correlated_px2), centre_mm2);
      if (const auto plane = contact_plane(shape_, region.position_px); plane && covariance) {
        region.on_face_covariance_mm2 = plane->transpose() * *covariance * *plane;
        region.position_covariance_mm2 =
            *covariance + lens_covariance_mm2(shape_, region.position_px, region.position_mm);
      }
    }
    if (const auto local = shape_.at(region.position_px.x(), region.position_px.y()))
      region.normal = local->normal;
    find_angle(options, region);
    if (region.angle_deg) region.axis = contact_axis(shape_, region.position_px, *region.angle_deg);
    region.polygon_mm =
        convex_polygon(outline_mm(), 0.25 * std::sqrt(region.area_mm2 / region.pixels));
    return region;
  }

 private:
  /// Both ends of each row, mm on the face: any convex polygon around them contains the pixels
  /// between.
  [[nodiscard]] std::vector<Eigen::Vector2d> outline_mm() const {
    std::vector<Eigen::Vector2d> outline;
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      const auto [first, last] = ends_[k];
      if (last < first) continue;
      const double row = first_row_ + static_cast<double>(k);
      outline.push_back(shape_.position_mm(first - 0.5, row));
      outline.push_back(shape_.position_mm(last + 0.5, row));
    }
    return outline;
  }

  /// Formula of contact_regions() with the weights depth - h: the centre lies
  ///   (sum of (d - h)^2 / sum of (d - h) / 2 + h) sin(theta) from the middle.
  void find_deepest_position(ContactRegion& region) const {
    region.deepest_on_face_mm = centre_.mean_mm();
    if (const auto plane = contact_plane(shape_, region.position_px))
      region.deepest_on_face_mm +=
          (region.deepest_mm - threshold_mm_ - 0.5 * centre_.mean_above_mm()) *
          plane->row(2).transpose();
  }

  /// Principal axis, where it is determined. Criterion: as many random points of the contact as it
  /// has independent pixels give an sd of at most kLargestAngleSdDeg, sqrt(l1 l2 / n) / (l1 - l2).
  void find_angle(const RegionOptions& options, ContactRegion& region) const {
    const auto plane = contact_plane(shape_, region.position_px);
    if (!plane) return;
    const auto axis = principal_axis(columns_, *plane, options.correlated_px2);
    if (!axis) return;
    constexpr double kDegPerRad = 180.0 / M_PI;
    const double independent = std::max(1.0, region.pixels / options.correlated_px2);
    const double sampling_sd_deg = kDegPerRad *
                                   std::sqrt(axis->greater_mm2 * axis->smaller_mm2 / independent) /
                                   (axis->greater_mm2 - axis->smaller_mm2);
    const double width_mm = std::sqrt(axis->smaller_mm2);
    const double sd_deg = std::hypot(
        kDegPerRad * axis->sd_rad,
        width_mm > 0 ? options.axis_beyond_noise_deg / std::sqrt(width_mm) : kLargestAngleSdDeg);
    if (!(sampling_sd_deg <= kLargestAngleSdDeg && sd_deg <= kLargestAngleSdDeg)) return;
    region.angle_deg = kDegPerRad * axis->angle_rad;
    region.angle_sd_deg = sd_deg;
  }

  /// Errors of the mean depth: those that all pixels share, and their independent noise.
  struct MeanErrors {
    double volume = 0, mapping = 0, reference = 0, light = 0, noise_square = 0;
    void add(const DepthErrorTerms& causes, double cell_volume, int pixels) {
      volume += cell_volume;
      mapping += cell_volume * causes.mapping;
      reference += cell_volume * causes.reference;
      light += cell_volume * causes.light;
      noise_square += pixels * causes.noise * causes.noise;
    }
    [[nodiscard]] double mean_sd_mm(const ContactRegion& region, double correlated_px2) const {
      const double noise = std::sqrt(correlated_px2 * noise_square) / region.pixels;
      return std::hypot(std::hypot(mapping, reference, light) / volume, noise);
    }
  };

  const FaceShape& shape_;
  const Face& face_;
  double threshold_mm_;
  std::vector<ContactColumn> columns_;
  Eigen::Vector2d deepest_px_{0, 0};
  int first_row_;
  std::vector<std::pair<int, int>> ends_;  // the first and the last pressed pixel of each row
  MeanErrors errors_;
  ContactRegion region_;  // positions not yet divided by the volume
  Eigen::Vector3d origin_mm_ = Eigen::Vector3d::Zero();
  Significance significance_;
  SkinCentre centre_;
};

/// A cell's pressed pixels, the deepest of them, and in each row the first and the last.
struct PressedCell {
  CellSums sums;
  std::array<std::pair<int, int>, kCell> ends;
  PressedCell() { ends.fill({0, -1}); }
  int deepest_u = 0, deepest_row = 0;
  float deepest = 0;
};

PressedCell pressed_in(const DepthMap& map, const cv::Rect& cell, float threshold) {
  PressedCell pressed;
  for (int row = cell.y; row < cell.y + cell.height; ++row) {
    const float* depth = map.depth_mm.ptr<float>(row);
    const auto* flags = map.flags.ptr<std::uint8_t>(row);
    auto& [first, last] = pressed.ends[static_cast<std::size_t>(row - cell.y)];
    for (int u = cell.x; u < cell.x + cell.width; ++u) {
      if (!(depth[u] > threshold)) continue;
      if (last < 0) first = u;
      last = u;
      const auto d = static_cast<double>(depth[u]);
      CellSums& sums = pressed.sums;
      ++sums.pixels;
      sums.depth += d;
      sums.depth_square += d * d;
      sums.depth_u += d * u;
      sums.depth_v += d * row;
      sums.limits |= limit_of_flag(flags[u]);
      if (depth[u] > pressed.deepest)
        pressed.deepest = depth[u], pressed.deepest_u = u, pressed.deepest_row = row;
    }
  }
  return pressed;
}

/// The pressed pixels of the cells with a label; the label image begins at the cell `origin`.
RegionSums sums_of(const DepthMap& depth, const cv::Mat& labels, int label, const cv::Rect& cells,
                   const cv::Point& origin, UntouchedCells& untouched, const FaceShape& shape,
                   const Face& face, double threshold_mm, const RegionOptions& options) {
  RegionSums sums(shape, face, threshold_mm, (origin.y + cells.y) * kCell, cells.height * kCell);
  const cv::Rect image({0, 0}, depth.depth_mm.size());
  for (int y = cells.y; y < cells.y + cells.height; ++y) {
    const int* row = labels.ptr<int>(y);
    for (int x = cells.x; x < cells.x + cells.width; ++x) {
      if (row[x] != label) continue;
      const cv::Rect cell =
          cv::Rect((origin.x + x) * kCell, (origin.y + y) * kCell, kCell, kCell) & image;
      const PressedCell pressed = pressed_in(depth, cell, static_cast<float>(threshold_mm));
      if (pressed.sums.pixels == 0) continue;
      sums.add(pressed.sums, untouched.at(origin + cv::Point(x, y)), options);
      for (std::size_t k = 0; k < pressed.ends.size(); ++k)
        if (const auto& [first, last] = pressed.ends[k]; last >= 0)
          sums.widen(cell.y + static_cast<int>(k), first, last);
      sums.update_deepest(pressed.deepest_u, pressed.deepest_row,
                          static_cast<double>(pressed.deepest));
    }
  }
  return sums;
}

struct FoundRegion {
  ContactRegion region;
  double sds_deep;
};

std::vector<ContactRegion> by_certainty_and_volume(std::vector<FoundRegion>& found) {
  constexpr double kPartOfMaxSds = 0.5;
  double max_sds = 0;
  for (const FoundRegion& one : found) max_sds = std::max(max_sds, one.sds_deep);
  std::stable_sort(found.begin(), found.end(), [&](const FoundRegion& a, const FoundRegion& b) {
    const auto rank = [&](const FoundRegion& one) {
      return std::pair(one.sds_deep >= kPartOfMaxSds * max_sds, one.region.volume_mm3);
    };
    return rank(a) > rank(b);
  });
  std::vector<ContactRegion> regions;
  for (FoundRegion& one : found) regions.push_back(std::move(one.region));
  return regions;
}

}  // namespace

std::vector<ContactRegion> contact_regions(const DepthMap& depth, const FaceShape& shape,
                                           const Face& face, const RegionOptions& options) {
  const double threshold = std::max(options.threshold_mm, 4.0 * options.noise_mm);
  cv::Mat everywhere = depth.cells_mm > threshold;
  // Labels are computed within the bounding box of all cells in contact, and a cell around it.
  const cv::Rect tight = cv::boundingRect(everywhere);
  if (tight.empty()) return {};
  const cv::Rect box = cv::Rect(tight.x - 1, tight.y - 1, tight.width + 2, tight.height + 2) &
                       cv::Rect({0, 0}, everywhere.size());
  cv::Mat in_contact = everywhere(box);
  UntouchedCells untouched(options, depth.depth_mm.size(), box);
  drop_insignificant(depth.cells_mm, box, options, untouched, in_contact);
  cv::Mat labels, statistics, centres;
  const int count =
      cv::connectedComponentsWithStats(in_contact, labels, statistics, centres, 8, CV_32S);
  // A region's rim extends into the adjacent cells.
  cv::Mat wide;
  labels.convertTo(wide, CV_32F);
  cv::dilate(wide, wide, cv::Mat::ones(3, 3, CV_8U));
  wide.convertTo(wide, CV_32S);
  labels.copyTo(wide, in_contact);

  std::vector<FoundRegion> found;
  for (int label = 1; label < count; ++label) {
    const cv::Rect cells = cv::Rect(statistics.at<int>(label, cv::CC_STAT_LEFT) - 1,
                                    statistics.at<int>(label, cv::CC_STAT_TOP) - 1,
                                    statistics.at<int>(label, cv::CC_STAT_WIDTH) + 2,
                                    statistics.at<int>(label, cv::CC_STAT_HEIGHT) + 2) &
                           cv::Rect(0, 0, labels.cols, labels.rows);
    const RegionSums sums =
        sums_of(depth, wide, label, cells, box.tl(), untouched, shape, face, threshold, options);
    if (sums.empty() || !sums.is_significant(options)) continue;
    const ContactRegion region = sums.region(options);
    const double sds_deep = sums.sds_deep(options);
    if (region.area_mm2 >= options.minimum_area_mm2 && sds_deep >= kMinSds)
      found.push_back({region, sds_deep});
  }
  return by_certainty_and_volume(found);
}

std::optional<ContactPlane> contact_plane(const FaceShape& shape, const Eigen::Vector2d& pixel) {
  const auto local = shape.at(pixel.x(), pixel.y());
  if (!local) return std::nullopt;
  // The face is nearly straight along y: its length is across y.
  const double to_tip = shape.base_at_low_u() ? 1.0 : -1.0;
  ContactPlane plane;
  plane.col(0) = to_tip * Eigen::Vector3d::UnitY().cross(local->normal).normalized();
  plane.col(1) = to_tip * local->normal.cross(plane.col(0));
  return plane;
}

std::optional<Eigen::Vector3d> contact_axis(const FaceShape& shape, const Eigen::Vector2d& pixel,
                                            double angle_deg) {
  const auto plane = contact_plane(shape, pixel);
  if (!plane) return std::nullopt;
  const double angle = angle_deg * M_PI / 180.0;
  return (*plane * Eigen::Vector2d(std::cos(angle), std::sin(angle))).normalized();
}

std::optional<Eigen::Matrix3d> contact_covariance_mm2(const FaceShape& shape,
                                                      const Eigen::Vector2d& pixel,
                                                      double depth_sd_mm,
                                                      const Eigen::Matrix2d& centre_mm2) {
  const auto& columns = shape.columns();
  const auto plane = contact_plane(shape, pixel);
  const auto ray = shape.camera().unproject(pixel);
  const auto u = std::lround(pixel.x());
  if (!ray || !plane || u < 0 || u >= static_cast<long>(columns.size())) return std::nullopt;
  const FaceColumn& column = columns[static_cast<std::size_t>(u)];
  if (!column.valid || !std::isfinite(depth_sd_mm)) return std::nullopt;
  const Eigen::Vector3d sight = column.z_sd_mm * ray->direction;
  Eigen::Matrix3d covariance = sight * sight.transpose();
  covariance(2, 2) += depth_sd_mm * depth_sd_mm;
  return covariance + *plane * centre_mm2 * plane->transpose();
}

Eigen::Matrix3d lens_covariance_mm2(const FaceShape& shape, const Eigen::Vector2d& pixel,
                                    const Eigen::Vector3d& point_mm) {
  const CameraParameters& lens = shape.camera().parameters();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  const auto ray = shape.camera().unproject(pixel);
  if (lens.sd_px.empty() || !ray) return covariance;
  for (const int axis : {0, 1}) {
    const auto next = shape.camera().unproject(pixel + Eigen::Vector2d::Unit(axis));
    if (!next) continue;
    const double sd_px = lens.sd_px[static_cast<std::size_t>(2 + axis)];
    const Eigen::Vector3d moved_mm = sd_px * (next->origin_mm - ray->origin_mm +
                                              point_mm.z() * (next->direction - ray->direction));
    covariance += moved_mm * moved_mm.transpose();
  }
  if (!shape.camera().is_perspective()) return covariance;
  const double focal_part = lens.sd_px[1] / lens.fy_px;
  const Eigen::Vector3d moved_mm =
      shape.face().kind == FaceKind::kFlat
          ? Eigen::Vector3d(-focal_part * point_mm.x(), -focal_part * point_mm.y(), 0.0)
          : Eigen::Vector3d(0.0, 0.0, focal_part * point_mm.z());
  return covariance + moved_mm * moved_mm.transpose();
}

std::vector<Eigen::Vector2d> convex_polygon(const std::vector<Eigen::Vector2d>& points_mm,
                                            double tolerance_mm) {
  if (points_mm.empty()) return {};
  // Relative to one of them, so that single precision is enough.
  const Eigen::Vector2d& origin = points_mm.front();
  std::vector<cv::Point2f> points, hull, corners;
  for (const Eigen::Vector2d& point : points_mm) {
    const Eigen::Vector2f off = (point - origin).cast<float>();
    points.emplace_back(off.x(), off.y());
  }
  cv::convexHull(points, hull);
  cv::approxPolyDP(hull, corners, tolerance_mm, true);
  std::vector<Eigen::Vector2d> polygon;
  for (const cv::Point2f& corner : corners)
    polygon.push_back(origin + Eigen::Vector2f(corner.x, corner.y).cast<double>());
  return polygon;
}

}  // namespace alltact
