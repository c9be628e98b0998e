// Simulated fingers of drawn sizes, cameras and dots, and what their contact tells of a push.
#pragma once

#include "core/sensing/contact/finger_contact.h"
#include "core/sensing/pipeline.h"
#include "tests/core/simulation/effects/pushed_scene.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>

namespace alltact {

inline constexpr double kMarkerNoise_px = 0.05;  // sd

// A finger of a drawn size, slope, camera and number of dots; frame 0 is at rest.
struct PushedDrawnFinger {
  double length_mm, incline_deg, width_mm;
  int per_row;
  std::string head;

  /// In pictures of 480 x 270 px times `scale`.
  explicit PushedDrawnFinger(Parameters& random, int scale = 1)
      : length_mm(random.between(95, 130)),
        incline_deg(random.between(28, 42)),
        width_mm(random.between(18, 28)),
        per_row(static_cast<int>(random.between(5, 13))) {
    const double f = scale * random.between(230, 300);
    head = fmt::format(
        "name: test\nwhy: drawn\nfinger:\n  camera: {{model: pinhole, size: [{9}, {10}], fx: {0}, "
        "fy: {0}, cx: {1}, cy: {2}}}\n  face: {{kind: fin_ray, width_mm: {3}, layer_mm: 1.5}}\n  "
        "markers: {{per_row: {4}, polarity: bright}}\nframes: 2\nuntouched: {{x_mm: {5}, z_mm: "
        "{6}, "
        "incline_deg: {7}, length_mm: {8}}}\neffects:\n",
        f, scale * random.between(225, 255), scale * random.between(125, 145), width_mm, per_row,
        random.between(-27, -20), random.between(27, 36), incline_deg, length_mm, 480 * scale,
        270 * scale);
    tail_ = fmt::format(
        "  - {{use: markers, radius_mm: 1.2, setback_mm: {}, first: {}, last: {}, albedo: 0.9}}\n"
        "  - {{use: layer, scatter_per_mm: 0.6, along: normal}}\n"
        "  - {{use: sides, albedo: 0.12, depth_mm: 14.0}}\n"
        "  - {{use: leds, lamps: [{{at_mm: [0, -3, 0], power: 270000}}, {{at_mm: [0, 3, 0], power: "
        "270000}}, {{at_mm: [4, 0, -20], power: 3300000, aim_mm: [71, 0, 93], lobe: 8}}]}}\n"
        "  - {{use: read, sd: 1.0}}\n  - {{use: quantisation}}\n",
        random.between(3, 6), random.between(0.08, 0.2), random.between(0.75, 0.92));
  }
  [[nodiscard]] std::string with(const std::string& effects) const {
    return head + effects + tail_;
  }

 private:
  std::string tail_;
};

// From 0 in the first frame to this in the second.
inline std::string reaching(double value) {
  return fmt::format("[{{at: 0, is: 0}}, {{at: 1, is: {}}}]", value);
}

// What a frame of it tells: the face's shape from its picture, markers with noise.
struct Told {
  Push push;
  std::optional<TipDisplacement> displacement;
  std::optional<FingerContact> contact;
  Truth truth;
};

inline std::optional<Told> told_of(const std::string& scene, Parameters& random) {
  const auto parsed = Scene::parse(scene, "drawn.yaml");
  EXPECT_TRUE(parsed) << parsed.error().sentence();
  const auto plan = Plan::compile(*parsed, 3);
  if (!plan) return std::nullopt;  // a push that is more than this finger bears
  const auto snapshot = FingerSnapshot::of("", plan->finger());
  EXPECT_TRUE(snapshot);
  auto frame = std::make_shared<Frame>();
  frame->grey = plan->render(1);
  const auto result = Pipeline::without_reference(*snapshot, {})(frame);
  if (!result || !result->shape) return std::nullopt;
  const Truth rest = plan->truth(0, TruthDetail::kWithoutImages);
  Told told;
  told.truth = plan->truth(1, TruthDetail::kWithoutImages);
  std::mt19937 bits(static_cast<unsigned>(1e9 * random.between(0, 1)));
  std::normal_distribution<double> noise(0.0, kMarkerNoise_px);
  ContactSettings settings;
  Markers markers;
  for (std::size_t m = 0; m < rest.markers.size(); ++m) {
    settings.rest_markers.emplace_back(rest.markers[m].u + noise(bits),
                                       rest.markers[m].v + noise(bits));
    markers.push_back({told.truth.markers[m].u + noise(bits), told.truth.markers[m].v + noise(bits),
                       true, kMarkerNoise_px});
  }
  // As install_reference sets it.
  const auto count = static_cast<double>(markers.size());
  settings.threshold_px = std::max(5 * kMarkerNoise_px * std::sqrt(2 * count), 0.2 * count);
  const Eigen::MatrixXd ways = displacement_covariance_px2(markers);
  told.push = push_of(markers, settings, result->shape->base_at_low_u(), ways);
  told.displacement = tip_displacement(markers, settings.rest_markers, *result->shape, ways);
  ContactEvidence evidence;
  evidence.add_push(told.push, settings, markers, *result->shape, ways);
  told.contact = FingerContactTracker()(evidence);
  return told;
}

/// A body of drawn walls and depths.
inline std::string drawn_body(Parameters& random, double least_coupling, double most_coupling) {
  return fmt::format(
      "  - {{use: body, shore_a: {}, wall_mm: {}, base_depth_mm: {}, tip_depth_mm: {}, coupling: "
      "{}}}\n",
      random.between(30, 55), random.between(3, 5), random.between(28, 38), random.between(11, 16),
      random.between(least_coupling, most_coupling));
}

}  // namespace alltact
