#include "tests/calibration/verdict/campaign_world.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact::test {
namespace {

/// std::uniform_real_distribution differs between libraries; these do not.
double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}
bool chance(std::mt19937_64& random, double share) { return uniform(random, 0, 1) < share; }
int whole(std::mt19937_64& random, int low, int high) {
  return low + static_cast<int>(uniform(random, 0, 1) * (high - low + 1));
}
/// Box and Muller.
double normal(std::mt19937_64& random) {
  const double radius = std::sqrt(-2 * std::log(1 - uniform(random, 0, 1)));
  return radius * std::cos(2 * CV_PI * uniform(random, 0, 1));
}

/// Normal numbers by the handful: one of 65536 that were drawn before, sixteen bits each.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : random_(seed) {}
  float operator()() {
    static const std::vector<float> kTable = [] {
      std::mt19937_64 random(4711);
      std::vector<float> table(1 << 16);
      for (float& value : table) value = static_cast<float>(normal(random));
      return table;
    }();
    if (left_ == 0) bits_ = random_(), left_ = 4;
    --left_;
    const float value = kTable[bits_ & 0xFFFFU];
    bits_ >>= 16U;
    return value;
  }

 private:
  std::mt19937_64 random_;
  std::uint64_t bits_ = 0;
  int left_ = 0;
};

/// Blurs what has no detail finer than `sigma_px`, at a third of the resolution.
cv::Mat1f wide_blur(const cv::Mat1f& image, double sigma_px) {
  constexpr int kStep = 3;  // sides of an image are multiples of it
  cv::Mat1f small, large;
  cv::resize(image, small, image.size() / kStep, 0, 0, cv::INTER_AREA);
  cv::GaussianBlur(small, small, {0, 0}, sigma_px / kStep);
  cv::resize(small, large, image.size(), 0, 0, cv::INTER_LINEAR);
  return large;
}

/// Reflectance of a layer over a coat: Kubelka 1948, eq. 18.
double reflectance(double thickness_mm, double absorb_per_mm, double scatter_per_mm, double coat) {
  const double a = (scatter_per_mm + absorb_per_mm) / scatter_per_mm;
  const double b = std::sqrt(a * a - 1);
  const double coth = 1 / std::tanh(b * scatter_per_mm * thickness_mm);
  return (1 - coat * (a - b * coth)) / (a - coat + b * coth);
}

/// Height of an indenter over the untouched face, mm; negative: it does not reach it.
double height_mm(const Indenter& one, double x_mm, double y_mm) {
  const double x = x_mm - one.position_mm.x, y = y_mm - one.position_mm.y;
  const double away = std::hypot(x, y);
  switch (one.kind) {
    case IndenterKind::kBall: {
      const double below = one.radius_mm * one.radius_mm - away * away;
      return below > 0 ? one.depth_mm - one.radius_mm + std::sqrt(below) : -1;
    }
    case IndenterKind::kPunch:
    case IndenterKind::kPin:
      return away < one.radius_mm ? one.depth_mm : -1;
    case IndenterKind::kEdge:
      return std::abs(x * std::cos(one.angle_rad) + y * std::sin(one.angle_rad)) < one.radius_mm
                 ? one.depth_mm
                 : -1;
  }
  return -1;
}

/// min over q of (start(q) + |p - q|), px, by two passes of a chamfer mask (Borgefors 1986).
void spread_distance(cv::Mat1f& distance) {
  struct Step {
    int du, dv;
    float length;
  };
  static const Step kSteps[] = {{-1, 0, 1.0F},     {0, -1, 1.0F},      {-1, -1, 1.41421F},
                                {1, -1, 1.41421F}, {-2, -1, 2.23607F}, {-1, -2, 2.23607F},
                                {1, -2, 2.23607F}, {2, -1, 2.23607F}};
  const auto pass = [&](int sign) {
    for (int i = 0; i < distance.rows; ++i) {
      const int v = sign > 0 ? i : distance.rows - 1 - i;
      for (int j = 0; j < distance.cols; ++j) {
        const int u = sign > 0 ? j : distance.cols - 1 - j;
        float& nearest = distance(v, u);
        for (const Step& step : kSteps) {
          const int from_u = u + sign * step.du, from_v = v + sign * step.dv;
          if (from_u < 0 || from_v < 0 || from_u >= distance.cols || from_v >= distance.rows)
            continue;
          nearest = std::min(nearest, distance(from_v, from_u) + step.length);
        }
      }
    }
  };
  pass(1);
  pass(-1);
}

}  // namespace

const char* to_string(IndenterKind kind) {
  switch (kind) {
    case IndenterKind::kBall:
      return "ball";
    case IndenterKind::kPunch:
      return "punch";
    case IndenterKind::kPin:
      return "pin";
    case IndenterKind::kEdge:
      return "edge";
  }
  return "";
}

std::string CampaignFaults::names() const {
  std::string all;
  const auto add = [&](bool is_there, const std::string& name) {
    if (is_there) all += (all.empty() ? "" : " ") + name;
  };
  add(radius_factor != 1, fmt::format("radius*{:.2f}", radius_factor));
  add(layer_factor != 1, fmt::format("layer*{:.2f}", layer_factor));
  add(scale_factor != 1, fmt::format("scale*{:.2f}", scale_factor));
  add(camera_shift_px != cv::Point2d(),
      fmt::format("moved={:.1f}px", std::hypot(camera_shift_px.x, camera_shift_px.y)));
  add(exposure_sd > 0, fmt::format("exposure={:.3f}", exposure_sd));
  add(lamp_drift != 0 || drift_slope != 0,
      fmt::format("drift={:+.3f}/{:+.3f}", lamp_drift, drift_slope));
  add(reference_touch_mm > 0, fmt::format("touched={:.2f}mm", reference_touch_mm));
  add(is_defocused, "defocus");
  add(jpeg_quality > 0, fmt::format("jpeg={}", jpeg_quality));
  add(has_few_presses, "few");
  add(is_at_one_position, "one-position");
  add(is_all_shallow, "shallow");
  add(is_all_deep, "deep");
  return all;
}

CampaignWorld::CampaignWorld(std::uint64_t seed) : seed_(seed) {
  Random random(seed * 0x9E3779B97F4A7C15U + 1);
  draw_finger(random);
  draw_faults(random);
  draw_presses(random);
  draw_contacts(random);
  light_ = light(faults.camera_shift_px, faults.lamp_drift, faults.drift_slope);
}

void CampaignWorld::draw_finger(Random& random) {
  mm_per_px = uniform(random, 0.12, 0.18);
  layer_mm = uniform(random, 1.2, 3.0);
  scatter_per_mm_ = uniform(random, 0.3, 1.2);
  absorb_per_mm_ = uniform(random, 0.002, 0.06);
  coat_ = uniform(random, 0.0, 0.06);
  scatter_slope_ = 0.04 * normal(random);
  scatter_bow_ = 0.02 * normal(random);
  layer_slope_ = 0.02 * normal(random);
  skirt_share_ = chance(random, 0.5) ? uniform(random, 0.0, 0.6) : 0.0;
  skirt_mm_ = layer_mm * uniform(random, 0.6, 1.3);
  lift_off_mm_ = uniform(random, 0.05, 0.3);
  bulge_ = chance(random, 0.5) ? uniform(random, 0.0, 0.3) : 0.0;
  level_ = uniform(random, 110, 220);
  fall_ = uniform(random, 0.0, 0.9);
  side_ = uniform(random, -0.2, 0.2);
  vignette_ = uniform(random, 0.0, 0.3);
  texture_ = uniform(random, 0.002, 0.02);
  blur_px_ = uniform(random, 0.3, 0.8);
  shot_ = uniform(random, 0.002, 0.02);
  read_sd_ = uniform(random, 0.3, 1.2);
}

/// Two fifths of the campaigns are as they should be; the others have one fault, some of them two.
void CampaignWorld::draw_faults(Random& random) {
  if (chance(random, 0.4)) return;
  const int count = chance(random, 0.25) ? 2 : 1;
  for (int i = 0; i < count; ++i) {
    const double sign = chance(random, 0.5) ? 1 : -1;
    switch (whole(random, 1, 13)) {
      case 1: {
        static const double kWrong[] = {0.05, 0.10, 0.30, 1.0};
        const double factor = 1 + kWrong[whole(random, 0, 3)];
        faults.radius_factor = sign > 0 ? factor : 1 / factor;
        break;
      }
      case 2:
        faults.layer_factor = 1 + sign * uniform(random, 0.1, 0.4);
        break;
      case 3:
        faults.scale_factor = 1 + sign * uniform(random, 0.03, 0.3);
        break;
      case 4: {
        const double angle = uniform(random, 0, 2 * CV_PI), length = uniform(random, 1, 3);
        faults.camera_shift_px = {length * std::cos(angle), length * std::sin(angle)};
        break;
      }
      case 5:
        faults.exposure_sd = uniform(random, 0.01, 0.08);
        break;
      case 6:
        faults.lamp_drift = sign * uniform(random, 0.01, 0.08);
        faults.drift_slope = chance(random, 0.5) ? 0.03 * normal(random) : 0.0;
        break;
      case 7:
        faults.reference_touch_mm = uniform(random, 0.05, 0.25) * layer_mm;
        break;
      case 8:
        faults.is_defocused = true;
        break;
      case 9:
        faults.jpeg_quality = whole(random, 40, 90);
        break;
      case 10:
        faults.has_few_presses = true;
        break;
      case 11:
        faults.is_at_one_position = true;
        break;
      case 12:
        faults.is_all_shallow = true;
        break;
      default:
        faults.is_all_deep = true;
        break;
    }
  }
  if (faults.is_all_shallow && faults.is_all_deep) faults.is_all_deep = false;
  if (faults.is_defocused) blur_px_ = uniform(random, 1.5, 3.0);
}

cv::Point2d CampaignWorld::position(Random& random, double margin_mm) const {
  const double x = std::max(0.0, mm_per_px * kWidthPx / 2 - margin_mm),
               y = std::max(0.0, mm_per_px * kHeightPx / 2 - margin_mm);
  return {uniform(random, -x, x), uniform(random, -y, y)};
}

void CampaignWorld::draw_presses(Random& random) {
  const int count = faults.has_few_presses ? whole(random, 1, 3) : whole(random, 6, 14);
  const double radius_mm = uniform(random, 2.0, 5.0);
  const bool has_two_balls = chance(random, 0.25);
  const cv::Point2d one = position(random, 4.0);
  for (int i = 0; i < count; ++i) {
    Indenter press;
    press.radius_mm = has_two_balls && i % 2 == 1 ? 1.5 * radius_mm : radius_mm;
    double low = 0.08, high = 0.40;
    if (faults.is_all_shallow) high = 0.12;
    if (faults.is_all_deep) low = 0.34;
    // From shallow to deep in turn, as a person presses who was asked for both.
    const double turn = (i % 3 + uniform(random, 0, 1)) / 3;
    press.depth_mm = layer_mm * (low + (high - low) * turn);
    // The contact whole on the face, over all of its length in turn.
    const double contact_mm = std::sqrt(2 * press.radius_mm * press.depth_mm);
    press.position_mm = position(random, contact_mm + 0.5);
    const double third = mm_per_px * kWidthPx / 3 - 0.67 * contact_mm;
    press.position_mm.x = third * ((i / 3 + i) % 3 - 1) + uniform(random, -1.0, 1.0);
    if (faults.is_at_one_position)
      press.position_mm = one + cv::Point2d(0.2 * normal(random), 0.2 * normal(random));
    presses.push_back(press);
  }
}

void CampaignWorld::draw_contacts(Random& random) {
  constexpr int kContacts = 24;
  for (int i = 0; i < kContacts; ++i) {
    Indenter contact;
    contact.kind = i % 8 < 4   ? IndenterKind::kBall
                   : i % 8 < 6 ? IndenterKind::kPunch
                   : i % 8 < 7 ? IndenterKind::kPin
                               : IndenterKind::kEdge;
    switch (contact.kind) {
      case IndenterKind::kBall:
        contact.radius_mm = uniform(random, 1.5, 8.0);
        break;
      case IndenterKind::kPunch:
        contact.radius_mm = uniform(random, 1.0, 3.0);
        break;
      case IndenterKind::kPin:
        contact.radius_mm = uniform(random, 0.4, 0.8);
        break;
      case IndenterKind::kEdge:
        contact.radius_mm = uniform(random, 0.4, 1.0);
        break;
    }
    contact.depth_mm = layer_mm * uniform(random, 0.06, 0.40);
    contact.position_mm = position(random, 2.0);
    contact.angle_rad = uniform(random, 0, CV_PI);
    contacts.push_back(contact);
  }
}

std::string CampaignWorld::traits() const {
  return fmt::format(
      "layer={:.2f} S={:.2f} vary={:+.2f}/{:+.2f} skirt={:.2f} lift={:.2f} bulge={:.2f} "
      "noise={:.2f} "
      "n={}",
      layer_mm, scatter_per_mm_, scatter_slope_, scatter_bow_, skirt_share_, lift_off_mm_, bulge_,
      read_sd_, presses.size());
}

void CampaignWorld::press_in(const Indenter& indenter, PaintedFrame& frame) const {
  const double lift_px = lift_off_mm_ / mm_per_px;
  cv::Mat1f height(kHeightPx, kWidthPx), start(kHeightPx, kWidthPx);
  for (int v = 0; v < kHeightPx; ++v) {
    for (int u = 0; u < kWidthPx; ++u) {
      const double h = height_mm(indenter, mm_per_px * (u - (kWidthPx - 1) / 2.0),
                                 mm_per_px * (v - (kHeightPx - 1) / 2.0));
      height(v, u) = static_cast<float>(h);
      start(v, u) = h > 0 ? static_cast<float>(-lift_px * std::log(h)) : 1e6F;
    }
  }
  cv::Mat1f distance = start.clone();
  spread_distance(distance);
  frame.contact = cv::Mat1b::zeros(kHeightPx, kWidthPx);
  frame.depth_mm = cv::Mat1f::zeros(kHeightPx, kWidthPx);
  for (int v = 0; v < kHeightPx; ++v) {
    for (int u = 0; u < kWidthPx; ++u) {
      const bool touches = height(v, u) > 0 && distance(v, u) >= start(v, u) - 1e-3F;
      frame.contact(v, u) = touches ? 255 : 0;
      frame.depth_mm(v, u) =
          touches ? height(v, u) : static_cast<float>(std::exp(-distance(v, u) / lift_px));
    }
  }
  if (bulge_ == 0) return;
  constexpr double kBesideMm = 0.3;  // over which skin that is lifted comes away from the indenter
  const cv::Mat1f blurred = wide_blur(frame.depth_mm, 0.6 * layer_mm / mm_per_px);
  cv::Mat1f beside;
  cv::distanceTransform(255 - frame.contact, beside, cv::DIST_L2, cv::DIST_MASK_5);
  for (int v = 0; v < kHeightPx; ++v)
    for (int u = 0; u < kWidthPx; ++u)
      frame.depth_mm(v, u) -= static_cast<float>(
          bulge_ * blurred(v, u) * (1 - std::exp(-beside(v, u) * mm_per_px / kBesideMm)));
}

cv::Mat1f CampaignWorld::darkening(const cv::Mat1f& depth_mm) const {
  constexpr float kNothingMm = 1e-5F;
  cv::Mat1f local = cv::Mat1f::zeros(depth_mm.size());
  for (int v = 0; v < depth_mm.rows; ++v) {
    for (int u = 0; u < depth_mm.cols; ++u) {
      if (std::abs(depth_mm(v, u)) < kNothingMm) continue;
      const double x = across(u, depth_mm.cols), y = across(v, depth_mm.rows);
      const double scatter =
          scatter_per_mm_ * (1 + scatter_slope_ * x + scatter_bow_ * (x * x + y * y - 1));
      const double layer = layer_mm * (1 + layer_slope_ * x);
      const double left_mm = std::max(0.02 * layer, layer - depth_mm(v, u));
      local(v, u) = static_cast<float>(1 - reflectance(left_mm, absorb_per_mm_, scatter, coat_) /
                                               reflectance(layer, absorb_per_mm_, scatter, coat_));
    }
  }
  if (skirt_share_ == 0) return local;
  const cv::Mat1f near = wide_blur(local, 0.5 * skirt_mm_ / mm_per_px);
  const cv::Mat1f far = wide_blur(local, 1.2 * skirt_mm_ / mm_per_px);
  return (1 - skirt_share_) * local + 0.5 * skirt_share_ * (near + far);
}

cv::Mat1f CampaignWorld::light(cv::Point2d shift_px, double drift, double slope) const {
  // Texture lies on the skin: it is drawn larger than the image and moves with the camera.
  constexpr int kRim = 8;
  Noise noise(seed_ + 77);
  cv::Mat1f texture(kHeightPx + 2 * kRim, kWidthPx + 2 * kRim);
  for (float& grain : texture) grain = noise();
  constexpr double kGrainPx = 2.0;
  cv::GaussianBlur(texture, texture, {0, 0}, kGrainPx);
  texture *= texture_ * 2 * std::sqrt(CV_PI) * kGrainPx;  // a standard deviation of texture_ again
  cv::Mat1f moved;
  const cv::Matx23d move(1, 0, shift_px.x - kRim, 0, 1, shift_px.y - kRim);
  cv::warpAffine(texture, moved, move, {kWidthPx, kHeightPx}, cv::INTER_CUBIC);
  cv::Mat1f level(kHeightPx, kWidthPx);
  for (int v = 0; v < kHeightPx; ++v) {
    for (int u = 0; u < kWidthPx; ++u) {
      const double x = across(u - shift_px.x, kWidthPx), y = across(v - shift_px.y, kHeightPx);
      const double lens_x = across(u, kWidthPx), lens_y = across(v, kHeightPx);
      level(v, u) = static_cast<float>(level_ * std::exp(-fall_ * (x + 1) / 2) * (1 + side_ * y) /
                                       (1 + std::abs(side_)) *
                                       (1 - vignette_ * (lens_x * lens_x + lens_y * lens_y) / 2) *
                                       (1 + moved(v, u)) * (1 + drift) * (1 + slope * x));
    }
  }
  return level;
}

cv::Mat CampaignWorld::seen(cv::Mat1f level, std::uint64_t noise_seed) const {
  cv::GaussianBlur(level, level, {0, 0}, blur_px_);
  Noise noise(seed_ * 1000003 + noise_seed);
  cv::Mat1b grey(level.size());
  for (int v = 0; v < level.rows; ++v) {
    for (int u = 0; u < level.cols; ++u) {
      const double sd = std::sqrt(read_sd_ * read_sd_ + shot_ * std::max(0.0F, level(v, u)));
      grey(v, u) = cv::saturate_cast<std::uint8_t>(level(v, u) + sd * noise());
    }
  }
  if (faults.jpeg_quality == 0) return grey;
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", grey, bytes, {cv::IMWRITE_JPEG_QUALITY, faults.jpeg_quality});
  return cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
}

cv::Mat CampaignWorld::reference() const {
  cv::Mat1f level = light({}, 0, 0);
  if (faults.reference_touch_mm > 0) {
    Random random(seed_ + 5);
    Indenter finger;
    finger.radius_mm = uniform(random, 2.0, 8.0);
    finger.depth_mm = faults.reference_touch_mm;
    finger.position_mm = position(random, 3.0);
    PaintedFrame touched;
    press_in(finger, touched);
    level = level.mul(1 - darkening(touched.depth_mm));
  }
  return seen(level, 0);
}

PaintedFrame CampaignWorld::pressed(const Indenter& indenter, int frame) const {
  PaintedFrame painted;
  press_in(indenter, painted);
  Random random(seed_ * 7919 + static_cast<std::uint64_t>(frame));
  const double gain = 1 + faults.exposure_sd * normal(random);
  painted.grey = seen(gain * light_.mul(1 - darkening(painted.depth_mm)),
                      static_cast<std::uint64_t>(frame) + 1);
  return painted;
}

}  // namespace alltact::test
