// An object with a relief is pressed into the face: a T of two bars, an M8 thread lying on its
// side, or any height map. Its highest point goes `depth_mm` in along z; the object follows the
// face where that is bent.
#include "core/io/picture.h"
#include "core/simulation/effect.h"
#include "core/simulation/give.h"

#include <filesystem>
#include <numbers>

namespace alltact {

namespace {

constexpr double kStep_mm = 0.05;
constexpr double kFarBelow_mm = 1e3;

// The gap functions say how far the object's surface lies below its highest point.

// Cross bar and stem, walls upright, centred on its bounding box.
struct TBar {
  double size_mm, bar_mm;
  double operator()(double along, double across) const {
    const double half = size_mm / 2;
    const bool in_bar = along >= half - bar_mm && along <= half && std::abs(across) <= half;
    const bool in_stem = std::abs(across) <= bar_mm / 2 && along >= -half && along <= half;
    return in_bar || in_stem ? 0.0 : kFarBelow_mm;
  }
};

// ISO 68-1 basic profile: crests P/8 and roots P/4 wide, flanks at 60 degrees, 5/8 H deep with
// H = P sqrt(3)/2, on a cylinder of 8 mm that lies along the finger's length.
struct Thread {
  double size_mm;
  static constexpr double kPitch_mm = 1.25, kRadius_mm = 4.0;
  double operator()(double along, double across) const {
    if (std::abs(across) >= kRadius_mm || std::abs(along) > size_mm / 2) return kFarBelow_mm;
    const double turn = std::asin(across / kRadius_mm) / (2 * std::numbers::pi);
    double phase = along / kPitch_mm - turn;
    phase = std::abs(phase - std::round(phase)) * kPitch_mm;  // mm from the nearest crest
    const double flank = std::max(0.0, phase - kPitch_mm / 16) * std::numbers::sqrt3;
    const double radius =
        kRadius_mm - std::min(flank, 0.625 * 0.5 * std::numbers::sqrt3 * kPitch_mm);
    const double up2 = radius * radius - across * across;
    return up2 > 0 ? kRadius_mm - std::sqrt(up2) : kFarBelow_mm;
  }
};

template <class Gap>
cv::Mat_<float> tabulate(const Gap& gap, double size_mm) {
  const int n = 2 * static_cast<int>(std::ceil(size_mm / 2 / kStep_mm)) + 5;
  cv::Mat_<float> grid(n, n);
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column)
      grid(row, column) =
          static_cast<float>(gap((column - n / 2) * kStep_mm, (row - n / 2) * kStep_mm));
  return grid;
}

class Relief final : public GeometryEffect {
 public:
  explicit Relief(YamlSection& p)
      : depth_(Varying::read(p, "depth_mm", strength_up_to(20))),
        s_(Varying::read(p, "s_mm", {-1000, 1000})),
        y_(Varying::read(p, "y_mm", {-1000, 1000})),
        rotation_deg_(Varying::read_or(p, "rotation_deg", 0, {-360, 360})),
        give_(p) {
    const std::vector<std::string_view> shapes{"t_bar", "thread_m8", "picture"};
    const std::string_view shape = shapes[p.choice("shape", shapes)];
    if (shape == "picture") {
      read_picture(p);
      return;
    }
    const double size = p.number("size_mm", {1, 50});
    if (shape == "thread_m8") {
      gap_mm_ = tabulate(Thread{size}, std::max(size, 2 * Thread::kRadius_mm));
      return;
    }
    const double bar = p.number("bar_mm", {0.1, 50});
    if (bar >= size)
      p.refuse("bar_mm", en::say("the bars are wider than the T"), en::say("less than size_mm"));
    gap_mm_ = tabulate(TBar{size, bar}, size);
  }

  Message sentence() const override {
    return en::say("An object with a relief is pressed into the face");
  }
  bool may_be_several() const override { return true; }

  Status fits(const SceneFacts& scene) const override {
    if (const Status status = press_fits(scene, depth_, s_, y_); !status) return status;
    return give_.fits(scene);
  }

  void shape(const FrameContext& frame, FaceCurve& curve) const override {
    give_.shape(frame, s_, curve);
  }

  void place(const FrameContext& frame, FrameGeometry& geometry) const override {
    ReliefPress press;
    press.place = geometry.press_place(frame(s_), frame(y_), frame(depth_));
    press.rotation_rad = frame(rotation_deg_) * std::numbers::pi / 180;
    press.step_mm = step_mm_;
    press.depth_mm = cv::max(press.place.normal_depth_mm() - gap_mm_, 0.0);
    geometry.presses.emplace_back(std::move(press));
  }

 private:
  void read_picture(YamlSection& p) {
    step_mm_ = p.number("mm_per_px", strength_up_to(10));
    const double height_mm = p.number("height_mm", strength_up_to(100));
    const std::filesystem::path beside = p.file().path().parent_path();
    const auto picture = read_grey_picture(beside / p.text("file"));
    if (!picture) p.refuse("file", picture.error().what, picture.error().advice);
    double greatest = 0;
    cv::minMaxLoc(*picture, nullptr, &greatest);
    picture->convertTo(gap_mm_, CV_32F, -height_mm / 255, height_mm * greatest / 255);
    cv::copyMakeBorder(gap_mm_, gap_mm_, 2, 2, 2, 2, cv::BORDER_CONSTANT, cv::Scalar(kFarBelow_mm));
  }

  Varying depth_, s_, y_, rotation_deg_;
  Give give_;
  cv::Mat_<float> gap_mm_;
  double step_mm_ = kStep_mm;
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
