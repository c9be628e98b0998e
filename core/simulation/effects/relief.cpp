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
std::shared_ptr<const Body> t_bar(double size_mm, double bar_mm) {
  const auto gap_mm = [size_mm, bar_mm](double along, double across) {
    const double half = size_mm / 2;
    const bool in_bar = along >= half - bar_mm && along <= half && std::abs(across) <= half;
    const bool in_stem = std::abs(across) <= bar_mm / 2 && along >= -half && along <= half;
    return in_bar || in_stem ? 0.0 : HeightField::kNothing_mm;
  };
  return std::make_shared<HeightField>(gap_mm, Eigen::Vector2d(size_mm / 2, size_mm / 2));
}

// ISO 68-1 basic profile: crests P/8 and roots P/4 wide, flanks at 60 degrees, 5/8 H deep with
// H = P sqrt(3)/2, on a cylinder of 8 mm that lies along the finger's length.
std::shared_ptr<const Body> thread_m8(double size_mm) {
  static constexpr double kPitch_mm = 1.25, kRadius_mm = 4.0;
  const auto gap_mm = [size_mm](double along, double across) {
    if (std::abs(across) >= kRadius_mm || std::abs(along) > size_mm / 2)
      return HeightField::kNothing_mm;
    const double turn = std::asin(across / kRadius_mm) / (2 * std::numbers::pi);
    double phase = along / kPitch_mm - turn;
    phase = std::abs(phase - std::round(phase)) * kPitch_mm;  // mm from the nearest crest
    const double flank = std::max(0.0, phase - kPitch_mm / 16) * std::numbers::sqrt3;
    const double radius =
        kRadius_mm - std::min(flank, 0.625 * 0.5 * std::numbers::sqrt3 * kPitch_mm);
    const double up2 = radius * radius - across * across;
    return up2 > 0 ? kRadius_mm - std::sqrt(up2) : HeightField::kNothing_mm;
  };
  return std::make_shared<HeightField>(gap_mm, Eigen::Vector2d(size_mm / 2, kRadius_mm));
}

// Bright is high. Bilinear between pixel centres, with upright walls around.
std::shared_ptr<const Body> height_map(const cv::Mat_<float>& gaps_mm, double mm_per_px) {
  const auto gap_mm = [gaps_mm, mm_per_px](double along, double across) {
    const double column = along / mm_per_px + 0.5 * (gaps_mm.cols - 1);
    const double row = across / mm_per_px + 0.5 * (gaps_mm.rows - 1);
    if (!(column >= 0 && row >= 0 && column <= gaps_mm.cols - 1 && row <= gaps_mm.rows - 1))
      return HeightField::kNothing_mm;
    const int i = std::min(static_cast<int>(column), gaps_mm.cols - 2);
    const int j = std::min(static_cast<int>(row), gaps_mm.rows - 2);
    const double tx = column - i, ty = row - j;
    const double upper = gaps_mm(j, i) + tx * (double{gaps_mm(j, i + 1)} - gaps_mm(j, i));
    const double lower =
        gaps_mm(j + 1, i) + tx * (double{gaps_mm(j + 1, i + 1)} - gaps_mm(j + 1, i));
    return upper + ty * (lower - upper);
  };
  return std::make_shared<HeightField>(
      gap_mm, mm_per_px / 2 * Eigen::Vector2d(gaps_mm.cols - 1, gaps_mm.rows - 1),
      std::min(0.02, mm_per_px / 2));
}

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
  return height_map(cv::Mat_<float>(cv::Mat(cv::max(gap_mm, 0.0F))), mm_per_px);
}

std::shared_ptr<const Body> relief_body(YamlSection& p) {
  const std::vector<std::string_view> shapes{"t_bar", "thread_m8", "picture"};
  const std::string_view shape = shapes[p.choice("shape", shapes)];
  if (shape == "picture") return read_height_map(p);
  const double size = p.number("size_mm", {1, 50});
  if (shape == "thread_m8") return thread_m8(size);
  const double bar = p.number("bar_mm", {0.1, 50});
  if (bar >= size)
    p.refuse("bar_mm", en::say("the bars are wider than the T"), en::say("less than size_mm"));
  return t_bar(size, bar);
}

}  // namespace

EffectKind effect_relief() {
  return effect_kind<RigidPressOf<relief_body>>(
      "relief", 31, en::say("An object with a relief is pressed into the face"),
      "shape: t_bar, size_mm: 12, bar_mm: 3, s_mm: 50, y_mm: 0, depth_mm: 0.9");
}

}  // namespace alltact
