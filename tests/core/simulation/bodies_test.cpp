// Rigid bodies that are pressed in, against closed forms and against one another.
#include "core/mesh/mesh_file.h"
#include "tests/core/simulation/scene_text.h"
#include "tests/support/temporary_folder.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

constexpr double kMmPerPx = 0.05;

// An orthographic flat sensor: pixel (u, v) lies over ((u - 160) 0.05, (v - 90) 0.05) mm.
std::string flat_sensor(const std::string& effects) {
  return "name: test\nwhy: bodies on a flat sensor\nfinger:\n"
         "  camera: {model: orthographic, size: [321, 181], cx: 160, cy: 90, mm_per_px: 0.05}\n"
         "  face: {kind: flat, layer_mm: 2.0, plane_z_mm: 20}\nframes: 1\neffects:\n" +
         effects;
}

// The greatest difference from a depth given by place, leaving out pixels whose neighbours' depth
// differs by more than `steepest` (walls, where a pixel is on either side).
template <class Depth>
double worst_error(const cv::Mat& depth_mm, const Depth& expected, double steepest = 0.4) {
  double worst = 0;
  for (int v = 1; v + 1 < depth_mm.rows; ++v)
    for (int u = 1; u + 1 < depth_mm.cols; ++u) {
      const double x = (u - 160) * kMmPerPx, y = (v - 90) * kMmPerPx, here = expected(x, y);
      const double step = kMmPerPx;
      const bool wall = std::abs(expected(x + step, y) - here) > steepest ||
                        std::abs(expected(x - step, y) - here) > steepest ||
                        std::abs(expected(x, y + step) - here) > steepest ||
                        std::abs(expected(x, y - step) - here) > steepest;
      if (!wall) worst = std::max(worst, std::abs(depth_mm.at<float>(v, u) - here));
    }
  return worst;
}

TEST(Bodies, OnAFlatSensorAreTheirClosedForms) {
  const double turn = 25 * std::numbers::pi / 180;
  const auto turned = [&](double x, double y) {
    return std::pair{std::cos(turn) * (x - 1) + std::sin(turn) * (y + 0.5),
                     -std::sin(turn) * (x - 1) + std::cos(turn) * (y + 0.5)};
  };
  const auto depth = [&](const std::string& body) {
    return plan_of(flat_sensor("  - {use: " + body +
                               ", s_mm: 1, y_mm: -0.5, rotation_deg: 25, depth_mm: 0.6}\n"))
        .truth(0)
        .depth_mm;
  };
  EXPECT_LT(worst_error(depth("cylinder, radius_mm: 3, length_mm: 9"),
                        [&](double x, double y) {
                          const auto [a, b] = turned(x, y);
                          if (std::abs(a) > 4.5 || std::abs(b) >= 3) return 0.0;
                          return std::max(0.0, 0.6 - (3 - std::sqrt(9 - b * b)));
                        }),
            2e-6);
  EXPECT_LT(worst_error(depth("edge, angle_deg: 100, length_mm: 8"),
                        [&](double x, double y) {
                          const auto [a, b] = turned(x, y);
                          const double wall = 50 * std::numbers::pi / 180;
                          if (std::abs(a) > 4) return 0.0;
                          return std::max(0.0, 0.6 - std::abs(b) / std::tan(wall));
                        }),
            2e-6);
  EXPECT_LT(worst_error(
                depth("punch, radius_mm: 2.5"),
                [&](double x, double y) { return std::hypot(x - 1, y + 0.5) <= 2.5 ? 0.6 : 0.0; }),
            2e-6);
}

TEST(Bodies, ARoundedEdgeIsSmoothWhereItsPartsMeet) {
  const double half = 40 * std::numbers::pi / 180, r = 0.7;
  const cv::Mat depth =
      plan_of(flat_sensor("  - {use: edge, angle_deg: 80, radius_mm: 0.7, length_mm: 30, s_mm: 0, "
                          "y_mm: 0, depth_mm: 1.2}\n"))
          .truth(0)
          .depth_mm;
  // The two flanks touch the round nose: everything is at r or more from its axis.
  EXPECT_LT(worst_error(
                depth,
                [&](double, double y) {
                  const double b = std::abs(y);
                  const double round = b <= r * std::cos(half) ? r - std::sqrt(r * r - b * b) : 1e9;
                  const double flank = r - r / std::sin(half) + b / std::tan(half);
                  return std::max(0.0, 1.2 - std::min(round, b > r * std::cos(half) ? flank : 1e9));
                }),
            2e-6);
}

void write_stl(const std::filesystem::path& file,
               const std::vector<std::array<Eigen::Vector3f, 3>>& triangles) {
  std::ofstream out(file, std::ios::binary);
  const std::string head(80, ' ');
  out.write(head.data(), 80);
  const auto count = static_cast<std::uint32_t>(triangles.size());
  out.write(reinterpret_cast<const char*>(&count), 4);
  for (const auto& triangle : triangles) {
    const Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    out.write(reinterpret_cast<const char*>(normal.data()), 12);
    for (const auto& corner : triangle) out.write(reinterpret_cast<const char*>(corner.data()), 12);
    const std::uint16_t none = 0;
    out.write(reinterpret_cast<const char*>(&none), 2);
  }
}

// A ball in parallels and meridians, its facets within 0.0007 mm of it for a radius of 4.
std::vector<std::array<Eigen::Vector3f, 3>> facetted_ball(float radius, bool closed = true) {
  constexpr int kRound = 240, kUp = 120;
  const auto point = [&](int i, int k) -> Eigen::Vector3f {
    const double polar = std::numbers::pi * k / kUp;
    const double azimuth = 2 * std::numbers::pi * (i % kRound) / kRound;
    if (k == 0 || k == kUp) return {0, 0, k == 0 ? radius : -radius};
    return (radius * Eigen::Vector3d(std::sin(polar) * std::cos(azimuth),
                                     std::sin(polar) * std::sin(azimuth), std::cos(polar)))
        .cast<float>();
  };
  std::vector<std::array<Eigen::Vector3f, 3>> triangles;
  for (int k = 0; k < kUp; ++k)
    for (int i = 0; i < kRound; ++i) {
      if (k > 0) triangles.push_back({point(i, k), point(i, k + 1), point(i + 1, k)});
      if (k + 1 < kUp) triangles.push_back({point(i + 1, k), point(i, k + 1), point(i + 1, k + 1)});
    }
  if (!closed) triangles.pop_back();
  return triangles;
}

void write_obj(const std::filesystem::path& file,
               const std::vector<std::array<Eigen::Vector3f, 3>>& triangles) {
  std::ofstream out(file);
  for (const auto& triangle : triangles)
    for (const auto& p : triangle) out << fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    out << fmt::format("f {} {} {}\n", 3 * i + 1, 3 * i + 2, 3 * i + 3);
}

class Meshes : public testing::Test {
 protected:
  static Plan plan_in(const std::filesystem::path& folder, const std::string& yaml) {
    const auto scene = Scene::parse(yaml, (folder / "scene.yaml").string());
    EXPECT_TRUE(scene) << scene.error().sentence();
    auto plan = Plan::compile(*scene, 3);
    EXPECT_TRUE(plan) << plan.error().sentence();
    return *plan;
  }
  [[nodiscard]] std::string refused(const std::string& body) const {
    const auto scene = Scene::parse(
        scene_text("  - {use: mesh, s_mm: 60, y_mm: 0, depth_mm: 0.5, " + body + "}\n"),
        (folder_ / "scene.yaml").string());
    return scene ? "" : scene.error().sentence();
  }
  TemporaryFolder folder_;
};

// On bent, swaying and twisted faces, anywhere.
TEST_F(Meshes, ABallOfTrianglesIsTheBall) {
  write_stl(folder_ / "ball.stl", facetted_ball(4));
  write_obj(folder_ / "ball.obj", facetted_ball(0.4F));
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 6; ++i) {
    const std::string pose =
        fmt::format("motion: {{kind: hold, pose: {{q1_mm: {}, sway_mm: {}, twist_deg: {}}}}}\n",
                    5 * unit(random), 2 * unit(random), i < 2 ? 0.0 : 15 * unit(random));
    const std::string moves =
        "  - {use: bend, q1_mm: {from: -6, to: 6}, q2_mm: {from: -6, to: 6}}\n"
        "  - {use: sway, sway_mm: {from: -4, to: 4}}\n"
        "  - {use: twist, twist_deg: {from: -30, to: 30}}\n";
    const std::string place =
        fmt::format("s_mm: {}, y_mm: {}, depth_mm: {}", 60 + 25 * unit(random), 6 * unit(random),
                    0.7 + 0.5 * unit(random));
    const std::string mesh = i % 2 == 0 ? "file: ball.stl" : "file: ball.obj, scale: 10";
    const std::string turned = fmt::format("rotation_deg: {}", 180 * unit(random));
    const cv::Mat ball =
        plan_in(folder_.path(),
                pose + scene_text(moves + "  - {use: ball, radius_mm: 4, " + place + "}\n"))
            .truth(0)
            .depth_mm;
    const cv::Mat facets =
        plan_in(folder_.path(), pose + scene_text(moves + "  - {use: mesh, " + mesh + ", " +
                                                  turned + ", " + place + "}\n"))
            .truth(0)
            .depth_mm;
    cv::Mat difference;
    cv::absdiff(ball, facets, difference);
    cv::patchNaNs(difference, 0);
    double worst = 0, deepest = 0;
    cv::minMaxLoc(difference, nullptr, &worst);
    cv::minMaxLoc(cv::max(ball, 0), nullptr, &deepest);
    EXPECT_LT(worst, 0.005) << turned;
    EXPECT_GT(deepest, 0.15);
  }
}

// A body turns about the point of it that touches first as long as it is not tilted; a ball's
// middle goes along a circle about that.
TEST_F(Meshes, TurnAboutWhereTheyTouch) {
  write_stl(folder_ / "ball.stl", facetted_ball(3));
  const cv::Mat tilted =
      plan_in(folder_.path(),
              flat_sensor("  - {use: mesh, file: ball.stl, s_mm: 0.5, y_mm: -0.25, depth_mm: 0.7, "
                          "rotation_deg: 90, tilt_deg: 20, roll_deg: 10}\n"))
          .truth(0)
          .depth_mm;
  const double tilt = 20 * std::numbers::pi / 180, roll = 10 * std::numbers::pi / 180;
  // (0, 0, 3) rolled about x, tilted about y so that what points to the tip goes up, turned by 90.
  const double rolled_y = -3 * std::sin(roll), rolled_z = 3 * std::cos(roll);
  const double x = 0.5 - rolled_y, y = -0.25 - rolled_z * std::sin(tilt);
  EXPECT_LT(worst_error(tilted,
                        [&](double at_x, double at_y) {
                          const double r2 = std::pow(at_x - x, 2) + std::pow(at_y - y, 2);
                          return r2 < 9 ? std::max(0.0, 0.7 - 3 + std::sqrt(9 - r2)) : 0.0;
                        }),
            0.002);
}

TEST_F(Meshes, ReadsEachPlaceOnce) {
  write_stl(folder_ / "ball.stl", facetted_ball(4));
  const auto mesh = read_mesh(folder_ / "ball.stl");
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->points.size(), 240U * 119 + 2);
  EXPECT_EQ(mesh->triangles.size(), 2U * 240 * 119);
  EXPECT_TRUE(check_closed(*mesh));
}

TEST_F(Meshes, RefusesWhatIsNoBody) {
  write_stl(folder_ / "hole.stl", facetted_ball(4, false));
  write_stl(folder_ / "none.stl", {});
  write_stl(folder_ / "small.stl", facetted_ball(0.01F));
  auto broken = facetted_ball(4);
  broken[7][1].y() = std::numeric_limits<float>::quiet_NaN();
  write_stl(folder_ / "nan.stl", broken);
  std::ofstream(folder_ / "text.stl") << "this is no mesh";
  std::ofstream(folder_ / "ball.ply") << "ply";
  EXPECT_THAT(refused("file: ball.stl"), HasSubstr("the mesh does not exist"));
  EXPECT_THAT(refused("file: ball.stl"), HasSubstr("scene.yaml:10"));
  EXPECT_THAT(refused("file: hole.stl"), HasSubstr("the mesh has holes: 3 edges"));
  EXPECT_THAT(refused("file: small.stl"), HasSubstr("'scale' specifies the mm per unit"));
  EXPECT_THAT(refused("file: ball.ply"), HasSubstr("this mesh format is unknown"));
  for (const char* file : {"none.stl", "text.stl", "nan.stl"})
    EXPECT_THAT(refused(std::string("file: ") + file), HasSubstr("mesh")) << file;
  EXPECT_EQ(refused("file: nut_m6.stl"), "");  // comes with the program
}

// A relief keeps its shape on a bent face: the walls' tops lie in one plane.
TEST(Bodies, DoNotTakeTheFacesBend) {
  const std::string pose = "motion: {kind: hold, pose: {q1_mm: 12}}\n";
  const Truth truth =
      plan_of(pose +
              scene_text("  - {use: bend, q1_mm: {from: -12, to: 12}, q2_mm: {from: -6, to: "
                         "6}}\n"
                         "  - {use: punch, radius_mm: 5, s_mm: 60, y_mm: 0, depth_mm: 0.8}\n"))
          .truth(0);
  ASSERT_EQ(truth.contacts.size(), 1U);
  const Eigen::Isometry3d object_from_camera = truth.contacts[0].camera_from_object->inverse();
  int on_it = 0;
  double bent = 0;
  for (int v = 0; v < 180; ++v)
    for (int u = 0; u < 320; ++u) {
      const float z = truth.view_z_mm.at<float>(v, u), depth = truth.depth_mm.at<float>(v, u);
      if (!(depth > 0)) continue;
      const double outer = truth.untouched_z_mm.at<float>(v, u) - double{depth};
      const Eigen::Vector3d point((u - 158.5) / 170 * z, (v - 90.25) / 172 * z, outer);
      const Eigen::Vector3d in_object = object_from_camera * point;
      if (std::hypot(in_object.x(), in_object.y()) > 4.9) continue;  // its wall
      EXPECT_NEAR(in_object.z(), 0, 3e-5);
      bent = std::max(bent, std::abs(depth - 0.8));
      ++on_it;
    }
  EXPECT_GT(on_it, 200);
  EXPECT_GT(bent, 0.01);  // the face under it is bent
}

TEST(TruthMaps, TellWhatTouchesAndHowItLies) {
  const std::string effects =
      "  - {use: ball, radius_mm: 4, depth_mm: 0.9, s_mm: 40, y_mm: 1}\n"
      "  - {use: ball, radius_mm: 3, depth_mm: 0.6, s_mm: 70, y_mm: -4}\n"
      "  - {use: rolloff, kind: hertz, length_mm: 0.8}\n";
  const std::string light =
      "  - {use: layer, scatter_per_mm: 0.6, along: normal}\n"
      "  - {use: sides, albedo: 0.3, depth_mm: 10}\n"
      "  - {use: markers, radius_mm: 1, setback_mm: 3, first: 0.1, last: 0.9, albedo: 0.9}\n"
      "  - {use: occlusion, markers: [2]}\n"
      "  - {use: leds, lamps: [{at_mm: [0, 3, 0], power: 540000}]}\n";
  const Plan plan = plan_of(scene_text(effects + light));
  const Truth truth = plan.truth(0);
  const TruthMaps maps = plan.truth_maps(0);
  EXPECT_TRUE(same_bytes(maps.untouched_grey, plan_of(scene_text(light)).render(0)));
  ASSERT_EQ(truth.contacts.size(), 2U);
  EXPECT_EQ(truth.contacts[0].name, "ball");
  EXPECT_EQ(truth.contacts[1].name, "ball#2");
  std::array<int, 3> pixels{};
  for (int v = 0; v < 180; ++v)
    for (int u = 0; u < 320; ++u) {
      const float depth = truth.depth_mm.at<float>(v, u);
      const int contact = maps.contact.at<std::uint8_t>(v, u);
      ++pixels.at(static_cast<std::size_t>(contact));
      const cv::Vec3f n = maps.normal.at<cv::Vec3f>(v, u);
      const auto labels = static_cast<PixelLabel>(maps.labels.at<std::uint8_t>(v, u));
      EXPECT_EQ(std::isnan(depth), labels != PixelLabel::kFace);
      EXPECT_EQ(std::isnan(n[0]), labels != PixelLabel::kFace);
      if (contact == 0) continue;
      const Truth::Ball& ball = truth.balls[static_cast<std::size_t>(contact) - 1];
      const double z = truth.view_z_mm.at<float>(v, u);
      const Eigen::Vector3d outer((u - 158.5) / 170 * z, (v - 90.25) / 172 * z,
                                  truth.untouched_z_mm.at<float>(v, u) - double{depth});
      EXPECT_NEAR((outer - ball.centre_mm).norm(), ball.radius_mm, 5e-5);
      const Eigen::Vector3d normal = (ball.centre_mm - outer).normalized();
      // At the very rim a difference reaches over it.
      const double from_rim = (outer - ball.centre_mm).cross(truth.contacts[0].direction).norm() -
                              std::sqrt(ball.radius_mm * ball.depth_mm * std::cos(0.5934));
      if (std::abs(from_rim) < 0.05) continue;
      EXPECT_LT((normal - Eigen::Vector3d(n[0], n[1], n[2])).norm(), 2e-3);
    }
  // Hertz: pi R delta, seen through the camera.
  EXPECT_GT(pixels[1], 30);
  EXPECT_GT(pixels[2], 10);
  const auto at = [&](std::size_t marker) {
    const Truth::Dot& dot = truth.markers[marker];
    return static_cast<PixelLabel>(maps.labels.at<std::uint8_t>(
        static_cast<int>(std::lround(dot.v)), static_cast<int>(std::lround(dot.u))));
  };
  EXPECT_EQ(at(1), PixelLabel::kDot);
  EXPECT_EQ(at(2), PixelLabel::kFoldOverDot);
}

}  // namespace
}  // namespace alltact
