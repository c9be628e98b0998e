// Scenes of resources/scenes, whole or with effects taken away, and what to measure in them.
#pragma once

#include "tests/core/simulation/scene_text.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <numbers>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <opencv2/imgproc.hpp>

namespace alltact {

/// Without these a plan renders light, exactly: CV_32FC1, no noise.
#define ALLTACT_BARE "read", "quantisation"

class ShippedScene {
 public:
  explicit ShippedScene(const std::string& name)
      : file_(std::filesystem::path(ALLTACT_SOURCE_DIR) / "resources/scenes" / (name + ".yaml")) {
    std::ifstream in(file_);
    EXPECT_TRUE(in.good()) << file_;
    for (std::string line; std::getline(in, line);) lines_.push_back(line);
  }

  /// Its text without the effects of these kinds.
  [[nodiscard]] std::string text(std::initializer_list<std::string_view> without = {}) const {
    std::string text;
    bool skips = false;
    for (const std::string& line : lines_) {
      if (line.starts_with("  - ")) {
        skips = false;
        for (const std::string_view kind : without) {
          const std::size_t use = line.find("use: " + std::string(kind));
          if (use == std::string::npos) continue;
          const std::size_t end = use + 5 + kind.size();
          skips |= end == line.size() || line[end] == ',' || line[end] == '}';
        }
        taken_ += skips;
      }
      if (!skips) text += line + '\n';
    }
    return text;
  }

  [[nodiscard]] Plan plan(std::initializer_list<std::string_view> without = {}) const {
    taken_ = 0;
    const std::string rest = text(without);
    EXPECT_GE(taken_, without.size()) << file_ << " does not name all that is to be taken away";
    return plan_of_text(rest);
  }

  [[nodiscard]] Plan plan_of_text(const std::string& text) const {
    const auto scene = Scene::parse(text, file_.string());
    EXPECT_TRUE(scene) << scene.error().sentence();
    auto plan = Plan::compile(*scene, 7);
    EXPECT_TRUE(plan) << plan.error().sentence();
    return *plan;
  }

 private:
  std::filesystem::path file_;
  std::vector<std::string> lines_;
  mutable std::size_t taken_ = 0;
};

/// The demonstration's straight finger: places on its view face.
struct StraightFace {
  double incline_rad = 34 * std::numbers::pi / 180, x_mm = -25, z_mm = 28;
  /// (s, y) of what is seen at z in a pixel.
  [[nodiscard]] Eigen::Vector2d place(const Plan& plan, int u, int v, double z) const {
    const CameraParameters& c = plan.finger().camera;
    const double x = (u - c.cx_px) / c.fx_px * z, y = (v - c.cy_px) / c.fy_px * z;
    return {(x - x_mm) * std::cos(incline_rad) + (z - z_mm) * std::sin(incline_rad), y};
  }
  /// Area of the face that a pixel sees: z^3 / (fx fy |n . p|).
  [[nodiscard]] double area_mm2(const Plan& plan, int u, double z) const {
    const CameraParameters& c = plan.finger().camera;
    const double x = (u - c.cx_px) / c.fx_px * z;
    const double towards = z * std::cos(incline_rad) - x * std::sin(incline_rad);
    return z * z * z / (c.fx_px * c.fy_px * towards);
  }
};

/// Moments of a pressed region on the straight face.
struct RegionMoments {
  double area_mm2 = 0;
  Eigen::Vector2d middle_mm = Eigen::Vector2d::Zero();
  Eigen::Matrix2d spread_mm2 = Eigen::Matrix2d::Zero();

  /// Of its longest axis, from the finger's length towards +y, in (-90, 90].
  [[nodiscard]] double angle_deg() const {
    return 90 / std::numbers::pi *
           std::atan2(2 * spread_mm2(0, 1), spread_mm2(0, 0) - spread_mm2(1, 1));
  }
  /// Longest over shortest axis.
  [[nodiscard]] double elongation() const {
    const double half = spread_mm2.trace() / 2;
    const double root = std::sqrt(std::max(0.0, half * half - spread_mm2.determinant()));
    return std::sqrt((half + root) / (half - root));
  }
};

template <class Belongs>
RegionMoments moments_of(const Plan& plan, const Truth& truth, const Belongs& belongs) {
  const StraightFace face;
  RegionMoments m;
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (int v = 0; v < truth.depth_mm.rows; ++v)
    for (int u = 0; u < truth.depth_mm.cols; ++u) {
      if (!belongs(v, u)) continue;
      const double z = truth.view_z_mm.at<float>(v, u), area = face.area_mm2(plan, u, z);
      const Eigen::Vector2d p = face.place(plan, u, v, z);
      m.area_mm2 += area;
      m.middle_mm += area * p;
      second += area * p * p.transpose();
    }
  m.middle_mm /= m.area_mm2;
  m.spread_mm2 = second / m.area_mm2 - m.middle_mm * m.middle_mm.transpose();
  return m;
}

/// 255 where the face is pressed in by more.
inline cv::Mat_<std::uint8_t> deeper_than(const Truth& truth, double depth_mm) {
  return truth.depth_mm > depth_mm;  // NaN is not
}
/// Where the face is.
inline cv::Mat_<std::uint8_t> on_face(const Truth& truth) {
  return truth.depth_mm == truth.depth_mm;
}
/// The face without a rim of pixels.
inline cv::Mat_<std::uint8_t> within_face(const Truth& truth, int rim_px) {
  cv::Mat_<std::uint8_t> mask = on_face(truth), inner;
  cv::copyMakeBorder(mask, mask, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::erode(mask, inner, cv::Mat(), cv::Point(-1, -1), rim_px);
  return inner(cv::Rect(1, 1, mask.cols - 2, mask.rows - 2)).clone();
}
inline int region_count(const cv::Mat_<std::uint8_t>& mask) {
  cv::Mat labels;
  return cv::connectedComponents(mask, labels) - 1;
}
inline cv::Point deepest_pixel(const Truth& truth) {
  cv::Mat depth = truth.depth_mm.clone();
  cv::patchNaNs(depth, -1);
  cv::Point at;
  cv::minMaxLoc(depth, nullptr, nullptr, nullptr, &at);
  return at;
}
inline double mean_of(const cv::Mat& image, const cv::Mat& mask = cv::Mat()) {
  return cv::mean(image, mask)[0];
}
inline cv::Mat_<float> ratio_of(const cv::Mat_<float>& a, const cv::Mat_<float>& b) {
  return a / cv::max(b, 1e-6);
}

/// How many pixels a step takes from a tenth to nine tenths of its height, along values.
inline double step_width_px(const std::vector<float>& values) {
  const auto ends = std::minmax_element(values.begin(), values.end());
  const float low = *ends.first, high = *ends.second;
  const auto crossing = [&](double part) {
    const double level = low + part * (high - low);
    for (std::size_t i = 1; i < values.size(); ++i) {
      const double a = values[i - 1] - level, b = values[i] - level;
      if ((a < 0) != (b < 0)) return static_cast<double>(i) - b / (b - a);
    }
    return -1.0;
  };
  return std::abs(crossing(0.9) - crossing(0.1));
}

/// Kubelka and Munk's reflectance over black, as core/simulation/effects/layer.cpp cites it.
inline double layer_reflectance(double scatter, double absorb, double thickness_mm) {
  if (absorb == 0) return scatter * thickness_mm / (1 + scatter * thickness_mm);
  const long double a = (static_cast<long double>(scatter) + absorb) / scatter;
  const long double b = std::sqrt(a * a - 1), x = b * scatter * thickness_mm;
  return static_cast<double>(std::sinh(x) / (a * std::sinh(x) + b * std::cosh(x)));
}

}  // namespace alltact
