// Recordings that show little, and pictures in which few markers are left: installed and followed
// within a bound, or refused by name. Long ones run with `packaging/test --slow`.
#include "calibration/reference/reference_recording.h"
#include "core/sensing/markers/marker_tracker.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/reference/recorded_poses.h"
#include "tests/stability/awaited.h"
#include "tests/support/marked_recording.h"
#include "tests/support/scratch_folder.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using test::Bend;
using test::described;
using test::MarkedFinger;
using test::MemorySource;
using test::pose;
using test::scratch_folder;
using test::small_finger;
using ::testing::AnyOf;
using ::testing::HasSubstr;

struct Installed {
  MarkedFinger drawn = small_finger();
  Finger finger = described(drawn);
  fs::path folder;
  std::optional<Result<ReferenceReport>> report;

  /// Records these poses; the same poses twice are not the same noise.
  explicit Installed(const std::string& name, const std::vector<Bend>& poses)
      : folder(scratch_folder(name)) {
    std::mt19937 random(51);
    MemorySource source;
    for (const Bend& bend : poses)
      source.images.push_back(drawn.with_noise(drawn.clean(bend), random));
    report = install_reference(source, folder, finger, Job{});
  }
  [[nodiscard]] Pipeline pipeline() const {
    return Pipeline::create(FingerSnapshot::of(folder, finger).value(), PipelineSettings{}, Job{})
        .value();
  }
};

std::vector<Bend> all_ways(int frames) {
  std::vector<Bend> poses;
  for (int i = 0; i < frames; ++i) poses.push_back(pose(i, frames));
  return poses;
}

FrameResult measured(Pipeline& pipeline, const cv::Mat& grey) {
  auto frame = std::make_shared<Frame>();
  frame->grey = grey;
  frame->name = "frame";
  pipeline.forget();
  return pipeline(frame).value();
}

/// Greatest distance of the markers, seen and estimated, from where they are.
struct Off {
  double seen_px = 0, hidden_px = 0;
  int seen = 0;
};
Off off_of(const Markers& markers, const MarkedFinger& drawn, const Bend& bend) {
  Off off;
  const auto truth = drawn.discs(bend);
  for (std::size_t m = 0; m < truth.size(); ++m) {
    const double px = std::hypot(markers[m].u - truth[m].u, markers[m].v - truth[m].v);
    EXPECT_TRUE(std::isfinite(px));
    (markers[m].seen ? off.seen_px : off.hidden_px) =
        std::max(markers[m].seen ? off.seen_px : off.hidden_px, px);
    off.seen += markers[m].seen ? 1 : 0;
  }
  return off;
}

TEST(HardRecordings, OfOneFrameIsRefused) {
  ALLTACT_SKIP_IF_AWAITED();
  const Installed one("one", all_ways(1));
  ASSERT_FALSE(one.report->ok());
  EXPECT_THAT(one.report->error().sentence(), HasSubstr("frame"));
}

TEST(HardRecordings, OfTwoFramesMeasuresThoseTwoPosesAndKnowsThatItKnowsNoOther) {
  ALLTACT_SKIP_IF_AWAITED();
  const Bend a{0.1, 0, 0, 0}, b{-0.1, 0.05, 2, 0};
  const Installed two("two", {a, b});
  if (!two.report->ok()) {
    EXPECT_THAT(two.report->error().sentence(), HasSubstr("frames"));
    return;
  }
  Pipeline pipeline = two.pipeline();
  std::mt19937 random(52);
  for (const Bend& bend : {a, b}) {
    const FrameResult result =
        measured(pipeline, two.drawn.with_noise(two.drawn.clean(bend), random));
    ASSERT_TRUE(result.markers);
    EXPECT_LT(off_of(*result.markers, two.drawn, bend).seen_px, 1.0);
    EXPECT_TRUE(result.reference->known_pose);
  }
  const Bend other{-0.4, 0.2, -6, 0.03};
  const FrameResult result =
      measured(pipeline, two.drawn.with_noise(two.drawn.clean(other), random));
  EXPECT_FALSE(result.problems.empty());
}

TEST(HardRecordings, OfTheSamePoseAgainAndAgainIsNamed) {
  ALLTACT_SKIP_IF_AWAITED();
  const Installed still("still", std::vector<Bend>(20, Bend{}));
  if (!still.report->ok()) {
    EXPECT_THAT(still.report->error().sentence(), AnyOf(HasSubstr("same"), HasSubstr("bend")));
    return;
  }
  const ReferenceReport& report = still.report->value();
  EXPECT_TRUE(report.repeated > 10 || !report.remarks.empty());
  EXPECT_TRUE(std::isfinite(report.error_median_mm) && std::isfinite(report.error_p95_mm));
}

TEST(HardRecordings, OfBendingInOneWayOnlyMeasuresOnThatWayAndNamesOthers) {
  ALLTACT_SKIP_IF_AWAITED();
  std::vector<Bend> poses;
  for (int i = 0; i < 24; ++i) poses.push_back({-0.3 + 0.6 * i / 23, 0, 0, 0});
  const Installed line("line", poses);
  ASSERT_TRUE(line.report->ok()) << line.report->error().sentence();
  Pipeline pipeline = line.pipeline();
  std::mt19937 random(53);
  for (const double curl : {-0.21, 0.013, 0.24}) {
    const Bend bend{curl, 0, 0, 0};
    const FrameResult result =
        measured(pipeline, line.drawn.with_noise(line.drawn.clean(bend), random));
    ASSERT_TRUE(result.markers) << curl;
    EXPECT_LT(off_of(*result.markers, line.drawn, bend).seen_px, 1.0) << curl;
    EXPECT_TRUE(result.reference->known_pose) << curl;
  }
  // Aside by 6 mm at the tip: nothing like it was recorded.
  const FrameResult aside =
      measured(pipeline, line.drawn.with_noise(line.drawn.clean({0, 0, 6, 0}), random));
  EXPECT_FALSE(aside.problems.empty());
}

/// Hides markers of a pose between the recorded ones. Enough of them: each within a bound; too few:
/// a problem says so.
class FewMarkers : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    installed_ = std::make_unique<Installed>("few", all_ways(60));
    ASSERT_TRUE(installed_->report->ok()) << installed_->report->error().sentence();
  }
  static void TearDownTestSuite() { installed_.reset(); }

  static FrameResult with_hidden(const std::vector<int>& hidden, const Bend& bend) {
    Pipeline pipeline = installed_->pipeline();
    std::mt19937 random(54);
    const MarkedFinger& drawn = installed_->drawn;
    return measured(pipeline, drawn.with_noise(drawn.clean(bend, hidden), random));
  }
  static inline std::unique_ptr<Installed> installed_;
};

TEST_F(FewMarkers, AWholeRowHiddenIsFilledInFromTheOther) {
  ALLTACT_SKIP_IF_AWAITED();
  for (const int first : {0, 6}) {
    std::vector<int> hidden;
    for (int m = first; m < first + 6; ++m) hidden.push_back(m);
    const Bend bend{0.12, -0.05, 1.5, 0.01};
    const FrameResult result = with_hidden(hidden, bend);
    ASSERT_TRUE(result.markers) << fmt::format("{}", fmt::join(result.problems, "; "));
    const Off off = off_of(*result.markers, installed_->drawn, bend);
    EXPECT_EQ(off.seen, 6);
    EXPECT_LT(off.seen_px, 1.0);
    EXPECT_LT(off.hidden_px, 3.0);
  }
}

TEST_F(FewMarkers, OneOrTwoLeftAreTooFewSoThatTheShapeTellsThePoseAndThatIsSaid) {
  ALLTACT_SKIP_IF_AWAITED();
  const Bend bend{0.12, -0.05, 1.5, 0.01};
  for (const int left : {0, 1, 2}) {
    std::vector<int> hidden;
    for (int m = left; m < 12; ++m) hidden.push_back(m);
    const FrameResult result = with_hidden(hidden, bend);
    ASSERT_TRUE(result.markers) << left;
    const Off off = off_of(*result.markers, installed_->drawn, bend);
    EXPECT_EQ(off.seen, 0) << left;
    EXPECT_LT(off.hidden_px, 3.0) << left;
    EXPECT_THAT(fmt::format("{}", fmt::join(result.problems, "; ")), HasSubstr("dots")) << left;
  }
}

TEST(MarkerTables, WithNumbersThatAreNoneAreRefusedByTheirLine) {
  ALLTACT_SKIP_IF_AWAITED();
  const fs::path folder = scratch_folder("tables");
  const std::string head = "frame,number,u,v,seen,radius,contrast\n0,0,10,20,1,3,50\n";
  for (const char* bad : {"nan", "inf", "-inf", "1e999", "", "0x10", "1e308"})
    for (int column = 2; column < 7; ++column) {
      std::vector<std::string> cells{"0", "1", "30", "20", "1", "3", "50"};
      cells[static_cast<std::size_t>(column)] = bad;
      std::ofstream(folder / "t.csv") << head << fmt::format("{}\nend,1\n", fmt::join(cells, ","));
      const auto table = MarkerTable::load(folder / "t.csv", 2);
      ASSERT_FALSE(table.ok()) << bad << " in column " << column;
      EXPECT_THAT(table.error().sentence(), HasSubstr("line 3")) << bad;
    }
}

/// Layouts of two rows of 12 markers in poses at random.
Eigen::MatrixXd many_layouts(int frames, std::mt19937& random) {
  MarkedFinger drawn;
  drawn.per_row = 12;
  // Layouts follow three modes; the exact ones of so many poses would take minutes.
  const Eigen::VectorXd rest = drawn.layout({}), curled = drawn.layout({0.3, 0, 0, 0}),
                        hooked = drawn.layout({0, 0.2, 0, 0}), swayed = drawn.layout({0, 0, 6, 0});
  std::uniform_real_distribution<double> part(-1, 1);
  std::normal_distribution<double> noise(0, 0.05);
  Eigen::MatrixXd layouts(frames, rest.size());
  for (Eigen::Index i = 0; i < frames; ++i) {
    layouts.row(i) = (rest + part(random) * (curled - rest) + part(random) * (hooked - rest) +
                      part(random) * (swayed - rest))
                         .transpose();
    for (double& value : layouts.row(i)) value += noise(random);
  }
  return layouts;
}

Markers markers_of(const Eigen::VectorXd& layout) {
  Markers markers;
  for (Eigen::Index m = 0; m < layout.size() / 2; ++m)
    markers.push_back({layout[2 * m], layout[2 * m + 1], true, 0.05});
  return markers;
}

TEST(LongRecordings, OfAHundredThousandFramesAreLearntAndSearched) {
  const int frames = test::is_slow_run() ? 100'000 : 10'000;
  std::mt19937 random(55);
  const Eigen::MatrixXd layouts = many_layouts(frames, random);
  const LayoutSearch search(layouts);
  for (int i = 0; i < 50; ++i) {
    const auto row = static_cast<Eigen::Index>(random() % frames);
    const auto found = search.nearest(markers_of(layouts.row(row).transpose()));
    EXPECT_EQ(found.row, row);
    EXPECT_LT(found.distance_px, 1e-3);
  }
  EXPECT_GT(search.median_step_px(), 0.0);

  MarkedFinger drawn;
  drawn.per_row = 12;
  const auto model = MarkerModel::learn(layouts, drawn.typical({}));
  ASSERT_TRUE(model.ok()) << model.error().sentence();
  for (int i = 0; i < 20; ++i) {
    const Eigen::VectorXd layout =
        layouts.row(static_cast<Eigen::Index>(random() % frames)).transpose();
    Markers markers = markers_of(layout);
    for (const std::size_t hidden : {3U, 11U, 17U}) markers[hidden].seen = false;
    const auto whole = model->complete(markers);
    ASSERT_TRUE(whole);
    for (const std::size_t m : {3U, 11U, 17U}) {
      const auto k = static_cast<Eigen::Index>(2 * m);
      EXPECT_LT(std::hypot((*whole)[m].u - layout[k], (*whole)[m].v - layout[k + 1]), 0.5);
    }
  }
}

TEST(SlowRecordings, AMillionFramesAreFollowedWithoutASlip) {
  if (!test::is_slow_run()) GTEST_SKIP() << "packaging/test --slow";
  constexpr int kFrames = 1'000'000, kPictures = 240;
  const Installed installed("million", all_ways(60));
  ASSERT_TRUE(installed.report->ok()) << installed.report->error().sentence();
  const Camera camera = Camera::create(installed.finger.camera).value();
  const auto library =
      ReferenceLibrary::load(FingerSnapshot::of(installed.folder, installed.finger).value(), Job{})
          .value();
  MarkerTracker tracker(installed.finger.markers, *library.marker_model());
  // One round of bending, over and over: neighbours in time are neighbours in pose.
  const MarkedFinger& drawn = installed.drawn;
  std::mt19937 random(56);
  std::vector<cv::Mat> images;
  std::vector<FaceShape> shapes;
  std::vector<Eigen::VectorXd> truth;
  for (int i = 0; i < kPictures; ++i) {
    const Bend bend = pose(i, kPictures);
    const std::vector<int> hidden =
        i % 5 == 0 ? std::vector<int>{i % 12, (i + 5) % 12} : std::vector<int>{};
    images.push_back(drawn.with_noise(drawn.clean(bend, hidden), random));
    shapes.push_back(drawn.shape(bend));
    truth.push_back(drawn.layout(bend));
  }
  int lost = 0, slipped = 0;
  for (int i = 0; i < kFrames; ++i) {
    const auto k = static_cast<std::size_t>(i % kPictures);
    const auto markers = tracker(images[k], shapes[k], nullptr);
    if (!markers) {
      ++lost;
      continue;
    }
    bool is_wrong = false;
    for (std::size_t m = 0; m < markers->size(); ++m) {
      const auto at = static_cast<Eigen::Index>(2 * m);
      is_wrong |= (*markers)[m].seen && std::hypot((*markers)[m].u - truth[k][at],
                                                   (*markers)[m].v - truth[k][at + 1]) > 3;
    }
    slipped += is_wrong ? 1 : 0;
  }
  std::printf("[ figures  ] of %d frames %d lost, %d slipped\n", kFrames, lost, slipped);
  EXPECT_LT(lost, kFrames / 1000);
  EXPECT_LT(slipped, kFrames / 1000);
}

}  // namespace
}  // namespace alltact
