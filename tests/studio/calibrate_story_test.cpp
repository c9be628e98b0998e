// A power cut while presses are taken.
#include "tests/studio/calibrate_rig.h"
#include "tests/support/child_tests.h"

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
  auto* place = studio.window().findChild<CalibratePage*>();
  ASSERT_TRUE(wait_until([&] { return place->collection().is_ready(); }, 30000));
  place->collection().set_radius(4);
  for (int i = 1;; ++i) {
    ASSERT_TRUE(wait_until([&] { return studio.session().view() != nullptr; }));
    const std::string name = place->collection().add({studio.session().view()->result.frame});
    place->collection().set_ball(name, {0.5 * i, 0, 50}, i);
    std::printf("taken %d\n", i);
    std::fflush(stdout);
    QTest::qWait(150);
  }
}

TEST(Calibrate, AKillInTheMiddleOfPressesLosesNothingButTheLastSecond) {
  CalibrateStudio rig;
  fs::copy(rig.folder() / "pressing.yaml", rig.finger() / "pressing.yaml");
  QProcess child;
  QProcessEnvironment environment = environment_of_child_tests();
  environment.insert("ALLTACT_KILLED_FINGER", QString::fromStdString(rig.finger().string()));
  child.setProcessEnvironment(environment);
  child.start("/proc/self/exe",
              {"--gtest_also_run_disabled_tests", "--gtest_filter=CalibrateKilled.*"});
  int taken = 0, a_second_before = 0;
  QElapsedTimer clock;
  std::deque<std::pair<qint64, int>> history;
  QByteArray reported;
  ASSERT_TRUE(wait_until(
      [&] {
        while (child.canReadLine()) {
          const QByteArray line = child.readLine();
          reported += line;
          if (!line.startsWith("taken ")) continue;
          if (taken == 0) clock.start();
          taken = line.mid(6).trimmed().toInt();
          history.emplace_back(clock.elapsed(), taken);
        }
        return taken >= 14 || child.state() == QProcess::NotRunning;
      },
      60000))
      << reported.toStdString();
  ASSERT_GE(taken, 14) << reported.toStdString();
  child.kill();  // SIGKILL
  child.waitForFinished();
  for (const auto& [when, number] : history)
    if (when < clock.elapsed() - 1000) a_second_before = number;
  ASSERT_GE(a_second_before, 5);
  rig.open();
  ASSERT_GE(static_cast<int>(rig.collection().presses().size()), a_second_before);
  EXPECT_TRUE(rig.wait_until_looked_at(static_cast<int>(rig.collection().presses().size())));
  for (int i = 1; i <= a_second_before; ++i) {
    const std::string name = fmt::format("press_{:02}", i);
    ASSERT_NE(rig.collection().find(name), nullptr) << name;
    EXPECT_FALSE(rig.collection().find(name)->analysis.grey.empty()) << name;
    ASSERT_TRUE(rig.collection().press_set().of(name).ball_mm) << name;
    EXPECT_EQ(rig.collection().press_set().of(name).ball_mm->x(), 0.5 * i);
  }
  EXPECT_EQ(rig.collection().press_set().ball_radius_mm, 4);
}

}  // namespace
}  // namespace alltact::test
