// A rigid object with a relief presses into the face: a T of two bars, an M8 thread lying on its
// side, or any height map. Its highest point indents by `depth_mm` along z.
#include "core/image/image_file.h"
#include "core/simulation/press.h"
#include "core/simulation/rigid_press.h"

#include <filesystem>
#include <numbers>

namespace alltact {

namespace {

// Cross bar and stem with upright walls, centred on its bounding box.
class TBar final : public HeightField {
 public:
  TBar(double size_mm, double bar_mm) : size_mm_(size_mm), bar_mm_(bar_mm) {}
  double gap_mm(double along, double across) const override {
    const double half = size_mm_ / 2;
    const bool in_bar = along >= half - bar_mm_ && along <= half && std::abs(across) <= half;
    const bool in_stem = std::abs(across) <= bar_mm_ / 2 && along >= -half && along <= half;
    return in_bar || in_stem ? 0.0 : kNothing_mm;
  }
  Eigen::Vector2d half_size_mm() const override { return {size_mm_ / 2, size_mm_ / 2}; }

 private:
  double size_mm_, bar_mm_;
};

// ISO 68-1 basic profile: crests P/8 and roots P/4 wide, flanks at 60 degrees, 5/8 H deep with
// H = P sqrt(3)/2, on a cylinder of 8 mm that lies along the finger's length.
class Thread final : public HeightField {
 public:
  explicit Thread(double size_mm) : size_mm_(size_mm) {}
  double gap_mm(double along, double across) const override {
    if (std::abs(across) >= kRadius_mm || std::abs(along) > size_mm_ / 2) return kNothing_mm;
    const double turn = std::asin(across / kRadius_mm) / (2 * std::numbers::pi);
    double phase = along / kPitch_mm - turn;
    phase = std::abs(phase - std::round(phase)) * kPitch_mm;  // mm from the nearest crest
    const double flank = std::max(0.0, phase - kPitch_mm / 16) * std::numbers::sqrt3;
    const double radius =
        kRadius_mm - std::min(flank, 0.625 * 0.5 * std::numbers::sqrt3 * kPitch_mm);
    const double up2 = radius * radius - across * across;
    return up2 > 0 ? kRadius_mm - std::sqrt(up2) : kNothing_mm;
  }
  Eigen::Vector2d half_size_mm() const override { return {size_mm_ / 2, kRadius_mm}; }

 private:
  static constexpr double kPitch_mm = 1.25, kRadius_mm = 4.0;
  double size_mm_;
};

// Bright is high. Bilinear between pixel centres, with upright walls around.
class HeightMap final : public HeightField {
 public:
  HeightMap(cv::Mat_<float> gap_mm, double mm_per_px)
      : gap_mm_(std::move(gap_mm)), mm_per_px_(mm_per_px) {}
  double gap_mm(double along, double across) const override {
    const double column = along / mm_per_px_ + 0.5 * (gap_mm_.cols - 1);
    const double row = across / mm_per_px_ + 0.5 * (gap_mm_.rows - 1);
    if (!(column >= 0 && row >= 0 && column <= gap_mm_.cols - 1 && row <= gap_mm_.rows - 1))
      return kNothing_mm;
    const int i = std::min(static_cast<int>(column), gap_mm_.cols - 2);
    const int j = std::min(static_cast<int>(row), gap_mm_.rows - 2);
    const double tx = column - i, ty = row - j;
    const double upper = gap_mm_(j, i) + tx * (double{gap_mm_(j, i + 1)} - gap_mm_(j, i));
    const double lower =
        gap_mm_(j + 1, i) + tx * (double{gap_mm_(j + 1, i + 1)} - gap_mm_(j + 1, i));
    return upper + ty * (lower - upper);
  }
  double finest_mm() const override { return std::min(0.02, mm_per_px_ / 2); }
  Eigen::Vector2d half_size_mm() const override {
    return mm_per_px_ / 2 * Eigen::Vector2d(gap_mm_.cols - 1, gap_mm_.rows - 1);
  }

 private:
  cv::Mat_<float> gap_mm_;
  double mm_per_px_;
};

std::shared_ptr<const Body> read_height_map(YamlSection& p) {
  const double mm_per_px = p.number("mm_per_px", strength_up_to(10));
  const double height_mm = p.number("height_mm", strength_up_to(100));
  const std::filesystem::path scene_folder = p.file().path().parent_path();
  const auto image = read_grey_image(scene_folder / p.text("file"));
  if (!image) p.refuse("file", image.error().what, image.error().advice);
  if (image->cols < 2 || image->rows < 2)
    p.refuse("file", en::say("the height map is too small"), en::say("2 x 2 pixels or more"));
  double max_value = 0;
  cv::minMaxLoc(*image, nullptr, &max_value);
  cv::Mat_<float> gap_mm;
  image->convertTo(gap_mm, CV_32F, -height_mm / 255, height_mm * max_value / 255);
  return std::make_shared<HeightMap>(cv::max(gap_mm, 0.0F), mm_per_px);
}

std::shared_ptr<const Body> read_relief(YamlSection& p) {
  const std::vector<std::string_view> shapes{"t_bar", "thread_m8", "picture"};
  const std::string_view shape = shapes[p.choice("shape", shapes)];
  if (shape == "picture") return read_height_map(p);
  const double size = p.number("size_mm", {1, 50});
  if (shape == "thread_m8") return std::make_shared<Thread>(size);
  const double bar = p.number("bar_mm", {0.1, 50});
  if (bar >= size)
    p.refuse("bar_mm", en::say("the bars are wider than the T"), en::say("less than size_mm"));
  return std::make_shared<TBar>(size, bar);
}

class Relief final : public RigidPress {
 public:
  explicit Relief(YamlSection& p) : RigidPress(p) { set_body(read_relief(p)); }
  Message sentence() const override {
    return en::say("An object with a relief is pressed into the face");
  }
};

}  // namespace

const EffectKind& effect_relief() {
  static const EffectKind kKind{
      "relief",
      Stage::kGeometry,
      31,
      [](YamlSection& p) -> std::shared_ptr<const Effect> { return std::make_shared<Relief>(p); },
      "shape: t_bar, size_mm: 12, bar_mm: 3, s_mm: 50, y_mm: 0, depth_mm: 0.9"};
  return kKind;
}

}  // namespace alltact
