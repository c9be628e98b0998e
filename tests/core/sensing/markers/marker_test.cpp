#include "core/sensing/markers/dot_measure.h"
#include "core/sensing/markers/marker_detector.h"
#include "core/sensing/markers/marker_model.h"
#include "core/sensing/markers/marker_tracker.h"
#include "core/sensing/markers/markers.h"
#include "tests/support/marked_finger.h"

#include <cstdio>
#include <ctime>
#include <set>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::Bend;
using test::MarkedFinger;
using test::random_bend;

// Learns from layouts of random bends, seen with a little noise as a recording has them.
MarkerModel learn(const MarkedFinger& finger, int frames, std::mt19937& random,
                  double share = 1.0) {
  std::normal_distribution<double> noise(0.0, 0.05);
  Eigen::MatrixXd layouts(frames, 4 * finger.per_row);
  for (int i = 0; i < frames; ++i) {
    layouts.row(i) = finger.layout(random_bend(random, share)).transpose();
    for (Eigen::Index k = 0; k < layouts.cols(); ++k) layouts(i, k) += noise(random);
  }
  return MarkerModel::learn(layouts, finger.typical(Bend{})).value();
}

struct Errors {
  std::vector<double> values;
  void add(double e) { values.push_back(e); }
  double rms() const {
    double s = 0;
    for (double e : values) s += e * e;
    return std::sqrt(s / std::max<std::size_t>(1, values.size()));
  }
  double quantile(double q) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
  }
  void print(const char* what) {
    std::printf("[ figures  ] %s: n %zu rms %.3f p50 %.3f p95 %.3f max %.3f px\n", what,
                values.size(), rms(), quantile(0.5), quantile(0.95), quantile(1.0));
  }
};

double off(const Marker& marker, const Eigen::VectorXd& truth, std::size_t m) {
  const auto i = static_cast<Eigen::Index>(2 * m);
  return std::hypot(marker.u - truth[i], marker.v - truth[i + 1]);
}

std::vector<MarkedFinger> various_fingers() {
  std::vector<MarkedFinger> fingers(5);
  fingers[1].dot_contrast = -30;  // dark dots
  fingers[1].side_level = 50;
  fingers[2].dot_aspect = 2.5;  // foreshortened on a grazing side face
  fingers[3].width = 1920, fingers[3].height = 1080, fingers[3].focal = 1048;
  fingers[3].mirrored = true;
  fingers[4].off_face_mm = 5;  // close to the bright face
  fingers[4].per_row = 12;
  fingers[4].dot_mm = 0.4;
  return fingers;
}

TEST(MarkerDetector, FindsEveryDotToATenthOfAPixelWithoutBeingToldThePolarity) {
  std::mt19937 random(1);
  for (const MarkedFinger& finger : various_fingers()) {
    Errors errors;
    int missed = 0, false_dots = 0;
    double ms = 0;
    for (int i = 0; i < 12; ++i) {
      const Bend bend = random_bend(random);
      const cv::Mat grey = finger.with_noise(finger.clean(bend), random);
      const FaceShape shape = finger.shape(bend);
      const MarkerDetector detector({finger.per_row, Polarity::kAuto});
      const std::clock_t t0 = std::clock();
      const auto found = detector(grey, shape);
      ms += 1e3 * static_cast<double>(std::clock() - t0) / CLOCKS_PER_SEC;
      EXPECT_EQ(found.polarity, finger.dot_contrast > 0 ? Polarity::kBright : Polarity::kDark);
      const auto truth = finger.discs(bend);
      std::set<const Dot*> used;
      for (std::size_t m = 0; m < truth.size(); ++m) {
        const Dot* best = nullptr;
        for (const Dot& dot : found.dots)
          if (!best || std::hypot(dot.u - truth[m].u, dot.v - truth[m].v) <
                           std::hypot(best->u - truth[m].u, best->v - truth[m].v))
            best = &dot;
        const double e = best ? std::hypot(best->u - truth[m].u, best->v - truth[m].v) : 99;
        // Dots whose rim lies within 3 px of the bright face melt into it.
        const auto& column = shape.columns()[static_cast<std::size_t>(truth[m].u)];
        const double gap =
            std::min(std::abs(column.upper_v - truth[m].v), std::abs(column.lower_v - truth[m].v)) -
            truth[m].radius_v;
        if (e > 2) {
          missed += gap > 3;
          continue;
        }
        used.insert(best);
        errors.add(e);
        EXPECT_EQ(best->upper, m < static_cast<std::size_t>(finger.per_row));
      }
      false_dots += static_cast<int>(found.dots.size() - used.size());
    }
    errors.print("detector");
    std::printf("[ figures  ] missed %d, false %d, %.2f ms a picture (polarity not told)\n", missed,
                false_dots, ms / 12);
    EXPECT_LT(errors.rms(), 0.1);
    EXPECT_LT(errors.quantile(0.99), 0.25);
    EXPECT_LE(missed, 2);
    EXPECT_LE(false_dots, 6);
  }
}

// Dots as a detector gives them: in no order, some missing, some that are none.
std::vector<Dot> shuffled_dots(const MarkedFinger& finger, const Eigen::VectorXd& layout,
                               const std::set<int>& hidden, int false_dots, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, 0.05);
  std::uniform_real_distribution<double> along(0.0, finger.width), across(0.0, finger.height);
  std::vector<Dot> dots;
  for (int m = 0; m < 2 * finger.per_row; ++m)
    if (!hidden.contains(m))
      dots.push_back({layout[2 * m] + noise(random), layout[2 * m + 1] + noise(random), 5, 60, 0.05,
                      m < finger.per_row});
  for (int i = 0; i < false_dots; ++i) {
    const double v = across(random);
    dots.push_back({along(random), v, 5, 60, 0.05, v < finger.height / 2.0});
  }
  std::shuffle(dots.begin(), dots.end(), random);
  return dots;
}

std::set<int> random_markers(int count, int of, std::mt19937& random) {
  std::set<int> chosen;
  while (static_cast<int>(chosen.size()) < count)
    chosen.insert(static_cast<int>(random() % static_cast<unsigned>(of)));
  return chosen;
}

TEST(MarkerModel, NumbersDotsWithAThirdHiddenAndFalseOnesAmongThem) {
  std::mt19937 random(2);
  for (const int per_row : {6, 12}) {
    MarkedFinger finger;
    finger.per_row = per_row;
    const MarkerModel model = learn(finger, 400, random);
    for (const int hidden_count : {0, per_row / 3, 2 * per_row / 3}) {
      Errors hidden_errors;
      int slips = 0, lost = 0, refused = 0;
      constexpr int kFrames = 700;
      double ms = 0;
      for (int i = 0; i < kFrames; ++i) {
        const Eigen::VectorXd truth = finger.layout(random_bend(random));
        const auto hidden = random_markers(hidden_count, 2 * per_row, random);
        const auto dots = shuffled_dots(finger, truth, hidden, i % 3, random);
        const std::clock_t t0 = std::clock();
        const auto markers = model.number(dots);
        ms += 1e3 * static_cast<double>(std::clock() - t0) / CLOCKS_PER_SEC;
        if (!markers) {
          ++lost;
          continue;
        }
        bool slipped = false;
        for (std::size_t m = 0; m < markers->size(); ++m) {
          const double e = off((*markers)[m], truth, m);
          if ((*markers)[m].seen && e > 3) slipped = true;
          if (hidden.contains(static_cast<int>(m)))
            hidden_errors.add(e);
          else
            refused += !(*markers)[m].seen;
        }
        slips += slipped;
      }
      std::printf(
          "[ figures  ] %d a row, %d hidden: slips %d, lost %d of %d frames, refused %d, %.3f ms a "
          "frame\n",
          per_row, hidden_count, slips, lost, kFrames, refused, ms / kFrames);
      hidden_errors.print("hidden");
      EXPECT_EQ(slips, 0);
      EXPECT_EQ(lost, 0);
      EXPECT_LT(hidden_errors.quantile(0.95), 1.0);
    }
  }
}

TEST(MarkerTracker, FollowsTheFingerThroughCoveredMarkersAndJumps) {
  std::mt19937 random(3);
  const MarkedFinger finger;
  MarkerTracker tracker({finger.per_row, Polarity::kBright}, learn(finger, 300, random));
  Errors seen, hidden;
  double ms = 0;
  int slips = 0;
  constexpr int kFrames = 60;
  for (int i = 0; i < kFrames; ++i) {
    // A slow motion, and a jump to elsewhere in the middle of it.
    const double t = 0.05 * i + (i >= 30 ? 2.0 : 0.0);
    const Bend bend{0.3 * std::sin(t), 0.2 * std::cos(2 * t), 6 * std::sin(1.5 * t),
                    0.02 * std::cos(t)};
    const std::vector<int> covered =
        i / 10 % 2 ? std::vector<int>{2, 3, 8, 11} : std::vector<int>{};
    const cv::Mat grey = finger.with_noise(finger.clean(bend, covered), random);
    const FaceShape shape = finger.shape(bend);
    const std::clock_t t0 = std::clock();
    const auto markers = tracker(grey, shape, nullptr);
    ms += 1e3 * static_cast<double>(std::clock() - t0) / CLOCKS_PER_SEC;
    ASSERT_TRUE(markers.has_value()) << i;
    const Eigen::VectorXd truth = finger.layout(bend);
    for (std::size_t m = 0; m < markers->size(); ++m) {
      const double e = off((*markers)[m], truth, m);
      ((*markers)[m].seen ? seen : hidden).add(e);
      slips += (*markers)[m].seen && e > 3;
    }
  }
  seen.print("tracker, seen");
  hidden.print("tracker, hidden");
  std::printf("[ figures  ] tracker: %.3f ms a frame\n", ms / kFrames);
  EXPECT_EQ(slips, 0);
  EXPECT_LT(seen.rms(), 0.1);
  EXPECT_LT(hidden.quantile(0.95), 1.0);
  EXPECT_GE(hidden.values.size(), 4U * 30U);
}

TEST(MarkerTracker, TurnsPartlyCoveredMarkersIntoEstimates) {
  std::mt19937 random(13);
  const MarkedFinger finger;
  const MarkerModel model = learn(finger, 300, random);
  Errors all;
  int believed = 0, total = 0;
  for (int i = 0; i < 20; ++i) {
    const Bend bend = random_bend(random, 0.8);
    std::vector<MarkedFinger::Extra> covers;
    const auto discs = finger.discs(bend);
    for (const std::size_t m : {std::size_t{1}, std::size_t{9}}) {
      auto cover = discs[m];  // as dim as the side face, over half the dot
      cover.u += cover.radius_u;
      covers.push_back({cover, finger.side_level * (1.2 - 0.4 * cover.u / finger.width)});
    }
    const cv::Mat grey = finger.with_noise(finger.clean(bend, {}, covers), random);
    MarkerTracker tracker({finger.per_row, Polarity::kBright}, model);
    const auto markers = tracker(grey, finger.shape(bend), nullptr);
    ASSERT_TRUE(markers.has_value());
    const Eigen::VectorXd truth = finger.layout(bend);
    for (std::size_t m = 0; m < markers->size(); ++m) all.add(off((*markers)[m], truth, m));
    for (const std::size_t m : {std::size_t{1}, std::size_t{9}}) {
      believed += (*markers)[m].seen;
      ++total;
    }
  }
  all.print("partly covered, all markers");
  std::printf("[ figures  ] half-covered dots taken as seen: %d of %d\n", believed, total);
  EXPECT_LE(believed, total / 20);
  EXPECT_LT(all.quantile(1.0), 1.0);
}

TEST(MarkerTracker, SaysWhyNothingCouldBeFound) {
  std::mt19937 random(14);
  const MarkedFinger finger;
  MarkerTracker tracker({finger.per_row, Polarity::kBright}, learn(finger, 50, random));
  std::vector<int> every;
  for (int m = 0; m < 12; ++m) every.push_back(m);
  const cv::Mat bare = finger.with_noise(finger.clean(Bend{}, every), random);
  Message problem;
  EXPECT_FALSE(tracker(bare, finger.shape(Bend{}), &problem).has_value());
  EXPECT_NE(problem.english().find("12 markers"), std::string::npos) << problem.english();
}

// In no recorded frame all markers are seen.
TEST(MarkerModel, LearnsFromLayoutsWithGaps) {
  std::mt19937 random(15);
  std::normal_distribution<double> noise(0.0, 0.05);
  const MarkedFinger finger;
  Eigen::MatrixXd layouts(200, 24);
  for (int i = 0; i < 200; ++i) {
    layouts.row(i) = finger.layout(random_bend(random)).transpose();
    for (Eigen::Index k = 0; k < 24; ++k) layouts(i, k) += noise(random);
    for (const int m : random_markers(1 + i % 4, 12, random))
      layouts.row(i).segment<2>(2 * m).setConstant(std::nan(""));
  }
  const auto model = MarkerModel::learn(layouts, finger.typical(Bend{}));
  ASSERT_TRUE(model.ok());
  Errors hidden_errors;
  int slips = 0;
  for (int i = 0; i < 300; ++i) {
    const Eigen::VectorXd truth = finger.layout(random_bend(random, 0.8));
    const auto hidden = random_markers(3, 12, random);
    const auto markers = model->number(shuffled_dots(finger, truth, hidden, 2, random));
    ASSERT_TRUE(markers.has_value());
    for (std::size_t m = 0; m < markers->size(); ++m) {
      slips += (*markers)[m].seen && off((*markers)[m], truth, m) > 3;
      if (hidden.contains(static_cast<int>(m))) hidden_errors.add(off((*markers)[m], truth, m));
    }
  }
  hidden_errors.print("learnt with gaps, hidden");
  EXPECT_EQ(slips, 0);
  EXPECT_LT(hidden_errors.quantile(0.95), 1.0);
}

TEST(MarkerModel, NeverSeesAMarkerThatTheFingerDoesNotHave) {
  std::mt19937 random(16);
  const MarkedFinger finger;
  const std::vector<int> missing{3, 9};
  Eigen::MatrixXd layouts(200, 24);
  for (int i = 0; i < 200; ++i) layouts.row(i) = finger.layout(random_bend(random)).transpose();
  const auto model = MarkerModel::learn(layouts, finger.typical(Bend{}), missing);
  ASSERT_TRUE(model.ok());
  for (int i = 0; i < 50; ++i) {
    const Eigen::VectorXd truth = finger.layout(random_bend(random, 0.8));
    // A bubble just where marker 3 would be.
    const auto markers = model->number(shuffled_dots(finger, truth, {9}, 0, random));
    ASSERT_TRUE(markers.has_value());
    EXPECT_FALSE((*markers)[3].seen);
    EXPECT_FALSE((*markers)[9].seen);
    EXPECT_LT(off((*markers)[9], truth, 9), 2.0);
    for (std::size_t m : {0, 1, 2, 4, 5, 6, 7, 8, 10, 11}) EXPECT_TRUE((*markers)[m].seen) << m;
  }
}

TEST(MarkerModel, RefusesRecordingsThatTeachNothing) {
  const MarkedFinger finger;
  Eigen::MatrixXd layouts(3, 24);
  for (int i = 0; i < 3; ++i) layouts.row(i) = finger.layout(Bend{0.1 * i, 0, 0, 0}).transpose();
  EXPECT_TRUE(MarkerModel::learn(layouts, finger.typical(Bend{})).ok());
  layouts.block(1, 0, 2, 14).setConstant(std::nan(""));
  EXPECT_FALSE(MarkerModel::learn(layouts, finger.typical(Bend{})).ok())
      << "less than half is seen";
  EXPECT_FALSE(MarkerModel::learn(Eigen::MatrixXd(), {}).ok());
}

}  // namespace
}  // namespace alltact
