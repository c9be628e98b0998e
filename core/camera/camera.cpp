#include "core/camera/camera.h"

#include "core/camera/distortion.h"

#include <algorithm>
#include <cassert>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr std::array kModels{std::pair{"pinhole", CameraModel::kPinhole},
                             std::pair{"brown", CameraModel::kBrown},
                             std::pair{"fisheye", CameraModel::kFisheye},
                             std::pair{"orthographic", CameraModel::kOrthographic}};
constexpr std::array kOrientations{std::pair{"none", Orientation::kNone},
                                   std::pair{"flip_u", Orientation::kFlipU},
                                   std::pair{"flip_v", Orientation::kFlipV},
                                   std::pair{"rotate_180", Orientation::kRotate180},
                                   std::pair{"rotate_90", Orientation::kRotate90},
                                   std::pair{"rotate_270", Orientation::kRotate270}};

template <class Words, class Value>
std::string_view word_of(const Words& words, Value value) {
  for (const auto& [word, meaning] : words)
    if (meaning == value) return word;
  assert(false);
  return {};
}

template <class Words>
auto meaning_of(const Words& words, std::string_view word)
    -> std::optional<decltype(words[0].second)> {
  for (const auto& [known, meaning] : words)
    if (known == word) return meaning;
  return std::nullopt;
}

std::size_t coefficient_limit(CameraModel model) {
  switch (model) {
    case CameraModel::kBrown:
      return BrownDistortion::kMaxCoefficients;
    case CameraModel::kFisheye:
      return 4;
    default:
      return 0;
  }
}

std::optional<Error> size_problem(const CameraParameters& p) {
  for (int side : {p.width_px, p.height_px})
    if (side < 16 || side > 16384)
      return Error{en::say("{} x {} px is no image size; each side must be 16 to 16384", p.width_px,
                           p.height_px),
                   std::string("camera.size"),
                   en::say("the size of the camera's images, [width, height]")};
  return std::nullopt;
}

std::optional<Error> scale_problem(const CameraParameters& p) {
  if (p.model == CameraModel::kOrthographic) {
    if (!(p.mm_per_px >= 1e-6 && p.mm_per_px <= 100))
      return Error{en::say("must be a number from 0.000001 to 100"),
                   std::string("camera.mm_per_px"), en::say("millimetres on the object per pixel")};
    return std::nullopt;
  }
  for (const auto& [value, key] : {std::pair{p.fx_px, "camera.fx"}, {p.fy_px, "camera.fy"}})
    if (!(value >= 1 && value <= 1e6))
      return Error{en::say("must be a number from 1 to 1000000"), std::string(key),
                   en::say("the focal length in pixels, as 'alltact lens' finds it")};
  return std::nullopt;
}

std::optional<Error> centre_problem(const CameraParameters& p) {
  for (const auto& [value, side, key] : {std::tuple{p.cx_px, p.width_px, "camera.cx"},
                                         std::tuple{p.cy_px, p.height_px, "camera.cy"}})
    if (!(value >= -side && value <= 2 * side))
      return Error{en::say("must be a number from {} to {}", -side, 2 * side), std::string(key),
                   en::say("the image's centre, or run 'alltact lens'")};
  return std::nullopt;
}

std::optional<Error> sd_problem(const CameraParameters& p) {
  const bool is_possible =
      std::all_of(p.sd_px.begin(), p.sd_px.end(), [](double sd) { return sd >= 0 && sd <= 1000; });
  if (p.sd_px.empty() || (p.sd_px.size() == 4 && is_possible)) return std::nullopt;
  return Error{en::say("must be four numbers from 0 to 1000"), std::string("camera.sd_px"),
               en::say("the standard deviations of fx, fy, cx and cy in pixels, or none")};
}

std::optional<Error> distortion_problem(const CameraParameters& p) {
  const std::size_t limit = coefficient_limit(p.model);
  if (p.distortion.size() > limit) {
    const Message allowed = limit == 0 ? en::say("no") : en::say("at most {}", limit);
    return Error{
        en::say("a {} camera has {} coefficients, here are {}", std::string(to_string(p.model)),
                allowed, p.distortion.size()),
        std::string("camera.distortion"),
        en::say("brown: k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4, fisheye: k1 k2 k3 k4, others: []")};
  }
  for (double k : p.distortion)
    if (!(std::abs(k) <= 1e4))
      return Error{en::say("holds a number that no lens has"), std::string("camera.distortion"),
                   en::say("run 'alltact lens'")};
  return std::nullopt;
}

std::optional<Error> port_problem(const CameraParameters& p) {
  if (!p.port) return std::nullopt;
  if (p.model == CameraModel::kOrthographic)
    return Error{en::say("belongs to a perspective camera; an orthographic one does not need it"),
                 std::string("camera.port"), en::say("leave it out")};
  const Status status = check_port(*p.port);
  if (status) return std::nullopt;
  Error error = status.error();
  error.where = "camera.port." + error.where.english();
  return error;
}

}  // namespace

std::string_view to_string(CameraModel model) { return word_of(kModels, model); }
std::string_view to_string(Orientation orientation) { return word_of(kOrientations, orientation); }
std::optional<CameraModel> camera_model_from(std::string_view word) {
  return meaning_of(kModels, word);
}
std::optional<Orientation> orientation_from(std::string_view word) {
  return meaning_of(kOrientations, word);
}

Result<Camera> Camera::create(const CameraParameters& parameters) {
  for (const auto check :
       {size_problem, scale_problem, centre_problem, sd_problem, distortion_problem, port_problem})
    if (auto problem = check(parameters)) return *problem;
  Camera camera(parameters);
  if (parameters.model == CameraModel::kBrown)
    camera.max_radius_ = BrownDistortion(parameters.distortion).valid_radius();
  if (parameters.model == CameraModel::kFisheye)
    camera.max_radius_ = FisheyeDistortion(parameters.distortion).valid_angle();
  if (camera.folds_in_image())
    return Error{
        en::say("the distortion folds over inside the image: near its border, one pixel would see "
                "two directions"),
        std::string("camera.distortion"),
        en::say("run 'alltact lens' with boards that reach into the corners, or with fewer "
                "coefficients"),
        ErrorKind::kFoldedLens};
  return camera;
}

bool Camera::folds_in_image() const {
  const CameraParameters& p = parameters_;
  const bool is_brown = p.model == CameraModel::kBrown;
  if (!is_brown && p.model != CameraModel::kFisheye) return false;
  if (p.model == CameraModel::kFisheye && max_radius_ >= FisheyeDistortion::kLimit) return false;
  // The valid region has no holes: a border inside it encloses only valid pixels. The border is
  // seen as four smooth curves; its corners, the furthest pixels, are included.
  constexpr int kSamples = 128;
  const double right = p.width_px - 1, bottom = p.height_px - 1;
  for (int i = 0; i <= kSamples; ++i) {
    const double part = static_cast<double>(i) / kSamples;
    for (const Eigen::Vector2d& pixel :
         {Eigen::Vector2d(part * right, 0), Eigen::Vector2d(part * right, bottom),
          Eigen::Vector2d(0, part * bottom), Eigen::Vector2d(right, part * bottom)})
      if (!unproject(pixel)) return true;
  }
  return false;
}

bool Camera::is_linear() const {
  const auto& k = parameters_.distortion;
  return parameters_.model != CameraModel::kFisheye && !parameters_.port &&
         std::all_of(k.begin(), k.end(), [](double value) { return value == 0; });
}

std::optional<Eigen::Vector2d> Camera::project(const Eigen::Vector3d& point_mm) const {
  const CameraParameters& p = parameters_;
  const Eigen::Vector2d centre(p.cx_px, p.cy_px);
  Eigen::Vector2d pixel;
  if (p.model == CameraModel::kOrthographic) {
    pixel = point_mm.head<2>() / p.mm_per_px + centre;
  } else {
    if (!(point_mm.z() > 0)) return std::nullopt;
    const auto direction = p.port ? direction_to(*p.port, point_mm) : std::optional(point_mm);
    if (!direction) return std::nullopt;
    Eigen::Vector2d seen = direction->head<2>() / direction->z();
    if (p.model == CameraModel::kBrown) {
      if (!(seen.norm() < max_radius_)) return std::nullopt;
      seen = BrownDistortion(p.distortion).distort(seen);
    } else if (p.model == CameraModel::kFisheye) {
      if (!(std::atan(seen.norm()) < max_radius_)) return std::nullopt;
      seen = FisheyeDistortion(p.distortion).distort(seen);
    }
    pixel = Eigen::Vector2d(p.fx_px * seen.x(), p.fy_px * seen.y()) + centre;
  }
  if (!pixel.allFinite()) return std::nullopt;
  return pixel;
}

std::optional<Ray> Camera::unproject(const Eigen::Vector2d& pixel) const {
  const CameraParameters& p = parameters_;
  if (!pixel.allFinite()) return std::nullopt;
  const Eigen::Vector2d off_centre = pixel - Eigen::Vector2d(p.cx_px, p.cy_px);
  Ray ray;
  if (p.model == CameraModel::kOrthographic) {
    ray.origin_mm.head<2>() = off_centre * p.mm_per_px;
    return ray;
  }
  const Eigen::Vector2d seen(off_centre.x() / p.fx_px, off_centre.y() / p.fy_px);
  std::optional<Eigen::Vector2d> straight = seen;
  if (p.model == CameraModel::kBrown)
    straight = BrownDistortion(p.distortion).undistort(seen, max_radius_);
  if (p.model == CameraModel::kFisheye)
    straight = FisheyeDistortion(p.distortion).undistort(seen, max_radius_);
  if (!straight) return std::nullopt;
  ray.direction.head<2>() = *straight;
  if (p.port) return ray_through(*p.port, ray.direction);
  return ray;
}

double Camera::mm_per_px_at(double z_mm) const {
  if (!is_perspective()) return parameters_.mm_per_px;
  const auto& port = parameters_.port;
  return (port ? apparent_distance_mm(*port, z_mm) : z_mm) / parameters_.fy_px;
}

double Camera::ray_origin_z_mm(double z_mm) const {
  const auto& port = parameters_.port;
  return port ? port->medium_index * apparent_distance_mm(*port, z_mm) : z_mm;
}

cv::Mat oriented(const cv::Mat& raw, Orientation orientation) {
  cv::Mat turned;
  switch (orientation) {
    case Orientation::kNone:
      return raw;
    case Orientation::kFlipU:
      cv::flip(raw, turned, 1);
      break;
    case Orientation::kFlipV:
      cv::flip(raw, turned, 0);
      break;
    case Orientation::kRotate180:
      cv::flip(raw, turned, -1);
      break;
    case Orientation::kRotate90:
      cv::rotate(raw, turned, cv::ROTATE_90_CLOCKWISE);
      break;
    case Orientation::kRotate270:
      cv::rotate(raw, turned, cv::ROTATE_90_COUNTERCLOCKWISE);
      break;
  }
  return turned;
}

Result<cv::Mat> oriented_for(const CameraParameters& camera, const cv::Mat& raw,
                             const Message& what, const Where& where, const Message& advice) {
  cv::Mat turned = oriented(raw, camera.orientation);
  if (turned.size() == cv::Size(camera.width_px, camera.height_px)) return turned;
  return Error{en::say("{} is {} x {} px, the camera of this finger gives {} x {}", what,
                       turned.cols, turned.rows, camera.width_px, camera.height_px),
               where, advice};
}

namespace {

/// With a = tan of the angle in air, its tangent in a medium of index n >= 1, where sin = a /
/// sqrt(1 + a^2) is n times smaller. Written without a difference that cancels.
double tangent_in(double index, double a) {
  return a / std::sqrt(index * index + (index - 1) * (index + 1) * a * a);
}

/// Derivative of tangent_in() by a.
double tangent_slope_in(double index, double a) {
  const double root = std::sqrt(index * index + (index - 1) * (index + 1) * a * a);
  return index * index / (root * root * root);
}

constexpr double kSteepest = 1000;  // tangent of 89.9 degrees

}  // namespace

Status check_port(const FlatPort& port) {
  for (const auto& [value, key] : {std::pair{port.gap_mm, "gap_mm"}, {port.plate_mm, "plate_mm"}})
    if (!(value >= 0 && value <= 1000))
      return Error{en::say("must be a length from 0 to 1000 mm"), std::string(key),
                   en::say("a caliper's reading")};
  for (const auto& [value, key] :
       {std::pair{port.plate_index, "plate_index"}, {port.medium_index, "medium_index"}})
    if (!(value >= 1 && value <= 3))
      return Error{en::say("must be an index of refraction from 1 to 3"), std::string(key),
                   en::say("1 for air, 1.33 water, 1.41 silicone, 1.49 acrylic, 1.52 glass")};
  return {};
}

std::optional<Ray> ray_through(const FlatPort& port, const Eigen::Vector3d& air_direction) {
  if (!(air_direction.z() > 0)) return std::nullopt;
  const Eigen::Vector2d aside = air_direction.head<2>() / air_direction.z();
  const double a = aside.norm();
  if (!(a <= kSteepest)) return std::nullopt;
  Ray ray;
  if (a == 0) return ray;
  const Eigen::Vector2d outward = aside / a;
  const double slope = tangent_in(port.medium_index, a);
  const double leaves = port.gap_mm * a + port.plate_mm * tangent_in(port.plate_index, a);
  ray.origin_mm.head<2>() = outward * (leaves - slope * (port.gap_mm + port.plate_mm));
  ray.direction.head<2>() = outward * slope;
  return ray;
}

std::optional<Eigen::Vector3d> direction_to(const FlatPort& port, const Eigen::Vector3d& point_mm) {
  const double in_medium = point_mm.z() - port.gap_mm - port.plate_mm;
  if (!(in_medium > 0)) return std::nullopt;
  const double radius = point_mm.head<2>().norm();
  if (radius == 0) return Eigen::Vector3d::UnitZ();
  // The radius reached grows with a and its slope falls: from the left Newton never oversteps.
  const auto reached = [&](double a) {
    return port.gap_mm * a + port.plate_mm * tangent_in(port.plate_index, a) +
           in_medium * tangent_in(port.medium_index, a);
  };
  if (!(reached(kSteepest) >= radius)) return std::nullopt;
  double low = 0, high = kSteepest, a = 0;
  constexpr int kSteps = 200;
  for (int step = 0; step < kSteps; ++step) {
    const double missing = radius - reached(a);
    (missing >= 0 ? low : high) = a;
    if (missing == 0) break;
    const double slope = port.gap_mm + port.plate_mm * tangent_slope_in(port.plate_index, a) +
                         in_medium * tangent_slope_in(port.medium_index, a);
    double next = a + missing / slope;
    if (!(next >= low && next <= high)) next = low + (high - low) / 2;
    if (std::abs(next - a) <= 1e-16 * a) break;
    a = next;
  }
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  direction.head<2>() = point_mm.head<2>() * (a / radius);
  return direction;
}

double apparent_distance_mm(const FlatPort& port, double z_mm) {
  return port.gap_mm + port.plate_mm / port.plate_index +
         (z_mm - port.gap_mm - port.plate_mm) / port.medium_index;
}

Status check_camera_range(const CameraParameters& p) {
  if (const auto camera = Camera::create(p); !camera) return camera.error();
  const int side = std::max(p.width_px, p.height_px);
  if (p.model == CameraModel::kOrthographic) {
    constexpr double kMinMm = 0.1, kMaxMm = 10000;
    if (p.mm_per_px * side >= kMinMm && p.mm_per_px * side <= kMaxMm) return {};
    return Error{en::say("must be a number from {:g} to {:g}", kMinMm / side, kMaxMm / side),
                 std::string("camera.mm_per_px"), en::say("millimetres on the object per pixel")};
  }
  constexpr double kWidest = 0.05, kNarrowest = 10, kSquare = 2;
  for (const auto& [value, other, key] :
       {std::tuple{p.fx_px, p.fy_px, "camera.fx"}, {p.fy_px, p.fx_px, "camera.fy"}}) {
    double low = kWidest * side, high = kNarrowest * side;
    // Where the other focal length is impossible itself, only that one is reported.
    if (other >= low && other <= high) {
      low = std::max(low, other / kSquare);
      high = std::min(high, other * kSquare);
    }
    if (!(value >= low && value <= high))
      return Error{en::say("must be a number from {:g} to {:g}", low, high), std::string(key),
                   en::say("the focal length in pixels, as 'alltact lens' finds it")};
  }
  return {};
}

std::vector<Error> implausible_camera(const CameraParameters& p) {
  std::vector<Error> all;
  if (p.model == CameraModel::kOrthographic) return all;
  constexpr double kShortest = 0.2, kLongest = 4;  // relative to the longer side
  constexpr double kRim = 0.2;                     // relative to each side
  const double side = std::max(p.width_px, p.height_px);
  const auto check = [&all](const char* key, double value, double low, double high) {
    if (!(value >= low && value <= high))
      all.push_back({en::say("{:g} px is unusual ({:g} to {:g} px): check the decimal mark", value,
                             low, high),
                     std::string(key), ""});
  };
  check("camera.fx", p.fx_px, kShortest * side, kLongest * side);
  check("camera.fy", p.fy_px, kShortest * side, kLongest * side);
  check("camera.cx", p.cx_px, kRim * p.width_px, (1 - kRim) * p.width_px);
  check("camera.cy", p.cy_px, kRim * p.height_px, (1 - kRim) * p.height_px);
  return all;
}

cv::Mat reduced_image(const cv::Mat& grey, int by) {
  CV_Assert(grey.type() == CV_8UC1 && by >= 1);
  if (by == 1) return grey;
  const cv::Size size(grey.cols / by, grey.rows / by);
  cv::Mat reduced;
  cv::resize(grey({0, 0, size.width * by, size.height * by}), reduced, size, 0, 0, cv::INTER_AREA);
  return reduced;
}

CameraParameters reduced_camera(const CameraParameters& camera, int by) {
  CameraParameters reduced = camera;
  reduced.width_px /= by;
  reduced.height_px /= by;
  reduced.fx_px /= by;
  reduced.fy_px /= by;
  reduced.cx_px = reduced_px(camera.cx_px, by);
  reduced.cy_px = reduced_px(camera.cy_px, by);
  reduced.mm_per_px *= by;
  for (double& sd : reduced.sd_px) sd /= by;
  return reduced;
}

}  // namespace alltact
