#include "core/sensing/depth/depth_resolution.h"

#include "core/sensing/depth/light_spread.h"
#include "core/sensing/depth/unrolled_face.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <opencv2/core.hpp>

namespace alltact {
namespace {

constexpr double kTolerance = 0.1;       // of the depth of walls, pins and steps
constexpr double kDip = 0.8;             // of the depth of two points, between them
constexpr double kLeastSpreadMm = 0.05;  // cell of a face with spread light

/// The chain from the skin to measured depth at one position of the face.
class DepthChain {
 public:
  DepthChain(const FaceShape& shape, const SightInLayer& sight, const MappingParameters& mapping,
             const Smoothing& smoothing, const Eigen::Vector2d& pixel_mm)
      : spread_(mapping.spread),
        layer_mm_(shape.face().layer_mm),
        sight_(sight),
        smoothing_(smoothing),
        pixel_mm_(pixel_mm) {}

  /// Of a wave along the face and across it.
  [[nodiscard]] std::complex<double> gain(const Eigen::Vector2d& wave_per_mm) const {
    return in_image(wave_per_mm.x(), pixel_mm_.x()) * in_image(wave_per_mm.y(), pixel_mm_.y()) *
           on_face(wave_per_mm);
  }
  /// Lens and smoothing, along one axis.
  [[nodiscard]] std::vector<double> in_image(const std::vector<double>& waves_per_mm,
                                             double pixel_mm) const {
    std::vector<double> gains;
    for (const double wave : waves_per_mm) gains.push_back(in_image(wave, pixel_mm));
    return gains;
  }
  [[nodiscard]] std::complex<double> on_face(const Eigen::Vector2d& wave_per_mm) const {
    return wave_after_removal(spread_, layer_mm_, sight_.displacement_mm, sight_.cos_sight,
                              wave_per_mm);
  }
  [[nodiscard]] const Eigen::Vector2d& pixel_mm() const { return pixel_mm_; }
  [[nodiscard]] double cell_mm() const {
    const double quarter = 0.25 * pixel_mm_.minCoeff();
    return spread_.is_local() ? quarter : std::max(quarter, kLeastSpreadMm);
  }

 private:
  [[nodiscard]] double in_image(double wave_per_mm, double pixel_mm) const {
    const double per_px = wave_per_mm * pixel_mm;
    double sum = smoothing_.weights.front();
    for (std::size_t i = 1; i < smoothing_.weights.size(); ++i)
      sum += 2.0 * smoothing_.weights[i] * std::cos(static_cast<double>(i) * per_px);
    return std::exp(-0.5 * kOpticsPx2 * per_px * per_px) * sum;
  }

  const LightSpread& spread_;
  double layer_mm_;
  SightInLayer sight_;
  const Smoothing& smoothing_;
  Eigen::Vector2d pixel_mm_;  // size of a pixel on the face
};

/// Depth that is measured around a point of the skin, its integral 1.
class PointResponse {
 public:
  explicit PointResponse(const DepthChain& chain)
      : cell_mm_(chain.cell_mm()), at_(kCells, kCells, CV_64FC1) {
    const double step = 2.0 * std::numbers::pi / (kCells * cell_mm_);
    std::vector<double> waves;
    for (int i = 0; i < kCells; ++i) waves.push_back(step * (i < kCells / 2 ? i : i - kCells));
    const auto along = chain.in_image(waves, chain.pixel_mm().x()),
               across = chain.in_image(waves, chain.pixel_mm().y());
    // Of a real response: the other half is conjugate to this one.
    cv::Mat_<cv::Vec2d> gains(kCells, kCells, cv::Vec2d(0.0, 0.0));
    for (std::size_t j = 0; j < waves.size(); ++j)
      for (std::size_t i = 0; i <= waves.size() / 2; ++i) {
        const std::complex<double> gain =
            along[i] * across[j] * chain.on_face({waves[i], waves[j]});
        gains(static_cast<int>(j), static_cast<int>(i)) = {gain.real(), gain.imag()};
      }
    cv::Mat response;
    cv::dft(gains, response, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
    // From the corners to the middle.
    for (int j = 0; j < kCells; ++j)
      for (int i = 0; i < kCells; ++i)
        at_.at<double>((j + kMiddle) % kCells, (i + kMiddle) % kCells) = response.at<double>(j, i);
  }

  static constexpr int kCells = 256, kMiddle = kCells / 2;
  [[nodiscard]] double cell_mm() const { return cell_mm_; }
  /// Of a cell at these numbers of cells from the point.
  [[nodiscard]] double at(int along, int across) const {
    return at_.at<double>(kMiddle + across, kMiddle + along);
  }

 private:
  double cell_mm_;
  cv::Mat at_;
};

/// A section through the response to a point or to a line, by cells from its middle.
struct Section {
  double cell_mm;
  std::vector<double> values;

  [[nodiscard]] double at(double mm) const {
    const double index = std::clamp(mm / cell_mm + PointResponse::kMiddle, 0.0,
                                    static_cast<double>(values.size()) - 1.001);
    const auto i = static_cast<std::size_t>(index);
    return std::lerp(values[i], values[i + 1], index - static_cast<double>(i));
  }
};

enum class Axis { kAlong, kAcross };

Section point_section(const PointResponse& response, Axis axis) {
  Section section{response.cell_mm(), {}};
  for (int i = -PointResponse::kMiddle; i < PointResponse::kMiddle; ++i)
    section.values.push_back(axis == Axis::kAlong ? response.at(i, 0) : response.at(0, i));
  return section;
}

/// Depth next to a step at the middle, from -1/2 to 1/2 of its height.
Section step_section(const PointResponse& response, Axis axis) {
  Section section{response.cell_mm(), {}};
  double sum = 0, before = 0;
  for (int i = -PointResponse::kMiddle; i < PointResponse::kMiddle; ++i) {
    double line = 0;
    for (int j = -PointResponse::kMiddle; j < PointResponse::kMiddle; ++j)
      line += axis == Axis::kAlong ? response.at(i, j) : response.at(j, i);
    sum += 0.5 * (before + line);
    before = line;
    section.values.push_back(sum);
  }
  return section;
}

/// The least size from which on `error` is within the tolerance, in steps of half a cell, between
/// which it is linear; at most kMaxMm.
template <class Error>
double least_size_mm(const Error& error, double cell_mm, double tolerance) {
  const double step = 0.5 * cell_mm;
  const double from = std::min(DepthResolution::kMaxMm, 0.4 * PointResponse::kCells * cell_mm);
  double beyond = error(from);
  if (!(beyond <= tolerance)) return DepthResolution::kMaxMm;
  for (double size = from - step; size > 0; size -= step) {
    const double here = error(size);
    if (!(here <= tolerance)) return size + step * (here - tolerance) / (here - beyond);
    beyond = here;
  }
  return step;
}

double two_points_mm(const Section& point, double pixel_mm) {
  // How much the depth between two points exceeds what it may be.
  const auto excess = [&](double distance) {
    const double step = 0.5 * point.cell_mm;
    const auto depth = [&](double at) {
      return point.at(at - 0.5 * distance) + point.at(at + 0.5 * distance);
    };
    double left = 0, right = 0;
    for (double at = 0; at < distance; at += step) {
      left = std::max(left, depth(-at));
      right = std::max(right, depth(at));
    }
    double between = depth(0);
    for (double at = -0.5 * distance; at < 0.5 * distance; at += step)
      between = std::min(between, depth(at));
    return between - kDip * std::min(left, right);
  };
  return std::max(2.0 * pixel_mm, least_size_mm(excess, point.cell_mm, 0.0));
}

double wall_mm(const Section& step) {
  const auto error = [&](double width) {
    return std::abs(step.at(0.5 * width) - step.at(-0.5 * width) - 1.0);
  };
  return least_size_mm(error, step.cell_mm, kTolerance);
}

double step_mm(const Section& step) {
  const auto error = [&](double distance) {
    return std::max(std::abs(step.at(distance) - 1.0), std::abs(step.at(-distance)));
  };
  return least_size_mm(error, step.cell_mm, kTolerance);
}

/// Depth in the middle of round pins of radius 0, 1, 2, .. quarters of a cell, the pin's own 1.
std::vector<double> depth_of_pins(const PointResponse& response) {
  constexpr int kReach = PointResponse::kMiddle - 1, kQuarters = 4;
  std::vector<double> depths(kQuarters * kReach, 0.0), entire(depths.size() + 1, 0.0);
  for (int j = -kReach; j <= kReach; ++j)
    for (int i = -kReach; i <= kReach; ++i) {
      // The part of the cell within a radius grows from 0 to 1 over a cell.
      const double first = std::hypot(i, j) - 0.5, value = response.at(i, j);
      auto k = static_cast<std::size_t>(std::max(0.0, std::ceil(kQuarters * first)));
      for (; k < depths.size(); ++k) {
        const double part = static_cast<double>(k) / kQuarters - first;
        if (part >= 1.0) break;
        depths[k] += part * value;
      }
      entire[std::min(k, depths.size())] += value;
    }
  double sum = 0;
  for (std::size_t k = 0; k < depths.size(); ++k) depths[k] += sum += entire[k];
  return depths;
}

double pin_mm(const PointResponse& response) {
  const std::vector<double> depths = depth_of_pins(response);
  const auto error = [&](double diameter) {
    const auto quarters =
        static_cast<std::size_t>(std::lround(2.0 * diameter / response.cell_mm()));
    return std::abs(depths[std::min(quarters, depths.size() - 1)] - 1.0);
  };
  return least_size_mm(error, response.cell_mm(), kTolerance);
}

/// Size of a pixel along the face and across it.
std::optional<Eigen::Vector2d> pixel_size_mm(const FaceShape& shape, const Eigen::Vector2d& pixel) {
  const double u = pixel.x(), v = pixel.y();
  const Eigen::Vector2d size{
      std::abs(shape.position_mm(u + 0.5, v).x() - shape.position_mm(u - 0.5, v).x()),
      std::abs(shape.position_mm(u, v + 0.5).y() - shape.position_mm(u, v - 0.5).y())};
  if (!(size.minCoeff() > 0) || !size.allFinite()) return std::nullopt;
  return size;
}

}  // namespace

std::optional<DepthResolution> depth_resolution_at(const FaceShape& shape,
                                                   const Eigen::Vector2d& position_mm,
                                                   const MappingParameters& mapping,
                                                   const Smoothing& smoothing) {
  const auto pixel = pixel_of_position(shape, position_mm);
  if (!pixel) return std::nullopt;
  const auto sight = sight_in_layer(shape, pixel->x(), pixel->y());
  const auto pixel_mm = pixel_size_mm(shape, *pixel);
  if (!sight || !pixel_mm) return std::nullopt;
  const DepthChain chain(shape, *sight, mapping, smoothing, *pixel_mm);
  const PointResponse response(chain);
  DepthResolution resolution{0, 0, pin_mm(response), 0, {}};
  for (const Axis axis : {Axis::kAlong, Axis::kAcross}) {
    const double px_mm = axis == Axis::kAlong ? pixel_mm->x() : pixel_mm->y();
    const auto take = [](double& largest, double mm) { largest = std::max(largest, mm); };
    take(resolution.two_points_mm, two_points_mm(point_section(response, axis), px_mm));
    const Section step = step_section(response, axis);
    take(resolution.wall_mm, wall_mm(step));
    take(resolution.step_mm, step_mm(step));
  }
  for (int i = 0; i < DepthResolution::kWaves; ++i) {
    const double wave = 2.0 * std::numbers::pi * DepthResolution::wave_per_mm(i);
    resolution.contrasts.push_back(
        std::min(std::abs(chain.gain({wave, 0.0})), std::abs(chain.gain({0.0, wave}))));
  }
  return resolution;
}

}  // namespace alltact
