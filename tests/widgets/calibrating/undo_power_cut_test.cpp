// Power that fails at any moment while a calibration is undone or redone leaves the finger as it
// was before or as it is then, never some of both.
#include "calibration/finger/calibration_report.h"
#include "core/base/atomic_file.h"
#include "tests/support/child_tests.h"
#include "tests/support/finger_on_disk.h"
#include "tests/support/recorded_disk.h"
#include "tests/widgets/calibrating/calibrate_in_window.h"

#include <QProcess>
#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>
#include <cstdlib>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIsChild = "ALLTACT_DISK_LOG";

class UndoPowerCut : public FingerOnDisk {
 protected:
  /// Loads the faulty disk below this program: only a new process can.
  void run_on_recorded_disk(const char* filter) {
    QProcess child;
    QProcessEnvironment environment = environment_of_child_tests();
    environment.insert("LD_PRELOAD", ALLTACT_FAULTY_DISK);
    environment.insert(kIsChild, QString::fromStdString(flat_.file("log")));
    child.setProcessEnvironment(environment);
    child.setProcessChannelMode(QProcess::MergedChannels);
    child.start("/proc/self/exe", {QStringLiteral("--gtest_filter=") + filter});
    ASSERT_TRUE(child.waitForFinished(300000));
    const std::string output = child.readAll().toStdString();
    EXPECT_EQ(child.exitCode(), 0) << output;
    EXPECT_NE(output.find("[  PASSED  ] 1 test"), std::string::npos) << output;
  }

  /// Operations on the finger's folder during `step`, from the log of this process.
  template <class Step>
  std::vector<DiskOperation> operations_of(const Step& step) {
    const char* log = std::getenv(kIsChild);
    const std::size_t before = fs::exists(log) ? disk_log(log).size() : 0;
    setenv("ALLTACT_DISK", finger().c_str(), 1);  // read at each operation
    step();
    unsetenv("ALLTACT_DISK");
    auto all = disk_log(log);
    return {all.begin() + static_cast<std::ptrdiff_t>(before), all.end()};
  }
};

TEST_F(UndoPowerCut, WhileACalibrationIsUndoneAndRedone) {
  if (std::getenv(kIsChild) == nullptr)
    return run_on_recorded_disk("UndoPowerCut.WhileACalibrationIsUndoneAndRedone");
  QUndoStack undo;
  PressCollection collection(undo);
  CalibrationRun run(collection, undo, "0.1.0");
  const auto written = [&] { return collection.disk()->wait(); };
  const auto calibrate = [&] {
    calibrate_and_wait(run, undo);
    if (HasFatalFailure()) return;
    written();
  };
  collection.open(finger());
  ASSERT_TRUE(QTest::qWaitFor([&] { return collection.is_ready(); }, 30000));
  collection.add_files({flat_.presses[0], flat_.presses[1], flat_.presses[2]});
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return collection.presses().size() == 3 && !collection.is_analysing(); }, 60000));
  collection.set_radius(FlatSensor::kBallRadiusMm);
  ASSERT_TRUE(QTest::qWaitFor([&] { return collection.usable_count() == 3; }, 30000));
  const std::string report = finger() + "/" + kReportJson;
  // The first has no calibration.yaml nor report before it: undoing removes them.
  // The second replaces those of the first.
  for (const char* which : {"the first", "a later one"}) {
    SCOPED_TRACE(which);
    if (undo.count() > 0) collection.set_radius(FlatSensor::kBallRadiusMm + 0.01);
    written();
    const auto before = files_in(finger());
    ASSERT_NO_FATAL_FAILURE(calibrate());
    const auto after = files_in(finger());
    ASSERT_TRUE(fs::exists(report));
    for (const bool undoes : {true, false}) {
      SCOPED_TRACE(undoes ? "undo" : "redo");
      const DiskModel disk(finger());
      const auto operations = operations_of([&] {
        undoes ? undo.undo() : undo.redo();
        written();
      });
      EXPECT_EQ(files_in(finger()), undoes ? before : after);
      EXPECT_NO_FATAL_FAILURE(expect_old_or_new_after_cuts(disk, operations, finger()));
    }
  }
}

}  // namespace
}  // namespace alltact::test
