// The large words of the place Calibrate, with the evidence and without it; and pictures of them to
// look at.
#include "app/studio/header_bar.h"
#include "app/studio/session.h"
#include "calibration/checks/check_history.h"
#include "core/base/atomic_file.h"
#include "core/finger/finger_store.h"
#include "core/image/image_file.h"
#include "tests/studio/calibrate_rig.h"
#include "widgets/calibrating/verdict_page.h"
#include "widgets/shell/finger_card.h"
#include "widgets/theme.h"

#include <QPixmap>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// Presses of the pressing scene, 15 frames at each of its six positions, with the ball of 4 mm.
void calibrate(const CalibrateStudio& rig, const std::vector<int>& frames) {
  fs::remove_all(rig.finger() / kPressFolder);
  fs::create_directories(rig.finger() / kPressFolder);
  for (std::size_t i = 0; i < frames.size(); ++i)
    must(write_image(rig.finger() / kPressFolder / fmt::format("press_{:02}.png", i + 1),
                     remembered_frame(rig.folder() / "pressing.yaml", frames[i])));
  FingerCalibrationInput input;
  input.folder = rig.finger();
  input.presses.files = {rig.finger() / kPressFolder};
  input.press_set.ball_radius_mm = 4;
  must(input.press_set.save(rig.finger()));
  input.program_version = "0.1.0";
  const auto made = calibrate_finger(input, Job());
  must(made ? Status() : Status(made.error()));
}

const std::vector<int> kSixPositions{7, 22, 37, 52, 67, 82, 10};
/// Both in the base third.
const std::vector<int> kTwoPositions{3, 6, 9, 12, 18, 21, 24, 27};

void change(const fs::path& finger, const std::function<void(Finger&)>& how) {
  const auto changed = FingerStore::of(finger)->update([&](Finger& now) {
    how(now);
    return Status();
  });
  must(changed ? Status() : Status(changed.error()));
}

/// Written by earlier versions, too: a pass with any number of presses.
void add_check(const fs::path& finger, int presses) {
  CheckEntry check;
  check.time = utc_now();
  check.verdict = CheckVerdict::kPass;
  check.error_mm = 0.002;
  check.drifting_above_mm = 0.03;
  check.recalibrate_above_mm = 0.06;
  check.presses = presses;
  check.ball_radius_mm = 4;
  check.calibration_date = Finger::load(finger).value().provenance.at("calibration_date");
  check.program_version = "0.1.0";
  must(append_check(finger, check));
}

class Worth : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    good_ = new CalibrateStudio;
    calibrate(*good_, kSixPositions);
    poor_ = new CalibrateStudio;
    calibrate(*poor_, kTwoPositions);
  }
  static void TearDownTestSuite() {
    delete good_;
    delete poor_;
  }
  void begin(const CalibrateStudio& as) {
    fs::remove_all(rig_.finger());
    fs::copy(as.finger(), rig_.finger(), fs::copy_options::recursive);
  }
  void open(const char* step) {
    rig_.open();
    ASSERT_TRUE(wait_until(
        [&] {
          return rig_.run().worth() && rig_.run().result() && !rig_.collection().is_analysing();
        },
        60000));
    rig_.go_to_step(step);
  }
  /// All that the labels of the page say.
  [[nodiscard]] std::string page() {
    std::string all;
    for (const QLabel* label : rig_.place().findChildren<QLabel*>())
      if (label->isVisible()) all += label->text().toStdString() + "\n";
    return all;
  }
  [[nodiscard]] std::string step(const char* title) {
    for (const auto* button : rig_.place().findChildren<QToolButton*>())
      if (button->isVisible() && button->accessibleName().contains(QLatin1String(title)))
        return button->accessibleName().toStdString();
    return {};
  }
  void expect_no_ticks() {
    for (const char* title : {"Mapping", "Verdict", "Check"})
      EXPECT_THAT(step(title), Not(HasSubstr("done")));
    for (const char* title : {"Mapping", "Verdict"})
      EXPECT_THAT(step(title), HasSubstr("check again"));
  }
  static CalibrateStudio *good_, *poor_;
  CalibrateStudio rig_;
};
CalibrateStudio *Worth::good_ = nullptr, *Worth::poor_ = nullptr;

TEST_F(Worth, TheHeadlineHasFigureLargestCauseAndWhatItRestsOn) {
  begin(*good_);
  open("Verdict");
  const auto verdict = rig_.run().worth()->verdict.value();
  std::printf("[ figures  ] %s\n", verdict.sentence.english().c_str());
  ASSERT_EQ(verdict.grade, Grade::kGood);
  EXPECT_THAT(page(), HasSubstr(fmt::format("Good, ±{:.3f} mm", verdict.error_mm)));
  EXPECT_THAT(page(), HasSubstr("Mostly "));
  EXPECT_THAT(page(), HasSubstr("Based on: ball of 8.00 mm diameter, layer 1.50 mm"));
  EXPECT_THAT(step("Verdict"), HasSubstr("done"));
}

TEST_F(Worth, TwoPositionsAreUnprovenAndTheEmptyThirdsAreNamed) {
  begin(*poor_);
  open("Verdict");
  EXPECT_THAT(page(), HasSubstr("Unproven"));
  EXPECT_THAT(page(), HasSubstr("middle, tip"));
  for (const char* large : {"Good", "Nothing is due"}) EXPECT_THAT(page(), Not(HasSubstr(large)));
  EXPECT_THAT(step("Verdict"), HasSubstr("check again"));
  // And the one thing to do leads there.
  auto* lead = rig_.studio().find<QPushButton>("Go to the presses");
  ASSERT_NE(lead, nullptr);
  EXPECT_TRUE(is_primary(*lead));
  lead->click();
  EXPECT_TRUE(rig_.place().findChild<PressesPage*>()->isVisible());
}

TEST_F(Worth, AChangedLayerVoidsItUntilItIsCalibratedAgainWithOneClick) {
  begin(*good_);
  add_check(rig_.finger(), 3);
  open("Verdict");
  ASSERT_THAT(page(), HasSubstr("Good"));
  ASSERT_TRUE(wait_until([&] { return step("Check").find("done") != std::string::npos; }));
  change(rig_.finger(), [](Finger& finger) { finger.face.layer_mm = 1.6; });
  rig_.place().reload();
  ASSERT_TRUE(
      wait_until([&] { return rig_.run().worth() && rig_.run().worth()->must_repeat; }, 60000));
  open("Verdict");
  EXPECT_THAT(page(), HasSubstr("Changed since"));
  EXPECT_THAT(page(), HasSubstr("Layer was changed since the calibration"));
  EXPECT_THAT(page(), Not(HasSubstr("Good")));
  expect_no_ticks();
  auto* again = rig_.studio().find<QPushButton>("Calibrate again");
  ASSERT_TRUE(wait_until([&] { return again->isEnabled(); }, 60000));
  EXPECT_TRUE(is_primary(*again));
  again->click();
  ASSERT_TRUE(wait_until([&] { return rig_.run().is_running(); }));
  ASSERT_TRUE(wait_until(
      [&] { return !rig_.run().is_running() && rig_.run().state() == CalibrationState::kCurrent; },
      120000));
  open("Verdict");
  EXPECT_THAT(page(), Not(HasSubstr("Changed since")));
  EXPECT_THAT(page(), HasSubstr("layer 1.60 mm"));
  EXPECT_EQ(rig_.run().result()->calibration.balls.size(), kSixPositions.size());
}

TEST_F(Worth, ANewerReferenceVoidsIt) {
  begin(*good_);
  add_check(rig_.finger(), 3);
  change(rig_.finger(),
         [](Finger& finger) { finger.provenance["reference_date"] = "2099-01-01T00:00:00Z"; });
  open("Verdict");
  ASSERT_TRUE(wait_until([&] { return page().find("Changed since") != std::string::npos; }));
  EXPECT_THAT(page(), HasSubstr("The reference is newer than the calibration: calibrate again"));
  EXPECT_THAT(page(), Not(HasSubstr("Good")));
  expect_no_ticks();
  const std::string sheet =
      verdict_sheet(*rig_.run().result(), rig_.run().command_line(), rig_.run().worth()).html();
  EXPECT_THAT(sheet, HasSubstr("Changed since it was calibrated"));
  EXPECT_THAT(sheet, Not(HasSubstr("Good")));
  rig_.go_to_step("Check");
  EXPECT_THAT(page(), Not(HasSubstr("Pass\n")));
  rig_.go_to_step("Mapping");
  EXPECT_THAT(page(), HasSubstr("The reference is newer than the calibration"));
  auto* summary = rig_.studio().window().findChild<FingerSummary*>();
  ASSERT_TRUE(wait_until([&] { return summary->card().has_value(); }));
  EXPECT_THAT(headline_of(*summary->card()).text.toStdString(), HasSubstr("Changed since"));
}

TEST_F(Worth, ACheckWithOnePressIsTooLittle) {
  begin(*good_);
  add_check(rig_.finger(), 1);
  open("Check");
  ASSERT_TRUE(wait_until([&] { return page().find("Too few") != std::string::npos; }));
  EXPECT_THAT(page(), Not(HasSubstr("Pass\n")));
  EXPECT_THAT(page(), HasSubstr("with 1 press: error 0.002 mm"));
  EXPECT_THAT(page(), HasSubstr("A check needs 3 presses at different positions"));
  EXPECT_THAT(step("Check"), HasSubstr("check again"));
  EXPECT_FALSE(rig_.place().is_checked());
}

/// In the list, in the plot and on the sheet.
TEST_F(Worth, APressHasOneErrorByOneName) {
  begin(*good_);
  open("Presses");
  const BallFit* worst = nullptr;
  for (const BallFit& ball : rig_.run().result()->calibration.balls)
    if (worst == nullptr || press_error_mm(ball) > press_error_mm(*worst)) worst = &ball;
  ASSERT_TRUE(worst != nullptr && press_error_mm(*worst).has_value());
  const std::string error = fmt::format("{:.3f}", *press_error_mm(*worst));
  auto* list = rig_.studio().find<QListView>("Presses");
  EXPECT_THAT(list->model()->index(0, 0).data().toString().toStdString(),
              HasSubstr(fmt::format("{}\n", worst->press)));
  EXPECT_THAT(list->model()->index(0, 0).data().toString().toStdString(),
              HasSubstr("error " + error + " mm"));
  list->setCurrentIndex(list->model()->index(0, 0));
  // What the outline comes to is another thing and has another name.
  for (const QLabel* label : rig_.place().findChildren<QLabel*>())
    if (label->isVisible() && label->text().contains("error ")) {
      EXPECT_THAT(label->text().toStdString(), HasSubstr("error " + error));
    }
  rig_.go_to_step("Mapping");
  auto* plot = rig_.place().findChild<MappingPage*>()->findChild<PressErrorPlot*>();
  EXPECT_THAT(plot->accessibleDescription().toStdString(),
              HasSubstr(worst->press + " with " + error + " mm"));
  EXPECT_THAT(verdict_sheet(*rig_.run().result(), {}).html(), HasSubstr(error));
}

/// Pictures for people: below the build's folder, screens/. All looks in thorough runs.
TEST_F(Worth, LooksAsItShould) {
  struct Look {
    const char* name;
    QSize size;
    Theme theme;
    const char* language;
  };
  std::vector<Look> looks{{"light_small", {1024, 700}, Theme::kLight, "en"}};
  if (is_thorough())
    looks = {{"light_small", {1024, 700}, Theme::kLight, "en"},
             {"dark_large", {1440, 900}, Theme::kDark, "en"},
             {"german_small", {1024, 700}, Theme::kLight, "de"},
             {"german_dark_large", {1440, 900}, Theme::kDark, "de"},
             {"chinese_small", {1024, 700}, Theme::kLight, "zh_CN"}};
  const auto save = [&](const std::string& name) {
    for (const Look& look : looks) {
      ProgramAppearance appearance;
      appearance.apply({look.theme, QLatin1String(look.language)});
      rig_.studio().window().resize(look.size);
      QTest::qWait(400);
      fs::create_directories(ALLTACT_SCREENS);
      const std::string file = fmt::format("{}/worth_{}_{}.png", ALLTACT_SCREENS, name, look.name);
      ASSERT_TRUE(rig_.studio().window().grab().save(QString::fromStdString(file)));
      for (const QLabel* label : rig_.place().findChildren<QLabel*>())
        if (label->isVisible() && label->wordWrap()) {
          EXPECT_GE(label->height(), label->heightForWidth(label->width()))
              << file << " clips: " << label->text().toStdString();
        }
    }
    ProgramAppearance appearance;
    appearance.apply({Theme::kLight, QStringLiteral("en")});
  };
  const auto look_at = [&](const CalibrateStudio& as, const std::string& name,
                           const std::function<void()>& prepare,
                           const std::vector<const char*>& steps) {
    rig_.close();
    begin(as);
    prepare();
    open("5");
    for (const char* step : steps) {
      rig_.go_to_step(step);
      QTest::qWait(200);
      ASSERT_NO_FATAL_FAILURE(save(name + "_" + step));
    }
  };
  look_at(*good_, "good", [&] { add_check(rig_.finger(), 3); }, {"4", "5", "6"});
  look_at(*poor_, "unproven", [&] { add_check(rig_.finger(), 1); }, {"5", "6"});
  look_at(*good_, "changed",
          [&] {
            add_check(rig_.finger(), 3);
            change(rig_.finger(), [](Finger& finger) { finger.face.layer_mm = 1.6; });
          },
          {"4", "5", "6"});
  look_at(*good_, "contradiction",
          [&] {
            change(rig_.finger(), [](Finger& finger) {
              finger.mapping_record->basis->contradictions = {
                  {"contact_wider_than_ball", 3, 6, 2.0, 2.17, 2.44},
                  {"contact_deeper_than_layer", 1, 6, 1.5, 2.086, 0}};
            });
          },
          {"5"});
  rig_.close();
  // The first page, with a card of each kind.
  TemporaryFolder lab;
  const auto add = [&](const CalibrateStudio& as, const char* name) {
    fs::copy(as.finger(), lab / name, fs::copy_options::recursive);
    change(lab / name, [&](Finger& finger) { finger.name = name; });
    return lab / name;
  };
  add_check(add(*good_, "left-01"), 3);
  add(*poor_, "left-02");
  const auto broken = add(*good_, "left-03");
  fs::remove(broken / Finger::load(broken).value().reference->video);
  change(add(*good_, "left-04"), [](Finger& finger) { finger.face.layer_mm = 1.6; });
  SessionState state;
  std::vector<fs::path>& folders = state.recent_fingers;
  for (int i = 1; i <= 4; ++i) folders.push_back(lab / fmt::format("left-0{}", i));
  fs::create_directories(lab / "session");
  must(write_file_atomically(lab / "session/session.json", session_to_json(state)));
  StudioOptions options;
  options.session_folder = lab / "session";
  Studio studio(options);
  auto* cards = studio.window().findChild<FingerCards*>();
  ASSERT_TRUE(wait_until([&] { return cards->cards().size() == 4; }));
  for (const Look& look : looks) {
    ProgramAppearance appearance;
    appearance.apply({look.theme, QLatin1String(look.language)});
    studio.window().resize(look.size);
    QTest::qWait(400);
    ASSERT_TRUE(studio.window().grab().save(
        QString::fromStdString(fmt::format("{}/worth_start_{}.png", ALLTACT_SCREENS, look.name))));
  }
  ProgramAppearance appearance;
  appearance.apply({Theme::kLight, QStringLiteral("en")});
  FingerListDialog dialog(folders);
  dialog.show();
  ASSERT_TRUE(wait_until([&] { return dialog.cards().size() == 4; }));
  QTest::qWait(200);
  ASSERT_TRUE(dialog.grab().save(QStringLiteral(ALLTACT_SCREENS "/worth_list.png")));
  std::map<std::string, std::string> words;
  for (const FingerCard& card : dialog.cards())
    words[card.name] = headline_of(card).text.toStdString();
  EXPECT_THAT(words["left-01"], HasSubstr("Good, ±"));
  EXPECT_EQ(words["left-02"], "Unproven");
  EXPECT_EQ(words["left-03"], "Broken");
  EXPECT_EQ(words["left-04"], "Changed since it was calibrated");
}

}  // namespace
}  // namespace alltact::test
