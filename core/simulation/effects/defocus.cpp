// Defocus blur. A thin lens images a point at distance z as a disc of diameter c = aperture * f |1
// / focus - 1 / z| pixels, f the camera's focal length in pixels. Here it is the Gaussian of the
// disc's variance, sd = c / 4 along each axis, by the view face's distance where the column crosses
// the image's middle row. `sd_px` gives that sd directly, constant over the image, instead of focus
// and aperture: for a lens of which only the blur is known, or a resampled image.
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"

namespace alltact {

namespace {

constexpr double kMinBlur_px = 0.02;  // a Gaussian of this sd is 1 in its middle pixel
constexpr int kMaxBlur_px = 200;

// sum[u] += weight[u] * in[u]: one tap of all columns' kernels.
ALLTACT_WIDE void add_weighted(int n, const float* __restrict weight, const float* __restrict in,
                               float* __restrict sum) {
  for (int u = 0; u < n; ++u) sum[u] += weight[u] * in[u];
}

class Defocus final : public SensorEffect {
 public:
  explicit Defocus(YamlSection& p)
      : sd_px_(p.has("sd_px") ? p.number("sd_px", strength_up_to(50)) : 0) {
    if (sd_px_ > 0) return;
    focus_mm_ = p.number("focus_mm", strength_up_to(1e5));
    aperture_mm_ = p.number("aperture_mm", strength_up_to(100));
  }

  Status validate(const SceneFacts& scene) const override {
    if (sd_px_ == 0 && scene.finger.camera.model == CameraModel::kOrthographic)
      return Error{en::say("an orthographic camera has no focal length for blur"), "",
                   en::say("sd_px instead of focus_mm and aperture_mm")};
    return {};
  }

  bool needs_full_image() const override { return true; }
  void process_image(const FrameContext& frame, const FrameGeometry& geometry,
                     cv::Mat_<float>& grey) const override {
    const cv::Mat_<float> weights = kernels(frame, geometry);  // row i: i pixels from the middle
    const int half = weights.rows - 1, width = grey.cols;
    cv::Mat_<float> along(grey.size(), 0.0F);
    std::vector<float> wide(static_cast<std::size_t>(std::ptrdiff_t{2} * half + width));
    for (int v = 0; v < grey.rows; ++v) {
      for (int u = -half; u < width + half; ++u)
        wide[static_cast<std::size_t>(std::ptrdiff_t{u} + half)] =
            grey(v, std::clamp(u, 0, width - 1));
      for (int i = -half; i <= half; ++i)
        add_weighted(width, weights[std::abs(i)], wide.data() + half + i, along[v]);
    }
    for (int v = 0; v < grey.rows; ++v) {
      std::fill(grey[v], grey[v] + width, 0.0F);
      for (int i = -half; i <= half; ++i)
        add_weighted(width, weights[std::abs(i)], along[std::clamp(v + i, 0, grey.rows - 1)],
                     grey[v]);
    }
  }

 private:
  [[nodiscard]] cv::Mat_<float> kernels(const FrameContext& frame,
                                        const FrameGeometry& geometry) const {
    if (sd_px_ > 0)
      return kernels(
          std::vector<double>(static_cast<std::size_t>(frame.finger.camera.width_px), sd_px_));
    const CameraParameters& camera = frame.finger.camera;
    RowScratch scratch(camera.width_px);
    RowView row(camera.width_px, scratch);
    row.v = camera.height_px / 2;
    geometry.fill(row);
    std::vector<double> sd;
    for (int u = 0; u < row.width; ++u) {
      const double z = row.face.z_mm[u];
      sd.push_back(aperture_mm_ * camera.fx_px * std::abs(1 / focus_mm_ - 1 / z) / 4);
    }
    return kernels(sd);
  }

  // One kernel for each column, of its standard deviation.
  [[nodiscard]] static cv::Mat_<float> kernels(const std::vector<double>& sd) {
    const double widest = *std::max_element(sd.begin(), sd.end());
    const int half = std::min(kMaxBlur_px, static_cast<int>(std::ceil(4 * widest)));
    const int width = static_cast<int>(sd.size());
    cv::Mat_<float> weights(half + 1, width);
    for (int u = 0; u < width; ++u) {
      const double s = std::max(sd[static_cast<std::size_t>(u)], kMinBlur_px);
      double sum = 1;
      for (int i = 1; i <= half; ++i) sum += 2 * std::exp(-0.5 * i * i / (s * s));
      for (int i = 0; i <= half; ++i)
        weights(i, u) = static_cast<float>(std::exp(-0.5 * i * i / (s * s)) / sum);
    }
    return weights;
  }

  double sd_px_;  // 0: by distance
  double focus_mm_ = 0, aperture_mm_ = 0;
};

}  // namespace

EffectKind effect_defocus() {
  return effect_kind<Defocus>("defocus", 5,
                              en::say("Objects outside the focus distance are blurred"),
                              "focus_mm: 60, aperture_mm: 0.5");
}

}  // namespace alltact
