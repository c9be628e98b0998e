#include "core/sensing/reference/image_warp.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr int kColumns = 300, kRows = 200, kStride = kColumns + 2 * kWarpChunk;
// A place is rounded to 1/2048 px and a product to a step.
constexpr double kPlaceError = 1.0 / 2048;
// Places that are no parabola may be off by so much besides.
constexpr double kOffParabola = 1.0 / 500;

/// Grey levels that differ by up to `step` from one pixel to the next, with room on both sides.
std::vector<std::int16_t> random_greys(std::mt19937& random, int step) {
  std::vector<std::int16_t> image(static_cast<std::size_t>(kStride * kRows));
  std::uniform_int_distribution<int> change(-step, step);
  int grey = 100 * kGreySteps;
  for (std::int16_t& pixel : image) {
    grey = std::clamp(grey + change(random), 0, 250 * kGreySteps);
    pixel = static_cast<std::int16_t>(grey);
  }
  return image;
}

/// Smooth places that advance by `slope` from one to the next, and change with the row.
ColumnQuadratics random_places(std::mt19937& random, int columns, double slope) {
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  const double first = 20.0 * part(random), bow = 1e-4 * part(random), turn = 0.02 * part(random),
               by_row = 1e-5 * part(random);
  ColumnQuadratics places;
  for (int i = 0; i < columns; ++i) {
    places.constant.push_back(static_cast<float>(first + i * (slope + bow * i)));
    places.slope.push_back(static_cast<float>(turn * i / columns));
    places.bow.push_back(static_cast<float>(by_row * i / columns));
  }
  places.finish();
  return places;
}

double place_of(const ColumnQuadratics& places, std::size_t i, double row, int count) {
  const double place =
      static_cast<double>(places.constant[i]) +
      row * (static_cast<double>(places.slope[i]) + row * static_cast<double>(places.bow[i]));
  return std::clamp(place, 0.0, count - 1.0);
}

/// Linear between two grey levels a step apart, in plain numbers, and by how much a place that is
/// off by a rounding may change it.
struct PlainLinear {
  double grey, bound;
};
template <class At>
PlainLinear between(double place, int count, At at, double place_error = kPlaceError) {
  const int left = std::min(static_cast<int>(place), count - 2);
  const double here = at(left), next = at(left + 1), part = place - left;
  // At a whole pixel the rounding may lead to either side.
  const double before = at(std::max(left - 1, 0)), after = at(std::min(left + 2, count - 1));
  const double steepest =
      std::max({std::abs(next - here), std::abs(here - before), std::abs(after - next)});
  return {here + part * (next - here), 1.0 + 1.5 * place_error * steepest};
}

class LaidRow : public ::testing::TestWithParam<double> {};

TEST_P(LaidRow, IsThePlainFormulaAlongAndAcross) {
  std::mt19937 random(11);
  for (const int step : {3, 400, 16000})
    for (const int n : {1, 31, 32, 33, 250}) {
      const auto image = random_greys(random, step);
      const auto places = random_places(random, n, GetParam());
      std::vector<std::int16_t> out(static_cast<std::size_t>(n + kWarpChunk));
      const float row = 40.0F;
      const std::int16_t* first = image.data() + 7 * kStride + kWarpChunk;
      warp_along(first, {places, 0, row, 0.0F, kColumns}, n, out.data());
      for (int i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const PlainLinear truth = between(place_of(places, k, 40.0, kColumns), kColumns,
                                          [&](int u) { return static_cast<double>(first[u]); });
        ASSERT_NEAR(out[k], truth.grey, truth.bound) << n << " along, place " << i;
      }
      const std::int16_t* top = image.data() + kWarpChunk;
      warp_across(top, kStride, {places, 0, row, 0.0F, kRows}, n, out.data());
      for (int i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const PlainLinear truth = between(place_of(places, k, 40.0, kRows), kRows, [&](int v) {
          return static_cast<double>(top[v * kStride + i]);
        });
        ASSERT_NEAR(out[k], truth.grey, truth.bound) << n << " across, place " << i;
      }
    }
}

// From one place to the next: still, as in a recording, stretched and pressed together, backwards,
// and so far that each is clamped at an end.
INSTANTIATE_TEST_SUITE_P(Slopes, LaidRow, ::testing::Values(0.0, 0.03, 0.97, 1.2, 3.0, -0.5, 40.0));

TEST(LaidRowOfWaves, IsExactEnoughWherePlacesWave) {
  std::mt19937 random(12);
  const auto image = random_greys(random, 400);
  const std::int16_t* first = image.data() + 7 * kStride + kWarpChunk;
  constexpr int kPlaces = 250;
  for (const double wave_px : {40.0, 100.0, 250.0, 600.0})
    for (const double high_px : {0.02, 0.5, 3.0}) {
      ColumnQuadratics places;
      for (int i = 0; i < kPlaces; ++i)
        places.constant.push_back(static_cast<float>(
            10.0 + i + high_px * std::sin(2.0 * std::numbers::pi * i / wave_px)));
      places.slope.resize(kPlaces), places.bow.resize(kPlaces);
      places.finish();
      std::vector<std::int16_t> out(static_cast<std::size_t>(kPlaces + kWarpChunk));
      warp_along(first, {places, 0, 40.0F, 0.0F, kColumns}, kPlaces, out.data());
      for (std::size_t i = 0; i < kPlaces; ++i) {
        const PlainLinear truth = between(
            place_of(places, i, 40.0, kColumns), kColumns,
            [&](int u) { return static_cast<double>(first[u]); }, kPlaceError + kOffParabola);
        ASSERT_NEAR(out[i], truth.grey, truth.bound) << wave_px << " " << high_px << ", " << i;
      }
    }
}

}  // namespace
}  // namespace alltact
