// The source paper's experiments: what the table says of them, and one from end to end.
#include "calibration/experiments/experiments.h"

#include "core/simulation/scene.h"
#include "tests/support/slow_run.h"
#include "tests/support/temporary_folder.h"

#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

std::set<std::string> scenes_of_experiments() {
  std::set<std::string> scenes;
  for (const Experiment& experiment : experiments())
    scenes.insert(experiment.scenes.begin(), experiment.scenes.end());
  return scenes;
}

TEST(Experiments, NamesAreDifferentAndScenesAreThere) {
  std::set<std::string> names;
  const std::filesystem::path folder = ALLTACT_SOURCE_DIR "/resources/scenes";
  for (const Experiment& experiment : experiments()) {
    EXPECT_TRUE(names.insert(experiment.name).second) << experiment.name;
    EXPECT_FALSE(experiment.measures.empty());
    ASSERT_FALSE(experiment.scenes.empty());
    for (const std::string& name : experiment.scenes) {
      const auto scene = Scene::load(folder / (name + ".yaml"));
      ASSERT_TRUE(scene) << scene.error().sentence();
      std::string expected = name;
      std::replace(expected.begin(), expected.end(), '_', ' ');
      EXPECT_EQ(scene->name, expected);
    }
  }
}

// A scene that no experiment measures says in vain what it is for.
TEST(Experiments, EverySceneOfAnExperimentIsMeasured) {
  const std::set<std::string> measured = scenes_of_experiments();
  int scenes = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(ALLTACT_SOURCE_DIR "/resources/scenes")) {
    const std::string stem = entry.path().stem().string();
    if (!stem.starts_with("experiment_")) continue;
    EXPECT_TRUE(measured.contains(stem)) << stem;
    ++scenes;
  }
  EXPECT_GE(scenes, 9);
}

TEST(Experiments, AreChosenByNameInTheTablesOrder) {
  const auto all = experiments_named({});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->size(), experiments().size());
  const auto some = experiments_named({"time", "pose", "time"});
  ASSERT_TRUE(some);
  ASSERT_EQ(some->size(), 2U);
  EXPECT_EQ(some->front()->name, "pose");
  EXPECT_EQ(some->back()->name, "time");
}

TEST(Experiments, AnUnknownNameIsRefusedWithTheNearest) {
  const auto refused = experiments_named({"pose", "localization"});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().sentence(), HasSubstr("'localization'"));
  EXPECT_THAT(refused.error().sentence(), HasSubstr("Try: 'localisation'"));
}

TEST(Experiments, AnAimIsReachedFromTheRightSide) {
  EXPECT_TRUE((ExperimentFigure{"", "mm", 0.2, {}, 0.2}.reaches_aim()));
  EXPECT_FALSE((ExperimentFigure{"", "mm", 0.21, {}, 0.2}.reaches_aim()));
  EXPECT_FALSE((ExperimentFigure{"", "%", 99.4, {}, 99.5, true}.reaches_aim()));
  EXPECT_TRUE((ExperimentFigure{"", "%", 99.5, {}, 99.5, true}.reaches_aim()));
  EXPECT_TRUE((ExperimentFigure{"", "ms", 1e9, 2.0, {}}.reaches_aim()));
}

BenchOptions options_in(const test::TemporaryFolder& folder) {
  BenchOptions options;
  options.folder = folder.path();
  options.threads = 2;
  options.recording_every = test::as_many_as(3, 1);
  return options;
}

class ExperimentsOnAFinger : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new test::TemporaryFolder;
    auto bench = ExperimentBench::make(options_in(*folder_), job_);
    ASSERT_TRUE(bench) << bench.error().sentence();
    bench_ = new ExperimentBench(std::move(bench).value());
  }
  static void TearDownTestSuite() {
    delete bench_;
    delete folder_;
  }

  static ExperimentOutcome outcome_of(const std::string& name) {
    auto outcome = experiments_named({name}).value().front()->run(*bench_);
    EXPECT_TRUE(outcome) << outcome.error().sentence();
    return std::move(outcome).value();
  }

  static inline const Job job_;
  static inline test::TemporaryFolder* folder_ = nullptr;
  static inline ExperimentBench* bench_ = nullptr;
};

// Bars lie at multiples of 15 degrees, which their names in the scene tell apart from the picture.
TEST_F(ExperimentsOnAFinger, PoseIsThatOfTheBars) {
  const ExperimentOutcome pose = outcome_of("pose");
  EXPECT_EQ(pose.frames, 12);
  ASSERT_EQ(pose.figures.size(), 3U);
  EXPECT_LT(pose.figures[0].simulated, 0.3);
  EXPECT_GT(pose.figures[0].simulated, 0);  // noise is in the pictures
  EXPECT_LT(pose.figures[1].simulated, 1.0);
  EXPECT_GE(pose.figures[1].simulated, pose.figures[0].simulated);
  EXPECT_EQ(pose.figures[2].simulated, 100);
  EXPECT_EQ(pose.figures[0].paper, 3.22);
}

// The scene's balls stand at known centres: along the face a ball touches deepest below its middle.
TEST_F(ExperimentsOnAFinger, LocalisationHoldsAgainstTheBallsOwnCentres) {
  double greatest_mm = 0;
  const auto frames = bench_->measure(
      "experiment_localisation", {},
      [&](std::size_t, const Truth& truth, const FrameResult& result) {
        ASSERT_FALSE(result.regions.empty());
        const Eigen::Vector3d normal = truth.contacts.front().direction;
        Eigen::Vector3d off = result.regions.front().position_mm - truth.ball->centre_mm;
        off -= off.dot(normal) * normal;
        greatest_mm = std::max(greatest_mm, off.norm());
      });
  ASSERT_TRUE(frames) << frames.error().sentence();
  EXPECT_EQ(*frames, 27);
  EXPECT_LT(greatest_mm, 0.2);
  if (!test::is_slow_run()) return;  // it makes fingers of its own
  const ExperimentOutcome told = outcome_of("localisation");
  ASSERT_EQ(told.figures.size(), 6U);
  EXPECT_NEAR(told.figures[2].simulated, greatest_mm, 0.01);
  EXPECT_LE(told.figures[0].simulated, told.figures[2].simulated);
  EXPECT_EQ(told.figures[3].simulated, 100);
  for (const ExperimentFigure& figure : told.figures) EXPECT_TRUE(figure.reaches_aim());
  EXPECT_GT(told.figures[4].simulated, 0);  // fingers of its own
  EXPECT_NE(told.figures[4].simulated, told.figures[0].simulated);
}

// What happens to a finger is the scene's; that one reference is worse is what the paper is about.
TEST_F(ExperimentsOnAFinger, OneReferenceIsWorseThanARecording) {
  if (!test::is_slow_run()) GTEST_SKIP() << "needs whole recordings; packaging/test --slow";
  const ExperimentOutcome references = outcome_of("references");
  EXPECT_EQ(references.frames, (1 + kFingerVariants) * 40);
  ASSERT_EQ(references.figures.size(), 9U);
  EXPECT_GT(references.figures[0].simulated, 90);                               // nearest
  EXPECT_LT(references.figures[1].simulated, references.figures[0].simulated);  // single
  EXPECT_GT(references.figures[3].simulated, 1.5 * references.figures[4].simulated);
  EXPECT_GT(references.figures[4].simulated, references.figures[5].simulated);
  EXPECT_TRUE(references.figures[2].reaches_aim()) << references.figures[2].simulated;
  // What the frames that the reference combines show together is nearer than any of them.
  EXPECT_GT(references.figures[7].simulated, 90);
  EXPECT_GT(references.figures[7].simulated, references.figures[6].simulated + 20);
  EXPECT_TRUE(references.figures[8].reaches_aim()) << references.figures[8].simulated;
}

/// Columns of a row that are higher than their neighbours and than half of what is highest.
std::vector<int> crests_of(const cv::Mat_<float>& map, int row) {
  double highest = 0;
  cv::minMaxLoc(map.row(row), nullptr, &highest);
  std::vector<int> crests;
  for (int u = 3; u + 3 < map.cols; ++u) {
    const float here = map(row, u);
    if (here > 0.5 * highest && here > map(row, u - 3) && here >= map(row, u + 3) &&
        (crests.empty() || u - crests.back() > 6))
      crests.push_back(u);
  }
  return crests;
}

double rms_of(const cv::Mat_<float>& map) {
  const cv::Mat told = map == map;
  EXPECT_GT(cv::countNonZero(told), 0.95 * static_cast<double>(map.total()));
  return cv::norm(map, cv::NORM_L2, told) / std::sqrt(cv::countNonZero(told));
}

// An M8 thread has a crest every 1.25 mm, wherever the finger is bent to.
TEST_F(ExperimentsOnAFinger, MapsShowTheThreadInMillimetres) {
  const ExperimentOutcome thread = outcome_of("thread");
  ASSERT_EQ(thread.maps.size(), 2U);
  for (const ExperimentMaps& maps : thread.maps) {
    ASSERT_EQ(maps.depths.size(), 3U);
    ASSERT_EQ(maps.differences.size(), 2U);
    const cv::Mat_<float>& truth = maps.depths[0].mm;
    const std::vector<int> crests = crests_of(truth, truth.rows / 2);
    ASSERT_GE(crests.size(), 8U);
    const double pitch_mm = maps.mm_per_cell * (crests.back() - crests.front()) /
                            static_cast<double>(crests.size() - 1);
    EXPECT_NEAR(pitch_mm, 1.25, 0.02);
    // In the middle along it and across it.
    EXPECT_NEAR(0.5 * (crests.front() + crests.back()), 0.5 * truth.cols, 20);
    double deepest_mm = 0;
    cv::minMaxLoc(truth, nullptr, &deepest_mm);
    EXPECT_GT(maps.top_mm, 0.95 * deepest_mm);
    for (std::size_t method = 0; method < 2; ++method) {
      const cv::Mat_<float> off = maps.depths[method + 1].mm - truth;
      EXPECT_NEAR(rms_of(off), rms_of(maps.differences[method].mm), 1e-9);
      EXPECT_EQ(crests_of(maps.depths[method + 1].mm, truth.rows / 2).size(), crests.size());
    }
  }
  const auto& bent = thread.maps[1].differences;
  EXPECT_GT(rms_of(bent[1].mm), 1.2 * rms_of(bent[0].mm));
}

// Hidden markers lie nearer to what the recording knows than half-way between their neighbours.
TEST_F(ExperimentsOnAFinger, WaysOfFindingMarkersAreCompared) {
  if (!test::is_slow_run()) GTEST_SKIP() << "makes fingers of its own; packaging/test --slow";
  const ExperimentOutcome markers = outcome_of("markers");
  constexpr std::size_t kOfAWay = 5;  // found, elsewhere, off, hidden, ms
  ASSERT_EQ(markers.figures.size(), 3 * kOfAWay);
  const auto of = [&](std::size_t way, std::size_t figure) {
    return markers.figures[way * kOfAWay + figure].simulated;
  };
  for (const std::size_t way : {0, 2}) {  // blobs, network
    EXPECT_GT(of(way, 0), 85) << way;
    EXPECT_LT(of(way, 1), 1) << way;
    EXPECT_LT(of(way, 3), 0.1 * of(1, 3)) << way;
  }
  EXPECT_GT(of(2, 4), of(0, 4)) << "a network costs more";
  for (const ExperimentPlot& plot : markers.plots) {
    EXPECT_EQ(plot.series.size(), 3U);
    EXPECT_EQ(plot.categories.size(), 6U);
  }
}

TEST_F(ExperimentsOnAFinger, AStopIsHeard) {
  Job stopped;
  stopped.request_stop();
  test::TemporaryFolder folder;
  const auto bench = ExperimentBench::make(options_in(folder), stopped);
  EXPECT_FALSE(bench);
}

}  // namespace
}  // namespace alltact
