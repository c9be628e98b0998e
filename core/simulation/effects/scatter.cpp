// The layer over a black coat, lit and seen through the body, with light that scatters several
// times: it leaves next to where it came in. Replaces the effect `layer`, whose light is local.
//
// Light that turns at a point of the layer is
//   S(r) = albedo (exp(-e z / cos(light)) + integral of e exp(-e |r - q|) / (4 pi |r - q|^2) S(q)),
// e the extinction (scattering + absorption), z the depth below the view face: straight from the
// lamps, at `light_deg` to the normal in the layer, and from other points (S. Chandrasekhar,
// Radiative Transfer, 1950). Beyond the skin, wherever that is pressed in, the side faces and the
// ends, S is 0. The integral is solved on a grid of voxels by repeated convolution. A line of sight
// collects
//   R = integral of e exp(-e l) S dl / (4 cos(light))
// of a white surface's light up to the skin. Isotropic scattering stands for any other by
// similarity: give the reduced coefficient. Light that leaves through an indentation and enters
// again, and the bending of the face over the reach of light, are ignored.
#include "core/numerics/image_noise.h"
#include "core/numerics/parallel.h"
#include "core/simulation/effect.h"

#include <array>
#include <numbers>

#include <opencv2/imgproc.hpp>

namespace alltact {

namespace {

constexpr double kCellMm = 0.12;  // of the skin, and of what is seen

/// A grid of positions on the face: rows across, columns along. A flat sensor's reaches beyond the
/// image by a margin.
class FaceCells {
 public:
  FaceCells(const FrameGeometry& geometry, double cell_mm, double margin_mm) : geometry_(geometry) {
    if (const FaceCurve* curve = geometry.curve()) {
      length_mm_ = curve->length_mm();
      width_mm_ = geometry.face().width_mm;
      first_w_mm_ = -0.5 * width_mm_;
    } else {
      const double z = geometry.face().plane_z_mm;
      const cv::Size size = geometry.rays().camera().size();
      const auto corner = [&](int u, int v) {
        const Ray ray = geometry.rays().ray(u, v);
        return Eigen::Vector2d(ray.origin_mm.head<2>() + z * ray.direction.head<2>());
      };
      const Eigen::Vector2d low = corner(0, 0), high = corner(size.width - 1, size.height - 1);
      first_s_mm_ = low.x() - margin_mm, first_w_mm_ = low.y() - margin_mm;
      length_mm_ = high.x() - low.x() + 2 * margin_mm;
      width_mm_ = high.y() - low.y() + 2 * margin_mm;
    }
    size_ = {static_cast<int>(std::ceil(length_mm_ / cell_mm)),
             static_cast<int>(std::ceil(width_mm_ / cell_mm))};
    step_s_ = length_mm_ / size_.width, step_w_ = width_mm_ / size_.height;
  }

  [[nodiscard]] const cv::Size& size() const { return size_; }
  [[nodiscard]] double s_mm(int column) const { return first_s_mm_ + (column + 0.5) * step_s_; }
  [[nodiscard]] double w_mm(int row) const { return first_w_mm_ + (row + 0.5) * step_w_; }
  [[nodiscard]] double step_s_mm() const { return step_s_; }
  [[nodiscard]] double step_w_mm() const { return step_w_; }
  [[nodiscard]] float column_at(float s_mm) const {
    return static_cast<float>((static_cast<double>(s_mm) - first_s_mm_) / step_s_ - 0.5);
  }
  [[nodiscard]] float row_at(float w_mm) const {
    return static_cast<float>((static_cast<double>(w_mm) - first_w_mm_) / step_w_ - 0.5);
  }
  /// Light leaves a finger's layer at its sides and ends; a flat sensor's goes on.
  [[nodiscard]] bool has_borders() const { return geometry_.curve() != nullptr; }

  /// A row of cells as a row of the face.
  struct Row {
    std::vector<float> x, y, z, sin, cos, luf, shift, s, coverage;
    FaceRow face;
  };
  [[nodiscard]] Row row(int number, RowScratch& scratch) const {
    Row row;
    for (int i = 0; i < size_.width; ++i) {
      const double s = s_mm(i), w = w_mm(number);
      const auto at = geometry_.body_point(s, w, 0);
      const double shift = geometry_.curve() ? geometry_.curve()->at(s).shift_mm : 0;
      const auto add = [](std::vector<float>& values, double value) {
        values.push_back(static_cast<float>(value));
      };
      add(row.x, at.point_mm.x()), add(row.y, at.point_mm.y()), add(row.z, at.point_mm.z());
      add(row.sin, at.along.z()), add(row.cos, at.along.x());
      add(row.luf, geometry_.luf_point_mm(s, w).z() - at.point_mm.z());
      add(row.shift, shift), add(row.s, s);
    }
    row.coverage.assign(row.x.size(), 1.0F);
    row.face.last = size_.width;
    row.face.coverage = row.coverage.data();
    row.face.x_mm = row.x.data(), row.face.y_mm = row.y.data(), row.face.z_mm = row.z.data();
    row.face.sin_incline = row.sin.data(), row.face.cos_incline = row.cos.data();
    row.face.luf_mm = row.luf.data(), row.face.shift_mm = row.shift.data();
    row.face.s_mm = row.s.data();
    for (const auto& change : geometry_.layer_changes) change(row.face, scratch, row.luf.data());
    return row;
  }

 private:
  const FrameGeometry& geometry_;
  double first_s_mm_ = 0, first_w_mm_ = 0, length_mm_ = 0, width_mm_ = 0;
  double step_s_ = 1, step_w_ = 1;
  cv::Size size_;
};

/// The skin of one frame as the layer sees it, by cells.
class Skin {
 public:
  Skin(const FrameGeometry& geometry, const FaceCells& cells) : cells_(cells) {
    const cv::Size size = cells.size();
    thickness_mm_.create(size);
    sight_.create(size);
    slope_.resize(static_cast<std::size_t>(size.width));
    RowScratch scratch(size.width);
    for (int j = 0; j < size.height; ++j) measure_row(geometry, j, scratch);
    double thickest = 0;
    cv::minMaxLoc(thickness_mm_, nullptr, &thickest);
    thickest_mm_ = std::max(thickest, 1e-3);
  }

  [[nodiscard]] double thickest_mm() const { return thickest_mm_; }
  /// How far the skin is above a point at depth `down_mm` below the view face, along the normal.
  /// The thickness is known where lines along z leave the view face.
  [[nodiscard]] float above_mm(float s_mm, float w_mm, float down_mm) const {
    const float at =
        std::clamp(cells_.column_at(s_mm), 0.0F, static_cast<float>(slope_.size() - 1));
    const float from = s_mm - down_mm * slope_[static_cast<std::size_t>(at)];
    return bilinear_within(thickness_mm_, cells_.column_at(from), cells_.row_at(w_mm)) - down_mm;
  }
  /// Displacement of a line of sight along and across, per mm of depth.
  [[nodiscard]] Eigen::Vector2f sight(int j, int i) const {
    return {sight_(j, i)[0], sight_(j, i)[1]};
  }

 private:
  void measure_row(const FrameGeometry& geometry, int j, RowScratch& scratch) {
    scratch.rewind();
    const FaceCells::Row row = cells_.row(j, scratch);
    const bool is_perspective = geometry.rays().camera().is_perspective();
    std::vector<float> depth(row.x.size(), 0.0F);
    for (const auto& press : geometry.presses)
      std::visit([&](const auto& one) { press_row(one, row.face, 0, row.face.last, depth.data()); },
                 press);
    for (int i = 0; i < row.face.last; ++i) {
      const auto k = static_cast<std::size_t>(i);
      thickness_mm_(j, i) = std::max(0.0F, row.luf[k] - depth[k]) * row.cos[k];
      slope_[k] = row.sin[k] / row.cos[k];
      const Eigen::Vector3f ray =
          is_perspective ? Eigen::Vector3f(row.x[k], row.y[k], row.z[k]) : Eigen::Vector3f(0, 0, 1);
      // Seen from behind or along the face: no pixel shows it.
      const float down = std::max(0.05F * ray.norm(), row.cos[k] * ray.z() - row.sin[k] * ray.x());
      sight_(j, i) = {(row.cos[k] * ray.x() + row.sin[k] * ray.z()) / down, ray.y() / down};
    }
  }

  const FaceCells& cells_;
  cv::Mat_<float> thickness_mm_;  // along the normal
  cv::Mat_<cv::Vec2f> sight_;
  std::vector<float> slope_;  // tangent of the incline, by column
  double thickest_mm_ = 0;
};

struct Optics {
  double extinction_per_mm, albedo, cos_light;

  /// How far light walks aside in a layer.
  [[nodiscard]] double reach_mm(double thickness_mm) const {
    return std::min(4 * thickness_mm, 12 / extinction_per_mm);
  }
  /// Straight from the lamps, at a depth below the view face.
  [[nodiscard]] double lamps_at(double down_mm) const {
    return std::exp(-extinction_per_mm * down_mm / cos_light);
  }
};

/// Light that turned before, in voxels of the layer.
class WalkingLight {
 public:
  WalkingLight(const FrameGeometry& geometry, const Skin& skin, const Optics& optics)
      : cells_(geometry, voxel_mm(optics), optics.reach_mm(skin.thickest_mm())),
        optics_(optics),
        layers_(layers_of(optics.extinction_per_mm * skin.thickest_mm())),
        height_mm_(skin.thickest_mm() / layers_),
        size_(cells_.size()) {
    if (cells_.has_borders()) {  // nothing comes back from beyond them
      const int margin =
          static_cast<int>(std::ceil(optics.reach_mm(skin.thickest_mm()) / cells_.step_s_mm()));
      size_ = size_ + cv::Size(margin, margin);
    }
    size_ = {cv::getOptimalDFTSize(size_.width), cv::getOptimalDFTSize(size_.height)};
    fill(skin);
    tabulate_flights();
    solve();
  }

  /// Between the middles of voxels; `down_mm`: below the view face.
  [[nodiscard]] float at(float s_mm, float w_mm, float down_mm) const {
    const float layer = std::clamp(down_mm / static_cast<float>(height_mm_) - 0.5F, 0.0F,
                                   static_cast<float>(layers_) - 1.001F);
    const auto k = static_cast<std::size_t>(layer);
    const float column = cells_.column_at(s_mm), row = cells_.row_at(w_mm);
    return std::lerp(bilinear_within(light_[k], column, row),
                     bilinear_within(light_[k + 1], column, row), layer - static_cast<float>(k));
  }

 private:
  // Some parts of a mean free path, and fine enough for the skin.
  [[nodiscard]] static double voxel_mm(const Optics& optics) {
    return std::clamp(0.4 / optics.extinction_per_mm, 0.12, 0.25);
  }
  [[nodiscard]] static int layers_of(double mean_free_paths) {
    return std::clamp(static_cast<int>(std::ceil(4 * mean_free_paths)), 8, 24);
  }
  [[nodiscard]] double down_mm(int layer) const { return (layer + 0.5) * height_mm_; }

  // The part of each voxel within the layer. A flat sensor's goes on all around.
  void fill(const Skin& skin) {
    for (int k = 0; k < layers_; ++k) {
      cv::Mat_<float> part(size_, cells_.has_borders() ? 0.0F : 1.0F);
      const auto down = static_cast<float>(down_mm(k)), height = static_cast<float>(height_mm_);
      for (int j = 0; j < cells_.size().height; ++j)
        for (int i = 0; i < cells_.size().width; ++i) {
          const float above = skin.above_mm(static_cast<float>(cells_.s_mm(i)),
                                            static_cast<float>(cells_.w_mm(j)), down);
          part(j, i) = std::clamp(above / height + 0.5F, 0.0F, 1.0F);
        }
      inside_.push_back(part);
    }
  }

  // Probability that light which turns in the middle of a voxel turns next in another one.
  [[nodiscard]] double flight(double s_mm, double w_mm, double z_mm) const {
    const double e = optics_.extinction_per_mm;
    const auto density = [&](double ds, double dw, double dz) {
      const double r2 = ds * ds + dw * dw + dz * dz;
      return e * std::exp(-e * std::sqrt(r2)) / (4 * std::numbers::pi * r2);
    };
    const double volume = cells_.step_s_mm() * cells_.step_w_mm() * height_mm_;
    const double far = std::hypot(s_mm, w_mm, z_mm);
    if (far == 0) return -std::expm1(-e * std::cbrt(0.75 * volume / std::numbers::pi));  // a ball
    if (far > 3 * cells_.step_s_mm()) return volume * density(s_mm, w_mm, z_mm);
    constexpr int kParts = 6;
    const auto offset = [](int part) { return (part + 0.5) / kParts - 0.5; };
    double sum = 0;
    for (int a = 0; a < kParts; ++a)
      for (int b = 0; b < kParts; ++b)
        for (int c = 0; c < kParts; ++c)
          sum += density(s_mm + offset(a) * cells_.step_s_mm(),
                         w_mm + offset(b) * cells_.step_w_mm(), z_mm + offset(c) * height_mm_);
    return volume * sum / (kParts * kParts * kParts);
  }

  void tabulate_flights() {
    for (int k = 0; k < layers_; ++k) {
      cv::Mat_<float> flights(size_);
      for (int j = 0; j < size_.height; ++j)
        for (int i = 0; i < size_.width; ++i)
          flights(j, i) = static_cast<float>(
              flight(std::min(i, size_.width - i) * cells_.step_s_mm(),
                     std::min(j, size_.height - j) * cells_.step_w_mm(), k * height_mm_));
      cv::Mat waves;
      cv::dft(flights, waves, cv::DFT_COMPLEX_OUTPUT);
      std::array<cv::Mat, 2> parts;
      cv::split(waves, parts.data());
      parts[1] = parts[0];  // even: real
      cv::merge(parts.data(), parts.size(), waves);
      flights_.push_back(waves);
    }
  }

  // S = albedo (lamps + flights * S), until nothing changes.
  void solve() {
    constexpr int kMaxRounds = 100;
    constexpr double kSettled = 1e-5;
    light_.assign(static_cast<std::size_t>(layers_), cv::Mat_<float>(size_, 0.0F));
    for (int round = 0; round < kMaxRounds; ++round) {
      std::vector<cv::Mat> waves(static_cast<std::size_t>(layers_));
      for (int k = 0; k < layers_; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const cv::Mat turning =
            (light_[i] + optics_.albedo * optics_.lamps_at(down_mm(k))).mul(inside_[i]);
        cv::dft(turning, waves[i], cv::DFT_COMPLEX_OUTPUT);
      }
      double change = 0;
      for (int k = 0; k < layers_; ++k) {
        cv::Mat sum = cv::Mat::zeros(size_, CV_32FC2), next;
        for (int from = 0; from < layers_; ++from)
          cv::accumulateProduct(waves[static_cast<std::size_t>(from)],
                                flights_[static_cast<std::size_t>(std::abs(k - from))], sum);
        cv::dft(sum, next, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
        next *= optics_.albedo;
        auto& light = light_[static_cast<std::size_t>(k)];
        change = std::max(change, cv::norm(next, light, cv::NORM_INF));
        light = next;
      }
      if (change < kSettled) break;
    }
  }

  FaceCells cells_;
  Optics optics_;
  int layers_;
  double height_mm_;  // of a voxel
  cv::Size size_;
  std::vector<cv::Mat_<float>> inside_;  // by layer
  std::vector<cv::Mat> flights_;         // by distance in layers, as waves
  std::vector<cv::Mat_<float>> light_;   // that turned before, by layer
};

/// What a layer reflects of the lamps' light, by cells.
cv::Mat_<float> reflected(const FaceCells& cells, const Skin& skin, const WalkingLight& walking,
                          const Optics& optics) {
  constexpr double kStepMm = 0.1;
  cv::Mat_<float> all(cells.size());
  const auto collected = [&](int j, int i) {
    const Eigen::Vector2f sight = skin.sight(j, i);
    const double path = std::sqrt(1.0 + static_cast<double>(sight.squaredNorm()));
    const auto s = static_cast<float>(cells.s_mm(i)), w = static_cast<float>(cells.w_mm(j));
    const auto above = [&](double down) {
      const auto z = static_cast<float>(down);
      return static_cast<double>(skin.above_mm(s + z * sight.x(), w + z * sight.y(), z));
    };
    double sum = 0, down = 0, here = above(0);
    while (here > 0) {
      double next = down + kStepMm, there = above(next);
      if (there < 0) next = down + kStepMm * here / (here - there);
      const double middle = 0.5 * (down + next), e = optics.extinction_per_mm * path;
      const auto z = static_cast<float>(middle);
      const double turning =
          optics.albedo * optics.lamps_at(middle) +
          static_cast<double>(walking.at(s + z * sight.x(), w + z * sight.y(), z));
      sum += turning * (std::exp(-e * down) - std::exp(-e * next));
      down = next, here = there;
    }
    return sum / (4 * optics.cos_light);
  };
  parallel_for(cells.size().height, default_threads(), [&](int first, int last) {
    for (int j = first; j < last; ++j)
      for (int i = 0; i < cells.size().width; ++i) all(j, i) = static_cast<float>(collected(j, i));
  });
  return all;
}

class Scatter final : public RadianceEffect {
 public:
  explicit Scatter(YamlSection& p)
      : scatter_per_mm_(p.number("scatter_per_mm", strength_up_to(100))),
        absorb_per_mm_(p.number_or("absorb_per_mm", 0, strength_up_to(100))),
        light_deg_(p.number_or("light_deg", 45, {0, 85})) {}

  Status validate(const SceneFacts& scene) const override {
    if (!scene.has_effect("layer")) return {};
    return Error{en::say("two effects for one layer: its light is local or scatters"), "",
                 en::say("naming the effect layer or the effect scatter")};
  }

  Rows begin(const FrameContext&, const FrameGeometry& geometry) const override {
    const Optics optics{scatter_per_mm_ + absorb_per_mm_,
                        scatter_per_mm_ / (scatter_per_mm_ + absorb_per_mm_),
                        std::cos(light_deg_ * std::numbers::pi / 180)};
    const FaceCells cells(geometry, kCellMm, optics.reach_mm(geometry.face().layer_mm));
    const Skin skin(geometry, cells);
    const WalkingLight walking(geometry, skin, optics);
    return [cells, seen = reflected(cells, skin, walking, optics)](RowView& row) {
      const FaceRow& face = row.face;
      float* light = row.surfaces[0].light;
      for (int u = face.first; u < face.last; ++u)
        light[u] *= bilinear_within(seen, cells.column_at(face.s_mm[u]),
                                    cells.row_at(face.y_mm[u] - face.shift_mm[u]));
    };
  }

 private:
  double scatter_per_mm_, absorb_per_mm_, light_deg_;
};

}  // namespace

EffectKind effect_scatter() {
  return effect_kind<Scatter>("scatter", 10,
                              en::say("Light in the layer scatters aside before it comes back"),
                              "scatter_per_mm: 0.6", {}, "layer");
}

}  // namespace alltact
