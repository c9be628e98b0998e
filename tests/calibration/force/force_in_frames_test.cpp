// A drawn finger learns forces and tells them of every frame; what goes wrong with its model spoils
// nothing else.
#include "calibration/force/collect_force.h"
#include "calibration/force/train_force.h"
#include "calibration/reference/reference_recording.h"
#include "core/base/atomic_file.h"
#include "core/finger/force_model.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/result_json.h"
#include "tests/support/marked_recording.h"
#include "tests/support/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using FrameJson = nlohmann::json;

/// Pushes are proportional to how the finger is bent and pushed aside.
Eigen::Vector2d drawn_force_N(const test::Bend& bend) { return {6 * bend.curl, 0.3 * bend.sway}; }

FramePtr drawn_frame(const cv::Mat& grey, int number) {
  auto frame = std::make_shared<Frame>();
  frame->grey = grey;
  frame->name = fmt::format("frame_{:05}", number);
  frame->sequence = static_cast<std::uint64_t>(number);
  frame->time_ns = 1000000000 + 33000000LL * number;
  return frame;
}

bool is_told(const FrameResult& result, const char* words) {
  return std::any_of(result.problems.begin(), result.problems.end(), [&](const Message& problem) {
    return problem.english().find(words) != std::string::npos;
  });
}

class ForceInFrames : public testing::Test {
 protected:
  static constexpr int kPoses = 60;

  void SetUp() override {
    std::mt19937 random(17);
    test::MemorySource source;
    for (int i = 0; i < kPoses; ++i)
      source.images.push_back(f_.with_noise(f_.clean(test::pose(i, kPoses)), random));
    Finger finger = test::described(f_);
    const auto report = install_reference(source, folder_.path(), finger, Job{});
    ASSERT_TRUE(report) << report.error().sentence();
    ASSERT_TRUE(finger.save(folder_.path()));
    pictures_ = source.images;
  }

  Pipeline pipeline() {
    return Pipeline::create(**FingerStore::of(folder_.path())->snapshot(), {}, Job{}).value();
  }

  /// The recording with forces as a gauge would tell them.
  CollectedForce collected() {
    Pipeline before = pipeline();
    std::vector<MarkerFrame> frames;
    std::string gauge = "frame,fx_n,fy_n,block\n";
    for (int i = 0; i < kPoses; ++i) {
      const FrameResult result =
          before(drawn_frame(pictures_[static_cast<std::size_t>(i)], i)).value();
      EXPECT_FALSE(result.force);
      if (!result.markers) continue;
      frames.push_back({result.frame->name, std::nullopt, *result.markers, std::nullopt});
      const Eigen::Vector2d force = drawn_force_N(test::pose(i, kPoses));
      gauge += fmt::format("{},{},{},{}\n", result.frame->name, force[0], force[1], i % 6);
    }
    auto table = collect_force(frames, ForceGauge::parse_csv(gauge, "gauge.csv").value());
    EXPECT_TRUE(table) << table.error().sentence();
    return *table;
  }

  static ForceTraining quick() {
    ForceTraining options;
    options.comparison_only = true;
    options.network.steps = 20, options.network.members = 1;
    return options;
  }

  FrameResult measured(Pipeline& pipeline, const test::Bend& bend) {
    std::mt19937 random(18);
    return pipeline(drawn_frame(f_.with_noise(f_.clean(bend), random), 99)).value();
  }

  [[nodiscard]] std::string yaml() const { return read_file(folder_ / "finger.yaml").value(); }

  test::MarkedFinger f_ = test::small_finger();
  test::TemporaryFolder folder_;
  std::vector<cv::Mat> pictures_;
};

TEST_F(ForceInFrames, IsLearntKeptMeasuredWrittenAndTakenBack) {
  const CollectedForce table = collected();
  EXPECT_GT(table.table.rows(), kPoses - 6);
  const auto trained = train_finger_force(folder_.path(), table.table, quick(), Job{});
  ASSERT_TRUE(trained) << trained.error().sentence();
  Pipeline with = pipeline();
  const test::Bend bend{0.15, -0.05, 2.5, 0.01};
  const FrameResult result = measured(with, bend);
  ASSERT_TRUE(result.force);
  EXPECT_TRUE(result.force->in_range);
  for (Eigen::Index axis = 0; axis < 2; ++axis)
    EXPECT_NEAR(result.force->force_N[axis], drawn_force_N(bend)[axis], 0.1) << axis;
  EXPECT_LT(result.times_ms.force, result.times_ms.total);
  const FrameJson line = FrameJson::parse(result_line(result, 0, ReferenceMethod::kLocal));
  EXPECT_NEAR(line.at("force").at("fx_n").get<double>(), result.force->force_N[0], 1e-4);
  EXPECT_EQ(line.at("force").at("sd_n").size(), 2U);
  EXPECT_EQ(line.at("force").at("in_range"), true);
  EXPECT_FALSE(line.at("force").contains("fz_n"));
  EXPECT_TRUE(line.at("times_ms").contains("force"));

  // The same table again: the same model, and nothing to take back but the first.
  const std::string first = (*FingerStore::of(folder_.path())->snapshot())->finger.force_model;
  const auto kept = stored_force_table(folder_.path());
  ASSERT_TRUE(kept) << kept.error().sentence();
  ASSERT_TRUE(train_finger_force(folder_.path(), *kept, quick(), Job{}));
  EXPECT_EQ((*FingerStore::of(folder_.path())->snapshot())->finger.force_model, first);
  ForceTraining other = quick();
  other.kind = ForceKind::kMean;
  ASSERT_TRUE(train_finger_force(folder_.path(), *kept, other, Job{}));
  const std::string second = (*FingerStore::of(folder_.path())->snapshot())->finger.force_model;
  EXPECT_NE(second, first);
  EXPECT_EQ((*revert_force(folder_.path()))->finger.force_model, first);
  EXPECT_EQ((*revert_force(folder_.path()))->finger.force_model, second);
}

TEST_F(ForceInFrames, AModelThatIsBrokenOrOfOtherMarkersIsNamedAndTheRestIsMeasured) {
  ASSERT_TRUE(train_finger_force(folder_.path(), collected().table, quick(), Job{}));
  const auto store = FingerStore::of(folder_.path());
  const std::string file = (*store->snapshot())->finger.force_model;
  const std::string good = read_file(folder_ / file).value();
  ASSERT_TRUE(write_file_atomically(folder_ / file, good.substr(0, good.size() / 2)));
  {
    const auto snapshot = store->snapshot();
    ASSERT_TRUE(snapshot) << "the finger itself is whole";
    EXPECT_FALSE((*snapshot)->force);
    ASSERT_TRUE((*snapshot)->force_problem);
    Pipeline broken = pipeline();
    const FrameResult result = measured(broken, test::pose(3, kPoses));
    EXPECT_TRUE(result.markers);
    EXPECT_FALSE(result.force);
    EXPECT_TRUE(is_told(result, "damaged or truncated"));
  }
  ASSERT_TRUE(write_file_atomically(folder_ / file, good));
  EXPECT_TRUE((*store->snapshot())->force) << "it is read again once it is whole";
  ASSERT_TRUE(store->update([](Finger& finger) {
    for (Eigen::Vector2d& rest : finger.contact->rest_markers) rest.x() += 20;
    return Status();
  }));
  Pipeline moved = pipeline();
  const FrameResult result = measured(moved, test::pose(3, kPoses));
  EXPECT_FALSE(result.force);
  EXPECT_TRUE(is_told(result, "belongs to another reference"));
}

TEST_F(ForceInFrames, ATableOfOtherMarkersIsRefusedAndNothingIsLost) {
  const ForceTable good = collected().table;
  const std::string before = yaml();
  const auto refused = [&](const ForceTable& table) {
    const auto trained = train_finger_force(folder_.path(), table, quick(), Job{});
    EXPECT_FALSE(trained);
    EXPECT_EQ(yaml(), before);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "force"));
    return trained ? std::string() : trained.error().sentence();
  };
  ForceTable fewer = good;
  fewer.marker_count = 10;
  EXPECT_NE(refused(fewer).find("10 markers, the finger has 12"), std::string::npos);
  ForceTable elsewhere = good;
  elsewhere.layouts.array() += 150;
  EXPECT_NE(refused(elsewhere).find("belong to another finger"), std::string::npos);
  ForceTable turned = good;  // numbered from the tip
  for (int m = 0; m < 12; ++m) {
    const int other = m < 6 ? 5 - m : 17 - m;
    turned.layouts.middleCols(2 * m, 2) = good.layouts.middleCols(2 * other, 2);
    turned.seen.col(m) = good.seen.col(other);
  }
  EXPECT_NE(refused(turned).find("belong to another finger"), std::string::npos);
  const auto none = revert_force(folder_.path());
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().sentence().find("no force model to revert"), std::string::npos);
  EXPECT_FALSE(stored_force_table(folder_.path()));
}

}  // namespace
}  // namespace alltact
