// The place Calibrate from an empty folder to a verdict, and a power cut in between.
#include "tests/studio/calibrate_rig.h"

#include <QProcess>
#include <QToolButton>
#include <deque>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

// What another process does until it is killed.
TEST(CalibrateKilled, DISABLED_TakesPressesForEver) {
  const char* folder = std::getenv("ALLTACT_KILLED_FINGER");
  ASSERT_NE(folder, nullptr);
  StudioOptions options;
  options.finger = folder;
  options.source = {fs::path(folder) / "pressing.yaml"};
  Studio studio(options);
  ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.has_reference; }, 30000));
  studio.window().go_to("calibrate");
  auto* place = studio.window().findChild<CalibratePlace*>();
  ASSERT_TRUE(wait_until([&] { return place->desk().is_ready(); }, 30000));
  place->desk().set_radius(4);
  for (int i = 1;; ++i) {
    ASSERT_TRUE(wait_until([&] { return studio.session().view() != nullptr; }));
    const std::string name = place->desk().add({studio.session().view()->result.frame});
    place->desk().place_ball(name, {0.5 * i, 0, 50}, i);
    std::printf("taken %d\n", i);
    std::fflush(stdout);
    QTest::qWait(150);
  }
}

TEST(Calibrate, AKillInTheMiddleOfPressesLosesNothingButTheLastSecond) {
  CalibrateStudio rig;
  fs::copy(rig.folder() / "pressing.yaml", rig.finger() / "pressing.yaml");
  QProcess child;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("ALLTACT_KILLED_FINGER", QString::fromStdString(rig.finger().string()));
  child.setProcessEnvironment(environment);
  child.start("/proc/self/exe",
              {"--gtest_also_run_disabled_tests", "--gtest_filter=CalibrateKilled.*"});
  int taken = 0, a_second_before = 0;
  QElapsedTimer clock;
  std::deque<std::pair<qint64, int>> history;
  ASSERT_TRUE(wait_until(
      [&] {
        while (child.canReadLine()) {
          const QByteArray line = child.readLine();
          if (!line.startsWith("taken ")) continue;
          if (taken == 0) clock.start();
          taken = line.mid(6).trimmed().toInt();
          history.emplace_back(clock.elapsed(), taken);
        }
        return taken >= 14;
      },
      60000));
  child.kill();  // SIGKILL
  child.waitForFinished();
  for (const auto& [when, number] : history)
    if (when < clock.elapsed() - 1000) a_second_before = number;
  ASSERT_GE(a_second_before, 5);
  rig.open();
  ASSERT_GE(static_cast<int>(rig.desk().presses().size()), a_second_before);
  EXPECT_TRUE(rig.wait_until_looked_at(static_cast<int>(rig.desk().presses().size())));
  for (int i = 1; i <= a_second_before; ++i) {
    const std::string name = fmt::format("press_{:02}", i);
    ASSERT_NE(rig.desk().find(name), nullptr) << name;
    EXPECT_FALSE(rig.desk().find(name)->looked.grey.empty()) << name;
    ASSERT_TRUE(rig.desk().said().of(name).ball_mm) << name;
    EXPECT_EQ(rig.desk().said().of(name).ball_mm->x(), 0.5 * i);
  }
  EXPECT_EQ(rig.desk().said().ball_radius_mm, 4);
}

/// Somebody who has only the window: every click and every line typed counts.
class Person {
 public:
  explicit Person(Studio& studio) : studio_(studio) {}
  void click(const QString& button) {
    ++actions_;
    studio_.click(button);
  }
  void click_place(const QString& name) {
    ++actions_;
    QTest::mouseClick(studio_.find<QToolButton>(name), Qt::LeftButton);
  }
  template <class Field>
  void type(Field* field, const QString& text, Qt::Key end = Qt::Key_Tab) {
    ++actions_;
    ASSERT_NE(field, nullptr);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, end);
  }
  [[nodiscard]] int actions() const { return actions_; }

 private:
  Studio& studio_;
  int actions_ = 0;
};

TEST(Calibrate, AFirstTimeUserComesFromAnEmptyFolderToAVerdict) {
  const TemporaryFolder empty;
  Studio studio;
  Person person(studio);
  person.click("Simulated finger");
  ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.finger.has_value(); }));
  person.click_place("Calibrate");
  person.click("Use the simulated camera's lens");
  person.click("Next: Finger");
  person.click("Make the finger's folder…");
  auto* dialog = studio.window().findChild<NewFingerDialog*>();
  ASSERT_NE(dialog, nullptr);
  const auto line = [&](const char* name) -> QLineEdit* {
    for (auto* field : dialog->findChildren<QLineEdit*>())
      if (field->accessibleName() == QLatin1String(name)) return field;
    return nullptr;
  };
  person.type(line("Folder to make"), QString::fromStdString((empty / "left-07").string()));
  person.click("Make the finger");
  ASSERT_TRUE(wait_until([&] {
    return studio.session().status().finger.folder == empty / "left-07" &&
           studio.session().status().finger.state == FingerState::kReady;
  })) << studio.problems();
  person.click("Go to Record");
  person.click("Start recording");
  // The ball comes and goes: in between the finger is free.
  ASSERT_TRUE(wait_until([&] { return studio.session().status().recording.counts.recorded >= 300; },
                         240000));
  person.click("Stop recording");
  ASSERT_TRUE(wait_until(
      [&] { return studio.session().status().recording.state == RecordingState::kDone; }));
  person.click("Install as this finger's reference");
  ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.has_reference; }, 240000))
      << studio.problems();
  person.click_place("Calibrate");
  auto* place = studio.window().findChild<CalibratePlace*>();
  ASSERT_TRUE(wait_until([&] { return place->desk().is_ready(); }, 120000));
  person.click("Next: Presses");
  person.type(studio.find<QDoubleSpinBox>("Ball's radius"), "4", Qt::Key_Return);
  std::vector<DarkPatch> taken;
  while (taken.size() < 8) {
    // As the picture shows it: the ball is in, elsewhere or deeper than before.
    ASSERT_TRUE(wait_until(
        [&] {
          const auto patch = dark_patch(studio.session().view()->result);
          if (!patch || patch->darkness < 0.06) return false;
          for (const DarkPatch& one : taken)
            if ((one.place_mm - patch->place_mm).norm() < 5 &&
                std::abs(one.darkness - patch->darkness) < 0.2 * patch->darkness)
              return false;
          taken.push_back(*patch);
          return true;
        },
        60000));
    person.click("Take a press (Space)");
  }
  const auto all_states = [&] {
    std::string states;
    for (const DeskPress& press : place->desk().presses())
      states += press.name + ": " +
                press_state_text(press, place->desk(), place->run()).toStdString() + "\n";
    return states;
  };
  ASSERT_TRUE(wait_until([&] { return place->desk().usable_count() >= 4; }, 60000)) << all_states();
  person.click("Next: Mapping");
  person.click("Calibrate now");
  ASSERT_TRUE(wait_until([&] { return place->run().result() != nullptr; }, 240000))
      << studio.problems();
  person.click("Next: Verdict");
  const Verdict& verdict = place->run().result()->verdict;
  EXPECT_TRUE(verdict.grade == Grade::kGood || verdict.grade == Grade::kUsable)
      << verdict.sentence.english();
  EXPECT_TRUE(says(studio, verdict.grade == Grade::kGood ? "Good" : "Usable"));
  EXPECT_LE(person.actions(), 40);
  RecordProperty("actions", person.actions());
  // And it measures where the scene presses its ball in, by 0.9 mm along the face's normal. Near
  // the tip, which half a minute of recording does not cover well, it may see what is not there.
  double deepest_mm = 0;
  const auto look = [&] {
    for (const ContactRegion& region : studio.session().view()->result.regions)
      if (region.place_mm.z() < 75) deepest_mm = std::max(deepest_mm, region.deepest_mm);
    return deepest_mm > 0.7;
  };
  EXPECT_TRUE(wait_until(look, 60000));
  wait_until([&] { return !look(); }, 1500);  // to the depth at which the ball stays
  std::printf("[ figures  ] deepest %.3f mm; %s\n", deepest_mm, verdict.sentence.english().c_str());
  // Which eight moments were caught decides; one calibration of them is a draw, and so is a
  // reading.
  EXPECT_NEAR(deepest_mm, 0.9, 0.15 + 2 * verdict.error_mm);
}

}  // namespace
}  // namespace alltact::test
