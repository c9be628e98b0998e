// Brightness of an indented layer from paths of light, walked backwards from the view face: the
// truth for tests of light that spreads. Shares no formula with the code under test.
#pragma once

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace alltact::made {

/// A layer that scatters in all directions alike, over black, seen along its normal. Each vertex of
/// a path collects the light that reaches it straight from the lamp. A path ends at its first
/// vertex beyond the outer side, wherever a body has pushed that in.
class WalkedLayer {
 public:
  /// `optical`: thickness times reduced scattering. `cos_light`: of the lamp's light in the layer.
  WalkedLayer(double thickness_mm, double optical, double cos_light, int paths, unsigned seed)
      : thickness_mm_(thickness_mm) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(1e-12, 1.0);
    std::normal_distribution<double> normal;
    const double per_mm = optical / thickness_mm;
    for (int path = 0; path < paths; ++path) {
      double x = 0, y = 0, z = -std::log(uniform(random)) / per_mm;
      first_.push_back(vertices_.size());
      while (z > 0 && z < thickness_mm && vertices_.size() - first_.back() < 60) {
        vertices_.push_back({x, y, z, std::exp(-per_mm * z / cos_light)});
        const double a = normal(random), b = normal(random), c = normal(random);
        const double flight =
            -std::log(uniform(random)) / per_mm / std::sqrt(a * a + b * b + c * c);
        x += flight * a, y += flight * b, z += flight * c;
      }
    }
    first_.push_back(vertices_.size());
    untouched_ = brightness([](double, double) { return 0.0; });
  }

  /// Brightness difference at the origin of a skin whose depth at (x, y) is `depth_mm`.
  template <class Depth>
  [[nodiscard]] double difference(const Depth& depth_mm) const {
    return 1.0 - brightness(depth_mm) / untouched_;
  }

 private:
  struct Vertex {
    double x_mm, y_mm, z_mm, light;
  };
  template <class Depth>
  [[nodiscard]] double brightness(const Depth& depth_mm) const {
    double sum = 0;
    for (std::size_t path = 0; path + 1 < first_.size(); ++path)
      for (std::size_t i = first_[path]; i < first_[path + 1]; ++i) {
        const Vertex& at = vertices_[i];
        if (at.z_mm > thickness_mm_ - depth_mm(at.x_mm, at.y_mm)) break;
        sum += at.light;
      }
    return sum;
  }

  double thickness_mm_;
  std::vector<Vertex> vertices_;
  std::vector<std::size_t> first_;
  double untouched_ = 1;
};

/// What a walked layer shows of a round indentation.
class ShownRound {
 public:
  /// `depth_mm`: by the distance from the axis. Nothing is shown beyond `reach_mm`.
  template <class Depth>
  ShownRound(const WalkedLayer& layer, const Depth& depth_mm, double reach_mm) {
    for (double r = 0; r < reach_mm; r += kStepMm)
      x_.push_back(
          layer.difference([&](double dx, double dy) { return depth_mm(std::hypot(r + dx, dy)); }));
    x_.push_back(0.0);
  }

  /// Brightness difference at a distance from the axis.
  [[nodiscard]] double at(double r_mm) const {
    const double index = r_mm / kStepMm;
    if (!(index < static_cast<double>(x_.size() - 1))) return 0.0;
    const auto i = static_cast<std::size_t>(index);
    return x_[i] + (index - static_cast<double>(i)) * (x_[i + 1] - x_[i]);
  }

 private:
  static constexpr double kStepMm = 0.1;
  std::vector<double> x_;
};

}  // namespace alltact::made
