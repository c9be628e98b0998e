// What the place Record offers once a recording is there.
#include "core/base/atomic_file.h"
#include "core/live/recording_feed.h"
#include "core/open/open_source.h"
#include "core/recording/video_file.h"
#include "tests/studio/studio_rig.h"
#include "widgets/panels/frame_strip.h"
#include "widgets/panels/image_panel.h"
#include "widgets/panels/recording_checks.h"
#include "widgets/theme.h"
#include "widgets/undo_step.h"
#include "widgets/widget_base.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QSpinBox>
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact::test {
namespace {

using testing::HasSubstr;

class RecordOffer : public testing::Test {
 protected:
  void open() {
    std::filesystem::copy(MadeFingers::get().described(), folder_ / "finger");
    StudioOptions options;
    options.source = {MadeFingers::get().bending()};
    options.finger = folder_ / "finger";
    studio_ = std::make_unique<Studio>(options);
    ASSERT_TRUE(studio_->wait_for_picture());
    ASSERT_TRUE(wait_until(
        [&] { return studio_->session().status().finger.state == FingerState::kReady; }));
    studio_->window().go_to("record");
  }
  void record(const std::filesystem::path& file) {
    auto* place = studio_->window().findChild<RecordPage*>();
    place->set_file(QString::fromStdString(file.string()));
    studio_->click("Start recording");
    const auto& recording = studio_->session().status().recording;
    ASSERT_TRUE(wait_until([&] { return recording.counts.recorded >= 45; }, 30000));
    studio_->click("Stop recording");
    ASSERT_TRUE(wait_until([&] { return recording.state == RecordingState::kDone; }, 20000));
  }
  bool has_words(const char* words) {
    for (const QLabel* label : studio_->window().findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(QLatin1String(words))) return true;
    return false;
  }
  bool wait_for_words(const char* words) {
    return wait_until([&] { return has_words(words); }, 60000);
  }
  void choose(const std::filesystem::path& video) {
    studio_->click("Install an existing video…");
    auto* dialog = studio_->window().findChild<QFileDialog*>();
    ASSERT_NE(dialog, nullptr);
    auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    ASSERT_NE(name, nullptr);
    name->setText(QString::fromStdString(video.string()));
    QTest::keyClick(name, Qt::Key_Return);
  }
  TemporaryFolder folder_;
  std::unique_ptr<Studio> studio_;
};

TEST_F(RecordOffer, SaysWhatItWouldBringAndLeavesTheFingerAlone) {
  open();
  record(folder_ / "bend.mkv");
  ASSERT_TRUE(wait_for_words("Expected error: half of the references off by less than 0."));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "finger/reference.mkv"));
  EXPECT_NE(studio_->find<QPushButton>("Install as this finger's reference"), nullptr);
  studio_->click("Keep for later");
  EXPECT_TRUE(wait_for_words("Saved: bend.mkv"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "bend.mkv"));
  // And later.
  choose(folder_ / "bend.mkv");
  for (const QCheckBox* box : studio_->window().findChildren<QCheckBox*>())
    EXPECT_FALSE(box->isVisible() && box->text().contains(QLatin1String("last reference")))
        << "there is none";
  studio_->click("Install as this finger's reference");
  ASSERT_TRUE(wait_until([&] { return studio_->session().status().finger.has_reference; }, 60000))
      << studio_->problems();
}

TEST_F(RecordOffer, AMeasurementIsNeitherJudgedNorInstalledAndInspectedNext) {
  open();
  studio_->find<QComboBox>("What the recording is for")->setCurrentIndex(1);
  const std::filesystem::path file =
      studio_->find<QLineEdit>("Recording file")->text().toStdString();
  EXPECT_EQ(file.parent_path(), folder_ / "finger");
  EXPECT_THAT(file.filename().string(), testing::StartsWith("measurement_20"));
  record(file);
  EXPECT_TRUE(wait_for_words("A measurement is neither judged nor installed."));
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_FALSE(has_words("The expected error"));
  EXPECT_FALSE(has_words("Expected error"));
  const auto is_offered = [&](const char* text) {
    for (const auto* button : studio_->window().findChildren<QPushButton*>())
      if (button->isVisible() && without_mnemonic(button->text()) == QLatin1String(text))
        return true;
    return false;
  };
  EXPECT_FALSE(is_offered("Install as this finger's reference"));
  EXPECT_TRUE(is_primary(*studio_->find<QPushButton>("Inspect this recording")));
  EXPECT_FALSE(is_primary(*studio_->find<QPushButton>("Start recording")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "finger/reference.mkv"));
  EXPECT_NE(studio_->find<QLineEdit>("Recording file")->text().toStdString(), file.string())
      << "the next one has a name of its own";
  studio_->click("Inspect this recording");
  EXPECT_EQ(studio_->window().findChild<InspectPage*>()->options().recording, file);
  // Back to a reference: it is shown how to bend, and it is judged again.
  studio_->window().go_to("record");
  studio_->find<QComboBox>("What the recording is for")->setCurrentIndex(0);
  EXPECT_THAT(studio_->find<QLineEdit>("Recording file")->text().toStdString(),
              HasSubstr("/bending_20"));
  EXPECT_FALSE(has_words("A measurement is neither"));
  record(folder_ / "bend.mkv");
  EXPECT_TRUE(wait_for_words("Expected error"));
  EXPECT_TRUE(is_primary(*studio_->find<QPushButton>("Install as this finger's reference")));
}

TEST_F(RecordOffer, AChosenFileIsRetainedForTheOtherPurpose) {
  open();
  auto* file = studio_->find<QLineEdit>("Recording file");
  file->setText("/tmp/mine.mkv");
  studio_->find<QComboBox>("What the recording is for")->setCurrentIndex(1);
  EXPECT_EQ(file->text(), "/tmp/mine.mkv");
}

TEST_F(RecordOffer, ARecordingStopsByItselfAfterItsTime) {
  open();
  auto* length = studio_->find<QSpinBox>("Length of the recording");
  EXPECT_EQ(length->text(), "until stopped");
  length->setValue(2);
  studio_->find<QLineEdit>("Recording file")
      ->setText(QString::fromStdString((folder_ / "timed.mkv").string()));
  studio_->click("Start recording");
  const auto& recording = studio_->session().status().recording;
  ASSERT_TRUE(wait_until([&] { return recording.state == RecordingState::kRunning; }));
  EXPECT_TRUE(wait_for_words(" / 0:02"));
  EXPECT_FALSE(length->isEnabled());
  ASSERT_TRUE(wait_until([&] { return recording.state == RecordingState::kDone; }, 20000));
  EXPECT_GE(recording.seconds, 1.9);
  EXPECT_LE(recording.seconds, 4.0);
}

TEST_F(RecordOffer, ASignIsRedOnlyWhileItRecords) {
  open();
  auto* sign = studio_->find<QLabel>("It does not record");
  ASSERT_NE(sign, nullptr);
  const auto is_red = [&] {
    const QImage image = sign->pixmap(Qt::ReturnByValue).toImage();
    const QColor middle = image.pixelColor(image.width() / 2, image.height() / 2);
    return middle.red() > 150 && middle.red() > 2 * middle.green();
  };
  EXPECT_FALSE(is_red());
  studio_->find<QLineEdit>("Recording file")
      ->setText(QString::fromStdString((folder_ / "a.mkv").string()));
  studio_->click("Start recording");
  EXPECT_TRUE(wait_until(is_red));
  EXPECT_EQ(sign->accessibleName(), "It records");
  studio_->click("Stop recording");
  EXPECT_TRUE(wait_until([&] { return !is_red(); }));
}

TEST_F(RecordOffer, ShowsWhatBecomesOfEachFrameBeforeItIsInstalled) {
  open();
  record(folder_ / "bend.mkv");
  ASSERT_TRUE(wait_for_words("Expected error"));
  const auto* strip = studio_->window().findChild<FrameStrip*>();
  ASSERT_NE(strip, nullptr);
  EXPECT_TRUE(strip->isVisible());
  int used = 0;
  for (int x = 0; x < strip->width(); ++x)
    used += static_cast<int>(strip->words_at(x).endsWith(QLatin1String("used")));
  EXPECT_GT(used, strip->width() / 4);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "finger/reference.mkv"));
}

TEST_F(RecordOffer, FramesAreLeftOutByDraggingAndTakenInAgain) {
  open();
  record(folder_ / "bend.mkv");
  ASSERT_TRUE(wait_for_words("Expected error"));
  auto* strip = studio_->window().findChild<FrameStrip*>();
  const std::vector<FrameUse> before = strip->uses();
  const auto excluded = [&] {
    return std::count(strip->uses().begin(), strip->uses().end(), FrameUse::kExcluded);
  };
  const auto errors = [&] {
    for (const QLabel* label : studio_->window().findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(QLatin1String("Expected error")))
        return label->text();
    return QString();
  };
  const QString first = errors();
  const int y = 16, from = strip->width() / 4, to = strip->width() / 2;
  QTest::mousePress(strip, Qt::LeftButton, {}, {from, y});
  QMouseEvent move(QEvent::MouseMove, QPointF(to, y), strip->mapToGlobal(QPointF(to, y)),
                   Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(strip, &move);
  QTest::mouseRelease(strip, Qt::LeftButton, {}, {to, y});
  ASSERT_TRUE(strip->selection());
  const auto count = strip->selection()->last - strip->selection()->first + 1;
  ASSERT_GT(count, 5);
  const QString frames = QStringLiteral("frames %1 to %2")
                             .arg(strip->selection()->first)
                             .arg(strip->selection()->last);
  studio_->click(QStringLiteral("Leave out ") + frames);
  EXPECT_EQ(excluded(), count) << "at once";
  ASSERT_TRUE(wait_until([&] { return !errors().isEmpty() && errors() != first; }, 60000))
      << "judged anew without them";
  EXPECT_EQ(excluded(), count);
  EXPECT_EQ(undo_words(studio_->window().undo_stack()), QStringLiteral("leave out ") + frames);
  studio_->window().undo_stack().undo();
  ASSERT_TRUE(wait_until([&] { return errors() == first; }, 60000)) << errors().toStdString();
  EXPECT_EQ(strip->uses(), before);
  studio_->window().undo_stack().redo();
  studio_->click(QStringLiteral("Use ") + frames);
  EXPECT_EQ(excluded(), 0);
  ASSERT_TRUE(wait_until([&] { return errors() == first; }, 60000)) << errors().toStdString();
}

TEST_F(RecordOffer, TheDarkestSpotIsMarkedInItsFrame) {
  open();
  auto* page = studio_->window().findChild<RecordPage*>();
  auto* chooser = page->findChild<FrameChooser*>();
  record(folder_ / "bend.mkv");
  ASSERT_TRUE(wait_for_words("Expected error"));
  // A contact that the program is not sure of, in the frames 10 to 14.
  ReferenceReport report;
  report.uses.assign(chooser->strip().uses().size(), FrameUse::kRetained);
  ReferenceStretch stretch;
  stretch.first = 10, stretch.last = 14, stretch.darkest = 12;
  stretch.along_mm = 40, stretch.across_mm = 2, stretch.darker = 0.1;
  report.stretches = {stretch};
  chooser->show_report(report);
  const auto* panel = page->findChild<ImagePanel*>();
  const auto picture = [&] { return panel->findChild<ImageView*>()->grab().toImage(); };
  const auto spots = [&] {  // pixels of the mark's colour
    const QImage image = picture();
    int found = 0;
    for (int v = 0; v < image.height(); ++v)
      for (int u = 0; u < image.width(); ++u) {
        const QColor c = image.pixelColor(u, v);
        found += c.red() > 230 && std::abs(c.green() - 184) < 20 && c.blue() < 40;
      }
    return found;
  };
  ASSERT_EQ(spots(), 0);
  chooser->show_stretch(0);
  ASSERT_TRUE(wait_until([&] { return spots() > 100; }, 30000));
  EXPECT_EQ(chooser->strip().selection()->first, 10);
  picture().save(QString::fromStdString(std::string(ALLTACT_SCREENS) + "/record_spot.png"));
  QTest::keyClick(&chooser->strip(), Qt::Key_Right);
  ASSERT_TRUE(wait_until([&] { return spots() > 50; }, 30000)) << "dashed: not the darkest";
  studio_->click("Show the live image");
  EXPECT_TRUE(wait_until([&] { return spots() == 0; }, 30000));
}

/// The bending finger there and back, with a dark spot on its face in some frames on the way back,
/// as of something that presses. Every pose is shown without it, too.
void write_with_spot(const std::filesystem::path& video, std::size_t first, std::size_t last) {
  const auto source = open_source({MadeFingers::get().bending()}).value();
  std::vector<FramePtr> frames;
  for (auto frame = source->next(); frame && *frame; frame = source->next())
    frames.push_back(*frame);
  const std::size_t count = frames.size();
  for (std::size_t i = 0; i < count; ++i) frames.push_back(frames[count - 1 - i]);
  auto writer = VideoWriter::create(video, *frames[0], VideoCodec::kMagicYuv, 30).value();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    Frame written = *frames[i];
    written.jpeg.reset();
    if (count + first <= i && i <= count + last) {
      written.grey = written.grey.clone();
      const cv::Point middle(written.grey.cols * 2 / 5, written.grey.rows / 2);
      cv::Mat spot(written.grey.size(), CV_8UC1, cv::Scalar(0));
      cv::circle(spot, middle, written.grey.cols / 40, cv::Scalar(255), -1);
      cv::Mat darker;
      written.grey.convertTo(darker, -1, 0.75);
      darker.copyTo(written.grey, spot);
    }
    ASSERT_TRUE(writer.add(written));
  }
  ASSERT_TRUE(writer.finish());
}

TEST_F(RecordOffer, AContactIsTickedUntickedAndTakenBack) {
  open();
  write_with_spot(folder_ / "spot.mkv", 10, 16);
  choose(folder_ / "spot.mkv");
  ASSERT_TRUE(wait_for_words("Expected error"));
  auto* list = studio_->find<QListWidget>("Frames that were left out, with the reason");
  ASSERT_NE(list, nullptr);
  const auto* strip = studio_->window().findChild<FrameStrip*>();
  const auto count = [&](FrameUse use) {
    return std::count(strip->uses().begin(), strip->uses().end(), use);
  };
  ASSERT_EQ(strip->stretches().size(), 1U) << list->count();
  const auto frames = count(FrameUse::kInContact);
  ASSERT_GT(frames, 3);
  EXPECT_EQ(list->item(0)->checkState(), Qt::Unchecked);
  list->item(0)->setCheckState(Qt::Checked);
  EXPECT_EQ(count(FrameUse::kInContact), 0) << "at once";
  EXPECT_FALSE(has_words("Expected error: "));
  ASSERT_TRUE(wait_for_words("Expected error: "));
  EXPECT_EQ(count(FrameUse::kInContact), 0);
  EXPECT_EQ(list->item(0)->checkState(), Qt::Checked);
  list->item(0)->setCheckState(Qt::Unchecked);
  EXPECT_EQ(count(FrameUse::kExcluded), frames);
  ASSERT_TRUE(wait_for_words("Expected error: "));
  EXPECT_EQ(count(FrameUse::kExcluded), frames);
  EXPECT_EQ(list->item(0)->checkState(), Qt::Unchecked) << "it stays in the list";
  studio_->window().undo_stack().undo();
  ASSERT_TRUE(wait_for_words("Expected error: "));
  studio_->window().undo_stack().undo();
  ASSERT_TRUE(wait_for_words("Expected error: "));
  EXPECT_EQ(count(FrameUse::kInContact), frames) << "as the program judges";
  EXPECT_EQ(list->item(0)->checkState(), Qt::Unchecked);
  // Its line shows its darkest frame with the spot.
  list->setCurrentRow(0);
  ASSERT_TRUE(strip->selection());
  EXPECT_EQ(strip->selection()->last - strip->selection()->first + 1, frames);
  QTest::qWait(1500);
  studio_->window().resize(1440, 900);
  QTest::qWait(300);
  studio_->window().grab().save(
      QString::fromStdString(std::string(ALLTACT_SCREENS) + "/record_contact.png"));
}

TEST_F(RecordOffer, AsksWhetherTheSkinIsAnotherOneThanInTheLastReference) {
  open();
  record(folder_ / "bend.mkv");
  studio_->click("Install as this finger's reference");
  ASSERT_TRUE(wait_until([&] { return studio_->session().status().finger.has_reference; }, 60000))
      << studio_->problems();
  choose(folder_ / "bend.mkv");
  ASSERT_TRUE(wait_for_words("Expected error: "));
  auto* skin = studio_->find<QCheckBox>("The skin was changed since the last reference");
  ASSERT_NE(skin, nullptr);
  EXPECT_TRUE(skin->isVisible());
  EXPECT_FALSE(skin->isChecked());
  for (const auto& [size, name] : {std::pair{QSize(1024, 700), "record_offer_1024"},
                                   std::pair{QSize(1440, 900), "record_offer_1440"}}) {
    studio_->window().resize(size);
    QTest::qWait(300);
    studio_->window().grab().save(
        QString::fromStdString(std::string(ALLTACT_SCREENS) + "/" + name + ".png"));
  }
  skin->click();  // is judged again
  EXPECT_TRUE(wait_until([&] { return !has_words("Expected error: "); }, 5000));
  EXPECT_TRUE(wait_for_words("Expected error: "));
}

TEST_F(RecordOffer, RecordingAgainTakesTheVideoAway) {
  open();
  record(folder_ / "first.mkv");
  studio_->click("Record again");
  const auto& recording = studio_->session().status().recording;
  ASSERT_TRUE(wait_until([&] { return recording.counts.recorded > 3; }, 20000))
      << studio_->problems();
  EXPECT_NE(recording.file, folder_ / "first.mkv");
  studio_->click("Stop recording");
  ASSERT_TRUE(wait_until([&] { return recording.state == RecordingState::kDone; }, 20000));
}

TEST_F(RecordOffer, TheListBeforeTheFirstRecordingStandsThere) {
  open();
  EXPECT_TRUE(wait_for_words("Focus at the base: edges at the base are "));
  EXPECT_TRUE(wait_for_words("Dots: 12 of 12 dots are found."));
  EXPECT_TRUE(wait_for_words("Brightness: the face has brightness "));
}

TEST_F(RecordOffer, StoppingTheInstallationLeavesTheFingerAsItWas) {
  open();
  const std::string before = read_file(folder_ / "finger/finger.yaml").value();
  choose(MadeFingers::get().bending());
  auto* install = studio_->find<QPushButton>("Install as this finger's reference");
  ASSERT_TRUE(wait_until([&] { return install->isVisible() && install->isEnabled(); }));
  studio_->click("Install as this finger's reference");
  studio_->click("Stop");
  // Who stopped it is told nothing but that it can be installed again.
  ASSERT_TRUE(wait_until([&] { return install->isVisible() && install->isEnabled(); }))
      << studio_->problems();
  EXPECT_EQ(studio_->problems().find("stopped"), std::string::npos) << studio_->problems();
  EXPECT_EQ(read_file(folder_ / "finger/finger.yaml").value(), before);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "finger/reference.mkv"));
}

/// Fed while it is written, with the frames of the bending finger.
std::shared_ptr<RecordingFeed> written(const std::filesystem::path& video, bool is_complete) {
  auto feed = std::make_shared<RecordingFeed>(video);
  const auto source = open_source({MadeFingers::get().bending()}).value();
  std::optional<VideoWriter> writer;
  for (auto frame = source->next(); frame && *frame; frame = source->next()) {
    if (!writer) {
      writer = VideoWriter::create(video, **frame, VideoCodec::kMagicYuv, 30).value();
      feed->begin(30, VideoCodec::kMagicYuv);
    }
    EXPECT_TRUE(writer->add(**frame));
    feed->add(*frame);
  }
  EXPECT_TRUE(writer && writer->finish());
  feed->end(is_complete);
  return feed;
}

TEST(FollowedTake, IsJudgedAsItsFileWouldBe) {
  const TemporaryFolder folder;
  const std::filesystem::path finger = MadeFingers::get().described(), video = folder / "bend.mkv";
  TakeJudge following, reading;
  ReferenceChoices choices;
  choices.leave_out = {{3, 8}};
  following.follow(finger, written(video, true));
  EXPECT_TRUE(following.is_working());
  EXPECT_EQ(following.judged(), nullptr) << "the choices are not yet made";
  ASSERT_TRUE(following.conclude(finger, video, choices));
  EXPECT_FALSE(following.conclude(finger, video, choices)) << "once";
  reading.judge(finger, video, choices);
  ASSERT_TRUE(wait_until([&] { return following.judged() && reading.judged(); }, 60000));
  ASSERT_TRUE(following.judged()->report.ok());
  EXPECT_EQ(following.judged()->report->uses, reading.judged()->report->uses);
  EXPECT_EQ(following.judged()->report->error_p95, reading.judged()->report->error_p95);
}

TEST(FollowedTake, IsNotWhatWasRecordedWhereItIsIncompleteOrOfAnotherFinger) {
  const TemporaryFolder folder;
  const std::filesystem::path finger = MadeFingers::get().described(), video = folder / "bend.mkv";
  TakeJudge judge;
  judge.follow(finger, written(video, false));
  EXPECT_FALSE(judge.conclude(finger, video, {}));
  const auto complete = written(video, true);
  judge.follow(finger, complete);
  EXPECT_FALSE(judge.conclude(finger / "other", video, {}));
  judge.follow(finger, complete);
  judge.forget();
  EXPECT_FALSE(judge.conclude(finger, video, {}));
}

}  // namespace
}  // namespace alltact::test
