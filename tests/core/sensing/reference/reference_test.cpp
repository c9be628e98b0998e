#include "core/base/atomic_file.h"
#include "core/sensing/reference/recorded_poses.h"
#include "core/sensing/reference/reference_image.h"
#include "core/sensing/reference/reference_library.h"
#include "tests/support/marked_finger.h"
#include "tests/support/scratch_folder.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;

using test::scratch_folder;

Eigen::MatrixXd random_points(int n, int dimensions, std::mt19937& random) {
  std::normal_distribution<double> normal(0.0, 10.0);
  Eigen::MatrixXd points(n, dimensions);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = normal(random);
  return points;
}

TEST(LocalLinearWeights, SumToOneAndReproduceAPoseInsideTheNeighbours) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::MatrixXd points = random_points(16, 1 + trial % 4, random);
    const Eigen::VectorXd query = 0.3 * random_points(1, 1 + trial % 4, random).transpose();
    const Eigen::VectorXd w = local_linear_weights(points, query, 0.05, 3.0);
    EXPECT_NEAR(w.sum(), 1.0, 1e-9);
    EXPECT_LE(w.lpNorm<1>(), 3.0 + 1e-9);
    EXPECT_LT((points.transpose() * w - query).norm(), 0.1);
  }
}

TEST(LocalLinearWeights, StaySmallFarOutsideAndForNeighboursOnALine) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 200; ++trial) {
    Eigen::MatrixXd points = random_points(16, 3, random);
    if (trial % 2) points = points.col(0) * Eigen::RowVector3d(1, 2, -1);
    if (trial % 5 == 0) points.rowwise() = points.row(0).eval();  // all the same
    const Eigen::VectorXd query = 20 * random_points(1, 3, random).transpose();
    const Eigen::VectorXd w = local_linear_weights(points, query, 0.05, 3.0);
    ASSERT_TRUE(w.allFinite());
    EXPECT_NEAR(w.sum(), 1.0, 1e-9);
    EXPECT_LE(w.lpNorm<1>(), 3.0 + 1e-9);
  }
}

/// Marks fixed to the skin: parts of its length, mm across it.
struct Mark {
  double t, y;
};
const std::vector<Mark> kMarks{{0.2, -6}, {0.33, 4}, {0.45, -2}, {0.55, 7}, {0.7, 0}, {0.82, -5}};

Eigen::Vector2d seen_at(const test::MarkedFinger& finger, const test::Bend& bend,
                        const Mark& mark) {
  const auto p = test::MarkedFinger::at(finger.arc(bend), mark.t, 0.0);
  return finger.project(p.x, mark.y + p.y, p.z);
}

/// The finger with dark specks in its skin.
cv::Mat specked(const test::MarkedFinger& finger, const test::Bend& bend) {
  std::vector<test::MarkedFinger::Extra> specks;
  for (const Mark& mark : kMarks) {
    const Eigen::Vector2d q = seen_at(finger, bend, mark);
    specks.push_back({{q.x(), q.y(), 2.5, 2.5}, 60.0});
  }
  return finger.clean(bend, {}, specks);
}

Markers markers_of(const test::MarkedFinger& finger, const test::Bend& bend) {
  Markers markers;
  for (const auto& d : finger.discs(bend)) markers.push_back({d.u, d.v, true, 0.02});
  return markers;
}

/// How far the centroid of what is darker than its surroundings lies from a place of a picture.
double centroid_off_px(const cv::Mat& image, const Eigen::Vector2d& place) {
  constexpr int kReach = 8;
  const cv::Rect window(static_cast<int>(place.x()) - kReach, static_cast<int>(place.y()) - kReach,
                        2 * kReach + 1, 2 * kReach + 1);
  double level = 0, sum = 0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  const cv::Mat near = image(window);
  for (int k = 0; k < near.cols; ++k)
    level = std::max(level, static_cast<double>(near.at<float>(0, k)));
  for (int row = 0; row < near.rows; ++row)
    for (int column = 0; column < near.cols; ++column) {
      const double dark = 0.8 * level - static_cast<double>(near.at<float>(row, column));
      if (dark > 0) sum += dark, first += dark * Eigen::Vector2d(column, row);
    }
  EXPECT_GT(sum, 0.0);
  return (Eigen::Vector2d(window.x, window.y) + first / sum - place).norm();
}

TEST(ReferenceImage, MarksOfTheSkinStayWhereTheyAreWhenTheFingerBends) {
  std::mt19937 random(7);
  test::MarkedFinger finger;
  finger.noise = 0;
  const FaceShape rest_shape = finger.shape({});
  const FaceChart rest = chart_of(rest_shape).value();
  const SkinPositions places = skin_positions(rest, rest_shape, markers_of(finger, {}));
  const FaceGrid grid = face_grid(rest, 0.15);
  const auto chart_in = [&](const test::Bend& bend) {
    const FaceShape shape = finger.shape(bend);
    FaceChart chart = chart_of(shape).value();
    register_chart(places, shape, markers_of(finger, bend), &chart);
    return chart;
  };
  double worst = 0;
  int compared = 0;
  for (int trial = 0; trial < 8; ++trial) {
    const test::Bend recorded = test::random_bend(random, 0.8),
                     now = test::random_bend(random, 0.8);
    const cv::Mat grey = finger.with_noise(specked(finger, recorded), random);
    const FaceImage face = warp_face(grey, chart_in(recorded), grid);
    const cv::Mat there =
        ReferenceImage(grid, {{{&face}, {1.0F}}}, ChartWarp(chart_in(now), grid.chart), grey.size())
            .grey();
    for (const Mark& mark : kMarks) {
      const Eigen::Vector2d place = seen_at(finger, now, mark),
                            was = seen_at(finger, recorded, mark);
      if (place.x() > finger.width - 20 || was.x() > finger.width - 20) continue;
      worst = std::max(worst, centroid_off_px(there, place));
      ++compared;
    }
  }
  std::printf("[ figures  ] marks of the skin: at most %.2f px beside their place\n", worst);
  EXPECT_GT(compared, 30);
  EXPECT_LT(worst, 0.6);
}

/// A shape from noisy edges, and the face's tip end, whose line leans by a slope.
FaceShape noisy_shape(const test::MarkedFinger& finger, const test::Bend& bend, double sd_px,
                      double slope, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, sd_px);
  FaceEdges edges = finger.edges(bend);
  for (Edge* edge : {&edges.upper, &edges.lower})
    for (std::size_t i = 0; i < edge->v.size(); ++i)
      edge->v[i] += noise(random), edge->sd[i] = sd_px;
  const Eigen::Vector2d end = seen_at(finger, bend, {1.0, 0.0});
  edges.ends.last =
      FaceEnd{.u_px = end.x(), .v_px = end.y(), .slope = slope, .bow_per_px = 0, .sd_px = 0.05};
  return FaceShape::fit(edges, Camera::create(finger.camera()).value(), finger.face(), 7).value();
}

TEST(FaceChart, TheTipEndShowsTheTiltWhereNoMarkerDoes) {
  std::mt19937 random(12);
  test::MarkedFinger finger;
  finger.length_mm = 70;  // its end is in the image
  const FaceShape rest_shape = noisy_shape(finger, {}, 0.1, 0.0, random);
  const FaceChart rest = chart_of(rest_shape).value();
  Markers unseen = markers_of(finger, {});
  for (Marker& marker : unseen) marker.seen = false;
  const SkinPositions places = skin_positions(rest, rest_shape, unseen);
  for (const double slope : {-0.04, 0.02, 0.06}) {
    const FaceShape shape = noisy_shape(finger, {}, 0.1, slope, random);
    FaceChart chart = chart_of(shape).value();
    register_chart(places, shape, unseen, &chart);
    const std::size_t last = chart.along_mm.size() - 1;
    const double mm_per_px = (chart.along_mm[last] - chart.along_mm[last - 8]) / 8;
    const double lean_mm = mm_per_px * slope * 0.5 * (chart.lower_v[last] - chart.upper_v[last]);
    // Skin of one length lies on the end line: its columns grow with t, so its tilt is negative.
    EXPECT_NEAR(chart.tilt_at(chart.along_mm[last]), -lean_mm, 0.1 * std::abs(lean_mm)) << slope;
  }
}

TEST(FaceChart, TheTipEndFixesTheSkinNextToIt) {
  std::mt19937 random(11);
  test::MarkedFinger finger;
  finger.length_mm = 70;  // its end is in the image
  finger.upper_shares = finger.lower_shares = {0.06, 0.16, 0.26, 0.36, 0.46, 0.56};
  const FaceShape rest_shape = noisy_shape(finger, {}, 0.6, 0.0, random);
  const FaceChart rest = chart_of(rest_shape).value();
  const SkinPositions with = skin_positions(rest, rest_shape, markers_of(finger, {}));
  ASSERT_TRUE(with.tip);
  SkinPositions without = with;
  without.tip.reset();
  double square_with = 0, square_without = 0;
  int compared = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const test::Bend bend = test::random_bend(random, 0.5);
    const Eigen::Vector2d now = seen_at(finger, bend, {0.98, 0.0});
    const FaceShape shape = noisy_shape(finger, bend, 0.6, 0.0, random);
    if (!shape.tip_end()) continue;
    // Where the rest frame shows this skin, by the registered lengths.
    const auto off_px = [&](const SkinPositions& positions) {
      FaceChart chart = chart_of(shape).value();
      register_chart(positions, shape, markers_of(finger, bend), &chart);
      const ChartWarp warp(chart, rest);
      const int column = static_cast<int>(now.x());
      std::array<float, 2> u{}, v{};
      warp.positions(static_cast<int>(std::lround(now.y())), column, 2, u.data(), v.data());
      return std::lerp(static_cast<double>(u[0]), static_cast<double>(u[1]), now.x() - column) -
             seen_at(finger, {}, {0.98, 0.0}).x();
    };
    square_with += std::pow(off_px(with), 2);
    square_without += std::pow(off_px(without), 2);
    ++compared;
  }
  ASSERT_GT(compared, 40);
  const double rms_with = std::sqrt(square_with / compared),
               rms_without = std::sqrt(square_without / compared);
  std::printf("[ figures  ] skin at the tip end: %.2f px rms registered with it, %.2f without\n",
              rms_with, rms_without);
  EXPECT_LT(rms_with, 0.6 * rms_without);
}

TEST(ReferenceImage, IsTheWeightedSumWhereEveryFrameShowsTheSkin) {
  std::mt19937 random(7);
  const test::MarkedFinger finger;
  const FaceChart chart = chart_of(finger.shape({})).value();
  const FaceGrid grid = face_grid(chart, 0.15);
  const std::vector<float> weights{0.5F, -0.25F, 0.4F, 0.2F, 0.15F};
  constexpr int kShorter = 10;  // columns that each frame shows less than the one before
  std::vector<cv::Mat> images;
  std::vector<FaceImage> faces;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    cv::Mat grey(finger.height, finger.width, CV_8UC1);
    cv::randu(grey, 0, 256);
    images.push_back(grey);
    FaceChart shorter = chart;
    for (auto values : {&FaceChart::along_mm, &FaceChart::upper_v, &FaceChart::lower_v})
      (shorter.*values).resize(chart.along_mm.size() - kShorter * i);
    faces.push_back(warp_face(grey, shorter, grid));
    EXPECT_LT(faces.back().bytes(), grey.total());
  }
  std::vector<const FaceImage*> pointers;
  for (const auto& face : faces) pointers.push_back(&face);
  const cv::Size size(finger.width, finger.height);
  const cv::Mat grey =
      ReferenceImage(grid, {{pointers, weights}}, ChartWarp(chart, grid.chart), size).grey();
  int shown = 0;
  for (int u = 0; u < finger.width; ++u)
    for (int v = 0; v < finger.height; ++v) {
      const auto i = static_cast<std::size_t>(std::max(0, u - chart.first));
      const bool everywhere = u >= chart.first && u < chart.end() - 4 * kShorter &&
                              v > chart.upper_v[i] && v < chart.lower_v[i];
      ASSERT_EQ(std::isfinite(grey.at<float>(v, u)), everywhere) << u << ' ' << v;
      if (!everywhere) continue;
      double sum = 0;
      for (std::size_t k = 0; k < weights.size(); ++k)
        sum += static_cast<double>(weights[k]) * images[k].at<std::uint8_t>(v, u);
      // Five products rounded to 1/64, weights to 2^-14, places to 1/128 px of steep noise.
      ASSERT_NEAR(grey.at<float>(v, u), sum, 3.0) << u << ' ' << v;
      ++shown;
    }
  EXPECT_GT(shown, 20000);
}

TEST(ReferenceImage, ContinuesByTheSecondMixWhereTheFirstDoesNotShowTheSkin) {
  const test::MarkedFinger finger;
  const FaceChart chart = chart_of(finger.shape({})).value();
  const FaceGrid grid = face_grid(chart, 0.15);
  constexpr int kShorter = 40;
  FaceChart shorter = chart;
  for (auto values : {&FaceChart::along_mm, &FaceChart::upper_v, &FaceChart::lower_v})
    (shorter.*values).resize(chart.along_mm.size() - kShorter);
  const cv::Size size(finger.width, finger.height);
  const int border = chart.end() - kShorter;
  // The second is lit 1.2 times as bright; its last part reflects 1.5 times as much.
  constexpr int kStep = 20;
  cv::Mat brighter(size, CV_8UC1, cv::Scalar(60));
  brighter.colRange(border + kStep, size.width).setTo(90);
  const FaceImage near = warp_face(cv::Mat(size, CV_8UC1, cv::Scalar(50)), shorter, grid),
                  further = warp_face(brighter, chart, grid);
  const ReferenceImage image(grid, {{{&near}, {1.0F}}, {{&further}, {1.0F}}},
                             ChartWarp(chart, grid.chart), size);
  const cv::Mat grey = image.grey();
  for (int u = chart.first; u < chart.end(); ++u) {
    const auto i = static_cast<std::size_t>(u - chart.first);
    const int v = static_cast<int>(0.5 * (chart.upper_v[i] + chart.lower_v[i]));
    EXPECT_EQ(image.is_first_mix(u), u < border) << u;
    if (std::abs(u - border) <= 1 || std::abs(u - border - kStep) <= 3) continue;
    EXPECT_NEAR(grey.at<float>(v, u), u < border + kStep ? 50.0 : 75.0, 0.02) << u;
  }
}

TEST(ReferenceImage, ContinuesWithWeightsOfAnySizeAndLightFromOneSide) {
  const test::MarkedFinger finger;
  const FaceChart chart = chart_of(finger.shape({})).value();
  const FaceGrid grid = face_grid(chart, 0.15);
  constexpr int kShorter = 60;
  FaceChart shorter = chart;
  for (auto values : {&FaceChart::along_mm, &FaceChart::upper_v, &FaceChart::lower_v})
    (shorter.*values).resize(chart.along_mm.size() - kShorter);
  const cv::Size size(finger.width, finger.height);
  const int border = chart.end() - kShorter;
  // Lit more from above than the first: 1.1 times as bright at the top, 0.9 times at the bottom.
  cv::Mat even(size, CV_8UC1, cv::Scalar(100)), tilted(size, CV_8UC1);
  for (int v = 0; v < size.height; ++v)
    tilted.row(v).setTo(std::round(100.0 * (1.1 - 0.2 * v / size.height)));
  const FaceImage near = warp_face(even, shorter, grid), further = warp_face(tilted, chart, grid);
  for (const float weight : {1.0F, 1.5F, 1.75F}) {
    const ReferenceImage image(grid,
                               {{{&near}, {1.0F}}, {{&further, &further}, {weight, 1.0F - weight}}},
                               ChartWarp(chart, grid.chart), size);
    const cv::Mat grey = image.grey();
    for (int u = border + 4; u < chart.end() - 2; u += 3) {
      const auto i = static_cast<std::size_t>(u - chart.first);
      for (const double t : {0.1, 0.5, 0.9}) {
        const int v =
            static_cast<int>(chart.upper_v[i] + t * (chart.lower_v[i] - chart.upper_v[i]));
        EXPECT_NEAR(grey.at<float>(v, u), 100.0, 1.0) << weight << ' ' << u << ' ' << t;
      }
    }
  }
}

TEST(ReferenceImage, ShowsWhatColumnsShareOfASlantedEnd) {
  const test::MarkedFinger finger;
  const FaceChart chart = chart_of(finger.shape({})).value();
  const FaceGrid grid = face_grid(chart, 0.15);
  const cv::Size size(finger.width, finger.height);
  const FaceImage face = warp_face(cv::Mat(size, CV_8UC1, cv::Scalar(70)), chart, grid);
  for (const double tilt_mm : {-3.0, 3.0}) {
    FaceChart now = chart;  // the same pixels, whose skin lies as far along as its side says
    now.tilt_mm = tilt_mm;
    const ChartWarp warp(now, grid.chart);
    const cv::Mat grey = ReferenceImage(grid, {{{&face}, {1.0F}}}, warp, size).grey();
    int in_part = 0;
    for (int u = chart.first; u < chart.end(); ++u) {
      const auto i = static_cast<std::size_t>(u - chart.first);
      const auto l = std::min(i, chart.along_mm.size() - 2);
      const double step_mm = chart.along_mm[l + 1] - chart.along_mm[l];
      bool shows = false, hides = false;
      for (int v = static_cast<int>(chart.upper_v[i]) + 1; v < chart.lower_v[i]; ++v) {
        // How far along the skin is that this pixel shows, in columns of the recorded frame.
        const double across =
            2.0 * (v - chart.upper_v[i]) / (chart.lower_v[i] - chart.upper_v[i]) - 1.0;
        const double to_u = u + across * tilt_mm / step_mm;
        if (std::min(std::abs(to_u - chart.first), std::abs(to_u - (chart.end() - 1))) < 0.5)
          continue;
        const bool is_shown = to_u > chart.first && to_u < chart.end() - 1;
        ASSERT_EQ(std::isfinite(grey.at<float>(v, u)), is_shown) << u << ' ' << v;
        (is_shown ? shows : hides) = true;
        if (is_shown) {
          ASSERT_NEAR(grey.at<float>(v, u), 70.0, 0.02);
        }
      }
      in_part += shows && hides;
    }
    EXPECT_GT(in_part, 20);
  }
}

/// What a recording of one pose says its references are off by in a part of the face: brightness
/// that differs by 1 % from frame to frame, and `dented` frames in which that part is a fifth
/// darker.
double told_sd(int dented) {
  std::mt19937 random(3);
  std::normal_distribution<float> chance(150.0F, 1.5F);
  const test::MarkedFinger finger;
  const FaceChart chart = chart_of(finger.shape({})).value();
  const FaceGrid grid = face_grid(chart, 0.15);
  const cv::Size size(finger.width, finger.height);
  const cv::Rect part(500, 0, 60, size.height);
  constexpr int kFrames = 40, kPatchPx = 16;
  std::vector<FaceImage> faces;
  for (int i = 0; i < kFrames; ++i) {
    cv::Mat_<float> patches(size.height / kPatchPx, size.width / kPatchPx);
    for (float& level : patches) level = chance(random);
    cv::Mat grey;
    cv::resize(patches, grey, size, 0, 0, cv::INTER_LINEAR);
    if (i < dented) grey(part) *= 0.8;
    grey.convertTo(grey, CV_8U);
    faces.push_back(warp_face(grey, chart, grid));
  }
  const ReferenceError error = reference_error(grid, faces, [](int i) {
    PoseNeighbours neighbours{{}, Eigen::VectorXd::Constant(4, 0.25), 1.0};
    for (int k = 1; k <= 4; ++k) neighbours.rows.push_back((i + 9 * k) % kFrames);
    return neighbours;
  });
  const int row = (size.height / 2 - grid.origin.y) / kErrorCellPx;
  const int first = (part.x - grid.origin.x) / kErrorCellPx;
  return cv::mean(
      error.relative_sd(cv::Rect(first + 2, row - 4, part.width / kErrorCellPx - 4, 8)))[0];
}

TEST(ReferenceError, IsNotThatOfDentsWhichNobodyNoticed) {
  const double clean = told_sd(0), dented = told_sd(1);  // seen in 5 comparisons of 40
  std::printf("[ figures  ] references off by %.4f; with 1 of 40 frames dented %.4f\n", clean,
              dented);
  EXPECT_GT(clean, 0.004);
  EXPECT_LT(clean, 0.013);  // of one cell sqrt(1 + 1/4) %, less what lies between patches
  EXPECT_NEAR(dented / clean, 1.0, 0.3);
}

MarkerTable random_table(int frames, int per_row, std::mt19937& random) {
  test::MarkedFinger finger;
  finger.per_row = per_row;
  MarkerTable table;
  table.layouts.resize(frames, 4 * per_row);
  for (int i = 0; i < frames; ++i) {
    table.frames.push_back(2 * i);
    table.layouts.row(i) = finger.layout(test::random_bend(random)).transpose();
    table.seen.emplace_back(static_cast<std::size_t>(2 * per_row), 1);
    table.seen.back()[static_cast<std::size_t>(i) % 4] = 0;
  }
  table.typical = finger.typical(test::Bend{});
  return table;
}

TEST(MarkerTable, ComesBackAsItWasSaved) {
  std::mt19937 random(8);
  const MarkerTable table = random_table(7, 3, random);
  const fs::path file = scratch_folder("table") / "reference.csv";
  ASSERT_TRUE(table.save(file).ok());
  const auto again = MarkerTable::load(file, 6);
  ASSERT_TRUE(again.ok()) << again.error().sentence();
  EXPECT_EQ(again->frames, table.frames);
  EXPECT_EQ(again->seen, table.seen);
  EXPECT_EQ((again->layouts - table.layouts).cwiseAbs().maxCoeff(), 0.0);
  for (std::size_t m = 0; m < 6; ++m) {
    EXPECT_EQ(again->typical[m].radius_px, table.typical[m].radius_px);
    EXPECT_EQ(again->typical[m].contrast, table.typical[m].contrast);
  }
}

TEST(MarkerTable, EveryTruncationAndForeignValueIsAnErrorThatNamesTheFile) {
  std::mt19937 random(9);
  const fs::path folder = scratch_folder("truncated_table");
  const fs::path file = folder / "reference.csv";
  ASSERT_TRUE(random_table(2, 2, random).save(file).ok());
  const std::string whole = read_file(file).value();
  const auto load = [&](const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
    return MarkerTable::load(file, 4);
  };
  ASSERT_TRUE(load(whole).ok());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto result = load(whole.substr(0, size));
    ASSERT_FALSE(result.ok()) << "after " << size << " bytes";
    EXPECT_NE(result.error().sentence().find("reference.csv"), std::string::npos);
  }
  for (const auto& [good, bad] :
       std::vector<std::pair<std::string, std::string>>{{"\n0,0,", "\n0,1,"},
                                                        {"\n0,0,", "\n-1,0,"},
                                                        {"\n0,0,", "\n0,0,nan"},
                                                        {"\n0,1,", "\n0,1,1e9,"},
                                                        {"\n2,0,", "\n0,0,"},
                                                        {"end,2", "end,3"},
                                                        {"\n0,0,", "\n0,0,,"},
                                                        {"\n0,0,", "\n 0,0,"}}) {
    std::string text = whole;
    text.replace(text.find(good), good.size(), bad);
    EXPECT_FALSE(load(text).ok()) << bad;
  }
  EXPECT_FALSE(MarkerTable::load(folder / "none.csv", 4).ok());
  EXPECT_FALSE(MarkerTable::load(file, 0).ok());
}

TEST(ReferenceLibrary, ASinglePictureIsItsOwnReference) {
  cv::Mat grey(40, 60, CV_8UC1);
  cv::randu(grey, 0, 256);
  const auto library = ReferenceLibrary::single(grey);
  ASSERT_TRUE(library.ok());
  EXPECT_EQ(library->frame_count(), 1U);
  EXPECT_EQ(library->marker_model(), nullptr);
  CameraParameters camera;
  camera.width_px = 60, camera.height_px = 40;
  camera.fx_px = camera.fy_px = 50;
  camera.cx_px = 30, camera.cy_px = 20;
  const FaceShape shape = FaceShape::plane(Camera::create(camera).value(), Face{});
  const Reference reference = library->reference_for({}, shape, ReferenceMethod::kLocal);
  cv::Mat as_float;
  grey.convertTo(as_float, CV_32F);
  EXPECT_EQ(cv::norm(reference.image.grey(), as_float, cv::NORM_INF), 0.0);
  EXPECT_TRUE(cv::checkRange(reference.image.grey()));
  EXPECT_TRUE(reference.known_pose);
  EXPECT_FALSE(ReferenceLibrary::single(cv::Mat()).ok());
}

}  // namespace
}  // namespace alltact
