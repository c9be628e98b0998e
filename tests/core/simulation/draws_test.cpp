// Everything that draws at random draws what it would draw alone: next to any others, in any order
// of the scene's lines and of the frames, with any number of threads. The draws are made here anew,
// from seed, name, frame and place.
#include "core/simulation/noise.h"
#include "tests/core/simulation/effects/effect_scene.h"

#include <functional>
#include <numbers>
#include <numeric>

#include <fmt/ranges.h>

namespace alltact {
namespace {

constexpr int kWidth = 70, kHeight = 40;

std::vector<float> row_of_normals(const char* who, int frame, int v, int n = kWidth) {
  std::vector<float> normals(static_cast<std::size_t>(n));
  RowNoise(who).normals(effect_seed(), frame, v, n, normals.data());
  return normals;
}

/// One sensor effect that draws, as a scene's line and as what it does to a row.
struct Drawer {
  std::string line;
  std::function<void(int frame, int v, float* value)> apply;
};

void fix(float* value, int v, const char* who, double share) {
  if (share <= 0) return;
  double at = -1;
  for (std::uint32_t i = 0;; ++i) {
    const double unit = philox_uniform(effect_seed(), who, static_cast<std::uint32_t>(v), i);
    at += 1 + std::floor(std::log(unit) / std::log1p(-share));
    if (at >= kWidth) return;
    value[static_cast<int>(at)] = std::string_view(who).ends_with("hot") ? 255 : 0;
  }
}

// In the order in which they run.
std::vector<Drawer> sensor_drawers(Parameters& random) {
  const double prnu = random.between(0.01, 0.1), dsnu = random.between(0.5, 5);
  const double gain = random.between(0.02, 2), sd = random.between(0.3, 9);
  const double row_sd = random.between(0.3, 4), drift = random.between(0.01, 0.1);
  const double every = random.between(0.01, 3), dead = random.between(0.005, 0.02);
  const auto each = [](const char* who, int key_frame, const auto& change) {
    return [=](int frame, int v, float* value) {
      const auto normals = row_of_normals(who, key_frame < 0 ? frame : key_frame, v);
      for (std::size_t u = 0; u < kWidth; ++u) change(normals[u], value[u]);
    };
  };
  const auto first = [](const char* who, int frame, int v) {
    return row_of_normals(who, frame, v, 1)[0];
  };
  return {
      {fmt::format("fixed-pattern, prnu: {}, dsnu: {}", prnu, dsnu),
       [=](int frame, int v, float* value) {
         each("fixed-pattern.prnu", 0,
              [&](float n, float& x) { x += x * static_cast<float>(prnu) * n; })(frame, v, value);
         each("fixed-pattern.dsnu", 0,
              [&](float n, float& x) { x += static_cast<float>(dsnu) * n; })(frame, v, value);
       }},
      {fmt::format("shot, gain: {}", gain),
       each("shot", -1,
            [=](float n, float& x) {
              x += std::sqrt(static_cast<float>(gain) * std::max(x, 0.0F)) * n;
            })},
      {fmt::format("read, sd: {}", sd),
       each("read", -1, [=](float n, float& x) { x += static_cast<float>(sd) * n; })},
      {fmt::format("row-noise, sd: {}", row_sd),
       [=](int frame, int v, float* value) {
         const float offset = static_cast<float>(row_sd) * first("row-noise", frame, v);
         for (int u = 0; u < kWidth; ++u) value[u] += offset;
       }},
      {fmt::format("gain-drift, sd: {}, every_s: {}", drift, every),
       [=](int frame, int, float* value) {
         const double knots = frame / 30.0 / every;
         const int k = static_cast<int>(knots);
         const double angle = std::numbers::pi / 2 * (knots - k);
         const double g = first("gain-drift", k, 0) * std::cos(angle) +
                          first("gain-drift", k + 1, 0) * std::sin(angle);
         for (int u = 0; u < kWidth; ++u) value[u] *= static_cast<float>(1 + drift * g);
       }},
      {fmt::format("dead-pixels, dead: {}, hot: {}", dead, dead / 2),
       [=](int, int v, float* value) {
         fix(value, v, "dead-pixels.dead", dead);
         fix(value, v, "dead-pixels.hot", dead / 2);
       }},
  };
}

std::string shuffled_lines(std::vector<std::string> lines, Parameters& random) {
  for (std::size_t i = lines.size(); i > 1; --i)
    std::swap(lines[i - 1], lines[static_cast<std::size_t>(random.between(0, double(i)))]);
  std::string text;
  for (const auto& line : lines) text += "  - {use: " + line + "}\n";
  return text;
}

std::string small_flat(const std::string& effects) {
  return flat_text(effects, "model: orthographic, size: [70, 40], mm_per_px: 0.1, cx: 35, cy: 20");
}

// None, each alone, each left out, and all the others between: every subset, to the last bit.
TEST(Draws, OfTheSensorAreTheSameNextToAnyOthers) {
  Parameters random(71);
  const std::vector<std::string> light{
      "speck, s_mm: {from: -2, to: 2}, y_mm: {from: -1, to: 1}, radius_mm: 0.7, darkness: 0.4",
      "hole, s_mm: {from: -3, to: 3}, y_mm: 0, radius_mm: {from: 0.2, to: 1}, level: 60",
      "uneven-layer, share: 0.08, length_mm: 3", "layer, scatter_per_mm: 0.6, along: z",
      "leds, lamps: [{at_mm: [1, -3, -2], power: 200000}]"};
  const auto drawers = sensor_drawers(random);
  const unsigned all = 1U << drawers.size();
  for (unsigned subset = 0; subset < all; ++subset) {
    std::vector<std::string> lines = light;
    for (std::size_t i = 0; i < drawers.size(); ++i)
      if (subset >> i & 1U) lines.push_back(drawers[i].line);
    if (subset % 3 == 0)
      lines.insert(lines.end(), {"drop, share: 0.5", "late, share: 0.5, by_ms: 9"});
    const Plan clean = plan_of(small_flat(shuffled_lines(light, random)));
    const Plan plan = plan_of(small_flat(shuffled_lines(lines, random)));
    for (const int frame : {41, 0, 7}) {
      cv::Mat_<float> expected = clean.render(frame);
      for (int v = 0; v < kHeight; ++v)
        for (std::size_t i = 0; i < drawers.size(); ++i)
          if (subset >> i & 1U) drawers[i].apply(frame, v, expected[v]);
      for (const int threads : {1, 2, 3})
        ASSERT_TRUE(same_bytes(plan.render(frame, threads), expected))
            << fmt::format("{}", fmt::join(lines, "; ")) << ", frame " << frame;
    }
  }
}

double drawn(const char* who, int frame, double from, double to) {
  return from +
         (to - from) * philox_uniform(effect_seed(), who, static_cast<std::uint32_t>(frame), 0);
}

std::vector<bool> visible_dots(int frame, std::size_t n) {
  std::vector<std::size_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0U);
  std::vector<bool> visible(n, true);
  const auto count = static_cast<std::size_t>(std::lround(drawn("occlusion.count", frame, 1, 9)));
  for (std::size_t i = 0; i < count; ++i) {
    const double unit =
        philox_uniform(effect_seed(), "occlusion.which", static_cast<std::uint32_t>(frame),
                       static_cast<std::uint32_t>(i));
    std::swap(numbers[i], numbers[i + static_cast<std::size_t>(unit * static_cast<double>(n - i))]);
    visible[numbers[i]] = false;
  }
  return visible;
}

/// What draws where things are and when they come: a scene's line and the proof of its draws.
struct Placer {
  std::string line;
  std::function<void(const Plan&, const Truth&, int frame)> check;
};

std::vector<Placer> placers() {
  const auto pose = [](const char* name, double low, double high) {
    return [=](const Plan&, const Truth& truth, int frame) {
      EXPECT_EQ(truth.pose.at(name),
                drawn((std::string("motion.") + name).c_str(), frame, low, high));
    };
  };
  return {
      {"bend, q1_mm: {from: -5, to: 4}, q2_mm: {from: -4, to: 3}", pose("q1_mm", -5, 4)},
      {"sway, sway_mm: {from: -2, to: 1}", pose("sway_mm", -2, 1)},
      {"ball, radius_mm: {from: 2, to: 5}, s_mm: 40, y_mm: 1, depth_mm: {from: 0.2, to: 1.1}",
       [](const Plan&, const Truth& truth, int frame) {
         ASSERT_FALSE(truth.balls.empty());
         EXPECT_EQ(truth.balls[0].radius_mm, drawn("ball.radius_mm", frame, 2, 5));
         EXPECT_EQ(truth.balls[0].depth_mm, drawn("ball.depth_mm", frame, 0.2, 1.1));
       }},
      {"occlusion, count: {from: 1, to: 9}",
       [](const Plan&, const Truth& truth, int frame) {
         std::vector<bool> visible;
         for (const auto& dot : truth.markers) visible.push_back(dot.visible);
         EXPECT_EQ(visible, visible_dots(frame, 12));
       }},
      {"drop, share: 0.3, run: 2",
       [](const Plan& plan, const Truth&, int frame) {
         bool lost = drawn("drop", frame, 0, 1) < 0.3;
         if (frame > 0) lost = lost || drawn("drop", frame - 1, 0, 1) < 0.3;
         EXPECT_EQ(plan.arrival(frame).is_dropped, lost);
       }},
      {"late, share: 0.4, by_ms: {from: 5, to: 90}",
       [](const Plan& plan, const Truth&, int frame) {
         const bool late = drawn("late", frame, 0, 1) < 0.4;
         EXPECT_EQ(plan.arrival(frame).late_ms, late ? drawn("late.by_ms", frame, 5, 90) : 0);
       }},
  };
}

TEST(Draws, OfPlacesAndTimesAreTheSameNextToAnyOthers) {
  Parameters random(72);
  const auto all = placers();
  for (unsigned subset = 1; subset < 1U << all.size(); ++subset) {
    std::vector<std::string> lines{
        "sides, albedo: 0.1, depth_mm: 9",
        "markers, radius_mm: 1, setback_mm: 4, first: 0.2, last: 0.8, albedo: 1"};
    for (std::size_t i = 0; i < all.size(); ++i)
      if (subset >> i & 1U) lines.push_back(all[i].line);
    if (subset % 2 == 0)
      lines.insert(lines.end(), {"read, sd: 1", "dead-pixels, dead: 0.01", "row-noise, sd: 2"});
    const bool moves = (subset & 3U) != 0;
    const Plan plan = plan_of((moves ? "motion: {kind: random}\n" : "") +
                              scene_text(shuffled_lines(lines, random)));
    for (const int frame : {9, 0, 4}) {
      const Truth truth = plan.truth(frame);
      for (std::size_t i = 0; i < all.size(); ++i)
        if (subset >> i & 1U) all[i].check(plan, truth, frame);
    }
    if (HasFailure()) FAIL() << fmt::format("{}", fmt::join(lines, "; "));
  }
}

// The layer's waves are of the seed alone.
TEST(Draws, OfTheLayersThicknessAreTheSameNextToAnyOthers) {
  const std::string uneven = "  - {use: uneven-layer, share: 0.05, length_mm: 4}\n";
  const cv::Mat alone = plan_of(small_flat(uneven)).truth(0).untouched_z_mm;
  for (const char* other : {"read, sd: 1", "shot, gain: 1", "drop, share: 0.5",
                            "hole, s_mm: {from: -1, to: 1}, y_mm: 0, radius_mm: 1, level: 9",
                            "ball, radius_mm: {from: 1, to: 2}, s_mm: 0, y_mm: 0, depth_mm: 0.5"})
    for (const bool before : {true, false}) {
      const std::string line = fmt::format("  - {{use: {}}}\n", other);
      const Plan plan = plan_of(small_flat(before ? line + uneven : uneven + line));
      for (const int frame : {5, 0})
        EXPECT_TRUE(same_bytes(plan.truth(frame).untouched_z_mm, alone)) << other;
    }
}

}  // namespace
}  // namespace alltact
