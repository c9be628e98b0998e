// What the finger feels, as the window tells it.
#include "core/base/atomic_file.h"
#include "tests/studio/force_finger.h"

#include <QLabel>

#include <gmock/gmock.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;
using testing::Not;

StudioOptions strong(const std::filesystem::path& source) {
  StudioOptions options;
  options.finger = ForceFinger::get().folder();
  options.source = {source};
  return options;
}

bool wait_for_finger(Studio& studio) {
  return wait_until([&] { return studio.session().status().finger.state == FingerState::kReady; },
                    40000);
}

bool wait_for_force(Studio& studio) {
  return wait_until(
      [&] {
        const auto& view = studio.session().view();
        return view && view->result.force && studio.session().touch_history().forces().size() > 5;
      },
      40000);
}

std::string reported(Studio& studio, const QString& label) {
  return studio.find<QLabel>(label)->text().toStdString();
}

TEST(LiveTouch, TellsTheForceThatTheMarkersTell) {
  Studio studio(strong(MadeFingers::get().bending()));
  ASSERT_TRUE(wait_for_force(studio));
  int covered = 0, compared = 0;
  std::uint64_t last = 0;
  static_cast<void>(wait_until([&] {
    const FrameResult& result = studio.session().view()->result;
    if (result.frame->sequence != last && result.force && result.markers) {
      last = result.frame->sequence;
      const Eigen::Vector2d truth = ForceFinger::get().force_N(*result.markers);
      for (Eigen::Index axis = 0; axis < 2; ++axis) {
        EXPECT_NEAR(result.force->force_N[axis], truth[axis], 0.2);
        covered +=
            std::abs(result.force->force_N[axis] - truth[axis]) <= result.force->half_95_N[axis];
        ++compared;
      }
    }
    return compared >= 300;
  }));
  ASSERT_GE(compared, 20);
  EXPECT_GE(covered, 0.8 * compared) << "frames that follow one another share their error";
  EXPECT_THAT(reported(studio, "Force now"), HasSubstr("Fx"));
  EXPECT_TRUE(wait_until([&] {  // frames out of range tell none
    return reported(studio, "Force now").find("±") != std::string::npos;
  }));
  EXPECT_THAT(reported(studio, "Force now"), Not(HasSubstr("Fz")));
  auto* plot = studio.find<ForcePlot>("Force over the last half minute");
  ASSERT_NE(plot, nullptr);
  EXPECT_TRUE(plot->isVisible());
  EXPECT_GE(plot->width(), 500) << "below the picture there is room";
}

/// Once the box has drawn it so; a force out of range is no zero.
void click_once_it_can_be(Studio& studio, const char* name) {
  const auto button = [&]() -> QPushButton* {
    for (QPushButton* one : studio.window().findChildren<QPushButton*>())
      if (one->isVisible() && one->isEnabled() &&
          one->text().remove(QLatin1Char('&')) == QLatin1String(name))
        return one;
    return nullptr;
  };
  ASSERT_TRUE(wait_until([&] { return button() != nullptr; })) << name;
  button()->click();
}

TEST(LiveTouch, TellsOfNoForceBeforeTheFingerItComesFrom) {
  Studio studio(strong(MadeFingers::get().touched()));
  int told = 0, untold = 0;
  QObject::connect(&studio.session(), &LiveSession::view_ready, &studio.window(), [&] {
    if (!studio.session().view()->result.force) return;
    ++(studio.session().status().finger.finger ? told : untold);
  });
  EXPECT_TRUE(wait_until([&] { return told > 5; }));
  EXPECT_EQ(untold, 0) << "what is re-zeroed now would be no finger's";
}

TEST(LiveTouch, TakesThePresentReadingAsZeroAndGivesItBack) {
  Studio studio(strong(MadeFingers::get().touched()));
  ASSERT_TRUE(wait_for_force(studio));
  ASSERT_FALSE(studio.session().force_zero());
  click_once_it_can_be(studio, "Re-zero");
  const auto zero = studio.session().force_zero();
  ASSERT_TRUE(zero);
  EXPECT_LE(std::abs(zero->since.secsTo(QDateTime::currentDateTime())), 5);
  EXPECT_TRUE(wait_until([&] {
    return reported(studio, "Zero of the forces").find("Zero: the reading of") != std::string::npos;
  }));
  EXPECT_EQ(studio.window().undo_stack().undoText(), "re-zero the force");
  QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(studio.session().force_zero());
  QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(studio.session().force_zero(), zero);
  click_once_it_can_be(studio, "As measured");
  EXPECT_FALSE(studio.session().force_zero());

  // Another finger's forces do not count from it.
  click_once_it_can_be(studio, "Re-zero");
  ASSERT_TRUE(studio.session().force_zero());
  studio.window().open_finger(MadeFingers::get().calibrated());
  EXPECT_TRUE(wait_for_finger(studio));
  EXPECT_FALSE(studio.session().force_zero());
  EXPECT_TRUE(wait_until([&] { return !studio.session().touch_history().has_forces(); }));
}

TEST(LiveTouch, SaysHowAFingerGetsAForceModel) {
  Studio studio(simulated());
  ASSERT_TRUE(studio.wait_for_picture());
  ASSERT_TRUE(wait_for_finger(studio));
  ASSERT_TRUE(wait_until([&] {
    return reported(studio, "Force now").find("no force model yet") != std::string::npos;
  }));
  EXPECT_THAT(reported(studio, "Force now"), HasSubstr("alltact force calibrated TABLE.csv"));
}

TEST(LiveTouch, SaysThatAForceModelIsBroken) {
  const TemporaryFolder folder;
  std::filesystem::copy(ForceFinger::get().folder(), folder / "broken",
                        std::filesystem::copy_options::recursive);
  const std::string file = open_finger(folder / "broken").value()->finger.force_model;
  std::filesystem::resize_file(folder / "broken" / file, 100);
  StudioOptions options = strong(MadeFingers::get().bending());
  options.finger = folder / "broken";
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  ASSERT_TRUE(wait_for_finger(studio));
  EXPECT_TRUE(wait_until([&] {
    return reported(studio, "Force now").find("damaged or truncated") != std::string::npos;
  })) << reported(studio, "Force now");
}

TEST(LiveTouch, TellsWhereTheBallTouches) {
  Studio studio(simulated());
  ASSERT_TRUE(wait_until(
      [&] {
        const auto& view = studio.session().view();
        return view && view->result.contact && view->result.contact->position;
      },
      40000));
  const FingerContact contact = *studio.session().view()->result.contact;
  EXPECT_EQ(contact.face, PushedFace::kContact);
  EXPECT_NEAR(contact.position->along_mm, 46.0, 1.0);  // as the scene says
  EXPECT_NEAR(contact.position->across_mm.value(), 0.0, 0.2);
  EXPECT_NEAR(contact.position->depth_mm.value(), 0.8, 0.1);
  ASSERT_TRUE(wait_until([&] {
    return reported(studio, "Contacts on the finger").find("Along") != std::string::npos;
  }));
  const std::string words = reported(studio, "Contacts on the finger");
  EXPECT_THAT(words, HasSubstr("Contact on the contact face"));
  EXPECT_THAT(words, HasSubstr("±"));
  EXPECT_THAT(words, HasSubstr("Direction"));
  EXPECT_TRUE(wait_until([&] { return !studio.session().touch_history().contacts().empty(); }));
}

TEST(LiveTouch, SaysThatNothingTouchesAnUntouchedFinger) {
  // The touched finger's scene, which stays near the pose at rest, without the ball.
  std::string scene = small_scene(true);
  for (const char* effect : {"  - {use: ball", "  - {use: rolloff"}) {
    const auto at = scene.find(effect);
    scene.erase(at, scene.find('\n', at) + 1 - at);
  }
  const TemporaryFolder folder;
  must(write_file_atomically(folder / "free.yaml", scene));
  StudioOptions options = simulated();
  options.source = {folder / "free.yaml"};
  Studio studio(options);
  ASSERT_TRUE(wait_until(
      [&] {
        const auto& view = studio.session().view();
        return view && view->result.reference && !view->result.contact;
      },
      40000));
  EXPECT_TRUE(wait_until([&] {
    return reported(studio, "Contacts on the finger").find("Nothing touches") != std::string::npos;
  }));
}

TEST(InspectTouch, TellsOfARecordingsFrameWhatItTellsLive) {
  StudioOptions options;
  options.finger = ForceFinger::get().folder();
  Studio studio(options);
  studio.window().go_to("inspect");
  auto& position = *studio.window().findChild<InspectPage*>();
  position.open(MadeFingers::get().touched_pictures());
  ASSERT_TRUE(wait_until(
      [&] {
        const auto& frame = position.inspection().frame();
        return frame && frame->result.force;
      },
      40000));
  const Force force = *position.inspection().frame()->result.force;
  ASSERT_TRUE(
      wait_until([&] { return reported(studio, "Force now").find("Fx") != std::string::npos; }));
  EXPECT_THAT(reported(studio, "Force now"),
              HasSubstr(QString::number(force.force_N.x(), 'f', 2).toStdString() + " ± "));
  EXPECT_THAT(reported(studio, "Contacts on the finger"), HasSubstr("Contact on the contact face"));
  EXPECT_FALSE(studio.find<QPushButton>("Re-zero")->isEnabled());
}

}  // namespace
}  // namespace alltact::test
