#include "core/thumbnail/thumbnail.h"

#include "core/image/colour_map.h"
#include "core/image/image_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kMinDepth_mm = 0.1;
constexpr int kSupersample = 3;                        // each pixel is the mean of so many a side
const Eigen::Vector3d kPlainColour(0.62, 0.66, 0.72);  // red, green, blue of a mesh without depth

double deepest(double deepest_mm, float depth_mm) {
  return std::isfinite(depth_mm) ? std::max<double>(deepest_mm, depth_mm) : deepest_mm;
}

/// Averages colours times opacity, so that transparent pixels do not count.
cv::Mat downsample(const cv::Mat& premultiplied, cv::Size size) {
  cv::Mat mean, image(size, CV_8UC4);
  cv::resize(premultiplied, mean, size, 0, 0, cv::INTER_AREA);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const auto& from = mean.at<cv::Vec4f>(v, u);
      const float share = from[3] > 0 ? 1 / from[3] : 0;
      for (int c = 0; c < 3; ++c)
        image.at<cv::Vec4b>(v, u)[c] = cv::saturate_cast<std::uint8_t>(255 * share * from[c]);
      image.at<cv::Vec4b>(v, u)[3] = cv::saturate_cast<std::uint8_t>(255 * from[3]);
    }
  }
  return image;
}

Eigen::Vector3d colour_of(double part) {
  const MapColour colour = depth_colour(part);
  return Eigen::Vector3d(colour.red, colour.green, colour.blue) / 255;
}

/// Projected points: x to the right, y downwards, z away, in pixels.
struct ProjectedMesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> colours;
};

/// x along the longest direction, z along the flattest, viewed from the side that most faces point
/// to.
Eigen::Matrix3d look_at(const Triangles& triangles, const Eigen::Vector3d& middle) {
  const auto point = [&](std::int32_t corner) {
    const cv::Vec3f& p = triangles.points_mm[static_cast<std::size_t>(corner)];
    return Eigen::Vector3d(p[0], p[1], p[2]);
  };
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Eigen::Vector3d facing = Eigen::Vector3d::Zero();
  for (const auto& [a, b, c] : triangles.corners) {
    const Eigen::Vector3d normal = (point(b) - point(a)).cross(point(c) - point(a));
    const Eigen::Vector3d centre = (point(a) + point(b) + point(c)) / 3 - middle;
    spread += normal.norm() * centre * centre.transpose();
    facing += normal;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  Eigen::Vector3d along = axes.eigenvectors().col(2), away = axes.eigenvectors().col(0);
  if (away.dot(facing) > 0 || (away.dot(facing) == 0 && away.sum() < 0)) away = -away;
  if (along.sum() < 0) along = -along;
  const Eigen::Vector3d down = away.cross(along);
  Eigen::Matrix3d view_axes;
  view_axes << along.transpose(), down.transpose(), away.transpose();
  constexpr double kTilt_rad = 40 * M_PI / 180, kTurn_rad = 20 * M_PI / 180;
  return Eigen::AngleAxisd(-kTilt_rad, Eigen::Vector3d::UnitX()).toRotationMatrix() *
         Eigen::AngleAxisd(kTurn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix() * view_axes;
}

ProjectedMesh project_mesh(const Triangles& triangles, int size_px) {
  Eigen::AlignedBox3d box;
  for (const cv::Vec3f& p : triangles.points_mm) box.extend(Eigen::Vector3d(p[0], p[1], p[2]));
  const Eigen::Vector3d middle = box.center();
  const Eigen::Matrix3d view = look_at(triangles, middle);
  ProjectedMesh projected;
  Eigen::AlignedBox3d shown;
  for (const cv::Vec3f& p : triangles.points_mm) {
    projected.points.emplace_back(view * (Eigen::Vector3d(p[0], p[1], p[2]) - middle));
    shown.extend(projected.points.back());
  }
  const double larger = std::max({shown.sizes().x(), shown.sizes().y(), 1e-12});
  constexpr double kFilled = 0.94;
  const double scale = kFilled * size_px / larger;
  for (Eigen::Vector3d& p : projected.points)
    p = scale * (p - shown.center()) + Eigen::Vector3d(0.5, 0.5, 0) * size_px;
  double top_mm = kMinDepth_mm;
  for (const float depth : triangles.depth_mm) top_mm = deepest(top_mm, depth);
  for (const float depth : triangles.depth_mm)
    projected.colours.push_back(std::isfinite(depth) ? colour_of(depth / top_mm) : kPlainColour);
  return projected;
}

/// Rasterises triangles with a depth buffer.
class Painter {
 public:
  explicit Painter(int size_px)
      : image_(size_px, size_px, CV_32FC4, cv::Scalar::all(0)),
        nearest_(size_px, size_px, std::numeric_limits<double>::max()) {}

  void paint(const std::array<Eigen::Vector3d, 3>& at, const Eigen::Vector3d& colour) {
    const Eigen::Vector3d normal = (at[1] - at[0]).cross(at[2] - at[0]);
    const double area = normal.z();
    if (!(std::abs(area) > 1e-9)) return;
    static const Eigen::Vector3d kLight = Eigen::Vector3d(-0.45, -0.6, -0.66).normalized();
    // Both sides are lit: an open face has no inside.
    const double lit = std::abs(normal.normalized().dot(kLight));
    const Eigen::Vector3d shade = colour * (0.35 + 0.65 * lit);
    const auto range = [&](int axis) {
      const auto [low, high] = std::minmax({at[0][axis], at[1][axis], at[2][axis]});
      const int last = image_.rows - 1;
      return std::pair(std::clamp(static_cast<int>(std::floor(low)), 0, last),
                       std::clamp(static_cast<int>(std::ceil(high)), 0, last));
    };
    const auto [left, right] = range(0);
    const auto [top, bottom] = range(1);
    for (int v = top; v <= bottom; ++v)
      for (int u = left; u <= right; ++u) draw_pixel(at, area, {u + 0.5, v + 0.5}, shade, u, v);
  }
  [[nodiscard]] const cv::Mat& image() const { return image_; }

 private:
  void draw_pixel(const std::array<Eigen::Vector3d, 3>& at, double area,
                  const Eigen::Vector2d& pixel, const Eigen::Vector3d& shade, int u, int v) {
    double z = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector2d from = at[(k + 1) % 3].head<2>() - pixel,
                            to = at[(k + 2) % 3].head<2>() - pixel;
      const double share = (from.x() * to.y() - from.y() * to.x()) / area;
      if (share < 0) return;
      z += share * at[k].z();
    }
    if (!(z < nearest_(v, u))) return;
    nearest_(v, u) = z;
    image_.at<cv::Vec4f>(v, u) =
        cv::Vec4f(static_cast<float>(shade.z()), static_cast<float>(shade.y()),
                  static_cast<float>(shade.x()), 1.0F);
  }

  cv::Mat image_;
  cv::Mat_<double> nearest_;
};

}  // namespace

cv::Mat depth_thumbnail(const cv::Mat& depth_mm, int size_px) {
  CV_Assert(depth_mm.type() == CV_32FC1 && !depth_mm.empty() && size_px > 0);
  double top_mm = kMinDepth_mm;
  for (int v = 0; v < depth_mm.rows; ++v)
    for (int u = 0; u < depth_mm.cols; ++u) top_mm = deepest(top_mm, depth_mm.at<float>(v, u));
  cv::Mat colours(depth_mm.size(), CV_32FC4, cv::Scalar::all(0));
  for (int v = 0; v < depth_mm.rows; ++v) {
    for (int u = 0; u < depth_mm.cols; ++u) {
      const float depth = depth_mm.at<float>(v, u);
      if (!std::isfinite(depth)) continue;
      const Eigen::Vector3f colour = colour_of(depth / top_mm).cast<float>();
      colours.at<cv::Vec4f>(v, u) = {colour.z(), colour.y(), colour.x(), 1.0F};
    }
  }
  const double scale = static_cast<double>(size_px) / std::max(depth_mm.cols, depth_mm.rows);
  const auto side = [&](int length) {
    return std::max(1, static_cast<int>(std::lround(scale * length)));
  };
  return downsample(colours, {side(depth_mm.cols), side(depth_mm.rows)});
}

cv::Mat mesh_thumbnail(const Triangles& triangles, int size_px) {
  CV_Assert(!triangles.corners.empty() && size_px > 0);
  const ProjectedMesh projected = project_mesh(triangles, kSupersample * size_px);
  Painter painter(kSupersample * size_px);
  for (const auto& corners : triangles.corners) {
    std::array<Eigen::Vector3d, 3> at;
    Eigen::Vector3d colour = projected.colours.empty() ? kPlainColour : Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::size_t>(corners[k]);
      at[k] = projected.points[corner];
      if (!projected.colours.empty()) colour += projected.colours[corner] / 3;
    }
    painter.paint(at, colour);
  }
  return downsample(painter.image(), {size_px, size_px});
}

Result<cv::Mat> thumbnail_of(const std::filesystem::path& file, int size_px) {
  const std::string name = file.filename().string();
  if (name.ends_with(".tiff") || name.ends_with(".png")) {
    auto depth = name.ends_with(".png") ? read_depth_png(file) : read_float_image(file);
    if (depth && depth->type() != CV_32FC1)
      return Error{en::say("these are points, no depth"), file.string(),
                   en::say("NAME.depth.tiff")};
    if (!depth) return depth.error();
    return depth_thumbnail(*depth, size_px);
  }
  const auto triangles = read_triangles(file);
  if (!triangles) return triangles.error();
  return mesh_thumbnail(*triangles, size_px);
}

}  // namespace alltact
