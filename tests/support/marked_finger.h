// A bent finger with dots on its side faces, drawn without anything of the program under test:
// points of an arc projected by hand, discs painted by sampling each pixel.
#pragma once

#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact::test {

struct Bend {
  double curl = 0;  ///< radians more at the tip than at the base
  double hook = 0;  ///< the same, growing with the square of the length
  double sway = 0;  ///< mm sideways at the tip
  double lean = 0;  ///< radians at the base
};

struct MarkedFinger {
  int width = 960, height = 540;
  double focal = 524, half_width_mm = 12, length_mm = 90;
  int per_row = 6;
  double dot_mm = 0.55, dot_aspect = 1.0;  ///< radius along the row; across it divided by aspect
  double off_face_mm = 9;                  ///< of the dots, towards the camera
  /// Where each row's dots lie, in shares of the length, and how large they are in parts of dot_mm;
  /// empty: per_row dots evenly spaced, all of the same size.
  std::vector<double> upper_shares, lower_shares, sizes;
  bool mirrored = false;  ///< base at high u
  double face_level = 150, side_level = 40, dark_level = 10, dot_contrast = 60;
  double noise = 1.0, blur = 0.7;

  struct Point {
    double x, z, angle, y;
  };

  [[nodiscard]] std::vector<Point> arc(const Bend& bend) const {
    constexpr int kSteps = 400;
    std::vector<Point> points;
    double x = -25, z = 42;
    for (int i = 0; i <= kSteps; ++i) {
      const double t = static_cast<double>(i) / kSteps;
      const double angle = 0.55 + bend.lean + bend.curl * t + bend.hook * t * t;
      points.push_back({x, z, angle, bend.sway * t * t});
      x += std::cos(angle) * length_mm / kSteps;
      z += std::sin(angle) * length_mm / kSteps;
    }
    return points;
  }

  [[nodiscard]] Eigen::Vector2d project(double x, double y, double z) const {
    const double u = focal * x / z, v = focal * y / z;
    return {0.5 * (width - 1) + (mirrored ? -u : u), 0.5 * (height - 1) + v};
  }

  /// The point at a share t of the length, `off` mm off the face towards the camera.
  [[nodiscard]] static Point at(const std::vector<Point>& arc, double t, double off) {
    Point p = arc[static_cast<std::size_t>(t * static_cast<double>(arc.size() - 1))];
    p.x += off * std::sin(p.angle);
    p.z -= off * std::cos(p.angle);
    return p;
  }

  struct Disc {
    double u, v, radius_u, radius_v;
  };

  [[nodiscard]] std::vector<Disc> discs(const Bend& bend) const {
    const auto points = arc(bend);
    std::vector<Disc> result;
    for (const double side : {-1.0, 1.0}) {
      const auto shares = shares_of(side);
      for (std::size_t i = 0; i < shares.size(); ++i)
        result.push_back(disc(points, side, shares[i], off_face_mm,
                              dot_mm * (i < sizes.size() ? sizes[i] : 1.0)));
    }
    return result;
  }

  [[nodiscard]] std::vector<double> shares_of(double side) const {
    const auto& given = side < 0 ? upper_shares : lower_shares;
    if (!given.empty()) return given;
    std::vector<double> even;
    for (int i = 0; i < per_row; ++i)
      even.push_back(per_row > 1 ? 0.06 + 0.86 * i / (per_row - 1) : 0.5);
    return even;
  }

  /// Anything round on a side face, fixed to the finger.
  [[nodiscard]] Disc disc(const std::vector<Point>& points, double side, double share,
                          double off_mm, double radius_mm) const {
    const Point p = at(points, share, off_mm);
    const Eigen::Vector2d q = project(p.x, side * half_width_mm + p.y, p.z);
    const double r = radius_mm * focal / p.z;
    return {q.x(), q.y(), r, r / dot_aspect};
  }

  [[nodiscard]] Eigen::VectorXd layout(const Bend& bend) const {
    const auto all = discs(bend);
    Eigen::VectorXd row(2 * static_cast<Eigen::Index>(all.size()));
    for (std::size_t m = 0; m < all.size(); ++m)
      row.segment<2>(2 * static_cast<Eigen::Index>(m)) << all[m].u, all[m].v;
    return row;
  }

  /// v of a long edge at each column, `off` mm off the face; NaN beyond the finger's ends.
  [[nodiscard]] std::vector<double> edge(const Bend& bend, double side, double off) const {
    std::vector<double> v(static_cast<std::size_t>(width), std::nan(""));
    const auto points = arc(bend);
    Eigen::Vector2d before(std::nan(""), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point p =
          at(points, static_cast<double>(i) / static_cast<double>(points.size() - 1), off);
      Eigen::Vector2d q = project(p.x, side * half_width_mm + p.y, p.z);
      if (i > 0) {
        const double low = std::min(q.x(), before.x()), high = std::max(q.x(), before.x());
        for (int u = std::max(0, static_cast<int>(std::ceil(low)));
             u <= std::min<double>(width - 1, high); ++u)
          v[static_cast<std::size_t>(u)] =
              before.y() + (q.y() - before.y()) * (u - before.x()) / (q.x() - before.x());
      }
      before = q;
    }
    return v;
  }

  /// The first and last number in place of what is missing before and after.
  static void hold_ends(std::vector<double>& v) {
    const auto is_number = [](double x) { return std::isfinite(x); };
    const auto first = std::find_if(v.begin(), v.end(), is_number);
    const auto last = std::find_if(v.rbegin(), v.rend(), is_number);
    if (first == v.end()) return;
    std::fill(v.begin(), first, *first);
    std::fill(v.rbegin(), last, *last);
  }

  struct Extra {
    Disc disc;
    double level;
  };

  /// The picture without noise: `hidden` markers are not painted, `extras` are painted last.
  [[nodiscard]] cv::Mat clean(const Bend& bend, const std::vector<int>& hidden = {},
                              const std::vector<Extra>& extras = {}) const {
    cv::Mat image(height, width, CV_32FC1, cv::Scalar(dark_level));
    auto up = edge(bend, -1, 0), low = edge(bend, 1, 0);
    const auto end = up;
    hold_ends(up);
    hold_ends(low);
    auto far_up = edge(bend, -1, 14), far_low = edge(bend, 1, 14);
    hold_ends(far_up);
    hold_ends(far_low);
    for (int u = 0; u < width; ++u) {
      const auto i = static_cast<std::size_t>(u);
      const double shine = 1.2 - 0.4 * u / width;
      // Nearer parts of the face, wider in the picture, get more of the light at the base.
      const double light = 0.4 + 1.2 * (low[i] - up[i]) / (0.5 * width);
      const double top = std::min(far_up[i], up[i] - 20),
                   bottom = std::max(far_low[i], low[i] + 20);
      for (int v = 0; v < height; ++v) {
        const auto covered = [v](double a, double b) {
          return std::clamp(std::min(v + 0.5, b) - std::max(v - 0.5, a), 0.0, 1.0);
        };
        const double face = std::isfinite(end[i]) ? covered(up[i], low[i]) : 0.0,
                     side = covered(top, up[i]) + covered(low[i], bottom);
        image.at<float>(v, u) = static_cast<float>(
            face * face_level * light + side * side_level * shine + (1 - face - side) * dark_level);
      }
    }
    const auto all = discs(bend);
    for (std::size_t m = 0; m < all.size(); ++m) {
      if (std::find(hidden.begin(), hidden.end(), static_cast<int>(m)) != hidden.end()) continue;
      const double shine = 1.2 - 0.4 * all[m].u / width;
      paint(image, all[m], (side_level + dot_contrast) * shine);
    }
    for (const Extra& extra : extras) paint(image, extra.disc, extra.level);
    cv::GaussianBlur(image, image, cv::Size(0, 0), blur);
    return image;
  }

  static void paint(cv::Mat& image, const Disc& d, double level) {
    constexpr int kSub = 8;
    for (int v = std::max(0, static_cast<int>(d.v - d.radius_v - 1));
         v <= std::min(image.rows - 1, static_cast<int>(d.v + d.radius_v + 2)); ++v)
      for (int u = std::max(0, static_cast<int>(d.u - d.radius_u - 1));
           u <= std::min(image.cols - 1, static_cast<int>(d.u + d.radius_u + 2)); ++u) {
        int inside = 0;
        for (int a = 0; a < kSub; ++a)
          for (int b = 0; b < kSub; ++b) {
            const double x = (u - 0.5 + (a + 0.5) / kSub - d.u) / d.radius_u;
            const double y = (v - 0.5 + (b + 0.5) / kSub - d.v) / d.radius_v;
            inside += x * x + y * y < 1;
          }
        const float share = static_cast<float>(inside) / (kSub * kSub);
        float& pixel = image.at<float>(v, u);
        pixel += share * (static_cast<float>(level) - pixel);
      }
  }

  [[nodiscard]] cv::Mat with_noise(const cv::Mat& image, std::mt19937& random) const {
    std::normal_distribution<double> normal;
    cv::Mat grey(image.size(), CV_8UC1);
    for (int v = 0; v < image.rows; ++v)
      for (int u = 0; u < image.cols; ++u)
        grey.at<std::uint8_t>(v, u) =
            cv::saturate_cast<std::uint8_t>(image.at<float>(v, u) + noise * normal(random));
    return grey;
  }

  [[nodiscard]] CameraParameters camera() const {
    CameraParameters p;
    p.width_px = width;
    p.height_px = height;
    p.fx_px = p.fy_px = focal;
    p.cx_px = 0.5 * (width - 1);
    p.cy_px = 0.5 * (height - 1);
    return p;
  }

  [[nodiscard]] Face face() const {
    Face f;
    f.kind = FaceKind::kFinRay;
    f.width_mm = 2 * half_width_mm;
    f.layer_mm = 1.5;
    return f;
  }

  /// The face's shape from its true edges.
  /// Of the face, without its ends.
  [[nodiscard]] FaceEdges edges(const Bend& bend) const {
    FaceEdges edges;
    const auto up = edge(bend, -1, 0), low = edge(bend, 1, 0);
    for (int u = 4; u < width; u += 8) {
      const auto i = static_cast<std::size_t>(u);
      const bool there = std::isfinite(up[i]) && std::isfinite(low[i]);
      edges.u.push_back(u);
      for (auto [edge, v] : {std::pair{&edges.upper, up[i]}, std::pair{&edges.lower, low[i]}}) {
        edge->v.push_back(there ? v : 0);
        edge->sd.push_back(0.02);
        edge->valid.push_back(there);
      }
    }
    edges.noise_sd = noise;
    return edges;
  }

  [[nodiscard]] FaceShape shape(const Bend& bend) const {
    return FaceShape::fit(edges(bend), Camera::create(camera()).value(), face(), 7).value();
  }

  [[nodiscard]] std::vector<Dot> typical(const Bend& bend) const {
    std::vector<Dot> dots;
    for (const Disc& d : discs(bend)) {
      Dot dot{
          d.u,  d.v,  std::sqrt(d.radius_u * d.radius_v), dot_contrast * (1.2 - 0.4 * d.u / width),
          0.02, false};
      dot.upper = static_cast<int>(dots.size()) < per_row;
      dots.push_back(dot);
    }
    return dots;
  }
};

inline Bend random_bend(std::mt19937& random, double share = 1.0) {
  std::uniform_real_distribution<double> one(-1.0, 1.0);
  return {0.45 * share * one(random), 0.25 * share * one(random), 9 * share * one(random),
          0.05 * share * one(random)};
}

}  // namespace alltact::test
