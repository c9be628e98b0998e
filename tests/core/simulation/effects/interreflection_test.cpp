// The light that faces give each other, against closed forms (J. Howell's catalogue, B-3, B-4 and
// C-14) where all is lit evenly, and against fine quadrature in long double where lamps shine.
#include "core/simulation/effect_catalogue.h"
#include "tests/core/simulation/effects/effect_scene.h"
#include "tests/core/simulation/howell.h"

#include <numbers>

#include <Eigen/Geometry>

namespace alltact {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double kBoxLength_mm = 40, kBoxWidth_mm = 24, kBoxDepth_mm = 14, kEvenLight = 100;
constexpr double kBounceFace = 0.5, kBounceSides = 0.3, kBoxAlbedo = 0.4;

// A straight finger in the middle of the picture; without a layer its view face gives back all.
std::string box_text(double incline_deg, const std::string& effects) {
  return fmt::format(
      "name: test\nwhy: a finger whose faces light each other\nfinger:\n"
      "  camera: {{model: pinhole, size: [320, 180], fx: 170, fy: 172, cx: 159.5, cy: 89.5}}\n"
      "  face: {{kind: fin_ray, width_mm: {}, layer_mm: 1.5}}\n"
      "untouched: {{x_mm: -20, z_mm: 40, incline_deg: {}, length_mm: {}}}\nframes: 3\neffects:\n{}"
      "  - {{use: sides, albedo: {}, depth_mm: {}}}\n",
      kBoxWidth_mm, incline_deg, kBoxLength_mm, effects, kBoxAlbedo, kBoxDepth_mm);
}
std::string bounce(double face, double sides) {
  return fmt::format("  - {{use: interreflection, face: {}, sides: {}, depth_mm: {}}}\n", face,
                     sides, kBoxDepth_mm);
}
const std::string kEvenly =
    "  - {use: leds, lamps: [{at_mm: [0, 0, 0], power: 1.0e-9}]}\n"
    "  - {use: ambient, level: 100}\n";

struct SeenOfBox {
  Vector3d at;
  bool on_side;
};
// What a pixel's middle sees of a finger without incline.
std::optional<SeenOfBox> seen_by(int u, int v, double margin_mm) {
  const Vector3d way((u - 159.5) / 170, (v - 89.5) / 172, 1);
  const double half = kBoxWidth_mm / 2;
  SeenOfBox seen{40 * way, false};
  if (std::abs(seen.at.y()) > half) seen = {way * half / std::abs(way.y()), true};
  const auto within = [&](double x, double low, double high) {
    return x > low + margin_mm && x < high - margin_mm;
  };
  if (!within(seen.at.x(), -20, 20)) return std::nullopt;
  if (seen.on_side ? !within(40 - seen.at.z(), 0, kBoxDepth_mm) : !within(seen.at.y(), -half, half))
    return std::nullopt;
  return seen;
}

// An upright rectangle that reaches to `before` and `after` the point.
long double upright(long double height, long double before, long double after, long double away) {
  return howell_b4(height, before, away) + howell_b4(height, after, away);
}

double even_truth(const SeenOfBox& seen) {
  const long double before = seen.at.x() + 20, after = 20 - seen.at.x(), half = kBoxWidth_mm / 2;
  if (!seen.on_side)
    return static_cast<double>(kEvenLight * kBounceSides *
                               (upright(kBoxDepth_mm, before, after, half + seen.at.y()) +
                                upright(kBoxDepth_mm, before, after, half - seen.at.y())));
  const long double behind = 40 - seen.at.z(), rest = kBoxDepth_mm - behind;
  const long double other =
      howell_b3(before, behind, kBoxWidth_mm) + howell_b3(after, behind, kBoxWidth_mm) +
      howell_b3(before, rest, kBoxWidth_mm) + howell_b3(after, rest, kBoxWidth_mm);
  return static_cast<double>(
      kEvenLight *
      (kBounceFace * upright(kBoxWidth_mm, before, after, behind) + kBounceSides * other));
}

TEST(Interreflection, OfEvenlyLitFacesIsHowells) {
  const cv::Mat_<float> plain = rendered(box_text(0, kEvenly));
  const cv::Mat_<float> lit = rendered(box_text(0, kEvenly + bounce(kBounceFace, kBounceSides)));
  Moments off;
  double worst = 0;
  int on_sides = 0;
  for_pixels(plain.size(), 1, [&](int v, int u) {
    const auto seen = seen_by(u, v, 0.3);
    if (!seen) return;
    const double gives_back = seen->on_side ? kBoxAlbedo : 1;
    const double error = (lit(v, u) - plain(v, u)) / gives_back - even_truth(*seen);
    off.add(error);
    worst = std::max(worst, std::abs(error));
    on_sides += seen->on_side;
  });
  EXPECT_GT(off.n, 20000);
  EXPECT_GT(on_sides, 5000);
  // Of 100: what linear interpolation on the lattice leaves, most of it at the corners.
  std::printf("[ figures  ] mean %.3f sd %.3f worst %.3f\n", off.mean(), std::sqrt(off.variance()),
              worst);
  EXPECT_LT(std::abs(off.mean()), 0.08);
  EXPECT_LT(std::sqrt(off.variance()), 0.15);
  EXPECT_LT(worst, 0.9);
}

TEST(Interreflection, OnTheWholeViewFaceIsHowellsC14) {
  const cv::Mat_<float> plain = rendered(box_text(0, kEvenly));
  const cv::Mat_<float> lit = rendered(box_text(0, kEvenly + bounce(kBounceFace, 1)));
  Moments share;
  for_pixels(plain.size(), 1, [&](int v, int u) {
    const auto seen = seen_by(u, v, 0);
    if (seen && !seen->on_side) share.add((lit(v, u) - plain(v, u)) / kEvenLight);
  });
  EXPECT_NEAR(share.mean(),
              static_cast<double>(2 * howell_c14(kBoxWidth_mm, kBoxLength_mm, kBoxDepth_mm)),
              0.003);
}

// An independent world: the finger inclined, two lamps, the clear body absorbing; patches of
// 0.25 mm, and no form factor but cos cos / (pi r^2).
struct LampLit {
  double incline_rad, absorb_per_mm;
  struct Patch {
    Vector3d at, normal;
    double light_area;  // rho E dA
  };

  [[nodiscard]] Vector3d along() const { return {std::cos(incline_rad), 0, std::sin(incline_rad)}; }
  [[nodiscard]] Vector3d inward() const {
    return {std::sin(incline_rad), 0, -std::cos(incline_rad)};
  }
  [[nodiscard]] static double lamp(const Vector3d& at, const Vector3d& from, double power,
                                   const Vector3d& normal, double per_mm) {
    const Vector3d way = from - at;
    const double r = way.norm();
    return power * std::max(0.0, normal.dot(way)) / (r * r * r) * std::exp(-per_mm * r);
  }
  [[nodiscard]] double direct(const Vector3d& at, const Vector3d& normal) const {
    return 5 + lamp(at, {1, -3, -2}, 300000, normal, absorb_per_mm) +
           lamp(at, {9, 4, 0}, 200000, normal, absorb_per_mm);
  }
  [[nodiscard]] std::vector<Patch> patches() const {
    constexpr double kStep = 0.25;
    std::vector<Patch> all;
    const Vector3d base(-20, 0, 40);
    const auto add = [&](const Vector3d& at, const Vector3d& normal, double albedo) {
      all.push_back({at, normal, albedo * direct(at, normal) * kStep * kStep});
    };
    for (double s = kStep / 2; s < kBoxLength_mm; s += kStep) {
      for (double y = kStep / 2; y < kBoxWidth_mm; y += kStep)
        add(base + s * along() + Vector3d(0, y - kBoxWidth_mm / 2, 0), inward(), kBounceFace);
      for (double d = kStep / 2; d < kBoxDepth_mm; d += kStep)
        for (const double side : {-1.0, 1.0})
          add(base + s * along() + d * inward() + Vector3d(0, side * kBoxWidth_mm / 2, 0),
              {0, -side, 0}, kBounceSides);
    }
    return all;
  }
  [[nodiscard]] double bounce_at(const Vector3d& at, const Vector3d& normal,
                                 const std::vector<Patch>& all) const {
    long double sum = 0;
    for (const Patch& patch : all) {
      const Vector3d way = patch.at - at;
      const double r2 = way.squaredNorm();
      const double here = normal.dot(way), there = -patch.normal.dot(way);
      if (here <= 1e-9 || there <= 1e-9) continue;
      sum += static_cast<long double>(here * there * patch.light_area *
                                      std::exp(-absorb_per_mm * std::sqrt(r2))) /
             (std::numbers::pi_v<long double> * r2 * r2);
    }
    return static_cast<double>(sum);
  }
};

TEST(Interreflection, OfLampsIsTheQuadratureOfTheEquation) {
  for (const auto& [incline_deg, per_mm] : {std::pair(0.0, 0.0), {20.0, 0.0}, {12.0, 0.004}}) {
    SCOPED_TRACE(incline_deg);
    const LampLit world{incline_deg * std::numbers::pi / 180, per_mm};
    const auto patches = world.patches();
    const std::string lamps =
        "  - {use: leds, lamps: [{at_mm: [1, -3, -2], power: 300000}, "
        "{at_mm: [9, 4, 0], power: 200000}]}\n  - {use: ambient, level: 5}\n" +
        (per_mm > 0 ? fmt::format("  - {{use: absorption, per_mm: {}}}\n", per_mm) : "");
    const cv::Mat_<float> plain = rendered(box_text(incline_deg, lamps));
    const cv::Mat_<float> lit =
        rendered(box_text(incline_deg, lamps + bounce(kBounceFace, kBounceSides)));
    int compared = 0;
    double greatest = 0;
    for_pixels(plain.size(), 7, [&](int v, int u) {
      const Vector3d way((u - 159.5) / 170, (v - 89.5) / 172, 1);
      // The ray meets the inclined plane through the base.
      const double z = world.inward().dot(Vector3d(-20, 0, 40)) / world.inward().dot(way);
      const bool on_side = std::abs(z * way.y()) > kBoxWidth_mm / 2;
      const Vector3d at =
          on_side ? Vector3d(way * (kBoxWidth_mm / 2 / std::abs(way.y()))) : Vector3d(way * z);
      const Vector3d from_base = at - Vector3d(-20, 0, 40);
      const double s = from_base.dot(world.along()), behind = from_base.dot(world.inward());
      if (s < 1 || s > kBoxLength_mm - 1) return;
      if (on_side ? behind < 1 || behind > kBoxDepth_mm - 1
                  : std::abs(at.y()) > kBoxWidth_mm / 2 - 1)
        return;
      const Vector3d normal =
          on_side ? Vector3d(0, way.y() > 0 ? -1 : 1, 0) : Vector3d(world.inward());
      const double truth = world.bounce_at(at, normal, patches) * (on_side ? kBoxAlbedo : 1) *
                           std::exp(-world.absorb_per_mm * at.norm());
      EXPECT_NEAR(lit(v, u) - plain(v, u), truth, 0.025 * truth + 0.1) << u << ' ' << v;
      greatest = std::max(greatest, truth);
      ++compared;
    });
    EXPECT_GT(compared, 150);
    EXPECT_GT(greatest, 15);
  }
}

// With white faces in random light, all that is lit again is less than what was lit.
TEST(Interreflection, GivesNoMoreThanComesIn) {
  Parameters random(21);
  for (int i = 0; i < 6; ++i) {
    const std::string lamps =
        fmt::format("  - {{use: leds, lamps: [{{at_mm: [{}, {}, {}], power: 300000}}]}}\n",
                    random.between(-15, 15), random.between(-8, 8), random.between(0, 15));
    const cv::Mat_<float> plain = rendered(box_text(0, lamps));
    const cv::Mat_<float> lit = rendered(box_text(0, lamps + bounce(1, 1)));
    double in = 0, again = 0;
    for_pixels(plain.size(), 1, [&](int v, int u) {
      const auto seen = seen_by(u, v, 0);
      if (!seen) return;
      // Area that the pixel sees: z^3 du dv / (fx fy |n . p|).
      const double across = seen->on_side ? std::abs(seen->at.y()) : seen->at.z();
      const double area = std::pow(seen->at.z(), 3) / (170.0 * 172.0 * across);
      const double per_light = area / (seen->on_side ? kBoxAlbedo : 1);
      in += per_light * plain(v, u);
      again += per_light * (lit(v, u) - plain(v, u));
    });
    EXPECT_LT(again, in);
    EXPECT_GT(again, 0.1 * in);  // the faces do see each other
  }
}

TEST(Interreflection, IsTheSameBytesWithAnyNumberOfThreads) {
  const std::string text = example_scene({"interreflection", "sway", "absorption"});
  const Plan plan = plan_of(text), again = plan_of(text);
  for (const int frame : {0, 7}) {
    const cv::Mat one = plan.render(frame, 1);
    for (const int threads : {2, 3}) EXPECT_TRUE(same_bytes(again.render(frame, threads), one));
  }
}

TEST(Interreflection, ChangesNoFrameWithoutIt) {
  const std::string lamps = kFaceAndLamps + "  - {use: absorption, per_mm: 0.003}\n";
  const std::string sides = "  - {use: sides, albedo: 0.2, depth_mm: 14}\n";
  const Plan plain = plan_of(scene_text(lamps + sides));
  const Plan partly = plan_of(scene_text(
      lamps + sides +
      "  - {use: interreflection, face: 0.47, sides: 0.2, depth_mm: 14, from: 1, until: 2}\n"));
  EXPECT_TRUE(same_bytes(partly.render(0), plain.render(0)));
  EXPECT_FALSE(same_bytes(partly.render(1), plain.render(1)));
  EXPECT_TRUE(same_bytes(partly.render(2), plain.render(2)));
}

TEST(Interreflection, NeedsFacesThatAreLit) {
  EXPECT_THAT(refusal(flat_text(kFaceAndLamps + bounce(0.5, 0.5))), HasSubstr("sides and leds"));
  EXPECT_THAT(
      refusal(scene_text(bounce(0.5, 0.5) + "  - {use: sides, albedo: 0.2, depth_mm: 9}\n")),
      HasSubstr("sides and leds"));
  EXPECT_THAT(refusal(box_text(0, kEvenly + bounce(0, 0.5))), HasSubstr("leave it out"));
}

}  // namespace
}  // namespace alltact
