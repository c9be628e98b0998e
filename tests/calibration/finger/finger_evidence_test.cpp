// A finger whose reference is gone, cut off or of another camera is never called good.
#include "calibration/finger/calibration_report.h"
#include "core/recording/video_file.h"
#include "core/sensing/reference/marker_table.h"
#include "tests/support/good_evidence.h"
#include "tests/support/program.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr int kFrames = 12;

class AFingersFiles : public testing::Test {
 protected:
  AFingersFiles() {
    finger_.name = "left-07";
    finger_.camera.width_px = 64;
    finger_.camera.height_px = 48;
    finger_.camera.fx_px = finger_.camera.fy_px = 60;
    finger_.camera.cx_px = 31.5;
    finger_.camera.cy_px = 23.5;
    finger_.face.width_mm = 24;
    finger_.face.layer_mm = 1.5;
    finger_.markers.per_row = 2;
    finger_.reference = ReferenceFiles{"reference.mkv", "reference.csv", ""};
    finger_.mapping.emplace();
    finger_.mapping->kind = MappingKind::kMoebius;
    finger_.mapping->a_mm = 3.4;
    finger_.mapping->x_max = 0.5;
    finger_.mapping_record = test::good_record(finger_);
    finger_.provenance["calibration_date"] = "2026-03-01T12:00:00Z";
    record();
  }
  void record() {
    Frame frame;
    frame.grey = cv::Mat(48, 64, CV_8UC1, cv::Scalar(90));
    auto writer = VideoWriter::create(video(), frame, VideoCodec::kFfv1, 30);
    ASSERT_TRUE(writer.ok());
    for (int i = 0; i < kFrames; ++i) {
      frame.grey = cv::Mat(48, 64, CV_8UC1, cv::Scalar(90 + i));
      ASSERT_TRUE(writer->add(frame).ok());
    }
    ASSERT_TRUE(writer->finish().ok());
    MarkerTable table;
    for (int i = 0; i < kFrames; ++i) table.frames.push_back(i);
    table.layouts = Eigen::MatrixXd::Constant(kFrames, 8, 20.0);
    table.seen.assign(kFrames, std::vector<char>(4, 1));
    table.typical.resize(4);
    for (Dot& dot : table.typical) dot.radius_px = 2, dot.contrast = 30;
    ASSERT_TRUE(table.save(markers()).ok());
  }
  [[nodiscard]] fs::path video() const { return folder_ / "reference.mkv"; }
  [[nodiscard]] fs::path markers() const { return folder_ / "reference.csv"; }
  [[nodiscard]] FingerSnapshot snapshot() const {
    return FingerSnapshot::of(folder_.path(), finger_).value();
  }
  [[nodiscard]] Verdict worth() const {
    return verdict(evidence_in(snapshot(), "2026-03-02T12:00:00Z"));
  }
  test::TemporaryFolder folder_;
  Finger finger_;
};

TEST_F(AFingersFiles, WholeOnesLetItBeGood) {
  EXPECT_EQ(reference_state(snapshot()), ReferenceState::kIntact);
  EXPECT_EQ(worth().grade, Grade::kGood) << worth().sentence.english();
}

TEST_F(AFingersFiles, ABrokenReferenceIsNamed) {
  const std::string whole = test::text_of(video()), table = test::text_of(markers());
  const auto expect_broken = [&](ReferenceState state) {
    EXPECT_EQ(reference_state(snapshot()), state);
    EXPECT_EQ(worth().grade, Grade::kUnfit);
    ASSERT_FALSE(worth().missing_names.empty());
    EXPECT_EQ(worth().missing_names.front(), "reference_whole");
  };
  for (const double part : {0.0, 0.3, 0.6, 0.95}) {
    SCOPED_TRACE(part);
    const auto length = static_cast<std::size_t>(part * static_cast<double>(whole.size()));
    test::write_text(video(), whole.substr(0, length));
    expect_broken(ReferenceState::kCut);
    EXPECT_EQ(test::text_of(video()).size(), length) << "looking must not repair";
  }
  test::write_text(video(), whole);
  test::write_text(markers(), table.substr(0, table.size() / 2));
  expect_broken(ReferenceState::kCut);
  test::write_text(markers(), table);
  EXPECT_EQ(worth().grade, Grade::kGood);
  fs::remove(markers());
  expect_broken(ReferenceState::kMissing);
  test::write_text(markers(), table);
  fs::remove(video());
  expect_broken(ReferenceState::kMissing);
  test::write_text(video(), whole);
  finger_.camera.width_px = 128;
  finger_.mapping_record = test::good_record(finger_);
  expect_broken(ReferenceState::kOtherImage);
  finger_.reference.reset();
  expect_broken(ReferenceState::kAbsent);
}

TEST_F(AFingersFiles, AgeCountsUntilACheckPasses) {
  const std::string later = "2027-06-01T12:00:00Z";
  EXPECT_EQ(verdict(evidence_in(snapshot(), later)).grade, Grade::kUnproven);
  EXPECT_EQ(verdict(evidence_in(snapshot(), later, "2027-05-30T12:00:00Z")).grade, Grade::kGood);
  EXPECT_EQ(verdict(evidence_in(snapshot(), "")).grade, Grade::kGood) << "ages are unknown";
}

TEST_F(AFingersFiles, ANewerReferenceIsNoLongerGood) {
  finger_.provenance["reference_date"] = "2026-03-01T12:00:01Z";
  EXPECT_EQ(worth().grade, Grade::kUnproven);
  EXPECT_EQ(worth().missing_names.front(), "reference_older");
}

}  // namespace
}  // namespace alltact
