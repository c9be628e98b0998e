// Presses whose answer is known: a ball, skin that follows it or leaves it, a scattering layer,
// noise. Written from the physics alone; shares no formula with the code under test.
#pragma once

#include "calibration/presses/press.h"
#include "tests/support/cameras.h"

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

namespace alltact::made {

struct MadeScene {
  Camera camera;
  Face face;
  FaceShape shape;
  Eigen::Vector3d normal;  ///< outward
};

/// A flat sensor, orthographic.
inline MadeScene flat_scene(double mm_per_px = 0.05, int width = 400, int height = 300) {
  CameraParameters p;
  p.model = CameraModel::kOrthographic;
  p.width_px = width;
  p.height_px = height;
  p.cx_px = 0.5 * width;
  p.cy_px = 0.5 * height;
  p.mm_per_px = mm_per_px;
  Face face;
  face.kind = FaceKind::kFlat;
  face.layer_mm = 1.5;
  face.plane_z_mm = 20.0;
  const Camera camera = Camera::create(p).value();
  return {camera, face, FaceShape::plane(camera, face), Eigen::Vector3d::UnitZ()};
}

/// A straight Fin Ray face seen in perspective: z = z0 + x tan(incline), from its two edges.
inline MadeScene finger_scene(double z0_mm, double incline_deg) {
  const CameraParameters p = pinhole();
  Face face;
  face.width_mm = 24.0;
  face.layer_mm = 1.5;
  const Camera camera = Camera::create(p).value();
  const double slope = std::tan(incline_deg * M_PI / 180.0);
  FaceEdges edges;
  for (double u = 3.5; u < 960; u += 8.0) {
    const double z = z0_mm / (1.0 - slope * (u - p.cx_px) / p.fx_px);
    const double half = 0.5 * face.width_mm * p.fy_px / z;
    edges.u.push_back(u);
    for (auto [edge, sign] : {std::pair{&edges.upper, -1.0}, std::pair{&edges.lower, 1.0}}) {
      edge->v.push_back(p.cy_px + sign * half);
      edge->sd.push_back(0.05);
      edge->valid.push_back(p.cy_px - half > 1.0 && z > 10.0);
    }
  }
  return {camera, face, FaceShape::fit(edges, camera, face, 7).value(),
          Eigen::Vector3d(-slope, 0.0, 1.0).normalized()};
}

enum class Skin { kSharp, kSmooth, kTail, kHertz };

/// How the skin goes from the ball to the untouched face.
struct Contact {
  Skin skin = Skin::kSharp;
  double size = 0;      ///< smooth: mm; tail: part of the rim's radius where the skin leaves
  double bulge_mm = 0;  ///< height of a bright ring outside
};

/// Depth of the skin along the normal against the distance from the contact's middle.
class Relief {
 public:
  Relief(Contact contact, double radius_mm, double depth_mm) {
    const double rim = std::sqrt(depth_mm * (2.0 * radius_mm - depth_mm));
    const auto cap = [&](double r) {
      return std::sqrt(std::max(0.0, radius_mm * radius_mm - r * r)) - (radius_mm - depth_mm);
    };
    const double a = std::sqrt(radius_mm * depth_mm);
    const double leave = contact.size * rim;
    for (int i = 0; i < kSteps; ++i) {
      const double r = i * kStepMm;
      double h = std::max(0.0, cap(r));
      if (contact.skin == Skin::kHertz && r > a) {
        const double q = r / a;
        const double u = ((2.0 - q * q) * std::asin(1.0 / q) + std::sqrt(q * q - 1.0)) / M_PI;
        h = cap(a) * u / 0.5;
      }
      if (contact.skin == Skin::kTail && r > leave) {
        const double slope = leave / std::sqrt(radius_mm * radius_mm - leave * leave);
        h = cap(leave) * std::exp(-slope * (r - leave) / cap(leave));
      }
      if (contact.skin == Skin::kSmooth) h = smoothed(cap, r, contact.size);
      const double ring = (r - (contact.skin == Skin::kHertz ? a : rim) - 1.0) / 0.6;
      h_[static_cast<std::size_t>(i)] = h - contact.bulge_mm * std::exp(-ring * ring);
    }
  }
  double operator()(double r) const {
    const double at = std::min(r / kStepMm, kSteps - 1.001);
    const auto i = static_cast<std::size_t>(at);
    return h_[i] + (at - static_cast<double>(i)) * (h_[i + 1] - h_[i]);
  }

 private:
  static constexpr int kSteps = 1000;
  static constexpr double kStepMm = 0.01;
  std::array<double, kSteps> h_{};

  template <class Cap>
  static double smoothed(const Cap& cap, double r, double sd) {
    constexpr int kHalf = 5;
    double sum = 0, weight = 0;
    for (int i = -kHalf; i <= kHalf; ++i) {
      for (int j = -kHalf; j <= kHalf; ++j) {
        const double x = 3.0 * i / kHalf, y = 3.0 * j / kHalf;
        const double w = std::exp(-0.5 * (x * x + y * y));
        sum += w * std::max(0.0, cap(std::hypot(r + sd * x, sd * y)));
        weight += w;
      }
    }
    return sum / weight;
  }
};

/// Kubelka-Munk layer over black: s = scattering times thickness, k = absorption / scattering.
struct Layer {
  double s = 0.6, k = 0.02;
  double thickness_mm = 1.5;
  MappingAlong along = MappingAlong::kZ;
  /// Uneven light or scattering: it takes (1 + uneven . p) times the depth to get as dark, p from
  /// -1 to 1 over the picture's width and height.
  Eigen::Vector2d uneven = Eigen::Vector2d::Zero();

  double reflectance(double t_mm) const {
    const double scatter = s / thickness_mm;
    if (k == 0.0) return scatter * t_mm / (1.0 + scatter * t_mm);
    const double a = 1.0 + k, b = std::sqrt(a * a - 1.0);
    return std::sinh(b * scatter * t_mm) /
           (a * std::sinh(b * scatter * t_mm) + b * std::cosh(b * scatter * t_mm));
  }
  double difference_at(double depth_mm) const {
    const double left = std::max(0.02, thickness_mm - depth_mm);
    return 1.0 - reflectance(left) / reflectance(thickness_mm);
  }
  double depth_at(double x) const {
    double low = -1.0, high = thickness_mm;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (difference_at(middle) < x ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
};

struct Made {
  Press press;
  Eigen::Vector3d centre_mm;
};

struct Ball {
  double u, v;  ///< pixel whose point of the face is the contact's middle
  double radius_mm = 4.0;
  double depth_mm = 0.8;  ///< along the normal
};

/// Every pixel of a picture.
inline FaceRuns whole_picture_runs(const cv::Size& size) {
  FaceRuns face;
  for (int row = 0; row < size.height; ++row) {
    face.row_begin.push_back(static_cast<std::uint32_t>(row));
    face.runs.push_back({row, 0, size.width, static_cast<std::uint32_t>(row * size.width)});
  }
  face.row_begin.push_back(static_cast<std::uint32_t>(size.height));
  return face;
}

/// Adds noise as after smoothing, and gives x the form of a difference. `noise`: standard deviation
/// of a grey level at a brightness of 120.
inline Difference noisy_difference(cv::Mat x, cv::Mat grain, double noise) {
  cv::GaussianBlur(grain, grain, {7, 7}, 1.0);
  for (int v = 0; v < x.rows; ++v)
    for (int u = 0; u < x.cols; ++u) {
      float& value = x.at<float>(v, u);
      value +=
          static_cast<float>(noise / 120.0 * std::hypot(1.0, 1.0 - static_cast<double>(value))) *
          grain.at<float>(v, u);
    }
  Difference difference;
  difference.x = x;
  difference.flags = cv::Mat(x.size(), CV_8UC1, cv::Scalar(kMeasured));
  difference.face = whole_picture_runs(x.size());
  return difference;
}

/// A flat punch of two levels: the straight line at `turn_deg` through its middle parts them.
struct Punch {
  double u, v;  ///< pixel whose point of the face lies over its middle
  double step_mm = 0.5;
  double depth_mm = 1.0;  ///< of the deeper level's middle, along the normal
  double turn_deg = 20.0;
  double tilt_first = 0.02, tilt_second = -0.03;     ///< of the whole punch against the face
  double half_length_mm = 6.5, half_width_mm = 5.0;  ///< across and along the line
  double back_mm = 0.25;  ///< over which the skin comes back from an edge
};

/// How deep the skin lies over a punch, along the normal; `at`: from its middle, mm.
inline double depth_over(const Punch& punch, const Eigen::Vector2d& at) {
  const double turn = punch.turn_deg * M_PI / 180.0;
  const double across = std::cos(turn) * at.x() + std::sin(turn) * at.y();
  const double along = -std::sin(turn) * at.x() + std::cos(turn) * at.y();
  const double lowered =
      across < 0.0 ? 0.0 : punch.step_mm * (1.0 - std::exp(-across / punch.back_mm));
  const double plane = punch.depth_mm + punch.tilt_first * at.x() + punch.tilt_second * at.y();
  const double outside = std::hypot(std::max(0.0, std::abs(across) - punch.half_length_mm),
                                    std::max(0.0, std::abs(along) - punch.half_width_mm));
  return std::max(0.0, plane - lowered) * std::exp(-outside / punch.back_mm);
}

/// The brightness difference of a skin whose depth along the normal is `depth_of(point)`, a point
/// of the untouched outer side; along z.
template <class DepthOf>
cv::Mat difference_of(const MadeScene& scene, const Layer& layer, const DepthOf& depth_of) {
  const cv::Size size = scene.camera.size();
  cv::Mat x(size, CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  const Eigen::Vector3d back(0.0, 0.0, 1.0);
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u) {
      const auto local = scene.shape.at(u, v);
      const auto rows = scene.shape.rows(u, 2.0);
      if (!local || v < rows.first || v > rows.last) continue;
      const Eigen::Vector3d from =
          local->view_point_mm + scene.face.layer_mm / local->cos_incline * back;
      double here = 0;
      for (int i = 0; i < 12; ++i) here = depth_of(from - here * back) / scene.normal.dot(back);
      x.at<float>(v, u) = static_cast<float>(layer.difference_at(here));
    }
  return x;
}

/// A press of a body over the middle at pixel (u, v): `depth_over` gives the depth along the normal
/// at a position from there, mm.
template <class DepthOver>
Press make_body_press(const MadeScene& scene, const Layer& layer, double u, double v,
                      const DepthOver& depth_over, double noise, std::mt19937& random,
                      const std::string& name) {
  const Eigen::Vector3d n = scene.normal;
  const Eigen::Vector3d foot = scene.shape.at(u, v).value().view_point_mm + scene.face.layer_mm * n;
  const Eigen::Vector3d first = Eigen::Vector3d::UnitY().cross(n).normalized(),
                        second = n.cross(first);
  const cv::Mat x = difference_of(scene, layer, [&](const Eigen::Vector3d& point) {
    return depth_over(Eigen::Vector2d(first.dot(point - foot), second.dot(point - foot)));
  });
  std::normal_distribution<double> normal;
  cv::Mat grain(x.size(), CV_32FC1);
  for (float& value : cv::Mat_<float>(grain)) value = static_cast<float>(normal(random));
  return Press{name, noisy_difference(x, grain, noise), scene.shape};
}

inline Press make_punch_press(const MadeScene& scene, const Layer& layer, const Punch& punch,
                              double noise, std::mt19937& random, const std::string& name) {
  Press press = make_body_press(
      scene, layer, punch.u, punch.v,
      [&](const Eigen::Vector2d& at) { return depth_over(punch, at); }, noise, random, name);
  press.step_mm = punch.step_mm;
  return press;
}

/// A rod that lies on the face, its axis at `turn` in it.
struct Rod {
  double u, v;  ///< pixel whose point of the face lies below its middle
  double radius_mm = 3.0;
  double depth_mm = 0.8;  ///< below its middle, along the normal
  double turn = 0.3, tilt = 0.01;
  double half_length_mm = 8.0;
  double back_mm = 0.25;  ///< over which the skin comes back from its ends
};

inline double depth_over(const Rod& rod, const Eigen::Vector2d& at) {
  const double along = std::cos(rod.turn) * at.x() + std::sin(rod.turn) * at.y();
  const double across = -std::sin(rod.turn) * at.x() + std::cos(rod.turn) * at.y();
  if (std::abs(across) >= rod.radius_mm) return 0.0;
  const double sunk = std::sqrt(rod.radius_mm * rod.radius_mm - across * across) - rod.radius_mm;
  const double outside = std::max(0.0, std::abs(along) - rod.half_length_mm);
  return std::max(0.0, rod.depth_mm + rod.tilt * along + sunk) * std::exp(-outside / rod.back_mm);
}

inline Press make_rod_press(const MadeScene& scene, const Layer& layer, const Rod& rod,
                            double noise, std::mt19937& random, const std::string& name) {
  return make_body_press(
      scene, layer, rod.u, rod.v, [&](const Eigen::Vector2d& at) { return depth_over(rod, at); },
      noise, random, name);
}

/// noise: see noisy_difference.
inline Made make_press(const MadeScene& scene, const Layer& layer, const Contact& contact,
                       const std::vector<Ball>& balls, double noise, std::mt19937& random,
                       const std::string& name = "press") {
  const cv::Size size = scene.camera.size();
  const Eigen::Vector3d n = scene.normal;
  std::vector<Relief> reliefs;
  std::vector<Eigen::Vector3d> feet;
  for (const Ball& ball : balls) {
    reliefs.emplace_back(contact, ball.radius_mm, ball.depth_mm);
    const auto middle = scene.shape.at(ball.u, ball.v).value();
    feet.push_back(middle.view_point_mm + scene.face.layer_mm * n);
  }
  std::normal_distribution<double> normal;
  cv::Mat x(size, CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  cv::Mat grain(size, CV_32FC1);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      grain.at<float>(v, u) = static_cast<float>(normal(random));
      const auto rows = scene.shape.rows(u, 2.0);
      if (v < rows.first || v > rows.last) continue;
      const auto local = scene.shape.at(u, v);
      if (!local) continue;
      const bool by_normal = layer.along == MappingAlong::kNormal;
      const Eigen::Vector3d back = by_normal ? n : Eigen::Vector3d(0.0, 0.0, 1.0);
      const double thick =
          by_normal ? scene.face.layer_mm : scene.face.layer_mm / local->cos_incline;
      const Eigen::Vector3d from = local->view_point_mm + thick * back;
      double depth = 0;
      for (std::size_t k = 0; k < balls.size(); ++k) {
        // The skin is a height over the face: follow the line until it meets it.
        double here = 0;
        for (int i = 0; i < (by_normal || local->cos_incline == 1.0 ? 1 : 12); ++i) {
          const Eigen::Vector3d p = from - here * back - feet[k];
          const double r = (p - p.dot(n) * n).norm();
          here = reliefs[k](r) / n.dot(back);
        }
        depth = std::abs(here) > std::abs(depth) ? here : depth;
      }
      if (layer.along == MappingAlong::kProjected) depth *= local->cos_incline;
      const Eigen::Vector2d place(2.0 * u / size.width - 1.0, 2.0 * v / size.height - 1.0);
      x.at<float>(v, u) =
          static_cast<float>(layer.difference_at(depth / (1.0 + layer.uneven.dot(place))));
    }
  }
  return {{name, noisy_difference(x, grain, noise), scene.shape,
           balls.empty() ? 4.0 : balls[0].radius_mm},
          feet.empty() ? Eigen::Vector3d::Zero().eval()
                       : (feet[0] + (balls[0].radius_mm - balls[0].depth_mm) * n).eval()};
}

}  // namespace alltact::made
