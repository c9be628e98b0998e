// What the page that one begins with says of a finger, from its folder.
#include "widgets/shell/finger_card.h"

#include "calibration/checks/check_history.h"
#include "core/base/atomic_file.h"
#include "core/finger/finger_store.h"
#include "core/image/image_file.h"
#include "tests/support/good_evidence.h"
#include "tests/support/program.h"

#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;
using testing::Not;

class AFingersCard : public testing::Test {
 protected:
  AFingersCard() {
    finger_.name = "left-07";
    finger_.camera.width_px = 640;
    finger_.camera.height_px = 480;
    finger_.camera.fx_px = finger_.camera.fy_px = 500;
    finger_.camera.cx_px = 319.5;
    finger_.camera.cy_px = 239.5;
    finger_.face.kind = FaceKind::kFlat;
    finger_.face.layer_mm = 1.5;
    finger_.face.plane_z_mm = 30;
    save();
  }
  void save() { ASSERT_TRUE(finger_.save(folder_.path())); }
  void calibrate() {
    finger_.mapping.emplace();
    finger_.mapping->kind = MappingKind::kMoebius;
    finger_.mapping->a_mm = 3.4;
    finger_.mapping->b = 1.0;
    finger_.mapping->x_max = 0.5;
    finger_.mapping_record = test::good_record(finger_);
    finger_.reference = ReferenceFiles{"", "", "reference.png"};
    ASSERT_TRUE(write_image(folder_ / "reference.png", cv::Mat(480, 640, CV_8UC1, cv::Scalar(99))));
    finger_.provenance["calibration_date"] = "2026-03-01T12:00:00Z";
    save();
  }
  void check(CheckVerdict verdict, const std::string& of = "2026-03-01T12:00:00Z") {
    CheckEntry entry;
    entry.time = "2026-03-05T12:00:00Z";
    entry.verdict = verdict;
    entry.error_mm = 0.01;
    entry.drifting_above_mm = 0.05;
    entry.recalibrate_above_mm = 0.1;
    entry.presses = 3;
    entry.ball_radius_mm = 4;
    entry.calibration_date = of;
    entry.program_version = "0.1.0";
    ASSERT_TRUE(append_check(folder_.path(), entry));
  }
  [[nodiscard]] FingerCard card(const char* now = "2026-03-06T12:00:00Z") const {
    const auto card = read_finger_card(folder_.path(), now);
    EXPECT_TRUE(card.has_value());
    return card.value_or(FingerCard());
  }
  test::TemporaryFolder folder_;
  Finger finger_;
};

TEST_F(AFingersCard, SaysWhatIsDueFromTheFirstDayOn) {
  EXPECT_EQ(card().name, "left-07");
  EXPECT_EQ(card().due, FingerDue::kCalibration);
  EXPECT_FALSE(card().grade.has_value());
  calibrate();
  EXPECT_EQ(card().due, FingerDue::kFirstCheck);
  EXPECT_EQ(card().grade, Grade::kGood);
  EXPECT_EQ(card().calibrated_on, "2026-03-01T12:00:00Z");
  check(CheckVerdict::kPass);
  EXPECT_EQ(card().due, FingerDue::kNothing);
  EXPECT_EQ(card().checked_on, "2026-03-05T12:00:00Z");
  EXPECT_EQ(card("2026-03-12T11:00:00Z").due, FingerDue::kNothing);
  EXPECT_EQ(card("2026-03-12T13:00:00Z").due, FingerDue::kCheck) << "a week and an hour later";
  check(CheckVerdict::kDrifting);
  EXPECT_EQ(card().due, FingerDue::kInspect);
  check(CheckVerdict::kRecalibrate);
  EXPECT_EQ(card().due, FingerDue::kCalibrateAgain);
}

TEST_F(AFingersCard, SaysNothingGoodOfABrokenOrChangedFinger) {
  calibrate();
  check(CheckVerdict::kPass);
  ASSERT_EQ(card().due, FingerDue::kNothing);
  std::filesystem::rename(folder_ / "reference.png", folder_ / "elsewhere.png");
  EXPECT_EQ(card().grade, Grade::kUnfit);
  EXPECT_EQ(card().due, FingerDue::kRepair);
  ASSERT_TRUE(write_image(folder_ / "reference.png", cv::Mat(48, 64, CV_8UC1, cv::Scalar(99))));
  EXPECT_EQ(card().grade, Grade::kUnfit) << "of another camera";
  std::filesystem::rename(folder_ / "elsewhere.png", folder_ / "reference.png");
  EXPECT_EQ(card().grade, Grade::kGood);
  finger_.face.layer_mm = 15;
  save();
  EXPECT_EQ(card().grade, Grade::kUnfit);
  EXPECT_EQ(card().due, FingerDue::kRepeat);
  finger_.face.layer_mm = 1.5;
  finger_.provenance["reference_date"] = "2026-03-02T12:00:00Z";
  save();
  EXPECT_EQ(card().grade, Grade::kUnproven) << "the reference is newer";
  EXPECT_EQ(card().due, FingerDue::kRepeat);
}

/// The words of the card, the list and the line below the picture.
std::string words_of(const FingerCard& card) {
  return (headline_of(card).text + "; " + due_text(card) + "; " + findings_text(card))
      .toStdString();
}

TEST_F(AFingersCard, NamesWhatIsBrokenAndWhatToDo) {
  calibrate();
  check(CheckVerdict::kPass);
  EXPECT_THAT(words_of(card()), HasSubstr("Good, ±"));
  EXPECT_THAT(words_of(card()), HasSubstr("Nothing is due"));
  EXPECT_EQ(headline_of(card()).meaning, Meaning::kGood);
  const std::filesystem::path reference = folder_ / "reference.png";
  const std::string whole = read_file(reference).value();
  const auto expect_broken = [&](const char* why, const char* due) {
    const FingerCard now = card();
    EXPECT_THAT(words_of(now), HasSubstr("Broken; "));
    EXPECT_THAT(words_of(now), HasSubstr(due));
    EXPECT_THAT(words_of(now), HasSubstr(why));
    for (const char* large : {"Good", "Nothing is due", "±"})
      EXPECT_THAT(words_of(now), Not(HasSubstr(large)));
    EXPECT_EQ(headline_of(now).meaning, Meaning::kBad);
    EXPECT_THAT(summary_of(now, "2026-03-06T12:00:00Z").toStdString(), Not(HasSubstr("Good")));
  };
  std::filesystem::remove(reference);
  expect_broken("A file of the reference is missing", "Due: restore its reference");
  ASSERT_TRUE(write_file_atomically(reference, whole.substr(0, whole.size() / 3)));
  expect_broken("The reference is cut off or unreadable", "Due: record its reference again");
  ASSERT_TRUE(write_image(reference, cv::Mat(48, 64, CV_8UC1, cv::Scalar(99))));
  expect_broken("another image size than the camera", "Due: record its reference again");
  ASSERT_TRUE(write_file_atomically(reference, whole));
  EXPECT_THAT(words_of(card()), HasSubstr("Nothing is due"));
}

TEST_F(AFingersCard, SaysWhatChangedSinceItWasCalibrated) {
  calibrate();
  check(CheckVerdict::kPass);
  const auto expect_changed = [&](const char* what) {
    EXPECT_THAT(words_of(card()), HasSubstr("Changed since it was calibrated; "));
    EXPECT_THAT(words_of(card()), HasSubstr("Due: calibrate it again"));
    EXPECT_THAT(words_of(card()), HasSubstr(what));
    EXPECT_THAT(words_of(card()), Not(HasSubstr("Good")));
  };
  finger_.provenance["reference_date"] = "2026-03-02T12:00:00Z";
  save();
  expect_changed("The reference is newer than the calibration");
  finger_.provenance.erase("reference_date");
  finger_.face.layer_mm = 16;
  save();
  expect_changed("Layer was changed");
  finger_.face.layer_mm = 1.5;
  finger_.face.plane_z_mm = 31;
  save();
  expect_changed("Distance of the face was changed");
  finger_.face.plane_z_mm = 30;
  finger_.camera.fx_px = 510;
  save();
  expect_changed("Camera or lens was changed");
}

TEST_F(AFingersCard, NothingIsDueOnlyWithTheEvidence) {
  calibrate();
  check(CheckVerdict::kPass);
  ASSERT_THAT(words_of(card()), HasSubstr("Nothing is due"));
  const MappingRecord good = *finger_.mapping_record;
  const auto expect_due = [&](const char* due) {
    save();
    EXPECT_THAT(words_of(card()), Not(HasSubstr("Nothing is due"))) << due;
    EXPECT_THAT(words_of(card()), Not(HasSubstr("Good"))) << due;
    EXPECT_THAT(words_of(card()), HasSubstr(due));
    finger_.mapping_record = good;
  };
  finger_.mapping_record->presses = {"a", "b"};
  expect_due("Due: more presses");
  finger_.mapping_record->basis->positions = 2;
  finger_.mapping_record->basis->thirds = {1, 1, 0};
  expect_due("Due: more presses");
  finger_.mapping_record->basis.reset();
  expect_due("Due: calibrate it again");
  finger_.mapping_record.reset();
  expect_due("Due: calibrate it again");
  save();
  ASSERT_THAT(words_of(card()), HasSubstr("Nothing is due"));
  EXPECT_THAT(words_of(card("2027-09-06T12:00:00Z")), HasSubstr("Due: a check")) << "a year later";
}

TEST_F(AFingersCard, ACheckWithOnePressIsNoPass) {
  calibrate();
  CheckEntry entry;
  entry.time = "2026-03-05T12:00:00Z";
  entry.verdict = CheckVerdict::kPass;  // as earlier versions wrote it
  entry.error_mm = 0.002;
  entry.drifting_above_mm = 0.05;
  entry.recalibrate_above_mm = 0.1;
  entry.presses = 1;
  entry.ball_radius_mm = 4;
  entry.calibration_date = "2026-03-01T12:00:00Z";
  entry.program_version = "0.1.0";
  ASSERT_TRUE(append_check(folder_.path(), entry));
  EXPECT_THAT(words_of(card()), HasSubstr("Due: a check"));
}

TEST_F(AFingersCard, ACheckOfAnotherCalibrationDoesNotCount) {
  calibrate();
  check(CheckVerdict::kPass, "2026-02-01T12:00:00Z");
  EXPECT_EQ(card().due, FingerDue::kFirstCheck);
  EXPECT_TRUE(card().checked_on.empty());
}

TEST_F(AFingersCard, ShowsAPress) {
  EXPECT_TRUE(card().image.isNull());
  std::filesystem::create_directories(folder_ / "presses");
  ASSERT_TRUE(
      write_image(folder_ / "presses" / "a.png", cv::Mat(480, 640, CV_8UC1, cv::Scalar(77))));
  ASSERT_FALSE(card().image.isNull());
  EXPECT_EQ(qGray(card().image.pixel(5, 5)), 77);
}

TEST_F(AFingersCard, StandsAmongOthersAndOpensItsFinger) {
  calibrate();
  FingerCards cards;
  QString chosen;
  QObject::connect(&cards, &FingerCards::finger_chosen,
                   [&](const QString& folder) { chosen = folder; });
  cards.set_fingers({"/nowhere/at/all", folder_.path()});
  ASSERT_TRUE(QTest::qWaitFor([&] { return cards.cards().size() == 1; }));
  cards.show();
  auto* button = cards.findChild<QToolButton*>();
  ASSERT_NE(button, nullptr);
  EXPECT_TRUE(button->text().contains("left-07"));
  EXPECT_TRUE(button->text().contains("Good"));
  EXPECT_TRUE(button->text().contains("Due: a check"));
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(chosen.toStdString(), folder_.path().string());
  EXPECT_FALSE(button->text().contains(QString::fromStdString(folder_.path().filename().string())));
  // Of two fingers of one name the folders differ.
  const test::TemporaryFolder shelf;
  std::filesystem::copy(folder_.path(), shelf / "copy", std::filesystem::copy_options::recursive);
  cards.resize(900, 400);
  cards.set_fingers({folder_.path(), shelf / "copy"});
  std::string texts;
  const auto are_both_shown = [&] {
    int shown = 0;
    texts.clear();
    for (const QToolButton* each : cards.findChildren<QToolButton*>()) {
      if (each->isHidden()) continue;
      texts += each->text().toStdString() + "; ";
      ++shown;
    }
    return shown == 2;
  };
  ASSERT_TRUE(QTest::qWaitFor(are_both_shown));
  EXPECT_THAT(texts, HasSubstr("/copy"));
  EXPECT_THAT(texts, HasSubstr("/" + folder_.path().filename().string()));
  // It is not there any more.
  std::filesystem::remove(folder_ / "finger.yaml");
  cards.set_fingers({folder_.path()});
  ASSERT_TRUE(QTest::qWaitFor([&] { return cards.cards().empty(); }));
  EXPECT_FALSE(cards.isVisible());
}

}  // namespace
}  // namespace alltact
