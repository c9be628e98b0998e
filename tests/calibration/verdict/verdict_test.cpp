// Every large word is said only with its evidence: each piece is taken away alone.
#include "calibration/verdict/verdict.h"

#include "tests/support/good_evidence.h"

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::good_evidence;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// What is taken away from a good calibration, the best word that is left, and what is named.
struct Lack {
  const char* requirement;
  std::function<void(CalibrationEvidence&)> take_away;
  Grade left;
  const char* says;
};

const std::vector<Lack>& lacks() {
  static const std::vector<Lack> kLacks{
      {"reference_whole", [](auto& e) { e.reference = ReferenceState::kMissing; }, Grade::kUnfit,
       "a file of the reference is missing"},
      {"numbers_unchanged",
       [](auto& e) {
         e.changed = {en::say("width"), en::say("layer")};
       },
       Grade::kUnfit,
       "width and layer were changed since the calibration: alltact calibrate left-07 --again"},
      {"ball_possible",
       [](auto& e) {
         e.contradictions = {
             {ContradictionKind::kContactWiderThanBall, {"a", "b", "c"}, 2, 2.17, 2.44, 6}};
       },
       Grade::kUnfit,
       "3 of 6 presses have a dark part wider than the ball of 4.00 mm diameter (2.17 to 2.44 mm "
       "radius): check the ball's radius"},
      {"error_usable", [](auto& e) { e.scale_sd_mm = 0.2; }, Grade::kUnfit, "press again"},
      {"numbers_consistent",
       [](auto& e) {
         e.contradictions = {{ContradictionKind::kContactDeeperThanLayer, {"a"}, 1.5, 2.086, 0, 6}};
       },
       Grade::kUnproven, "1 of 6 presses is deeper than the layer of 1.50 mm (2.09 mm)"},
      {"basis_stored", [](auto& e) { e.has_basis = false; }, Grade::kUnproven,
       "alltact calibrate left-07 --again"},
      {"reference_older", [](auto& e) { e.reference_is_newer = true; }, Grade::kUnproven,
       "the reference is newer than the calibration"},
      {"complete", [](auto& e) { e.is_complete = false; }, Grade::kUnproven, "was stopped"},
      {"held_out", [](auto& e) { e.held_out_mm = 0; }, Grade::kUnproven, "no press was left out"},
      {"presses", [](auto& e) { e.presses = 3; }, Grade::kUnproven, "3 of 4 presses needed"},
      {"positions", [](auto& e) { e.positions = 2; }, Grade::kUnproven,
       "at 2 positions, 3 are needed"},
      {"thirds",
       [](auto& e) {
         e.thirds = {3, 3, 0};
       },
       Grade::kUnproven, "no press in the tip third; press there once"},
      {"depths", [](auto& e) { e.shallowest_mm = e.deepest_mm; }, Grade::kUnproven,
       "press shallower and deeper"},
      {"scale_known", [](auto& e) { e.scale_sd_mm = 0; }, Grade::kUnproven, "scale"},
      {"few_left_out", [](auto& e) { e.left_out = 7; }, Grade::kUnproven,
       "7 of 13 presses had to be left out"},
      {"fresh", [](auto& e) { e.days_unchecked = 400; }, Grade::kUnproven, "for 400 days"},
      {"error_good", [](auto& e) { e.scale_sd_mm = 0.08; }, Grade::kUsable, "at most 0.06 mm"},
  };
  return kLacks;
}

TEST(Verdict, GoodIsSaidWithAllEvidence) {
  const Verdict worth = verdict(good_evidence());
  EXPECT_EQ(worth.grade, Grade::kGood);
  EXPECT_TRUE(worth.missing.empty());
  EXPECT_THAT(worth.sentence.english(),
              AllOf(HasSubstr("good: expected error 0.0"),
                    HasSubstr("ball of 8.00 mm diameter, layer 1.50 mm")));
}

TEST(Verdict, GoodIsNotSaidWithoutAnyOne) {
  for (const Lack& lack : lacks()) {
    SCOPED_TRACE(lack.requirement);
    CalibrationEvidence evidence = good_evidence();
    lack.take_away(evidence);
    const Verdict worth = verdict(evidence);
    EXPECT_EQ(worth.grade, lack.left) << worth.sentence.english();
    EXPECT_THAT(worth.missing_names, Contains(lack.requirement));
    EXPECT_THAT(worth.sentence.english(), HasSubstr(lack.says));
    EXPECT_THAT(worth.sentence.english(), Not(HasSubstr("good:")));
  }
}

TEST(Verdict, EveryRequirementHasACaseAndNoCaseIsOfNone) {
  std::map<std::string_view, int> cases;
  for (const Lack& lack : lacks()) ++cases[lack.requirement];
  for (const Requirement& requirement : calibration_requirements())
    EXPECT_EQ(cases[requirement.name], 1) << requirement.name;
  EXPECT_EQ(cases.size(), calibration_requirements().size());
}

TEST(Verdict, TheWorstIsNamedFirst) {
  CalibrationEvidence evidence = good_evidence();
  evidence.halo_mm = 0.09;
  evidence.presses = 3;
  evidence.changed = {en::say("layer")};
  const Verdict worth = verdict(evidence);
  EXPECT_EQ(worth.grade, Grade::kUnfit);
  EXPECT_THAT(worth.missing_names,
              testing::ElementsAre("numbers_unchanged", "presses", "error_good"));
  Grade last = Grade::kUnfit;
  for (const Requirement& requirement : calibration_requirements()) {
    EXPECT_LE(requirement.without, last) << requirement.name;
    last = requirement.without;
  }
}

TEST(Verdict, TheErrorIsTheRootOfTheSquaresOfItsCauses) {
  CalibrationEvidence evidence = good_evidence();
  evidence.scale_sd_mm = 0.05;
  evidence.halo_mm = 0.01;
  evidence.position_leverage = 2.0 / 6 + 4;
  const double mean = std::sqrt(2 / M_PI), student = student_factor(5);
  const double shape = student * 0.01, scale = student * mean * 0.05;
  const double depth = (0.4 + 0.9) / 4, radius = 1.2 * 0.01 / 4 * depth, body = 0.05 * depth;
  const Verdict worth = verdict(evidence);
  EXPECT_NEAR(worth.error_mm,
              std::sqrt(shape * shape + scale * scale + 4 * shape * shape + 0.01 * 0.01 / 2 +
                        body * body + radius * radius),
              1e-12);
  ASSERT_EQ(worth.parts.size(), 6U);
  EXPECT_EQ(worth.parts.front().cause, ErrorCause::kScale);
  EXPECT_NEAR(worth.parts.front().error_mm, scale, 1e-12);
  EXPECT_THAT(worth.sentence.english(), HasSubstr("mostly scale: measure one press's depth"));
  // Noise and reference are in the error on presses left out already: the larger counts.
  evidence.pixel_sd_mm = 0.1;
  EXPECT_NEAR(
      verdict(evidence).error_mm * verdict(evidence).error_mm - worth.error_mm * worth.error_mm,
      mean * mean * 0.01 - shape * shape, 1e-12);
}

TEST(Verdict, AMeasuredDepthTellsWhatBallsHide) {
  CalibrationEvidence evidence = good_evidence();
  const double alone = verdict(evidence).error_mm;
  evidence.ball_radii_mm = {2, 4};  // balls agree with each other
  EXPECT_GE(verdict(evidence).error_mm, alone);
  evidence.ball_radii_mm = {0, 4};
  const Verdict worth = verdict(evidence);
  EXPECT_LT(worth.error_mm, alone);
  for (const ErrorPart& part : worth.parts) EXPECT_NE(part.cause, ErrorCause::kBody);
  EXPECT_THAT(worth.sentence.english(), HasSubstr("ball of 8.00 mm diameter"));
}

TEST(Verdict, BodiesOfOtherShapeCountAsFarAsSpreadLightMayBeUndetected) {
  const auto body_mm = [](double undetected) {
    CalibrationEvidence evidence = good_evidence();
    evidence.undetected_spread = undetected;
    for (const ErrorPart& part : verdict(evidence).parts)
      if (part.cause == ErrorCause::kBody) return part.error_mm;
    return 0.0;
  };
  const double untested = body_mm(1);
  EXPECT_NEAR(untested, 0.05 * (0.4 + 0.9) / 4, 1e-12);
  EXPECT_NEAR(body_mm(0.25), untested / 2, 1e-12);
  EXPECT_NEAR(body_mm(0), untested * std::sqrt(0.1), 1e-12) << "no test is certain";
}

TEST(Verdict, ScatteredLightLowersTheWordByWhatItIsOff) {
  CalibrationEvidence evidence = good_evidence();
  evidence.halo_mm = 0.09;
  const Verdict worth = verdict(evidence);
  EXPECT_EQ(worth.grade, Grade::kUsable);
  EXPECT_THAT(worth.sentence.english(), HasSubstr("mostly depth measured next to contacts"));
}

TEST(Verdict, StudentsFactorIsThatOfTables) {
  // 84.13 % quantiles of Student's distribution, as R gives them: qt(pnorm(1), n).
  const std::map<int, double> table{{1, 1.8373}, {2, 1.3213}, {3, 1.1969}, {4, 1.1416},
                                    {5, 1.1105}, {9, 1.0585}, {30, 1.0169}};
  for (const auto& [freedom, factor] : table)
    EXPECT_NEAR(student_factor(freedom), factor, freedom < 2 ? 0.03 : 0.01) << freedom;
}

TEST(Verdict, GradesChangeAtTheirLimits) {
  CalibrationEvidence evidence = good_evidence();
  const auto error_with = [&](double scale_mm) {
    evidence.scale_sd_mm = scale_mm;
    return verdict(evidence);
  };
  for (const auto& [limit_mm, below, above] :
       {std::tuple{kGoodErrorMm, Grade::kGood, Grade::kUsable},
        std::tuple{kUsableErrorMm, Grade::kUsable, Grade::kUnfit}}) {
    double low = 0.001, high = 1;
    for (int i = 0; i < 80; ++i) {
      const double middle = 0.5 * (low + high);
      (error_with(middle).error_mm <= limit_mm ? low : high) = middle;
    }
    EXPECT_EQ(error_with(low).grade, below);
    EXPECT_EQ(error_with(high).grade, above);
  }
}

TEST(Verdict, NoNumberIsNeverGood) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double CalibrationEvidence::*member :
       {&CalibrationEvidence::held_out_mm, &CalibrationEvidence::scale_sd_mm,
        &CalibrationEvidence::pixel_sd_mm, &CalibrationEvidence::position_leverage,
        &CalibrationEvidence::depth_per_radius, &CalibrationEvidence::deepest_mm}) {
    for (const double value : {nan, std::numeric_limits<double>::infinity()}) {
      CalibrationEvidence evidence = good_evidence();
      evidence.*member = value;
      EXPECT_NE(verdict(evidence).grade, Grade::kGood);
    }
  }
  EXPECT_EQ(verdict({}).grade, Grade::kUnfit) << "no evidence at all";
}

TEST(Verdict, AnOlderFileKeepsItsFiguresAndNotItsWord) {
  Finger finger;
  finger.mapping.emplace();
  finger.mapping_record = test::good_record(finger);
  EXPECT_TRUE(evidence_of(finger).has_basis);
  EXPECT_TRUE(evidence_of(finger).changed.empty());
  finger.mapping_record->basis.reset();
  EXPECT_EQ(verdict(evidence_of(finger)).grade, Grade::kUnproven);
}

TEST(Verdict, EveryChangedNumberIsNamed) {
  Finger finger;
  finger.face.width_mm = 24, finger.face.layer_mm = 1.5;
  finger.mapping.emplace();
  finger.mapping_record = test::good_record(finger);
  ASSERT_EQ(verdict(evidence_of(finger)).grade, Grade::kGood);
  const std::vector<std::pair<std::function<void(Finger&)>, const char*>> changes{
      {[](Finger& f) { f.face.width_mm = 22; }, "width was changed"},
      {[](Finger& f) { f.face.layer_mm = 15; }, "layer was changed"},
      {[](Finger& f) { f.face.plane_z_mm = 1; }, "distance of the face was changed"},
      {[](Finger& f) { f.camera.fx_px += 1e-9; }, "camera or lens was changed"}};
  for (const auto& [change, says] : changes) {
    Finger changed = finger;
    change(changed);
    const Verdict worth = verdict(evidence_of(changed));
    EXPECT_EQ(worth.grade, Grade::kUnfit);
    EXPECT_THAT(worth.sentence.english(), HasSubstr(says));
    EXPECT_THAT(worth.rests_on.english(), HasSubstr("layer 1.50 mm, face 24.00 mm wide"));
  }
}

TEST(CheckVerdicts, PassNeedsThreePositions) {
  const CheckEvidence fine{3, 3, 0.01, 0.02, 0.06, 0.001, 0.02, 0.06};
  EXPECT_EQ(check_verdict(fine), CheckVerdict::kPass);
  CheckEvidence one = fine;
  one.count = one.positions = 1;
  EXPECT_EQ(check_verdict(one), CheckVerdict::kTooFew);
  CheckEvidence repeats = fine;
  repeats.count = 9, repeats.positions = 2;
  EXPECT_EQ(check_verdict(repeats), CheckVerdict::kTooFew);
}

TEST(CheckVerdicts, AClearFailureIsSaidFromOnePressAndNoNumberIsOne) {
  CheckEvidence evidence{1, 1, 0.07, 0.02, 0.06, 0.001, 0.02, 0.06};
  EXPECT_EQ(check_verdict(evidence), CheckVerdict::kRecalibrate);
  evidence.error = 0.03;
  EXPECT_EQ(check_verdict(evidence), CheckVerdict::kTooFew);
  evidence.count = evidence.positions = 3;
  EXPECT_EQ(check_verdict(evidence), CheckVerdict::kDrifting);
  evidence.error = 0.01;
  evidence.light_change = 0.03;
  EXPECT_EQ(check_verdict(evidence), CheckVerdict::kDrifting);
  evidence.light_change = 0.07;
  EXPECT_EQ(check_verdict(evidence), CheckVerdict::kRecalibrate);
  evidence.light_change = 0;
  evidence.error = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(check_verdict(evidence), CheckVerdict::kRecalibrate);
}

TEST(Due, NothingIsDueOnlyWithAllEvidence) {
  const DueEvidence fine{
      true, true, ReferenceState::kIntact, Grade::kGood, false, CheckVerdict::kPass, 1.0};
  EXPECT_EQ(due_of(fine), FingerDue::kNothing);
  const std::vector<std::pair<std::function<void(DueEvidence&)>, FingerDue>> lacks{
      {[](auto& e) { e.reference = ReferenceState::kAbsent; }, FingerDue::kRecording},
      {[](auto& e) { e.reference = ReferenceState::kMissing; }, FingerDue::kRepair},
      {[](auto& e) { e.reference = ReferenceState::kCut; }, FingerDue::kRepair},
      {[](auto& e) { e.reference = ReferenceState::kOtherImage; }, FingerDue::kRepair},
      {[](auto& e) { e.has_mapping = false; }, FingerDue::kCalibration},
      {[](auto& e) { e.must_repeat = true; }, FingerDue::kRepeat},
      {[](auto& e) { e.grade = Grade::kUnfit; }, FingerDue::kCalibrateAgain},
      {[](auto& e) { e.grade = Grade::kUnproven; }, FingerDue::kEvidence},
      {[](auto& e) { e.grade.reset(); }, FingerDue::kEvidence},
      {[](auto& e) { e.check.reset(); }, FingerDue::kFirstCheck},
      {[](auto& e) { e.check = CheckVerdict::kRecalibrate; }, FingerDue::kCalibrateAgain},
      {[](auto& e) { e.check = CheckVerdict::kDrifting; }, FingerDue::kInspect},
      {[](auto& e) { e.check = CheckVerdict::kTooFew; }, FingerDue::kMorePresses},
      {[](auto& e) { e.check_days = 8; }, FingerDue::kCheck},
      {[](auto& e) { e.check_days.reset(); }, FingerDue::kCheck},
      {[](auto& e) { e.check_days = -3; }, FingerDue::kCheck}};
  for (const auto& [take_away, due] : lacks) {
    DueEvidence evidence = fine;
    take_away(evidence);
    EXPECT_EQ(due_of(evidence), due) << to_string(due);
  }
}

TEST(Words, AreOneEachAndAllDifferent) {
  std::set<std::string_view> words;
  for (int i = 1; i <= 4; ++i) words.insert(to_string(static_cast<Grade>(i)));
  EXPECT_EQ(words.size(), 4U);
  words.clear();
  for (int i = 1; i <= 11; ++i) words.insert(to_string(static_cast<FingerDue>(i)));
  EXPECT_EQ(words.size(), 11U);
}

}  // namespace
}  // namespace alltact
