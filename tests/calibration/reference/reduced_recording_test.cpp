// A finger with its recording, measured with fewer pixels, other numbers of neighbours and what was
// kept of the recording: the demonstration's, simulated, a ball pressed into it.
#include "calibration/reference/reference_recording.h"
#include "core/base/atomic_file.h"
#include "core/finger/finger_store.h"
#include "core/numerics/median.h"
#include "core/sensing/pipeline.h"
#include "core/simulation/plan.h"
#include "core/sources/source.h"
#include "tests/support/plan_source.h"
#include "tests/support/temporary_folder.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

constexpr int kRecorded = 40, kPressed = 8;

/// Recorded once for all tests.
class RecordedFinger : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::string scene = read_file(std::filesystem::path(ALLTACT_SOURCE_DIR) /
                                  "resources/scenes/demo_reference.yaml")
                            .value();
    const Plan plan = Plan::compile(Scene::parse(scene, "demo").value(), 5).value();
    const std::string markers = "  - {use: markers,";
    const std::string ball =
        "  - {use: ball, radius_mm: 4.0, s_mm: {from: 22.0, to: 80.0}, y_mm: {from: -4.0, to: "
        "4.0}, depth_mm: {from: 0.4, to: 1.2}}\n";
    scene.insert(scene.find(markers), ball);
    const Plan touched = Plan::compile(Scene::parse(scene, "demo").value(), 5).value();
    folder_ = std::make_unique<TemporaryFolder>();
    Finger finger = plan.finger();
    PlanSource source(plan, kRecorded);
    const auto installed = install_reference(source, folder_->path(), finger, Job());
    ASSERT_TRUE(installed.ok()) << installed.error().sentence();
    MappingParameters mapping;
    mapping.kind = MappingKind::kMoebius;
    mapping.x_max = 0.6;
    mapping.a_mm = 2.4;
    mapping.b = 0.6;
    finger.mapping = mapping;
    finger_ = std::make_unique<FingerSnapshot>(FingerSnapshot::of(folder_->path(), finger).value());
    PlanSource live(touched, kPressed);
    for (auto frame = live.next(); *frame; frame = live.next()) frames_.push_back(*frame);
  }
  static void TearDownTestSuite() {
    folder_.reset();
    finger_.reset();
    frames_.clear();
  }

  static std::vector<FrameResult> measured(const PipelineSettings& settings) {
    auto pipeline = Pipeline::create(*finger_, settings, Job());
    EXPECT_TRUE(pipeline.ok()) << pipeline.error().sentence();
    if (!pipeline) return {};
    std::vector<FrameResult> results;
    for (const FramePtr& frame : frames_) {
      auto result = (*pipeline)(frame);
      EXPECT_TRUE(result.ok());
      results.push_back(std::move(result).value());
    }
    return results;
  }

  static std::unique_ptr<TemporaryFolder> folder_;
  static std::unique_ptr<FingerSnapshot> finger_;
  static std::vector<FramePtr> frames_;
};
std::unique_ptr<TemporaryFolder> RecordedFinger::folder_;
std::unique_ptr<FingerSnapshot> RecordedFinger::finger_;
std::vector<FramePtr> RecordedFinger::frames_;

TEST_F(RecordedFinger, IsReadAtTheResolutionThatIsMeasuredWith) {
  const auto whole = ReferenceLibrary::load(*finger_, Job());
  ASSERT_TRUE(whole.ok());
  for (const int by : {2, 4}) {
    const auto reduced = ReferenceLibrary::load(reduced_finger(*finger_, by), Job());
    ASSERT_TRUE(reduced.ok()) << reduced.error().sentence();
    EXPECT_EQ(reduced->frame_count(), whole->frame_count());
    const double part =
        static_cast<double>(reduced->memory_bytes()) / static_cast<double>(whole->memory_bytes());
    EXPECT_NEAR(part * by * by, 1.0, 0.1) << "of the memory";
  }
}

TEST_F(RecordedFinger, TellsTheSameMillimetresWithFewerPixels) {
  const std::vector<FrameResult> whole = measured({});
  for (const Resolution resolution : {Resolution::kHalf, Resolution::kQuarter}) {
    PipelineSettings settings;
    settings.resolution = resolution;
    const int by = binning_factor(resolution);
    const std::vector<FrameResult> reduced = measured(settings);
    std::vector<double> depths_mm, places_mm, distances_mm;
    for (int i = 0; i < kPressed; ++i) {
      const FrameResult &a = whole[static_cast<std::size_t>(i)],
                        &b = reduced[static_cast<std::size_t>(i)];
      ASSERT_TRUE(a.depth && b.depth) << i << " by " << by;
      ASSERT_EQ(b.depth->depth_mm.size(), cv::Size(960 / by, 540 / by));
      ASSERT_FALSE(a.regions.empty()) << i;
      // A small contact near the tip is a few pixels of a quarter of the picture.
      if (b.regions.empty()) continue;
      places_mm.push_back((a.regions[0].position_mm - b.regions[0].position_mm).norm());
      for (int v = 0; v < b.depth->depth_mm.rows; ++v)
        for (int u = 0; u < b.depth->depth_mm.cols; ++u) {
          const cv::Mat square = a.depth->depth_mm({u * by, v * by, by, by});
          const double mean = cv::mean(square)[0];
          const double here = static_cast<double>(b.depth->depth_mm.at<float>(v, u));
          if (mean > 0.1 && std::isfinite(here)) depths_mm.push_back(std::abs(here - mean));
          const double middle = 0.5 * (by - 1);
          const auto local = a.shape->at(u * by + middle, v * by + middle),
                     other = b.shape->at(u, v);
          if (local && other && u % 8 == 0 && v % 8 == 0)
            distances_mm.push_back((local->view_point_mm - other->view_point_mm).norm());
        }
    }
    ASSERT_GE(places_mm.size(), by == 2 ? std::size_t{kPressed} : std::size_t{kPressed / 2});
    EXPECT_LT(upper_median(depths_mm), by == 2 ? 0.01 : 0.04);
    EXPECT_LT(upper_median(places_mm), by == 2 ? 0.06 : 0.15);
    EXPECT_LT(upper_median(distances_mm), by == 2 ? 0.1 : 0.3);
  }
}

TEST_F(RecordedFinger, MoreNeighboursLeaveLessNoiseInTheReference) {
  double before = std::numeric_limits<double>::infinity();
  for (const int neighbours : {2, 4, 8, 16}) {
    PipelineSettings settings;
    settings.reference_neighbours = neighbours;
    double gain = 0;
    for (const FrameResult& result : measured(settings)) {
      ASSERT_TRUE(result.reference);
      gain += result.reference->noise_gain / kPressed;
    }
    EXPECT_LT(gain, before) << neighbours;
    before = gain;
  }
}

/// One folder for what is kept, while it lives.
class EmptyCache {
 public:
  EmptyCache() { setenv(kVariable, folder_.path().c_str(), 1); }
  EmptyCache(const EmptyCache&) = delete;
  EmptyCache& operator=(const EmptyCache&) = delete;
  ~EmptyCache() { setenv(kVariable, before_.c_str(), 1); }
  [[nodiscard]] std::vector<std::filesystem::path> files() const {
    std::vector<std::filesystem::path> files;
    std::error_code none_yet;
    for (const auto& entry :
         std::filesystem::directory_iterator(folder_ / "alltact/faces", none_yet))
      files.push_back(entry.path());
    return files;
  }

 private:
  static constexpr const char* kVariable = "XDG_CACHE_HOME";
  TemporaryFolder folder_;
  std::string before_ = std::getenv(kVariable);
};

void expect_same(const std::vector<FrameResult>& a, const std::vector<FrameResult>& b) {
  ASSERT_EQ(a.size(), b.size());
  const auto are_same = [](const cv::Mat& one, const cv::Mat& other) {
    return one.size() == other.size() && one.type() == other.type() && one.isContinuous() &&
           other.isContinuous() &&
           std::memcmp(one.data, other.data, one.total() * one.elemSize()) == 0;
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(are_same(a[i].depth->depth_mm, b[i].depth->depth_mm)) << i;
    EXPECT_TRUE(are_same(a[i].depth->flags, b[i].depth->flags)) << i;
    EXPECT_TRUE(are_same(a[i].reference->relative_sd, b[i].reference->relative_sd)) << i;
    EXPECT_EQ(a[i].reference->error_factor, b[i].reference->error_factor) << i;
    EXPECT_EQ(a[i].reference->known_pose, b[i].reference->known_pose) << i;
    EXPECT_EQ(a[i].shape->twist().has_value(), b[i].shape->twist().has_value()) << i;
  }
}

TEST_F(RecordedFinger, IsTheSameBitByBitFromWhatWasKept) {
  namespace fs = std::filesystem;
  const EmptyCache cache;
  const std::vector<FrameResult> read = measured({});
  ASSERT_EQ(cache.files().size(), 1U);
  // The recording itself is not read: nothing of it is left but its size and its date.
  const fs::path video = folder_->path() / finger_->finger.reference->video;
  const std::string bytes = read_file(video).value();
  const auto date = fs::last_write_time(video);
  const auto fill = [&](const std::string& content) {
    std::ofstream(video, std::ios::binary | std::ios::in) << content;
    fs::last_write_time(video, date);
  };
  fill(std::string(bytes.size(), '\0'));
  expect_same(read, measured({}));
  // What is damaged is not taken.
  const std::string kept = read_file(cache.files().front()).value();
  std::string damaged = kept;
  damaged[damaged.size() / 2] ^= 1;
  std::ofstream(cache.files().front(), std::ios::binary) << damaged;
  EXPECT_FALSE(Pipeline::create(*finger_, {}, Job()).ok());
  // It is replaced when the recording is read again.
  fill(bytes);
  expect_same(read, measured({}));
  EXPECT_EQ(read_file(cache.files().front()).value(), kept);
  // Another resolution is another's.
  PipelineSettings half;
  half.resolution = Resolution::kHalf;
  static_cast<void>(measured(half));
  EXPECT_EQ(cache.files().size(), 2U);
}

TEST_F(RecordedFinger, IsReadAgainWhenItsRecordingHasChanged) {
  namespace fs = std::filesystem;
  const EmptyCache cache;
  const std::vector<FrameResult> read = measured({});
  const fs::path video = folder_->path() / finger_->finger.reference->video;
  fs::last_write_time(video, fs::last_write_time(video) + std::chrono::seconds(1));
  expect_same(read, measured({}));
  EXPECT_EQ(cache.files().size(), 2U);
}

TEST_F(RecordedFinger, IsMeasuredWhereNothingCanBeKept) {
  const EmptyCache cache;
  const std::string nowhere = "/proc/nothing/can/be/made/here";
  setenv("XDG_CACHE_HOME", nowhere.c_str(), 1);
  EXPECT_EQ(measured({}).size(), std::size_t{kPressed});
  EXPECT_FALSE(std::filesystem::exists(nowhere));
}

}  // namespace
}  // namespace alltact::test
