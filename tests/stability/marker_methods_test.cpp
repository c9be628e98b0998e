// What the ways of finding markers cost and gain, side by side on simulated fingers drawn at random
// that the network was not trained on: clear, worn, blurred, partly lit, with dark dots.
#include "core/sensing/face/face_edges.h"
#include "core/sensing/markers/dot_network.h"
#include "core/sensing/markers/marker_detector.h"
#include "core/sensing/markers/marker_tracker.h"
#include "core/simulation/plan.h"
#include "core/simulation/scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr int kFingers = 5, kFramesOfEach = 2, kPosesLearnt = 150;

/// A demonstration finger of other sizes, light and dots; `more`: what makes it hard.
std::string drawn_scene(const std::string& more, bool is_dark, unsigned seed) {
  std::mt19937 random(seed);
  const auto draw = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double light = draw(0.6, 1.4);
  const int per_row = 4 + static_cast<int>(random() % 5);
  return fmt::format(
      "name: drawn\nwhy: for a test\nframes: {}\nfinger:\n"
      "  camera: {{model: pinhole, size: [960, 540], fx: {}, fy: {}, cx: 479.5, cy: 269.5}}\n"
      "  face: {{kind: fin_ray, width_mm: {}, layer_mm: 1.5}}\n"
      "  markers: {{per_row: {}, polarity: {}}}\n"
      "untouched: {{x_mm: -25.0, z_mm: 28.0, incline_deg: 34.0, length_mm: {}}}\n"
      "motion: {{kind: random}}\neffects:\n"
      "  - {{use: bend, q1_mm: {{from: -4.0, to: 4.0}}, q2_mm: {{from: -4.0, to: 4.0}}}}\n"
      "  - {{use: sway, sway_mm: {{from: -2.0, to: 2.0}}}}\n"
      "  - {{use: markers, radius_mm: {}, setback_mm: {}, first: 0.1, last: 0.88, albedo: {}}}\n"
      "  - {{use: sides, albedo: {}, depth_mm: 14.0}}\n"
      "  - {{use: layer, scatter_per_mm: 0.6, along: normal}}\n"
      "  - use: leds\n    lamps:\n"
      "      - {{at_mm: [0.0, -3.0, 0.0], power: {}}}\n"
      "      - {{at_mm: [0.0, 3.0, 0.0], power: {}}}\n"
      "      - {{at_mm: [4.0, 0.0, -20.0], power: {}, aim_mm: [71.0, 0.0, 93.0], lobe: 8}}\n"
      "  - {{use: read, sd: {}}}\n  - {{use: quantisation}}\n{}",
      kPosesLearnt, 524.0, 524.0, draw(20, 27), per_row, is_dark ? "dark" : "bright", draw(95, 118),
      draw(1.0, 1.6), draw(3.5, 6.0), is_dark ? 0.05 : draw(0.6, 0.95), is_dark ? 0.45 : 0.12,
      270000 * light, 270000 * light, 3300000 * light, draw(0.5, 2.0), more);
}

struct Cost {
  int dots = 0, found = 0, missed = 0, false_dots = 0, images = 0;
  double square_px2 = 0, ms = 0;

  void add(const std::vector<Dot>& given, const std::vector<Truth::Dot>& truth) {
    std::vector<char> is_true(given.size(), 0);
    for (const Truth::Dot& dot : truth) {
      double best = 3.0;
      for (std::size_t i = 0; i < given.size(); ++i) {
        const double off = std::hypot(given[i].u - dot.u, given[i].v - dot.v);
        if (off < 3.0) is_true[i] = 1;
        best = std::min(best, off);
      }
      if (!dot.visible) continue;
      ++dots;
      if (best < 3.0)
        ++found, square_px2 += best * best;
      else
        ++missed;
    }
    false_dots += static_cast<int>(std::count(is_true.begin(), is_true.end(), 0));
    ++images;
  }
  void print(const std::string& world, const char* way) const {
    std::printf(
        "[ figures  ] %-12s %-8s found %4d of %4d, false %3d in %2d pictures, %.3f px rms, %.1f "
        "ms\n",
        world.c_str(), way, found, dots, false_dots, images,
        std::sqrt(square_px2 / std::max(1, found)), ms / std::max(1, images));
  }
};

/// Of numbered markers: how often one was taken for another, and how far estimates of hidden ones
/// are off.
struct Numbers {
  int frames = 0, lost = 0, wrong = 0, hidden = 0;
  double square_px2 = 0;

  void add(const std::optional<Markers>& markers, const std::vector<Truth::Dot>& truth) {
    ++frames;
    if (!markers) {
      ++lost;
      return;
    }
    bool is_wrong = false;
    for (std::size_t m = 0; m < truth.size(); ++m) {
      const double off = std::hypot((*markers)[m].u - truth[m].u, (*markers)[m].v - truth[m].v);
      if ((*markers)[m].seen)
        is_wrong |= off > 3.0;
      else
        ++hidden, square_px2 += off * off;
    }
    wrong += is_wrong;
  }
  void print(const std::string& world, const char* way) const {
    std::printf(
        "[ figures  ] %-12s %-18s of %2d frames %2d numbered wrongly, %d lost; %d hidden markers "
        "%.2f px rms\n",
        world.c_str(), way, frames, wrong, lost, hidden,
        std::sqrt(square_px2 / std::max(1, hidden)));
  }
};

MarkerModel model_of_truth(const Plan& plan, const std::vector<Dot>& typical) {
  const auto markers = plan.truth(0).markers.size();
  Eigen::MatrixXd layouts(kPosesLearnt - kFramesOfEach, 2 * static_cast<Eigen::Index>(markers));
  for (int i = kFramesOfEach; i < kPosesLearnt; ++i) {
    const Truth truth = plan.truth(i);
    for (std::size_t m = 0; m < markers; ++m)
      layouts.row(i - kFramesOfEach).segment<2>(2 * static_cast<Eigen::Index>(m))
          << truth.markers[m].u,
          truth.markers[m].v;
  }
  return MarkerModel::learn(layouts, typical).value();
}

struct World {
  std::string name, more;
  bool is_dark = false;
};

void PrintTo(const World& world, std::ostream* out) { *out << world.name; }

class MarkerWays : public ::testing::TestWithParam<World> {};

TEST_P(MarkerWays, SideBySide) {
  using Clock = std::chrono::steady_clock;
  const World& world = GetParam();
  const std::filesystem::path own =
      std::filesystem::path(ALLTACT_SOURCE_DIR) / "resources" / kBuiltInMarkerNetwork;
  Cost blobs, network;
  Numbers modelled, modelled_network, sorted;
  for (unsigned f = 0; f < kFingers; ++f) {
    const auto scene = Scene::parse(drawn_scene(world.more, world.is_dark, 7000 + f), "drawn");
    ASSERT_TRUE(scene.ok()) << scene.error().sentence();
    const auto plan = Plan::compile(*scene, 7000 + f);
    ASSERT_TRUE(plan.ok()) << plan.error().sentence();
    const Finger& finger = plan->finger();
    const Camera camera = Camera::create(finger.camera).value();
    const FaceEdgeFinder edges_of({.view = FaceView{camera, finger.face.width_mm}});
    auto loaded = DotNetwork::load(own);
    ASSERT_TRUE(loaded.ok()) << loaded.error().sentence();
    const MarkerDetector blob_finder(finger.markers);
    const NetworkDotFinder network_finder(std::move(loaded).value(), finger.markers);
    const MarkerModel model = model_of_truth(
        *plan, std::vector<Dot>(2 * static_cast<std::size_t>(finger.markers.per_row)));
    Markers before;
    for (const Truth::Dot& dot : plan->truth(kFramesOfEach).markers)
      before.push_back({dot.u, dot.v, true, 0});
    for (int i = 0; i < kFramesOfEach; ++i) {
      const cv::Mat grey = plan->render(i);
      const Truth truth = plan->truth(i);
      const auto edges = edges_of(grey);
      ASSERT_TRUE(edges.ok());
      const auto shape = FaceShape::fit(*edges, camera, finger.face, 7);
      ASSERT_TRUE(shape.ok());
      const auto timed = [&](const DotFinder& finder, Cost& cost) {
        const auto start = Clock::now();
        const FoundDots found = finder(grey, *shape);
        cost.ms += std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        EXPECT_TRUE(found.problem.empty()) << found.problem.english();
        cost.add(found.dots, truth.markers);
        return found;
      };
      const FoundDots by_blobs = timed(blob_finder, blobs);
      const FoundDots by_network = timed(network_finder, network);
      modelled.add(numbered(by_blobs, model, nullptr), truth.markers);
      modelled_network.add(numbered(by_network, model, nullptr), truth.markers);
      sorted.add(paper_rows(by_blobs.dots, finger.markers.per_row, shape->base_at_low_u(), &before),
                 truth.markers);
    }
  }
  blobs.print(world.name, "blobs");
  network.print(world.name, "network");
  modelled.print(world.name, "blobs, model");
  modelled_network.print(world.name, "network, model");
  sorted.print(world.name, "blobs, paper rows");
  const double least = world.name == "clear" ? 0.95 : 0.7;
  EXPECT_GT(blobs.found, least * blobs.dots);
  EXPECT_GT(network.found, least * network.dots);
  EXPECT_LT(std::sqrt(network.square_px2 / network.found), 0.3);
  EXPECT_LT(network.false_dots, network.dots / 5);
  EXPECT_EQ(modelled.wrong, 0);
  EXPECT_EQ(modelled_network.wrong, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Worlds, MarkerWays,
    ::testing::Values(World{"clear", ""}, World{"hidden", "  - {use: occlusion, count: 3}\n"},
                      World{"worn", "  - {use: worn-marker, markers: [1, 3, 6], wear: 0.7}\n"},
                      World{"blurred", "  - {use: defocus, focus_mm: 40.0, aperture_mm: 1.0}\n"},
                      World{"partly_lit", "  - {use: dead-lamp, lamp: 0}\n"},
                      World{"dark_dots", "", true}),
    [](const ::testing::TestParamInfo<World>& info) { return info.param.name; });

}  // namespace
}  // namespace alltact
