#include "calibration/study/painted_press.h"

#include "core/sensing/contact/contact_geometry.h"
#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/depth/depth_cells.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace alltact {
namespace {

constexpr double kMaxDepthFraction = 0.8;  // of the depth range of the calibration
constexpr double kMinDepthMm = 0.15;       // still distinguishable from zero
constexpr std::uint32_t kMaxTries = 20;    // to find a valid position
constexpr double kBarRadiusPart = 0.5;     // of the ball's
constexpr double kBarHalfLengthMm = 3.0;
constexpr double kBarDepthMm = 0.5;

std::optional<double> distance_to_ball(const Eigen::Vector3d& centre_mm,
                                       double radius_mm,
                                       const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& direction) {
  const Eigen::Vector3d to_centre = centre_mm - from;
  const double along = to_centre.dot(direction);
  const double off2 = (to_centre - along * direction).squaredNorm();
  const double inside = radius_mm * radius_mm - off2;
  if (inside <= 0) return std::nullopt;
  return along - std::sqrt(inside);
}

// The body's middle part, without its ends.
std::optional<double> distance_to_cylinder(const PaintedBody& body,
                                           const Eigen::Vector3d& from,
                                           const Eigen::Vector3d& direction) {
  const auto across = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
    return v - v.dot(body.axis) * body.axis;
  };
  const Eigen::Vector3d off = across(from - body.centre_mm), step = across(direction);
  const double a = step.squaredNorm(), b = off.dot(step);
  const double root = b * b - a * (off.squaredNorm() - body.radius_mm * body.radius_mm);
  if (!(a > 1e-12) || root <= 0) return std::nullopt;
  const double t = (-b - std::sqrt(root)) / a;
  const double along = (from + t * direction - body.centre_mm).dot(body.axis);
  if (std::abs(along) > body.half_length_mm) return std::nullopt;
  return t;
}

// Thinning of the layer over a view-face point: along the mapping's direction, and along z.
struct Thinning {
  double of_mapping_mm = 0, along_z_mm = 0;
};

Thinning thinning(const FaceShape::Local& local,
                  const PaintedBody& body,
                  double layer_mm,
                  MappingAlong along) {
  Thinning thinner;
  const double layer_z_mm = layer_mm / local.cos_incline;
  if (const auto z = distance_to_body(body, local.view_point_mm, Eigen::Vector3d::UnitZ()))
    thinner.along_z_mm = std::clamp(layer_z_mm - *z, 0.0, layer_z_mm);
  switch (along) {
    case MappingAlong::kZ:
      thinner.of_mapping_mm = thinner.along_z_mm;
      break;
    case MappingAlong::kProjected:
      thinner.of_mapping_mm = thinner.along_z_mm * local.cos_incline;
      break;
    case MappingAlong::kNormal:
      if (const auto n = distance_to_body(body, local.view_point_mm, local.normal))
        thinner.of_mapping_mm = std::clamp(layer_mm - *n, 0.0, layer_mm);
      break;
  }
  return thinner;
}

// At a z drawn evenly within the zone; where all columns have the same z, at a random column.
std::optional<int> column_in(FaceZone zone, const FaceShape& shape, StudyDraws& draws) {
  const auto& columns = shape.columns();
  std::vector<int> valid;
  for (int u = 0; u < shape.width_px(); ++u)
    if (columns[static_cast<std::size_t>(u)].valid) valid.push_back(u);
  if (valid.empty()) return std::nullopt;
  const auto z_of = [&](int u) { return columns[static_cast<std::size_t>(u)].z_mm; };
  const auto [nearest, farthest] = std::minmax_element(
      valid.begin(), valid.end(), [&](int a, int b) { return z_of(a) < z_of(b); });
  const double part =
      (static_cast<double>(zone) + draws.uniform()) / static_cast<double>(kFaceZones);
  const double range_mm = z_of(*farthest) - z_of(*nearest);
  if (range_mm <= 0)
    return valid[static_cast<std::size_t>(part * static_cast<double>(valid.size()))];
  const double z_mm = z_of(*nearest) + part * range_mm;
  return *std::min_element(valid.begin(), valid.end(), [&](int a, int b) {
    return std::abs(z_of(a) - z_mm) < std::abs(z_of(b) - z_mm);
  });
}

// Position of the greatest depth in the ground truth.
std::optional<Eigen::Vector2d> deepest_position(const cv::Mat& depth_mm,
                                                const FaceShape& shape,
                                                const Face& face) {
  DepthMap truth;
  truth.depth_mm = depth_mm;
  truth.flags = cv::Mat::zeros(depth_mm.size(), CV_8UC1);
  truth.cells_mm = depth_cells(truth.depth_mm);
  const auto regions = contact_regions(truth, shape, face, RegionOptions{});
  if (regions.empty()) return std::nullopt;
  return regions.front().deepest_on_face_mm;
}

}  // namespace

std::optional<double> distance_to_body(const PaintedBody& body,
                                       const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& direction) {
  if (body.half_length_mm <= 0)
    return distance_to_ball(body.centre_mm, body.radius_mm, from, direction);
  std::optional<double> first = distance_to_cylinder(body, from, direction);
  for (const double end : {-body.half_length_mm, body.half_length_mm}) {
    const auto there =
        distance_to_ball(body.centre_mm + end * body.axis, body.radius_mm, from, direction);
    if (there && (!first || *there < *first)) first = there;
  }
  return first;
}

struct PressPainter::Spot {
  FaceShape::Local local;
  Eigen::Vector3d outer_mm;
  double u, v;
};

PressPainter::PressPainter(const FingerSnapshot& finger, double radius_mm)
    : finger_(finger), mapping_(*finger.mapping), radius_mm_(radius_mm) {
  deepest_mm_ = std::min(kMaxDepthFraction * mapping_.depth_mm(mapping_.x_max()),
                         kMaxDepthFraction * finger.finger.face.layer_mm);
}

std::optional<PressPainter::Spot> PressPainter::spot_on(const FaceShape& shape,
                                                        StudyDraws& draws,
                                                        FaceZone zone) const {
  for (std::uint32_t tried = 0; tried < kMaxTries; ++tried) {
    const auto u = column_in(zone, shape, draws);
    if (!u) continue;
    const FaceColumn& column = shape.columns()[static_cast<std::size_t>(*u)];
    const double v =
        column.upper_v + (0.2 + 0.6 * draws.uniform()) * (column.lower_v - column.upper_v);
    const auto local = shape.at(*u, v);
    if (!local) continue;
    return Spot{*local,
                local->view_point_mm + finger_.finger.face.layer_mm * local->normal,
                static_cast<double>(*u),
                v};
  }
  return std::nullopt;
}

std::optional<StudyFrame> PressPainter::ball(const cv::Mat& grey,
                                             const FaceShape& shape,
                                             StudyDraws& draws,
                                             FaceZone zone) const {
  const auto spot = spot_on(shape, draws, zone);
  if (!spot) return std::nullopt;
  const double depth_mm = kMinDepthMm + draws.uniform() * (deepest_mm_ - kMinDepthMm);
  PaintedBody body;
  body.centre_mm = spot->outer_mm + (radius_mm_ - depth_mm) * spot->local.normal;
  body.radius_mm = radius_mm_;
  StudyFrame frame = painted_with(body, zone, grey, shape);
  frame.position_mm = deepest_position(frame.depth_mm, shape, finger_.finger.face);
  return frame;
}

std::optional<StudyFrame> PressPainter::bar(const cv::Mat& grey,
                                            const FaceShape& shape,
                                            StudyDraws& draws,
                                            FaceZone zone) const {
  const double depth_mm = std::min(kBarDepthMm, deepest_mm_);
  const auto is_on_face = [&](const Eigen::Vector3d& point_mm) {
    const auto pixel = shape.camera().project(point_mm);
    return pixel && pixel->x() >= 0 && pixel->x() <= grey.cols - 1 && pixel->y() >= 0 &&
           pixel->y() <= grey.rows - 1 && shape.at(pixel->x(), pixel->y());
  };
  for (std::uint32_t tried = 0; tried < kMaxTries; ++tried) {
    const auto spot = spot_on(shape, draws, zone);
    if (!spot) continue;
    const auto plane = contact_plane(shape, {spot->u, spot->v});
    const double angle_rad = M_PI * (draws.uniform() - 0.5);
    if (!plane) continue;
    PaintedBody body;
    body.radius_mm = kBarRadiusPart * radius_mm_;
    body.half_length_mm = kBarHalfLengthMm;
    body.axis = *plane * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
    body.centre_mm = spot->outer_mm + (body.radius_mm - depth_mm) * spot->local.normal;
    // A bar that the face's end cuts off has another angle.
    const Eigen::Vector3d to_end = (body.half_length_mm + body.radius_mm) * body.axis;
    if (!is_on_face(spot->local.view_point_mm + to_end) ||
        !is_on_face(spot->local.view_point_mm - to_end))
      continue;
    StudyFrame frame = painted_with(body, zone, grey, shape);
    frame.angle_deg = 180.0 / M_PI * angle_rad;
    return frame;
  }
  return std::nullopt;
}

StudyFrame PressPainter::painted_with(const PaintedBody& body,
                                      FaceZone zone,
                                      const cv::Mat& grey,
                                      const FaceShape& shape) const {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  const MappingParameters& parameters = mapping_.parameters();
  StudyFrame frame;
  frame.depth_mm = cv::Mat(grey.size(), CV_32FC1, cv::Scalar(kNaN));
  frame.zone = zone;
  cv::Mat indented = grey.clone();
  for (int v = 0; v < grey.rows; ++v)
    for (int u = 0; u < grey.cols; ++u) {
      const auto local = shape.at(u, v);
      if (!local) continue;
      const Thinning thinner =
          thinning(*local, body, finger_.finger.face.layer_mm, parameters.along);
      frame.depth_mm.at<float>(v, u) = static_cast<float>(thinner.along_z_mm);
      if (thinner.of_mapping_mm <= 0) continue;
      const double factor =
          parameters.variation.is_none() ? 1.0 : parameters.variation.at(shape.position_mm(u, v));
      const double x = mapping_.difference_at(thinner.of_mapping_mm / factor);
      indented.at<std::uint8_t>(v, u) =
          static_cast<std::uint8_t>(std::lround(grey.at<std::uint8_t>(v, u) * (1 - x)));
    }
  auto image = std::make_shared<Frame>();
  image->grey = std::move(indented);
  frame.image = std::move(image);
  return frame;
}

}  // namespace alltact
