// Large words of the window, and when they are not said.
#include "widgets/verdict_text.h"

#include "tests/support/good_evidence.h"
#include "widgets/language.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string headline(const CalibrationEvidence& evidence, bool must_repeat = false) {
  const Verdict worth = window_verdict(evidence);
  return headline_of(worth.grade, expected_error_mm(worth).value_or(0.0), must_repeat,
                     evidence.reference)
      .text.toStdString();
}

TEST(WorthWords, GoodComesWithItsFigure) {
  const Verdict worth = window_verdict(test::good_evidence());
  ASSERT_EQ(worth.grade, Grade::kGood);
  const QString error = local_mm(worth.error_mm, 3);
  EXPECT_EQ(headline(test::good_evidence()), "Good, ±" + error.toStdString() + " mm");
  EXPECT_TRUE(findings_of(worth, {}).empty());
}

TEST(WorthWords, NothingVouchesForAFigureWithoutTheEvidence) {
  CalibrationEvidence two = test::good_evidence();
  two.presses = 2;
  EXPECT_EQ(headline(two), "Unproven");
  CalibrationEvidence two_positions = test::good_evidence();
  two_positions.presses = 14;
  two_positions.positions = 2;
  two_positions.thirds = {2, 0, 0};
  EXPECT_EQ(headline(two_positions), "Unproven");
  const Verdict worth = window_verdict(two_positions);
  EXPECT_FALSE(expected_error_mm(worth).has_value());
  std::string all;
  for (const Message& finding : findings_of(worth, {})) all += finding.english() + "\n";
  EXPECT_THAT(all, HasSubstr("middle, tip"));
  EXPECT_THAT(all, HasSubstr("press"));
}

TEST(WorthWords, ABrokenOrChangedFingerHasNoGrade) {
  for (const ReferenceState state :
       {ReferenceState::kMissing, ReferenceState::kCut, ReferenceState::kOtherImage}) {
    CalibrationEvidence evidence = test::good_evidence();
    evidence.reference = state;
    EXPECT_EQ(headline(evidence), "Broken");
    EXPECT_EQ(findings_of(window_verdict(evidence), {}).front(), sentence(state));
  }
  CalibrationEvidence changed = test::good_evidence();
  changed.changed = {en::say("layer")};
  EXPECT_EQ(headline(changed, true), "Changed since it was calibrated");
  CalibrationEvidence newer = test::good_evidence();
  newer.reference_is_newer = true;
  EXPECT_EQ(headline(newer, true), "Changed since it was calibrated");
  EXPECT_NE(headline_of(Grade::kGood, 0.02, true, ReferenceState::kIntact).meaning, Meaning::kGood);
}

TEST(WorthWords, AWindowNamesItsButtonAndNoCommand) {
  CalibrationEvidence newer = test::good_evidence();
  newer.reference_is_newer = true;
  const std::string words = findings_of(window_verdict(newer), {}).front().english();
  EXPECT_THAT(words, HasSubstr("calibrate again"));
  EXPECT_THAT(words, Not(HasSubstr("--again")));
  EXPECT_THAT(verdict(newer).missing.front().english(), HasSubstr("--again"));
}

TEST(WorthWords, WhatContradictsStandsBeforeWhatIsMissing) {
  CalibrationEvidence evidence = test::good_evidence();
  evidence.is_complete = false;
  evidence.presses = 2;
  evidence.reference_is_newer = true;
  const Contradiction deeper{
      ContradictionKind::kContactDeeperThanLayer, {"press_1"}, 1.5, 2.086, 0, 6};
  const Contradiction beyond{ContradictionKind::kDepthBeyondMapping, {"press_2"}, 1.1, 1.3, 0, 6};
  evidence.contradictions = {deeper, beyond};
  const Verdict worth = window_verdict(evidence);
  const auto findings = findings_of(worth, evidence.contradictions);
  const auto at = [&](const Message& message) {
    return std::find(findings.begin(), findings.end(), message) - findings.begin();
  };
  ASSERT_GE(findings.size(), 5U);
  std::vector<Message> lacking;
  for (std::size_t i = 0; i < worth.missing.size(); ++i)
    if (worth.missing_names[i] == "complete" || worth.missing_names[i] == "presses")
      lacking.push_back(worth.missing[i]);
  ASSERT_EQ(lacking.size(), 2U);
  for (const Message& contradiction : {sentence(deeper), sentence(beyond)})
    for (const Message& lacks : lacking) EXPECT_LT(at(contradiction), at(lacks));
  EXPECT_LT(at(lacking.back()), static_cast<long>(findings.size())) << "all are there";
}

TEST(WorthWords, APressHasAnErrorOnlyWhereAMappingWasMadeWithoutIt) {
  BallFit ball;
  ball.residual_mm = 0.001;
  EXPECT_FALSE(press_error_mm(ball).has_value()) << "what it was fitted to shows nothing";
  ball.held_out_mm = 0.002;
  EXPECT_EQ(press_error_mm(ball), 0.002);
}

TEST(WorthWords, TooFewPressesAreNoPass) {
  EXPECT_EQ(check_text(CheckVerdict::kTooFew), "Too few to judge");
  EXPECT_EQ(meaning_of(CheckVerdict::kTooFew), Meaning::kDoubtful);
  EXPECT_EQ(check_text(CheckVerdict::kPass), "Pass");
}

TEST(SettingsWords, AreThePhrasesOfWhatDiffers) {
  const PipelineSettings usual;
  EXPECT_EQ(difference_words(usual, usual), "");
  PipelineSettings two;
  two.smoothing_px = 0;
  two.reference = ReferenceMethod::kNearest;
  EXPECT_EQ(difference_words(two, usual), "compared with the nearest image, no smoothing");
  EXPECT_EQ(difference_words(usual, two), "compared with several images, smoothing of 1 px");
}

}  // namespace
}  // namespace alltact
