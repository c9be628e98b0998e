// Numbers that the presses contradict, against presses whose geometry is known.
#include "calibration/finger/calibrate_presses.h"
#include "tests/support/made_press.h"

#include <cmath>
#include <map>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace made;
using testing::HasSubstr;

constexpr double kTrueRadiusMm = 4;

double rim_mm(double depth_mm) { return std::sqrt(depth_mm * (2 * kTrueRadiusMm - depth_mm)); }

/// Presses of one ball of 4 mm, from 0.3 to 1.3 mm deep, with the ball's radius as it is said.
class Contradictions : public testing::Test {
 protected:
  Contradictions() {
    std::mt19937 random(43);
    const MadeScene scene = flat_scene();
    done_.finger.face = scene.face;
    for (int i = 0; i < 6; ++i) {
      const Ball ball{150.0 + 20 * i, 140.0 + 5 * i, kTrueRadiusMm, 0.3 + 0.2 * i};
      const std::string name = fmt::format("press_{}", i);
      MeasuredPress taken;
      taken.name = name;
      taken.press = make_press(scene, {}, {}, {ball}, 1.0, random, name).press;
      done_.presses.push_back(std::move(taken));
      depth_mm_[name] = ball.depth_mm;
    }
  }

  void say_radius(double radius_mm) {
    for (MeasuredPress& taken : done_.presses) taken.press->ball_radius_mm = radius_mm;
  }

  FingerCalibration done_;
  std::map<std::string, double> depth_mm_;
};

TEST_F(Contradictions, NoneWhereTheNumbersAreRight) {
  EXPECT_TRUE(find_contradictions(done_).empty());
}

TEST_F(Contradictions, ABallThatIsNarrowerThanWhatItLeaves) {
  say_radius(2);
  done_.presses.back().left_out = en::say("the dark part has a radius");  // it still is evidence
  const auto found = find_contradictions(done_);
  ASSERT_EQ(found.size(), 1U);
  const Contradiction& wider = found[0];
  EXPECT_EQ(wider.kind, ContradictionKind::kContactWiderThanBall);
  EXPECT_EQ(wider.of, 6);
  EXPECT_GE(wider.presses.size(), 2U);
  EXPECT_EQ(wider.presses.back(), "press_5");
  for (const std::string& press : wider.presses) EXPECT_GT(rim_mm(depth_mm_[press]), 2.0);
  EXPECT_GT(wider.measured_mm, 2.0);
  EXPECT_LE(wider.measured_to_mm, rim_mm(1.3));
  EXPECT_EQ(wider.given_mm, 2);
  EXPECT_TRUE(rules_out_use(wider.kind));
  EXPECT_THAT(sentence(wider).english(), HasSubstr("wider than the ball of 4.00 mm diameter"));
  say_radius(8);
  EXPECT_TRUE(find_contradictions(done_).empty()) << "the diameter fits under every contact";
}

TEST_F(Contradictions, AnExcludedPressIsNoEvidence) {
  say_radius(2);
  for (const MeasuredPress& taken : done_.presses) {
    PressNote note;
    note.excluded = "";
    done_.inputs.press_set.say(taken.name, note);
  }
  EXPECT_TRUE(find_contradictions(done_).empty());
}

TEST_F(Contradictions, APressThatIsDeeperThanTheLayer) {
  for (const auto& [name, depth] : depth_mm_) {
    BallFit ball;
    ball.press = name;
    ball.indentation_mm = depth;
    ball.depth_mm = 1.2 * depth;  // along z, on an inclined face
    done_.calibration.balls.push_back(ball);
  }
  EXPECT_TRUE(find_contradictions(done_).empty()) << "1.3 mm in 1.5 mm, though 1.56 mm along z";
  done_.calibration.balls[2].indentation_mm = 2.086;
  const auto found = find_contradictions(done_);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, ContradictionKind::kContactDeeperThanLayer);
  EXPECT_EQ(found[0].presses, std::vector<std::string>{"press_2"});
  EXPECT_EQ(found[0].measured_mm, 2.086);
  EXPECT_EQ(found[0].given_mm, 1.5);
  EXPECT_EQ(found[0].of, 6);
}

TEST_F(Contradictions, ADepthThatTheMappingDoesNotReach) {
  done_.calibration.mapping.kind = MappingKind::kMoebius;
  done_.calibration.mapping.x_max = 0.5;
  done_.calibration.mapping.a_mm = 2;
  done_.calibration.mapping.b = 0;  // 1.0 mm at its end
  PressNote note;
  note.depth = GivenDepth{1.02, 0.02};
  done_.inputs.press_set.say("press_3", note);
  EXPECT_TRUE(find_contradictions(done_).empty()) << "within what the measured depth is known to";
  note.depth = GivenDepth{1.3, 0.02};
  done_.inputs.press_set.say("press_5", note);
  const auto found = find_contradictions(done_);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, ContradictionKind::kDepthBeyondMapping);
  EXPECT_EQ(found[0].presses, std::vector<std::string>{"press_5"});
  EXPECT_NEAR(found[0].given_mm, 1.0, 1e-12);
  EXPECT_EQ(found[0].of, 2);
}

/// What pressed 0.3 mm deep on the untouched picture leaves a spot in all that are compared with
/// it.
void brighten(Press& press, cv::Point2d at_px) {
  for (int v = 0; v < press.difference.x.rows; ++v)
    for (int u = 0; u < press.difference.x.cols; ++u) {
      const double r_px = std::hypot(u - at_px.x, v - at_px.y);
      press.difference.x.at<float>(v, u) -= static_cast<float>(0.08 * std::exp(-r_px * r_px / 400));
    }
}

TEST_F(Contradictions, SkinThatIsBrighterThanTheReferenceAtOnePlace) {
  const cv::Point2d spot_px(45, 150);
  brighten(*done_.presses[1].press, spot_px);
  EXPECT_TRUE(find_contradictions(done_).empty()) << "one alone may be a glint";
  brighten(*done_.presses[2].press, {355, 150});
  EXPECT_TRUE(find_contradictions(done_).empty()) << "two glints";
  brighten(*done_.presses[4].press, spot_px);
  brighten(*done_.presses[5].press, spot_px);
  const auto found = find_contradictions(done_);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, ContradictionKind::kReferenceContact);
  EXPECT_THAT(found[0].presses, testing::Not(testing::Contains("press_2")));
  EXPECT_EQ(found[0].of, 6);
  const FaceShape& shape = done_.presses[1].press->shape;
  EXPECT_NEAR(found[0].measured_mm, shape.position_mm(spot_px.x, spot_px.y).x(), 0.5);
  EXPECT_FALSE(rules_out_use(found[0].kind));
  EXPECT_THAT(sentence(found[0]).english(), HasSubstr("record it again"));
}

TEST_F(Contradictions, ABulgeAroundABallAccusesNoReference) {
  std::mt19937 random(44);
  const MadeScene scene = flat_scene();
  for (int i = 0; i < 6; ++i) {
    const Ball ball{180.0, 150.0 + i, kTrueRadiusMm, 0.3 + 0.1 * i};
    done_.presses[static_cast<std::size_t>(i)].press =
        make_press(scene, {}, {.skin = Skin::kSharp, .bulge_mm = 0.15}, {ball}, 1.0, random, "b")
            .press;
  }
  EXPECT_TRUE(find_contradictions(done_).empty());
}

/// A straight face in a distance, with the width that is said of it.
FaceShape straight_face(const CameraParameters& p, Face face, double seen_px) {
  FaceEdges edges;
  for (double u = 3.5; u < 960; u += 8.0) {
    edges.u.push_back(u);
    for (auto [edge, sign] : {std::pair{&edges.upper, -0.5}, std::pair{&edges.lower, 0.5}}) {
      edge->v.push_back(p.cy_px + sign * seen_px);
      edge->sd.push_back(0.05);
      edge->valid.push_back(true);
    }
  }
  return FaceShape::fit(edges, Camera::create(p).value(), face, 3, 1e3).value();
}

TEST_F(Contradictions, AWidthThatNoCameraInAFingerSees) {
  const CameraParameters p = pinhole();
  constexpr double kSeenPx = 240;
  // z = f W / 240: 52 mm for a width of 24 mm.
  for (const auto& [width_mm, is_possible] :
       {std::pair{24.0, true}, {2.4, true}, {1.0, false}, {240.0, false}}) {
    SCOPED_TRACE(width_mm);
    done_.finger.face.kind = FaceKind::kFinRay;
    done_.finger.face.width_mm = width_mm;
    for (MeasuredPress& taken : done_.presses)
      taken.press->shape = straight_face(p, done_.finger.face, kSeenPx);
    const auto found = find_contradictions(done_);
    const auto width = std::find_if(found.begin(), found.end(), [](const Contradiction& one) {
      return one.kind == ContradictionKind::kFaceWidthAgainstCamera;
    });
    ASSERT_EQ(width == found.end(), is_possible);
    if (is_possible) continue;
    EXPECT_EQ(width->given_mm, width_mm);
    EXPECT_NEAR(width->measured_mm, 5 * kSeenPx / p.fy_px, 0.05);
    EXPECT_NEAR(width->measured_to_mm, 500 * kSeenPx / p.fy_px, 5);
  }
}

}  // namespace
}  // namespace alltact
