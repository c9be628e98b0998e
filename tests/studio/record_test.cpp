// The place Record, as a person uses it.
#include "core/finger/finger_store.h"
#include "core/open/open_source.h"
#include "core/recording/video_file.h"
#include "core/simulation/plan.h"
#include "tests/studio/studio_rig.h"

#include <QLineEdit>
#include <QProgressBar>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class RecordTest : public testing::Test {
 protected:
  void open(const std::filesystem::path& source, const std::filesystem::path& finger) {
    StudioOptions options;
    options.source = {source};
    options.finger = finger;
    studio_ = std::make_unique<Studio>(options);
    ASSERT_TRUE(studio_->wait_for_picture());
    ASSERT_TRUE(wait_until(
        [&] { return studio_->session().status().finger.state == FingerState::kReady; }));
    QTest::keyClick(&studio_->window(), Qt::Key_3, Qt::ControlModifier);
  }
  void type_file(const std::filesystem::path& file) {
    auto* line = studio_->find<QLineEdit>("Recording file");
    line->selectAll();
    QTest::keyClicks(line, QString::fromStdString(file.string()));
  }
  [[nodiscard]] const RecordingStatus& recording() const {
    return studio_->session().status().recording;
  }
  bool wait_for(RecordingState state) {
    return wait_until([&] { return recording().state == state; }, 20000);
  }
  void record(std::uint64_t frames) {
    ASSERT_TRUE(wait_until([&] { return recording().counts.recorded >= frames; }, 30000))
        << studio_->problems();
  }
  TemporaryFolder folder_;
  std::unique_ptr<Studio> studio_;
};

TEST_F(RecordTest, RecordsEveryFrameExactly) {
  const auto scene = MadeFingers::get().bending();
  open(scene, MadeFingers::get().calibrated());
  type_file(folder_ / "bend.mkv");
  studio_->click("Start recording");
  record(40);
  studio_->click("Stop recording");
  ASSERT_TRUE(wait_for(RecordingState::kDone));
  ASSERT_FALSE(recording().problem) << recording().problem->sentence();
  EXPECT_EQ(recording().counts.dropped + recording().counts.missing, 0U);
  auto video = VideoFile::open(folder_ / "bend.mkv");
  ASSERT_TRUE(video) << video.error().sentence();
  EXPECT_EQ(video->frame_count(), recording().counts.recorded);
  const Plan plan = Plan::compile(Scene::load(scene).value(), 1).value();
  std::uint64_t expected = video->frame(0).value()->sequence;
  for (std::size_t i = 0; i < video->frame_count(); ++i, ++expected) {
    const FramePtr frame = video->frame(i).value();
    ASSERT_EQ(frame->sequence, expected);
    // The test's source shows the scene again and again.
    const cv::Mat truth = plan.render(static_cast<int>(expected) % plan.frame_count());
    ASSERT_EQ(cv::norm(frame->grey, truth, cv::NORM_INF), 0) << "frame " << expected;
  }
}

TEST_F(RecordTest, RecordsByKeysAlone) {
  open(MadeFingers::get().bending(), MadeFingers::get().calibrated());
  type_file(folder_ / "keys.mkv");
  QTest::keyClick(&studio_->window(), Qt::Key_R, Qt::ControlModifier);
  record(5);
  QTest::keyClick(&studio_->window(), Qt::Key_R, Qt::ControlModifier);
  ASSERT_TRUE(wait_for(RecordingState::kDone));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "keys.mkv"));
  EXPECT_NE(studio_->find<QGroupBox>("Recorded video"), nullptr);
}

TEST_F(RecordTest, SaysInPlaceThatAFolderCannotBeWrittenTo) {
  open(MadeFingers::get().bending(), MadeFingers::get().calibrated());
  std::ofstream(folder_ / "file") << "no folder";
  type_file(folder_ / "file/bend.mkv");
  studio_->click("Start recording");
  ASSERT_TRUE(wait_for(RecordingState::kDone));
  ASSERT_TRUE(wait_until([&] { return !studio_->problems().empty(); }));
  EXPECT_THAT(studio_->problems(), HasSubstr("file/bend.mkv"));
  EXPECT_THAT(studio_->problems(), HasSubstr("Try: "));
  type_file(folder_ / "bend.mkv");
  studio_->click("Start recording");
  record(3);
  EXPECT_TRUE(wait_until([&] { return studio_->problems().empty(); }));
}

TEST_F(RecordTest, CoversTheBendingOfASecondFingerAsOfTheFirst) {
  const auto covered = [&] {
    return studio_->find<CoverageView>("Coverage of bending")->accessibleDescription();
  };
  const auto delivered = [&] { return studio_->session().status().source.delivered; };
  open(MadeFingers::get().bending(), MadeFingers::get().described());
  ASSERT_TRUE(wait_until([&] { return delivered() > 300; }, 60000));
  const QString first = covered();
  EXPECT_TRUE(first.startsWith("Missing: ") || first.startsWith("Enough")) << first.toStdString();
  std::filesystem::copy(MadeFingers::get().described(), folder_ / "other",
                        std::filesystem::copy_options::recursive);
  studio_->window().open_finger(folder_ / "other");
  studio_->window().open_source({MadeFingers::get().bending()});
  EXPECT_EQ(covered().toStdString(), "No pose seen yet.");
  EXPECT_TRUE(wait_until([&] { return covered() == first; }, 60000)) << covered().toStdString();
}

TEST_F(RecordTest, NeverWritesOverARecording) {
  open(MadeFingers::get().bending(), MadeFingers::get().calibrated());
  std::ofstream(folder_ / "old.mkv") << "yesterday's";
  type_file(folder_ / "old.mkv");
  studio_->click("Start recording");
  ASSERT_TRUE(wait_for(RecordingState::kDone));
  EXPECT_TRUE(wait_until([&] { return !studio_->problems().empty(); }));
  EXPECT_EQ(bytes_of(folder_ / "old.mkv"), "yesterday's");
}

TEST_F(RecordTest, WarnsWhileTheContactFaceIsTouched) {
  open(MadeFingers::get().touched(), MadeFingers::get().calibrated());
  EXPECT_TRUE(wait_until([&] {
    return studio_->problems().find("Something touches the contact face") != std::string::npos;
  }));
  studio_->window().open_source({MadeFingers::get().bending()});
  EXPECT_TRUE(wait_until([&] { return studio_->problems().empty(); })) << studio_->problems();
}

TEST_F(RecordTest, WarnsWithoutAReferenceAsWell) {
  // The simulated finger is touched from frame 46 of 150 on, and then begins anew.
  open(std::filesystem::path(ALLTACT_SOURCE_DIR) / "resources/scenes/studio_finger.yaml", {});
  const auto says = [&](const char* words) {
    return studio_->problems().find(words) != std::string::npos;
  };
  EXPECT_TRUE(wait_until([&] { return says("detected from the preceding frames"); }));
  EXPECT_TRUE(wait_until([&] { return says("Something touches the contact face"); }));
  EXPECT_TRUE(wait_until([&] { return !says("Something touches the contact face"); }));
}

TEST_F(RecordTest, SaysWhenTouchingCannotBeSeen) {
  const TemporaryFolder folder;
  for (int i = 0; i < 90; ++i)
    ASSERT_TRUE(QImage(64, 48, QImage::Format_Grayscale8)
                    .save(QString::fromStdString(
                        (folder / ("p" + std::to_string(100 + i) + ".png")).string())));
  StudioOptions options;
  options.source = {folder.path()};
  studio_ = std::make_unique<Studio>(options);
  ASSERT_TRUE(studio_->wait_for_picture());
  QTest::keyClick(&studio_->window(), Qt::Key_3, Qt::ControlModifier);
  EXPECT_TRUE(wait_until([&] {
    return studio_->problems().find("is unknown whether") != std::string::npos;
  })) << studio_->problems();
}

TEST_F(RecordTest, SaysWhatIsNeededFirst) {
  studio_ = std::make_unique<Studio>();
  QTest::keyClick(&studio_->window(), Qt::Key_3, Qt::ControlModifier);
  EXPECT_FALSE(studio_->find<QPushButton>("Start recording")->isEnabled());
  bool is_said = false;
  for (const QLabel* label : studio_->window().findChildren<QLabel*>())
    is_said = is_said || (label->isVisible() && label->text().contains("Open a source first"));
  EXPECT_TRUE(is_said);
}

TEST_F(RecordTest, InstallsTheSameBytesAsTheCommandLine) {
  // A finger of its own that the window may change, and its twin for the command line.
  for (const char* name : {"window", "command"})
    std::filesystem::copy(MadeFingers::get().described(), folder_ / name);
  open(MadeFingers::get().bending(), folder_ / "window");
  type_file(folder_ / "bend.mkv");
  studio_->click("Start recording");
  record(45);
  studio_->click("Stop recording");
  ASSERT_TRUE(wait_for(RecordingState::kDone));
  QTest::qWait(300);
  studio_->click("Install as this finger's reference");
  ASSERT_TRUE(wait_until([&] { return studio_->session().status().finger.has_reference; }, 60000))
      << studio_->problems();
  const std::string command = std::string(ALLTACT_PROGRAM) + " reference '" +
                              (folder_ / "command").string() + "' '" +
                              (folder_ / "bend.mkv").string() + "' >/dev/null 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0);
  for (const char* file : {"reference.csv", "reference.mkv"})
    EXPECT_EQ(bytes_of(folder_ / "window" / file), bytes_of(folder_ / "command" / file)) << file;
  auto by_window = Finger::load(folder_ / "window").value();
  auto by_command = Finger::load(folder_ / "command").value();
  by_window.provenance.erase("reference_date");
  by_command.provenance.erase("reference_date");
  EXPECT_EQ(by_window.to_yaml().value(), by_command.to_yaml().value());
}

}  // namespace
}  // namespace alltact::test
